import type { ParamRow, RowFacts } from './param-rows.ts';
import { MODEL_PARAMS } from './params/model-params.ts';
import { OUTLINE_PARAMS } from './params/outline-params.ts';
import { SCAN_PARAMS } from './params/scan-params.ts';
import { SECONDARY_PARAMS } from './params/secondary-params.ts';
import { SHEET_PARAMS } from './params/sheet-params.ts';
import { SLICE_PARAMS } from './params/slice-params.ts';
import type { AreaText, LengthText } from './quantity.ts';

/**
 * Every number a person may set: options, ranges, controls, attributes, flags and docs are made from this table,
 * and a changed value runs the pipeline again from its stage. In the order of the stages.
 */
export const PARAMS = {
  ...SCAN_PARAMS,
  ...SLICE_PARAMS,
  ...OUTLINE_PARAMS,
  ...SECONDARY_PARAMS,
  ...MODEL_PARAMS,
  ...SHEET_PARAMS,
} as const satisfies Record<string, ParamRow>;

export type ParamName = keyof typeof PARAMS;
type ValueOf<Row> = Row extends RowFacts<infer T> ? T : never;

/** One value for every row of {@link PARAMS}. */
export type Options = { readonly [K in ParamName]: ValueOf<(typeof PARAMS)[K]> };

type GivenValue<Row> = Row extends { readonly unit: 'm' }
  ? ValueOf<Row> | LengthText
  : Row extends { readonly unit: 'm²' }
    ? ValueOf<Row> | AreaText
    : ValueOf<Row>;

/** What a person may give: any of the {@link Options}, lengths and areas also as text with a unit: `24mm`, `2.4px`. */
export type GivenValues = { readonly [K in ParamName]?: GivenValue<(typeof PARAMS)[K]> };

export const PARAM_NAMES = Object.keys(PARAMS) as readonly ParamName[];

/** `wallThickness` → `wall-thickness`: a parameter's spelling as a flag and as an attribute. */
export function kebabCase(name: string): string {
  return name.replace(/(?<=[a-z])(?=[A-Z])|(?<=[a-z])(?=\d)|(?<=\d)(?=[A-Z])/g, '-').toLowerCase();
}

/** `bridgeGap` among words; names of a single word are plain English and stay. */
const NAME_AMONG_WORDS = /\b[a-z]+(?:[A-Z0-9][A-Za-z0-9]*)+\b/g;

/** Warnings and hints name parameters as a script would; this says them as another reader knows them. */
export function renameParams(text: string, say: (name: ParamName) => string): string {
  return text.replace(NAME_AMONG_WORDS, (name) =>
    Object.hasOwn(PARAMS, name) ? say(name as ParamName) : name,
  );
}
