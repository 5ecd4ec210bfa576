// What the page shows until its core is there: the answers that the core gave, when the page was built, to what a page
// without a link asks first; the surface coarser, so that they take little room.
import { initial } from '../state';
import type { Outcome } from './client';
import type { Catalogue, Control, MeshSpec, SchemeInfo, SchemeSpec, Surface, SurfaceAsk } from './results';
import type { Session } from './session';
import { firstThatSuits } from './suits';

const levels = 2;
/** Of the surface here; the core gives no such name. */
export const openingTopology = 'opening';

interface Header {
  text: string;
  scheme: SchemeInfo;
  mesh: string;
  check: Control['check'];
  info: Surface['info'];
  /** Elements of the arrays that follow. */
  counts: { control: number; edges: number; points: number; corners: number };
  /** What the largest whole number of a coordinate stands for. */
  size: number;
}

/** Numbers of this many bits each, as multiples of largest / (the largest of so many bits). */
const whole = (values: Float32Array, largest: number, most: number): number[] =>
  Array.from(values, (value) => Math.round((value / largest) * most));
const [most16, most8] = [32767, 127];

/** Asked of the core when the page is built. */
export function packOpening(session: Session, catalogue: Catalogue): Uint8Array {
  const text = catalogue.schemes.find((scheme) => scheme.name === initial.scheme)!.text;
  const spec = { text, parameters: {} };
  const scheme = session.load(spec);
  const mesh = firstThatSuits(scheme.split, catalogue.meshes)!.name;
  const control = session.control({ name: mesh, moved: {}, sharp: {} });
  const surface = session.surface({ scheme: spec, mesh: { name: mesh, moved: {}, sharp: {} }, levels, limit: initial.limit, shade: initial.shade });
  const size = surface.positions.reduce((most, value) => Math.max(most, Math.abs(value)), 0);
  const triangles = surface.triangles!;
  const header: Header = { text, scheme, mesh, check: control.check, info: surface.info, size,
    counts: { control: control.positions.length, edges: control.edges.length, points: surface.positions.length, corners: triangles.length } };
  const json = new TextEncoder().encode(JSON.stringify(header));
  const parts = [Uint32Array.of(json.length), json, new Uint8Array(-json.length & 3), control.positions, Uint16Array.from(control.edges),
    Int16Array.from(whole(surface.positions, size, most16)), Int16Array.from(triangles, (v, i) => v - (triangles[i - 1] ?? 0)),
    Int8Array.from(whole(surface.normals, 1, most8))];
  const bytes = new Uint8Array(parts.reduce((sum, part) => sum + part.byteLength, 0));
  let at = 0;
  for (const part of parts) {
    bytes.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), at);
    at += part.byteLength;
  }
  return bytes;
}

export class Opening {
  private header: Header;
  private positions: Float32Array;
  private edges: Uint32Array;
  private made: Surface;

  constructor(bytes: ArrayBuffer) {
    const length = new DataView(bytes).getUint32(0, true);
    this.header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length))) as Header;
    const { counts, size, info } = this.header;
    let at = 4 + length + (-length & 3);
    const next = <T extends { byteLength: number }>(made: new (buffer: ArrayBuffer, from: number, count: number) => T, count: number): T => {
      const part = new made(bytes, at, count);
      at += part.byteLength;
      return part;
    };
    this.positions = next(Float32Array, counts.control);
    this.edges = Uint32Array.from(next(Uint16Array, counts.edges));
    const positions = Float32Array.from(next(Int16Array, counts.points), (value) => (value * size) / most16);
    let corner = 0;
    const triangles = Uint32Array.from(next(Int16Array, counts.corners), (step) => (corner += step));
    const normals = Float32Array.from(next(Int8Array, counts.points), (value) => value / most8);
    this.made = { topology: openingTopology, positions, normals, triangles, info, planned: 0, evaluated: 0 };
  }

  /** The core's answer, where it is here. */
  load(spec: SchemeSpec): Outcome<SchemeInfo> | undefined {
    return this.is(spec) ? { ok: true, result: this.header.scheme, milliseconds: 0 } : undefined;
  }

  /** The core's answer, where it is here. */
  control(spec: MeshSpec): Outcome<Control> | undefined {
    if (spec.name !== this.header.mesh || spec.file) return undefined;
    return { ok: true, result: { positions: this.positions.slice(), edges: this.edges.slice(), check: this.header.check }, milliseconds: 0 };
  }

  /** The same surface, coarser; where it is here. */
  surface({ scheme, mesh, limit, shade }: SurfaceAsk): Surface | undefined {
    const untouched = mesh.name === this.header.mesh && !mesh.file && Object.keys(mesh.moved).length + Object.keys(mesh.sharp).length === 0;
    const enough = limit === initial.limit && (shade === 'plain' || shade === 'reflection' || shade === 'normals');
    return this.is(scheme) && untouched && enough ? this.made : undefined;
  }

  private is({ text, parameters }: SchemeSpec): boolean {
    return text === this.header.text && Object.keys(parameters).length === 0;
  }
}
