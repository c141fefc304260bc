import { gzipSync, type Zippable, zipSync } from 'fflate';
import type { Random } from '../../fixtures/simulator/random.ts';
import { COPC_SEEDS, E57_SEEDS, LAS_SEEDS, LAZ_SEEDS, NOTE } from './binary-seeds.ts';
import { GLB_SEEDS } from './model-seeds.ts';
import { mutate } from './mutate.ts';
import { type Bytes, placesOf, type Seed } from './seed.ts';
import { CSV_SEEDS, OBJ_SEEDS, PCD_SEEDS, PLY_SEEDS, PTS_SEEDS, PTX_SEEDS } from './text-seeds.ts';

/** What an archive is made of. */
const INNER: readonly (readonly Seed[])[] = [
  ...[PLY_SEEDS, LAS_SEEDS, LAZ_SEEDS, COPC_SEEDS, E57_SEEDS, PTX_SEEDS],
  ...[PTS_SEEDS, PCD_SEEDS, GLB_SEEDS, OBJ_SEEDS, CSV_SEEDS],
];
const BOMB_BYTES = 1 << 22;
/** Large enough to be spoken of as packed a thousand times; made once. */
const BOMB = gzipSync(new Uint8Array(BOMB_BYTES)) as Bytes;

function gzipSeed(inner: Seed, level: 0 | 6): Seed {
  const bytes = gzipSync(inner.bytes, { level, mtime: 0 }) as Bytes;
  return {
    name: `${inner.name}.gz`,
    bytes,
    boundaries: [2, 3, 4, 8, 10, bytes.length - 8, bytes.length - 4],
    body: [10, bytes.length],
    text: [],
    // Any other damage the checksum tells at once.
    remadeShare: 0.85,
    remake: (random) => {
      const die = random.next();
      if (die < 0.03) return gzipSync(BOMB) as Bytes;
      if (die < 0.06) return gzipSync(gzipSync(gzipSync(gzipSync(inner.bytes)))) as Bytes;
      if (die < 0.1) return joined(gzipSync(mutate(inner, random)), gzipSync(inner.bytes));
      return gzipSync(mutate(inner, random), { level: random.pick([0, 1, 6]), mtime: 0 }) as Bytes;
    },
  };
}

function joined(...parts: readonly Uint8Array[]): Bytes {
  return Uint8Array.from(Buffer.concat(parts));
}

const MARKS = ['PK\x03\x04', 'PK\x01\x02', 'PK\x05\x06', 'PK\x06\x06', 'PK\x06\x07'];
/** Fields of a local header, of the directory and of its end. */
const FIELDS = [0, 6, 8, 10, 12, 16, 18, 20, 22, 24, 26, 28, 30, 42, 46];

function zipSeed(name: string, files: Zippable, inner: readonly Seed[]): Seed {
  const bytes = zipSync(files, { mtime: '2020-01-01' }) as Bytes;
  const marks = MARKS.flatMap((mark) => placesOf(bytes, mark).filter((_, i) => i % 2 === 0));
  return {
    name,
    bytes,
    boundaries: marks
      .flatMap((mark) => FIELDS.map((field) => mark + field))
      .filter((at) => at < bytes.length),
    // The first file's bytes.
    body: [30, marks[1] ?? bytes.length],
    text: [],
    isRigid: true,
    remake: (random) => remakeZip(inner, random),
  };
}

function remakeZip(inner: readonly Seed[], random: Random): Bytes {
  const files: Zippable = {};
  const count = random.pick([1, 1, 1, 2, 3]);
  for (let i = 0; i < count; i++) {
    const seed = random.pick(inner);
    const content = i === 0 || random.chance(0.3) ? mutate(seed, random) : seed.bytes;
    files[`${i}/${seed.name}`] = [content, { level: random.pick([0, 0, 6]) }];
  }
  const die = random.next();
  if (die < 0.02) files['bomb.gz'] = [BOMB, { level: 0 }];
  else if (die < 0.05) files['in.zip'] = [zipSync(structuredClone(files)), { level: 0 }];
  else if (die < 0.15) files['note.txt'] = NOTE;
  else if (die < 0.16) for (let i = 0; i < 5000; i++) files[`${i}`] = new Uint8Array(0);
  const bytes = zipSync(files, { mtime: '2020-01-01' }) as Bytes;
  return random.chance(0.1) ? with64Bits(bytes, random) : bytes;
}

/** The end of the directory told in 64 bits too, as for archives of more than 4 GB. */
function with64Bits(bytes: Bytes, random: Random): Bytes {
  const end = placesOf(bytes, 'PK\x05\x06')[0];
  const from = new DataView(bytes.buffer);
  const record = new DataView(new ArrayBuffer(56 + 20));
  record.setUint32(0, 0x06064b50, true);
  record.setBigUint64(4, 44n, true);
  record.setBigUint64(32, BigInt(from.getUint16(end + 10, true)), true);
  record.setBigUint64(40, BigInt(from.getUint32(end + 12, true)), true);
  record.setBigUint64(48, BigInt(from.getUint32(end + 16, true)), true);
  record.setUint32(56, 0x07064b50, true);
  record.setBigUint64(64, BigInt(end), true);
  if (random.chance(0.5)) record.setUint8(random.integer(0, 75), random.pick([0, 1, 127, 255]));
  return joined(bytes.subarray(0, end), new Uint8Array(record.buffer), bytes.subarray(end));
}

export const GZIP_SEEDS: readonly Seed[] = INNER.flatMap((seeds, i) => [
  gzipSeed(seeds[0], 6),
  gzipSeed(seeds[seeds.length - 1], i % 2 === 0 ? 0 : 6),
]);

export const ZIP_SEEDS: readonly Seed[] = INNER.map((seeds) => {
  const [{ name, bytes }] = seeds;
  const files: Zippable = { [`tiles/${name}`]: [bytes, { level: 0 }], [name]: bytes };
  return zipSeed(`${name}.zip`, files, seeds);
});
