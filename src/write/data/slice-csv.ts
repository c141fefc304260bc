import { sourceCoordinates } from '../../core/source-coordinates.ts';
import { decimal } from '../decimals.ts';
import { noPointsFor, type Product } from '../plan-writer.ts';

/**
 * Writes slice.csv: the points the outline was found from, plan frame, source units and coordinates to 0.1 mm. One file
 * whatever the storeys, since the outline is found once, from one level of the whole scan (contract: slice.csv).
 *
 * @throws result/cannot-write for a plan without its scan
 */
export function writeSliceCsv({ plan, slice }: Product): string {
  if (slice.xy.length === 0) throw noPointsFor('slice.csv', 'slice');
  const { x, y, digits } = sourceCoordinates(plan.frame);
  const lines = ['x,y'];
  for (let i = 0; i < slice.xy.length; i += 2) {
    lines.push(`${decimal(x(slice.xy[i]), digits)},${decimal(y(slice.xy[i + 1]), digits)}`);
  }
  return `${lines.join('\n')}\n`;
}
