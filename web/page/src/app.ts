// What the views share: the state, the core, the last good scheme and mesh, and how one view tells the others.
import { superseded, type Client, type Outcome } from './core/client';
import type { Opening } from './core/opening';
import type { Catalogue, Control, Fault, MeshSpec, SchemeInfo, SchemeSpec } from './core/results';
import { firstThatSuits, suits } from './core/suits';
import { ball, type Colours, type Painter } from './space/picture';
import { type Store, type State } from './state';
import { strToU8 } from 'fflate';

export interface GoodScheme {
  spec: SchemeSpec;
  info: SchemeInfo;
  label: string;
}
export interface GoodMesh {
  name: string;
  spec: Omit<MeshSpec, 'moved' | 'sharp'>;
  control: Control;
  ball: { centre: [number, number, number]; radius: number };
}
export interface Model {
  scheme?: GoodScheme;
  other?: GoodScheme;
  /** Of the text and parameters that stand now; empty where they are good. */
  errors: Fault[];
  otherErrors: Fault[];
  mesh?: GoodMesh;
  /** Why another mesh is shown than the one that was asked for. */
  meshNote: string;
}
export interface DroppedFile {
  bytes: Uint8Array;
  key: string;
}
export interface View {
  element: HTMLElement;
  /** Whether it belongs to the first picture; all else waits for that. */
  first?: boolean;
  /** The state or the model changed: ask for what is out of date. Called often; cheap where nothing concerns the view. */
  update(state: State, model: Model): void;
}
export interface Timing {
  what: string;
  total: number;
  core: number;
  drawn: number;
  vertices: number;
}

const growth = (split: string): number =>
  split.endsWith('ternary') ? 9 : split === 'sqrt3' ? 3 : split === 'quad-sqrt2' || split === 'midedge' ? 2 : 4;
/** The deepest level, of those offered, that keeps a surface below so many faces. */
export function deepest(split: string, faces: number, most = 400_000): number {
  return Math.max(1, Math.min(7, Math.floor(Math.log(most / Math.max(1, faces)) / Math.log(growth(split)))));
}

export function good<T>(outcome: Outcome<T> | typeof superseded): T | undefined {
  return outcome !== superseded && outcome.ok ? outcome.result : undefined;
}

export class App {
  readonly model: Model = { errors: [], otherErrors: [], meshNote: '' };
  readonly files = new Map<string, DroppedFile>();
  readonly timings: Timing[] = [];
  views: View[] = [];
  private asked = { scheme: '', other: '', mesh: '' };
  meshErrors: (name: string, faults: Fault[], canRepair: boolean) => void = () => {};
  onTiming: (timing: Timing) => void = () => {};
  /** A picture that was dropped, to lie on surfaces. */
  image?: ImageBitmap;
  /** Milliseconds from the page's beginning to the first surface on the screen; 0 before. */
  firstPicture = 0;
  /** The same to the first one that the core made: from then on everything answers. */
  firstAnswer = 0;
  private begun = false;

  constructor(readonly store: Store, readonly client: Client, readonly painter: Painter | null, readonly catalogue: Catalogue,
    readonly record: Record<string, unknown> | null, readonly opening: Opening) {
    store.listen(() => this.refresh());
  }

  shipped(name: string) {
    return this.catalogue.schemes.find((scheme) => scheme.name === name);
  }
  spec(state: State): SchemeSpec | null {
    const text = state.text ?? this.shipped(state.scheme)?.text;
    return text === undefined ? null : { text, parameters: state.parameters };
  }
  colours(): Colours {
    const style = getComputedStyle(document.documentElement);
    const of = (name: string): string => style.getPropertyValue(name).trim();
    return { ground: of('--ground'), surface: of('--body'), back: of('--body-back'), net: of('--net'), ink: of('--ink'), accent: of('--accent') };
  }
  /** The mesh with what was changed by hand. */
  meshSpec(state: State): MeshSpec | null {
    const mesh = this.model.mesh;
    return mesh ? { ...mesh.spec, moved: state.moved, sharp: state.sharp } : null;
  }
  time(timing: Timing): void {
    this.timings.push(timing);
    if (this.timings.length > 200) this.timings.shift();
    this.onTiming(timing);
  }

  refresh(): void {
    const state = this.store.now;
    this.loadScheme(state);
    this.loadOther(state);
    this.loadMesh(state);
    for (const view of this.views) if (this.begun || view.first) view.update(state, this.model);
  }

  /** The first surface was asked for and answered, or there is none: now the analyses. */
  begin(): void {
    if (this.begun) return;
    this.begun = true;
    this.refresh();
  }

  private async loadScheme(state: State): Promise<void> {
    const spec = this.spec(state);
    const key = JSON.stringify([state.scheme, spec]);
    if (this.asked.scheme === key) return;
    this.asked.scheme = key;
    if (!spec) {
      this.model.errors = [{ message: `no scheme "${state.scheme}" is shipped`, hint: 'pick one from the list' }];
      if (!this.model.scheme) this.store.set({ scheme: 'loop', parameters: {} });
      return;
    }
    const outcome = this.opening.load(spec) ?? (await this.client.ask('scheme', 'load', spec));
    if (outcome === superseded || this.asked.scheme !== key) return;
    if (outcome.ok) this.model.scheme = { spec, info: outcome.result, label: state.text === null ? state.scheme : outcome.result.name || 'mine' };
    this.model.errors = outcome.ok ? [] : outcome.errors;
    if (!outcome.ok && !this.model.scheme) await this.loadFirst();
    this.refresh();
  }

  /** A link to a scheme that is wrong still shows a page: its errors, over the surface of the first shipped scheme. */
  private async loadFirst(): Promise<void> {
    const first = this.shipped('loop') ?? this.catalogue.schemes[0];
    if (!first) return;
    const spec = { text: first.text, parameters: {} };
    const info = good(await this.client.ask('scheme-first', 'load', spec));
    if (info) this.model.scheme ??= { spec, info, label: first.name };
  }

  private async loadOther(state: State): Promise<void> {
    const text = state.other ? this.shipped(state.other)?.text : undefined;
    const key = state.other + JSON.stringify(state.otherParameters);
    if (this.asked.other === key) return;
    this.asked.other = key;
    if (text === undefined) {
      this.model.other = undefined;
      return;
    }
    const spec = { text, parameters: state.otherParameters };
    const outcome = await this.client.ask('other', 'load', spec);
    if (outcome === superseded || this.asked.other !== key) return;
    if (outcome.ok) this.model.other = { spec, info: outcome.result, label: state.other };
    this.model.otherErrors = outcome.ok ? [] : outcome.errors;
    this.refresh();
  }

  /** The mesh that was asked for where it suits the scheme, else the first that does. */
  private wanted(state: State): { name: string; spec: GoodMesh['spec']; note: string } | null {
    const split = this.model.scheme?.info.split;
    if (!split) return null;
    if (state.obj !== null && !this.files.has(state.mesh)) this.files.set(state.mesh, { bytes: strToU8(state.obj), key: `link${state.obj.length}` });
    const file = this.files.get(state.mesh);
    if (file) return { name: state.mesh, spec: { name: state.mesh, file: { ...file, repair: state.repair } }, note: '' };
    const asked = this.catalogue.meshes.find((mesh) => mesh.name === state.mesh);
    if (asked && suits(split, asked)) return { name: asked.name, spec: { name: asked.name }, note: '' };
    const first = firstThatSuits(split, this.catalogue.meshes);
    if (!first) return null;
    const note = asked ? `${asked.name} has ${asked.faces}; ${split} needs others: this is ${first.name}` : '';
    return { name: first.name, spec: { name: first.name }, note };
  }

  private async loadMesh(state: State): Promise<void> {
    const wanted = this.wanted(state);
    if (!wanted) return;
    const key = `${wanted.name}|${wanted.spec.file?.key ?? ''}|${wanted.spec.file?.repair ?? ''}`;
    this.model.meshNote = wanted.note;
    if (this.asked.mesh === key) return;
    this.asked.mesh = key;
    const spec = { ...wanted.spec, moved: {}, sharp: {} };
    const outcome = this.opening.control(spec) ?? (await this.client.ask('control', 'control', spec));
    if (outcome === superseded || this.asked.mesh !== key) return;
    if (outcome.ok) {
      this.model.mesh = { name: wanted.name, spec: wanted.spec, control: outcome.result, ball: ball(outcome.result.positions) };
      this.refresh();
      return;
    }
    this.meshErrors(wanted.name, outcome.errors, wanted.spec.file?.repair !== 'repair');
    this.files.delete(wanted.name);
    this.asked.mesh = '';
    this.store.set({ mesh: this.model.mesh && this.files.has(this.model.mesh.name) ? this.model.mesh.name : '', obj: null, repair: '', moved: {}, sharp: {} });
  }
}
