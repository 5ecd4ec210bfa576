// The text of a scheme file, as text: values written into it, and the steps of sliders as fractions.

/** The text with these defaults of its parameters, so that a copied file is the scheme that is shown. */
export function withDefaults(text: string, parameters: Record<string, string>): string {
  for (const [name, value] of Object.entries(parameters)) {
    if (!/^\w+$/.test(name) || /["\\\n]/.test(value)) continue;
    const section = new RegExp(`(\\[parameter\\.${name}\\][^\\[]*?\\bdefault\\s*=\\s*)(?:"[^"\\n]*"|[-+.\\w]+)`);
    const inline = new RegExp(`(\\bparameter\\.${name}\\s*=\\s*\\{[^}\\n]*?\\bdefault\\s*=\\s*)(?:"[^"\\n]*"|[-+.\\w]+)`);
    const table = new RegExp(`(\\[parameter\\][^\\[]*?\\n\\s*${name}\\s*=\\s*\\{[^}\\n]*?\\bdefault\\s*=\\s*)(?:"[^"\\n]*"|[-+.\\w]+)`);
    for (const pattern of [section, inline, table])
      if (pattern.test(text)) {
        text = text.replace(pattern, (_all, before: string) => `${before}"${value}"`);
        break;
      }
  }
  return text;
}

/** How many parts of one a slider over this range steps by: a number with many divisors, so that values are short fractions. */
export function partsOfOne(min: number, max: number, integer: boolean): number {
  if (integer) return 1;
  const width = max - min;
  for (const parts of [4, 16, 48, 240, 960, 4800, 48000]) if (parts * width >= 200) return parts;
  return 480000;
}

export function fraction(numerator: number, denominator: number): string {
  const gcd = (a: number, b: number): number => (b === 0 ? a : gcd(b, a % b));
  const d = gcd(Math.abs(numerator), denominator) || 1;
  return denominator / d === 1 ? String(numerator / d) : `${numerator / d}/${denominator / d}`;
}
