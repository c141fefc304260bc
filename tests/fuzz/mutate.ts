import type { Random } from '../../fixtures/simulator/random.ts';
import { type ByteEdit, LOOSE_EDITS, RIGID_EDITS, splice, type Zone } from './mutate-bytes.ts';
import { mutateText } from './mutate-text.ts';
import { type Bytes, bytesOfLatin1, type Seed, type Span, textOf } from './seed.ts';

/** Of the mutants that are not made anew, so many are spoilt behind the header only. */
const BODY_SHARE = 0.7;
const REMADE_SHARE = 0.5;
const TEXT_SHARE = 0.7;
const REPAIRED_SHARE = 0.5;
const MOST_EDITS = 6;

/** A spoilt copy of a valid file. */
export function mutate(seed: Seed, random: Random): Bytes {
  if (seed.remake && random.chance(seed.remadeShare ?? REMADE_SHARE)) return seed.remake(random);
  const isInBody = random.chance(BODY_SHARE) && seed.body[1] > seed.body[0];
  const span: Span = isInBody ? seed.body : [0, seed.bytes.length];
  const spoilt = spoil(seed, span, random);
  return seed.repair && random.chance(REPAIRED_SHARE) ? seed.repair(spoilt) : spoilt;
}

function spoil(seed: Seed, span: Span, random: Random): Bytes {
  const texts = seed.text.map((text) => common(text, span)).filter(([begin, end]) => end > begin);
  if (texts.length > 0 && random.chance(TEXT_SHARE)) {
    const part = random.pick(texts);
    return splice(seed.bytes, part, bytesOfLatin1(mutateText(textOf(seed.bytes.subarray(...part)), random)));
  }
  const isRigid = seed.isRigid && span === seed.body;
  const edits: readonly ByteEdit[] = isRigid ? RIGID_EDITS : [...RIGID_EDITS, ...LOOSE_EDITS];
  const zone: Zone = { span, boundaries: seed.boundaries.filter((at) => at >= span[0] && at < span[1]) };
  let bytes: Bytes = seed.bytes.slice();
  const count = random.chance(0.5) ? 1 : random.integer(2, MOST_EDITS);
  for (let i = 0; i < count && bytes.length > 0; i++) bytes = random.pick(edits)(bytes, zone, random);
  return bytes;
}

function common([begin, end]: Span, [low, high]: Span): Span {
  return [Math.max(begin, low), Math.min(end, high)];
}
