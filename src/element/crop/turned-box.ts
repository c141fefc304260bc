import type { CropBox } from '../../core/crop-box.ts';
import { planPlace, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { Frame, Vec2 } from '../../core/types.ts';
import type { Box } from './grip.ts';

/** A box in axes that are turned about the plan's origin, along which it stands square. Plan metres. */
export interface TurnedBox extends Box {
  /** Of its axes, degrees, counter-clockwise. */
  readonly heading: number;
}

/** A box is drawn to this, m: nobody sees a centimetre on a sheet … */
const DRAWN = 0.01;
/** … but in that of a small thing; a share of the box's shorter side. */
const FINE = 0.01;
/** Of a heading: the corner of a box 50 m long is off by a hand's breadth of what is drawn, 4 mm. */
const HEADING_DIGITS = 2;

/** A place seen in axes turned by `heading` degrees, counter-clockwise; a negative heading leads back. */
export function inTurnedAxes([x, y]: Vec2, heading: number): Vec2 {
  const [cos, sin] = [Math.cos((heading * Math.PI) / 180), Math.sin((heading * Math.PI) / 180)];
  return heading === 0 ? [x, y] : [cos * x + sin * y, cos * y - sin * x];
}

/** The heading of a box along the sheet. @param turn of the plan on its sheet, radians, counter-clockwise */
export function headingOf(turn: number): number {
  return Number(((-turn * 180) / Math.PI).toFixed(HEADING_DIGITS)) + 0;
}

export function turnedBox(frame: Frame, { x0, y0, x1, y1, heading }: CropBox): TurnedBox {
  const [low, high] = [planPlace(frame, x0, y0), planPlace(frame, x1, y1)];
  const half = [(high[0] - low[0]) / 2, (high[1] - low[1]) / 2];
  const [x, y] = inTurnedAxes([low[0] + half[0], low[1] + half[1]], heading);
  return { heading, low: [x - half[0], y - half[1]], high: [x + half[0], y + half[1]] };
}

/** Its corners on the plan, all the way round. */
export function cornersOf({ low, high, heading }: TurnedBox): readonly Vec2[] {
  const corners = [low, [high[0], low[1]], high, [low[0], high[1]]] as const;
  return corners.map((corner) => inTurnedAxes(corner, -heading));
}

/** The box in source units and coordinates, rounded to what can be seen. */
export function cropOf(frame: Frame, { low, high, heading }: TurnedBox): Omit<CropBox, 'heights'> {
  const half = [(high[0] - low[0]) / 2, (high[1] - low[1]) / 2];
  const [x, y] = inTurnedAxes([low[0] + half[0], low[1] + half[1]], -heading);
  const to = sourceCoordinates(frame, Math.min(DRAWN, FINE * 2 * Math.min(...half)));
  const round = (value: number) => roundTo(value, to.digits);
  return {
    x0: round(to.x(x - half[0])),
    y0: round(to.y(y - half[1])),
    x1: round(to.x(x + half[0])),
    y1: round(to.y(y + half[1])),
    heading,
  };
}

/** Where the whole cloud lies, source units and coordinates, rounded outwards. */
export function wholeOf(frame: Frame, { min, max }: Readonly<Record<'min' | 'max', readonly number[]>>) {
  const { planOrigin, metresPerUnit } = frame;
  const to = sourceCoordinates(frame, DRAWN);
  const step = 10 ** -to.digits;
  const below = (value: number) => roundTo(Math.floor(value / step) * step, to.digits);
  const above = (value: number) => roundTo(Math.ceil(value / step) * step, to.digits);
  const z = (height: number) => planOrigin[2] + height / metresPerUnit;
  return {
    x0: below(to.x(min[0])),
    y0: below(to.y(min[1])),
    z0: below(z(min[2])),
    x1: above(to.x(max[0])),
    y1: above(to.y(max[1])),
    z1: above(z(max[2])),
  };
}

/** Adding 0 makes a negative zero a zero. */
function roundTo(value: number, digits: number): number {
  return Number(value.toFixed(digits)) + 0;
}
