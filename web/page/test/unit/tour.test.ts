import { readdirSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { fromFragment, initial, toFragment } from '../../src/state';
import { cube, plane, star, torus } from '../../src/tour/meshes';
import { stateOf, steps } from '../../src/tour/steps';

/** How often each edge is met, and V − E + F. */
function count(obj: string): { once: number; more: number; euler: number } {
  const edges = new Map<string, number>();
  const lines = obj.trim().split('\n');
  const faces = lines.filter((l) => l.startsWith('f ')).map((l) => l.slice(2).split(' ').map(Number));
  for (const face of faces)
    face.forEach((a, i) => {
      const b = face[(i + 1) % face.length]!;
      const key = [Math.min(a, b), Math.max(a, b)].join();
      edges.set(key, (edges.get(key) ?? 0) + 1);
    });
  const points = lines.filter((l) => l.startsWith('v ')).length;
  return { once: [...edges.values()].filter((n) => n === 1).length, more: [...edges.values()].filter((n) => n > 2).length, euler: points - edges.size + faces.length };
}

describe('the tour', () => {
  it('names shipped schemes alone, and its links restore it', () => {
    const shipped = readdirSync(resolve(__dirname, '../../../../schemes')).map((f) => f.replace(/\.toml$/, ''));
    steps.forEach((_step, i) => {
      const state = stateOf(i, initial);
      expect(shipped).toContain(state.scheme);
      if (state.other) expect(shipped).toContain(state.other);
      expect(fromFragment(toFragment(state))).toEqual(state);
    });
  });
  it('has control meshes that are surfaces', () => {
    expect(count(cube())).toEqual({ once: 0, more: 0, euler: 2 });
    expect(count(torus())).toEqual({ once: 0, more: 0, euler: 0 });
    for (const n of [3, 6, 7]) expect(count(plane(n))).toEqual({ once: 3 * n, more: 0, euler: 1 });
    expect(count(star(5, 1, () => 0)).euler).toBe(1);
  });
});
