import { describe, expect, it } from 'vitest';
import { outerWalls } from '../../../src/core/building/walls/outer-walls.ts';
import { combine } from '../../../src/core/geometry/areas.ts';
import { chordTurn, ON_ARC, SAGITTA, withArcs } from '../../../src/core/geometry/ring-arcs.ts';
import { ringsOf } from '../../../src/core/geometry/rings.ts';
import { squaredDistanceToSegment } from '../../../src/core/geometry/segments.ts';
import type { Polygon } from '../../../src/core/types.ts';
import { writeGeoJson } from '../../../src/write/data/geojson.ts';
import { parsePlanJson, writePlanJson } from '../../../src/write/data/plan-json.ts';
import { writeSvg } from '../../../src/write/drawing/svg.ts';
import { writeDxf } from '../../../src/write/dxf/dxf.ts';
import { disc, type PlanFacts, ring } from '../solid/plans.ts';
import { productOf } from './products.ts';

type Place = readonly [x: number, y: number];

const RADIUS = 4;
const THICKNESS = 0.3;

/** A room that is three quarters of a disc about (1, 2), with its walls. */
function roundRoom(frame: PlanFacts['frame'] = {}): PlanFacts {
  const count = Math.ceil((1.5 * Math.PI) / chordTurn(RADIUS));
  const xy = Array.from({ length: count + 1 }, (_, k) => {
    const angle = (1.5 * Math.PI * k) / count;
    return [1 + RADIUS * Math.cos(angle), 2 + RADIUS * Math.sin(angle)];
  });
  const circles = [{ cx: 1, cy: 2, radius: RADIUS }];
  const outline = withArcs({ outer: ring(...xy.flat(), 1, 2), holes: [] }, circles);
  const walls = outerWalls([outline], [THICKNESS, THICKNESS, THICKNESS]).map((wall) => ({
    ...{ outline: wall.outline, thickness: wall.thickness, confidence: 1 },
  }));
  const rooms = [{ name: 'Room 1', outline, height: 2.5, confidence: 1 }];
  return { frame, storeys: [{ primary: [outline], rooms, walls }] };
}

/** A round hall: one arc, all around. */
function roundHall(): PlanFacts {
  const outline = withArcs({ outer: disc(0, 0, 5, 120), holes: [] }, [{ cx: 0, cy: 0, radius: 5 }]);
  return { storeys: [{ primary: [outline], walls: [], rooms: [] }] };
}

const edgesOf = (xy: readonly number[]): [Place, Place][] =>
  Array.from({ length: xy.length / 2 }, (_, i) => {
    const j = (2 * i + 2) % xy.length;
    return [
      [xy[2 * i], xy[2 * i + 1]],
      [xy[j], xy[j + 1]],
    ];
  });

function distanceTo(ringXy: readonly number[], [x, y]: Place): number {
  return Math.sqrt(Math.min(...edgesOf(ringXy).map(([a, b]) => squaredDistanceToSegment(x, y, ...a, ...b))));
}

/** The farthest that either of two rings is from the other, by their vertices. */
function farthest(a: readonly number[], b: readonly number[]): number {
  const off = (from: readonly number[], to: readonly number[]) =>
    Math.max(...edgesOf(from).map(([place]) => distanceTo(to, place)));
  return Math.max(off(a, b), off(b, a));
}

/** Places along a circular arc from one place towards another, that one left out. */
function alongBulge([ax, ay]: Place, [bx, by]: Place, bulge: number): number[] {
  if (bulge === 0) return [ax, ay];
  const turn = 4 * Math.atan(bulge);
  const chord = Math.hypot(bx - ax, by - ay);
  // The centre is to the left of the chord for a counter-clockwise arc of less than half a turn.
  const off = chord / 2 / Math.tan(turn / 2);
  const cx = (ax + bx) / 2 - (off * (by - ay)) / chord;
  const cy = (ay + by) / 2 + (off * (bx - ax)) / chord;
  const [start, radius] = [Math.atan2(ay - cy, ax - cx), Math.hypot(ax - cx, ay - cy)];
  return Array.from({ length: 400 }, (_, k) => start + (turn * k) / 400).flatMap((angle) => [
    cx + radius * Math.cos(angle),
    cy + radius * Math.sin(angle),
  ]);
}

interface BulgedLine {
  readonly layer: string;
  readonly vertices: number;
  readonly bulges: readonly number[];
  /** Finely along it. */
  readonly xy: readonly number[];
}

/** Closed polylines of a DXF, by the rules of the format: a bulge is of the vertex before it. */
function bulgedLinesOf(text: string): BulgedLine[] {
  const entities = text.slice(text.indexOf('\nENTITIES\n'), text.indexOf('\nOBJECTS\n'));
  return entities
    .split('\nLWPOLYLINE\n')
    .slice(1)
    .map((entity) => {
      const lines = entity.split('\n');
      const tags = Array.from(
        { length: Math.floor(lines.length / 2) },
        (_, i) => [Number(lines[2 * i]), lines[2 * i + 1]] as const,
      );
      const end = tags.findIndex(([code]) => code === 0);
      const places: { x: number; y: number; bulge: number }[] = [];
      for (const [code, value] of end < 0 ? tags : tags.slice(0, end)) {
        if (code === 10) places.push({ x: Number(value), y: 0, bulge: 0 });
        const last = places.at(-1);
        if (last && code === 20) last.y = Number(value);
        if (last && code === 42) last.bulge = Number(value);
      }
      const xy = places.flatMap(({ x, y, bulge }, i) => {
        const next = places[(i + 1) % places.length];
        return alongBulge([x, y], [next.x, next.y], bulge);
      });
      const layer = tags.find(([code]) => code === 8)![1];
      return { layer, vertices: places.length, bulges: places.map((place) => place.bulge), xy };
    });
}

describe('DXF', () => {
  it('arcs are bulges that pass the chords within the sagitta', async () => {
    const facts = roundRoom();
    const { plan, ...product } = await productOf(facts);
    const lines = bulgedLinesOf(writeDxf({ plan, ...product }, 0));
    const { rooms, walls } = plan.storeys[0];
    const [room] = lines.filter(({ layer }) => layer === 'A-AREA');
    // The arc is longer than half a circle, so it comes in two.
    expect(room.vertices).toBe(4);
    expect(room.bulges.filter((bulge) => bulge > 0)).toHaveLength(2);
    expect(farthest(room.xy, [...rooms[0].outline.outer])).toBeLessThan(SAGITTA + ON_ARC);
    const drawn = lines.filter(({ layer }) => layer === 'A-WALL');
    // Its three walls are one area.
    const faces = ringsOf(
      combine(
        'union',
        walls.map(({ outline }) => outline),
      ),
    );
    expect(drawn).toHaveLength(faces.length);
    drawn.forEach((line) => {
      // The outer face's chords are longer by its radius.
      const widest = (SAGITTA * (RADIUS + THICKNESS)) / RADIUS;
      expect(Math.min(...faces.map((face) => farthest(line.xy, [...face])))).toBeLessThan(widest + ON_ARC);
    });
    expect(drawn.flatMap(({ bulges }) => bulges.filter((bulge) => bulge < 0))).toHaveLength(2);
    expect(drawn.flatMap(({ bulges }) => bulges.filter((bulge) => bulge > 0))).toHaveLength(2);
  });

  it('a circle is two half circles, in feet as well', async () => {
    const [hall] = bulgedLinesOf(writeDxf(await productOf(roundHall()), 0));
    expect(hall.bulges).toEqual([1, 1]);
    const inFeet = roundRoom({ metresPerUnit: 0.3048, unit: 'ft', planOrigin: [1000, 2000, 0] });
    const room = bulgedLinesOf(writeDxf(await productOf(inFeet), 0)).find(({ layer }) => layer === 'A-AREA')!;
    expect(room.vertices).toBe(4);
  });
});

interface ArcProperty {
  readonly ring: number;
  readonly from: number;
  readonly to: number;
  readonly centre: Place;
  readonly radius: number;
  readonly angles: Place;
}

describe('GeoJSON', () => {
  it.each([1, 0.3048])('arcs are told in the coordinates of the file, %f m a unit', async (metresPerUnit) => {
    const planOrigin = [691_000.12, 5_334_000.45, 500] as const;
    const facts = roundRoom({ metresPerUnit, planOrigin, unit: 'custom' });
    const { features } = JSON.parse(writeGeoJson(await productOf(facts))) as {
      features: {
        properties: { kind: string; arcs?: ArcProperty[] };
        geometry: { coordinates: Place[][] };
      }[];
    };
    const counts = features.map(({ properties }) => [properties.kind, properties.arcs?.length ?? 0]);
    expect(counts).toEqual([
      ['primary-boundary', 1],
      ['room', 1],
      ['wall', 2],
      ['wall', 0],
      ['wall', 0],
    ]);
    for (const { properties, geometry } of features) {
      for (const { ring: number, from, to, centre, radius, angles } of properties.arcs ?? []) {
        const places = geometry.coordinates[number].slice(0, -1);
        const within = places.filter((_, i) => (from < to ? i >= from && i <= to : i >= from || i <= to));
        expect(within.length).toBeGreaterThan(10);
        for (const [x, y] of within) {
          const off = Math.hypot(x - centre[0], y - centre[1]) - radius;
          // The radius, the centre and the vertex are rounded.
          expect(Math.abs(off) * metresPerUnit).toBeLessThan(ON_ARC);
        }
        [places[from], places[to]].forEach(([x, y], i) => {
          expect(centre[0] + radius * Math.cos(angles[i])).toBeCloseTo(x, 3);
          expect(centre[1] + radius * Math.sin(angles[i])).toBeCloseTo(y, 3);
        });
        // Outer faces go on into their mitres.
        const mitres =
          radius * metresPerUnit > RADIUS + ON_ARC ? 2 * Math.asin(THICKNESS / (RADIUS + THICKNESS)) : 0;
        expect(Math.abs(angles[1] - angles[0])).toBeCloseTo(1.5 * Math.PI + mitres, 4);
      }
    }
  });
});

describe('plan JSON', () => {
  it('keeps arcs', async () => {
    const product = await productOf(roundRoom());
    const again = parsePlanJson(writePlanJson(product));
    const outlines = (walls: readonly { readonly outline: Polygon }[]) => walls.map(({ outline }) => outline);
    expect(outlines(again.storeys[0].walls)).toEqual(outlines(product.plan.storeys[0].walls));
    expect(again.storeys[0].primary[0].arcs).toHaveLength(1);
  });

  it('refuses an arc of vertices that are not there', async () => {
    const text = writePlanJson(await productOf(roundRoom()));
    expect(() => parsePlanJson(text.replace(/"to":\d+/, '"to":4000'))).toThrow(
      /storeys\[0\]\.primary\[0\]\.arcs\[0\]\.to: expected a whole number below \d+, found 4000/,
    );
  });
});

/** Finely along a path of M, L, A and Z, arcs of half a circle at most, by SVG's rules. */
function alongPath(d: string): number[] {
  const xy: number[] = [];
  let [x, y, beginX, beginY] = [0, 0, 0, 0];
  for (const [, command, rest] of d.matchAll(/([MLAZ])([^MLAZ]*)/g)) {
    const numbers = rest.trim().split(/\s+/).map(Number);
    const [toX, toY] = command === 'Z' ? [beginX, beginY] : numbers.slice(-2);
    if (command === 'M') [beginX, beginY] = [toX, toY];
    if (command === 'A') {
      const [radius, , , isLarge, isPositive] = numbers;
      expect(isLarge).toBe(0);
      const turn = 2 * Math.asin(Math.min(1, Math.hypot(toX - x, toY - y) / 2 / radius));
      xy.push(...alongBulge([x, y], [toX, toY], (isPositive === 1 ? 1 : -1) * Math.tan(turn / 4)));
    } else if (command !== 'M') xy.push(x, y);
    [x, y] = [toX, toY];
  }
  return xy;
}

describe('SVG', () => {
  it('arcs of walls are arcs that pass the chords within the sagitta', async () => {
    const facts = roundRoom();
    const bare = ({ outer, holes }: Polygon): Polygon => ({ outer, holes });
    const chords: PlanFacts = {
      storeys: (facts.storeys ?? []).map((storey) => ({
        ...storey,
        walls: (storey.walls ?? []).map((wall) => ({ ...wall, outline: bare(wall.outline) })),
      })),
    };
    const [round, straight] = await Promise.all(
      [facts, chords].map(async (each) => {
        const text = writeSvg(await productOf(each), 0);
        const scale = Number(/data-scale="(\d+)"/.exec(text)![1]);
        return { d: /id="wall-0"[^>]* d="([^"]+)"/.exec(text)![1], mmPerMetre: 1000 / scale };
      }),
    );
    expect(round.d.match(/A/g)).toHaveLength(4);
    expect(straight.d).not.toMatch(/A/);
    const widest = (SAGITTA * (RADIUS + THICKNESS)) / RADIUS + ON_ARC;
    const [rings, chordRings] = [round.d, straight.d].map((d) => d.match(/M[^Z]*Z/g)!.map(alongPath));
    expect(rings).toHaveLength(2);
    rings.forEach((xy, i) => {
      expect(farthest(xy, chordRings[i]) / round.mmPerMetre).toBeLessThan(widest);
    });
    expect(round.d.length).toBeLessThan(straight.d.length / 4);
  });
});
