// Which painter this browser can have. The one that uses WebGL is read while the core works; until then small pictures,
// as the one that the page comes with, are drawn without it.
import { FlatPainter } from './flat_painter';
import type { Colours, Look, Painter, Picture } from './picture';

/** Triangles that take no longer to draw without WebGL than it takes to come. */
const few = 2000;

class ComingPainter implements Painter {
  readonly name = 'webgl';
  private meanwhile = new FlatPainter();
  /** Drawn by the processor: many small polygons are slow where a graphics processor is only imitated. */
  private scratch = document.createElement('canvas');
  private made?: Painter;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, ready: () => void) {
    limnStart.painter().then(({ GlPainter }) => {
      this.made = new GlPainter(canvas, context);
      ready();
    }, (error: unknown) => setTimeout(() => { throw error; }));
  }

  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): boolean {
    if (this.made) return this.made.draw(picture, look, canvas, colours);
    if ((picture.body?.triangles.length ?? 0) > 3 * few) return false;
    const { width, height } = canvas;
    Object.assign(this.scratch, { width, height });
    this.scratch.getContext('2d', { willReadFrequently: true });
    this.meanwhile.draw(picture, look, this.scratch, colours);
    const to = canvas.getContext('2d')!;
    to.clearRect(0, 0, width, height);
    to.drawImage(this.scratch, 0, 0);
    return true;
  }
}

/** `ready` is called where it could not draw at once, and now can. Null: this browser draws nothing. */
export function painterFor(ready: () => void): Painter | null {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, preserveDrawingBuffer: true });
  if (context) return new ComingPainter(canvas, context, ready);
  return document.createElement('canvas').getContext('2d') && new FlatPainter();
}
