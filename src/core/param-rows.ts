import type { StageName } from './stages.ts';

/** A length or area in the paper's canvas pixels; `pixelsPerMetre` turns it into metres or square metres. */
export interface Pixels {
  readonly px: number;
  readonly power: 1 | 2;
}

/** What every row tells of its parameter. */
export interface RowFacts<T> {
  readonly default: T;
  /** Value under the preset `paper`, where it differs. */
  readonly paper?: T | Pixels;
  readonly stage: StageName;
  readonly label: string;
  readonly doc: string;
  /** Paper section or "ours". */
  readonly source: string;
  /** Shown only when a person asks for all parameters. */
  readonly advanced?: boolean;
}

export interface NumberRow extends RowFacts<number> {
  readonly kind: 'number';
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit: '' | 'm' | 'm²' | '°' | 'px/m' | 'points';
}
/** A number the pipeline works out by itself unless a person sets it. */
export interface AutoNumberRow extends RowFacts<number | 'auto'> {
  readonly kind: 'auto-number';
  readonly min: number;
  readonly max: number;
  readonly step: number;
  readonly unit: NumberRow['unit'];
}
export interface FlagRow extends RowFacts<boolean> {
  readonly kind: 'flag';
}
export interface ChoiceRow<C extends string = string> extends RowFacts<C> {
  readonly kind: 'choice';
  readonly choices: readonly C[];
}
/** A comma-separated list of choices; the last one counts for all that follow. */
export interface ChoiceListRow<C extends string = string> extends RowFacts<readonly C[]> {
  readonly kind: 'choice-list';
  readonly choices: readonly C[];
}
/** `auto`, one of the three levels, or a height band `low:high` in metres above the floor. */
export interface LevelRow extends RowFacts<LevelChoice> {
  readonly kind: 'level';
}
/** `none`, `gaps`, or doors `x,y,width[,height]` joined by semicolons; `parseDoors` reads it. */
export interface DoorsRow extends RowFacts<string> {
  readonly kind: 'doors';
}
/** `all`, or class codes and ranges of them separated by commas; `parseClasses` reads it. */
export interface ClassesRow extends RowFacts<string> {
  readonly kind: 'classes';
}
/** `none`, or a box `x0,y0,x1,y1[,z0,z1][@heading]` in source units and coordinates; `parseCrop` reads it. */
export interface CropRow extends RowFacts<string> {
  readonly kind: 'crop';
}
/** `none`, or names `x,y[,storey]=Name` joined by semicolons; `parseRoomNames` reads it. */
export interface RoomNamesRow extends RowFacts<string> {
  readonly kind: 'room-names';
}
/** Free text. */
export interface TextRow extends RowFacts<string> {
  readonly kind: 'text';
  /** In UTF-16 units. */
  readonly longest: number;
}
export type LevelChoice = 'auto' | '0' | '1' | '2' | `${number}:${number}`;

export type ParamRow =
  | NumberRow
  | AutoNumberRow
  | FlagRow
  | ChoiceRow
  | ChoiceListRow
  | LevelRow
  | DoorsRow
  | ClassesRow
  | CropRow
  | RoomNamesRow
  | TextRow;

export const px = (value: number): Pixels => ({ px: value, power: 1 });
export const px2 = (value: number): Pixels => ({ px: value, power: 2 });
type In<U> = { readonly unit: U };
export const number = <U extends NumberRow['unit']>(
  row: Omit<NumberRow, 'kind'> & In<U>,
): NumberRow & In<U> => ({
  kind: 'number',
  ...row,
});
export const autoNumber = <U extends NumberRow['unit']>(
  row: Omit<AutoNumberRow, 'kind'> & In<U>,
): AutoNumberRow & In<U> => ({ kind: 'auto-number', ...row });
export const flag = (row: Omit<FlagRow, 'kind'>): FlagRow => ({ kind: 'flag', ...row });
export const choice = <const C extends string>(
  choices: readonly C[],
  row: Omit<ChoiceRow<C>, 'kind' | 'choices'>,
): ChoiceRow<C> => ({ kind: 'choice', choices, ...row });
export const choiceList = <const C extends string>(
  choices: readonly C[],
  row: Omit<ChoiceListRow<C>, 'kind' | 'choices'>,
): ChoiceListRow<C> => ({ kind: 'choice-list', choices, ...row });
export const level = (row: Omit<LevelRow, 'kind'>): LevelRow => ({ kind: 'level', ...row });
export const doors = (row: Omit<DoorsRow, 'kind'>): DoorsRow => ({ kind: 'doors', ...row });
export const classes = (row: Omit<ClassesRow, 'kind'>): ClassesRow => ({ kind: 'classes', ...row });
export const crop = (row: Omit<CropRow, 'kind'>): CropRow => ({ kind: 'crop', ...row });
export const roomNames = (row: Omit<RoomNamesRow, 'kind'>): RoomNamesRow => ({
  kind: 'room-names',
  ...row,
});
export const text = (row: Omit<TextRow, 'kind'>): TextRow => ({ kind: 'text', ...row });

/** A row's default as told to people; a text without letters is said to be empty. */
export const defaultWords = (row: ParamRow): string => (row.default === '' ? 'empty' : String(row.default));
