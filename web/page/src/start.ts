// What the loader hands to the page's program.
export interface Start {
  /** For the Opening (core/opening.ts). */
  opening: Promise<ArrayBuffer>;
  /** A worker with the core in it, or on its way there. The first one was begun before the program was read. */
  spawn(): Worker;
  /** Draws with WebGL: most of the page's code, which is read while the core works on the first surface. */
  painter(): Promise<typeof import('./space/gl_painter')>;
  /** What the first picture does without. Read once, when first asked for. */
  later(): Promise<typeof import('./later')>;
}

declare global {
  var limnStart: Start;
}
