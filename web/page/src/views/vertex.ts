// The extraordinary vertex: eigenvalues by rotational frequency, the verdict with its reasons, the characteristic map.
// Numbers stand as text, so that they can be read, copied and tested without any picture.
import { type App, type GoodScheme, type Model, type View } from '../app';
import { superseded } from '../core/client';
import type { Eigen } from '../core/results';
import type { State } from '../state';
import { h, s, say, show, six, slider } from '../ui/dom';
import { saveSvg, saveSvgAsPng } from '../ui/export';
import { verdictWord } from './words';

type Map = { about: Record<string, unknown>; points: Float32Array; lines: Uint32Array };
const components = ['tangent', 'cup', 'saddle'] as const;

export function vertexView(app: App): View {
  const { store } = app;
  const valence = slider({ label: 'Valence n', name: 'valence', min: 3, max: 20, step: 1, change: (n) => store.set({ valence: n }) });
  const cells = Object.fromEntries(components.map((name) => [name, h('td', { class: 'number', 'data-value': name })]));
  const others = Object.fromEntries(components.map((name) => [name, h('td', { class: 'number second', 'data-value': `${name}-b` })]));
  const square = h('td', { class: 'number', 'data-value': 'tangent-squared' });
  const meanings = { tangent: 'μ₁, of ω = 1', cup: 'ω = 0', saddle: 'ω = 2' };
  const heads = [h('th', {}), h('th', {}), h('th', { class: 'second' })];
  const table = h('table', { class: 'numbers', 'data-test': 'components' }, h('thead', {}, h('tr', {}, ...heads)),
    h('tbody', {}, ...components.map((name) => h('tr', {}, h('th', { scope: 'row' }, name, h('small', {}, meanings[name])), cells[name]!, others[name]!)),
      h('tr', {}, h('th', { scope: 'row' }, 'μ₁²'), square, h('td', { class: 'second' }))));
  const verdicts = h('dl', { class: 'verdicts', 'data-test': 'verdict' });
  const reasons = h('ul', { class: 'reasons', 'data-test': 'reasons' });
  const chart = h('figure', { class: 'chart', 'data-test': 'eigen-chart' });
  const map = h('figure', { class: 'map', 'data-test': 'characteristic-map' });
  const mapNote = h('figcaption', {});
  const note = h('p', { class: 'note', hidden: true, 'data-test': 'vertex-note' });
  const numbersList = h('div', { class: 'blocks', 'data-test': 'blocks' });
  const all = h('details', {}, h('summary', {}, 'All eigenvalues'), numbersList);
  const svg = (at: HTMLElement) => (): SVGSVGElement | null => at.querySelector('svg');
  const save = (name: string, find: () => SVGSVGElement | null) => h('span', { class: 'save' },
    h('button', { type: 'button', class: 'quiet', onclick: () => saveSvg(find(), `${name}.svg`) }, 'SVG'),
    h('button', { type: 'button', class: 'quiet', onclick: () => saveSvgAsPng(find(), `${name}.png`) }, 'PNG'));
  const element = h('section', { class: 'card', id: 'vertex', 'data-view': 'vertex', 'aria-label': 'Extraordinary vertex' },
    h('header', {}, h('h2', {}, 'Vertex'), valence.element), note,
    h('div', { class: 'body two' }, h('div', { class: 'body' }, table, verdicts, reasons, all), h('div', { class: 'figures' },
      h('div', { class: 'framed' }, h('h3', {}, 'Eigenvalues by frequency', save('eigenvalues', svg(chart))), chart),
      h('div', { class: 'framed' }, h('h3', {}, 'Characteristic map', save('characteristic-map', svg(map))), map, mapNote))));

  const asked = { eigen: '', eigenB: '', map: '' };
  let drawn: Eigen | undefined;

  async function ask(scheme: GoodScheme, n: number): Promise<void> {
    const quick = await app.client.ask('eigen', 'eigenQuick', scheme.spec, n);
    if (quick === superseded) return;
    show(note, !quick.ok);
    element.classList.toggle('stale', !quick.ok);
    if (!quick.ok) return say(note, quick.errors.map((e) => e.message).join(' · '));
    numbers(quick.result, cells);
    drawn = quick.result;
    void draw();
    verdict(quick.result, true);
    const whole = await app.client.askSlow('eigen-whole', 'eigen', scheme.spec, n);
    if (whole !== superseded && whole.ok && drawn === quick.result) verdict(whole.result, false);
  }
  async function askSecond(scheme: GoodScheme, n: number): Promise<void> {
    const answer = await app.client.ask('eigen-b', 'eigenQuick', scheme.spec, n);
    if (answer !== superseded) numbers(answer.ok ? answer.result : undefined, others);
  }
  function numbers(eigen: Eigen | undefined, into: Record<string, HTMLElement>): void {
    for (const name of components) say(into[name]!, six(eigen?.components[name]));
    if (into !== cells || !eigen) return;
    element.dataset.valence = String(eigen.valence);
    const tangent = eigen.components.tangent;
    say(square, six(tangent === null ? null : tangent ** 2));
    numbersList.replaceChildren(...eigen.blocks.map((block) => h('p', {}, h('b', {}, `ω = ${block.frequency}`), ' ',
      ...block.eigenvalues.slice(0, 12).flatMap((one) => [h('span', { class: 'number' }, complex(one.value)), ' ']))));
  }
  function verdict(eigen: Eigen, quick: boolean): void {
    const v = eigen.verdict;
    const rows: [string, string, string][] = [['C¹, necessary conditions', v.c1_necessary, 'c1'], ['bounded curvature', quick && v.bounded_curvature === 'undecided' ? '…' : v.bounded_curvature, 'curvature'],
      ['cup against μ₁²', v.cup ?? '–', 'cup'], ['saddle against μ₁²', v.saddle ?? '–', 'saddle']];
    verdicts.replaceChildren(...rows.flatMap(([label, word, name]) => [h('dt', {}, label), h('dd', { 'data-value': name, class: verdictWord(word) }, word)]));
    if (quick && v.reasons.length === 0 && reasons.childElementCount > 0) return;
    reasons.replaceChildren(...v.reasons.map((text) => h('li', {}, text)));
  }
  async function draw(): Promise<void> {
    if (!drawn) return;
    const plot = await limnStart.later();
    const width = Math.max(240, Math.min(720, chart.clientWidth || 340));
    chart.replaceChildren(eigenChart(plot, drawn, width, Math.round(Math.max(190, width * 0.58))));
  }
  async function askMap(scheme: GoodScheme, n: number): Promise<void> {
    const answer = await app.client.ask('map', 'characteristicMap', scheme.spec, n, scheme.info.split.includes('ternary') ? 2 : 3);
    if (answer === superseded) return;
    if (answer.ok) map.replaceChildren(mapPicture(answer.result));
    else map.replaceChildren(h('p', { class: 'none' }, answer.errors[0]?.message ?? 'none'));
    const regular = answer.ok ? String(answer.result.about.regular) : '';
    say(mapNote, answer.ok ? `regular, by samples: ${regular}${answer.result.about.reason ? ` (${answer.result.about.reason})` : ''}` : '');
  }
  let width = 0;
  new ResizeObserver(() => {
    if (Math.abs(chart.clientWidth - width) > 8) (width = chart.clientWidth), void draw();
  }).observe(chart);

  return {
    element,
    update(state: State, model: Model): void {
      const { scheme, other } = model;
      valence.set(state.valence);
      if (!scheme) return;
      valence.input.min = String(Math.max(2, scheme.info.valences.least));
      element.classList.toggle('paired', other !== undefined);
      say(heads[1]!, other ? scheme.label : '');
      say(heads[2]!, other?.label ?? '');
      const key = JSON.stringify([scheme.spec, state.valence]);
      if (scheme.info.features.eigen === false) {
        show(note, true);
        say(note, scheme.info.reasons.eigen ?? 'the scheme has no eigenanalysis');
        asked.eigen = '';
        return;
      }
      if (asked.eigen !== key) {
        asked.eigen = key;
        void ask(scheme, state.valence);
        void askMap(scheme, state.valence);
      }
      const second = other ? JSON.stringify([other.spec, state.valence]) : '';
      if (asked.eigenB !== second) {
        asked.eigenB = second;
        if (other) void askSecond(other, state.valence);
      }
    },
  };
}

function complex([re, im]: [number, number]): string {
  return im === 0 ? six(re) : `${six(re)} ${im < 0 ? '−' : '+'} ${six(Math.abs(im))} i`;
}

function eigenChart(Plot: Awaited<ReturnType<typeof limnStart.later>>, eigen: Eigen, width: number, height: number): SVGSVGElement | HTMLElement {
  const dots = eigen.blocks.flatMap((block) => block.eigenvalues.slice(0, 10).map((one, i) => ({
    omega: block.frequency, size: one.modulus, role: role(block.frequency, i), text: complex(one.value) })));
  const tangent = eigen.components.tangent;
  const lines = tangent === null ? [] : [{ y: Math.abs(tangent), text: 'μ₁' }, { y: tangent ** 2, text: 'μ₁²' }];
  const named = dots.filter((d) => d.role !== '');
  return Plot.plot({
    width, height, marginLeft: 40, marginRight: 34, marginBottom: 34, marginTop: 12, style: { background: 'transparent', fontSize: '11px', overflow: 'visible' },
    x: { type: 'linear', domain: [-0.4, Math.max(2, ...dots.map((d) => d.omega)) + 0.4], label: 'rotational frequency ω', ticks: [...new Set(dots.map((d) => d.omega))], tickFormat: 'd', labelAnchor: 'center', labelArrow: 'none' },
    y: { domain: [0, 1.02], label: null, ticks: 5, grid: false },
    marks: [
      Plot.ruleY(lines.slice(0, 1), { y: 'y', stroke: 'var(--accent)', strokeDasharray: '1 3' }),
      Plot.ruleY(lines.slice(1), { y: 'y', stroke: 'var(--accent)', strokeDasharray: '6 3' }),
      Plot.text(lines, { y: 'y', text: 'text', frameAnchor: 'right', dx: 26, fill: 'var(--accent)', fontSize: 12 }),
      Plot.ruleX(dots, Plot.groupX({ y: 'max' }, { x: 'omega', y: 'size', stroke: 'var(--line)' })),
      Plot.dot(dots, { x: 'omega', y: 'size', r: 3, stroke: 'var(--ink)', strokeWidth: 1.3, fill: 'var(--card)', title: 'text' }),
      Plot.dot(named, { x: 'omega', y: 'size', r: 4.5, fill: 'var(--ink)', title: 'text' }),
      Plot.text(named, { x: 'omega', y: 'size', text: 'role', dx: 9, textAnchor: 'start', fill: 'var(--ink)', stroke: 'var(--card)', strokeWidth: 5, fontSize: 11 }),
    ],
  });
}
const role = (omega: number, index: number): string =>
  omega === 1 && index === 0 ? 'tangent' : omega === 0 && index === 1 ? 'cup' : omega === 2 && index === 0 ? 'saddle' : '';

function mapPicture({ points, lines, about }: Map): SVGSVGElement {
  let reach = 1e-9;
  for (const x of points) reach = Math.max(reach, Math.abs(x));
  const scale = 100 / reach;
  const path: string[] = [];
  for (let i = 0; i + 1 < lines.length; i += 2) {
    const [a, b] = [2 * lines[i]!, 2 * lines[i + 1]!];
    path.push(`M${(points[a]! * scale).toFixed(2)} ${(-points[a + 1]! * scale).toFixed(2)}L${(points[b]! * scale).toFixed(2)} ${(-points[b + 1]! * scale).toFixed(2)}`);
  }
  const net = about.net as { points: [number, number][]; lines: [number, number][] } | undefined;
  const dots = (net?.points ?? []).filter((p) => Math.max(Math.abs(p[0]), Math.abs(p[1])) <= reach * 1.02);
  return s('svg', { viewBox: '-104 -104 208 208', class: 'characteristic', role: 'img', 'aria-label': 'Characteristic map' },
    s('path', { d: path.join(''), class: 'image' }),
    ...dots.map((p) => s('circle', { cx: (p[0] * scale).toFixed(2), cy: (-p[1] * scale).toFixed(2), r: 1.1, class: 'net' })),
    s('circle', { cx: 0, cy: 0, r: 2.4, class: 'centre' }));
}

