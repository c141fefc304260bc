import type { ParamRow } from '../core/param-rows.ts';
import type { ParamName } from '../core/params.ts';
import type { Model } from './model.ts';

/** What a person edits one value with. */
export interface Field {
  readonly node: HTMLElement;
  set(value: unknown, model: Model): void;
}

export interface FieldFacts {
  readonly id: string;
  readonly name: ParamName;
  readonly row: ParamRow;
  change(value: unknown, isFinal: boolean): void;
}
