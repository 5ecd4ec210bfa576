// Smoothness on the regular lattice, and what a report's record adds: closed formulas and certificates.
import type { App, GoodScheme, Model, View } from '../app';
import { superseded } from '../core/client';
import type { Regularity } from '../core/results';
import { command, type State } from '../state';
import { copy, h, say, show } from '../ui/dom';
import { recordPart } from './record';
import { holder, verdictWord } from './words';

const seconds = 20;
const order = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];

export function smoothnessView(app: App): View {
  const exponent = h('p', { class: 'big', 'data-value': 'holder' });
  const exponentB = h('p', { class: 'big second', 'data-value': 'holder-b' });
  const how = h('p', { class: 'how' });
  const verdicts = h('dl', { class: 'verdicts', 'data-test': 'smoothness' });
  const progress = h('p', { class: 'progress', hidden: true, role: 'status' });
  const note = h('p', { class: 'note', hidden: true });
  const native = h('p', { class: 'how' });
  const record = h('div', { class: 'record', 'data-test': 'record' });
  const element = h('section', { class: 'card', id: 'smoothness', 'data-view': 'smoothness', 'aria-label': 'Smoothness' },
    h('header', {}, h('h2', {}, 'Smoothness'), progress), note,
    h('div', { class: 'body' }, h('h3', {}, 'Hölder exponent on the regular lattice'), h('div', { class: 'exponents' }, exponent, exponentB), how, verdicts, native, record));
  let asked = '';
  let askedB = '';
  let since = 0;
  let timer = 0;
  const busy = (on: boolean): void => {
    clearInterval(timer);
    show(progress, on);
    if (!on) return;
    since = performance.now();
    const tick = (): void => say(progress, `searching a proof, ${Math.round((performance.now() - since) / 1000)} s of at most ${seconds}`);
    tick();
    timer = window.setInterval(tick, 1000);
  };

  async function ask(scheme: GoodScheme): Promise<void> {
    busy(true);
    element.classList.add('stale');
    const answer = await app.client.askSlow('regularity', 'regularity', scheme.spec, seconds);
    if (answer === superseded) return;
    busy(false);
    element.classList.toggle('stale', !answer.ok);
    show(note, !answer.ok);
    if (!answer.ok) return say(note, answer.errors.map((e) => e.message).join(' · '));
    fill(answer.result);
  }
  function fill(found: Regularity): void {
    say(exponent, holder(found.holder));
    const attained = found.holder.attained === true ? 'attained: ' : found.holder.attained === false ? 'not attained: ' : '';
    say(how, found.holder.exact_reason ?? (found.holder.exact ? attained + found.holder.attained_reason
      : found.time_ended ? 'the time ended the search; the bracket holds all the same' : found.holder.upper === null ? found.stable.reason : 'both ends are proved'));
    verdicts.replaceChildren(...found.smoothness.flatMap((word, k) => [h('dt', {}, `C${order[k] ?? k}`),
      h('dd', { class: verdictWord(word), 'data-value': `c${k}` }, word, h('small', {}, found.proofs[`c${k}`]?.reason ?? ''))]));
  }
  async function askSecond(scheme: GoodScheme): Promise<void> {
    say(exponentB, '…');
    const answer = await app.client.askSlow('regularity-b', 'regularity', scheme.spec, seconds);
    if (answer !== superseded) say(exponentB, answer.ok ? holder(answer.result.holder) : '–');
  }

  return {
    element,
    update(state: State, model: Model): void {
      const { scheme, other } = model;
      if (!scheme) return;
      element.classList.toggle('paired', other !== undefined);
      const key = JSON.stringify(scheme.spec);
      if (asked !== key) {
        asked = key;
        void ask(scheme);
        const fits = recordPart(app.record, scheme);
        record.replaceChildren(...(fits ?? []));
        native.replaceChildren(...(fits ? [] : nativeHint(app, state)));
      }
      const second = other ? JSON.stringify(other.spec) : '';
      if (askedB !== second) {
        askedB = second;
        if (other) void askSecond(other);
        else say(exponentB, '');
      }
    },
  };
}

/** Formulas and certificates need the native command; this is it. */
function nativeHint(app: App, state: State): (Node | string)[] {
  const of = command({ ...state, focus: 'scheme' }, '').replace(/^limn show /, '');
  const report = `limn report ${of} -o report.html`;
  return ['Closed formulas and certificates of C¹ are computed natively: ', h('button', { type: 'button', class: 'command', title: 'Copy the command',
    'data-test': 'report-command', onclick: async () => { if (await copy(report)) document.dispatchEvent(new CustomEvent('toast', { detail: 'command copied' })); } }, report),
    app.record ? ' (this page has the record of another scheme or of other parameters)' : ''];
}
