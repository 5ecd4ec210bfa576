// What a step costs, measured in this browser, on request.
import type { App, Timing } from '../app';
import { good } from '../app';
import { h, say, show, thousands } from '../ui/dom';

export function timingPanel(app: App) {
  const first = h('p', { 'data-test': 'timing-first' });
  const last = h('p', { 'data-test': 'timing-last' });
  const result = h('p', { 'data-test': 'timing-result' });
  const measure = h('button', { type: 'button', class: 'main', 'data-test': 'measure', onclick: () => void run() }, 'Measure');
  const element = h('div', { class: 'popover timing', hidden: true, 'data-test': 'timing' }, h('header', {}, h('strong', {}, 'Timing'),
    h('button', { type: 'button', class: 'quiet', 'aria-label': 'Close', onclick: () => show(element, false) }, '×')), first, last, measure, result);
  const tellFirst = (): void => {
    say(first, `First picture: ${Math.round(app.firstPicture)} ms after the page began; the core's first surface: ${Math.round(app.firstAnswer)} ms.`);
    element.dataset.first = String(app.firstPicture);
    element.dataset.answer = String(app.firstAnswer);
  };
  app.onTiming = (timing: Timing): void => {
    tellFirst();
    say(last, `Last step, ${timing.what}: ${timing.total.toFixed(1)} ms, of which ${timing.core.toFixed(1)} ms in the core; drawn in ${timing.drawn.toFixed(1)} ms; ${thousands(timing.vertices)} vertices.`);
  };

  /** Moves a control vertex, and then a parameter, by small steps at the first level with 50 thousand vertices. */
  async function run(): Promise<void> {
    measure.disabled = true;
    say(result, 'measuring…');
    const state = app.store.now;
    const { scheme, mesh } = app.model;
    const spec = app.meshSpec(state);
    if (!scheme || !mesh || !spec) return;
    let levels = 0;
    let vertices = 0;
    while (levels < 8 && vertices < 50_000) {
      const made = good(await app.client.ask('timing', 'surface', { scheme: scheme.spec, mesh: spec, levels: ++levels, limit: state.limit, shade: 'plain' }));
      if (!made) break;
      vertices = made.positions.length / 3;
    }
    const ask = { scheme: scheme.spec, mesh: spec, levels, limit: state.limit, shade: 'plain' as const };
    const has = good(await app.client.ask('timing', 'surface', ask))?.topology;
    const [x, y, z] = mesh.control.positions as unknown as [number, number, number];
    const moved = await series(30, (i) => ({ ...ask, has, mesh: { ...spec, moved: { ...spec.moved, 0: [x + i * 1e-3, y, z] as [number, number, number] } } }));
    const one = scheme.info.parameters.find((p) => p.min !== null && p.max !== null && !p.integer);
    const changed = one && await series(12, (i) => ({ ...ask, has, scheme: { text: scheme.spec.text,
      parameters: { ...scheme.spec.parameters, [one.name]: `${Math.round((one.min! + (one.max! - one.min!) * (0.3 + i / 60)) * 9600)}/9600` } } }));
    measure.disabled = false;
    element.dataset.vertices = String(vertices);
    element.dataset.moved = String(moved.total);
    element.dataset.changed = changed ? String(changed.total) : '';
    const words = (s: { total: number; core: number }): string => `${s.total.toFixed(1)} ms (${s.core.toFixed(1)} ms in the core)`;
    say(result, `${thousands(vertices)} vertices with normals, median of a step from question to answer: a vertex moved ${words(moved)}` +
      (changed ? `; parameter ${one.name} changed ${words(changed)}.` : '.'));
  }
  async function series(count: number, ask: (i: number) => Parameters<typeof app.client.ask<'surface'>>[2]): Promise<{ total: number; core: number }> {
    const times: [number, number][] = [];
    for (let i = 0; i < count; ++i) {
      const begun = performance.now();
      const made = good(await app.client.ask('timing', 'surface', ask(i)));
      if (made) times.push([performance.now() - begun, made.planned + made.evaluated]);
    }
    const median = (k: 0 | 1): number => times.map((t) => t[k]).sort((a, b) => a - b)[Math.floor(times.length / 2)] ?? NaN;
    return { total: median(0), core: median(1) };
  }
  return { element, toggle: (): void => (tellFirst(), show(element, element.hidden)) };
}
