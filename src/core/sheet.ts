import type { RingArc } from './types.ts';

/** A numeric plane map in the order of SVG's matrix(): x' = a·x + c·y + e, y' = b·x + d·y + f. */
export type Affine = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

/** `outer` after `inner`. */
export function chain(outer: Affine, inner: Affine): Affine {
  const [a, b, c, d, e, f] = outer;
  const [p, q, r, s, x, y] = inner;
  return [
    ...([a * p + c * q, b * p + d * q, a * r + c * s, b * r + d * s] as const),
    ...([a * x + c * y + e, b * x + d * y + f] as const),
  ];
}

/** The way back. */
export function inverse([a, b, c, d, e, f]: Affine): Affine {
  const determinant = a * d - b * c;
  const [p, q, r, s] = [d / determinant, -b / determinant, -c / determinant, a / determinant];
  return [p, q, r, s, -(p * e + r * f), -(q * e + s * f)];
}

/** Vertices x, y carried through a map. */
export function mapped(xy: Float64Array, [a, b, c, d, e, f]: Affine): Float64Array {
  const result = new Float64Array(xy.length);
  for (let i = 0; i < xy.length; i += 2) {
    result[i] = a * xy[i] + c * xy[i + 1] + e;
    result[i + 1] = b * xy[i] + d * xy[i + 1] + f;
  }
  return result;
}

export interface Paper {
  /** ISO 216 name: A4 … A0. */
  readonly name: string;
  /** Millimetres, as turned. */
  readonly width: number;
  readonly height: number;
}

/** How a path is drawn; line weights in mm by ISO 128. */
export interface LineStyle {
  /** 0 draws no line. */
  readonly width: number;
  /** Lengths of dash and gap, mm. */
  readonly dash?: readonly [number, number];
  readonly isFilled?: boolean;
  /** Share of ink; 1 where not said. */
  readonly ink?: number;
}

export const LINE_STYLES = {
  wall: { width: 0.5, isFilled: true },
  secondary: { width: 0.35 },
  hatch: { width: 0.13 },
  furniture: { width: 0.18, dash: [1.2, 0.6], ink: 0.55 },
  inferred: { width: 0.25, dash: [3, 1] },
  opening: { width: 0.25 },
  passage: { width: 0.25, dash: [1.2, 0.8] },
  dimension: { width: 0.18 },
  tick: { width: 0.35 },
  rule: { width: 0.18 },
  swatch: { width: 0.25 },
  scaleBar: { width: 0.18, isFilled: true },
} as const satisfies Record<string, LineStyle>;

/** Decimals of a millimetre on the sheet: a hundredth of a millimetre in the building at 1:100. */
export const SHEET_DIGITS = 4;

/** Text sizes in mm. */
export const TEXT_SIZES = { label: 2.5, room: 3.5, title: 5 } as const;

export type LayerName =
  | 'points'
  | 'furniture'
  | 'walls'
  | 'secondary'
  | 'gaps'
  | 'openings'
  | 'dimensions'
  | 'labels'
  | 'title';

/** One or more lines or rings drawn together; where filled, by the even-odd rule. */
export interface SheetPath {
  readonly kind: 'path';
  readonly style: keyof typeof LINE_STYLES;
  /** x, y a vertex, mm, y down. */
  readonly lines: readonly Float64Array[];
  /** Arcs of the lines, which are rings; `ring` is the number of the line. */
  readonly arcs?: readonly RingArc[];
  readonly isClosed: boolean;
  readonly id?: string;
  /** Facts for scripts; keys in kebab-case. */
  readonly data?: Readonly<Record<string, string | number>>;
}

export interface SheetText {
  readonly kind: 'text';
  readonly size: keyof typeof TEXT_SIZES;
  /** Anchor on the base line, mm, y down. */
  readonly x: number;
  readonly y: number;
  readonly text: string;
  readonly anchor: 'start' | 'middle' | 'end';
  readonly isUpright?: boolean;
  readonly id?: string;
}

/** Points beneath the drawing. */
export interface SheetPoints {
  readonly kind: 'points';
  /** x, y a point, mm, y down. */
  readonly xy: Float64Array;
}

export type SheetItem = SheetPath | SheetText | SheetPoints;

export interface SheetLayer {
  readonly name: LayerName;
  readonly isVisible: boolean;
  readonly items: readonly SheetItem[];
}

/** The display list of a drawn page; every drawn format and the 2D view show this, so they cannot differ. */
export interface Sheet {
  readonly paper: Paper;
  /** 50 for 1:50. */
  readonly scale: number;
  /** Index of the storey drawn. */
  readonly storey: number;
  readonly title: string;
  readonly description: string;
  /** Plan metres to millimetres on the sheet. */
  readonly planToSheet: Affine;
  /** Bottom to top. */
  readonly layers: readonly SheetLayer[];
}
