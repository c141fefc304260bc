/**
 * The data that flows through the house. Plain, readonly, structured-clonable; metres and radians inside, always.
 *
 *     Scan → PointCloud → Slice → Boundary → FloorPlan → Solid
 */
import type { Options } from './params.ts';

export type Vec2 = readonly [x: number, y: number];
export type Vec3 = readonly [x: number, y: number, z: number];
export type Unit = 'm' | 'cm' | 'mm' | 'ft' | 'us-ft' | 'px';
/** A unit, or one without a name: its `metresPerUnit` was given. */
export type FrameUnit = Unit | 'custom';
export type Axis = 'x' | 'y' | 'z' | '-x' | '-y' | '-z';

/** An open ring, flat: x0, y0, x1, y1, … in metres. The last vertex is not repeated. */
export type Ring = Float64Array;

/** Outer ring counter-clockwise, holes clockwise; every ring simple. */
export interface Polygon {
  readonly outer: Ring;
  readonly holes: readonly Ring[];
  /** Where its rings stand for curves; absent where they do nowhere. */
  readonly arcs?: readonly RingArc[];
}

/**
 * A run of vertices on a circle, a few mm off which the edges between them pass: a curved wall.
 *
 * From vertex `from` of a ring on to vertex `to`, past its last vertex to its first where need be; a whole circle ends where
 * it begins.
 */
export interface RingArc {
  /** 0 for the outer ring, then the holes in order. */
  readonly ring: number;
  readonly from: number;
  readonly to: number;
  readonly centre: Vec2;
  readonly radius: number;
}

/** What a reader knew of each point beside its place. Every array present has one entry (colour: three) a point. */
export interface PointAttributes {
  /** r, g, b, 0 to 255. */
  readonly colour?: Uint8Array;
  /** 0 to 1 where the format says its range, else as read. */
  readonly intensity?: Float32Array;
  /** ASPRS class codes. */
  readonly classification?: Uint8Array;
  /** Index of the scanner station that saw the point. */
  readonly station?: Uint16Array;
}

/** Facts about the bytes a scan came from. */
export interface SourceFacts {
  readonly name: string;
  /** A row of the table of read formats, e.g. `ply`. */
  readonly format: string;
  readonly bytes: number;
  readonly pointsRead: number;
  /** Points with a NaN or infinite coordinate; left out. */
  readonly pointsDropped: number;
  readonly pointsKept: number;
}

/** A cloud as read: source axes, source units, thinned, relative to a float64 origin. */
export interface Scan {
  readonly facts: SourceFacts;
  /** x, y, z a point, source axes and units, relative to `origin`; sorted by lattice cell, so file order is forgotten. */
  readonly positions: Float32Array;
  readonly origin: Vec3;
  /** Of every finite point read, kept or not; source axes, units and coordinates. */
  readonly bounds: { readonly min: Vec3; readonly max: Vec3 };
  readonly attributes: PointAttributes;
  /** Edge of the thinning cell in source units; 0 where every point was kept. */
  readonly cellSize: number;
  /** Where each scanner stood, source axes, units and coordinates; empty where the file does not tell. */
  readonly stations: readonly Vec3[];
  /** Two columns: a ready slice, already in the plan frame; z is 0. */
  readonly isSlice: boolean;
  /** The unit the file states, if it states one. */
  readonly unit?: Unit;
  /** The axis that is up by the format's own rule; files break it now and then. */
  readonly up?: Axis;
  /** EPSG code or WKT, if the file states one. */
  readonly crs?: string;
  readonly warnings: readonly Warning[];
}

/**
 * How source coordinates become plan coordinates and back.
 *
 * plan (m) = metresPerUnit · rotation · (source − origin); in source units and coordinates the plan point is
 * planOrigin + plan / metresPerUnit. `rotation` is a proper rotation (determinant +1), so no plan is ever mirrored.
 */
export interface Frame {
  /** Source point at the plan's (0, 0, 0), source units, float64. */
  readonly origin: Vec3;
  /** The same point in the plan frame, source units: for z-up (x, y, z), for y-up (x, −z, y). */
  readonly planOrigin: Vec3;
  /** Row-major 3 × 3, source axes → plan axes (right, ahead, up), levelling included. */
  readonly rotation: readonly number[];
  readonly metresPerUnit: number;
  readonly unit: FrameUnit;
  readonly up: Axis;
  /** Angle by which levelling tilted the cloud, radians. */
  readonly tilt: number;
  readonly crs?: string;
}

/** An upright cloud: metres, z up, plan frame, relative to `frame.origin`. */
export interface PointCloud {
  readonly frame: Frame;
  readonly positions: Float32Array;
  readonly attributes: PointAttributes;
  /** Where each scanner stood, by `attributes.station`; metres, plan frame, relative to `frame.origin`. */
  readonly stations: readonly Vec3[];
  /** Heights of the floor and ceiling planes, m; null where none was found. */
  readonly floor: number | null;
  readonly ceiling: number | null;
  /** One sentence each: why this unit, why this axis. */
  readonly reasons: { readonly unit: string; readonly up: string };
  /** All heights equal: the cloud is taken as a slice. */
  readonly isFlat: boolean;
}

/** One of the three height levels of [Stojanovic19] §3. Heights in metres above the floor. */
export interface Level {
  readonly low: number;
  readonly high: number;
  readonly points: number;
  /** Points per m² of the level's axis-aligned bounding box. */
  readonly densityPerM2: number;
  readonly chosen: boolean;
}

/** Points of one height band seen from above. */
export interface Slice {
  /** x, y a point, metres, plan frame. */
  readonly xy: Float64Array;
  /** Heights above the floor, m. */
  readonly band: readonly [low: number, high: number];
  /** Mean distance to the nearest neighbour, m. */
  readonly spacing: number;
}

/** A stretch of an outline that no point supports: a gap in a scanned wall that the boundary bridges, or a hidden wall. */
export interface Gap {
  readonly from: Vec2;
  readonly to: Vec2;
  readonly width: number;
  /** Name of the room whose outline it is of; the primary boundary has none. */
  readonly room?: string;
}

/** The outline a boundary method finds, before regularisation. */
export interface Boundary {
  readonly method: Options['boundary'];
  readonly polygons: readonly Polygon[];
  /** Gift opening: edges longer than this were opened, m; 0 for other methods. */
  readonly openingLength: number;
  readonly gaps: readonly Gap[];
}

/** The passes of [Stojanovic19] §3, and ours around them, that take off noise and restore corners. */
export type RegularisationPass = 'noise' | 'radial' | 'douglas-peucker' | 'visvalingam' | 'corners';

/** A boundary after each of the passes that ran. */
export interface RegularisedBoundary {
  readonly passes: readonly { readonly name: RegularisationPass; readonly polygons: readonly Polygon[] }[];
  /** What the last pass left. */
  readonly polygons: readonly Polygon[];
}

export type Operation = 'subtract' | 'add' | 'independent';

/** A structure that stands inside the primary boundary: column, shaft, cubicle. */
export interface SecondaryBoundary {
  readonly outline: Polygon;
  readonly operation: Operation;
  readonly type: 'column' | 'shaft' | 'other';
  readonly points: number;
}

/** One round of [Stojanovic19] Algorithms 1 and 2 on one cluster. Points x, y each, m. */
export interface SecondaryRound {
  /** The points Algorithm 1 keeps: inside the boundary before and near the cluster's centre. */
  readonly near: Float64Array;
  /** Their concave outline, regularised (Fig. 3c). */
  readonly outline: Ring | null;
  /** The points the stroke along that outline does not cover. */
  readonly innermost: Float64Array;
  /** Their concave outline, regularised (Fig. 3d). */
  readonly result: Ring | null;
}

/** How the paper's method came to one structure: the cluster it took and every round within it. */
export interface ClusterSearch {
  readonly cluster: number;
  readonly rounds: readonly SecondaryRound[];
}

/** What the search for secondary boundaries saw on its way ([Stojanovic19] §3.1, Fig. 3). */
export interface SecondaryResult {
  /** Cluster of each slice point; empty where no clustering ran. */
  readonly clusters: Uint8Array;
  /** One a cluster taken for a structure; empty for the method `robust`. */
  readonly searches: readonly ClusterSearch[];
  readonly boundaries: readonly SecondaryBoundary[];
}

export interface Wall {
  readonly outline: Polygon;
  readonly thickness: number;
  readonly confidence: number;
  /** No point shows its other face: the thickness is that of others, or the one asked for. */
  readonly isThicknessInferred?: true;
}

export interface Room {
  readonly name: string;
  readonly outline: Polygon;
  readonly height: number;
  readonly confidence: number;
}

/** A hole through a wall, from jamb to jamb along the wall's axis. */
export interface Opening {
  readonly type: 'door' | 'window' | 'passage';
  readonly from: Vec2;
  readonly to: Vec2;
  /** Heights above the floor, m. */
  readonly sill: number;
  readonly head: number;
  /** 1 where a person said so. */
  readonly confidence: number;
}

/** A thing that stands in a room and is no part of the building: a table, a bed, a cupboard. */
export interface Furniture {
  readonly outline: Polygon;
  /** Of its top above the floor, m. */
  readonly height: number;
  /** Share of its outline that points show; the back of what stands before a wall is not seen. */
  readonly confidence: number;
  /** Name of the room it stands in. */
  readonly room: string;
}

/** One floor of a building. Heights in metres; plan frame. */
export interface Storey {
  readonly index: number;
  /** z of the floor, relative to the frame's origin. */
  readonly floor: number;
  readonly height: number;
  readonly primary: readonly Polygon[];
  readonly secondary: readonly SecondaryBoundary[];
  readonly walls: readonly Wall[];
  readonly rooms: readonly Room[];
  readonly openings: readonly Opening[];
  /** Bridged gaps and hidden walls: stretches of the outlines no point supports. */
  readonly gaps: readonly Gap[];
  /** Absent unless the parameter `furniture` asks for it. */
  readonly furniture?: readonly Furniture[];
}

/** The plan of a whole building, lowest storey first. Every writer takes this. */
export interface FloorPlan {
  readonly version: 1;
  readonly source: SourceFacts;
  readonly frame: Frame;
  readonly options: Options;
  readonly storeys: readonly Storey[];
  readonly warnings: readonly Warning[];
}

/** A triangle mesh in the plan frame: metres, z up, relative to the frame's origin. */
export interface Solid {
  /** x, y, z a vertex; shared between triangles. */
  readonly positions: Float64Array;
  /** Three a triangle, counter-clockwise seen from outside. */
  readonly indices: Uint32Array;
  /** Runs of triangles that belong together and form a closed two-manifold each, in order of `start`. */
  readonly groups: readonly SolidGroup[];
}

export interface SolidGroup {
  /** Unique, e.g. `wall-0`, `floor-0`, `column-2`. */
  readonly name: string;
  readonly kind: 'wall' | 'floor' | 'ceiling' | 'secondary';
  readonly storey: number;
  /** First entry in `indices`. */
  readonly start: number;
  /** Entries in `indices`: three times the triangles. */
  readonly count: number;
}

/** A degraded result says so here; core never logs. */
export interface Warning {
  /** e.g. `boundary/gap-bridged`. */
  readonly code: string;
  readonly message: string;
  /** One thing to try. */
  readonly hint: string;
}
