// What is shipped: asked of the core when the page is built, as the list of schemes takes some tenths of a second.
import type { Core } from './api';
import type { Catalogue, Shipped, ShippedMesh } from './results';

export function catalogueOf(core: Core): Catalogue {
  const { version } = JSON.parse(core.version()) as { version: string };
  const { schemes } = JSON.parse(core.schemes()) as { schemes: Shipped[] };
  const { meshes } = JSON.parse(core.meshes()) as { meshes: ShippedMesh[] };
  return { version, schemes, meshes };
}
