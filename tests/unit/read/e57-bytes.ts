import { bytesOf } from './memory-source.ts';

const PAYLOAD = 1020;

export interface E57Field {
  readonly name: string;
  /** Attributes of its prototype, `type` first: `type="Integer" minimum="0" maximum="9"`. */
  readonly prototype: string;
  /** As packed: whole numbers less their minimum, or floats. */
  readonly values: readonly (number | bigint)[];
  /** Bits of a packed value; 32 and 64 with `isFloat` are floats. */
  readonly bits: number;
  readonly isFloat?: boolean;
}

export interface E57ScanContent {
  readonly fields: readonly E57Field[];
  /** Elements beside the points: pose, limits. */
  readonly xml?: string;
  /** Told in place of the true number of records. */
  readonly recordCount?: number;
}

export interface E57Style {
  /** Into so many data packets a scan's bytestreams are cut, each at other places; 1 if not given. */
  readonly packets?: number;
  /** Between data packets; none if not given. */
  readonly between?: readonly Uint8Array[];
  /** Elements beside `data3D`. */
  readonly xml?: string;
}

/** Binary packets that hold no points. */
export const INDEX_PACKET = Uint8Array.of(0, 0, 31, 0, ...new Array<number>(28).fill(7));
export const IGNORED_PACKET = Uint8Array.of(2, 0, 7, 0, 1, 2, 3, 4);

/** An E57 file built byte by byte. */
export function e57Bytes(scans: readonly E57ScanContent[], style: E57Style = {}): Uint8Array<ArrayBuffer> {
  const parts: number[] = new Array<number>(48).fill(0);
  const children = scans.map((scan) => {
    const offset = physical(parts.length);
    append(parts, section(scan, parts.length, style));
    return scanXml(scan, offset);
  });
  const xmlAt = physical(parts.length);
  const xml = bytesOf(
    `<?xml version="1.0" encoding="UTF-8"?>\n<e57Root type="Structure" xmlns="http://www.astm.org/COMMIT/E57/2010-e57-v1.0">${style.xml ?? ''}<data3D type="Vector" allowHeterogeneousChildren="1">${children.join('')}</data3D></e57Root>\n`,
  );
  append(parts, xml);
  const pages = Math.ceil(parts.length / PAYLOAD);
  parts.splice(0, 48, ...header(1024 * pages, xmlAt, xml.length));
  return paged(Uint8Array.from(parts));
}

/** Puts right the checksum of every page. */
export function withChecksums(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const view = new DataView(bytes.buffer);
  for (let page = 0; page + 1024 <= bytes.length; page += 1024)
    view.setUint32(page + PAYLOAD, bitwiseCrc32c(bytes.subarray(page, page + PAYLOAD)), false);
  return bytes;
}

/** Bit by bit, from the definition. */
export function bitwiseCrc32c(bytes: Uint8Array): number {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ 0x82f63b78 : sum >>> 1;
  }
  return ~sum >>> 0;
}

/** Float64 fields of cartesian points. */
export function cartesianFields(points: readonly (readonly number[])[]): E57Field[] {
  return ['X', 'Y', 'Z'].map((axis, k) => ({
    name: `cartesian${axis}`,
    prototype: 'type="Float"',
    values: points.map((point) => point[k]),
    bits: 64,
    isFloat: true,
  }));
}

/** A field of whole numbers. */
export function integerField(name: string, least: number, most: number, values: readonly number[]): E57Field {
  return {
    name,
    prototype: `type="Integer" minimum="${least}" maximum="${most}"`,
    values: values.map((value) => value - least),
    bits: most > least ? BigInt(most - least).toString(2).length : 0,
  };
}

function header(fileBytes: number, xmlAt: number, xmlBytes: number): Uint8Array {
  const bytes = new Uint8Array(48);
  const view = new DataView(bytes.buffer);
  bytes.set(bytesOf('ASTM-E57'));
  view.setUint32(8, 1, true);
  [fileBytes, xmlAt, xmlBytes, 1024].forEach((value, i) => {
    view.setBigUint64(16 + 8 * i, BigInt(value), true);
  });
  return bytes;
}

function scanXml({ fields, xml = '', recordCount }: E57ScanContent, offset: number): string {
  const prototype = fields.map(({ name, prototype: type }) => `<${name} ${type}/>`).join('');
  const count = recordCount ?? fields[0]?.values.length ?? 0;
  return `<vectorChild type="Structure">${xml}<points type="CompressedVector" fileOffset="${offset}" recordCount="${count}"><prototype type="Structure">${prototype}</prototype><codecs type="Vector" allowHeterogeneousChildren="1"></codecs></points></vectorChild>`;
}

function section(
  { fields }: E57ScanContent,
  begin: number,
  { packets = 1, between = [] }: E57Style,
): number[] {
  const streams = fields.map(pack);
  const body: number[] = [];
  for (let packet = 0; packet < packets; packet++) {
    const cuts = streams.map((stream, i) => {
      // Uneven, so that fields drift apart.
      const at = (share: number) => Math.round(stream.length * share ** (1 + i / 4));
      return stream.subarray(at(packet / packets), at((packet + 1) / packets));
    });
    for (const other of between) append(body, other);
    append(body, dataPacket(cuts));
  }
  const head = new Uint8Array(32);
  const view = new DataView(head.buffer);
  view.setUint8(0, 1);
  view.setBigUint64(8, BigInt(32 + body.length), true);
  view.setBigUint64(16, BigInt(physical(begin + 32)), true);
  return [...head, ...body];
}

function dataPacket(streams: readonly Uint8Array[]): number[] {
  const sizes = streams.flatMap(({ length }) => [length & 255, length >> 8]);
  const bytes = [1, 0, 0, 0, streams.length & 255, streams.length >> 8, ...sizes];
  for (const stream of streams) append(bytes, stream);
  while (bytes.length % 4 > 0) bytes.push(0);
  bytes[2] = (bytes.length - 1) & 255;
  bytes[3] = (bytes.length - 1) >> 8;
  return bytes;
}

/** Too many arguments for `push` overflow the stack. */
function append(bytes: number[], more: ArrayLike<number>): void {
  for (let i = 0; i < more.length; i++) bytes.push(more[i]);
}

function pack({ values, bits, isFloat = false }: E57Field): Uint8Array {
  const bytes = new Uint8Array(Math.ceil((values.length * bits) / 8));
  values.forEach((value, i) => {
    let word = isFloat ? floatBits(Number(value), bits) : BigInt(value);
    for (let bit = i * bits; bit < (i + 1) * bits; bit++, word >>= 1n)
      bytes[bit >> 3] |= Number(word & 1n) << (bit & 7);
  });
  return bytes;
}

function floatBits(value: number, bits: number): bigint {
  const view = new DataView(new ArrayBuffer(8));
  if (bits === 32) view.setFloat32(0, value, true);
  else view.setFloat64(0, value, true);
  return view.getBigUint64(0, true);
}

function physical(logical: number): number {
  return Math.floor(logical / PAYLOAD) * 1024 + (logical % PAYLOAD);
}

function paged(logical: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(1024 * Math.ceil(logical.length / PAYLOAD));
  for (let page = 0; page * PAYLOAD < logical.length; page++)
    bytes.set(logical.subarray(page * PAYLOAD, (page + 1) * PAYLOAD), page * 1024);
  return withChecksums(bytes);
}
