/** What the scan of a file is called, or of several together: `hall.las + 2`. @param files at least one */
export function scanName([first, ...rest]: readonly { readonly name: string }[]): string {
  return rest.length === 0 ? first.name : `${first.name} + ${rest.length}`;
}
