// What the page comes with: packed and unpacked it is the core's answers, and it is given for nothing else.
import { describe, expect, it } from 'vitest';
import { Opening, packOpening } from '../../src/core/opening';
import type { Catalogue, SurfaceAsk } from '../../src/core/results';
import type { Session } from '../../src/core/session';

const control = { positions: Float32Array.from([0.1, -2, 3, 4, 5, -6.5]), edges: Uint32Array.from([0, 1]), check: { vertices: 2, faces: 1, refinable: true } };
const scheme = { name: 'loop', split: 'triangle-dyadic', notes: 'odd: “ü”' };
const surface = { positions: Float32Array.from([1, -2.5, 0.001, 0, 7, 2]), normals: Float32Array.from([0, 0.6, -0.8, 1, 0, 0]),
  triangles: Uint32Array.from([0, 700, 2, 65, 0, 1]), info: { vertices: 2, triangles: 2 } };
const asked: SurfaceAsk[] = [];
const session = { load: () => scheme, control: () => control, surface: (ask: SurfaceAsk) => (asked.push(ask), surface) } as unknown as Session;
const catalogue = { version: '1', schemes: [{ name: 'loop', text: 'LOOP' }],
  meshes: [{ name: 'q', summary: '', faces: 'quads' }, { name: 't', summary: '', faces: 'triangles' }] } as unknown as Catalogue;
const opening = new Opening(packOpening(session, catalogue).slice().buffer as ArrayBuffer);
const spec = { text: 'LOOP', parameters: {} };
const mesh = { name: 't', moved: {}, sharp: {} };
const ask: SurfaceAsk = { scheme: spec, mesh, levels: 4, limit: true, shade: 'plain' };

describe('the opening', () => {
  it('has the scheme and the control mesh as they are', () => {
    expect(opening.load(spec)).toMatchObject({ ok: true, result: scheme });
    expect(opening.control(mesh)).toMatchObject({ ok: true, result: control });
  });
  it('has the surface, to a part in 32767 of its size', () => {
    const made = opening.surface(ask)!;
    expect(asked[0]).toMatchObject({ levels: 2, limit: true, scheme: spec });
    expect([...made.triangles!]).toEqual([...surface.triangles]);
    made.positions.forEach((value, i) => expect(Math.abs(value - surface.positions[i]!)).toBeLessThanOrEqual(7 / 65534 + 1e-9));
    made.normals.forEach((value, i) => expect(Math.abs(value - surface.normals[i]!)).toBeLessThanOrEqual(0.5 / 127 + 1e-9));
  });
  it('answers nothing else', () => {
    expect(opening.load({ ...spec, parameters: { a: '1' } })).toBeUndefined();
    expect(opening.load({ ...spec, text: 'LOOP ' })).toBeUndefined();
    expect(opening.control({ ...mesh, name: 'q' })).toBeUndefined();
    const others: Partial<SurfaceAsk>[] = [{ scheme: { ...spec, text: '' } }, { mesh: { ...mesh, name: 'q' } }, { mesh: { ...mesh, moved: { 0: [1, 2, 3] } } },
      { mesh: { ...mesh, sharp: { e0: 1 } } }, { limit: false }, { shade: 'gaussian' }];
    for (const other of others) expect(opening.surface({ ...ask, ...other })).toBeUndefined();
  });
});
