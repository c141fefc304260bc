/** Text of at most so many characters, halves of none: where it is longer, its beginning and an ellipsis. O(longest). */
export function cutText(text: string, longest: number): string {
  if (text.length <= longest) return text;
  const characters: string[] = [];
  for (const character of text) {
    if (characters.length === longest) return `${characters.slice(0, -1).join('')}…`;
    characters.push(character);
  }
  return text;
}

/** Of a wrong value so many characters are told. */
const QUOTED = 60;

/** Text as a message tells what it found: in quotes, cut where it is longer. */
export function quoteText(text: string, longest = QUOTED): string {
  return `"${cutText(text, longest)}"`;
}
