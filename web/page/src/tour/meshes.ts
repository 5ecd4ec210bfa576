// The control meshes that the papers' figures have, as OBJ texts.
const short = (x: number): string => String(Math.round(x * 1e5) / 1e5);

function text(points: number[][], faces: number[][]): string {
  return [...points.map((p) => `v ${p.map(short).join(' ')}`), ...faces.map((f) => `f ${f.map((i) => i + 1).join(' ')}`)].join('\n') + '\n';
}

/** Triangles round a vertex of valence n, `rings` deep; y is the height over x and z. */
export function star(n: number, rings: number, height: (x: number, z: number, ring: number) => number): string {
  const points: number[][] = [[0, height(0, 0, 0), 0]];
  const faces: number[][] = [];
  const index = (ring: number, i: number): number => (ring === 0 ? 0 : 1 + (n * ring * (ring - 1)) / 2 + (i % (n * ring)));
  for (let ring = 1; ring <= rings; ++ring)
    for (let sector = 0; sector < n; ++sector)
      for (let b = 0; b < ring; ++b) {
        const [s, t] = [(2 * Math.PI * sector) / n, (2 * Math.PI * (sector + 1)) / n];
        const x = (ring - b) * Math.cos(s) + b * Math.cos(t);
        const z = -((ring - b) * Math.sin(s) + b * Math.sin(t));
        points.push([x, height(x, z, ring), z]);
        const outer = sector * ring + b;
        const inner = sector * (ring - 1) + b;
        faces.push([index(ring - 1, inner), index(ring, outer), index(ring, outer + 1)]);
        if (b + 1 < ring) faces.push([index(ring - 1, inner), index(ring, outer + 1), index(ring - 1, inner + 1)]);
      }
  return text(points, faces);
}

export const plane = (n: number): string => star(n, 3, () => 0);
export const saddle = (n: number): string => star(n, 3, (x, z) => 0.14 * (x * x - z * z));
/** One vertex at height 1, the others at 0: the surface is the scheme's basis function. */
export const peak = (): string => star(6, 4, (_x, _z, ring) => (ring === 0 ? 2 : 0));

export function cube(): string {
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);
  const sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  return text(corners, sides.flatMap(([a, b, c, d]) => [[a!, b!, c!], [a!, c!, d!]]));
}

export function torus(): string {
  const [many, few] = [9, 6];
  const points: number[][] = [];
  const faces: number[][] = [];
  for (let i = 0; i < many; ++i)
    for (let j = 0; j < few; ++j) {
      const [u, v] = [(2 * Math.PI * i) / many, (2 * Math.PI * j) / few];
      const r = 2 + 0.9 * Math.cos(v);
      points.push([r * Math.cos(u), 0.9 * Math.sin(v), -r * Math.sin(u)]);
      const [a, b] = [i * few + j, i * few + ((j + 1) % few)];
      const [c, d] = [((i + 1) % many) * few + j, ((i + 1) % many) * few + ((j + 1) % few)];
      faces.push([a, c, d], [a, d, b]);
    }
  return text(points, faces);
}
