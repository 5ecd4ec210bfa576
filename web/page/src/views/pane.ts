// One canvas in space: asks for a scheme's surface over the mesh, draws it, and lets a hand turn it.
import { Vector3 } from 'three/src/math/Vector3.js';
import { deepest, type App, type GoodScheme } from '../app';
import { superseded } from '../core/client';
import { openingTopology } from '../core/opening';
import type { Fault, Lines, Shade, Surface, SurfaceAsk, Texture } from '../core/results';
import { flatSvg, mostTriangles } from '../space/flat_painter';
import { orbit, type Hand } from '../space/orbit';
import { camera, meansOf, middleRange, type Dots, type Look, type Picture, type Wires } from '../space/picture';
import type { State } from '../state';
import { h } from '../ui/dom';

export type Element = { kind: 'v' | 'e'; index: number };

export class Pane {
  readonly canvas = h('canvas', { tabindex: 0, role: 'img', 'aria-label': 'Surface: drag to turn, wheel to zoom, arrow keys too' });
  readonly title = h('div', { class: 'pane-title' });
  readonly element = h('div', { class: 'pane' }, this.canvas, this.title);
  surface?: Surface;
  texture?: Texture;
  range?: [number, number];
  hovered?: Element;
  chosen?: Element;
  faults: Fault[] = [];
  onSurface: () => void = () => {};
  private asked = '';
  private triangles?: Uint32Array;
  private lines?: Lines;
  private linesAsked = '';
  private frame = 0;
  private late = 0;
  private now?: { ask: SurfaceAsk; coarse: number };
  private picture?: Picture;
  private pictureKey = '';

  constructor(private app: App, private lane: 'surface' | 'surface-b', hand?: Hand) {
    orbit(this.canvas, () => this.look(), (look) =>
      app.store.set({ camera: [look.azimuth, look.height, look.distance] }), hand);
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  look(): Look {
    const [azimuth, height, distance] = this.app.store.now.camera;
    return { azimuth, height, distance };
  }

  update(state: State, scheme: GoodScheme | undefined, other: GoodScheme | undefined): void {
    const mesh = this.app.meshSpec(state);
    if (!scheme || !mesh) return;
    const { faces } = this.app.model.mesh!.control.check;
    const flat = this.app.painter?.name === 'canvas';
    const levels = Math.min(state.levels, deepest(scheme.info.split, faces, flat ? mostTriangles / 2 : undefined));
    const shade: Shade = state.shade === 'distance' && !other ? 'plain' : state.shade;
    const ask: SurfaceAsk = { scheme: scheme.spec, mesh, levels, limit: state.limit, shade,
      other: shade === 'distance' ? other?.spec : undefined };
    this.now = { ask, coarse: Math.min(levels, deepest(scheme.info.split, faces, mostTriangles / 2)) };
    const key = JSON.stringify([ask.scheme, ask.other, levels, state.limit, shadeKey(shade), mesh.name, mesh.file?.key, mesh.file?.repair, mesh.moved, mesh.sharp]);
    this.title.textContent = scheme.label;
    if (key !== this.asked) {
      this.asked = key;
      void this.ask({ ...ask, has: this.surface?.topology }, key);
    }
    this.askLines(state);
    this.draw();
  }

  private async ask(ask: SurfaceAsk, key: string): Promise<void> {
    if (!this.surface) this.open(ask);
    this.late ||= window.setTimeout(() => this.element.classList.add('busy'), 350);
    const begun = performance.now();
    const outcome = await this.app.client.ask(this.lane, 'surface', ask);
    if (outcome === superseded) return;
    const answered = performance.now();
    if (this.asked === key) this.rest();
    this.faults = outcome.ok ? [] : outcome.errors;
    if (outcome.ok) {
      const surface = outcome.result;
      this.triangles = surface.triangles ?? this.triangles;
      this.texture = ask.shade === 'texture' ? surface.texture ?? this.texture : undefined;
      this.surface = surface;
      this.range = surface.values && middleRange(surface.values, ask.shade !== 'distance');
      this.draw(true);
      this.app.time({ what: ask.shade === 'plain' ? 'surface' : `surface, ${ask.shade}`, total: answered - begun,
        core: surface.planned + surface.evaluated, drawn: performance.now() - answered, vertices: surface.positions.length / 3 });
      this.askLines(this.app.store.now);
    }
    this.onSurface();
    this.app.begin();
  }

  /** Whether the surface is the one that the page came with. */
  get opening(): boolean {
    return this.surface?.topology === openingTopology;
  }

  /** Until the core answers. */
  private open(ask: SurfaceAsk): void {
    const surface = this.app.opening.surface(ask);
    if (!surface) return;
    this.surface = surface;
    this.triangles = surface.triangles;
    this.draw(true);
  }

  /** The control mesh's edges on the surface, once they are to be seen. */
  private async askLines(state: State): Promise<void> {
    const topology = this.surface?.topology;
    if (state.net || state.shade !== 'plain' || this.opening || !topology || this.linesAsked === topology || !this.now) return;
    this.linesAsked = topology;
    const outcome = await this.app.client.ask(`${this.lane}-lines`, 'lines', this.now.ask);
    if (outcome === superseded || !outcome.ok) return;
    this.lines = outcome.result;
    this.draw();
    this.onSurface();
  }

  /** Of the control mesh's edges on the surface. */
  get segments(): number {
    return this.lines && this.lines.topology === this.surface?.topology ? this.lines.segments.length / 2 : 0;
  }

  /** The picture as SVG, of a coarser level where the surface has too many triangles. */
  async vector(): Promise<string | undefined> {
    const picture = this.compose();
    if (!picture || !this.now) return undefined;
    const { width, height } = this.canvas.getBoundingClientRect();
    const { ask, coarse } = this.now;
    const outcome = await this.app.client.ask('svg', 'surface', { ...ask, levels: coarse });
    const { triangles, texture, ...surface } = outcome !== superseded && outcome.ok ? outcome.result : ({} as Partial<Surface>);
    const body = triangles && picture.body && { ...picture.body, positions: surface.positions!, normals: surface.normals!, triangles, texture,
      values: surface.values };
    // lines on the surface are those of the finer level, which runs through the same places
    return flatSvg({ ...picture, body }, this.look(), width, height, this.app.colours(), this.title.textContent ?? '');
  }

  private rest(): void {
    clearTimeout(this.late);
    this.late = 0;
    this.element.classList.remove('busy');
  }

  draw(at_once = false): void {
    if (at_once) {
      cancelAnimationFrame(this.frame);
      this.frame = 0;
      this.paint();
    } else this.frame ||= requestAnimationFrame(() => ((this.frame = 0), this.paint()));
  }

  private fit(): boolean {
    const box = this.canvas.getBoundingClientRect();
    const scale = Math.min(2, devicePixelRatio || 1);
    const [width, height] = [Math.round(box.width * scale), Math.round(box.height * scale)];
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
    return width > 0 && height > 0;
  }

  private paint(): void {
    if (!this.fit() || !this.app.painter) return;
    const picture = this.compose();
    if (picture && this.app.painter.draw(picture, this.look(), this.canvas, this.app.colours()) && picture.body)
      {
        this.app.firstPicture ||= performance.now();
        if (!this.opening) this.app.firstAnswer ||= performance.now();
      }
  }

  /** Kept while nothing of it changes, so that turning costs no buffers. */
  private compose(): Picture | undefined {
    const state = this.app.store.now;
    const control = this.app.model.mesh?.control;
    if (!control) return undefined;
    const parts = [this.surface, this.lines, this.app.image, control, state.net, state.shade, state.moved, state.sharp, this.hovered, this.chosen, document.documentElement.dataset.theme];
    const key = parts.map(identity).join();
    if (this.picture && key === this.pictureKey) return this.picture;
    this.pictureKey = key;
    const surface = this.surface;
    const shade = surface?.values || (state.shade === 'texture' ? this.texture : !['gaussian', 'mean', 'distance'].includes(state.shade)) ? state.shade : 'plain';
    this.picture = {
      ...this.app.model.mesh!.ball,
      body: surface && this.triangles ? { positions: surface.positions, normals: surface.normals, triangles: this.triangles,
        values: surface.values, range: this.range, texture: this.texture, image: this.app.image, shade } : undefined,
      wires: this.wires(state),
      dots: this.dots(state),
    };
    return this.picture;
  }

  private wires(state: State): Wires[] {
    const { edges } = this.app.model.mesh!.control;
    const positions = this.points();
    const wires: Wires[] = [];
    if (state.net) wires.push({ positions, segments: edges, kind: 'net' });
    if (this.surface && this.lines?.topology === this.surface.topology && !state.net && state.shade === 'plain')
      wires.push({ positions: meansOf(this.surface.positions, this.lines), segments: this.lines.segments, kind: 'seam' });
    const some = (list: number[], kind: Wires['kind']): void => {
      if (list.length) wires.push({ positions, segments: Uint32Array.from(list.flatMap((e) => [edges[2 * e]!, edges[2 * e + 1]!])), kind });
    };
    some(Object.keys(state.sharp).filter((k) => k[0] === 'e').map((k) => Number(k.slice(1))).filter((e) => 2 * e < edges.length), 'sharp');
    for (const one of [this.hovered, this.chosen]) if (one?.kind === 'e') some([one.index], 'accent');
    return wires;
  }

  private dots(state: State): Dots[] {
    const positions = this.points();
    const at = (list: number[], kind: Dots['kind']): Dots[] => list.length ? [{ kind,
      positions: Float32Array.from(list.filter((v) => 3 * v < positions.length).flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)])) }] : [];
    const dots: Dots[] = state.net ? [{ positions, kind: 'net' }] : [];
    dots.push(...at(Object.keys(state.sharp).filter((k) => k[0] === 'v').map((k) => Number(k.slice(1))), 'sharp'));
    for (const one of [this.hovered, this.chosen]) if (one?.kind === 'v') dots.push(...at([one.index], 'accent'));
    return dots;
  }

  /** The control points as they stand, with what was moved. */
  points(): Float32Array {
    const { positions } = this.app.model.mesh!.control;
    const moved = Object.entries(this.app.store.now.moved);
    if (moved.length === 0) return positions;
    const copy = positions.slice();
    for (const [v, p] of moved) if (3 * Number(v) < copy.length) copy.set(p, 3 * Number(v));
    return copy;
  }

  private eye() {
    const { width, height } = this.canvas.getBoundingClientRect();
    const made = camera(this.picture!, this.look(), width / height);
    return { made, width, height };
  }

  /** The control vertex or edge that is nearest to a place on the canvas, within `reach` pixels. */
  pick(x: number, y: number, reach = 11): Element | undefined {
    if (!this.picture) return undefined;
    const { made, width, height } = this.eye();
    const positions = this.points();
    const { edges } = this.app.model.mesh!.control;
    const p = new Float32Array(positions.length);
    const at = new Vector3();
    for (let i = 0; i < positions.length; i += 3) {
      at.set(positions[i]!, positions[i + 1]!, positions[i + 2]!).project(made);
      p.set([(at.x * 0.5 + 0.5) * width, (0.5 - at.y * 0.5) * height, at.z], i);
    }
    let best = undefined as { score: number; element: Element } | undefined;
    const offer = (distance: number, depth: number, element: Element): void => {
      const score = distance + depth * 40;
      if (distance <= reach && (!best || score < best.score)) best = { score, element };
    };
    for (let v = 0; 3 * v < p.length; ++v) offer(Math.hypot(p[3 * v]! - x, p[3 * v + 1]! - y), p[3 * v + 2]!, { kind: 'v', index: v });
    const vertex = best as { element: Element } | undefined;
    if (vertex) return vertex.element;
    for (let e = 0; 2 * e < edges.length; ++e) {
      const [a, b] = [3 * edges[2 * e]!, 3 * edges[2 * e + 1]!];
      const [dx, dy] = [p[b]! - p[a]!, p[b + 1]! - p[a + 1]!];
      const t = Math.max(0, Math.min(1, ((x - p[a]!) * dx + (y - p[a + 1]!) * dy) / (dx * dx + dy * dy || 1)));
      offer(Math.hypot(p[a]! + t * dx - x, p[a + 1]! + t * dy - y) + 2, p[a + 2]! + t * (p[b + 2]! - p[a + 2]!), { kind: 'e', index: e });
    }
    return best?.element;
  }

  /** Where control vertex v stands on the canvas. */
  place(v: number): [number, number] {
    const { made, width, height } = this.eye();
    const points = this.points();
    const at = new Vector3(points[3 * v], points[3 * v + 1], points[3 * v + 2]).project(made);
    return [(at.x * 0.5 + 0.5) * width, (0.5 - at.y * 0.5) * height];
  }

  /** Where vertex v comes to when it follows the pointer, in the plane that faces the eye. */
  follow(v: number, x: number, y: number): [number, number, number] {
    const { made, width, height } = this.eye();
    const points = this.points();
    const depth = new Vector3(points[3 * v], points[3 * v + 1], points[3 * v + 2]).project(made).z;
    const to = new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, depth).unproject(made);
    return [to.x, to.y, to.z];
  }
}

/** Modes that are drawn from the same data need no new answer. */
const shadeKey = (shade: Shade): string => (['plain', 'reflection', 'normals'].includes(shade) ? '' : shade);

let count = 0;
const identities = new WeakMap<object, number>();
function identity(value: unknown): string {
  if (typeof value !== 'object' || value === null) return String(value);
  if (!identities.has(value)) identities.set(value, ++count);
  return `#${identities.get(value)}`;
}
