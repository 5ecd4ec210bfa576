// The page: where the views stand, what the keys do, and what goes to the clipboard.
import type { App, View } from './app';
import { command, focuses, fromFragment, shades, toFragment, type Focus, type State } from './state';
import { withDefaults } from './scheme_text';
import { tourPanel } from './tour/panel';
import { copy, download, h, say, show } from './ui/dom';
import { artifactsView } from './views/artifacts';
import { schemeView } from './views/scheme';
import { smoothnessView } from './views/smoothness';
import { drop, surfaceView } from './views/surface';
import { sweepView } from './views/sweep';
import { timingPanel } from './views/timing';
import { vertexView } from './views/vertex';

const titles: Record<Focus, string> = { surface: 'Surface', vertex: 'Vertex', artifacts: 'Artifacts', smoothness: 'Smoothness', sweep: 'Sweep', scheme: 'Scheme' };
const keys: [string, string][] = [['1 … 6', 'surface, vertex, artifacts, smoothness, sweep, scheme'], ['[ ]', 'level'], [', .', 'valence'], ['m', 'next shading'],
  ['p', 'play the levels'], ['l', 'limit surface or level'], ['g', 'control mesh on or off'], ['t', 'tour; n, b: on and back'], ['c', 'copy the link'],
  ['r', 'projector'], ['d', 'light or dark'], ['arrows, + −', 'turn and zoom, where the surface has the focus'], ['Esc', 'close']];

/** The fragment that shows the state. One that someone has put there since is not written over: `hashchange` follows. */
const fragment = {
  known: location.hash,
  write(state: State): void {
    if (location.hash !== this.known) return;
    history.replaceState(null, '', `#${toFragment(state)}`);
    this.known = location.hash;
  },
};

export function mount(app: App, place: HTMLElement): void {
  const { store } = app;
  const toast = toaster();
  document.addEventListener('toast', (event) => toast.say((event as CustomEvent<string>).detail));
  const surface = surfaceView(app);
  const views = { surface, vertex: vertexView(app), artifacts: artifactsView(app), smoothness: smoothnessView(app), sweep: sweepView(app), scheme: schemeView(app) };
  const tour = tourPanel(app);
  const timing = timingPanel(app);
  const help = h('dialog', { class: 'help', 'data-test': 'help' }, h('h2', {}, 'Keys'), h('dl', {}, ...keys.flatMap(([key, what]) => [h('dt', {}, key), h('dd', {}, what)])),
    h('p', { class: 'source' }, `limn ${app.catalogue.version}. Nothing leaves this page: it computes in your browser and makes no request.`),
    h('form', { method: 'dialog' }, h('button', { class: 'main' }, 'Close')));
  const center = h('div', { class: 'center' });
  const side = h('div', { class: 'side' });
  const left = h('div', { class: 'left' }, views.scheme.element);
  const tabs = h('nav', { class: 'tabs', 'aria-label': 'Views' }, ...focuses.map((focus) => h('button', { type: 'button', 'data-focus': focus, onclick: () => store.set({ focus }) }, titles[focus])));
  const clip = copies(app, toast.say);
  const name = h('h1', { 'data-test': 'title' });
  const button = (text: string, title: string, act: () => void, test?: string) => h('button', { type: 'button', class: 'quiet', title, 'data-test': test, onclick: act }, text);
  const actions = {
    tour: () => tour.go(store.now.tour < 0 ? 0 : -1),
    projector: () => store.set({ projector: !store.now.projector }),
    theme: () => store.set({ theme: isDark(store.now) ? 'light' : 'dark' }),
    help: () => (help.open ? help.close() : help.showModal()),
  };
  const projector = button('Projector', 'Large type, for a lecture hall (r)', actions.projector, 'projector');
  const header = h('header', { class: 'top' }, h('a', { class: 'mark', href: '#', title: 'Begin anew', onclick: (event: Event) => { event.preventDefault(); store.set(fromFragment('')); } }, 'limn'), name,
    h('div', { class: 'actions' }, button('Tour', 'A tour through three papers (t)', actions.tour, 'tour-begin'), clip.element, button('Timing', 'What a step costs in this browser', timing.toggle, 'timing-open'),
      projector, button('Light / dark', 'Light or dark (d)', actions.theme, 'theme'), button('?', 'Keys', actions.help, 'help-open')));
  place.replaceChildren(header, tabs, h('main', {}, left, center, side), tour.element, timing.element, help, toast.element);
  for (const focus of focuses) addExpander(views[focus].element, focus, app);
  const heading: View = { element: name, first: true, update: (_state, { scheme, other }) => {
    const title = (one: typeof scheme): string => one?.info.title || one?.label || '';
    say(name, title(scheme) + (other ? ` beside ${title(other)}` : ''));
    document.title = `limn · ${scheme?.label ?? ''}`;
  } };
  app.views = [...Object.values(views), heading];
  app.meshErrors = (file, faults, repairable) => meshFaults(app, toast.offer, file, faults, repairable);

  let arranged = '';
  function arrange(state: State): void {
    document.documentElement.dataset.theme = isDark(state) ? 'dark' : 'light';
    document.documentElement.dataset.size = state.projector ? 'large' : 'normal';
    document.body.dataset.focus = state.focus;
    projector.setAttribute('aria-pressed', String(state.projector));
    for (const tab of tabs.querySelectorAll('button')) tab.setAttribute('aria-current', String(tab.dataset.focus === state.focus));
    tour.update(state);
    if (arranged === state.focus) return;
    arranged = state.focus;
    const main = state.focus === 'scheme' ? 'surface' : state.focus;
    center.replaceChildren(views[main].element);
    side.replaceChildren(...focuses.filter((f) => f !== main && f !== 'scheme').map((f) => views[f].element));
  }
  let timer = 0;
  store.listen((state) => {
    arrange(state);
    clearTimeout(timer);
    timer = window.setTimeout(() => fragment.write(state), 200);
  });
  addEventListener('hashchange', () => {
    fragment.known = location.hash;
    const state = fromFragment(location.hash);
    if (toFragment(state) !== toFragment(store.now)) store.set(state);
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => store.set({}));
  listenKeys(app, { ...actions, play: surface.play, link: clip.link, on: () => store.now.tour >= 0 && tour.go(store.now.tour + 1), back: () => store.now.tour > 0 && tour.go(store.now.tour - 1), close: () => show(timing.element, false) });
  listenDrops(app);
  // Tests ask where a control vertex stands on the stage, and what steps took.
  Object.assign(window, { limnPick: (v: number) => surface.panes[0]!.place(v), limnTimings: app.timings });
  arrange(store.now);
  app.refresh();
  // Whatever becomes of the surface, numbers come.
  setTimeout(() => app.begin(), 3000);
}

function isDark(state: State): boolean {
  return state.theme === 'auto' ? matchMedia('(prefers-color-scheme: dark)').matches : state.theme === 'dark';
}

function addExpander(element: HTMLElement, focus: Focus, app: App): void {
  const expand = h('button', { type: 'button', class: 'expand', title: `${titles[focus]} as the main view`, 'aria-label': `${titles[focus]} as the main view`, 'data-expand': focus,
    onclick: () => app.store.set({ focus }) }, '⤢');
  if (focus !== 'scheme') (element.querySelector('header') ?? element).append(expand);
}

function copies(app: App, toast: (text: string) => void) {
  const { store } = app;
  const text = (): string => withDefaults(store.now.text ?? app.shipped(store.now.scheme)?.text ?? '', store.now.parameters);
  const put = async (what: string, value: string): Promise<void> => toast((await copy(value)) ? `${what} copied` : `this browser does not let a page copy; ${what.toLowerCase()}: ${value}`);
  const link = (): void => {
    fragment.write(store.now);
    const own = app.files.has(store.now.mesh) && store.now.obj === null;
    void put('Link', location.href).then(() => own && toast('link copied; it does not hold your mesh, which is too large or no OBJ'));
  };
  const item = (label: string, test: string, act: () => void) => h('button', { type: 'button', 'data-test': test, onclick: () => { menu.open = false; act(); } }, label);
  const menu = h('details', { class: 'menu' }, h('summary', { 'data-test': 'copy' }, 'Copy'), h('div', {},
    item('Link to this state', 'copy-link', link),
    item('Scheme file', 'copy-scheme', () => void put('Scheme file', text())),
    item('limn command', 'copy-command', () => void put('Command', command(store.now, app.model.mesh?.name.includes('.') ? app.model.mesh.name : `${app.model.mesh?.name ?? 'mesh'}.obj`))),
    item('Save the scheme file', 'save-scheme', () => download(`${store.now.scheme || 'mine'}.toml`, new Blob([text()], { type: 'text/plain' })))));
  document.addEventListener('pointerdown', (event) => { if (!menu.contains(event.target as Node)) menu.open = false; });
  return { element: menu, link };
}

function toaster() {
  const element = h('div', { class: 'toasts', role: 'status', 'aria-live': 'polite', 'data-test': 'toast' });
  const put = (content: (Node | string)[], seconds: number): HTMLElement => {
    const box = h('div', { class: 'toast' }, ...content);
    element.replaceChildren(box);
    if (seconds) setTimeout(() => box.remove(), seconds * 1000);
    return box;
  };
  return {
    element,
    say: (text: string): void => void put([text], 4),
    offer(text: string, lines: string[], label: string, act?: () => void): void {
      const box: HTMLElement = put([h('strong', {}, text), h('ul', {}, ...lines.map((line) => h('li', {}, line))), h('div', { class: 'row' },
        act && h('button', { type: 'button', class: 'main', 'data-test': 'repair', onclick: () => { box.remove(); act(); } }, label),
        h('button', { type: 'button', class: 'quiet', onclick: () => box.remove() }, 'Close'))], 0);
    },
  };
}

/** What is wrong with a dropped mesh, with its lines; repair where that can help. */
function meshFaults(app: App, offer: ReturnType<typeof toaster>['offer'], name: string, faults: { line?: number; message: string; hint?: string }[], repairable: boolean): void {
  const file = app.files.get(name);
  const lines = faults.slice(0, 6).map((fault) => `${fault.line ? `line ${fault.line}: ` : ''}${fault.message}${fault.hint ? ` (${fault.hint})` : ''}`);
  if (faults.length > 6) lines.push(`and ${faults.length - 6} more`);
  offer(`${name} cannot be refined as it is`, lines, 'Repair and open', repairable && file ? () => drop(app, name, file.bytes, 'repair') : undefined);
}

function listenDrops(app: App): void {
  addEventListener('dragover', (event) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  });
  addEventListener('dragleave', (event) => { if (!event.relatedTarget) document.body.classList.remove('dropping'); });
  addEventListener('drop', async (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    if (/\.toml$/i.test(file.name)) app.store.set({ text: await file.text(), parameters: {} });
    else if (file.type.startsWith('image/')) await dropImage(app, file);
    else drop(app, file.name, new Uint8Array(await file.arrayBuffer()));
  });
}

/** A picture lies on the surface from then on; it goes into no link. */
async function dropImage(app: App, file: File): Promise<void> {
  try {
    app.image = await createImageBitmap(file, { imageOrientation: 'flipY' });
    app.store.set({ shade: 'texture', focus: 'surface' });
  } catch {
    document.dispatchEvent(new CustomEvent('toast', { detail: `${file.name} is no picture that this browser can read` }));
  }
}

type Actions = Record<'tour' | 'projector' | 'theme' | 'help' | 'play' | 'link' | 'on' | 'back' | 'close', () => unknown>;
function listenKeys(app: App, act: Actions): void {
  const { store } = app;
  const step = (key: 'levels' | 'valence', by: number, low: number, high: number): void =>
    store.set({ [key]: Math.max(low, Math.min(high, store.now[key] + by)) });
  const bindings: Record<string, () => unknown> = {
    '[': () => step('levels', -1, 0, 7), ']': () => step('levels', 1, 0, 7), ',': () => step('valence', -1, 3, 20), '.': () => step('valence', 1, 3, 20),
    m: () => store.set({ shade: shades[(shades.indexOf(store.now.shade) + 1) % shades.length]! }),
    l: () => store.set({ limit: !store.now.limit }), g: () => store.set({ net: !store.now.net }),
    p: act.play, t: act.tour, n: act.on, b: act.back, c: act.link, r: act.projector, d: act.theme, '?': act.help,
    Escape: () => (store.now.tour >= 0 ? act.tour() : act.close()),
  };
  focuses.forEach((focus, i) => (bindings[String(i + 1)] = () => store.set({ focus })));
  addEventListener('keydown', (event) => {
    const at = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || at.closest('textarea, select, input:not([type=range]):not([type=checkbox]), dialog')) return;
    const bound = bindings[event.key];
    if (!bound) return;
    event.preventDefault();
    bound();
  });
}
