import viewStyles from '../view/view.css?inline';
import elementStyles from './styles.css?inline';

let sheets: CSSStyleSheet[] | null = null;

/** Adopted sheets, not a style element: a strict content security policy would drop that. Made once for all elements. */
export function adoptStyles(root: ShadowRoot): void {
  sheets ??= [elementStyles, viewStyles].map((text) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(text);
    return sheet;
  });
  root.adoptedStyleSheets = sheets;
}
