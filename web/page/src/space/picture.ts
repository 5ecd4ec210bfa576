// What is drawn in space, and how it is looked at. No painter knows more.
// By file: the whole library would come into the page's program beside the painter's.
import { PerspectiveCamera } from 'three/src/cameras/PerspectiveCamera.js';
import { Vector3 } from 'three/src/math/Vector3.js';
import type { Lines, Shade, Texture } from '../core/results';

export interface Body {
  positions: Float32Array;
  normals: Float32Array;
  triangles: Uint32Array;
  /** A value a vertex, and what the ends of the scale stand for. */
  values?: Float32Array;
  range?: [number, number];
  texture?: Texture;
  /** What lies on the surface instead of a checker. */
  image?: ImageBitmap;
  shade: Shade;
}
export interface Wires {
  positions: Float32Array;
  segments: Uint32Array;
  kind: 'net' | 'seam' | 'sharp' | 'accent';
}
export interface Dots {
  positions: Float32Array;
  kind: 'net' | 'sharp' | 'accent';
}
export interface Picture {
  body?: Body;
  wires: Wires[];
  dots: Dots[];
  /** The ball that fills the picture. */
  centre: [number, number, number];
  radius: number;
}
export interface Look {
  azimuth: number;
  height: number;
  distance: number;
}
export interface Colours {
  ground: string;
  surface: string;
  back: string;
  net: string;
  ink: string;
  accent: string;
}

export interface Painter {
  readonly name: 'webgl' | 'canvas';
  /** False where it cannot draw yet. */
  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): boolean;
}

export function camera(picture: Picture, look: Look, aspect: number): PerspectiveCamera {
  const made = new PerspectiveCamera(32, aspect, picture.radius * 0.05, picture.radius * 60);
  const a = (look.azimuth * Math.PI) / 180;
  const h = (look.height * Math.PI) / 180;
  const reach = look.distance * picture.radius * 1.25 * Math.max(1, 0.95 / aspect);
  made.position.set(Math.cos(h) * Math.sin(a), Math.sin(h), Math.cos(h) * Math.cos(a)).multiplyScalar(reach);
  made.position.add(new Vector3(...picture.centre));
  made.lookAt(new Vector3(...picture.centre));
  made.updateMatrixWorld();
  return made;
}

/** The points of lines on a surface. */
export function meansOf(positions: Float32Array, { vertices, begin }: Lines): Float32Array {
  const points = new Float32Array(3 * (begin.length - 1));
  for (let p = 0; p + 1 < begin.length; ++p) {
    const [first, last] = [begin[p]!, begin[p + 1]!];
    for (let i = first; i < last; ++i) for (let c = 0; c < 3; ++c) points[3 * p + c]! += positions[3 * vertices[i]! + c]! / (last - first);
  }
  return points;
}

/** Whether a place in a control face is on a dark field of its checker, as the painters draw it. */
export function isDark(pattern: Texture['pattern'], u: number, v: number): boolean {
  // an odd number across a quad, so that it looks alike from all its corners
  const fields = { image: 16, triangles: 4, quads: 5, none: 1 }[pattern];
  const third = pattern === 'triangles' ? Math.floor(fields * (1 - u - v)) : 0;
  return ((Math.floor(fields * u) + Math.floor(fields * v) + third) & 1) === 1;
}

/** The ball round the middle of the points' box. */
export function ball(points: Float32Array): { centre: [number, number, number]; radius: number } {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < points.length; ++i) {
    const x = points[i]!;
    if (x < low[i % 3]!) low[i % 3] = x;
    if (x > high[i % 3]!) high[i % 3] = x;
  }
  const centre = low.map((l, i) => (Number.isFinite(l) ? (l + high[i]!) / 2 : 0)) as [number, number, number];
  let radius = 0;
  for (let i = 0; i + 2 < points.length; i += 3)
    radius = Math.max(radius, Math.hypot(points[i]! - centre[0], points[i + 1]! - centre[1], points[i + 2]! - centre[2]));
  return { centre, radius: radius > 0 && Number.isFinite(radius) ? radius : 1 };
}

/** The middle part of the values: from the 3rd to the 97th of a hundred, symmetric about 0 where `signed`. */
export function middleRange(values: Float32Array, signed: boolean): [number, number] {
  const step = Math.max(1, Math.floor(values.length / 4096));
  const some: number[] = [];
  for (let i = 0; i < values.length; i += step) if (Number.isFinite(values[i]!)) some.push(values[i]!);
  some.sort((a, b) => a - b);
  if (some.length === 0) return [0, 1];
  const low = some[Math.floor(0.03 * (some.length - 1))]!;
  const high = some[Math.ceil(0.97 * (some.length - 1))]!;
  if (!signed) return [0, some[some.length - 1]! || 1];
  const end = Math.max(Math.abs(low), Math.abs(high)) || 1;
  return [-end, end];
}
