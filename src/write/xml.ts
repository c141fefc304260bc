const ESCAPES: Readonly<Record<string, string>> = {
  '&': '&amp;',
  '<': '&lt;',
  '>': '&gt;',
  '"': '&quot;',
  "'": '&apos;',
};

/** Text fit for XML 1.0 content and attributes: escaped, without the characters XML forbids. */
export function escapeXml(text: string): string {
  let safe = '';
  // Iterating by code point leaves lone surrogates as letters of their own.
  for (const letter of text) if (isAllowed(letter.codePointAt(0)!)) safe += ESCAPES[letter] ?? letter;
  return safe;
}

/** Attributes in the order given, those that are undefined left out. */
export function attributes(values: Readonly<Record<string, string | number | undefined>>): string {
  let text = '';
  for (const [name, value] of Object.entries(values)) {
    if (value !== undefined) text += ` ${name}="${escapeXml(String(value))}"`;
  }
  return text;
}

/** [XML] §2.2 Char, without the C1 controls; tab and line breaks count as allowed. */
function isAllowed(code: number): boolean {
  if (code < 0x20) return code === 0x9 || code === 0xa || code === 0xd;
  if (code >= 0x7f && code <= 0x9f) return false;
  if (code >= 0xd800 && code <= 0xdfff) return false;
  return code !== 0xfffe && code !== 0xffff;
}
