import { expect, it } from 'vitest';
import { PARAM_NAMES } from '../../../src/core/params.ts';
import { ATTRIBUTES, PARAM_ATTRIBUTES } from '../../../src/element/contract.ts';

it('the class and its registration import in plain Node, and register nothing', async () => {
  expect(globalThis.HTMLElement).toBeUndefined();
  const { FloorPlanElement } = await import('../../../src/element/define.ts');
  expect(FloorPlanElement.observedAttributes).toContain('wall-thickness');
});

it('every parameter has one attribute, and none takes the name of an attribute of the element', () => {
  expect([...PARAM_ATTRIBUTES.values()]).toEqual([...PARAM_NAMES]);
  for (const name of PARAM_ATTRIBUTES.keys()) {
    expect(name).toMatch(/^[a-z][a-z0-9]*(-[a-z0-9]+)*$/);
    expect(Object.keys(ATTRIBUTES)).not.toContain(name);
  }
});
