import { expect, test } from 'vitest';
import { fromBase85, toBase85 } from '../../src/core/base85';

test('bytes come back, whatever their number', () => {
  for (let length = 0; length < 70; ++length) {
    const bytes = Uint8Array.from({ length }, (_, i) => (i % 7 === 0 ? 255 : (i * 151 + length * 29) % 256));
    expect(fromBase85(toBase85(bytes))).toEqual(bytes);
  }
  expect(fromBase85(toBase85(new Uint8Array(9).fill(255)))).toEqual(new Uint8Array(9).fill(255));
});

test('the text can stand in a script element', () => {
  const bytes = Uint8Array.from({ length: 40_000 }, (_, i) => (i * i * 31 + (i >> 3)) % 256);
  expect(toBase85(bytes)).toMatch(/^[#-;=-x]*$/);
  expect(toBase85(bytes).length).toBe(50_001);
});
