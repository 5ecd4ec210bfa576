// Libraries that the first picture does without: charts and typeset formulas.
export { dot, groupX, plot, ruleX, ruleY, text } from '@observablehq/plot';
export { default as katex } from 'katex';
