import { ARCHIVES, READ_FORMATS } from '../read/formats.ts';
import { WRITE_FORMATS } from '../write/formats.ts';

/** A row of a table of formats, as a page shows it. */
export interface FormatRow {
  /** Key in the table. */
  readonly name: string;
  readonly label: string;
  readonly doc: string;
  /** With the dot. */
  readonly extensions: readonly string[];
}

/** What can be opened. */
export const OPENED: readonly FormatRow[] = Object.entries({ ...READ_FORMATS, ...ARCHIVES }).map(
  ([name, { label, doc, extensions }]) => ({
    name,
    label,
    doc,
    extensions: extensions.map((extension) => `.${extension}`),
  }),
);

/** What can be saved. */
export const SAVED: readonly FormatRow[] = Object.entries(WRITE_FORMATS).map(
  ([name, { label, doc, extension }]) => ({
    name,
    label,
    doc,
    extensions: [`.${extension}`],
  }),
);
