// A few words to build the page with.
type Child = Node | string | null | undefined | false;
type Properties = Record<string, string | number | boolean | null | undefined | ((event: never) => void)>;

function fill(element: Element, properties: Properties, children: Child[]): void {
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === 'function') element.addEventListener(name.replace(/^on/, ''), value as EventListener);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
  element.append(...children.filter((c): c is Node | string => c !== null && c !== undefined && c !== false));
}

export function h<K extends keyof HTMLElementTagNameMap>(tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  fill(element, properties, children);
  return element;
}
export function s<K extends keyof SVGElementTagNameMap>(tag: K, properties: Properties = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  fill(element, properties, children);
  return element;
}
/** Sets the text only where it differs, so that what a person has marked stays marked. */
export function say(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}
export function show(element: HTMLElement, visible: boolean): void {
  element.hidden = !visible;
}

const mathSymbols = { none: '–' };
export const six = (x: number | null | undefined): string => (x === null || x === undefined || !Number.isFinite(x) ? mathSymbols.none : x.toFixed(6));
export function figures(x: number | null | undefined, digits = 3): string {
  if (x === null || x === undefined || !Number.isFinite(x)) return mathSymbols.none;
  if (x === 0) return '0';
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-3 ? x.toExponential(digits - 1).replace('e', ' · 10^') : String(Number(x.toPrecision(digits)));
}
export const thousands = (x: number): string => String(x).replace(/\B(?=(\d{3})+$)/g, '\u202f');

/** A row of buttons of which one is chosen. */
export function choice<T extends string>(label: string, items: readonly (readonly [T, string])[], pick: (value: T) => void) {
  const buttons = items.map(([value, text]) =>
    h('button', { type: 'button', role: 'radio', 'data-value': value, onclick: () => pick(value) }, text));
  const element = h('div', { class: 'choice', role: 'radiogroup', 'aria-label': label }, ...buttons);
  element.addEventListener('keydown', (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    const at = buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (!step || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const next = buttons[(at + step + buttons.length) % buttons.length]!;
    next.focus();
    next.click();
  });
  return {
    element,
    set(value: T): void {
      for (const button of buttons) {
        const on = button.dataset.value === value;
        button.setAttribute('aria-checked', String(on));
        button.tabIndex = on ? 0 : -1;
      }
    },
    button: (value: T) => buttons.find((b) => b.dataset.value === value),
  };
}

export interface SliderOptions {
  label: string;
  name: string;
  min: number;
  max: number;
  step: number;
  change(value: number): void;
  text?(value: number): string;
}
/** A slider with its value beside it. */
export function slider(options: SliderOptions) {
  const output = h('output', { 'data-for': options.name });
  const input = h('input', { type: 'range', min: options.min, max: options.max, step: options.step, 'aria-label': options.label,
    'data-slider': options.name, oninput: () => { write(Number(input.value)); options.change(Number(input.value)); } });
  const write = (value: number): void => say(output, options.text ? options.text(value) : String(value));
  const element = h('label', { class: 'slider' }, h('span', {}, options.label), input, output);
  return {
    element,
    input,
    set(value: number): void {
      if (Number(input.value) !== value) input.value = String(value);
      write(value);
    },
  };
}

export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h('textarea', { style: 'position:fixed;opacity:0' });
    area.value = text;
    document.body.append(area);
    area.select();
    const done = document.execCommand('copy');
    area.remove();
    return done;
  }
}
export function download(name: string, data: Blob): void {
  const url = URL.createObjectURL(data);
  const link = h('a', { href: url, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}
