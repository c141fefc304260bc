import { distance } from '../../fixtures/simulator/ring.ts';
import type { Truth } from '../../fixtures/simulator/truth.ts';
import { type OpeningFacts, type PlanFile, pairStoreys, type StoreyFacts, type StoreyPair } from './facts.ts';
import { assign, countPairs } from './matching.ts';
import { measureInferred } from './measure-inferred.ts';
import { measureStructured3d } from './measure-structured3d.ts';
import { measureWalls } from './measure-walls.ts';
import { f1, inferredShares, type Measures, meanOfStoreys } from './measures.ts';
import { clockwise, cornersOf, offsets, quantile, sampleRings } from './outlines.ts';
import {
  areaOf,
  intersectionOverUnion,
  type Polygon,
  type Region,
  regionOf,
  sharedArea,
  unite,
  withoutHoles,
} from './regions.ts';
import { isValidPolygon } from './validity.ts';

/** A room or structure counts as found above this IoU. */
const MATCH_IOU = 0.5;
/** A found room that shares more than this part of itself with another is not right. */
const OVERLAP_SHARE = 0.05;
/** m */
const FACE_REACH = 0.1;
/** m */
const OPENING_REACH = 0.5;
const MM = 1000;

/**
 * How good a plan is, in the measures of `MEASURES`; buildings of several storeys give the mean over them.
 *
 * Agrees with the reference scorer on every figure they share, for valid polygons; the Hungarian method pairs rooms
 * and structures by IoU, maximum matching pairs corners and openings.
 */
export function measurePlan(plan: PlanFile, truth: Truth): Measures {
  const storeys = pairStoreys(plan, truth).map(measureStorey);
  return storeys.length === 1 ? storeys[0] : meanOfStoreys(storeys);
}

function measureStorey({ plan, truth }: StoreyPair): Measures {
  return {
    ...measureFootprint(plan, truth),
    ...measureRooms(plan, truth),
    ...measureStructures(plan, truth),
    ...measureOpenings(plan, truth),
    ...measureWalls(plan, truth),
    ...withShares(measureInferred(plan, truth)),
    invalidCount: countInvalid(plan),
    ...measureStructured3d(plan, truth),
  };
}

function withShares(lengths: Measures): Measures {
  return { ...lengths, ...inferredShares(lengths) };
}

/** Shared by two rooms where coordinates of 0.1 mm do not tell better, m². */
const SHARED_BY_ROUNDING = 1e-3;

function countInvalid({ primary, rooms, structures, walls }: StoreyFacts): number {
  const polygons = [...primary, ...rooms, ...structures, ...walls.map(({ outline }) => outline)];
  const regions = rooms.map(regionOf);
  const overlaps = regions.flatMap((room, i) =>
    regions.slice(i + 1).filter((other) => sharedArea(room, other) > SHARED_BY_ROUNDING),
  );
  return polygons.filter((polygon) => !isValidPolygon(polygon)).length + overlaps.length;
}

function measureFootprint(plan: StoreyFacts, truth: StoreyFacts): Measures {
  if (plan.primary.length === 0) return {};
  const found = withoutHoles(unite(plan.primary.map(regionOf)));
  const wanted = regionOf(truth.primary[0]);
  const samples = sampleRings(plan.primary.map(([outer]) => clockwise(outer)));
  const wantedOuter = truth.primary[0].slice(0, 1);
  return {
    footprintIou: intersectionOverUnion(found, wanted),
    footprintAreaErrorPct: (100 * (areaOf(found) - areaOf(wanted))) / areaOf(wanted),
    footprintP95: quantile(offsets(samples, wantedOuter), 0.95),
    boundaryVertices: plan.primary.reduce((sum, [outer]) => sum + outer.length, 0),
    valid: [...plan.primary, ...plan.rooms, ...plan.structures].every(isValidPolygon) ? 1 : 0,
  };
}

function measureRooms(plan: StoreyFacts, truth: StoreyFacts): Measures {
  if (plan.rooms.length === 0) return { roomF1: 0, cornerF1At10cm: 0 };
  return { ...matchRooms(plan, truth), ...measureCorners(plan, truth), ...measureFaces(plan, truth) };
}

function matchRooms(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const found = plan.rooms.map(regionOf);
  const wanted = truth.rooms.map(regionOf);
  const shared = found.map((room, i) => found.map((other, k) => (k === i ? 0 : sharedArea(room, other))));
  const isClear = found.map((room, i) => shared[i].every((area) => area <= OVERLAP_SHARE * areaOf(room)));
  const iou = intersections(found, wanted);
  const matched = assign(iou).filter(([i, k]) => iou[i][k] > MATCH_IOU && isClear[i]);
  const precision = matched.length / found.length;
  const recall = matched.length / wanted.length;
  const mean = (values: readonly number[]): number => values.reduce((a, b) => a + b, 0) / values.length;
  const areaErrors = matched.map(
    ([i, k]) => (100 * Math.abs(areaOf(found[i]) - areaOf(wanted[k]))) / areaOf(wanted[k]),
  );
  const heightErrors = matched
    .map(([i, k]) => Math.abs(plan.roomHeights[i] - truth.roomHeights[k]) * MM)
    .filter(Number.isFinite);
  return {
    roomPrecision: precision,
    roomRecall: recall,
    roomF1: f1(precision, recall),
    roomIou: matched.length > 0 ? mean(matched.map(([i, k]) => iou[i][k])) : 0,
    ...(areaErrors.length > 0 && { roomAreaErrorPct: mean(areaErrors) }),
    ...(heightErrors.length > 0 && { roomHeightErrorMm: quantile(heightErrors, 0.5) }),
    roomOverlapM2: shared.flat().reduce((a, b) => a + b, 0) / 2,
  };
}

function intersections(found: readonly Region[], wanted: readonly Region[]): number[][] {
  return found.map((a) => wanted.map((b) => intersectionOverUnion(a, b)));
}

function measureCorners(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const found = cornersOf(outersOf(plan.rooms));
  const wanted = cornersOf(outersOf(truth.rooms));
  const score = (radius: number): number => {
    const right = countPairs(found, wanted, radius);
    return f1(right / Math.max(1, found.length), right / Math.max(1, wanted.length));
  };
  return {
    cornerF1At5cm: score(0.05),
    cornerF1At10cm: score(0.1),
    cornerF1At20cm: score(0.2),
    cornerF1At30cm: score(0.3),
  };
}

const outersOf = (polygons: readonly Polygon[]) => polygons.map(([outer]) => outer);

function measureFaces(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const found = outersOf(plan.rooms).map(clockwise);
  const wanted = outersOf(truth.rooms);
  const toFound = offsets(sampleRings(wanted), found);
  const toWanted = offsets(sampleRings(found), wanted);
  const close = toWanted.filter((value) => value <= FACE_REACH);
  const near = (values: readonly number[]): number =>
    values.filter((value) => value <= FACE_REACH).length / values.length;
  return {
    faceCompleteness: near(toFound),
    faceCorrectness: near(toWanted),
    faceMedianMm: quantile(toWanted, 0.5) * MM,
    ...(close.length > 0 ? { isprsAccuracyMm: quantile(close, 0.5) * MM } : {}),
  };
}

function measureStructures(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const [found, wanted] = [plan.structures.map(regionOf), truth.structures.map(regionOf)];
  if (found.length + wanted.length === 0) return {};
  const iou = intersections(found, wanted);
  const right = assign(iou).filter(([i, k]) => iou[i][k] > MATCH_IOU).length;
  return {
    structuresFound: found.length,
    structuresTrue: wanted.length,
    structuresMatched: right,
    structureF1: f1(right / Math.max(1, found.length), right / Math.max(1, wanted.length)),
  };
}

function measureOpenings(plan: StoreyFacts, truth: StoreyFacts): Measures {
  const door = openingsOf('door', plan, truth);
  const window = openingsOf('window', plan, truth);
  const passage = openingsOf('passage', plan, truth);
  const figures: { readonly [K in keyof Measures]: number | undefined } = {
    doorF1: door.f1,
    windowF1: window.f1,
    passageF1: passage.f1,
    doorWidthErrorMm: door.median('width'),
    windowWidthErrorMm: window.median('width'),
    passageWidthErrorMm: passage.median('width'),
    openingWidthErrorMm: medianOf([door, window, passage].flatMap(({ errors }) => errors('width'))),
    doorHeadErrorMm: door.median('head'),
    windowSillErrorMm: window.median('sill'),
    windowHeadErrorMm: window.median('head'),
  };
  return Object.fromEntries(Object.entries(figures).filter(([, value]) => value !== undefined));
}

interface OpeningScore {
  readonly f1: number | undefined;
  /** Over true openings with a found one near, mm. */
  errors(side: 'width' | 'sill' | 'head'): number[];
  median(side: 'width' | 'sill' | 'head'): number | undefined;
}

function openingsOf(kind: OpeningFacts['kind'], plan: StoreyFacts, truth: StoreyFacts): OpeningScore {
  const found = plan.openings.filter((opening) => opening.kind === kind);
  const wanted = truth.openings.filter((opening) => opening.kind === kind);
  const centres = (openings: readonly OpeningFacts[]) => openings.map(({ centre }) => centre);
  const right = countPairs(centres(found), centres(wanted), OPENING_REACH);
  const pairs = wanted.flatMap((truly) => {
    const near = found.find(({ centre }) => distance(centre, truly.centre) < OPENING_REACH);
    return near ? [{ near, truly }] : [];
  });
  const errors: OpeningScore['errors'] = (side) =>
    pairs.map(({ near, truly }) => Math.abs(near[side] - truly[side]) * MM).filter(Number.isFinite);
  return {
    errors,
    f1:
      found.length + wanted.length === 0
        ? undefined
        : f1(right / Math.max(1, found.length), right / Math.max(1, wanted.length)),
    median: (side) => medianOf(errors(side)),
  };
}

function medianOf(values: readonly number[]): number | undefined {
  return values.length > 0 ? quantile(values, 0.5) : undefined;
}
