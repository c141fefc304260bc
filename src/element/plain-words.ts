import type { ParamRow } from '../core/param-rows.ts';
import { PARAMS, type ParamName } from '../core/params.ts';

/** `bridgeGap` among words; names of a single word are plain English and stay. */
const CODE_NAME = /\b[a-z]+(?:[A-Z0-9][A-Za-z0-9]*)+\b/g;

/** Choices whose name is not a word. */
const SPELT: Readonly<Record<string, string>> = { bsp: 'BSP', 'us-ft': 'US survey foot' };
/** Shorter choices are units and axes. */
const SHORTEST_WORD = 3;

/** Warnings and hints name parameters as a script would; a person finds them by the label of their control. */
export function sayLabels(text: string): string {
  return text.replace(CODE_NAME, (name) =>
    Object.hasOwn(PARAMS, name) ? `“${(PARAMS[name as ParamName] as ParamRow).label}”` : name,
  );
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
