// Scales of colour: one for signs (blue, neutral, red), one for magnitudes (paper to accent to ink).
export type Rgb = [number, number, number];

const signs: Rgb[] = [[33, 74, 135], [92, 140, 193], [168, 197, 222], [238, 235, 229], [236, 178, 148], [210, 105, 76], [140, 34, 40]];
const magnitudes: Rgb[] = [[250, 246, 238], [250, 221, 178], [244, 178, 112], [225, 118, 66], [181, 62, 45], [116, 26, 44], [52, 12, 38]];

function along(scale: Rgb[], t: number): Rgb {
  const x = Math.max(0, Math.min(1, t)) * (scale.length - 1);
  const i = Math.min(Math.floor(x), scale.length - 2);
  const [a, b] = [scale[i]!, scale[i + 1]!];
  return [0, 1, 2].map((c) => Math.round(a[c]! + (x - i) * (b[c]! - a[c]!))) as Rgb;
}
export const signColour = (t: number): Rgb => along(signs, (t + 1) / 2);
export const magnitudeColour = (t: number): Rgb => along(magnitudes, t);

/** A strip of 256 colours, as bytes. */
export function strip(signed: boolean): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(256 * 4);
  for (let i = 0; i < 256; ++i)
    bytes.set([...(signed ? signColour(i / 127.5 - 1) : magnitudeColour(i / 255)), 255], 4 * i);
  return bytes;
}
/** The same as a gradient of CSS. */
export function gradient(signed: boolean): string {
  const list = (signed ? signs : magnitudes).map((c) => `rgb(${c.join(',')})`);
  return `linear-gradient(90deg, ${list.join(', ')})`;
}

export function hexRgb(text: string): Rgb {
  const match = /^#([0-9a-f]{6})$/i.exec(text.trim());
  const value = match ? parseInt(match[1]!, 16) : 0x808080;
  return [value >> 16, (value >> 8) & 255, value & 255];
}
