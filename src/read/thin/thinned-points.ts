import type { PointAttributes, Vec3 } from '../../core/types.ts';
import type { CellBlocks } from './cell-blocks.ts';
import type { AttributeSet, PointRecords } from './point-records.ts';

/** Points that thinning has kept, in an order that depends on nothing but the points. */
export interface ThinnedPoints<T> {
  readonly count: number;
  /** x, y, z a point, source units, relative to an origin. */
  readonly positions: T;
  readonly attributes: PointAttributes;
  /** Whether every coordinate is a 32-bit float. */
  readonly areSingle: boolean;
}

/** Copies points out of their blocks, in order, step by step. @param make room for so many values */
export function* copyInOrder<T extends Float32Array | Float64Array>(
  blocks: CellBlocks,
  origin: Vec3,
  make: (length: number) => T,
): Generator<void, ThinnedPoints<T>> {
  const room = blocks.held;
  const positions = make(3 * room);
  const attributes = emptyAttributes(blocks.records.has, room);
  const hasAttributes = Object.keys(attributes).length > 0;
  let count = 0;
  let areSingle = true;
  yield* blocks.visitInOrder((records, places) => {
    copyPositions(blocks.records, records, { origin, into: positions, places });
    areSingle &&= haveSingles(blocks.records, records);
    if (hasAttributes) blocks.records.getAttributes(records, attributes, places);
    count += records.length;
  });
  if (count === room) return { count, positions, attributes, areSingle };
  return {
    count,
    positions: positions.slice(0, 3 * count) as T,
    attributes: shortened(attributes, count),
    areSingle,
  };
}

interface Target {
  readonly origin: Vec3;
  readonly into: Float32Array | Float64Array;
  /** Which point of `into` each record becomes. */
  readonly places: Uint32Array;
}

function copyPositions({ xyz, stride }: PointRecords, records: Uint32Array, target: Target): void {
  const { into, places } = target;
  const [x, y, z] = target.origin;
  for (let i = 0; i < records.length; i++) {
    const at = Math.imul(stride, records[i]);
    const to = Math.imul(3, places[i]);
    into[to] = xyz[at] - x;
    into[to + 1] = xyz[at + 1] - y;
    into[to + 2] = xyz[at + 2] - z;
  }
}

function haveSingles({ xyz, stride }: PointRecords, listed: Uint32Array): boolean {
  for (let i = 0; i < listed.length; i++) {
    for (let at = stride * listed[i], end = at + 3; at < end; at++)
      if (xyz[at] !== Math.fround(xyz[at])) return false;
  }
  return true;
}

function emptyAttributes(has: AttributeSet, count: number): PointAttributes {
  return {
    ...(has.colour && { colour: new Uint8Array(3 * count) }),
    ...(has.intensity && { intensity: new Float32Array(count) }),
    ...(has.classification && { classification: new Uint8Array(count) }),
    ...(has.station && { station: new Uint16Array(count) }),
  };
}

function shortened(
  { colour, intensity, classification, station }: PointAttributes,
  count: number,
): PointAttributes {
  return {
    ...(colour && { colour: colour.slice(0, 3 * count) }),
    ...(intensity && { intensity: intensity.slice(0, count) }),
    ...(classification && { classification: classification.slice(0, count) }),
    ...(station && { station: station.slice(0, count) }),
  };
}
