// The stage: the control mesh and its surface, alone or beside a second scheme's.
import { strToU8 } from 'fflate';
import { deepest, type App, type Model, type View } from '../app';
import { suits } from '../core/suits';
import { gradient } from '../ui/colours';
import { choice, figures, h, say, show, slider, thousands } from '../ui/dom';
import { saveSvgText, savePng } from '../ui/export';
import type { State } from '../state';
import { sharpnessPanel } from './sharpness';
import { Pane } from './pane';

const shadeNames = [['plain', 'Plain'], ['reflection', 'Reflection'], ['gaussian', 'Gauss'], ['mean', 'Mean'], ['normals', 'Normals'], ['distance', 'Distance'], ['texture', 'Texture']] as const;

export function surfaceView(app: App): View & { panes: Pane[]; play(): void } {
  const { store } = app;
  let held: number | undefined;
  const hand = (pane: () => Pane) => ({
    take(x: number, y: number): boolean {
      if (!store.now.net) return false;
      const under = pane().pick(x, y);
      held = under?.kind === 'v' ? under.index : undefined;
      return held !== undefined;
    },
    drag(x: number, y: number): void {
      if (held !== undefined) store.set({ moved: { ...store.now.moved, [held]: pane().follow(held, x, y) } });
    },
    drop(x: number, y: number, still: boolean): void {
      if (still) choose(store.now.net ? pane().pick(x, y) : undefined);
      held = undefined;
    },
    hover(x: number, y: number): void {
      const under = store.now.net ? pane().pick(x, y) : undefined;
      if (under?.kind === pane().hovered?.kind && under?.index === pane().hovered?.index) return;
      for (const one of panes) one.hovered = under;
      pane().canvas.style.cursor = under ? 'pointer' : '';
      for (const one of panes) one.draw();
    },
  });
  const first: Pane = new Pane(app, 'surface', hand(() => first));
  const second: Pane = new Pane(app, 'surface-b', hand(() => second));
  const panes = [first, second];
  first.canvas.dataset.test = 'stage';
  const panel = sharpnessPanel(app);
  function choose(element: Pane['chosen']): void {
    for (const pane of panes) (pane.chosen = element), pane.draw();
    panel.choose(element);
  }
  panel.closed = () => choose(undefined);

  const status = h('div', { class: 'status', 'data-test': 'surface-status', role: 'status' });
  const note = h('div', { class: 'note', 'data-test': 'surface-note', hidden: true });
  const bar = h('i', {});
  const low = h('span', {});
  const high = h('span', {});
  const legend = h('div', { class: 'legend', hidden: true }, low, bar, high);
  const stage = h('div', { class: 'stage' }, first.element, second.element, legend, note, panel.element);
  if (!app.painter) stage.append(h('p', { class: 'note' }, 'This browser draws no canvas; numbers are in the other views.'));

  const mesh = h('select', { 'aria-label': 'Control mesh', 'data-test': 'mesh', onchange: () =>
    store.set({ mesh: mesh.value, moved: {}, sharp: {}, obj: null, repair: '' }) });
  const file = h('input', { type: 'file', accept: '.obj,.off,.ply,.stl', hidden: true, onchange: async () => {
    const chosen = file.files?.[0];
    if (chosen) drop(app, chosen.name, new Uint8Array(await chosen.arrayBuffer()));
    file.value = '';
  } });
  const open = h('button', { type: 'button', class: 'quiet', title: 'Or drop a file anywhere on the page', onclick: () => file.click() }, 'Open…');
  const levels = slider({ label: 'Level', name: 'levels', min: 0, max: 6, step: 1, change: (value) => store.set({ levels: value }) });
  const shades = choice('Shading', shadeNames, (shade) => store.set({ shade }));
  const check = (text: string, key: 'limit' | 'net') => {
    const box = h('input', { type: 'checkbox', 'data-test': key, onchange: () => store.set({ [key]: box.checked }) });
    return { box, element: h('label', { class: 'check' }, box, text) };
  };
  const limit = check('Limit', 'limit');
  const net = check('Mesh', 'net');
  const back = h('button', { type: 'button', class: 'quiet', hidden: true, 'data-test': 'undo-edits', onclick: () => store.set({ moved: {}, sharp: {} }) }, 'Undo edits');

  let playing = 0;
  const playButton = h('button', { type: 'button', class: 'quiet', 'aria-pressed': 'false', title: 'Play the levels (p)', onclick: () => play() }, '▶');
  function play(): void {
    if (playing) {
      clearInterval(playing);
      playing = 0;
    } else {
      const end = Math.max(2, Math.min(5, Number(levels.input.max)));
      store.set({ levels: 0, limit: false });
      playing = window.setInterval(() => store.set({ levels: store.now.levels >= end ? 0 : store.now.levels + 1 }), 900);
    }
    playButton.setAttribute('aria-pressed', String(playing !== 0));
    playButton.textContent = playing ? '❚❚' : '▶';
  }

  const save = h('div', { class: 'save' },
    h('button', { type: 'button', class: 'quiet', title: 'Save the picture', onclick: () => savePng(first.canvas, 'surface.png') }, 'PNG'),
    h('button', { type: 'button', class: 'quiet', title: 'Save the picture as polygons and lines', 'data-test': 'surface-svg', onclick: async () => {
      const text = await first.vector();
      if (text) saveSvgText(text, 'surface.svg');
    } }, 'SVG'));
  const tools = h('div', { class: 'tools' }, h('div', { class: 'pick' }, mesh, open, file), levels.element, playButton,
    limit.element, net.element, shades.element, back, save);
  const element = h('section', { class: 'card', id: 'surface', 'data-view': 'surface', 'aria-label': 'Surface' }, stage, status, tools);

  function report(): void {
    const surface = first.opening ? undefined : first.surface;
    const state = store.now;
    const faults = [...first.faults, ...(app.model.other ? second.faults : [])];
    const words = [app.model.meshNote, ...faults.map((f) => (f.hint ? `${f.message}; ${f.hint}` : f.message))].filter(Boolean);
    if (state.limit && surface?.info.limit === false && surface.info.reason) words.push(`no limit surface here: ${surface.info.reason}`);
    if (state.limit && surface?.info.missing) words.push(`the holes are where there is no limit, at ${thousands(surface.info.missing)} vertices: ${surface.info.reason}`);
    if (state.shade === 'texture' && first.texture?.pattern === 'none') words.push(`a checker in space, since there are no texture coordinates: ${first.texture.reason}`);
    const missing = state.shade === 'distance' && !app.model.other ? ['distance to what? choose a second scheme under Compare'] : [];
    say(note, [...words, ...missing].join(' · '));
    show(note, words.length + missing.length > 0);
    if (surface)
      say(status, `${thousands(surface.positions.length / 3)} vertices · ${state.limit ? 'limit points of ' : ''}level ${levelsShown(state)}` +
        (app.painter?.name === 'canvas' ? ' · drawn without WebGL' : ''));
    status.dataset.vertices = surface ? String(surface.positions.length / 3) : '';
    status.dataset.lines = String(first.segments);
    show(legend, first.range !== undefined && ['gaussian', 'mean', 'distance'].includes(state.shade));
    if (first.range) {
      say(low, figures(first.range[0]));
      say(high, figures(first.range[1]));
      bar.style.background = gradient(state.shade !== 'distance');
    }
  }
  const levelsShown = (state: State): number => {
    const { scheme, mesh: shown } = app.model;
    return scheme && shown ? Math.min(state.levels, deepest(scheme.info.split, shown.control.check.faces)) : state.levels;
  };
  first.onSurface = second.onSurface = report;

  return {
    element, panes, play, first: true,
    update(state: State, model: Model): void {
      fillMeshes(app, mesh, model);
      levels.set(state.levels);
      if (model.scheme && model.mesh) levels.input.max = String(deepest(model.scheme.info.split, model.mesh.control.check.faces));
      limit.box.checked = state.limit;
      net.box.checked = state.net;
      shades.set(state.shade);
      show(back, Object.keys(state.moved).length + Object.keys(state.sharp).length > 0);
      show(second.element, model.other !== undefined);
      stage.dataset.panes = model.other ? '2' : '1';
      first.update(state, model.scheme, model.other);
      if (model.other) second.update(state, model.other, model.scheme);
      panel.update(state);
      report();
    },
  };
}

function fillMeshes(app: App, select: HTMLSelectElement, model: Model): void {
  const split = model.scheme?.info.split ?? '';
  const names = [...app.catalogue.meshes.filter((m) => suits(split, m)).map((m) => [m.name, m.summary || m.name] as const),
    ...[...app.files.keys()].map((name) => [name, `${name} (yours)`] as const)];
  const key = names.map(([n]) => n).join('|');
  if (select.dataset.key !== key) {
    select.dataset.key = key;
    select.replaceChildren(...names.map(([value, title]) => h('option', { value, title }, app.files.has(value) ? title : value)));
  }
  if (model.mesh) select.value = model.mesh.name;
}

const linkable = 60_000;

/** A file that a person gives: kept, and shown; what is wrong with it is said, and the mesh of before stays. */
export function drop(app: App, name: string, bytes: Uint8Array, repair = ''): void {
  if (bytes.length > 200_000_000) return app.meshErrors(name, [{ message: `${name} has more than 200 MB` }], false);
  let key = 5381;
  for (let i = 0; i < bytes.length; i += 1 + (bytes.length >> 14)) key = (key * 33 + bytes[i]!) | 0;
  app.files.set(name, { bytes, key: `${bytes.length}.${key}` });
  const text = /\.obj$/i.test(name) && bytes.length <= linkable ? new TextDecoder().decode(bytes) : null;
  const same = text !== null && strToU8(text).length === bytes.length;
  app.store.set({ mesh: name, obj: same ? text : null, repair, moved: {}, sharp: {}, focus: 'surface' });
}
