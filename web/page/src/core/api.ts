// Build contract (page_core side, please keep):
//   LIMN_CORE_DIR=DIR npm run build   reads DIR/limn_core.mjs (emscripten, MODULARIZE + EXPORT_ES6, default export makes the
//   module; it gets `wasmBinary` or `instantiateWasm`) and DIR/limn_core.wasm, and writes dist/index.html, one file.
//   The module's embind object is the Core below (free functions on the module). Typed arrays may be views of the heap:
//   the worker copies them at once.
//   dist/index.html holds `<script type="application/json" id="record">null</script>` exactly once; `limn report` puts the
//   record in the place of `null` (with every "<" written as <).
// The contract between the page and the core (one WebAssembly module in one worker). Every function is synchronous inside
// the worker; strings are JSON. Results are {"ok":true,…} or {"ok":false,"errors":[{"line","column","message","hint"}]}
// (line and column are 0 where there is none). Numbers and keys are those of the command's --json.
// As built in web/core/page_core.h (its comments say more). Changed against the first draft, page_core side:
//   schemes() and meshes() are {"ok","schemes":[…]} and {"ok","meshes":[…]}; eigen has a third argument, regularity and
//   artifactMap a further one; sampling() is new; characteristicMap takes steps, and its json has the net; control() and
//   topology() have a json; typed arrays are copies, the worker may transfer them.
export interface Core {
  /** {"ok","version"} */
  version(): string;
  /** {"ok","schemes":[{"name","title","split","lattice":"triangles|quads","source","text"}]}: the shipped schemes. */
  schemes(): string;
  /** Parses a scheme file's text. parameters: a JSON object {"a":"1/8"} or {"a":0.125}, or "". The text of the last few
   *  schemes is kept, so that a call with other parameters alone is quick (about a millisecond).
   *  → {"ok","id","name","title","split","lattice","dual","source","notes","file",
   *     "parameters":[{"name","meaning","value":"1/8","number":0.125|null,"default":"1/16","min":number|null,"max","integer"}],
   *     "valences":{"regular":6,"least":2,"most":128},
   *     "features":{"eigen","refine","boundary","sharpness":bool,…},"reasons":{feature: why not}} */
  load(text: string, parameters: string): string;
  unload(id: number): void;
  show(id: number): string;                                   // {"ok", … as `limn show --json`}
  /** {"ok", "regular_part":{…}, … as valences[0] of `limn eigen --json`}. quick: do not ask what the regular lattice
   *  allows (up to some tenths of a second for a mask not seen before); verdict.bounded_curvature is then undecided. */
  eigen(id: number, valence: number, quick: boolean): string;
  /** Characteristic map after `steps` (0…5; 3 or 4 are good): points (x,y pairs) and lines (pairs of indices) of the image's
   *  fine net; json: {"ok","valence","eigenvalue","regular":"yes|no|undecided","reason","turned_over",
   *  "net":{"points":[[x,y],…],"lines":[[i,j],…]}}: the control net. */
  characteristicMap(id: number, valence: number, steps: number): { json: string; points: Float32Array; lines: Uint32Array };
  /** {"ok", … as `limn artifacts --frequency fx,fy --json`}. |f| ≤ 1000. */
  artifacts(id: number, fx: number, fy: number): string;
  /** {"ok", … as `limn artifacts --tolerance percent --json`}: edges per wavelength. Some tenths of a second. */
  sampling(id: number, percent: number): string;
  /** size×size percents of the signal (limit) over the bounding box of the Nyquist region, row by row from the least fy,
   *  cell centres; NaN outside the region. measure: "mean_energy" (percent_of_signal of artifacts, quick) or "total_energy"
   *  (total_energy_percent, slow). json: {"ok","size","extent":[x0,y0,x1,y1],"lattice","cell":[[fx,fy],…],"measure","largest"}. */
  artifactMap(id: number, size: number, measure: string): { json: string; values: Float32Array };
  /** Limit surface of the wave of frequency (fx,fy) as a height field over a square of the plane, in control edges; errors:
   *  height minus the signal. json: {"ok","extent":[x0,y0,x1,y1],"size":points a side,"signal":amplitude,"largest_error"}.
   *  levels 0…4: 16·2^levels cells a side. */
  wave(id: number, fx: number, fy: number, levels: number): { json: string; positions: Float32Array; triangles: Uint32Array; errors: Float32Array };
  /** {"ok", … as `limn regularity --json`}; seconds bounds the search ("time_ended" says that it ended it). */
  regularity(id: number, seconds: number): string;
  /** Example control meshes: {"ok","meshes":[{"name","summary","faces":"triangles|quads|mixed"}]}. */
  meshes(): string;
  mesh(name: string): string;                                 // loads one → as loadMesh
  /** An OBJ/OFF/PLY/STL/GLB file's bytes → {"ok","id","faces","closed","check":{… as `limn check --json`},"warnings":[…],
   *  "repaired":[{"what","count","text"}]}; where the mesh has faults that keep it from being refined: {"ok":false,"check",
   *  "errors"}. repair: "" or "weld", "orient", "cut", "triangulate", "repair", several with commas. */
  loadMesh(fileName: string, bytes: Uint8Array, repair: string): string;
  unloadMesh(id: number): void;
  /** positions (x,y,z), edges (pairs of vertices; edge number = place in this list). json: {"ok","vertices","edges","faces",
   *  "bounds":[[x,y,z],[x,y,z]],"sharp":{"edges":{number:sharpness},"vertices":{…}}}. */
  control(meshId: number): { json: string; positions: Float32Array; edges: Uint32Array };
  /** The plan of refining this mesh with this scheme; kept, so that evaluate is quick. options: JSON {"levels":3,
   *  "limit":true,"normals":true,"texture":false,"instead":0} → {"ok","id","vertices","triangles","engine":"fast|plain",
   *  "limit":bool,"reason","missing"}: at so many vertices there is no limit, and the faces there are left out. instead: a plan
   *  that goes, whose memory this one takes. A plan outlives unload of its scheme and mesh; it is wrong after setSharpness
   *  (make a new one), right after moveVertex. */
  plan(id: number, meshId: number, options: string): string;
  unplan(planId: number): void;
  /** triangles of the refined mesh. json: {"ok"} */
  topology(planId: number): { json: string; triangles: Uint32Array };
  /** The control mesh's edges on the surface: point p is the mean of the plan's vertices vertices[begin[p]] …
   *  vertices[begin[p + 1] - 1]; segments are pairs of points. As long as refining anew. json: {"ok"} */
  lines(planId: number): { json: string; vertices: Uint32Array; begin: Uint32Array; segments: Uint32Array };
  /** Of a plan made with "texture": two numbers for each corner of topology's triangles. json: {"ok","pattern":"image" (the
   *  mesh's own) | "triangles" | "quads" (of each control face) | "none","reason"} */
  texture(planId: number): { json: string; coordinates: Float32Array };
  /** Of the mesh as it is now. normals of the limit surface, or else means of the faces' (json says which).
   *  json: {"ok","limit":bool,"normals":"limit|faces","milliseconds"} */
  evaluate(planId: number): { json: string; positions: Float32Array; normals: Float32Array };
  /** At the plan's vertices; NaN where there is none. Microseconds a vertex. json: {"ok","missing":count,"reasons":[…]} */
  curvature(planId: number): { json: string; gaussian: Float32Array; mean: Float32Array };
  /** From each vertex of surface A to surface B. json: {"ok","largest","mean","diagonal"} */
  distance(planA: number, planB: number): { json: string; values: Float32Array };
  moveVertex(meshId: number, vertex: number, x: number, y: number, z: number): string;
  /** sharpness 0 … 10; 10 and more: for ever. */
  setSharpness(meshId: number, kind: "edge" | "vertex", index: number, sharpness: number): string;
}
