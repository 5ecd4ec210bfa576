// The record that `limn report` puts into the page: formulas, typeset as MathML, and certificates.
import type { GoodScheme } from '../app';
import { h } from '../ui/dom';
import { verdictWord } from './words';

type Json = Record<string, unknown>;
const list = (value: unknown): Json[] => (Array.isArray(value) ? (value.filter((x) => x && typeof x === 'object') as Json[]) : []);
const object = (value: unknown): Json => (value && typeof value === 'object' && !Array.isArray(value) ? (value as Json) : {});

/** The formula, typeset as soon as the library for that is there; as it is where it cannot be. */
export function formula(latex: string): HTMLElement {
  const place = h('span', { class: 'formula' }, h('code', {}, latex));
  const typeset = async (): Promise<void> => {
    const { katex } = await limnStart.later();
    const made = h('span', {});
    katex.render(latex, made, { output: 'mathml', throwOnError: true, maxExpand: 200, maxSize: 20, trust: false, strict: 'ignore' });
    place.replaceChildren(...made.childNodes);
  };
  typeset().catch(() => {});
  return place;
}

/** What the record is of: a text, as the page would load it, and the parameters that were set. */
export function recordScheme(record: Json): { name: string; text: string | null; parameters: Record<string, string> } {
  const of = object(record.scheme);
  const text = list(of.texts)[0]?.text;
  const parameters = Object.entries(object(of.parameters)).filter((pair): pair is [string, string] => typeof pair[1] === 'string');
  return { name: String(of.name ?? ''), text: typeof text === 'string' ? text : null, parameters: Object.fromEntries(parameters) };
}

/** The record's part for this scheme; nothing where the record is of another, or the parameters differ. */
export function recordPart(record: Json | null, scheme: GoodScheme): HTMLElement[] | null {
  if (!record) return null;
  const of = recordScheme(record);
  if (of.text === null ? of.name !== scheme.info.name : of.text !== scheme.spec.text) return null;
  if (scheme.info.parameters.some((p) => p.name in of.parameters && of.parameters[p.name] !== p.value)) return null;
  const parts = [...formulas(record), ...lattice(record), ...certificate(record), ...facts(record)];
  return parts.length ? parts : null;
}

function formulas(record: Json): HTMLElement[] {
  const blocks = list(object(object(record.formulas).eigen).formulas);
  if (blocks.length === 0) return [];
  const rows = blocks.map((block) => h('tr', {}, h('th', { scope: 'row' }, `${String(block.valences ?? '')}`, h('small', {}, `ω ${typeof block.frequency === 'number' ? `= ${block.frequency}` : String(block.frequency ?? '').replace('omega', '')}`)),
    h('td', {}, ...list(block.eigenvalues).slice(0, 4).map((one) => h('div', {}, formula(String(object(one.by_lets).latex ?? one.latex ?? one.text ?? '')))))));
  return [h('h3', {}, 'Eigenvalues in closed form'), h('table', { class: 'formulas' }, h('tbody', {}, ...rows))];
}

export interface LatexPart {
  /** The remark before it. */
  title: string;
  latex: string;
}
/** The displayed formulas of a fragment of LaTeX, each with the remark before it. */
export function latexParts(fragment: string): LatexPart[] {
  const parts: LatexPart[] = [];
  let title = '';
  let body: string[] | undefined;
  for (const line of fragment.split('\n')) {
    if (line.startsWith('%')) title = line.slice(1).trim();
    else if (line === '\\[' || line === '\\begin{align*}') body = [];
    else if ((line === '\\]' || line === '\\end{align*}') && body) {
      const latex = body.join('\n');
      parts.push({ title, latex: line === '\\]' ? latex : `\\begin{aligned}\n${latex}\n\\end{aligned}` });
      body = undefined;
    } else body?.push(line);
  }
  return parts;
}

/** Mask, factors, limit stencil and artifacts on the regular lattice. */
function lattice(record: Json): HTMLElement[] {
  const fragment = object(record.formulas).lattice_latex;
  if (typeof fragment !== 'string') return [];
  // remarks may have formulas of their own, between dollars
  const typeset = (text: string): (string | HTMLElement)[] => text.split('$').map((part, i) => (i % 2 === 0 ? part : formula(part)));
  const parts = latexParts(fragment);
  if (parts.length === 0) return [];
  return [h('h3', {}, 'On the regular lattice'), h('div', { class: 'lattice', 'data-test': 'lattice' }, ...parts.map(({ title, latex }) =>
    h('figure', {}, h('figcaption', {}, ...typeset(title)), h('div', { class: 'display' }, formula(latex)))))];
}

function certificate(record: Json): HTMLElement[] {
  const found = object(record.certificate);
  const valences = list(found.valences);
  if (valences.length === 0) return [];
  const cells = valences.slice(0, 60).map((one) => h('span', { class: `chip ${verdictWord(String(one.c1))}`, title: String(one.reason ?? one.c1) }, String(one.valence)));
  const words = new Set(valences.map((one) => String(one.c1)));
  return [h('h3', {}, 'C¹ at the extraordinary vertex'), h('p', { class: 'how' }, `In ball arithmetic, by limn certify: ${[...words].join(', ')}.`), h('p', { class: 'chips' }, ...cells)];
}

function facts(record: Json): HTMLElement[] {
  const known = list(record.facts);
  if (known.length === 0) return [];
  return [h('h3', {}, 'What the literature states, held true by tests'), h('ul', { class: 'reasons' }, ...known.slice(0, 12).map((fact) => {
    const values = Object.entries(object(fact.values)).map(([key, value]) => `${key} = ${String(value)}`).join(', ');
    const span = Array.isArray(fact.valences) ? `n = ${[...new Set(fact.valences.map(String))].join(' … ')}: ` : '';
    return h('li', {}, `${span}${values} (${String(fact.source ?? '')})`);
  }))];
}
