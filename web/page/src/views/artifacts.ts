// Artifacts over the frequencies: the map with a frequency to pick, what the numbers are there, and the wave's surface.
import { contours } from 'd3-contour';
import type { App, GoodScheme, Model, View } from '../app';
import { superseded } from '../core/client';
import type { MapInfo, WaveInfo } from '../core/results';
import { orbit } from '../space/orbit';
import { middleRange, type Look, type Picture } from '../space/picture';
import type { State } from '../state';
import { magnitudeColour } from '../ui/colours';
import { figures, h, s, say, show } from '../ui/dom';
import { saveSvg, saveSvgAsPng } from '../ui/export';

type Field = { about: MapInfo; values: Float32Array };
const levels = [0.1, 1, 5, 10, 25, 50, 100];
const tone = (percent: number): number => Math.log10(1 + percent * 9) / Math.log10(1 + 150 * 9);

export function artifactsView(app: App): View {
  const { store } = app;
  const map = h('figure', { class: 'map', 'data-test': 'artifact-map' });
  const mapB = h('figure', { class: 'map second', hidden: true });
  const wave = h('canvas', { class: 'wave', tabindex: 0, role: 'img', 'aria-label': 'Limit surface of the wave', 'data-test': 'wave' });
  const names = [['percent', 'all artifacts, % of the signal'], ['mean', 'mean energy, first refined lattice, %'], ['signal', 'signal'],
    ['edges', 'control edges per wavelength']] as const;
  const cells = Object.fromEntries(names.map(([name]) => [name, h('td', { class: 'number', 'data-value': name })]));
  const others = Object.fromEntries(names.map(([name]) => [name, h('td', { class: 'number second', 'data-value': `${name}-b` })]));
  const sampling = h('p', { class: 'sampling', 'data-test': 'sampling' });
  const note = h('p', { class: 'note', hidden: true });
  const inputs = [0, 1].map((i) => h('input', { type: 'number', step: 0.01, 'aria-label': i ? 'frequency along y' : 'frequency along x', 'data-test': i ? 'fy' : 'fx',
    onchange: () => {
      const f = [...store.now.frequency] as [number, number];
      const value = Number(inputs[i]!.value);
      if (Number.isFinite(value) && Math.abs(value) <= 4) f[i] = value;
      store.set({ frequency: f });
    } }));
  const element = h('section', { class: 'card', id: 'artifacts', 'data-view': 'artifacts', 'aria-label': 'Artifacts' },
    h('header', {}, h('h2', {}, 'Artifacts'), h('div', { class: 'frequency' }, 'f =', inputs[0]!, inputs[1]!)), note,
    h('div', { class: 'body two' },
      h('div', { class: 'framed' }, h('h3', {}, 'Percent of the signal', h('span', { class: 'save' },
        h('button', { type: 'button', class: 'quiet', onclick: () => saveSvg(map.querySelector('svg'), 'artifacts.svg') }, 'SVG'),
        h('button', { type: 'button', class: 'quiet', onclick: () => saveSvgAsPng(map.querySelector('svg'), 'artifacts.png') }, 'PNG'))),
        h('div', { class: 'maps' }, map, mapB)),
      h('div', {}, h('table', { class: 'numbers', 'data-test': 'artifact-numbers' }, h('tbody', {}, ...names.map(([name, label]) =>
        h('tr', {}, h('th', { scope: 'row' }, label), cells[name]!, others[name]!)))), sampling,
        h('div', { class: 'framed' }, h('h3', {}, 'The wave of this frequency'), wave))));

  const asked = { map: '', mapB: '', numbers: '', numbersB: '', wave: '', sampling: '' };
  let picture: Picture | undefined;
  let look: Look = { azimuth: 25, height: 38, distance: 3 };
  orbit(wave, () => look, (next) => ((look = next), paint()));

  function paint(): void {
    const box = wave.getBoundingClientRect();
    const scale = Math.min(2, devicePixelRatio || 1);
    Object.assign(wave, { width: Math.round(box.width * scale), height: Math.round(box.height * scale) });
    if (picture && wave.width && wave.height) app.painter?.draw(picture, look, wave, app.colours());
  }
  new ResizeObserver(paint).observe(wave);

  async function askMap(scheme: GoodScheme, lane: 'artifact-map' | 'artifact-map-b', at: HTMLElement): Promise<void> {
    const coarse = await app.client.ask(lane, 'artifactMap', scheme.spec, 48);
    if (coarse === superseded) return;
    if (!coarse.ok) return at.replaceChildren(h('p', { class: 'none' }, coarse.errors[0]?.message ?? 'none'));
    at.replaceChildren(mapPicture(coarse.result, scheme.label));
    mark(store.now.frequency);
    const fine = await app.client.askSlow(lane, 'artifactMap', scheme.spec, 192);
    if (fine === superseded || !fine.ok) return;
    at.replaceChildren(mapPicture(fine.result, scheme.label));
    mark(store.now.frequency);
  }
  async function askNumbers(scheme: GoodScheme, [fx, fy]: [number, number], into: Record<string, HTMLElement>, lane: string): Promise<void> {
    const answer = await app.client.ask(lane, 'artifacts', scheme.spec, fx, fy);
    if (answer === superseded) return;
    if (into === cells) {
      show(note, !answer.ok);
      element.classList.toggle('stale', !answer.ok);
      say(note, answer.ok ? '' : answer.errors.map((e) => e.message).join(' · '));
    }
    const one = answer.ok ? answer.result : undefined;
    say(into.percent!, figures(one?.total_energy_percent, 4));
    say(into.mean!, figures(one?.percent_of_signal, 4));
    say(into.signal!, one ? one.signal.toFixed(6) : '–');
    const size = Math.hypot(fx, fy);
    say(into.edges!, size > 0 ? figures(1 / size, 3) : '∞');
    into.percent!.dataset.exact = one?.total_energy_percent == null ? '' : String(one.total_energy_percent);
  }
  async function askWave(scheme: GoodScheme, [fx, fy]: [number, number]): Promise<void> {
    const answer = await app.client.ask('wave', 'wave', scheme.spec, fx, fy, 2);
    if (answer === superseded) return;
    picture = answer.ok ? wavePicture(answer.result) : undefined;
    paint();
  }
  async function askSampling(scheme: GoodScheme): Promise<void> {
    say(sampling, '…');
    const answer = await app.client.askSlow('sampling', 'sampling', scheme.spec, 1);
    if (answer === superseded) return;
    const energy = answer.ok ? answer.result.sampling.total_energy : undefined;
    say(sampling, energy ? `Within 1 % of the signal from ${figures(energy.worst.edges_per_wavelength)} control edges per wavelength (worst direction; ${figures(energy.best.edges_per_wavelength)} in the best).` : '');
  }

  function pick(event: PointerEvent, svg: SVGSVGElement): void {
    const box = svg.getScreenCTM();
    if (!box) return;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(box.inverse());
    const cell = JSON.parse(svg.dataset.cell!) as [number, number][];
    const f: [number, number] = [Number(at.x.toFixed(4)), Number((-at.y).toFixed(4))];
    if (inside(cell, f)) store.set({ frequency: f });
  }
  for (const figure of [map, mapB]) {
    const go = (event: PointerEvent): void => {
      const svg = figure.querySelector('svg');
      if (svg && event.buttons & 1) pick(event, svg);
    };
    figure.addEventListener('pointerdown', go);
    figure.addEventListener('pointermove', go);
  }
  function mark([fx, fy]: [number, number]): void {
    for (const dot of element.querySelectorAll('.picked')) dot.setAttribute('transform', `translate(${fx} ${-fy})`);
  }

  return {
    element,
    update(state: State, model: Model): void {
      const { scheme, other } = model;
      inputs.forEach((input, i) => document.activeElement !== input && (input.value = String(Number(state.frequency[i]!.toFixed(4)))));
      if (!scheme) return;
      const spec = JSON.stringify(scheme.spec);
      const once = (what: keyof typeof asked, key: string, go: () => void): void => {
        if (asked[what] !== key) (asked[what] = key), key && go();
      };
      once('numbers', spec + state.frequency, () => void askNumbers(scheme, state.frequency, cells, 'artifacts'));
      once('wave', spec + state.frequency, () => void askWave(scheme, state.frequency));
      once('map', spec, () => void askMap(scheme, 'artifact-map', map));
      once('sampling', spec, () => void askSampling(scheme));
      const two = other;
      const specB = two ? JSON.stringify(two.spec) : '';
      once('numbersB', specB && specB + state.frequency, () => void askNumbers(two!, state.frequency, others, 'artifacts-b'));
      once('mapB', specB, () => void askMap(two!, 'artifact-map-b', mapB));
      show(mapB, two !== undefined);
      element.classList.toggle('paired', two !== undefined);
      mark(state.frequency);
    },
  };
}

function inside(cell: [number, number][], [x, y]: [number, number]): boolean {
  let result = false;
  for (let i = 0, j = cell.length - 1; i < cell.length; j = i++) {
    const [a, b] = [cell[i]!, cell[j]!];
    if (a[1] > y !== b[1] > y && x < ((b[0] - a[0]) * (y - a[1])) / (b[1] - a[1]) + a[0]) result = !result;
  }
  return result;
}

/** The values as colours, with their level lines; y grows upwards, so rows are laid from below. */
function mapPicture({ about, values }: Field, label: string): SVGSVGElement {
  const { size, extent: [x0, y0, x1, y1], cell } = about;
  const image = document.createElement('canvas');
  Object.assign(image, { width: size, height: size });
  const to = image.getContext('2d')!;
  const pixels = to.createImageData(size, size);
  const filled = spread(values, size);
  for (let i = 0; i < size; ++i)
    for (let j = 0; j < size; ++j)
      pixels.data.set([...magnitudeColour(tone(filled[i * size + j]!)), 255], 4 * ((size - 1 - i) * size + j));
  to.putImageData(pixels, 0, 0);
  const [dx, dy] = [(x1 - x0) / size, (y1 - y0) / size];
  const outline = cell.map(([x, y], i) => `${i ? 'L' : 'M'}${x} ${-y}`).join('') + 'Z';
  const id = `cell${Math.random().toString(36).slice(2)}`;
  const lines = contours().size([size, size]).thresholds(levels)(Array.from(filled)).map((line) => s('path', {
    class: 'level', 'data-level': line.value,
    d: line.coordinates.flatMap((polygon) => polygon.map((ring) => ring.map(([x, y], i) =>
      `${i ? 'L' : 'M'}${(x0 + x! * dx).toFixed(4)} ${(-(y0 + y! * dy)).toFixed(4)}`).join('') + 'Z')).join('') }));
  const pad = 0.03 * (x1 - x0);
  return s('svg', { viewBox: `${x0 - pad} ${-y1 - pad} ${x1 - x0 + 2 * pad} ${y1 - y0 + 2 * pad}`, class: 'frequencies', 'data-cell': JSON.stringify(cell), role: 'img',
    'aria-label': `Artifacts of ${label} over the frequencies` },
    s('clipPath', { id }, s('path', { d: outline })),
    s('g', { 'clip-path': `url(#${id})` },
      s('image', { href: image.toDataURL(), x: x0, y: -y1, width: x1 - x0, height: y1 - y0, preserveAspectRatio: 'none' }), ...lines),
    s('path', { d: outline, class: 'outline' }),
    ...labels(filled, about),
    s('g', { class: 'picked' }, s('circle', { r: 0.018, class: 'halo' }), s('circle', { r: 0.012, class: 'dot' })));
}

/** Where each level is met along the horizontal through the middle: its number stands there. */
function labels(values: Float32Array, { size, extent: [x0, , x1] }: MapInfo): SVGTextElement[] {
  const row = Math.floor(size / 2) * size;
  let last = -Infinity;
  return levels.flatMap((level) => {
    for (let j = Math.floor(size / 2); j + 1 < size; ++j)
      if (values[row + j]! < level && values[row + j + 1]! >= level) {
        const x = x0 + ((j + 1) / size) * (x1 - x0);
        if (x - last < 0.07) return [];
        last = x;
        return [s('text', { x: x.toFixed(4), y: -0.012, class: 'label' }, `${level}`)];
      }
    return [];
  });
}

/** Gives cells beyond the region the value of the nearest one in their row or column, so that lines reach the outline. */
function spread(values: Float32Array, size: number): Float32Array {
  const out = values.slice();
  const sweep = (at: (line: number, i: number) => number): void => {
    for (let line = 0; line < size; ++line)
      for (const backwards of [false, true]) {
        let last = NaN;
        for (let k = 0; k < size; ++k) {
          const here = at(line, backwards ? size - 1 - k : k);
          if (Number.isNaN(out[here]!)) out[here] = last;
          else last = values[here]!;
          if (Number.isNaN(values[here]!) === false) last = values[here]!;
        }
      }
  };
  sweep((line, i) => line * size + i);
  sweep((line, i) => i * size + line);
  for (let i = 0; i < out.length; ++i) if (!Number.isFinite(out[i]!)) out[i] = 150;
  return out;
}

function wavePicture({ about, positions, triangles, errors }: { about: WaveInfo; positions: Float32Array; triangles: Uint32Array; errors: Float32Array }): Picture {
  const normals = new Float32Array(positions.length);
  const [u, v] = [[0, 0, 0], [0, 0, 0]];
  for (let t = 0; t + 2 < triangles.length; t += 3) {
    const [a, b, c] = [3 * triangles[t]!, 3 * triangles[t + 1]!, 3 * triangles[t + 2]!];
    for (let k = 0; k < 3; ++k) (u[k] = positions[b + k]! - positions[a + k]!), (v[k] = positions[c + k]! - positions[a + k]!);
    const n = [u[1]! * v[2]! - u[2]! * v[1]!, u[2]! * v[0]! - u[0]! * v[2]!, u[0]! * v[1]! - u[1]! * v[0]!];
    for (const at of [a, b, c]) for (let k = 0; k < 3; ++k) normals[at + k]! += n[k]!;
  }
  // Height is z there and y here.
  const turn = (from: Float32Array): Float32Array => {
    const to = new Float32Array(from.length);
    for (let i = 0; i < from.length; i += 3) to.set([from[i]!, from[i + 2]!, -from[i + 1]!], i);
    return to;
  };
  for (let i = 0; i < normals.length; i += 3) {
    const size = Math.hypot(normals[i]!, normals[i + 1]!, normals[i + 2]!) || 1;
    for (let k = 0; k < 3; ++k) normals[i + k]! /= size;
  }
  let reach = 0;
  for (let i = 0; i < positions.length; i += 3) reach = Math.max(reach, Math.abs(positions[i]!), Math.abs(positions[i + 1]!));
  const range = middleRange(errors, true);
  const end = Math.max(range[1], 0.02 * Math.abs(about.signal) || 0.02);
  return { body: { positions: turn(positions), normals: turn(normals), triangles, values: errors, range: [-end, end], shade: 'mean' },
    wires: [], dots: [], centre: [0, 0, 0], radius: reach * 1.15 || 1 };
}
