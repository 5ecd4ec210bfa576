// Begins: the state from the link, the core in its worker, then the page round them.
import catalogue from 'limn-catalogue';
import { App } from './app';
import { Client } from './core/client';
import { Opening } from './core/opening';
import { painterFor } from './space/painters';
import { fromFragment, Store } from './state';
import { mount } from './page';
import { recordScheme } from './views/record';
import './style.css';

function record(): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(document.getElementById('record')?.textContent ?? 'null');
    return value && typeof value === 'object' && !Array.isArray(value) ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}

async function begin(): Promise<void> {
  const client = new Client(limnStart.spawn);
  const opening = new Opening(await limnStart.opening);
  const embedded = record();
  let state = fromFragment(location.hash);
  // A report opens with its scheme, unless a link says otherwise.
  if (embedded && location.hash.length < 2) {
    const of = recordScheme(embedded);
    const shipped = catalogue.schemes.find((scheme) => scheme.name === of.name);
    const own = of.text !== null && of.text !== shipped?.text ? of.text : null;
    if (shipped || own) state = { ...state, scheme: shipped?.name ?? state.scheme, text: own, parameters: of.parameters };
  }
  const app: App = new App(new Store(state), client, painterFor(() => app.refresh()), catalogue, embedded, opening);
  mount(app, document.getElementById('app')!);
}

await begin();
