// A parameter over its range, or the valence, as a strip of small pictures with what the eigenvalues say of each.
import { good, type App, type GoodScheme, type Model, type View } from '../app';
import type { MeshSpec, SchemeSpec, Surface } from '../core/results';
import { fraction, partsOfOne } from '../scheme_text';
import { ball } from '../space/picture';
import type { State } from '../state';
import { figures, h, say, show } from '../ui/dom';
import { verdictWord } from './words';

const count = 7;
interface Step {
  label: string;
  scheme: SchemeSpec;
  mesh: MeshSpec;
  valence: number;
  patch: Partial<State>;
}

export function sweepView(app: App): View {
  const { store } = app;
  const what = h('select', { 'aria-label': 'What is swept', 'data-test': 'sweep', onchange: () => store.set({ sweep: what.value }) });
  const strip = h('div', { class: 'strip', 'data-test': 'strip' });
  const note = h('p', { class: 'note', hidden: true });
  const element = h('section', { class: 'card', id: 'sweep', 'data-view': 'sweep', 'aria-label': 'Sweep' },
    h('header', {}, h('h2', {}, 'Sweep'), what), note, strip);
  let asked = '';
  let shown: { canvas: HTMLCanvasElement; surface?: Surface; net: Float32Array }[] = [];

  function paint(): void {
    const [azimuth, height, distance] = store.now.camera;
    for (const { canvas, surface, net } of shown) {
      const box = canvas.getBoundingClientRect();
      const scale = Math.min(2, devicePixelRatio || 1);
      Object.assign(canvas, { width: Math.round(box.width * scale), height: Math.round(box.height * scale) });
      if (!surface?.triangles || !canvas.width) continue;
      const shade = store.now.shade === 'reflection' || store.now.shade === 'normals' ? store.now.shade : 'plain';
      app.painter?.draw({ body: { positions: surface.positions, normals: surface.normals, triangles: surface.triangles, shade },
        wires: [], dots: [], ...ball(net) }, { azimuth, height, distance: Math.min(distance, 3) }, canvas, app.colours());
    }
  }
  async function fill(steps: Step[], levels: number, lane: number): Promise<void> {
    shown = [];
    strip.replaceChildren(...steps.map((step, i) => {
      const canvas = h('canvas', {});
      const tangent = h('span', { class: 'number' });
      const word = h('span', {});
      shown.push({ canvas, net: new Float32Array(0) });
      void one(step, i, levels, tangent, word, shown[i]!, lane);
      return h('button', { type: 'button', class: 'small', title: 'Take this one', onclick: () => store.set(step.patch) }, canvas,
        h('b', {}, step.label), h('small', {}, 'μ₁ ', tangent), h('small', {}, 'C¹ ', word));
    }));
  }
  async function one(step: Step, i: number, levels: number, tangent: HTMLElement, word: HTMLElement, place: (typeof shown)[0], lane: number): Promise<void> {
    const eigen = good(await app.client.ask(`sweep-eigen-${i}`, 'eigenQuick', step.scheme, step.valence));
    if (lane !== run) return;
    say(tangent, figures(eigen?.components.tangent, 4));
    say(word, eigen?.verdict.c1_necessary ?? '–');
    word.className = verdictWord(eigen?.verdict.c1_necessary ?? '');
    const control = good(await app.client.ask(`sweep-net-${i}`, 'control', { ...step.mesh, moved: {}, sharp: {} }));
    const surface = good(await app.client.ask(`sweep-${i}`, 'surface', { scheme: step.scheme, mesh: step.mesh, levels, limit: store.now.limit, shade: 'plain' }));
    if (lane !== run || !control) return;
    Object.assign(place, { surface, net: control.positions });
    paint();
  }
  let run = 0;

  function steps(state: State, scheme: GoodScheme): Step[] {
    const mesh = app.meshSpec(state)!;
    if (state.sweep === 'valence' || !scheme.info.parameters.some((p) => p.name === sweptName(state, scheme))) {
      const of = /^vertex-(\d+)-(triangles|quads)$/;
      return app.catalogue.meshes.flatMap((one) => {
        const match = of.exec(one.name);
        return match && match[2] === scheme.info.lattice ? [{ label: `n = ${match[1]}`, scheme: scheme.spec, valence: Number(match[1]),
          mesh: { name: one.name, moved: {}, sharp: {} }, patch: { valence: Number(match[1]), mesh: one.name, obj: null, moved: {}, sharp: {} } }] : [];
      }).sort((a, b) => a.valence - b.valence).slice(0, 10);
    }
    const parameter = scheme.info.parameters.find((p) => p.name === sweptName(state, scheme))!;
    const { name, min, max } = parameter;
    if (min === null || max === null) return [];
    const parts = partsOfOne(min, max, parameter.integer);
    const values = [...new Set(Array.from({ length: count }, (_, i) => fraction(Math.round((min + ((max - min) * i) / (count - 1)) * parts), parts)))];
    return values.map((value) => ({ label: `${name} = ${value}`, valence: state.valence, mesh,
      scheme: { text: scheme.spec.text, parameters: { ...scheme.spec.parameters, [name]: value } },
      patch: { parameters: { ...state.parameters, [name]: value } } }));
  }

  return {
    element,
    update(state: State, model: Model): void {
      const { scheme, mesh } = model;
      if (!scheme || !mesh) return;
      const names = [...scheme.info.parameters.filter((p) => p.min !== null && p.max !== null).map((p) => p.name), 'valence'];
      if (what.dataset.key !== names.join()) {
        what.dataset.key = names.join();
        what.replaceChildren(...names.map((name) => h('option', { value: name }, name)));
      }
      what.value = names.includes(state.sweep) ? state.sweep : names[0]!;
      if (!visible(element)) return;
      const list = steps({ ...state, sweep: what.value }, scheme);
      show(note, list.length === 0);
      say(note, 'nothing to sweep');
      const levels = Math.min(3, state.levels, mesh.control.check.faces > 2000 ? 1 : 3);
      const key = JSON.stringify([list.map((s) => [s.label, s.scheme.parameters]), scheme.spec.text, levels, state.limit, what.value, state.valence, mesh.name, state.moved, state.sharp]);
      if (key !== asked) {
        asked = key;
        void fill(list, levels, ++run);
      } else paint();
    },
  };
}
const sweptName = (state: State, scheme: GoodScheme): string => state.sweep || (scheme.info.parameters[0]?.name ?? 'valence');
const visible = (element: HTMLElement): boolean => element.offsetParent !== null;
