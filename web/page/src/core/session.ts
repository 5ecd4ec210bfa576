// The jobs that the worker does. Each is whole in itself: it names its scheme by text and its mesh by name or bytes, and
// the session keeps what the core has loaded, so that a step of a slider costs an evaluation and no more. A worker that
// was ended is replaced by a new one without the page noticing.
import type { Core } from './api';
import type * as R from './results';

interface Loaded {
  id: number;
  answer: R.Answer<R.SchemeInfo>;
}
interface LoadedMesh {
  id: number;
  check: R.MeshCheck;
  initial: Float32Array;
  edges: Uint32Array;
  moved: Set<number>;
  sharp: Record<string, number>;
}
interface Plan {
  id: number;
  info: R.Surface['info'];
}

class Kept<T> {
  private items = new Map<string, T>();
  constructor(private room: number, private drop: (item: T) => void) {}
  get(key: string): T | undefined {
    const item = this.items.get(key);
    if (item !== undefined) {
      this.items.delete(key);
      this.items.set(key, item);
    }
    return item;
  }
  put(key: string, item: T): T {
    this.items.set(key, item);
    for (const [oldest, value] of this.items) {
      if (this.items.size <= this.room) break;
      this.items.delete(oldest);
      this.drop(value);
    }
    return item;
  }
  /** Gives away the last one whose key matches. */
  take(matches: (key: string, item: T) => boolean): T | undefined {
    const key = [...this.items.keys()].reverse().find((one) => matches(one, this.items.get(one)!));
    const item = key === undefined ? undefined : this.items.get(key);
    if (key !== undefined) this.items.delete(key);
    return item;
  }
  remove(matches: (key: string) => boolean): void {
    for (const [key, value] of this.items)
      if (matches(key)) {
        this.items.delete(key);
        this.drop(value);
      }
  }
}

/** An answer that is no success, as an exception inside the session. */
class Refused extends Error {
  constructor(readonly errors: R.Fault[]) {
    super(errors[0]?.message ?? 'refused');
  }
}

function parse<T>(json: string): T {
  const value = JSON.parse(json) as { ok?: boolean; errors?: R.Fault[] };
  if (value.ok === false) throw new Refused(value.errors ?? []);
  return value as T;
}

export class Session {
  private schemes = new Kept<Loaded>(8, (item) => item.id >= 0 && this.core.unload(item.id));
  private meshes = new Kept<LoadedMesh>(4, (item) => this.core.unloadMesh(item.id));
  private plans = new Kept<Plan>(6, (item) => this.core.unplan(item.id));

  constructor(private core: Core) {}

  load(scheme: R.SchemeSpec): R.SchemeInfo {
    const { answer } = this.loaded(scheme);
    if (!answer.ok) throw new Refused(answer.errors);
    return { ...answer, features: answer.features ?? {}, reasons: answer.reasons ?? {} };
  }

  show(scheme: R.SchemeSpec): Record<string, unknown> {
    return parse(this.core.show(this.id(scheme)));
  }

  eigen(scheme: R.SchemeSpec, valence: number): R.Eigen {
    return parse(this.core.eigen(this.id(scheme), valence, false));
  }
  /** The same without the regular lattice, while a slider moves. */
  eigenQuick(scheme: R.SchemeSpec, valence: number): R.Eigen {
    return parse(this.core.eigen(this.id(scheme), valence, true));
  }

  /** The components over the valences; null where the scheme has none. */
  spectra(scheme: R.SchemeSpec, from: number, to: number): (R.Eigen | null)[] {
    const id = this.id(scheme);
    const list: (R.Eigen | null)[] = [];
    for (let n = from; n <= to; ++n) {
      try {
        list.push(parse<R.Eigen>(this.core.eigen(id, n, true)));
      } catch (error) {
        if (!(error instanceof Refused)) throw error;
        list.push(null);
      }
    }
    return list;
  }

  characteristicMap(scheme: R.SchemeSpec, valence: number, steps: number) {
    const { json, points, lines } = this.core.characteristicMap(this.id(scheme), valence, steps);
    return { about: parse<Record<string, unknown>>(json), points, lines };
  }

  artifacts(scheme: R.SchemeSpec, fx: number, fy: number): R.Artifacts {
    return parse(this.core.artifacts(this.id(scheme), fx, fy));
  }

  artifactMap(scheme: R.SchemeSpec, size: number) {
    const { json, values } = this.core.artifactMap(this.id(scheme), size, 'total_energy');
    return { about: parse<R.MapInfo>(json), values };
  }

  sampling(scheme: R.SchemeSpec, percent: number): R.Sampling {
    return parse(this.core.sampling(this.id(scheme), percent));
  }

  wave(scheme: R.SchemeSpec, fx: number, fy: number, levels: number) {
    const wave = this.core.wave(this.id(scheme), fx, fy, levels);
    return { ...wave, about: parse<R.WaveInfo>(wave.json) };
  }

  regularity(scheme: R.SchemeSpec, seconds: number): R.Regularity {
    return parse(this.core.regularity(this.id(scheme), seconds));
  }

  control(spec: R.MeshSpec): R.Control {
    const mesh = this.mesh(spec);
    return { positions: this.core.control(mesh.id).positions, edges: mesh.edges.slice(), check: mesh.check };
  }

  surface(ask: R.SurfaceAsk): R.Surface {
    const begin = performance.now();
    const mesh = this.mesh(ask.mesh);
    const plan = this.plan(ask.scheme, ask.mesh, mesh, ask);
    const middle = performance.now();
    const made = this.core.evaluate(plan.id);
    parse(made.json);
    const surface: R.Surface = {
      topology: this.topologyKey(ask, plan),
      positions: made.positions,
      normals: made.normals,
      info: plan.info,
      planned: middle - begin,
      evaluated: performance.now() - middle,
    };
    this.addValues(surface, ask, mesh, plan);
    if (surface.topology !== ask.has) {
      surface.triangles = this.core.topology(plan.id).triangles;
      if (ask.shade === 'texture') {
        const { json, coordinates } = this.core.texture(plan.id);
        surface.texture = { ...parse<Omit<R.Texture, 'coordinates'>>(json), coordinates };
      }
    }
    return surface;
  }

  lines(ask: R.SurfaceAsk): R.Lines {
    const plan = this.plan(ask.scheme, ask.mesh, this.mesh(ask.mesh), ask);
    const { json, vertices, begin, segments } = this.core.lines(plan.id);
    parse(json);
    return { topology: this.topologyKey(ask, plan), vertices, begin, segments };
  }

  private addValues(surface: R.Surface, ask: R.SurfaceAsk, mesh: LoadedMesh, plan: Plan): void {
    if (ask.shade === 'gaussian' || ask.shade === 'mean') {
      const curvature = this.core.curvature(plan.id);
      surface.about = parse(curvature.json);
      surface.values = curvature[ask.shade];
    } else if (ask.shade === 'distance' && ask.other) {
      const other = this.plan(ask.other, ask.mesh, mesh, ask, plan);
      const distance = this.core.distance(plan.id, other.id);
      surface.about = parse(distance.json);
      surface.values = distance.values;
    }
  }

  private schemeKey(scheme: R.SchemeSpec): string {
    return JSON.stringify(scheme.parameters) + scheme.text;
  }

  private loaded(scheme: R.SchemeSpec): Loaded {
    const key = this.schemeKey(scheme);
    const known = this.schemes.get(key);
    if (known) return known;
    const answer = JSON.parse(this.core.load(scheme.text, JSON.stringify(scheme.parameters))) as Loaded['answer'];
    return this.schemes.put(key, { id: answer.ok ? (answer as unknown as { id: number }).id : -1, answer });
  }

  private id(scheme: R.SchemeSpec): number {
    const { id, answer } = this.loaded(scheme);
    if (!answer.ok) throw new Refused(answer.errors);
    return id;
  }

  private meshKey(spec: R.MeshSpec): string {
    return spec.file ? `${spec.name}|${spec.file.key}|${spec.file.repair}` : spec.name;
  }

  private mesh(spec: R.MeshSpec): LoadedMesh {
    const key = this.meshKey(spec);
    const mesh = this.meshes.get(key) ?? this.meshes.put(key, this.readMesh(spec));
    this.change(mesh, spec, key);
    return mesh;
  }

  private readMesh(spec: R.MeshSpec): LoadedMesh {
    const json = spec.file ? this.core.loadMesh(spec.name, spec.file.bytes, spec.file.repair) : this.core.mesh(spec.name);
    const { id, check } = parse<{ id: number; check: R.MeshCheck }>(json);
    const control = this.core.control(id);
    return { id, check, initial: control.positions, edges: control.edges, moved: new Set(), sharp: {} };
  }

  /** Makes the core's mesh as the page's: vertices moved and moved back, sharpness set and taken away. */
  private change(mesh: LoadedMesh, spec: R.MeshSpec, key: string): void {
    for (const v of mesh.moved)
      if (!(v in spec.moved)) {
        parse(this.core.moveVertex(mesh.id, v, mesh.initial[3 * v]!, mesh.initial[3 * v + 1]!, mesh.initial[3 * v + 2]!));
        mesh.moved.delete(v);
      }
    for (const [v, p] of Object.entries(spec.moved)) {
      if (!(Number(v) * 3 < mesh.initial.length)) continue;
      parse(this.core.moveVertex(mesh.id, Number(v), ...p));
      mesh.moved.add(Number(v));
    }
    // A link may name what this mesh does not have.
    const has = (element: string) =>
      Number(element.slice(1)) < (element[0] === 'e' ? mesh.edges.length / 2 : mesh.initial.length / 3);
    const wanted = Object.fromEntries(Object.entries(spec.sharp).filter(([element]) => has(element)));
    const sharp = { ...Object.fromEntries(Object.keys(mesh.sharp).map((k) => [k, 0])), ...wanted };
    let changed = false;
    for (const [element, value] of Object.entries(sharp)) {
      if ((mesh.sharp[element] ?? 0) === value) continue;
      parse(this.core.setSharpness(mesh.id, element[0] === 'e' ? 'edge' : 'vertex', Number(element.slice(1)), value));
      changed = true;
    }
    mesh.sharp = wanted;
    if (changed) this.plans.remove((plan) => plan.startsWith(key + '\n'));
  }

  private plan(scheme: R.SchemeSpec, spec: R.MeshSpec, mesh: LoadedMesh, ask: Pick<R.SurfaceAsk, 'levels' | 'limit' | 'shade'>, beside?: Plan): Plan {
    const texture = ask.shade === 'texture';
    const shape = `${this.meshKey(spec)}\n${ask.levels}${ask.limit}${texture}${scheme.text}\n`;
    const key = shape + JSON.stringify(scheme.parameters);
    const known = this.plans.get(key);
    if (known) return known;
    // A slider's next step takes the memory of the one before.
    const before = this.plans.take((other, plan) => other.startsWith(shape) && plan !== beside);
    const options = { levels: ask.levels, limit: ask.limit, normals: true, texture, instead: before?.id ?? 0 };
    const plan = parse<{ id: number } & R.Surface['info']>(this.core.plan(this.id(scheme), mesh.id, JSON.stringify(options)));
    return this.plans.put(key, { id: plan.id, info: plan });
  }

  /** Surfaces with one key have the same triangles: the split, the mesh, the levels and what is sharp decide them. */
  private topologyKey(ask: R.SurfaceAsk, plan: Plan): string {
    const { answer } = this.loaded(ask.scheme);
    const split = answer.ok ? answer.split : '';
    return [this.meshKey(ask.mesh), split, ask.levels, ask.limit, ask.shade === 'texture', plan.info.vertices, plan.info.triangles, plan.info.engine].join('|');
  }
}

export type JobName = Exclude<keyof Session, never>;
export type Job<K extends JobName> = Session[K];

/** Does a job; a refusal of the core is an answer, whatever else is thrown goes on. */
export function perform(session: Session, job: JobName, args: unknown[]): unknown {
  try {
    const result = (session[job] as (...a: unknown[]) => unknown).apply(session, args);
    return { ok: true, result };
  } catch (error) {
    if (error instanceof Refused) return { ok: false, errors: error.errors };
    throw error;
  }
}
