// Draws the same pictures on a 2D canvas, where a browser has no WebGL: triangles from the farthest to the nearest.
import { Vector3 } from 'three';
import { hexRgb, magnitudeColour, signColour, type Rgb } from '../ui/colours';
import type { Painter } from './gl_painter';
import { camera, type Body, type Colours, type Look, type Picture } from './picture';

const most = 24_000;

export class FlatPainter implements Painter {
  readonly name = 'canvas';

  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): void {
    const to = canvas.getContext('2d')!;
    const { width, height } = canvas;
    to.clearRect(0, 0, width, height);
    const eye = camera(picture, look, width / height);
    const matrix = eye.projectionMatrix.clone().multiply(eye.matrixWorldInverse);
    const at = new Vector3();
    const project = (points: Float32Array): Float32Array => {
      const out = new Float32Array(points.length);
      for (let i = 0; i + 2 < points.length; i += 3) {
        at.set(points[i]!, points[i + 1]!, points[i + 2]!).applyMatrix4(matrix);
        out.set([(at.x * 0.5 + 0.5) * width, (0.5 - at.y * 0.5) * height, at.z], i);
      }
      return out;
    };
    if (picture.body) this.body(picture.body, project(picture.body.positions), eye.position, to, colours);
    for (const wires of picture.wires) {
      const p = project(wires.positions);
      to.strokeStyle = wires.kind === 'net' || wires.kind === 'seam' ? colours.net : colours.accent;
      to.lineWidth = wires.kind === 'sharp' ? 2.5 : 1;
      to.globalAlpha = wires.kind === 'seam' ? 0.3 : 0.7;
      to.beginPath();
      for (let i = 0; i + 1 < wires.segments.length; i += 2) {
        const [a, b] = [3 * wires.segments[i]!, 3 * wires.segments[i + 1]!];
        to.moveTo(p[a]!, p[a + 1]!);
        to.lineTo(p[b]!, p[b + 1]!);
      }
      to.stroke();
    }
    to.globalAlpha = 1;
    for (const dots of picture.dots) {
      const p = project(dots.positions);
      const size = dots.kind === 'net' ? 3 : 7;
      to.fillStyle = dots.kind === 'net' ? colours.net : colours.accent;
      for (let i = 0; i + 2 < p.length; i += 3) to.fillRect(p[i]! - size / 2, p[i + 1]! - size / 2, size, size);
    }
  }

  private body(body: Body, p: Float32Array, eye: Vector3, to: CanvasRenderingContext2D, colours: Colours): void {
    const count = body.triangles.length / 3;
    const step = Math.max(1, Math.ceil(count / most));
    const order: [number, number][] = [];
    for (let t = 0; t < count; t += step) {
      const [a, b, c] = [0, 1, 2].map((i) => 3 * body.triangles[3 * t + i]!) as [number, number, number];
      order.push([p[a + 2]! + p[b + 2]! + p[c + 2]!, t]);
    }
    order.sort((a, b) => b[0] - a[0]);
    const surface = hexRgb(colours.surface);
    for (const [, t] of order) {
      const a = body.triangles[3 * t]!;
      const style = `rgb(${this.colour(body, a, eye, surface).join(',')})`;
      to.fillStyle = to.strokeStyle = style;
      to.beginPath();
      for (let i = 0; i < 3; ++i) {
        const v = 3 * body.triangles[3 * t + i]!;
        if (i === 0) to.moveTo(p[v]!, p[v + 1]!);
        else to.lineTo(p[v]!, p[v + 1]!);
      }
      to.closePath();
      to.fill();
      to.stroke();
    }
  }

  private colour(body: Body, v: number, eye: Vector3, surface: Rgb): Rgb {
    const n = new Vector3(body.normals[3 * v], body.normals[3 * v + 1], body.normals[3 * v + 2]);
    const e = eye.clone().sub(new Vector3(body.positions[3 * v], body.positions[3 * v + 1], body.positions[3 * v + 2])).normalize();
    if (n.dot(e) < 0) n.negate();
    if (body.shade === 'normals') return [n.x, n.y, n.z].map((x) => Math.round(127 + 127 * x)) as Rgb;
    let base = surface;
    if (body.shade === 'reflection') {
      const r = e.clone().negate().reflect(n);
      base = Math.abs(((9 * Math.atan2(r.x, r.y + 1.35)) % 1 + 1) % 1 - 0.5) > 0.25 ? [245, 243, 236] : [28, 30, 34];
    } else if (body.values && body.range) {
      const t = (body.values[v]! - body.range[0]) / (body.range[1] - body.range[0]);
      base = body.shade === 'distance' ? magnitudeColour(t) : signColour(2 * t - 1);
    }
    const light = 0.42 + 0.6 * Math.max(0, n.dot(new Vector3(-0.45, 0.75, 0.6).normalize()));
    return base.map((c) => Math.min(255, Math.round(c * light))) as Rgb;
  }
}
