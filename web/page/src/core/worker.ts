// The worker: inflates and compiles the core once, then does one job after another.
import makeCore from 'limn-core';
import type { Core } from './api';
import { fromBase85 } from './base85';
import { perform, Session, type JobName } from './session';

type Message = { start: string | WebAssembly.Module } | { id: number; job: JobName; args: unknown[] };

let session: Promise<Session> | undefined;

async function compiled(packed: string): Promise<WebAssembly.Module | undefined> {
  if (packed === '') return undefined;
  // It is compiled while it is inflated.
  const stream = new Blob([fromBase85(packed)]).stream().pipeThrough(new DecompressionStream('deflate'));
  return WebAssembly.compileStreaming(new Response(stream, { headers: { 'Content-Type': 'application/wasm' } }));
}

async function start(source: string | WebAssembly.Module): Promise<Session> {
  const module = typeof source === 'string' ? await compiled(source) : source;
  const core = await makeCore({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void) {
      WebAssembly.instantiate(module!, imports).then((instance) => done(instance, module!));
      return {};
    },
  });
  postMessage({ started: module ?? null });
  return new Session(core as unknown as Core);
}

function buffers(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (value && typeof value === 'object' && !(value instanceof ArrayBuffer))
    for (const part of Object.values(value)) buffers(part, found);
  return found;
}

onmessage = async ({ data }: MessageEvent<Message>) => {
  if ('start' in data) {
    session = start(data.start);
    session.catch((error: unknown) => postMessage({ failed: String(error) }));
    return;
  }
  try {
    const answer = perform(await session!, data.job, data.args);
    postMessage({ id: data.id, answer }, { transfer: [...buffers((answer as { result?: unknown }).result)] });
  } catch (error) {
    postMessage({ id: data.id, stopped: String(error) });
  }
};
