// The worker: takes the compiled core once, then does one job after another.
import makeCore from 'limn-core';
import type { Core } from './api';
import { perform, Session, type JobName } from './session';

/** `start`: the core, or why there is none. Jobs may come before it. */
type Message = { start: WebAssembly.Module | string } | { id: number; job: JobName; args: unknown[] };

let begin!: (session: Promise<Session>) => void;
const session = new Promise<Session>((resolve) => (begin = resolve));

async function start(module: WebAssembly.Module | string): Promise<Session> {
  if (typeof module === 'string') throw new Error(module);
  const core = await makeCore({
    instantiateWasm(imports: WebAssembly.Imports, done: (instance: WebAssembly.Instance, module: WebAssembly.Module) => void) {
      WebAssembly.instantiate(module, imports).then((instance) => done(instance, module));
      return {};
    },
  });
  return new Session(core as unknown as Core);
}

function buffers(value: unknown, found = new Set<ArrayBuffer>()): Set<ArrayBuffer> {
  if (ArrayBuffer.isView(value)) found.add(value.buffer as ArrayBuffer);
  else if (value && typeof value === 'object' && !(value instanceof ArrayBuffer))
    for (const part of Object.values(value)) buffers(part, found);
  return found;
}

onmessage = async ({ data }: MessageEvent<Message>) => {
  if ('start' in data) return begin(start(data.start));
  try {
    const answer = perform(await session, data.job, data.args);
    postMessage({ id: data.id, answer }, { transfer: [...buffers((answer as { result?: unknown }).result)] });
  } catch (error) {
    postMessage({ id: data.id, stopped: String(error) });
  }
};
