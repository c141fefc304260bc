import { expect, it } from 'vitest';
import { resolveOptions } from '../../../../src/core/options.ts';
import {
  changeTo,
  type Difference,
  differences,
  FIRST_COMPARED,
  firstValue,
} from '../../../../src/element/steps/compared-params.ts';

const find = (all: readonly Difference[], name: string) => all.find((one) => one.name === name)!;

it('offers every other choice of what shapes the plan, and nothing that makes another scan', () => {
  const all = differences(resolveOptions({}));
  const names = all.map(({ name }) => name);
  for (const name of ['preset', 'boundary', 'secondaryMethod', 'levelRule', 'radialPass', 'csg'])
    expect(names).toContain(name);
  for (const name of ['unit', 'up', 'levelling', 'epsilon']) expect(names).not.toContain(name);
  expect(find(all, 'boundary')).toMatchObject({ now: 'Gift opening' });
  expect(find(all, 'boundary').others.map(({ value }) => value)).not.toContain('gift-opening');
  expect(find(all, 'preset').others).toEqual([{ value: 'paper', label: 'Paper' }]);
});

it('every offered value is one that its parameter takes', () => {
  for (const { name, others } of differences(resolveOptions({}, { isSlice: true }))) {
    expect(others.length).toBeGreaterThan(0);
    for (const { value } of others) expect(() => resolveOptions(changeTo(name, value))).not.toThrow();
  }
});

it("begins with the paper's rival, or with the first other method where that is the one shown", () => {
  const ours = find(differences(resolveOptions({})), FIRST_COMPARED);
  expect(firstValue(ours)).toBe('alpha-shape');
  const rival = find(differences(resolveOptions({ boundary: 'alpha-shape' })), FIRST_COMPARED);
  expect(firstValue(rival)).toBe('gift-opening');
});
