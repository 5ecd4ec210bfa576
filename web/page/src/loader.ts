// Runs as soon as the core is read. Each part of the page stands in an element of its own, deflated: the worker's program and the core, which
// is three quarters of the file, before this script; the page's program and what is needed later behind it. So the core is compiled
// while the browser reads on. (The program first, or the core in pieces, each compiled while the next is read, made the whole slower.)
import { fromBase85 } from './core/base85';
import type { Start } from './start';

/** The whole file is read: all elements are there. */
const read = new Promise<void>((resolve) =>
  document.readyState === 'loading' ? addEventListener('DOMContentLoaded', () => resolve(), { once: true }) : resolve());

function inflated(id: string, type: string): Response {
  const bytes = fromBase85(document.getElementById(id)!.textContent!);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream, { headers: { 'Content-Type': type } });
}

async function addressOf(id: string): Promise<string> {
  const code = await inflated(id, 'text/javascript').arrayBuffer();
  return URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
}

async function load<T>(id: string, code = addressOf(id)): Promise<T> {
  const address = await code;
  const module: T = await import(/* @vite-ignore */ address);
  URL.revokeObjectURL(address);
  return module;
}

function once<T>(id: string): () => Promise<T> {
  let loaded: Promise<T> | undefined;
  return () => (loaded ??= read.then(() => load<T>(id)));
}

async function begin(): Promise<void> {
  const core = WebAssembly.compileStreaming(inflated('core', 'application/wasm'));
  const program = read.then(() => addressOf('program'));
  const worker = await addressOf('worker');
  const spawn = (): Worker => {
    const made = new Worker(worker);
    core.then((module) => made.postMessage({ start: module }), (error: unknown) => made.postMessage({ start: String(error) }));
    return made;
  };
  const first = [spawn()];
  const start: Start = { opening: inflated('opening', 'application/octet-stream').arrayBuffer(), spawn: () => first.pop() ?? spawn(), painter: once('painter'), later: once('later') };
  Object.assign(globalThis, { limnStart: start });
  await load('program', program);
}

begin().catch((error: unknown) => {
  document.getElementById('app')!.textContent =
    `This page needs a browser with WebAssembly and DecompressionStream (Chrome 103, Firefox 113, Safari 16.4 or newer). ${String(error)}`;
});
