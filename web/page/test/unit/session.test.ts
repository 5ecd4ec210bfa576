// The session over a core that counts: what is asked of the core, and when it is asked anew.
import { describe, expect, it } from 'vitest';
import type { Core } from '../../src/core/api';
import type { MeshSpec, SurfaceAsk } from '../../src/core/results';
import { perform, Session } from '../../src/core/session';

type Options = { levels: number; texture: boolean; instead: number };
function counting() {
  const calls: string[] = [];
  const asked: Options[] = [];
  let id = 0;
  const core = {
    version: () => '{"ok":true,"version":"1"}',
    load(text: string, parameters: string) {
      calls.push('load');
      return text === 'bad' ? '{"ok":false,"errors":[{"line":3,"column":2,"message":"wrong","hint":"right"}]}'
        : JSON.stringify({ ok: true, id: ++id, split: 's', parameters });
    },
    unload: () => calls.push('unload'),
    eigen: (_id: number, n: number) => (n > 12 ? '{"ok":false,"errors":[{"message":"too large"}]}' : JSON.stringify({ ok: true, valence: n })),
    mesh: (name: string) => (calls.push(`mesh ${name}`), JSON.stringify({ ok: true, id: ++id, check: { faces: 1 } })),
    control: () => ({ json: '{"ok":true}', positions: Float32Array.from([0, 0, 0, 1, 1, 1]), edges: Uint32Array.from([0, 1]) }),
    unloadMesh: () => calls.push('unloadMesh'),
    moveVertex: (_m: number, v: number, x: number) => (calls.push(`move ${v} ${x}`), '{"ok":true}'),
    setSharpness: (_m: number, kind: string, i: number, s: number) => (calls.push(`sharp ${kind} ${i} ${s}`), '{"ok":true}'),
    plan: (_s: number, _m: number, options: string) => (calls.push('plan'), asked.push(JSON.parse(options) as Options), JSON.stringify({ ok: true, id: ++id, vertices: 2, triangles: 0 })),
    lines: () => (calls.push('lines'), { json: '{"ok":true}', vertices: new Uint32Array(2), begin: Uint32Array.from([0, 1, 2]), segments: Uint32Array.from([0, 1]) }),
    texture: () => (calls.push('texture'), { json: '{"ok":true,"pattern":"quads","reason":""}', coordinates: new Float32Array(6) }),
    distance: () => (calls.push('distance'), { json: '{"ok":true}', values: new Float32Array(2) }),
    unplan: () => calls.push('unplan'),
    topology: () => (calls.push('topology'), { json: '{"ok":true}', triangles: new Uint32Array(3) }),
    evaluate: () => (calls.push('evaluate'), { json: '{"ok":true}', positions: new Float32Array(6), normals: new Float32Array(6) }),
  } as unknown as Core;
  return { session: new Session(core), calls, asked };
}
const mesh: MeshSpec = { name: 'm', moved: {}, sharp: {} };
const ask: SurfaceAsk = { scheme: { text: 't', parameters: {} }, mesh, levels: 2, limit: true, shade: 'plain' };

describe('a session', () => {
  it('plans once, and a moved vertex costs an evaluation', () => {
    const { session, calls } = counting();
    const first = session.surface(ask);
    expect(first.triangles).toBeDefined();
    calls.length = 0;
    const second = session.surface({ ...ask, has: first.topology, mesh: { ...mesh, moved: { 1: [5, 0, 0] } } });
    expect(second.triangles).toBeUndefined();
    expect(calls).toEqual(['move 1 5', 'evaluate']);
    calls.length = 0;
    session.surface({ ...ask, has: first.topology });
    expect(calls).toEqual(['move 1 1', 'evaluate']);
  });
  it('plans anew for other parameters and other sharpness', () => {
    const { session, calls } = counting();
    session.surface(ask);
    calls.length = 0;
    session.surface({ ...ask, scheme: { text: 't', parameters: { a: '1' } } });
    expect(calls.filter((c) => c === 'plan' || c === 'load')).toEqual(['load', 'plan']);
    calls.length = 0;
    session.surface({ ...ask, mesh: { ...mesh, sharp: { e0: 3 } } });
    expect(calls).toContain('sharp edge 0 3');
    expect(calls).toContain('plan');
    calls.length = 0;
    session.surface(ask);
    expect(calls).toContain('sharp edge 0 0');
    expect(calls).toContain('plan');
  });
  it('gives back what it no longer needs', () => {
    const { session, calls } = counting();
    for (let i = 0; i < 30; ++i) session.surface({ ...ask, scheme: { text: `t${i}`, parameters: {} } });
    expect(calls.filter((c) => c === 'unplan').length).toBe(30 - 6);
    expect(calls.filter((c) => c === 'unload').length).toBe(30 - 8);
  });
  it('lets the next step of a slider take the memory of the one before, and of no other', () => {
    const { session, asked } = counting();
    const step = (a: string, more: Partial<SurfaceAsk> = {}) => session.surface({ ...ask, scheme: { text: 't', parameters: { a } }, ...more });
    for (const a of ['1', '2', '3']) step(a);
    expect(asked[0]!.instead).toBe(0);
    expect(asked[1]!.instead).toBeGreaterThan(0);
    expect(asked[2]!.instead).toBeGreaterThan(asked[1]!.instead);
    step('3', { levels: 3 });
    session.surface({ ...ask, scheme: { text: 'u', parameters: { a: '3' } } });
    expect(asked.slice(3).map((one) => one.instead)).toEqual([0, 0]);
    // beside one another both are needed
    step('4', { shade: 'distance', other: { text: 't', parameters: { a: '5' } } });
    expect(asked.at(-2)!.instead).toBeGreaterThan(0);
    expect(asked.at(-1)!.instead).toBe(0);
  });
  it('gives texture and lines where they are asked for', () => {
    const { session, calls, asked } = counting();
    const plain = session.surface(ask);
    expect([plain.texture, asked.at(-1)!.texture]).toEqual([undefined, false]);
    const textured = session.surface({ ...ask, shade: 'texture', has: plain.topology });
    expect(textured.topology).not.toBe(plain.topology);
    expect(textured.texture).toMatchObject({ pattern: 'quads' });
    expect(asked.at(-1)!.texture).toBe(true);
    expect(session.surface({ ...ask, shade: 'texture', has: textured.topology }).texture).toBeUndefined();
    expect(session.lines(ask).topology).toBe(plain.topology);
    expect(calls.filter((c) => c === 'plan')).toHaveLength(2);
  });
  it('passes on refusals, and stands after them', () => {
    const { session } = counting();
    expect(perform(session, 'load', [{ text: 'bad', parameters: {} }])).toEqual({ ok: false, errors: [{ line: 3, column: 2, message: 'wrong', hint: 'right' }] });
    expect(perform(session, 'eigen', [ask.scheme, 99])).toMatchObject({ ok: false });
    expect(perform(session, 'eigen', [ask.scheme, 5])).toMatchObject({ ok: true, result: { valence: 5 } });
    expect(session.spectra(ask.scheme, 11, 13).map((e) => e?.valence ?? null)).toEqual([11, 12, null]);
  });
  it('ignores edits of elements that the mesh does not have', () => {
    const { session, calls } = counting();
    session.surface({ ...ask, mesh: { ...mesh, moved: { 99: [1, 2, 3] } } });
    expect(calls.some((c) => c.startsWith('move'))).toBe(false);
  });
});
