import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';
import { readmePath, withTables } from '../tables.ts';

it('has the tables of the source in the README (npm run tables writes them)', () => {
  const readme = readFileSync(readmePath, 'utf8');
  expect(readme).toBe(withTables(readme));
  expect(readme.match(/<!-- table: /g)).toHaveLength(4);
});
