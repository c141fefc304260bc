import type { Bounds } from '../../core/geometry/rings.ts';
import type { Options } from '../../core/params.ts';
import type { Polygon, Vec2 } from '../../core/types.ts';
import { placeFigures } from '../sheet/chain-figures.ts';
import {
  BELOW,
  type Dimensions,
  EXTENSION,
  FIRST_CHAIN,
  type Inside,
  NEXT_CHAIN,
  planDimensions,
} from '../sheet/dimensions.ts';
import { formatDimension } from '../sheet/measure-words.ts';
import { roomChords } from '../sheet/room-dimensions.ts';
import { widthByCapitals } from '../sheet/text-width.ts';
import { type DxfDrawing, type DxfText, degrees, legible } from './dxf-drawing.ts';
import { DIMENSION_STYLE, type DimensionStyle, ROOM_DIMENSION_STYLE } from './dxf-tables.ts';
import type { DxfTags } from './dxf-tags.ts';

/** Types of a rotated dimension whose block is its own, and of one whose text has been put in place. */
const OWN_BLOCK = 32;
const PLACED = OWN_BLOCK + 128;

/** A side of the plan: the angle of its chains to the plan's square axes, and what leads outwards from it. */
const SIDES = {
  bottom: { isAcross: true, edge: 'minY', away: -1 },
  top: { isAcross: true, edge: 'maxY', away: 1 },
  left: { isAcross: false, edge: 'minX', away: -1 },
  right: { isAcross: false, edge: 'maxX', away: 1 },
} as const satisfies Record<
  keyof Dimensions['chains'],
  { isAcross: boolean; edge: keyof Bounds; away: 1 | -1 }
>;

export interface DimensionFacts {
  readonly which: Options['dimensions'];
  /** What a storey covers, turned square; metres. */
  readonly covered: readonly Polygon[];
  readonly extent: Bounds;
  /** Rooms and openings, turned as well. */
  readonly inside: Inside;
  /** Likewise. */
  readonly structures: readonly Polygon[];
  readonly furniture: readonly Polygon[];
  readonly labels: readonly DxfText[];
  /** The angle it was turned by, radians. */
  readonly turn: number;
  /** 100 for 1:100, which the texts are made for. */
  readonly scale: number;
  readonly style: DimensionStyle;
}

/** A distance between two places of a square plan, its line, and what extension lines go from; metres. */
interface Measured {
  readonly from: Vec2;
  readonly to: Vec2;
  /** Ends of the line. */
  readonly lineFrom: Vec2;
  readonly lineTo: Vec2;
  /** Outwards; none where the line runs from face to face. */
  readonly out: Vec2 | null;
  readonly angle: number;
  readonly figure: Figure;
}

/** What stands at a dimension. */
interface Figure {
  readonly text: string;
  /** Its middle on the line, and what leads from there to its upper side. */
  readonly at: Vec2;
  readonly up: Vec2;
  /** It has no place of its own on its side of the line, or none at all. */
  readonly place: 'above' | 'below' | 'none';
}

/** Draws the chains around the plan and the sizes of its rooms: their distances are measured by the CAD program. */
export function drawDxfDimensions(
  drawing: DxfDrawing,
  facts: DimensionFacts,
  nextHandle: () => string,
): void {
  const { which, scale, style } = facts;
  const measured = [
    ...(which === 'none' ? [] : measureChains(facts, drawing.metresPerUnit)),
    ...(which === 'all' ? measureRooms(facts, drawing.metresPerUnit) : []),
  ];
  measured.forEach((each, i) => {
    drawDimension(drawing, `*D${i + 1}`, { measured: each, style, metresPerMm: scale / 1000, nextHandle });
  });
}

/** The way from the square plan. */
function turnBack(turn: number): (x: number, y: number) => Vec2 {
  const [cos, sin] = [Math.cos(-turn), Math.sin(-turn)];
  return (x, y) => [cos * x - sin * y, sin * x + cos * y];
}

function measureChains(facts: DimensionFacts, metresPerUnit: number): Measured[] {
  const { covered, extent, inside, turn, scale, style } = facts;
  const { chains } = planDimensions(covered, extent, scale, inside);
  const back = turnBack(turn);
  const mmPerMetre = 1000 / scale;
  return (Object.keys(SIDES) as (keyof typeof SIDES)[]).flatMap((name) => {
    const { isAcross, edge, away } = SIDES[name];
    const out = isAcross ? back(0, away) : back(away, 0);
    const angle = legible((isAcross ? 0 : Math.PI / 2) - turn);
    const at = (place: number, mm: number) => {
      const aside = extent[edge] + (away * mm) / mmPerMetre;
      return isAcross ? back(place, aside) : back(aside, place);
    };
    return chains[name].flatMap((places, k) => {
      const line = FIRST_CHAIN + k * NEXT_CHAIN;
      const texts = places.slice(1).map((place, i) => sayFigure(place - places[i], style, metresPerUnit));
      const placed = placeFigures(
        places.map((place) => place * mmPerMetre),
        texts,
      );
      return texts.map((text, i): Measured => {
        const [from, to] = [places[i], places[i + 1]];
        const place = placed[i];
        return {
          // Extension lines are short, as on the sheet: what they would lead to is far off where the outline steps back.
          ...{ from: at(from, line - EXTENSION), to: at(to, line - EXTENSION) },
          ...{ lineFrom: at(from, line), lineTo: at(to, line), out, angle },
          figure: {
            ...{
              text,
              at: at(place === null ? (from + to) / 2 : place.at / mmPerMetre, line),
              up: upOf(angle),
            },
            place: place === null ? 'none' : place.isBelow ? 'below' : 'above',
          },
        };
      });
    });
  });
}

/** Inside rooms, clear of their labels. */
function measureRooms(facts: DimensionFacts, metresPerUnit: number): Measured[] {
  const { inside, structures, furniture, labels, turn, scale, style } = facts;
  const back = turnBack(turn);
  const toPlace = turnBack(-turn);
  const perMetre = 1000 / scale;
  const chords = roomChords({
    rooms: inside.rooms.map(({ outline }) => outline),
    structures,
    furniture,
    // As on a sheet, y runs down.
    planToSheet: [perMetre, 0, 0, -perMetre, 0, 0],
    taken: labels.map(({ at, angle, half }) => {
      const [x, y] = toPlace(...at);
      const isTurned = Math.abs(Math.sin(angle + turn)) > Math.SQRT1_2;
      const [reachX, reachY] = isTurned ? [half[1], half[0]] : half;
      return {
        ...{ minX: (x - reachX) * perMetre, maxX: (x + reachX) * perMetre },
        ...{ minY: -(y + reachY) * perMetre, maxY: -(y - reachY) * perMetre },
      };
    }),
    figure: (mm) => sayFigure(mm / perMetre, style, metresPerUnit),
  });
  return chords.map(({ along, place, from, to }): Measured => {
    const at = (value: number) =>
      along === 0 ? back(value / perMetre, -place / perMetre) : back(place / perMetre, -value / perMetre);
    // Upright figures are read upwards.
    const ends = along === 0 ? [at(from), at(to)] : [at(to), at(from)];
    const angle = (along === 0 ? 0 : Math.PI / 2) - turn;
    return {
      ...{ from: ends[0], to: ends[1], lineFrom: ends[0], lineTo: ends[1], out: null, angle: legible(angle) },
      figure: {
        text: sayFigure((to - from) / perMetre, style, metresPerUnit),
        // On the side that was found clear, whichever way it is read.
        ...{ at: at((from + to) / 2), up: upOf(angle), place: 'above' },
      },
    };
  });
}

/** What leads up from a line of text. */
const upOf = (angle: number): Vec2 => [-Math.sin(angle), Math.cos(angle)];

/** What a CAD program makes of the style. */
function sayFigure(metres: number, { inchesPerUnit, decimals }: DimensionStyle, metresPerUnit: number) {
  return inchesPerUnit === undefined
    ? (metres / metresPerUnit).toFixed(decimals)
    : formatDimension(metres, 'ft');
}

interface DrawnDimension {
  readonly measured: Measured;
  readonly style: DimensionStyle;
  readonly metresPerMm: number;
  readonly nextHandle: () => string;
}

/** A dimension and the block that shows it, for programs that do not draw it themselves. */
function drawDimension(
  drawing: DxfDrawing,
  name: string,
  { measured, style, metresPerMm, nextHandle }: DrawnDimension,
): void {
  const { from, to, lineTo, out, angle, figure } = measured;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const height = style.textHeight * metresPerMm;
  const half: Vec2 = [widthByCapitals(figure.text, height) / 2, height / 2];
  const above =
    figure.place === 'below' ? -BELOW * metresPerMm + half[1] : style.textGap * metresPerMm + half[1];
  const at: Vec2 = [figure.at[0] + figure.up[0] * above, figure.at[1] + figure.up[1] * above];
  const lines = linesOf(measured, style, metresPerMm).map(
    ([a, b]) => [drawing.point(10, a), drawing.point(11, b)] as const,
  );
  const text = drawing.textTags({ lines: [figure.text], at, height, angle, half });
  const points = [drawing.point(13, from), drawing.point(14, to)].flat();
  const [onLine, middle] = [drawing.point(10, lineTo), drawing.point(11, at)];
  const write = (tags: DxfTags, owner: string) => {
    for (const [a, b] of lines) {
      tags.entity('LINE', owner, '0');
      tags.add([100, 'AcDbLine'], ...a, ...b);
    }
    if (figure.place === 'none') return;
    tags.entity('MTEXT', owner, '0');
    text(tags);
  };
  drawing.blocks.push({ name, handle: nextHandle(), flags: 1, write });
  drawing.add('dimension', (tags, owner, layer) => {
    tags.entity('DIMENSION', owner, layer);
    tags.add(
      [100, 'AcDbDimension'],
      [2, name],
      ...onLine,
      ...middle,
      [70, figure.place === 'above' ? OWN_BLOCK : PLACED],
      [71, 5],
      // A blank where there is no place for its figure; else what the program measures.
      [1, figure.place === 'none' ? ' ' : ''],
    );
    tags.add([42, drawing.length(length)], [3, out === null ? ROOM_DIMENSION_STYLE : DIMENSION_STYLE]);
    tags.add([100, 'AcDbAlignedDimension'], ...points);
    tags.add([50, degrees(angle)], [100, 'AcDbRotatedDimension']);
  });
}

/** The line, the two that lead to it, and the ticks. */
function linesOf(
  { from, to, lineFrom, lineTo, out, angle }: Measured,
  { extensionGap, extensionOverhang, tick }: DimensionStyle,
  metresPerMm: number,
): (readonly [Vec2, Vec2])[] {
  const beside = ([x, y]: Vec2, [outX, outY]: Vec2, mm: number): Vec2 => [
    x + outX * mm * metresPerMm,
    y + outY * mm * metresPerMm,
  ];
  const leadTo = (place: Vec2, end: Vec2, way: Vec2) =>
    [beside(place, way, extensionGap), beside(end, way, extensionOverhang)] as const;
  const oblique = angle + Math.PI / 4;
  const reach = Math.SQRT2 * tick * metresPerMm;
  const [dx, dy] = [Math.cos(oblique) * reach, Math.sin(oblique) * reach];
  return [
    [lineFrom, lineTo],
    ...(out === null ? [] : [leadTo(from, lineFrom, out), leadTo(to, lineTo, out)]),
    ...[lineFrom, lineTo].map(([x, y]) => [[x - dx, y - dy] as const, [x + dx, y + dy] as const] as const),
  ];
}
