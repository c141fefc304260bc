/**
 * The library: bytes → Scan → FloorPlan → Solid → bytes, in Node, worker and browser.
 *
 * @module
 */

export { canvasStrokeTest, type StrokeContext } from './core/canvas-stroke.ts';
export type { StrokeTest } from './core/context.ts';
export { type DoorCut, type Doors, formatDoors, parseDoors } from './core/doors.ts';
export { type ErrorCode, FloorPlanError } from './core/errors.ts';
export { parseParam, resolveOptions } from './core/options.ts';
export type { ParamRow } from './core/param-rows.ts';
export {
  type GivenValues,
  kebabCase,
  type Options,
  PARAM_NAMES,
  PARAMS,
  type ParamName,
} from './core/params.ts';
export type { PipelineHooks, Progress, StageReport } from './core/pipeline-run.ts';
export { formatRoomNames, parseRoomNames, type RoomName } from './core/room-names.ts';
export type { StageResults } from './core/stage-results.ts';
export { STAGE_NAMES, STAGES, type StageName } from './core/stages.ts';
export type * from './core/types.ts';
export { blobSource } from './read/bytes/blob-source.ts';
export type { ByteSource } from './read/bytes/source.ts';
export { urlSource } from './read/bytes/url-source.ts';
export { READ_FORMATS } from './read/formats.ts';
export { makeReport, type Report } from './session/report.ts';
export { isOfScan, type RunResult, type ScanResult } from './session/result.ts';
export { Session, type SessionControl } from './session/session.ts';
export { parsePlanJson, writePlanJson } from './write/data/plan-json.ts';
export { WRITE_FORMATS } from './write/formats.ts';
export { comparePolygons, type PolygonComparison } from './write/pictures/compare-polygons.ts';
export { type ComparedRun, type ComparisonLook, drawComparison } from './write/pictures/comparison.ts';
export {
  drawPicture,
  PICTURE_NAMES,
  PICTURES,
  type PictureFacts,
  type PictureName,
} from './write/pictures/pictures.ts';
export type { WrittenFile } from './write/plan-writer.ts';
