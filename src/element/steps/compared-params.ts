import type { ParamRow } from '../../core/param-rows.ts';
import { type GivenValues, type Options, PARAM_NAMES, PARAMS, type ParamName } from '../../core/params.ts';
import { STAGE_NAMES } from '../../core/stages.ts';
import { sayChoice } from '../plain-words.ts';

/** A way in which two plans of one scan may differ: a choice that could fall otherwise. */
export interface Difference {
  readonly name: ParamName;
  readonly label: string;
  /** As it is now, in words. */
  readonly now: string;
  readonly others: readonly { readonly value: string; readonly label: string }[];
}

/** The paper's own rival ([Stojanovic19] §4, Fig. 6) is what a comparison begins with. */
const FIRST = { name: 'boundary', value: 'alpha-shape' } as const;
/** Another unit or up axis makes another scan, not another plan of this one. */
const FIRST_STAGE = STAGE_NAMES.indexOf('outliers');

/** Everything two plans can be compared in: the choices and flags of {@link PARAMS} from the cleaned cloud on, and the preset. */
export function differences(options: Options): Difference[] {
  return PARAM_NAMES.flatMap((name) => {
    const row: ParamRow = PARAMS[name];
    if (name !== 'preset' && STAGE_NAMES.indexOf(row.stage) < FIRST_STAGE) return [];
    if (row.kind !== 'choice' && row.kind !== 'flag') return [];
    const values =
      row.kind === 'flag' ? ['true', 'false'] : row.choices.filter((choice) => choice !== 'auto');
    const now = String(options[name]);
    const label = (value: string) => (row.kind === 'flag' ? sayFlag(value) : sayChoice(value));
    const others = values.filter((value) => value !== now).map((value) => ({ value, label: label(value) }));
    return [{ name, label: row.label, now: label(now), others }];
  });
}

/** What to compare with at first: the paper's rival, else the first other choice. */
export function firstValue({ name, others }: Difference): string {
  const rival = others.find(({ value }) => name === FIRST.name && value === FIRST.value);
  return (rival ?? others[0]).value;
}

export const FIRST_COMPARED: ParamName = FIRST.name;

/** The change of parameters that a chosen value stands for. */
export function changeTo(name: ParamName, value: string): GivenValues {
  return { [name]: PARAMS[name].kind === 'flag' ? value === 'true' : value } as GivenValues;
}

function sayFlag(value: string): string {
  return value === 'true' ? 'On' : 'Off';
}
