import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import { findFurniture } from '../../../../src/core/building/furniture/find-furniture.ts';
import type { Furniture, Polygon, Vec2 } from '../../../../src/core/types.ts';
import { makeCloud } from '../made-scan.ts';

const STEP = 0.03;

type Box = readonly [minX: number, minY: number, maxX: number, maxY: number];

/** A room made by hand, of 5 m × 4 m × 2.6 m, and points of what stands in it; metres. */
export class FurnishedRoom {
  static readonly WIDTH = 5;
  static readonly DEPTH = 4;
  static readonly HEIGHT = 2.6;
  readonly #xyz: number[] = [];
  readonly #hidden: Box[] = [];

  /** The floor under a box is in its shadow. */
  hide(box: Box): this {
    this.#hidden.push(box);
    return this;
  }

  level(z: number, [minX, minY, maxX, maxY]: Box): this {
    for (let x = minX + STEP / 2; x < maxX; x += STEP)
      for (let y = minY + STEP / 2; y < maxY; y += STEP) this.#xyz.push(x, y, z);
    return this;
  }

  /** An upright face between two places. */
  face([ax, ay]: Vec2, [bx, by]: Vec2, [low, high]: readonly [number, number]): this {
    const steps = Math.ceil(Math.hypot(bx - ax, by - ay) / STEP);
    for (let k = 0; k < steps; k++) {
      const t = (k + 0.5) / steps;
      for (let z = low + STEP / 2; z < high; z += STEP)
        this.#xyz.push(ax + t * (bx - ax), ay + t * (by - ay), z);
    }
    return this;
  }

  /** Sides of a box, without its top. */
  sides([minX, minY, maxX, maxY]: Box, heights: readonly [number, number]): this {
    return this.face([minX, minY], [maxX, minY], heights)
      .face([maxX, minY], [maxX, maxY], heights)
      .face([maxX, maxY], [minX, maxY], heights)
      .face([minX, maxY], [minX, minY], heights);
  }

  /** A top on four legs. */
  table([minX, minY, maxX, maxY]: Box, height: number): this {
    this.level(height, [minX, minY, maxX, maxY]);
    for (const x of [minX, maxX - 0.06])
      for (const y of [minY, maxY - 0.06]) this.sides([x, y, x + 0.06, y + 0.06], [0, height]);
    return this;
  }

  /** What is found, in a room turned about its corner. */
  furniture(turn = 0): { readonly found: readonly Furniture[]; readonly room: Polygon } {
    const { WIDTH, DEPTH, HEIGHT } = FurnishedRoom;
    const whole: Box = [0, 0, WIDTH, DEPTH];
    const { positions, outline } = this.#scanned(whole, HEIGHT, turn);
    const cloud = makeCloud(positions, { floor: 0, ceiling: HEIGHT });
    const all = Uint32Array.from({ length: positions.length / 3 }, (_, i) => i);
    const columns = heightColumns(cloud, all, { floor: 0, ceiling: HEIGHT });
    const room: Polygon = { outer: outline, holes: [] };
    const rooms = [{ name: 'Room 1', outline: room, height: HEIGHT, confidence: 1 }];
    const site = { cloud, columns, ceiling: localCeiling(columns), noise: 0.005, rooms, secondary: [] };
    return { found: findFurniture(site), room };
  }

  #scanned(whole: Box, height: number, turn: number) {
    const own = this.#xyz.slice();
    this.sides(whole, [0, height]).level(height, whole);
    const walls = this.#xyz.splice(own.length);
    this.level(0, whole);
    const floor = this.#xyz.splice(own.length);
    const xyz = [...own, ...walls];
    for (let i = 0; i < floor.length; i += 3) {
      const [x, y] = [floor[i], floor[i + 1]];
      if (this.#hidden.some((box) => x > box[0] && x < box[2] && y > box[1] && y < box[3])) continue;
      xyz.push(x, y, 0);
    }
    const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
    const positions = Float32Array.from(xyz);
    for (let i = 0; i < xyz.length; i += 3) {
      positions[i] = cos * xyz[i] - sin * xyz[i + 1];
      positions[i + 1] = sin * xyz[i] + cos * xyz[i + 1];
    }
    const [minX, minY, maxX, maxY] = whole;
    const corners = [minX, minY, maxX, minY, maxX, maxY, minX, maxY];
    const outline = Float64Array.from(corners, (_, i) =>
      i % 2 === 0 ? cos * corners[i] - sin * corners[i + 1] : sin * corners[i - 1] + cos * corners[i],
    );
    return { positions, outline };
  }
}
