import { FloorPlanError } from '../core/errors.ts';
import { nameRooms } from '../core/name-rooms.ts';
import { resolveOptions } from '../core/options.ts';
import { type GivenValues, type Options, PARAM_NAMES, PARAMS, type ParamName } from '../core/params.ts';
import { formatRoomNames, parseRoomNames, type RoomName } from '../core/room-names.ts';
import { STAGE_NAMES } from '../core/stages.ts';
import type { FloorPlan, Warning } from '../core/types.ts';
import { isArchive, openArchive } from '../read/archive/open-archive.ts';
import type { ByteSource } from '../read/bytes/source.ts';
import { HEAD_BYTES } from '../read/signatures.ts';
import { parsePlanJson } from '../write/data/plan-json.ts';
import { unsoundOutlines } from './unsound-outlines.ts';

/** Longer than any plan of a building, and shorter than any text may be, bytes. */
const MOST_BYTES = 2 ** 28;
/** As the writer puts it, or an editor that sets spaces; properties in any order. */
const MARK = /^\uFEFF?\s*\{[\s\S]*?"format"\s*:\s*"grundriss-plan"/;

/** A plan, the options it is shown with, and what is to be said of them. */
export interface OpenedPlan {
  readonly plan: FloorPlan;
  readonly options: Options;
  /** That are none of the plan's own. */
  readonly warnings: readonly Warning[];
}

/**
 * The plan in a plan.json, told by its content; it may be gzipped, or in a ZIP, among all that was written with it. Null where
 * the source is none. Parts of a scan are never a plan, so a plan among several sources is passed over as no cloud.
 *
 * @throws input/malformed, input/too-large, option/unknown, option/invalid, and what sources and archives throw
 */
export async function readPlanFile(sources: readonly ByteSource[]): Promise<FloorPlan | null> {
  if (sources.length !== 1) return null;
  for (const source of await candidatesIn(sources[0])) {
    if (isPlan(await source.slice(0, HEAD_BYTES))) return parsePlanJson(await textOf(source));
  }
  return null;
}

/**
 * Lays over a plan what was given: parameters of the stages after it, the height of its walls and names of its rooms. All else
 * was decided with the points at hand.
 *
 * @throws option/unknown, option/invalid
 */
export function openPlan(read: FloorPlan, given: GivenValues): OpenedPlan {
  // Complains of what is wrong in it, whether it counts or not.
  const asked = resolveOptions(given);
  const names = PARAM_NAMES.filter((name) => given[name] !== undefined);
  const counting = names.filter(countsWithoutPoints);
  const changes: Partial<Options> = Object.fromEntries(counting.map((name) => [name, asked[name]]));
  const roomNames = changes.roomNames && withNames(read.options.roomNames, changes.roomNames);
  const options = resolveOptions({ ...read.options, ...changes, ...(roomNames && { roomNames }) });
  const lost = names.filter((name) => !countsWithoutPoints(name) && !isSaid(name, read.options, asked));
  const plan = changed({ ...read, options }, changes);
  return {
    plan,
    options,
    warnings: [...(lost.length > 0 ? [needScan(lost)] : []), ...unsoundOutlines(read)],
  };
}

/** Names that were given before, and after them those given now. */
function withNames(before: string, now: string): string {
  const names = parseRoomNames(now);
  const isOther = (old: RoomName) =>
    names.every(({ x, y, storey }) => x !== old.x || y !== old.y || storey !== old.storey);
  return formatRoomNames([...parseRoomNames(before).filter(isOther), ...names]);
}

/** With the walls as high and the rooms called as was given now. */
function changed(plan: FloorPlan, { wallHeight, roomNames }: Partial<Options>): FloorPlan {
  const isHigh = typeof wallHeight === 'number';
  const storeys = isHigh ? plan.storeys.map((storey) => ({ ...storey, height: wallHeight })) : plan.storeys;
  if (roomNames === undefined) return { ...plan, storeys };
  // A name that found no room before may be given again.
  const warnings = new Map(plan.warnings.map((warning) => [warning.message, warning]));
  const options = { ...plan.options, roomNames };
  const named = nameRooms({ ...plan, storeys, options }, (warning) => warnings.set(warning.message, warning));
  return { ...plan, storeys: named, warnings: [...warnings.values()] };
}

function countsWithoutPoints(name: ParamName): boolean {
  if (name === 'wallHeight' || name === 'roomNames') return true;
  return STAGE_NAMES.indexOf(PARAMS[name].stage) > STAGE_NAMES.indexOf('plan');
}

/** What the plan was made with all the same is not worth a word. */
function isSaid(name: ParamName, made: Options, asked: Options): boolean {
  return String(made[name]) === String(asked[name]);
}

function needScan(names: readonly ParamName[]): Warning {
  return {
    code: 'plan/needs-scan',
    message: `A plan without its scan was opened, so that ${names.join(', ')} cannot change it.`,
    hint: 'Load the scan to make the plan anew.',
  };
}

/** What may be a plan: the source itself, what it packs alone, or of many packed files those named as JSON. */
async function candidatesIn(source: ByteSource): Promise<readonly ByteSource[]> {
  const head = await source.slice(0, HEAD_BYTES);
  if (!isArchive(head)) return [source];
  const files = await openArchive(source, head);
  return files.length === 1 ? files : files.filter(({ name }) => name.toLowerCase().endsWith('.json'));
}

function isPlan(head: Uint8Array): boolean {
  return MARK.test(new TextDecoder().decode(head));
}

async function textOf(source: ByteSource): Promise<string> {
  const decoder = new TextDecoder('utf-8', { fatal: true });
  let [text, bytes] = ['', 0];
  try {
    for await (const piece of source.stream()) {
      bytes += piece.length;
      if (bytes > MOST_BYTES) throw tooLarge(source.name);
      text += decoder.decode(piece, { stream: true });
    }
    return text + decoder.decode();
  } catch (cause) {
    if (!(cause instanceof TypeError)) throw cause;
    throw new FloorPlanError(
      'input/malformed',
      `${source.name}: expected UTF-8, found other bytes before byte ${bytes}`,
      { hint: 'Save the plan as UTF-8.', cause },
    );
  }
}

function tooLarge(name: string): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected a plan of at most ${MOST_BYTES / 2 ** 20} MB, found more`,
    { hint: 'Give a plan.json as this program wrote it.' },
  );
}
