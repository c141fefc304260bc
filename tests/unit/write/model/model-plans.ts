import type { Opening, SecondaryBoundary, Storey } from '../../../../src/core/types.ts';
import { type PlanFacts, rectangle, secondary } from '../../solid/plans.ts';

/** Plans with what a model is made of, for the tests of its writers. */

const opening = (type: Opening['type'], from: Opening['from'], to: Opening['to'], sill = 0): Opening => ({
  ...{ type, from, to, sill, head: 2, confidence: 1 },
});

/** The opening's wall is the room's south one, or its east one. */
export const OPENINGS: readonly Opening[] = [
  opening('door', [0.5, -0.1], [1.4, -0.1]),
  opening('window', [2, -0.1], [3.2, -0.1], 0.9),
  opening('passage', [4.1, 1], [4.1, 2]),
];

const typed = (boundary: SecondaryBoundary, type: SecondaryBoundary['type']): SecondaryBoundary => ({
  ...boundary,
  type,
});

export const FURNISHED: Partial<Storey> = {
  openings: OPENINGS,
  secondary: [
    secondary(rectangle(1, 1.5, 0.3, 0.3), 'subtract'),
    secondary(rectangle(2, 1.5, 0.3, 0.3), 'independent'),
    typed(secondary(rectangle(3, 1.5, 0.6, 0.6), 'subtract'), 'shaft'),
    typed(secondary(rectangle(3, 2.3, 0.5, 0.5), 'independent'), 'other'),
  ],
  rooms: [
    {
      name: '<script>"&]]> 🏠 غرفة\nend_header',
      outline: { outer: rectangle(0, 0, 4, 3), holes: [] },
      height: 2.5,
      confidence: 1,
    },
  ],
};

/** A room with a door, a window, a passage, two columns, a shaft and something else. */
export const furnished = (facts: PlanFacts = {}): PlanFacts => ({ storeys: [FURNISHED], ...facts });

/** A line break, markup, a lone surrogate, what ends a PLY header, and 10,000 characters. */
export const HOSTILE_NAME = `<script>"&]]>\nv 1 2 3\r end_header\n🏠 \ud800 غرفة ${'x'.repeat(10_000)}`;
