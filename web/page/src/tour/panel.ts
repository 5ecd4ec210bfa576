// The tour's panel: where one is, what one sees, and the way on.
import type { App } from '../app';
import type { State } from '../state';
import { h, say, show } from '../ui/dom';
import { stateOf, steps } from './steps';

export function tourPanel(app: App) {
  const { store } = app;
  const go = (index: number): void => {
    if (index >= 0 && index < steps.length) store.set(stateOf(index, store.now));
    else store.set({ tour: -1 });
  };
  const paper = h('p', { class: 'paper' });
  const title = h('h2', {});
  const text = h('p', {});
  const count = h('span', { class: 'count' });
  const back = h('button', { type: 'button', class: 'quiet', onclick: () => go(store.now.tour - 1) }, 'Back');
  const next = h('button', { type: 'button', class: 'main', 'data-test': 'tour-next', onclick: () => go(store.now.tour + 1) }, 'Next');
  const again = h('button', { type: 'button', class: 'quiet', title: 'The figure as the tour shows it', onclick: () => go(store.now.tour) }, 'Reset figure');
  const end = h('button', { type: 'button', class: 'quiet', 'aria-label': 'End the tour', onclick: () => store.set({ tour: -1 }) }, '×');
  const element = h('aside', { class: 'tour', 'data-test': 'tour', 'aria-label': 'Guided tour', 'aria-live': 'polite', hidden: true },
    h('header', {}, paper, end), title, text, h('footer', {}, count, again, back, next));
  return {
    element, go,
    update(state: State): void {
      const step = steps[state.tour];
      show(element, step !== undefined);
      document.body.classList.toggle('touring', step !== undefined);
      if (!step) return;
      say(paper, `${step.paper}, ${step.figure}`);
      say(title, step.title);
      say(text, step.text);
      say(count, `${state.tour + 1} / ${steps.length}`);
      back.disabled = state.tour === 0;
      say(next, state.tour + 1 === steps.length ? 'End' : 'Next');
    },
  };
}
