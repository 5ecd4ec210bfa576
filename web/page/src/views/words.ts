// Words of verdicts, as classes of style; numbers of exponents, as text.
export function verdictWord(word: string): string {
  if (word === 'yes' || word === 'bounded' || word === 'flat' || word === 'proved') return 'good';
  if (word === 'no' || word === 'unbounded' || word === 'refuted') return 'bad';
  return 'open';
}

export function holder(bracket: { lower: number | null; upper: number | null; exact?: string | null }): string {
  const down = (x: number): string => (Math.floor(x * 1e4) / 1e4).toFixed(4);
  const up = (x: number): string => (Math.ceil(x * 1e4) / 1e4).toFixed(4);
  if (bracket.exact) return /^\d+$/.test(bracket.exact) ? bracket.exact : `${bracket.exact} = ${(bracket.lower ?? NaN).toFixed(6)}`;
  if (bracket.lower === null) return '–';
  return bracket.upper === null ? `at least ${down(bracket.lower)}` : `[${down(bracket.lower)}, ${up(bracket.upper)}]`;
}
