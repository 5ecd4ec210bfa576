// The page's side of the workers. Every view asks in a lane of its own: a lane has one job under way and remembers only
// the newest that came meanwhile, so a slider never builds up a queue. A running job cannot be interrupted, so what is drawn
// under a hand has a worker to itself, analyses have a second one, and long jobs a third, which is ended and replaced when a
// newer step comes.
import type { Fault } from './results';
import type { Session, JobName } from './session';

type Result<K extends JobName> = ReturnType<Session[K]>;
export type Outcome<T> = { ok: true; result: T; milliseconds: number } | { ok: false; errors: Fault[] };
/** What a job's asker gets when a newer job took its place. */
export const superseded = Symbol('superseded');

interface Ask {
  lane: string;
  job: JobName;
  args: unknown[];
  begun: number;
  resolve(outcome: Outcome<never> | typeof superseded): void;
}
interface Wire {
  worker: Worker;
  current?: Ask;
  id: number;
}

/** Ahead of others: what a hand is on. */
const order = ['scheme', 'control', 'surface', 'surface-b', 'eigen', 'map', 'sweep', 'artifacts', 'wave', 'eigen-whole', 'sampling'];
/** In the first worker. */
const drawing = new Set(['scheme', 'scheme-first', 'other', 'control', 'surface', 'surface-b', 'surface-lines', 'surface-b-lines', 'timing', 'svg']);
const rank = (lane: string): number => (order.indexOf(lane.startsWith('sweep-') ? 'sweep' : lane) + order.length + 1) % (order.length + 1);

class Line {
  private wire?: Wire;
  private waiting = new Map<string, Ask>();

  constructor(private open: () => Worker, private impatient: boolean) {}

  put(ask: Ask): void {
    this.waiting.get(ask.lane)?.resolve(superseded);
    this.waiting.delete(ask.lane);
    this.waiting.set(ask.lane, ask);
    if (this.impatient && this.wire?.current?.lane === ask.lane) this.end(superseded);
    this.next();
  }

  warm(): void {
    this.wire ??= this.connect();
  }

  private end(outcome: Outcome<never> | typeof superseded): void {
    this.wire?.worker.terminate();
    const current = this.wire?.current;
    this.wire = undefined;
    current?.resolve(outcome);
  }

  private connect(): Wire {
    const wire: Wire = { worker: this.open(), id: 0 };
    const stop = (message: string) =>
      wire === this.wire && (this.end({ ok: false, errors: [{ message: `the core stopped: ${message}` }] }), this.next());
    wire.worker.onerror = (event) => stop(event.message);
    wire.worker.addEventListener('message', ({ data }) => {
      if (data.id !== wire.id || !wire.current) return;
      if (data.stopped) return void stop(data.stopped);
      const ask = wire.current;
      wire.current = undefined;
      ask.resolve(Object.assign(data.answer, { milliseconds: performance.now() - ask.begun }));
      this.next();
    });
    return wire;
  }

  private next(): void {
    if (this.waiting.size === 0 || this.wire?.current) return;
    this.wire ??= this.connect();
    const ask = [...this.waiting.values()].sort((a, b) => rank(a.lane) - rank(b.lane))[0]!;
    this.waiting.delete(ask.lane);
    this.wire.current = ask;
    ask.begun = performance.now();
    this.wire.worker.postMessage({ id: ++this.wire.id, job: ask.job, args: ask.args });
  }
}

export class Client {
  private quick: Line;
  private analyses: Line;
  private slow: Line;

  private settling = new Map<string, { timer: ReturnType<typeof setTimeout>; drop(): void }>();

  /** `spawn` begins a worker. `settle`: milliseconds that a long job waits for a newer one, so that a slider that moves begins none. */
  constructor(spawn: () => Worker, private settle = 300) {
    this.quick = new Line(spawn, false);
    this.analyses = new Line(spawn, false);
    this.slow = new Line(spawn, true);
    this.quick.warm();
  }

  /** The answer, or `superseded` where a newer job of the lane came first. */
  ask<K extends JobName>(lane: string, job: K, ...args: Parameters<Session[K]>): Promise<Outcome<Result<K>> | typeof superseded> {
    return this.put(drawing.has(lane) ? this.quick : this.analyses, lane, job, args) as Promise<Outcome<Result<K>> | typeof superseded>;
  }

  /** The same in the worker for long jobs, which a newer one of the lane ends. */
  askSlow<K extends JobName>(lane: string, job: K, ...args: Parameters<Session[K]>): Promise<Outcome<Result<K>> | typeof superseded> {
    const waiting = this.settling.get(lane);
    if (waiting) (clearTimeout(waiting.timer), waiting.drop());
    return new Promise((resolve) => {
      const go = (): void => {
        this.settling.delete(lane);
        void (this.put(this.slow, lane, job, args) as Promise<Outcome<Result<K>> | typeof superseded>).then(resolve);
      };
      if (this.settle === 0) return go();
      this.settling.set(lane, { timer: setTimeout(go, this.settle), drop: () => resolve(superseded) });
    });
  }

  private put(line: Line, lane: string, job: JobName, args: unknown[]): Promise<unknown> {
    return new Promise((resolve) => line.put({ lane, job, args, begun: performance.now(), resolve }));
  }
}
