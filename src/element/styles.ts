import viewStyles from '../view/view.css?inline';
import elementStyles from './styles.css?inline';

let sheets: CSSStyleSheet[] | null = null;

const added = new Map<string, CSSStyleSheet>();

/** Adds the styles of a part that came later, once. */
export function addStyles(root: ShadowRoot, text: string): void {
  let sheet = added.get(text);
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    added.set(text, sheet);
  }
  if (!root.adoptedStyleSheets.includes(sheet)) root.adoptedStyleSheets.push(sheet);
}

/** Adopted sheets, not a style element: a strict content security policy would drop that. Made once for all elements. */
export function adoptStyles(root: ShadowRoot): void {
  sheets ??= [elementStyles, viewStyles].map((text) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    return sheet;
  });
  root.adoptedStyleSheets = sheets;
}
