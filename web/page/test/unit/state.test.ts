import { describe, expect, it } from 'vitest';
import { command, fromFragment, initial, packText, toFragment, unpackText, type State } from '../../src/state';

const odd: State = {
  ...initial, scheme: 'laplacian-butterfly', text: 'name = "mine"\n# äöü + = & # %\n', parameters: { b: '3/16', a: 'cos(2*pi/n) + 1' }, other: 'loop',
  otherParameters: { w: '1/16' }, mesh: 'cube & co.obj', obj: 'v 0 0 0\n', repair: 'repair', levels: 3, limit: false, shade: 'distance', net: false,
  moved: { 3: [0.25, -1, 2.5] }, sharp: { e12: 2.5, v4: 10 }, valence: 9, frequency: [0.125, -0.3], camera: [-90, 45.5, 3.25], focus: 'artifacts',
  sweep: 'b', theme: 'dark', projector: true, tour: 4,
};

/** A small generator, so that a failure can be repeated. */
function random(seed: number): () => number {
  return () => ((seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0) / 2 ** 32);
}

describe('the fragment', () => {
  it('restores every part of a state', () => {
    expect(fromFragment(`#${toFragment(odd)}`)).toEqual(odd);
    for (const key of Object.keys(odd) as (keyof State)[]) expect(odd[key], key).not.toEqual(initial[key]);
  });
  it('is short where nothing differs', () => {
    expect(toFragment(initial)).toBe('scheme=loop');
    expect(fromFragment('')).toEqual(initial);
  });
  it('can be typed by hand', () => {
    const state = fromFragment('#scheme=laplacian-loop&p=a=1/8&valence=7');
    expect([state.scheme, state.parameters, state.valence]).toEqual(['laplacian-loop', { a: '1/8' }, 7]);
  });
  it('falls back where it is wrong', () => {
    const state = fromFragment('#scheme=&valence=-3&levels=1e9&f=nan,1&camera=1&shade=x&focus=y&edits=m1=a;e=;v2=-1;q&text=%%%&obj=AAAA&p=__proto__=1&tour=1.5');
    expect({ ...state, text: null, obj: null }).toEqual(initial);
  });
  it('never throws and always gives a state that it can write again', () => {
    const next = random(7);
    const fragment = toFragment(odd);
    for (let i = 0; i < 400; ++i) {
      let text = fragment;
      for (let k = 0; k < 1 + 4 * next(); ++k) {
        const at = Math.floor(next() * text.length);
        text = text.slice(0, at) + String.fromCharCode(32 + Math.floor(next() * 96)) + text.slice(at + Math.floor(next() * 8));
      }
      const state = fromFragment(text);
      expect(toFragment(fromFragment(toFragment(state)))).toEqual(toFragment(state));
      expect(state.frequency.every(Number.isFinite) && state.camera.every(Number.isFinite)).toBe(true);
    }
  });
  it('does not inflate a bomb', () => {
    expect(unpackText(packText('x'.repeat(1000)))).toBe('x'.repeat(1000));
    expect(unpackText(packText('x'.repeat(5_000_000)))).toBeNull();
  });
});

describe('the command', () => {
  it('names the scheme, its parameters and what is looked at', () => {
    expect(command({ ...initial, focus: 'vertex', parameters: { a: '1/8' } }, 'm.obj')).toBe('limn eigen loop -p a=1/8 --valence 7');
    expect(command({ ...initial, levels: 3 }, 'my mesh.obj')).toBe("limn refine 'my mesh.obj' -s loop -n 3 --limit --normals -o surface.ply");
    expect(command({ ...initial, other: 'laplacian-loop', otherParameters: { a: '1/4' } }, 'm.obj')).toBe('limn compare loop laplacian-loop:a=1/4 --mesh m.obj -o both.png');
    expect(command({ ...initial, focus: 'artifacts' }, '')).toBe('limn artifacts loop --frequency 0.2,0.1');
    expect(command({ ...initial, text: 'x', focus: 'smoothness', parameters: { a: "n*'" } }, '')).toBe("limn regularity ./mine.toml -p 'a=n*'\\'''");
  });
});
