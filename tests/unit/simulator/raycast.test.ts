import { describe, expect, it } from 'vitest';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { seededRandom } from '../../../fixtures/simulator/random.ts';
import { rayCaster } from '../../../fixtures/simulator/raycast.ts';
import { contains, rectangle } from '../../../fixtures/simulator/ring.ts';
import { type Surfaces, surfacesOf } from '../../../fixtures/simulator/surfaces.ts';

/** Distance to the nearest surface, every surface tried. */
function nearestByTrying({ quads, flats }: Surfaces, [px, py, pz, dx, dy, dz]: Float64Array): number {
  const onQuads = quads.map(({ a, b, low, high }) => {
    // p + t d = a + u (b − a), by Cramer's rule.
    const det = -dx * (b[1] - a[1]) + dy * (b[0] - a[0]);
    const t = (-(a[0] - px) * (b[1] - a[1]) + (a[1] - py) * (b[0] - a[0])) / det;
    const u = (dx * (a[1] - py) - dy * (a[0] - px)) / det;
    const z = pz + t * dz;
    return t > 1e-4 && u >= 0 && u <= 1 && z >= low && z <= high ? t : Infinity;
  });
  const onFlats = flats.map(({ ring, z }) => {
    const t = (z - pz) / dz;
    return t > 1e-4 && contains(ring, px + t * dx, py + t * dy) ? t : Infinity;
  });
  return Math.min(...onQuads, ...onFlats);
}

function randomRay(random: ReturnType<typeof seededRandom>, at: readonly number[]): Float64Array {
  const [x, y, z] = [random.normal(), random.normal(), random.normal()];
  const length = Math.hypot(x, y, z);
  return Float64Array.of(at[0], at[1], at[2], x / length, y / length, z / length);
}

describe('ray caster', () => {
  it('meets what trying every surface meets', () => {
    const [storey] = homeBuilding(2, { shape: 'L' }).storeys;
    const surfaces = surfacesOf(storey);
    const caster = rayCaster(surfaces);
    const random = seededRandom(1, 'rays');
    let hits = 0;
    for (let i = 0; i < 3000; i++) {
      const { ring } = random.pick(storey.rooms);
      const at = [
        ring[0][0] * 0.5 + ring[2][0] * 0.5,
        ring[0][1] * 0.5 + ring[2][1] * 0.5,
        random.between(0.1, 2.3),
      ];
      const ray = randomRay(random, at);
      const hit = caster.cast(ray);
      const nearest = nearestByTrying(surfaces, ray);
      expect(hit < 0 ? Infinity : caster.reach()).toBe(nearest);
      if (hit >= 0) hits++;
    }
    expect(hits).toBeGreaterThan(2500);
  });

  it('is stopped by the nearer of two walls', () => {
    const wall = (x: number) => ({ a: [x, 0], b: [x, 4], low: 0, high: 2, kind: 'wall', owner: 0 }) as const;
    const caster = rayCaster({
      quads: [wall(7), wall(3)],
      flats: [{ ring: rectangle(0, 0, 9, 4), z: 0, kind: 'floor', owner: 0 }],
    });
    expect(caster.cast(Float64Array.of(1, 2, 1, 1, 0, 0))).toBe(1);
    expect(caster.reach()).toBeCloseTo(2, 12);
    expect(caster.cast(Float64Array.of(1, 2, 1, Math.SQRT1_2, 0, -Math.SQRT1_2))).toBe(2);
    expect(caster.cast(Float64Array.of(1, 2, 1, -1, 0, 0))).toBe(-1);
  });
});
