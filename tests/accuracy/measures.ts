interface MeasureRow {
  readonly label: string;
  readonly doc: string;
  readonly digits: number;
  /** A share is 0 for a scene without a plan; other measures are then unknown. Sums add up over storeys and scenes. */
  readonly kind: 'share' | 'error' | 'count' | 'sum';
  /** Its name in the reference scorer `score.py`. */
  readonly reference?: string;
}

const row = (
  label: string,
  digits: number,
  kind: MeasureRow['kind'],
  doc: string,
  reference?: string,
): MeasureRow =>
  reference === undefined ? { label, digits, kind, doc } : { label, digits, kind, doc, reference };

/** Every measure: names, table columns, and what the reference calls it. */
export const MEASURES = {
  footprintIou: row(
    'footprint IoU',
    3,
    'share',
    'Primary boundary against the interior outline.',
    'footprint_iou',
  ),
  footprintAreaErrorPct: row('area err %', 2, 'error', 'Its area, signed.', 'footprint_area_err_pct'),
  footprintP95: row(
    'p95 m',
    3,
    'error',
    '95th percentile distance of its samples to the truth.',
    'footprint_p95_m',
  ),
  boundaryVertices: row('vertices', 0, 'count', 'Of the primary boundary.', 'boundary_vertices'),
  valid: row('valid', 2, 'share', 'Every ring simple, every polygon valid.', 'valid'),
  roomPrecision: row('room P', 2, 'share', 'Found rooms that are right.', 'room_p'),
  roomRecall: row('room R', 2, 'share', 'True rooms that are found.', 'room_r'),
  roomF1: row('room F1', 2, 'share', 'Rooms matched with IoU above 0.5, without overlap.', 'room_f1'),
  roomIou: row('room IoU', 3, 'share', 'Mean of matched rooms.', 'room_iou'),
  roomAreaErrorPct: row('room area %', 2, 'error', 'Mean of matched rooms.', 'room_area_err_pct'),
  roomOverlapM2: row('overlap m²', 3, 'error', 'Area that rooms share.'),
  roomHeightErrorMm: row('height mm', 0, 'error', 'Median of matched rooms.'),
  cornerF1At5cm: row('corner 5', 2, 'share', 'Corners within 5 cm.', 'corner_f1_5cm'),
  cornerF1At10cm: row('corner 10', 2, 'share', 'Corners within 10 cm.', 'corner_f1_10cm'),
  cornerF1At20cm: row('corner 20', 2, 'share', 'Corners within 20 cm.', 'corner_f1_20cm'),
  cornerF1At30cm: row('corner 30', 2, 'share', 'Corners within 30 cm.', 'corner_f1_30cm'),
  faceCompleteness: row(
    'face compl',
    3,
    'share',
    'True faces within 10 cm of a found one.',
    'face_completeness_10cm',
  ),
  faceCorrectness: row(
    'face corr',
    3,
    'share',
    'Found faces within 10 cm of a true one.',
    'face_correctness_10cm',
  ),
  faceMedianMm: row('face mm', 1, 'error', 'Median distance of found faces to true ones.', 'face_median_mm'),
  structuresFound: row('SB found', 0, 'count', 'Secondary boundaries in the plan.', 'sb_found'),
  structuresTrue: row('SB true', 0, 'count', 'Columns in the truth.', 'sb_true'),
  structuresMatched: row('SB right', 0, 'count', 'With IoU above 0.5.', 'sb_tp'),
  structureF1: row('SB F1', 2, 'share', 'Pooled over scenes in the mean.', 'sb_f1'),
  doorF1: row('door F1', 2, 'share', 'Centres within 0.5 m.', 'door_f1'),
  windowF1: row('window F1', 2, 'share', 'Centres within 0.5 m.', 'window_f1'),
  passageF1: row('passage F1', 2, 'share', 'Centres within 0.5 m.', 'passage_f1'),
  doorWidthErrorMm: row('door w mm', 0, 'error', 'Median.', 'door_width_err_mm'),
  windowWidthErrorMm: row('win w mm', 0, 'error', 'Median.', 'window_width_err_mm'),
  passageWidthErrorMm: row('pass w mm', 0, 'error', 'Median.', 'passage_width_err_mm'),
  doorHeadErrorMm: row('door h mm', 0, 'error', 'Median.'),
  windowSillErrorMm: row('sill mm', 0, 'error', 'Median.'),
  windowHeadErrorMm: row('win h mm', 0, 'error', 'Median.'),
  openingWidthErrorMm: row('open w mm', 0, 'error', 'Median over openings of all kinds.'),
  wallThicknessErrorMm: row(
    'thick mm',
    0,
    'error',
    'Median over walls with both faces seen, inferred ones left out.',
  ),
  wallsMeasured: row(
    'thick known',
    2,
    'share',
    'Walls with both faces seen whose thickness the plan claims to know.',
  ),
  outerThicknessErrorMm: row(
    'outer thick mm',
    0,
    'error',
    'Median over outer walls the plan claims to know.',
  ),
  wallsInferred: row('walls inferred', 0, 'count', 'Walls of the plan with an assumed thickness.'),
  inferredM: row('inferred m', 1, 'sum', 'Length of the stretches the plan calls inferred.'),
  inferredRightM: row('of it right', 1, 'sum', 'Length of those that no ray met indeed.'),
  hiddenM: row('hidden m', 1, 'sum', 'Length of the stretches of wall, 30 cm or longer, that no ray met.'),
  hiddenToldM: row('of it told', 1, 'sum', 'Length of those that the plan calls inferred.'),
  inferredPrecision: row('inferred P', 2, 'share', 'Inferred stretches that are right, by length; pooled.'),
  inferredRecall: row('inferred R', 2, 'share', 'Hidden stretches that are told, by length; pooled.'),
  invalidCount: row(
    'invalid',
    2,
    'error',
    'Invalid polygons, and pairs of rooms that share more than 10 cm².',
  ),
  watertight: row(
    'solid closed',
    2,
    'share',
    'Every part of the model is a closed two-manifold, by the report.',
  ),
  isprsAccuracyMm: row(
    'ISPRS acc mm',
    1,
    'error',
    'Median distance of found faces within 10 cm of a true one.',
  ),
  s3dRoomPrecision: row('S3D room P', 3, 'share', 'Structured3D protocol on a map of 256 px.'),
  s3dRoomRecall: row('S3D room R', 3, 'share', 'Structured3D protocol on a map of 256 px.'),
  s3dCornerPrecision: row('S3D corner P', 3, 'share', 'Within 10 px.'),
  s3dCornerRecall: row('S3D corner R', 3, 'share', 'Within 10 px.'),
  s3dAnglePrecision: row('S3D angle P', 3, 'share', 'Within 5°.'),
  s3dAngleRecall: row('S3D angle R', 3, 'share', 'Within 5°.'),
} as const satisfies Record<string, MeasureRow>;

export type MeasureName = keyof typeof MEASURES;
/** Figures of a scene; what its plan or truth has nothing to say about is left out. */
export type Measures = Partial<Record<MeasureName, number>>;

export const MEASURE_NAMES = Object.keys(MEASURES) as readonly MeasureName[];

export function rowOf(name: MeasureName): MeasureRow {
  return MEASURES[name];
}

/** Harmonic mean of precision and recall. */
export function f1(precision: number, recall: number): number {
  return precision + recall === 0 ? 0 : (2 * precision * recall) / (precision + recall);
}

/** As the reference does: the mean over storeys, where a figure of the reference that a storey lacks counts 0. */
export function meanOfStoreys(storeys: readonly Measures[]): Measures {
  const mean = meanBy(storeys, (name) => rowOf(name).reference !== undefined);
  return withSums(mean, storeys);
}

/** Lengths add up, and the shares made of them with them. */
function withSums(mean: Measures, items: readonly Measures[]): Measures {
  const sums: Measures = { ...mean };
  for (const name of MEASURE_NAMES) {
    if (rowOf(name).kind !== 'sum' || mean[name] === undefined) continue;
    sums[name] = items.reduce((sum, item) => sum + (item[name] ?? 0), 0);
  }
  return { ...sums, ...inferredShares(sums) };
}

/** Precision and recall by length; unknown where nothing was told or asked. */
export function inferredShares({ inferredM, inferredRightM, hiddenM, hiddenToldM }: Measures): Measures {
  return {
    ...(inferredM ? { inferredPrecision: (inferredRightM ?? 0) / inferredM } : {}),
    ...(hiddenM ? { inferredRecall: (hiddenToldM ?? 0) / hiddenM } : {}),
  };
}

/** Mean over scenes that have a figure; null stands for a scene without a plan. Structures are pooled. */
export function meanOfScenes(scenes: readonly (Measures | null)[]): Measures {
  const known = scenes.map((scene) => scene ?? NO_PLAN);
  const mean = withSums(
    meanBy(known, () => false),
    known,
  );
  const sum = (name: MeasureName): number => known.reduce((total, scene) => total + (scene[name] ?? 0), 0);
  const [found, wanted, right] = [sum('structuresFound'), sum('structuresTrue'), sum('structuresMatched')];
  if (found + wanted > 0) {
    mean.structuresFound = found;
    mean.structuresTrue = wanted;
    mean.structuresMatched = right;
    mean.structureF1 = f1(right / Math.max(1, found), right / Math.max(1, wanted));
  }
  return mean;
}

const NO_PLAN: Measures = { footprintIou: 0, valid: 0, roomF1: 0, cornerF1At10cm: 0 };

function meanBy(items: readonly Measures[], countsMissing: (name: MeasureName) => boolean): Measures {
  const mean: Measures = {};
  for (const name of MEASURE_NAMES) {
    const values = items.flatMap((item) => item[name] ?? []);
    if (values.length === 0) continue;
    mean[name] = values.reduce((a, b) => a + b, 0) / (countsMissing(name) ? items.length : values.length);
  }
  return mean;
}
