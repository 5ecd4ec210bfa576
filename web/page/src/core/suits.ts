// Which meshes a scheme's split takes.
import type { ShippedMesh } from './results';

const needsTriangles = (split: string): boolean => split.startsWith('triangle') || split === 'sqrt3';

export function suits(split: string, mesh: ShippedMesh): boolean {
  if (needsTriangles(split)) return mesh.faces === 'triangles';
  return split === 'quad-sqrt2' || split === 'quad-ternary' ? mesh.faces === 'quads' : true;
}

/** The first shipped mesh for the split, of the faces that it is for. */
export function firstThatSuits(split: string, meshes: ShippedMesh[]): ShippedMesh | undefined {
  const own = meshes.filter((mesh) => suits(split, mesh));
  return own.find((mesh) => (needsTriangles(split) ? mesh.faces === 'triangles' : mesh.faces === 'quads')) ?? own[0];
}
