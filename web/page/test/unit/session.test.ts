// The session over a core that counts: what is asked of the core, and when it is asked anew.
import { describe, expect, it } from 'vitest';
import type { Core } from '../../src/core/api';
import type { MeshSpec, SurfaceAsk } from '../../src/core/results';
import { perform, Session } from '../../src/core/session';

function counting() {
  const calls: string[] = [];
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
    plan: () => (calls.push('plan'), JSON.stringify({ ok: true, id: ++id, vertices: 2, triangles: 0 })),
    unplan: () => calls.push('unplan'),
    topology: () => (calls.push('topology'), { json: '{"ok":true}', triangles: new Uint32Array(3), lines: new Uint32Array(2) }),
    evaluate: () => (calls.push('evaluate'), { json: '{"ok":true}', positions: new Float32Array(6), normals: new Float32Array(6) }),
  } as unknown as Core;
  return { session: new Session(core), calls };
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
