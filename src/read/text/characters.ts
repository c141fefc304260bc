/** Bytes that text tables are made of. */
export const TAB = 9;
export const LINE_FEED = 10;
export const CARRIAGE_RETURN = 13;
export const BLANK = 32;
export const COMMA = 44;

export function isBlank(byte: number): boolean {
  return byte === BLANK || byte === TAB;
}

export function isLineEnd(byte: number): boolean {
  return byte === LINE_FEED || byte === CARRIAGE_RETURN;
}

export function isBlankOrEnd(byte: number): boolean {
  return byte === BLANK || byte === TAB || isLineEnd(byte);
}

/** Moves past blanks, and tabs unless they separate. */
export function skipBlanks(bytes: Uint8Array, begin: number, separator = BLANK): number {
  let at = begin;
  while (bytes[at] === BLANK || (bytes[at] === TAB && separator !== TAB)) at++;
  return at;
}

/** Where the line that `begin` lies in ends, by LF, CRLF, CR or the end of the bytes. */
export function lineEnd(bytes: Uint8Array, begin: number): number {
  let at = begin;
  while (at < bytes.length && !isLineEnd(bytes[at])) at++;
  return at;
}

/** Where the line after begins. @param end a line's */
export function nextLine(bytes: Uint8Array, end: number): number {
  return bytes[end] === CARRIAGE_RETURN && bytes[end + 1] === LINE_FEED ? end + 2 : end + 1;
}
