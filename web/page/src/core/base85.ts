// Bytes as text: five characters for four bytes, a quarter longer, where base64 is a third. The characters are those from #
// to x but <, so that the text can stand in a script element; the first one says how many bytes the last group lacks.
const letter = (digit: number): number => digit + (digit < 25 ? 35 : 36);
const digit = (text: string, i: number): number => {
  const code = text.charCodeAt(i);
  return code - (code < 60 ? 35 : 36);
};

export function toBase85(bytes: Uint8Array): string {
  const groups = Math.ceil(bytes.length / 4);
  const out = new Uint8Array(5 * groups + 1);
  out[0] = letter(4 * groups - bytes.length);
  for (let g = 0; g < groups; ++g) {
    let value = 0;
    for (let i = 0; i < 4; ++i) value = 256 * value + (bytes[4 * g + i] ?? 0);
    for (let i = 5; i > 0; --i, value = Math.floor(value / 85)) out[5 * g + i] = letter(value % 85);
  }
  return new TextDecoder('latin1').decode(out);
}

export function fromBase85(text: string): Uint8Array<ArrayBuffer> {
  const groups = (text.length - 1) / 5;
  const bytes = new Uint8Array(4 * groups);
  for (let g = 0; g < groups; ++g) {
    let value = 0;
    for (let i = 1; i <= 5; ++i) value = 85 * value + digit(text, 5 * g + i);
    bytes[4 * g] = value >>> 24;
    bytes[4 * g + 1] = value >>> 16;
    bytes[4 * g + 2] = value >>> 8;
    bytes[4 * g + 3] = value;
  }
  return bytes.subarray(0, bytes.length - digit(text, 0));
}
