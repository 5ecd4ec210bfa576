// Surfaces as SVG: nearest last, as many polygons as triangles, coordinates on the page.
import { describe, expect, it } from 'vitest';
import { flatSvg } from '../../src/space/flat_painter';
import { isDark, meansOf, type Picture } from '../../src/space/picture';

const colours = { ground: '#ffffff', surface: '#c0c0c0', back: '#606060', net: '#112233', ink: '#000000', accent: '#ff0000' };
const look = { azimuth: 0, height: 0, distance: 3 };
/** Two triangles that face the eye, which looks along -z: the second is farther away. */
const picture: Picture = {
  body: {
    positions: Float32Array.from([-0.6, -0.6, 0.5, 0.6, -0.6, 0.5, 0, 0.6, 0.5, -0.6, -0.6, -0.5, 0.6, -0.6, -0.5, 0, 0.6, -0.5]),
    normals: Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
    triangles: Uint32Array.from([0, 1, 2, 3, 4, 5]), shade: 'mean', values: Float32Array.from([-1, -1, -1, 1, 1, 1]), range: [-1, 1],
  },
  wires: [{ positions: Float32Array.from([-1, 0, 0, 1, 0, 0]), segments: Uint32Array.from([0, 1]), kind: 'net' }],
  dots: [{ positions: Float32Array.from([0, 0, 0]), kind: 'net' }], centre: [0, 0, 0], radius: 1,
};

describe('a surface as SVG', () => {
  const text = flatSvg(picture, look, 400, 300, colours, 'a < b & c');
  it('draws from the farthest to the nearest, lines among the triangles', () => {
    const shapes = [...text.matchAll(/<path d="([^"]+)" fill="([^"]+)"/g)].map((match) => match[2]!);
    expect(shapes).toHaveLength(2 + 10);
    const red = (hex: string): boolean => parseInt(hex.slice(1, 3), 16) > parseInt(hex.slice(5, 7), 16);
    expect(red(shapes[0]!)).toBe(true); // the value 1 is farther away
    expect(red(shapes.at(-1)!)).toBe(false);
    expect(shapes.slice(1, -1)).toEqual(Array.from({ length: 10 }, () => 'none'));
  });
  it('stays on the page, and its title is text', () => {
    const numbers = [...text.matchAll(/[ML](-?[\d.]+) (-?[\d.]+)/g)].flatMap((match) => [Number(match[1]) / 400, Number(match[2]) / 300]);
    expect(numbers.length).toBeGreaterThan(20);
    expect(numbers.every((x) => x > 0 && x < 1)).toBe(true);
    expect(text).toContain('<title>a &#60; b &#38; c</title>');
  });
  it('leaves out what has no place', () => {
    const holes = structuredClone(picture);
    holes.body!.positions[0] = NaN;
    expect(flatSvg(holes, look, 400, 300, colours, '').match(/fill="#/g)).toHaveLength(1 + 1);
  });
});

describe('lines on a surface', () => {
  it('run through means of vertices', () => {
    const positions = Float32Array.from([0, 0, 0, 2, 0, 0, 2, 4, 6]);
    const lines = { topology: '', vertices: Uint32Array.from([0, 1, 2]), begin: Uint32Array.from([0, 1, 3]), segments: Uint32Array.from([0, 1]) };
    expect([...meansOf(positions, lines)]).toEqual([0, 0, 0, 2, 2, 3]);
  });
});

describe('the checker', () => {
  it('of a triangle is the same from each of its corners, so that it has no seams', () => {
    for (const [u, v] of [[0.1, 0.2], [0.05, 0.9], [0.3, 0.33], [0.61, 0.02]] as const) {
      const w = 1 - u - v;
      for (const [a, b] of [[v, u], [u, w], [w, u], [v, w], [w, v]] as const) expect(isDark('triangles', a, b)).toBe(isDark('triangles', u, v));
    }
  });
  it('of a quad too', () => {
    for (const [u, v] of [[0.1, 0.3], [0.65, 0.9]] as const)
      for (const [a, b] of [[v, u], [1 - u, v], [u, 1 - v], [1 - v, u], [1 - v, 1 - u]] as const) expect(isDark('quads', a, b)).toBe(isDark('quads', u, v));
  });
});
