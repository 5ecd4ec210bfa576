// What the core's JSON and the worker's jobs answer, as types. Keys are those of the command's --json.
export interface Fault {
  line?: number;
  column?: number;
  message: string;
  hint?: string;
}
export interface Failed {
  ok: false;
  errors: Fault[];
}
export type Answer<T> = (T & { ok: true }) | Failed;

export interface Shipped {
  name: string;
  split: string;
  source: string;
  title: string;
  text: string;
}
export interface ShippedMesh {
  name: string;
  summary: string;
  faces: 'triangles' | 'quads' | 'mixed';
}
export interface Catalogue {
  version: string;
  schemes: Shipped[];
  meshes: ShippedMesh[];
}
export interface Parameter {
  name: string;
  value: string;
  number: number | null;
  default: string;
  min: number | null;
  max: number | null;
  integer: boolean;
  meaning: string;
}
export interface SchemeInfo {
  name: string;
  title: string;
  split: string;
  lattice: 'triangles' | 'quads';
  dual: boolean;
  source: string;
  notes: string;
  parameters: Parameter[];
  valences: { regular: number; least: number; most: number };
  /** What is missing is false. */
  features: Partial<Record<'eigen' | 'refine' | 'boundary' | 'sharpness', boolean>>;
  reasons: Record<string, string>;
}

export interface Eigenvalue {
  value: [number, number];
  modulus: number;
  ring: number | null;
  multiplicity?: number;
  jordan?: number;
}
export interface Eigen {
  valence: number;
  rings: number;
  blocks: { frequency: number; eigenvalues: Eigenvalue[] }[];
  components: Record<'position' | 'tangent' | 'cup' | 'saddle', number | null>;
  verdict: {
    convergent: string;
    c1_necessary: string;
    curvature_necessary?: string;
    regular_part?: { bounded: string; reason: string };
    bounded_curvature: string;
    cup: string | null;
    saddle: string | null;
    reasons: string[];
  };
}
export interface Artifacts {
  frequency: [number, number];
  signal: number;
  artifacts: number[];
  mean_energy: number;
  percent_of_signal: number | null;
  total_energy_percent: number | null;
}
export interface MapInfo {
  size: number;
  extent: [number, number, number, number];
  lattice: string;
  cell: [number, number][];
  largest: number;
}
export interface WaveInfo {
  extent: number[] | number;
  size: number;
  signal: number;
  waves: number;
  largest_error: number;
}
export type Word = 'yes' | 'no' | 'undecided';
export interface Regularity {
  holder: {
    lower: number | null;
    upper: number | null;
    exact: string | null;
    exact_reason: string | null;
    attained: boolean | null;
    attained_reason: string;
    logarithm: number | null;
  };
  c0: Word;
  c1: Word;
  c2: Word;
  smoothness: Word[];
  sum_rules: number;
  reproduction: number;
  stable: { verdict: Word; reason: string };
  proofs: Record<string, { reason: string; power: number | null; norm: number | null }>;
  time_ended: boolean;
}
export interface Direction {
  edges_per_wavelength: number | null;
  direction_degrees?: number;
}
export interface Sampling {
  tolerance_percent: number;
  sampling: Record<'total_energy' | 'mean_energy', Record<'worst' | 'best', Direction>>;
}
export interface MeshCheck {
  vertices: number;
  faces: number;
  refinable: boolean;
  faults?: { kind: string; message: string; count?: number; lines?: number[] }[];
  remedies?: Record<string, string>;
  valences?: Record<string, number>;
  [key: string]: unknown;
}

/** A scheme as the page holds it: a file's text and values of parameters, as expressions. */
export interface SchemeSpec {
  text: string;
  parameters: Record<string, string>;
}
/** A control mesh: a shipped name, or a file that a person dropped; then what was changed by hand. */
export interface MeshSpec {
  name: string;
  file?: { bytes: Uint8Array; repair: string; key: string };
  moved: Record<number, [number, number, number]>;
  sharp: Record<string, number>;
}
export type Shade = 'plain' | 'reflection' | 'normals' | 'gaussian' | 'mean' | 'distance' | 'texture';
/** Two numbers for each corner of the triangles, and what they are coordinates of. */
export interface Texture {
  coordinates: Float32Array;
  pattern: 'image' | 'triangles' | 'quads' | 'none';
  reason: string;
}
export interface SurfaceAsk {
  scheme: SchemeSpec;
  mesh: MeshSpec;
  levels: number;
  limit: boolean;
  shade: Shade;
  other?: SchemeSpec;
  /** The topology that the page holds already; it is then left out of the answer. */
  has?: string;
}
export interface Surface {
  topology: string;
  triangles?: Uint32Array;
  texture?: Texture;
  positions: Float32Array;
  normals: Float32Array;
  values?: Float32Array;
  info: { vertices: number; triangles: number; engine?: string; limit?: boolean; reason?: string; missing?: number };
  about?: Record<string, unknown>;
  /** Milliseconds in the core: the plan, and the evaluation. */
  planned: number;
  evaluated: number;
}
/** The control mesh's edges on the surface of this topology. */
export interface Lines {
  topology: string;
  vertices: Uint32Array;
  begin: Uint32Array;
  segments: Uint32Array;
}
export interface Control {
  positions: Float32Array;
  edges: Uint32Array;
  check: MeshCheck;
}
