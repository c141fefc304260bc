import type { E57Node } from './e57-node.ts';

const LEAST_INT64 = -(2n ** 63n);
const MOST_INT64 = 2n ** 63n - 1n;
const MOST_BITS = 64;
const HALF = 2n ** 32n;

/** How one field of the points lies in its bytestream, and what it means: scale · (packed + minimum) + shift. */
export interface PackedField {
  readonly name: string;
  readonly kind: 'integer' | 'float32' | 'float64' | 'text';
  /** Of one value; 0 where all are the minimum. */
  readonly bits: number;
  /** minimum = high · 2³² + low, both whole: sums with packed values stay exact beyond 2⁵³. */
  readonly minimum: { readonly high: number; readonly low: number };
  readonly scale: number;
  readonly shift: number;
  /** Least and greatest value where the file states them. */
  readonly range: Range | null;
}

export interface Range {
  readonly low: number;
  readonly high: number;
}

/** What a scan's points hold, in the order of the bytestreams. */
export interface Prototype {
  readonly fields: readonly PackedField[];
  /** Range, azimuth and elevation instead of x, y and z. */
  readonly isSpherical: boolean;
  readonly hasColour: boolean;
  /** What stands for 0 and full colour in red, green and blue; 0 and 1 in intensity. */
  readonly limits: ReadonlyMap<string, Range>;
}

export const CARTESIAN = ['cartesianX', 'cartesianY', 'cartesianZ'];
export const SPHERICAL = ['sphericalRange', 'sphericalAzimuth', 'sphericalElevation'];
export const COLOURS = ['colorRed', 'colorGreen', 'colorBlue'];
export const INTENSITY_NAME = 'intensity';

/** Reads what a scan's points hold ([E2807] §8.4.4). @throws input/malformed */
export function readPrototype(scan: E57Node, points: E57Node): Prototype {
  const fields = leavesOf(points.child('prototype')).map(readField);
  const hasAll = (names: readonly string[]) =>
    names.every((name) => fields.some((field) => field.name === name && field.kind !== 'text'));
  const isCartesian = hasAll(CARTESIAN);
  if (!isCartesian && !hasAll(SPHERICAL)) {
    const found = fields.map(({ name }) => name).join(', ');
    throw points.malformed('points with cartesian or spherical coordinates', found || 'none');
  }
  for (const codec of points.child('codecs')?.children ?? []) {
    const unknown = codec.children.find(({ name }) => name !== 'inputs' && name !== 'bitPackCodec');
    if (unknown) throw unknown.malformed('no codec but bitPackCodec', unknown.name);
  }
  const limits = new Map<string, Range>();
  for (const field of fields) {
    const range = [statedLimits(scan, field.name), field.range].find((one) => one && one.high > one.low);
    if (range) limits.set(field.name, range);
  }
  return { fields, isSpherical: !isCartesian, hasColour: hasAll(COLOURS), limits };
}

/** A prototype may hold structures; its bytestreams are those of the leaves. */
function leavesOf(node: E57Node | undefined): E57Node[] {
  if (!node) return [];
  return node.children.flatMap((child) => (child.type === 'Structure' ? leavesOf(child) : [child]));
}

function readField(node: E57Node): PackedField {
  const { name, type } = node;
  const plain = { name, minimum: { high: 0, low: 0 }, scale: 1, shift: 0, range: null };
  if (type === 'String') return { ...plain, kind: 'text', bits: 0 };
  if (type === 'Integer' || type === 'ScaledInteger') return readInteger(node);
  if (type !== 'Float') throw node.malformed('Integer, ScaledInteger, Float or String', type);
  const isSingle = node.attributeText('precision') === 'single';
  const isStated = node.hasAttribute('minimum') && node.hasAttribute('maximum');
  return {
    ...plain,
    kind: isSingle ? 'float32' : 'float64',
    bits: isSingle ? 32 : 64,
    range: isStated ? { low: node.attribute('minimum', 0), high: node.attribute('maximum', 0) } : null,
  };
}

function readInteger(node: E57Node): PackedField {
  const least = node.integerAttribute('minimum', LEAST_INT64);
  const most = node.integerAttribute('maximum', MOST_INT64);
  const bits = most > least ? (most - least).toString(2).length : 0;
  if (most < least || bits > MOST_BITS)
    throw node.malformed('a minimum below the maximum', `${least} … ${most}`);
  const isScaled = node.type === 'ScaledInteger';
  const scale = isScaled ? node.attribute('scale', 1) : 1;
  const shift = isScaled ? node.attribute('offset', 0) : 0;
  const low = BigInt.asUintN(32, least);
  const isStated = node.hasAttribute('minimum') && node.hasAttribute('maximum');
  return {
    name: node.name,
    kind: 'integer',
    bits,
    minimum: { high: Number((least - low) / HALF), low: Number(low) },
    scale,
    shift,
    range: isStated ? { low: Number(least) * scale + shift, high: Number(most) * scale + shift } : null,
  };
}

/** `colorLimits` and `intensityLimits`: what the scanner can tell apart, whatever the field could hold. */
function statedLimits(scan: E57Node, field: string): Range | null {
  const limits = scan.child(field === INTENSITY_NAME ? 'intensityLimits' : 'colorLimits');
  const [low, high] = ['Minimum', 'Maximum'].map((end) => limits?.child(`${field}${end}`));
  return low && high ? { low: low.number(), high: high.number() } : null;
}
