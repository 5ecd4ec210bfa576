// The lanes over workers of the test's own: newest wins, long jobs are ended, a stopped core is replaced.
import { describe, expect, it } from 'vitest';
import { Client, superseded } from '../../src/core/client';

class FakeWorker extends EventTarget {
  static all: FakeWorker[] = [];
  asked: { id: number; job: string; args: unknown[] }[] = [];
  ended = false;
  onerror: unknown = null;
  constructor() {
    super();
    FakeWorker.all.push(this);
  }
  postMessage(data: { id?: number; job?: string; args?: unknown[] }): void {
    if (data.id !== undefined) this.asked.push(data as FakeWorker['asked'][0]);
  }
  terminate(): void {
    this.ended = true;
  }
  tell(data: unknown): void {
    this.dispatchEvent(Object.assign(new Event('message'), { data }));
  }
  answer(result: unknown): void {
    this.tell({ id: this.asked.at(-1)!.id, answer: { ok: true, result } });
  }
}
function client(): Client {
  FakeWorker.all = [];
  return new Client(() => new FakeWorker() as unknown as Worker, 0);
}
const spec = { text: 't', parameters: {} };

describe('a lane', () => {
  it('does one job, and of those that wait only the newest', async () => {
    const c = client();
    const first = c.ask('eigen', 'eigen', spec, 3);
    const second = c.ask('eigen', 'eigen', spec, 4);
    const third = c.ask('eigen', 'eigen', spec, 5);
    expect(await second).toBe(superseded);
    const worker = FakeWorker.all[1]!;
    worker.answer({ valence: 3 });
    expect(await first).toMatchObject({ ok: true, result: { valence: 3 } });
    expect(worker.asked.map((a) => a.args[1])).toEqual([3, 5]);
    worker.answer({ valence: 5 });
    expect(await third).toMatchObject({ result: { valence: 5 } });
  });
  it('does not hold up another, and the surface goes first', () => {
    const c = client();
    void c.ask('scheme', 'load', spec);
    void c.ask('timing', 'load', spec);
    void c.ask('surface', 'show', spec);
    const worker = FakeWorker.all[0]!;
    worker.answer({});
    expect(worker.asked.at(-1)!.job).toBe('show');
  });
  it('of an analysis leaves the worker that draws free', async () => {
    const c = client();
    void c.ask('artifact-map', 'artifactMap', spec, 48);
    void c.ask('eigen', 'eigen', spec, 3);
    const surface = c.ask('surface', 'show', spec);
    const [draws, analyses] = FakeWorker.all as [FakeWorker, FakeWorker];
    expect(draws.asked.map((a) => a.job)).toEqual(['show']);
    expect(analyses.asked.map((a) => a.job)).toEqual(['artifactMap']);
    draws.answer({});
    expect(await surface).toMatchObject({ ok: true });
  });
  it('ends a long job when a newer comes', async () => {
    const c = client();
    const first = c.askSlow('regularity', 'regularity', spec, 20);
    const second = c.askSlow('regularity', 'regularity', spec, 20);
    expect(await first).toBe(superseded);
    expect(FakeWorker.all[1]!.ended).toBe(true);
    FakeWorker.all[2]!.answer({ c1: 'yes' });
    expect(await second).toMatchObject({ result: { c1: 'yes' } });
  });
  it('waits with a long job until the slider rests', async () => {
    FakeWorker.all = [];
    const c = new Client(() => new FakeWorker() as unknown as Worker, 20);
    const steps = [1, 2, 3].map((seconds) => c.askSlow('regularity', 'regularity', spec, seconds));
    expect(await Promise.all(steps.slice(0, 2))).toEqual([superseded, superseded]);
    expect(FakeWorker.all).toHaveLength(1);
    await new Promise((resolve) => setTimeout(resolve, 60));
    expect(FakeWorker.all[1]!.asked.map((a) => a.args[1])).toEqual([3]);
  });
  it('replaces a core that stopped', async () => {
    const c = client();
    const first = c.ask('eigen', 'eigen', spec, 3);
    FakeWorker.all[1]!.tell({ id: 1, stopped: 'unreachable' });
    expect(await first).toMatchObject({ ok: false });
    const second = c.ask('eigen', 'eigen', spec, 3);
    FakeWorker.all[2]!.answer({ valence: 3 });
    expect(await second).toMatchObject({ ok: true });
  });
});
