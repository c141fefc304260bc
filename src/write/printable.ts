/** Line breaks and other control characters, and lone surrogates, which are no text. */
const UNPRINTABLE = /[\p{Cc}\p{Cs}\p{Zl}\p{Zp}]+/gu;

/** Foreign text, as a name, on one line that every program can show. */
export function printable(text: string): string {
  return text.replace(UNPRINTABLE, ' ').trim();
}
