// Turns what a hand does on a canvas into a look: drag to turn, wheel or two fingers to come nearer.
import type { Look } from './picture';

export interface Hand {
  /** Called first; true where what lies under the pointer is taken (a vertex), and no turn begins. */
  take(x: number, y: number): boolean;
  drag(x: number, y: number): void;
  /** Ended; `still` where the pointer did not move, so a click. */
  drop(x: number, y: number, still: boolean, taken: boolean): void;
  hover(x: number, y: number): void;
}

export function orbit(canvas: HTMLCanvasElement, look: () => Look, set: (look: Look) => void, hand?: Hand): void {
  const down = new Map<number, [number, number]>();
  let begin: [number, number] = [0, 0];
  let taken = false;
  let spread = 0;
  const at = (event: PointerEvent): [number, number] => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const distance = (): number => {
    const [a, b] = [...down.values()];
    return a && b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, at(event));
    if (down.size === 1) {
      begin = at(event);
      taken = hand?.take(...begin) ?? false;
    } else spread = distance();
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = down.get(event.pointerId);
    const now = at(event);
    if (!before) return hand?.hover(...now);
    down.set(event.pointerId, now);
    if (down.size === 2) {
      const wide = distance();
      if (spread > 0 && wide > 0) set(clamp({ ...look(), distance: (look().distance * spread) / wide }));
      spread = wide;
    } else if (taken) hand!.drag(...now);
    else {
      const l = look();
      set(clamp({ ...l, azimuth: l.azimuth - (now[0] - before[0]) * 0.4, height: l.height + (now[1] - before[1]) * 0.4 }));
    }
  });
  const up = (event: PointerEvent): void => {
    if (!down.delete(event.pointerId)) return;
    const now = at(event);
    if (down.size === 0 && event.type === 'pointerup')
      hand?.drop(...now, Math.hypot(now[0] - begin[0], now[1] - begin[1]) < 4, taken);
    if (down.size === 0) taken = false;
  };
  canvas.addEventListener('pointerup', up);
  canvas.addEventListener('pointercancel', up);
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    set(clamp({ ...look(), distance: look().distance * Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.002) }));
  }, { passive: false });
  canvas.addEventListener('keydown', (event) => {
    const step = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, 6], ArrowDown: [0, -6] }[event.key];
    const zoom = { '+': 0.9, '=': 0.9, '-': 1 / 0.9 }[event.key];
    if (!step && !zoom) return;
    event.preventDefault();
    const l = look();
    set(clamp({ azimuth: l.azimuth + (step?.[0] ?? 0), height: l.height + (step?.[1] ?? 0), distance: l.distance * (zoom ?? 1) }));
  });
}

function clamp(look: Look): Look {
  return {
    azimuth: ((((look.azimuth + 180) % 360) + 360) % 360) - 180,
    height: Math.max(-89, Math.min(89, look.height)),
    distance: Math.max(0.4, Math.min(30, look.distance)),
  };
}
