// What a click on an edge or a vertex of the control mesh offers: how sharp it is.
import type { App } from '../app';
import type { State } from '../state';
import { h, say, show, slider } from '../ui/dom';
import type { Element } from './pane';

export function sharpnessPanel(app: App) {
  const { store } = app;
  let chosen: Element | undefined;
  const key = (): string => `${chosen!.kind}${chosen!.index}`;
  const title = h('strong', {});
  const put = (value: number): void => {
    if (!chosen) return;
    const sharp = { ...store.now.sharp };
    if (value > 0) sharp[key()] = value;
    else delete sharp[key()];
    store.set({ sharp });
  };
  const sharpness = slider({ label: 'Sharpness', name: 'sharpness', min: 0, max: 10, step: 0.25, change: put,
    text: (value) => (value >= 10 ? '∞' : String(value)) });
  const back = h('button', { type: 'button', class: 'quiet', onclick: () => {
    const moved = { ...store.now.moved };
    if (chosen) delete moved[chosen.index];
    store.set({ moved });
  } }, 'Move back');
  const close = h('button', { type: 'button', class: 'quiet', 'aria-label': 'Close', onclick: () => self.closed() }, '×');
  const element = h('div', { class: 'popover', 'data-test': 'sharpness', hidden: true }, h('header', {}, title, close), sharpness.element, back);
  const self = {
    element,
    closed: (): void => {},
    choose(next: Element | undefined): void {
      chosen = next;
      show(element, next !== undefined);
      if (next) say(title, `${next.kind === 'v' ? 'Vertex' : 'Edge'} ${next.index}`);
      self.update(store.now);
    },
    update(state: State): void {
      if (!chosen) return;
      sharpness.set(state.sharp[key()] ?? 0);
      show(back, chosen.kind === 'v' && chosen.index in state.moved);
    },
  };
  return self;
}
