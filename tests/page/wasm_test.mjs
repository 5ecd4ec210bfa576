// node tests/page/wasm_test.mjs CORE_FOLDER LIMN: the page's core as WebAssembly against the native command. Numbers are equal
// to 1e-9 for every shipped scheme at the valences 3 … 12; words are the same; bad input is answered, never a trap.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [folder, limn] = process.argv.slice(2).map((path) => resolve(path));
globalThis.require = createRequire(import.meta.url);
globalThis.__dirname = folder;
const started = performance.now();
const make = (await import(pathToFileURL(join(folder, 'limn_core.mjs')))).default;
const core = await make({ wasmBinary: readFileSync(join(folder, 'limn_core.wasm')) });
const startMs = performance.now() - started;

const parsed = (text) => JSON.parse(text);
const accepted = (text) => {
  const { ok, ...rest } = parsed(text);
  assert.ok(ok, text.slice(0, 500));
  return rest;
};
const refused = (text) => {
  const answer = parsed(text);
  assert.equal(answer.ok, false, text.slice(0, 500));
  assert.ok(answer.errors.length > 0);
};
const command = (...words) => {
  try {
    return parsed(execFileSync(limn, [...words, '--json'], { stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 1 << 28 }));
  } catch {
    return null;
  }
};

let compared = 0;
/** Same keys, words and flags; numbers equal to 1e-9 of what is 1 or their size. */
function equal(ours, theirs, where) {
  if (typeof theirs === 'number' && typeof ours === 'number') {
    ++compared;
    const apart = Math.abs(ours - theirs);
    assert.ok(apart <= 1e-9 * Math.max(1, Math.abs(theirs)), `${where}: ${ours} is not ${theirs}`);
  } else if (theirs !== null && typeof theirs === 'object') {
    assert.deepEqual(Object.keys(ours ?? {}), Object.keys(theirs), where);
    for (const key of Object.keys(theirs)) equal(ours[key], theirs[key], `${where}.${key}`);
  } else {
    assert.equal(ours, theirs, where);
  }
}

/** Eigenvalues alone of a complex pair or a multiple one may come in another order: compare sizes, then all but those. */
function withoutOrder(valence) {
  const copy = structuredClone(valence);
  for (const block of copy.blocks) {
    block.eigenvalues = block.eigenvalues.map((one) => one.modulus);
  }
  // reasons name numbers to some digits
  copy.verdict.reasons = copy.verdict.reasons.length;
  return copy;
}

const shipped = accepted(core.schemes()).schemes;
for (const scheme of shipped) {
  const id = accepted(core.load(scheme.text, '')).id;
  const eigen = command('eigen', scheme.name);
  if (eigen === null || eigen.lattices) {  // the page shows one lattice alone
    refused(core.eigen(id, 5, true));
  } else {
    for (const valence of eigen.valences) {
      const { regular_part, ...ours } = accepted(core.eigen(id, valence.valence, false));
      assert.equal(regular_part.bounded, eigen.regular_part.bounded, scheme.name);
      equal(withoutOrder(ours), withoutOrder(valence), `${scheme.name} ${valence.valence}`);
    }
  }
  const artifacts = command('artifacts', scheme.name, '-f', '0.21,0.13');
  if (artifacts === null || artifacts.lattices) refused(core.artifacts(id, 0.21, 0.13));
  else equal(accepted(core.artifacts(id, 0.21, 0.13)), artifacts, `${scheme.name} artifacts`);
  core.unload(id);
}

for (const name of ['loop', 'butterfly', 'catmull-clark', 'sqrt3']) {
  const id = accepted(core.load(shipped.find((one) => one.name === name).text, '')).id;
  const ours = accepted(core.regularity(id, 600));
  const theirs = command('regularity', name, '--time', '0');
  equal(ours.holder, theirs.holder, `${name} holder`);
  equal(ours.smoothness, theirs.smoothness, `${name} smoothness`);
}

// garbage of every kind
const loop = accepted(core.load(shipped.find((one) => one.name === 'loop').text, '')).id;
const mesh = accepted(core.mesh('octahedron')).id;
let random = 12345;
const next = (below) => (random = (random * 1103515245 + 12345) % 2147483648) % below;
for (let round = 0; round < 100; ++round) {
  const text = [...shipped[round % shipped.length].text];
  for (let i = 0; i < 4; ++i) text.splice(next(text.length), next(30), String.fromCharCode(next(256)));
  const answer = parsed(core.load(text.join(''), ''));
  assert.ok(answer.ok || answer.errors.length > 0);
  if (answer.ok) parsed(core.eigen(answer.id, 5, true));
}
for (let round = 0; round < 100; ++round) {
  const bytes = Uint8Array.from({ length: next(300) }, () => next(256));
  for (const file of ['x.obj', 'x.ply', 'x.stl', 'x.glb', 'x.off', 'x', '']) refused(core.loadMesh(file, bytes, 'repair'));
}
for (const bad of [NaN, Infinity, -1, 1e308]) {
  refused(core.artifacts(loop, bad === -1 ? 1e9 : bad, 0));
  refused(core.sampling(loop, bad));
  refused(core.regularity(loop, bad));
  refused(core.moveVertex(mesh, 0, bad === -1 ? NaN : bad, 0, 0));
  refused(core.setSharpness(mesh, 'edge', 0, bad));
}
refused(core.eigen(loop, 1e9, false));
refused(core.plan(loop, mesh, '{"levels": 40}'));
refused(core.plan(loop, accepted(core.mesh('bracket')).id, '{"levels": 10}'));
refused(core.load(shipped[0].text, '{"a": "1" '));
refused(core.load('x'.repeat(1 << 21), ''));

const text = (name) => shipped.find((one) => one.name === name).text;

// control edges run on the surface of every split: their length comes to rest over the levels
{
  const length = (lines, positions) => {
    const point = (p) => [0, 1, 2].map((c) => { let sum = 0; for (let i = lines.begin[p]; i < lines.begin[p + 1]; ++i) sum += positions[3 * lines.vertices[i] + c]; return sum / (lines.begin[p + 1] - lines.begin[p]); });
    let sum = 0;
    for (let i = 0; i < lines.segments.length; i += 2) { const [a, b] = [point(lines.segments[i]), point(lines.segments[i + 1])]; sum += Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }
    return sum;
  };
  const pieces = { loop: (l) => 2 ** l, 'catmull-clark': (l) => 2 ** l, 'loop-ternary': (l) => 3 ** l, 'doo-sabin': (l) => 2 ** l, sqrt3: (l) => 3 ** Math.floor(l / 2) * (l % 2 ? 2 : 1), 'four-eight': (l) => 2 ** Math.floor(l / 2) * (l % 2 ? 2 : 1), midedge: (l) => 2 ** Math.floor(l / 2) * (l % 2 ? 2 : 1) };
  for (const [name, count] of Object.entries(pieces)) {
    const scheme = accepted(core.load(text(name), ''));
    const torus = accepted(core.mesh(scheme.lattice === 'triangles' ? 'torus-triangles' : 'torus-quads')).id;
    const edges = core.control(torus).edges.length / 2;
    let before = 0;
    for (const levels of [2, 3, 4]) {
      const plan = accepted(core.plan(scheme.id, torus, JSON.stringify({ levels }))).id;
      const lines = core.lines(plan);
      assert.equal(lines.segments.length / 2, edges * count(levels), `${name}, level ${levels}: pieces of edges`);
      const now = length(lines, core.evaluate(plan).positions);
      if (before > 0) assert.ok(Math.abs(now / before - 1) < 0.03, `${name}, level ${levels}: edges of length ${now}, not ${before}`);
      before = now;
      core.unplan(plan);
    }
  }
}

// a plan instead of another is that of its own parameters
{
  const mesh = accepted(core.mesh('bracket')).id;
  const load = (a) => accepted(core.load(text('laplacian-loop'), JSON.stringify({ a }))).id;
  let before = accepted(core.plan(load('1/32'), mesh, '{"levels":3}')).id;
  for (const a of ['1/16', '1/8', '1/32']) {
    const fresh = accepted(core.plan(load(a), mesh, '{"levels":3}')).id;
    const instead = accepted(core.plan(load(a), mesh, JSON.stringify({ levels: 3, instead: before }))).id;
    assert.deepEqual(core.evaluate(instead).positions, core.evaluate(fresh).positions);
    assert.deepEqual(core.evaluate(instead).normals, core.evaluate(fresh).normals);
    assert.deepEqual(core.topology(instead).triangles, core.topology(fresh).triangles);
    refused(core.evaluate(before).json);
    before = instead;
  }
}

// what a slider sets again and again is checked as what is set once, whether its rules are known by then or not
for (const [name, parameter] of [['laplacian-loop-low', 'a'], ['butterfly', 'w'], ['loop-type', 'beta'], ['kobbelt-quad', 'w']]) {
  for (const value of ['1/16', '1/10', '1/9', '1/8', '2', '-3', '1/0', 'nothing', '1/7']) {
    const again = parsed(core.load(text(name), JSON.stringify({ [parameter]: value })));
    const once = parsed(core.load(`${text(name)}\n# ${value}\n`, JSON.stringify({ [parameter]: value })));
    assert.equal(again.ok, once.ok, `${name} ${parameter}=${value}`);
    if (again.ok) assert.deepEqual(again.parameters, once.parameters);
    else assert.deepEqual(again.errors.map((e) => e.message), once.errors.map((e) => e.message));
  }
}
// weights that sum to 1 at two values of a parameter, and nowhere else
{
  const parabola = 'extends = "loop"\nsplit = "triangle-dyadic"\nvertex = { self = "1 - n*beta + (a - 1)*(2*a - 1)", ring = "beta" }\n[parameter.a]\ndefault = "1"\n';
  for (const a of ['1/2', '1', '1/2']) accepted(core.load(parabola, JSON.stringify({ a })));
  for (const a of ['1/4', '0', '3']) refused(core.load(parabola, JSON.stringify({ a })));
}

// texture coordinates: the mesh's own on either side of a seam, those of the faces, and none
{
  const squares = 'v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 3 3\nvt 4 3\nvt 4 4\nvt 3 4\nf 1/1 2/2 5/3 4/4\nf 2/5 3/6 6/7 5/8\n';
  const mesh = accepted(core.loadMesh('squares.obj', new TextEncoder().encode(squares), '')).id;
  const of = (name, mesh, more = {}) => {
    const plan = accepted(core.plan(accepted(core.load(text(name), '')).id, mesh, JSON.stringify({ levels: 2, texture: true, ...more }))).id;
    const { json, coordinates } = core.texture(plan);
    return { ...accepted(json), coordinates, triangles: core.topology(plan).triangles, positions: core.evaluate(plan).positions };
  };
  const own = of('catmull-clark', mesh, { limit: false });
  assert.equal(own.pattern, 'image');
  assert.equal(own.coordinates.length, 2 * own.triangles.length);
  own.triangles.forEach((v, i) => {
    const x = own.positions[3 * v];
    if (Math.abs(x - 1) > 0.1) assert.equal(x < 1, own.coordinates[2 * i] < 2);
  });
  const faces = of('loop', accepted(core.mesh('octahedron')).id);
  assert.equal(faces.pattern, 'triangles');
  assert.equal(faces.coordinates.length, 2 * faces.triangles.length);
  assert.ok(faces.coordinates.every((x) => Math.abs(4 * x - Math.round(4 * x)) < 1e-6));
  const none = of('sqrt3', accepted(core.mesh('octahedron')).id);
  assert.equal(none.pattern, 'none');
  assert.match(none.reason, /seams/);
}

// where there is no limit there are holes
{
  const jumps = 'split = "triangle-dyadic"\nextends = "loop"\n[[vertex]]\nwhen = "n == 5"\nself = "3"\nring = "-2/n"\n[[vertex]]\nself = "1 - n*beta"\nring = "beta"\n';
  const scheme = accepted(core.load(jumps, '')).id;
  const turn = (i) => (i * 2 * Math.PI) / 5;
  const hill = `v 0 0 1\n${[0, 1, 2, 3, 4].map((i) => `v ${Math.cos(turn(i))} ${Math.sin(turn(i))} 0\n`).join('')}${[0, 1, 2, 3, 4].map((i) => `f 1 ${2 + i} ${2 + ((i + 1) % 5)}\n`).join('')}`;
  const mesh = accepted(core.loadMesh('hill.obj', new TextEncoder().encode(hill), '')).id;
  const plan = accepted(core.plan(scheme, mesh, '{"levels":2}'));
  assert.ok(plan.limit && plan.missing >= 1 && plan.reason.length > 0, JSON.stringify(plan));
  assert.equal(core.topology(plan.id).triangles.length, 3 * plan.triangles);
  assert.ok(plan.triangles <= 75);
  assert.equal(accepted(core.plan(scheme, mesh, '{"levels":2,"limit":false}')).triangles, 80);
}

// how long a step of a slider takes at about 50 000 vertices: processor time, on a thread that others may hold up
const now = () => process.cpuUsage().user / 1000;
const bracket = accepted(core.mesh('bracket')).id;
const blended = shipped.find((one) => one.name === 'laplacian-loop').text;
const times = [];
let vertices = 0;
let before = 0;
for (let i = 0; i < 40; ++i) {
  const start = now();
  const id = accepted(core.load(blended, JSON.stringify({ a: 0.1 + i / 1000 }))).id;
  const plan = accepted(core.plan(id, bracket, JSON.stringify({ levels: 5, instead: before })));
  const surface = core.evaluate(plan.id);
  times.push(now() - start);
  vertices = plan.vertices;
  assert.equal(surface.positions.length, 3 * vertices);
  assert.equal(plan.engine, 'fast');
  before = plan.id;
  core.unload(id);
}
const plan = accepted(core.plan(loop, bracket, '{"levels": 5}')).id;
const dragged = [];
for (let i = 0; i < 40; ++i) {
  const start = now();
  accepted(core.moveVertex(bracket, 0, -1.6 + i / 100, 0, 0));
  core.evaluate(plan);
  dragged.push(now() - start);
}
const least = (list) => Math.min(...list).toFixed(1);
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)].toFixed(1);
console.log(`${shipped.length} schemes, ${compared} numbers equal the command's to 1e-9`);
console.log(`start ${startMs.toFixed(0)} ms; ${vertices} vertices: a parameter ${least(times)} ms at least, ${median(times)} ms as a rule, a moved vertex ${least(dragged)} and ${median(dragged)} ms`);
