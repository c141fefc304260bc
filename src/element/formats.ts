import { ARCHIVES, READ_FORMATS } from '../read/formats.ts';
import { WRITE_FORMATS } from '../write/formats.ts';
import type { FormatGroup, WriteFormat } from '../write/plan-writer.ts';

/** A row of a table of formats, as a page shows it. */
export interface FormatRow {
  /** Key in the table. */
  readonly name: string;
  readonly label: string;
  readonly doc: string;
  /** With the dot. */
  readonly extensions: readonly string[];
}

/** A plan saved before: what is opened beside scans. */
const PLAN: FormatRow = {
  name: 'plan',
  label: 'Plan JSON',
  doc: 'A plan saved before, to be shown, its model changed, and saved again.',
  extensions: ['.json'],
};

/** What can be opened. */
export const OPENED: readonly FormatRow[] = [
  ...Object.entries({ ...READ_FORMATS, ...ARCHIVES }).map(([name, { label, doc, extensions }]) => ({
    name,
    label,
    doc,
    extensions: extensions.map((extension) => `.${extension}`),
  })),
  PLAN,
];

/** A format to save a plan as. */
export interface SavedRow extends FormatRow {
  readonly group: FormatGroup;
  /** What a plan may lack. */
  readonly needs: 'points' | 'crs' | null;
}

/** What can be saved. */
export const SAVED: readonly SavedRow[] = Object.entries<WriteFormat>(WRITE_FORMATS).map(
  ([name, { label, group, doc, extension, needs = null }]) => ({
    name,
    label,
    group,
    doc,
    extensions: [`.${extension}`],
    needs,
  }),
);
