import type { IfcGuids } from './ifc-guids.ts';
import type { Ref, StepFile } from './step-file.ts';
import { FALSE, fixed, label, list, OMITTED, real, type StepValue, TRUE, text } from './step-text.ts';

/** Decimals of measured quantities: mm³ of a wall, mm² of its foot. */
const QUANTITY_DIGITS = 6;

const QUANTITIES = {
  length: 'IFCQUANTITYLENGTH',
  area: 'IFCQUANTITYAREA',
  volume: 'IFCQUANTITYVOLUME',
} as const;

export type Quantity = readonly [name: string, kind: keyof typeof QUANTITIES, value: number];
export type Property = readonly [name: string, value: StepValue];

/** Values of properties: a value names its type. */
export const asText = (value: string): StepValue => `IFCTEXT(${text(value)})`;
export const asLabel = (value: string): StepValue => `IFCLABEL(${label(value)})`;
export const asIdentifier = (value: string): StepValue => `IFCIDENTIFIER(${label(value)})`;
export const asReal = (value: number): StepValue => `IFCREAL(${real(value)})`;
export const asBoolean = (value: boolean): StepValue => `IFCBOOLEAN(${value ? TRUE : FALSE})`;
export const asLength = (value: number): StepValue => `IFCLENGTHMEASURE(${fixed(value, QUANTITY_DIGITS)})`;
export const asRatio = (value: number): StepValue =>
  `IFCNORMALISEDRATIOMEASURE(${fixed(Math.min(1, Math.max(0, value)), 4)})`;

/** How quantities were measured, as IfcElementQuantity tells it. */
const METHOD = "'From the plan of a point cloud'";

interface SetOf {
  readonly type: 'IFCPROPERTYSET' | 'IFCELEMENTQUANTITY';
  readonly name: string;
  readonly items: StepValue;
  readonly things: Ref[];
}

/** Property and quantity sets: things of which a set says the same share it. */
export class IfcProperties {
  readonly #file: StepFile;
  readonly #sets = new Map<string, SetOf>();

  constructor(file: StepFile) {
    this.#file = file;
  }

  /** No set where there are no properties. */
  properties(thing: Ref, name: string, properties: readonly Property[]): void {
    const items = properties.map(([key, value]) =>
      this.#file.share('IFCPROPERTYSINGLEVALUE', label(key), OMITTED, value, OMITTED),
    );
    this.#define(thing, 'IFCPROPERTYSET', name, items);
  }

  /** Quantities below 0 and such without a value are left out. */
  quantities(thing: Ref, name: string, quantities: readonly Quantity[]): void {
    const items = quantities
      .filter(([, , value]) => Number.isFinite(value) && value >= 0)
      .map(([key, kind, value]) =>
        this.#file.share(
          QUANTITIES[kind],
          ...[label(key), OMITTED, OMITTED, fixed(value, QUANTITY_DIGITS), OMITTED],
        ),
      );
    this.#define(thing, 'IFCELEMENTQUANTITY', name, items);
  }

  /** Writes all sets. */
  end(guids: IfcGuids): void {
    for (const [key, { type, name, items, things }] of this.#sets) {
      const method = type === 'IFCPROPERTYSET' ? [] : [METHOD];
      const set = this.#file.add(
        type,
        ...[guids.next(type, key), OMITTED, label(name), OMITTED, ...method, items],
      );
      this.#file.add(
        'IFCRELDEFINESBYPROPERTIES',
        ...[guids.next('defines', key), OMITTED, OMITTED, OMITTED, list(things), set],
      );
    }
  }

  #define(thing: Ref, type: SetOf['type'], name: string, refs: readonly Ref[]): void {
    if (refs.length === 0) return;
    const items = list(refs);
    const key = `${name} ${items}`;
    const known = this.#sets.get(key);
    if (known === undefined) this.#sets.set(key, { type, name, items, things: [thing] });
    else known.things.push(thing);
  }
}
