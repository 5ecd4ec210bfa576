// The scheme: which one, its parameters, its text with the errors at their lines; and a second one to compare with.
import type { App, Model, View } from '../app';
import type { Fault, Parameter } from '../core/results';
import { fraction, partsOfOne } from '../scheme_text';
import type { State } from '../state';
import { h, say, show, slider } from '../ui/dom';

export function schemeView(app: App): View {
  const { store } = app;
  const options = (none: boolean): HTMLElement[] => {
    const groups = new Map<string, HTMLOptGroupElement>();
    for (const one of app.catalogue.schemes) {
      if (!groups.has(one.split)) groups.set(one.split, h('optgroup', { label: one.split }));
      groups.get(one.split)!.append(h('option', { value: one.name, title: one.title }, one.name));
    }
    return [...(none ? [h('option', { value: '' }, 'none')] : []), ...groups.values()];
  };
  const picker = h('select', { id: 'scheme-picker', 'aria-label': 'Scheme', 'data-test': 'scheme', onchange: () =>
    store.set({ scheme: picker.value, text: null, parameters: {} }) }, ...options(false));
  const second = h('select', { 'aria-label': 'Second scheme', 'data-test': 'other', onchange: () =>
    store.set({ other: second.value, otherParameters: {}, ...(second.value === '' && store.now.shade === 'distance' ? { shade: 'plain' as const } : {}) }) }, ...options(true));
  const title = h('p', { class: 'title' });
  const source = h('p', { class: 'source' });
  const notes = h('p', { class: 'source' });
  const parameters = parameterList('parameter', (values) => store.set({ parameters: values }));
  const otherParameters = parameterList('other', (values) => store.set({ otherParameters: values }));
  const errors = h('ul', { class: 'errors', 'data-test': 'errors', role: 'alert' });
  const editor = textEditor((text) => {
    const shipped = app.shipped(store.now.scheme)?.text;
    store.set({ text: text === shipped ? null : text });
  });
  const revert = h('button', { type: 'button', class: 'quiet', hidden: true, 'data-test': 'revert', onclick: () => store.set({ text: null, parameters: {} }) }, 'Back to the shipped file');
  const stale = h('p', { class: 'note', hidden: true, 'data-test': 'stale' }, 'The pictures show the last scheme without errors.');
  const about = h('details', {}, h('summary', {}, 'About'), source, notes);
  const file = h('details', { 'data-test': 'editor', class: 'file' }, h('summary', {}, 'Scheme file'), editor.element, revert);
  const element = h('section', { class: 'card', id: 'scheme', 'data-view': 'scheme', 'aria-label': 'Scheme' },
    h('header', {}, h('h2', {}, 'Scheme')), picker, title, parameters.element, errors, stale, file, about,
    h('h2', {}, 'Beside'), second, otherParameters.element);

  function showErrors(faults: Fault[]): void {
    const key = JSON.stringify(faults);
    if (errors.dataset.key === key) return;
    errors.dataset.key = key;
    errors.replaceChildren(...faults.slice(0, 12).map((fault) => h('li', {}, h('button', { type: 'button', class: 'quiet', onclick: () => {
      file.open = true;
      if (fault.line) editor.goto(fault.line, fault.column ?? 1);
    } }, fault.line ? `line ${fault.line}: ` : '', fault.message, fault.hint ? h('small', {}, fault.hint) : null))));
    editor.mark(faults.flatMap((fault) => (fault.line ? [fault.line] : [])));
  }

  return {
    element, first: true,
    update(state: State, model: Model): void {
      if (picker.value !== state.scheme) picker.value = state.scheme;
      if (second.value !== state.other) second.value = state.other;
      const info = model.scheme?.info;
      say(title, `${info?.title || info?.name || ''}${state.text !== null ? ', edited' : ''}`);
      say(source, info?.source ?? '');
      say(notes, info?.notes ?? '');
      parameters.update(info?.parameters ?? [], state.parameters);
      otherParameters.update(model.other?.info.parameters ?? [], state.otherParameters);
      editor.set(state.text ?? app.shipped(state.scheme)?.text ?? '');
      show(revert, state.text !== null);
      showErrors([...model.errors, ...model.otherErrors]);
      show(stale, model.errors.length > 0);
      element.dataset.state = model.errors.length ? 'errors' : 'good';
    },
  };
}

function parameterList(kind: string, change: (values: Record<string, string>) => void) {
  const element = h('div', { class: 'parameters', 'data-test': `${kind}s` });
  let key = '';
  let values: Record<string, string> = {};
  let rows: { parameter: Parameter; set(text: string, value: number | null): void }[] = [];
  const put = (name: string, value: string): void => change({ ...values, [name]: value });
  function row(parameter: Parameter) {
    const { name, min, max } = parameter;
    const exact = h('input', { type: 'text', class: 'exact', 'aria-label': `${name}, exactly`, 'data-parameter': name, spellcheck: false, autocomplete: 'off',
      onchange: () => put(name, exact.value.trim() || parameter.default) });
    const place = h('div', { class: 'parameter', title: parameter.meaning });
    const ranged = min !== null && max !== null && max > min;
    const parts = ranged ? partsOfOne(min, max, parameter.integer) : 1;
    const made = ranged ? slider({ label: name, name: `${kind}-${name}`, min: Math.ceil(min * parts - 1e-9), max: Math.floor(max * parts + 1e-9), step: 1,
      change: (k) => put(name, fraction(k, parts)), text: () => '' }) : undefined;
    place.append(made?.element ?? h('span', {}, name), exact, h('small', {}, parameter.meaning));
    element.append(place);
    return {
      parameter,
      set(text: string, value: number | null): void {
        if (document.activeElement !== exact) exact.value = text;
        if (made && value !== null && document.activeElement !== made.input) made.set(Math.round(value * parts));
      },
    };
  }
  return {
    element,
    update(parameters: Parameter[], set: Record<string, string>): void {
      values = set;
      const now = JSON.stringify(parameters.map((p) => [p.name, p.min, p.max, p.default]));
      if (now !== key) {
        key = now;
        element.replaceChildren();
        rows = parameters.map(row);
      }
      parameters.forEach((parameter, i) => rows[i]!.set(set[parameter.name] ?? parameter.value, parameter.number));
    },
  };
}

/** Lines with numbers, the wrong ones marked. */
function textEditor(change: (text: string) => void) {
  const numbers = h('pre', { class: 'gutter', 'aria-hidden': 'true' });
  const area = h('textarea', { spellcheck: false, autocomplete: 'off', autocapitalize: 'off', 'aria-label': 'Scheme file', 'data-test': 'text', rows: 18, wrap: 'off' });
  let timer = 0;
  let wrong = new Set<number>();
  const lines = (): void => {
    const count = area.value.split('\n').length;
    numbers.replaceChildren(...Array.from({ length: count }, (_, i) => h('span', { class: wrong.has(i + 1) ? 'wrong' : '' }, `${i + 1}\n`)));
  };
  area.addEventListener('input', () => {
    lines();
    clearTimeout(timer);
    timer = window.setTimeout(() => change(area.value), 120);
  });
  area.addEventListener('scroll', () => (numbers.scrollTop = area.scrollTop));
  return {
    element: h('div', { class: 'editor' }, numbers, area),
    set(text: string): void {
      if (area.value === text || document.activeElement === area) return;
      area.value = text;
      lines();
    },
    mark(list: number[]): void {
      wrong = new Set(list);
      lines();
    },
    goto(line: number, column: number): void {
      const at = area.value.split('\n').slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0) + column - 1;
      area.focus();
      area.setSelectionRange(at, at);
      area.scrollTop = Math.max(0, (line - 4) * 18);
    },
  };
}
