// Draws the same pictures without WebGL, triangles and lines from the farthest to the nearest: on a 2D canvas, or as SVG.
import { Vector3 } from 'three/src/math/Vector3.js';
import { hexRgb, magnitudeColour, signColour, type Rgb } from '../ui/colours';
import { camera, isDark, type Body, type Colours, type Look, type Painter, type Picture, type Wires } from './picture';

/** Of a surface with more, every second one or fewer is drawn; whoever can asks for a coarser level. */
export const mostTriangles = 24_000;
/** Lines are cut into pieces, which are nearer or farther than a triangle each by itself. */
const pieces = 10;

/** What shapes are drawn with. */
interface Pen {
  polygon(xy: number[], colour: string): void;
  line(xy: number[], colour: string, width: number, opacity: number): void;
  square(x: number, y: number, size: number, colour: string): void;
}

class CanvasPen implements Pen {
  constructor(private to: CanvasRenderingContext2D) {}
  private trace(xy: number[]): void {
    this.to.beginPath();
    for (let i = 0; i < xy.length; i += 2) this.to[i === 0 ? 'moveTo' : 'lineTo'](xy[i]!, xy[i + 1]!);
  }
  polygon(xy: number[], colour: string): void {
    this.to.fillStyle = this.to.strokeStyle = colour;
    this.to.lineWidth = 1;
    this.trace(xy);
    this.to.closePath();
    this.to.fill();
    this.to.stroke();
  }
  line(xy: number[], colour: string, width: number, opacity: number): void {
    Object.assign(this.to, { strokeStyle: colour, lineWidth: width, globalAlpha: opacity });
    this.trace(xy);
    this.to.stroke();
    this.to.globalAlpha = 1;
  }
  square(x: number, y: number, size: number, colour: string): void {
    this.to.fillStyle = colour;
    this.to.fillRect(x - size / 2, y - size / 2, size, size);
  }
}

class SvgPen implements Pen {
  readonly parts: string[] = [];
  private path(xy: number[]): string {
    const at = (i: number): string => `${xy[i]!.toFixed(1)} ${xy[i + 1]!.toFixed(1)}`;
    let path = `M${at(0)}`;
    for (let i = 2; i < xy.length; i += 2) path += `L${at(i)}`;
    return path;
  }
  polygon(xy: number[], colour: string): void {
    this.parts.push(`<path d="${this.path(xy)}Z" fill="${colour}" stroke="${colour}"/>`);
  }
  line(xy: number[], colour: string, width: number, opacity: number): void {
    this.parts.push(`<path d="${this.path(xy)}" fill="none" stroke="${colour}" stroke-width="${width}" opacity="${opacity}"/>`);
  }
  square(x: number, y: number, size: number, colour: string): void {
    this.parts.push(`<rect x="${(x - size / 2).toFixed(1)}" y="${(y - size / 2).toFixed(1)}" width="${size}" height="${size}" fill="${colour}"/>`);
  }
}

type Shape = [depth: number, draw: () => void];

class Flat {
  private shapes: Shape[] = [];
  private matrix;
  private eye;

  constructor(picture: Picture, look: Look, private width: number, private height: number, private colours: Colours, private pen: Pen) {
    const eye = camera(picture, look, width / height);
    this.eye = eye.position;
    this.matrix = eye.projectionMatrix.clone().multiply(eye.matrixWorldInverse);
    if (picture.body) this.body(picture.body);
    for (const wires of picture.wires) this.wires(wires);
    this.shapes.sort((a, b) => b[0] - a[0]);
    for (const [, draw] of this.shapes) draw();
    for (const dots of picture.dots) {
      const p = this.project(dots.positions);
      const net = dots.kind === 'net';
      for (let i = 0; i + 2 < p.length; i += 3) pen.square(p[i]!, p[i + 1]!, net ? 3 : 7, net ? colours.net : colours.accent);
    }
  }

  private project(points: Float32Array): Float32Array {
    const at = new Vector3();
    const out = new Float32Array(points.length);
    for (let i = 0; i + 2 < points.length; i += 3) {
      at.set(points[i]!, points[i + 1]!, points[i + 2]!).applyMatrix4(this.matrix);
      out.set([(at.x * 0.5 + 0.5) * this.width, (0.5 - at.y * 0.5) * this.height, at.z], i);
    }
    return out;
  }

  private body(body: Body): void {
    const p = this.project(body.positions);
    const count = body.triangles.length / 3;
    const surface = hexRgb(this.colours.surface);
    const back = hexRgb(this.colours.back);
    for (let t = 0; t < count; t += Math.max(1, Math.ceil(count / mostTriangles))) {
      const [a, b, c] = [0, 1, 2].map((i) => 3 * body.triangles[3 * t + i]!) as [number, number, number];
      const depth = (p[a + 2]! + p[b + 2]! + p[c + 2]!) / 3;
      if (!Number.isFinite(depth)) continue;
      const colour = hex(this.colour(body, t, surface, back));
      this.shapes.push([depth, () => this.pen.polygon([p[a]!, p[a + 1]!, p[b]!, p[b + 1]!, p[c]!, p[c + 1]!], colour)]);
    }
  }

  private wires(wires: Wires): void {
    const p = this.project(wires.positions);
    const quiet = wires.kind === 'net' || wires.kind === 'seam';
    const colour = quiet ? (wires.kind === 'seam' ? this.colours.ink : this.colours.net) : this.colours.accent;
    const width = wires.kind === 'sharp' ? 2.5 : 1;
    const opacity = wires.kind === 'seam' ? 0.35 : 0.75;
    const cuts = wires.kind === 'seam' ? 1 : pieces;
    for (let i = 0; i + 1 < wires.segments.length; i += 2) {
      const [a, b] = [3 * wires.segments[i]!, 3 * wires.segments[i + 1]!];
      if (!Number.isFinite(p[a]! + p[b]!)) continue;
      const at = (c: number, t: number): number => p[a + c]! + t * (p[b + c]! - p[a + c]!);
      for (let k = 0; k < cuts; ++k) {
        const [t, u] = [k / cuts, (k + 1) / cuts];
        // what lies on a surface is nearer than the surface
        this.shapes.push([at(2, (t + u) / 2) - 2e-4, () => this.pen.line([at(0, t), at(1, t), at(0, u), at(1, u)], colour, width, opacity)]);
      }
    }
  }

  private colour(body: Body, t: number, surface: Rgb, back: Rgb): Rgb {
    const v = body.triangles[3 * t]!;
    const n = new Vector3(body.normals[3 * v], body.normals[3 * v + 1], body.normals[3 * v + 2]);
    const e = this.eye.clone().sub(new Vector3(body.positions[3 * v], body.positions[3 * v + 1], body.positions[3 * v + 2])).normalize();
    const inside = n.dot(e) < 0;
    if (inside) n.negate();
    if (body.shade === 'normals') return [n.x, n.y, n.z].map((x) => Math.round(127 + 127 * x)) as Rgb;
    let base = inside ? back : surface;
    if (body.shade === 'reflection') {
      const r = e.clone().negate().reflect(n);
      base = Math.abs(((9 * Math.atan2(r.x, r.y + 1.35)) % 1 + 1) % 1 - 0.5) > 0.25 ? [245, 243, 236] : [28, 30, 34];
    } else if (body.shade === 'texture' && body.texture && body.texture.pattern !== 'none') {
      const uv = body.texture.coordinates;
      const mean = (c: number): number => (uv[6 * t + c]! + uv[6 * t + 2 + c]! + uv[6 * t + 4 + c]!) / 3;
      if (isDark(body.texture.pattern, mean(0), mean(1))) base = base.map((c) => Math.round(c * 0.55)) as Rgb;
    } else if (body.values && body.range) {
      const s = (body.values[v]! - body.range[0]) / (body.range[1] - body.range[0]);
      base = Number.isNaN(s) ? [128, 128, 128] : body.shade === 'distance' ? magnitudeColour(s) : signColour(2 * s - 1);
    }
    const light = 0.42 + 0.6 * Math.max(0, n.dot(new Vector3(-0.45, 0.75, 0.6).normalize()));
    return base.map((c) => Math.min(255, Math.round(c * light))) as Rgb;
  }
}

const hex = (rgb: Rgb): string => `#${rgb.map((c) => c.toString(16).padStart(2, '0')).join('')}`;

export class FlatPainter implements Painter {
  readonly name = 'canvas';

  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): boolean {
    const to = canvas.getContext('2d')!;
    to.clearRect(0, 0, canvas.width, canvas.height);
    new Flat(picture, look, canvas.width, canvas.height, colours, new CanvasPen(to));
    return true;
  }
}

const escaped = (text: string): string => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

/** The picture as an SVG file of polygons and lines. */
export function flatSvg(picture: Picture, look: Look, width: number, height: number, colours: Colours, title: string): string {
  const pen = new SvgPen();
  new Flat(picture, look, width, height, colours, pen);
  const [w, h] = [Math.round(width), Math.round(height)];
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${w} ${h}" width="${w}" height="${h}" stroke-linejoin="round" stroke-width="0.6">\n` +
    `<title>${escaped(title)}</title>\n${pen.parts.join('\n')}\n</svg>\n`;
}
