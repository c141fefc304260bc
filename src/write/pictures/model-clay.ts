import type { SolidGroup } from '../../core/types.ts';

/** Share of the light that comes from all around. */
const AMBIENT = 0.8;

type Colour = readonly [r: number, g: number, b: number];
interface Clay {
  readonly side: Colour;
  readonly top: string;
}

/** Matt clay, slightly darker where it is cut; floors in paper; structures in a muted accent. */
const CLAY: Record<SolidGroup['kind'], Clay> = {
  wall: { side: [0xf2, 0xf0, 0xea], top: '#A9A69F' },
  floor: { side: [0xe4, 0xe1, 0xd8], top: '#FBFAF6' },
  ceiling: { side: [0xf2, 0xf0, 0xea], top: '#ECEAE4' },
  secondary: { side: [0xb4, 0xc5, 0xe8], top: '#8FA6D6' },
};

/** Colour of what looks up. */
export const topColour = (kind: SolidGroup['kind']): string => CLAY[kind].top;

/**
 * Colour of an upright face: Lambert's law under one light and an even sky.
 *
 * @param normal x, y of the unit vector out of the face
 * @param light x, y of the unit vector towards the light
 */
export function sideColour(
  kind: SolidGroup['kind'],
  normal: readonly [number, number],
  light: readonly [number, number],
): string {
  const facing = Math.max(0, normal[0] * light[0] + normal[1] * light[1]);
  const share = AMBIENT + (1 - AMBIENT) * facing;
  const parts = CLAY[kind].side.map((part) =>
    Math.round(part * share)
      .toString(16)
      .padStart(2, '0'),
  );
  return `#${parts.join('').toUpperCase()}`;
}
