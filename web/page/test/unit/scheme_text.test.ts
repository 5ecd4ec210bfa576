import { readdirSync, readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { fraction, partsOfOne, withDefaults } from '../../src/scheme_text';

const folder = resolve(__dirname, '../../../../schemes');

describe('defaults in a scheme file', () => {
  it('are written into every shipped file that has parameters, and nothing else changes', () => {
    let found = 0;
    for (const name of readdirSync(folder)) {
      const text = readFileSync(resolve(folder, name), 'utf8');
      for (const [, parameter] of text.matchAll(/^\[parameter\.(\w+)\]/gm)) {
        const changed = withDefaults(text, { [parameter!]: '77/78' });
        const lines = changed.split('\n').filter((line, i) => line !== text.split('\n')[i]);
        expect(lines, `${name} ${parameter}`).toHaveLength(1);
        expect(lines[0]).toMatch(/^default\s*=\s*"77\/78"/);
        ++found;
      }
    }
    expect(found).toBeGreaterThan(5);
  });
  it('take inline tables, and no text that could break a file', () => {
    expect(withDefaults('parameter.a = { default = "1", range = ["0", "1"] }', { a: '1/2' })).toBe('parameter.a = { default = "1/2", range = ["0", "1"] }');
    expect(withDefaults('[parameter.a]\ndefault = "1"\n', { a: '"\n' })).toBe('[parameter.a]\ndefault = "1"\n');
  });
});

describe('steps of sliders', () => {
  it('are fractions in lowest terms', () => {
    expect(fraction(120, 240)).toBe('1/2');
    expect(fraction(-3, 48)).toBe('-1/16');
    expect(fraction(480, 240)).toBe('2');
    expect(fraction(0, 240)).toBe('0');
  });
  it('are at least 200 over a range', () => {
    for (const width of [1e-3, 0.125, 1, 2, 50, 1000]) expect(partsOfOne(0, width, false) * width).toBeGreaterThanOrEqual(200);
    expect(partsOfOne(0, 9, true)).toBe(1);
  });
});
