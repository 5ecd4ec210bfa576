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
  if (eigen === null) {
    refused(core.eigen(id, 5, true));
  } else {
    for (const valence of eigen.valences) {
      const { regular_part, ...ours } = accepted(core.eigen(id, valence.valence, false));
      assert.equal(regular_part.bounded, eigen.regular_part.bounded, scheme.name);
      equal(withoutOrder(ours), withoutOrder(valence), `${scheme.name} ${valence.valence}`);
    }
  }
  const artifacts = command('artifacts', scheme.name, '-f', '0.21,0.13');
  if (artifacts === null) refused(core.artifacts(id, 0.21, 0.13));
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

// how long a step of a slider takes at about 50 000 vertices
const bracket = accepted(core.mesh('bracket')).id;
const blended = shipped.find((one) => one.name === 'laplacian-loop').text;
const times = [];
let vertices = 0;
for (let i = 0; i < 12; ++i) {
  const start = performance.now();
  const id = accepted(core.load(blended, JSON.stringify({ a: 0.1 + i / 1000 }))).id;
  const plan = accepted(core.plan(id, bracket, '{"levels": 5}'));
  const surface = core.evaluate(plan.id);
  times.push(performance.now() - start);
  vertices = plan.vertices;
  assert.equal(surface.positions.length, 3 * vertices);
  assert.equal(plan.engine, 'fast');
  core.unplan(plan.id);
  core.unload(id);
}
const plan = accepted(core.plan(loop, bracket, '{"levels": 5}')).id;
const dragged = [];
for (let i = 0; i < 12; ++i) {
  const start = performance.now();
  accepted(core.moveVertex(bracket, 0, -1.6 + i / 100, 0, 0));
  core.evaluate(plan);
  dragged.push(performance.now() - start);
}
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)].toFixed(1);
console.log(`${shipped.length} schemes, ${compared} numbers equal the command's to 1e-9`);
console.log(`start ${startMs.toFixed(0)} ms; ${vertices} vertices: a parameter ${median(times)} ms, a moved vertex ${median(dragged)} ms`);
