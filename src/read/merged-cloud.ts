import { FloorPlanError } from '../core/errors.ts';
import type { Vec3, Warning } from '../core/types.ts';
import type { OpenCloud, PointChunk, ReadProgress } from './cloud-reader.ts';

/** A cloud that is a part of a scan. */
export interface CloudPart {
  readonly name: string;
  readonly cloud: OpenCloud;
  /** Bytes to be read of it, where known. */
  readonly size: number | undefined;
}

/**
 * Several clouds in one system of coordinates as one, part after part: tiles, or the scans of several stations.
 *
 * @param parts at least one
 * @param found what is to be warned of beside
 * @throws input/malformed, where parts differ in kind or unit
 */
export function mergeClouds(parts: readonly CloudPart[], found: readonly Warning[] = []): OpenCloud {
  if (parts.length === 1) {
    const [{ cloud }] = parts;
    cloud.warnings.push(...found);
    return cloud;
  }
  const own = [...found, ...mixedCrs(parts)];
  const warnings = [...own];
  const stations: Vec3[] = [];
  const crs = parts.find(({ cloud }) => cloud.crs !== undefined)?.cloud.crs;
  const unit = agreed(parts, 'unit', ({ cloud }) => cloud.unit);
  const up = agreed(parts, 'up axis', ({ cloud }) => cloud.up);
  const counts = parts.map(({ cloud }) => cloud.pointsAnnounced);
  return {
    isSlice: agreed(parts, 'kind', kindOf) === SLICE,
    isAdaptive: parts.some(({ cloud }) => cloud.isAdaptive),
    // Where only some are grids, points without a place may be lost ones of the others.
    ...(parts.every(({ cloud }) => cloud.hasEmptyPlaces) && { hasEmptyPlaces: true }),
    ...(unit && { unit }),
    ...(up && { up }),
    ...(crs && { crs }),
    ...(!counts.includes(undefined) && {
      pointsAnnounced: counts.reduce<number>((sum, n) => sum + (n ?? 0), 0),
    }),
    stations,
    warnings,
    chunks(progress, ...rest) {
      warnings.splice(0, Infinity, ...own);
      stations.length = 0;
      return readParts({ parts, stations, warnings }, progress, rest);
    },
  };
}

interface Merging {
  readonly parts: readonly CloudPart[];
  readonly stations: Vec3[];
  readonly warnings: Warning[];
}

async function* readParts(
  { parts, stations, warnings }: Merging,
  progress: ReadProgress,
  rest: readonly [spacing: number, budget?: number | undefined],
): AsyncGenerator<PointChunk> {
  let before = 0;
  for (const { name, cloud, size } of parts) {
    let read = 0;
    const firstStation = stations.length;
    const tell = (bytes: number) => {
      read = bytes;
      progress(before + bytes);
    };
    for await (const chunk of cloud.chunks(tell, ...rest)) yield withStations(chunk, firstStation);
    before += size ?? read;
    stations.push(...(cloud.stations ?? []));
    warnings.push(
      ...cloud.warnings.map((warning) => ({ ...warning, message: `${name}: ${warning.message}` })),
    );
  }
}

/** Stations are counted on from those of the parts before. */
function withStations(chunk: PointChunk, first: number): PointChunk {
  if (!chunk.station || first === 0) return chunk;
  return { ...chunk, station: chunk.station.map((index) => index + first) };
}

const SLICE = 'a ready slice';

function kindOf({ cloud }: CloudPart): string {
  return cloud.isSlice ? SLICE : 'a 3D cloud';
}

/** What the parts that say it say alike. @throws input/malformed, where they do not */
function agreed<T extends string>(
  parts: readonly CloudPart[],
  what: string,
  of: (part: CloudPart) => T | undefined,
): T | undefined {
  const first = parts.find((part) => of(part) !== undefined);
  const other = first && parts.find((part) => of(part) !== undefined && of(part) !== of(first));
  if (!first || !other) return first && of(first);
  throw new FloorPlanError(
    'input/malformed',
    `expected files of one ${what} to merge, found ${of(first)} in ${first.name} and ${of(other)} in ${other.name}`,
    { hint: 'Load them one at a time.' },
  );
}

function mixedCrs(parts: readonly CloudPart[]): readonly Warning[] {
  const named = parts.filter(({ cloud }) => cloud.crs !== undefined);
  const other = named.find(({ cloud }) => cloud.crs !== named[0].cloud.crs);
  if (!other) return [];
  return [
    {
      code: 'read/mixed-crs',
      message: `${named[0].name} and ${other.name} name different coordinate systems; their coordinates are taken as they are.`,
      hint: 'If the parts do not fit together, bring them into one system first.',
    },
  ];
}
