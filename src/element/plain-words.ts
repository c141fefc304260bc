import { PARAMS, type ParamName, renameParams } from '../core/params.ts';

/** Choices whose name is not a word. */
const SPELT: Readonly<Record<string, string>> = { bsp: 'BSP', 'us-ft': 'US survey foot' };
/** Shorter choices are units and axes. */
const SHORTEST_WORD = 3;

/** Parameters in warnings and hints are called by the label of their control. */
export function sayLabels(text: string): string {
  return renameParams(text, sayLabel);
}

/** A parameter as its control is labelled. */
export function sayLabel(name: ParamName): string {
  return `“${PARAMS[name].label}”`;
}

/** An error's message as a sentence of its own: "expected …" starts one, a file's or a parameter's name is left as it is. */
export function saySentence(message: string): string {
  return sayLabels(message.replace(/^expected\b/, 'Expected'));
}

/** `gift-opening` → `Gift opening`; units and axes as they are. */
export function sayChoice(choice: string): string {
  if (choice in SPELT) return SPELT[choice];
  if (choice.length < SHORTEST_WORD) return choice;
  return choice[0].toUpperCase() + choice.slice(1).replaceAll('-', ' ');
}
