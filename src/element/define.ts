import { FloorPlanElement } from './floor-plan.ts';

/** Registers `<floor-plan>`; a second import, or a second copy of this package on a page, changes nothing. */
if (globalThis.customElements && !customElements.get('floor-plan')) {
  customElements.define('floor-plan', FloorPlanElement);
}

export { FloorPlanElement };
