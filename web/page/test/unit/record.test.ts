// What the record's LaTeX holds, and that all of it can be typeset.
import katex from 'katex';
import { describe, expect, it } from 'vitest';
import { latexParts } from '../../src/views/record';

const fragment = `% loop: mask
\\[
\\frac{1}{16}\\left[\\begin{array}{ccc}
   & 1 & 2 \\\\
  1 & 10 &
\\end{array}\\right]
\\]
% factors: direction (1, 0) 2 times
% magnitudes of the signal and the artifacts, in the limit; $x = \\cos 2\\pi f_1$
\\begin{align*}
  S &= \\frac{1}{2}x \\\\
  Y_1 &= x^2
\\end{align*}
`;

describe('a fragment of LaTeX', () => {
  it('is its displayed formulas, each with the remark before it', () => {
    const parts = latexParts(fragment);
    expect(parts.map((part) => part.title)).toEqual(['loop: mask', 'magnitudes of the signal and the artifacts, in the limit; $x = \\cos 2\\pi f_1$']);
    expect(parts[0]!.latex).toContain('\\begin{array}');
    for (const { latex } of parts) expect(katex.renderToString(latex, { output: 'mathml', throwOnError: true, strict: 'ignore' })).toContain('<math');
  });
  it('that ends too early has no half formulas', () => {
    expect(latexParts('% a\n\\[\nx')).toEqual([]);
    expect(latexParts('')).toEqual([]);
  });
});
