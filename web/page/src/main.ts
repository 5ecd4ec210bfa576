// Begins: the state from the link, the core in its worker, then the page round them.
import CoreWorker from './core/worker?worker&inline';
import { App } from './app';
import { Client, superseded } from './core/client';
import { FlatPainter } from './space/flat_painter';
import { GlPainter, type Painter } from './space/gl_painter';
import { fromFragment, Store } from './state';
import { mount } from './page';
import { recordScheme } from './views/record';
import './style.css';

function painter(): Painter | null {
  try {
    return new GlPainter();
  } catch {
    return document.createElement('canvas').getContext('2d') ? new FlatPainter() : null;
  }
}

function record(): Record<string, unknown> | null {
  try {
    const value: unknown = JSON.parse(document.getElementById('record')?.textContent ?? 'null');
    return value && typeof value === 'object' && !Array.isArray(value) ? (value as Record<string, unknown>) : null;
  } catch {
    return null;
  }
}

async function begin(): Promise<void> {
  const place = document.getElementById('app')!;
  const client = new Client(() => new CoreWorker(), document.getElementById('core')?.textContent ?? '');
  // A context for drawing takes long where it is made of software; meanwhile the core is compiled.
  const draws = painter();
  const catalogue = await client.ask('catalogue', 'catalogue');
  if (catalogue === superseded || !catalogue.ok) {
    place.textContent = `The core did not start: ${catalogue === superseded ? '' : catalogue.errors.map((e) => e.message).join('; ')}`;
    return;
  }
  const embedded = record();
  let state = fromFragment(location.hash);
  // A report opens with its scheme, unless a link says otherwise.
  if (embedded && location.hash.length < 2) {
    const of = recordScheme(embedded);
    const shipped = catalogue.result.schemes.find((scheme) => scheme.name === of.name);
    const own = of.text !== null && of.text !== shipped?.text ? of.text : null;
    if (shipped || own) state = { ...state, scheme: shipped?.name ?? state.scheme, text: own, parameters: of.parameters };
  }
  const app = new App(new Store(state), client, draws, catalogue.result, embedded);
  mount(app, place);
}

void begin();
