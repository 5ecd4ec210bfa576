// All that a link restores: one object, and its text in the URL's fragment. Reading is lenient: what is wrong in a
// fragment falls back to the default, since a mistyped link must still show a page.
import { deflateSync, inflateSync, strFromU8, strToU8 } from 'fflate';
import type { Shade } from './core/results';

export const focuses = ['surface', 'vertex', 'artifacts', 'smoothness', 'sweep', 'scheme'] as const;
export type Focus = (typeof focuses)[number];
export const shades: readonly Shade[] = ['plain', 'reflection', 'gaussian', 'mean', 'normals', 'distance', 'texture'];
export const themes = ['auto', 'light', 'dark'] as const;

export interface State {
  scheme: string;
  /** A scheme file typed here; null for the shipped one of that name. */
  text: string | null;
  parameters: Record<string, string>;
  /** A second scheme, shipped; "" for none. */
  other: string;
  otherParameters: Record<string, string>;
  /** A shipped mesh, "" for the first that suits the scheme, or the name of one that was dropped. */
  mesh: string;
  /** The text of a dropped OBJ file, where it is small enough for a link. */
  obj: string | null;
  repair: string;
  levels: number;
  limit: boolean;
  shade: Shade;
  net: boolean;
  moved: Record<number, [number, number, number]>;
  sharp: Record<string, number>;
  valence: number;
  frequency: [number, number];
  /** Azimuth and height in degrees, and the distance in radii of the mesh. */
  camera: [number, number, number];
  focus: Focus;
  sweep: string;
  theme: (typeof themes)[number];
  projector: boolean;
  tour: number;
}

export const initial: State = {
  scheme: 'loop', text: null, parameters: {}, other: '', otherParameters: {}, mesh: '', obj: null, repair: '',
  levels: 4, limit: true, shade: 'plain', net: true, moved: {}, sharp: {}, valence: 7, frequency: [0.2, 0.1],
  camera: [35, 22, 2.9], focus: 'surface', sweep: '', theme: 'auto', projector: false, tour: -1,
};

const base64 = (bytes: Uint8Array): string =>
  btoa(Array.from(bytes, (b) => String.fromCharCode(b)).join('')).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
const fromBase64 = (text: string): Uint8Array =>
  Uint8Array.from(atob(text.replace(/-/g, '+').replace(/_/g, '/')), (c) => c.charCodeAt(0));

const longest = 200_000;

export function packText(text: string): string {
  return base64(deflateSync(strToU8(text), { level: 9 }));
}
export function unpackText(packed: string): string | null {
  try {
    const text = strFromU8(inflateSync(fromBase64(packed), { out: new Uint8Array(longest + 1) }));
    return text.length <= longest ? text : null;
  } catch {
    return null;
  }
}

const short = (x: number): string => String(Number(x.toPrecision(7)));

function pairs(values: Record<string, string>): string {
  return Object.entries(values).map(([k, v]) => `${k}=${v}`).join(',');
}
function readPairs(text: string): Record<string, string> {
  const values: Record<string, string> = {};
  for (const part of text.split(',')) {
    const match = /^([A-Za-z_]\w{0,40})=(.{1,200})$/.exec(part);
    if (match && match[1] !== '__proto__') values[match[1]!] = match[2]!;
  }
  return values;
}

function numbers(text: string, count: number, largest: number): number[] | null {
  const list = text.split(',').map(Number);
  return list.length === count && list.every((x) => Number.isFinite(x) && Math.abs(x) <= largest) ? list : null;
}

const edits = {
  write: (moved: State['moved'], sharp: State['sharp']): string =>
    [...Object.entries(moved).map(([v, p]) => `m${v}=${p.map(short).join(',')}`),
     ...Object.entries(sharp).map(([e, s]) => `${e}=${short(s)}`)].join(';'),
  read(text: string): Pick<State, 'moved' | 'sharp'> {
    const moved: State['moved'] = {};
    const sharp: State['sharp'] = {};
    for (const part of text.split(';').slice(0, 2000)) {
      const match = /^([mev])(\d{1,7})=(.+)$/.exec(part);
      if (!match) continue;
      const values = numbers(match[3]!, match[1] === 'm' ? 3 : 1, 1e6);
      if (!values) continue;
      if (match[1] === 'm') moved[Number(match[2])] = values as [number, number, number];
      else if (values[0]! > 0) sharp[match[1]! + match[2]!] = Math.min(values[0]!, 10);
    }
    return { moved, sharp };
  },
};

/** The fragment without "#": only what differs from the default. */
export function toFragment(state: State): string {
  const out = new URLSearchParams();
  const put = (key: string, value: string, plain: string): void => {
    if (value !== plain) out.set(key, value);
  };
  out.set('scheme', state.scheme);
  if (state.text !== null) out.set('text', packText(state.text));
  put('p', pairs(state.parameters), '');
  put('other', state.other, initial.other);
  put('q', pairs(state.otherParameters), '');
  put('mesh', state.mesh, initial.mesh);
  if (state.obj !== null) out.set('obj', packText(state.obj));
  put('repair', state.repair, initial.repair);
  put('levels', String(state.levels), String(initial.levels));
  put('limit', state.limit ? '1' : '0', '1');
  put('shade', state.shade, initial.shade);
  put('net', state.net ? '1' : '0', '1');
  put('edits', edits.write(state.moved, state.sharp), '');
  put('valence', String(state.valence), String(initial.valence));
  put('f', state.frequency.map(short).join(','), initial.frequency.join(','));
  put('camera', state.camera.map((x) => x.toFixed(2)).join(','), initial.camera.map((x) => x.toFixed(2)).join(','));
  put('focus', state.focus, initial.focus);
  put('sweep', state.sweep, initial.sweep);
  put('theme', state.theme, initial.theme);
  put('projector', state.projector ? '1' : '0', '0');
  put('tour', String(state.tour), String(initial.tour));
  return out.toString().replace(/%2C/g, ',').replace(/%3D/g, '=').replace(/%3B/g, ';').replace(/%2F/g, '/');
}

function whole(text: string | null, low: number, high: number, plain: number): number {
  const value = text === null || text === '' ? NaN : Number(text);
  return Number.isInteger(value) && value >= low && value <= high ? value : plain;
}
function among<T extends string>(text: string | null, list: readonly T[], plain: T): T {
  return list.includes(text as T) ? (text as T) : plain;
}
const name = (text: string | null, plain: string): string => (text !== null && text.length <= 200 ? text : plain);

export function fromFragment(fragment: string): State {
  const at = new URLSearchParams(fragment.replace(/^#/, ''));
  const text = at.get('text');
  const obj = at.get('obj');
  const f = numbers(at.get('f') ?? '', 2, 4);
  const camera = numbers(at.get('camera') ?? '', 3, 3600);
  return {
    scheme: name(at.get('scheme'), initial.scheme) || initial.scheme,
    text: text === null ? null : unpackText(text),
    parameters: readPairs(at.get('p') ?? ''),
    other: name(at.get('other'), ''),
    otherParameters: readPairs(at.get('q') ?? ''),
    mesh: name(at.get('mesh'), ''),
    obj: obj === null ? null : unpackText(obj),
    repair: among(at.get('repair'), ['', 'weld', 'repair'], ''),
    levels: whole(at.get('levels'), 0, 7, initial.levels),
    limit: at.get('limit') !== '0',
    shade: among(at.get('shade'), shades, initial.shade),
    net: at.get('net') !== '0',
    ...edits.read(at.get('edits') ?? ''),
    valence: whole(at.get('valence'), 2, 64, initial.valence),
    frequency: f ? [f[0]!, f[1]!] : initial.frequency,
    camera: camera ? [camera[0]!, Math.max(-89, Math.min(89, camera[1]!)), Math.max(0.4, Math.min(30, camera[2]!))] : initial.camera,
    focus: among(at.get('focus'), focuses, initial.focus),
    sweep: name(at.get('sweep'), ''),
    theme: among(at.get('theme'), themes, 'auto'),
    projector: at.get('projector') === '1',
    tour: whole(at.get('tour'), -1, 99, -1),
  };
}

/** Words of a shell, quoted where they must be. */
const word = (text: string): string => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replace(/'/g, "'\\''")}'`);

/** The command that shows the state natively; `file` stands for an edited scheme. */
export function command(state: State, mesh: string, file = 'mine.toml'): string {
  const scheme = state.text === null ? state.scheme : `./${file}`;
  const settings = Object.entries(state.parameters).flatMap(([k, v]) => ['-p', word(`${k}=${v}`)]);
  const full = (one: string, p: Record<string, string>): string => word(one + (Object.keys(p).length ? `:${pairs(p)}` : ''));
  const say = (...words: string[]): string => ['limn', ...words].join(' ');
  switch (state.focus) {
    case 'vertex':
    case 'sweep':
      return say('eigen', word(scheme), ...settings, '--valence', String(state.valence));
    case 'artifacts':
      return say('artifacts', word(scheme), ...settings, '--frequency', state.frequency.map(short).join(','));
    case 'smoothness':
      return say('regularity', word(scheme), ...settings);
    case 'scheme':
      return say('show', word(scheme), ...settings);
    default:
      if (state.other) return say('compare', full(scheme, state.parameters), full(state.other, state.otherParameters), '--mesh', word(mesh), '-o', 'both.png');
      return say('refine', word(mesh), '-s', word(scheme), ...settings, '-n', String(state.levels),
        ...(state.limit ? ['--limit', '--normals'] : []), '-o', 'surface.ply');
  }
}

export class Store {
  private listeners: ((state: State, before: State) => void)[] = [];
  constructor(private state: State) {}
  get now(): State {
    return this.state;
  }
  set(patch: Partial<State>): void {
    const before = this.state;
    this.state = { ...before, ...patch };
    for (const listener of this.listeners) listener(this.state, before);
  }
  listen(listener: (state: State, before: State) => void): void {
    this.listeners.push(listener);
  }
}
