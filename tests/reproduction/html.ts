import { escapeXml } from '../../src/write/xml.ts';

/** Text that is markup already; everything else is escaped on its way into the page. */
export class Markup {
  readonly text: string;

  constructor(text: string) {
    this.text = text;
  }
}

type Part = string | number | Markup | readonly Markup[] | null;

/** Markup with escaped holes: html`<p>${text}</p>`. */
export function html(strings: TemplateStringsArray, ...parts: readonly Part[]): Markup {
  return new Markup(strings.map((text, i) => text + (i < parts.length ? fill(parts[i]) : '')).join(''));
}

/** Cells of a table: the first column names the row, text stands left, numbers right. */
export type Cell = string | number | Markup;

/** A table that scrolls sideways on its own where the page is narrow, under its caption, which does not. */
export function table(caption: string, head: readonly Cell[], rows: readonly (readonly Cell[])[]): Markup {
  const cell = (value: Cell, i: number) =>
    i === 0 ? html`<th scope="row">${value}</th>` : html`<td>${value}</td>`;
  return html`<p class="caption">${caption}</p>
<div class="wide" role="region" aria-label="${caption}" tabindex="0"><table>
<thead><tr>${head.map((title) => html`<th scope="col">${title}</th>`)}</tr></thead>
<tbody>
${rows.map((row) => html`<tr>${row.map(cell)}</tr>\n`)}</tbody>
</table></div>`;
}

function fill(part: Part): string {
  if (part === null) return '';
  if (part instanceof Markup) return part.text;
  if (typeof part === 'object') return part.map(({ text }) => text).join('');
  return escapeXml(String(part));
}
