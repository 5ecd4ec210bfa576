// Which painter this browser can have. The one that uses WebGL is read while the core works; until then it draws nothing.
import { FlatPainter } from './flat_painter';
import type { Colours, Look, Painter, Picture } from './picture';

class ComingPainter implements Painter {
  readonly name = 'webgl';
  private made?: Painter;

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext, ready: () => void) {
    limnStart.painter().then(({ GlPainter }) => {
      this.made = new GlPainter(canvas, context);
      ready();
    }, (error: unknown) => setTimeout(() => { throw error; }));
  }

  draw(picture: Picture, look: Look, canvas: HTMLCanvasElement, colours: Colours): boolean {
    return this.made?.draw(picture, look, canvas, colours) ?? false;
  }
}

/** `ready` is called where it could not draw at once, and now can. Null: this browser draws nothing. */
export function painterFor(ready: () => void): Painter | null {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true, preserveDrawingBuffer: true });
  if (context) return new ComingPainter(canvas, context, ready);
  return document.createElement('canvas').getContext('2d') && new FlatPainter();
}
