import { expect, it } from 'vitest';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { Session } from '../../../src/session/session.ts';

const fixture = (name: string) => new URL(`../../../fixtures/foreign/${name}`, import.meta.url).pathname;

/** Inner outline of the flat, see fixtures/foreign/make-mesh.py. */
const FLAT = [
  [0, 0],
  [7, 0],
  [7, 3],
  [4, 3],
  [4, 5],
  [0, 5],
];
const [COS, SIN] = [Math.cos(Math.PI / 6), Math.sin(Math.PI / 6)];
/** The same in the GLB, seen from above: turned by 30° about its origin, then moved. */
const TURNED = FLAT.map(([x, y]) => [10 + COS * x - SIN * y, 3 + SIN * x + COS * y]);

/** One format at the resolution that holds by default, the others on a lattice thrice as wide, m. */
it.each([
  ['flat.obj', 0.03, 'z', FLAT],
  ['flat.ply', 0.01, 'z', FLAT],
  ['flat.glb', 0.03, 'y', TURNED],
  ['flat-meshopt.glb', 0.03, 'y', TURNED],
  ['flat-draco.glb', 0.03, 'y', TURNED],
] as const)('%s at %d m: the outline is true to a centimetre', async (name, resolution, up, truth) => {
  const { plan } = await new Session({ strokeTest: createStrokeTest() }).load(
    await nodeSource(fixture(name)),
    { resolution },
  );
  expect(plan.frame).toMatchObject({ up, metresPerUnit: 1 });
  const [ox, oy] = plan.frame.planOrigin;
  const { outer } = plan.storeys[0].primary[0];
  const corners = Array.from({ length: outer.length / 2 }, (_, i) => [
    outer[2 * i] + ox,
    outer[2 * i + 1] + oy,
  ]);
  expect(corners).toHaveLength(truth.length);
  for (const [x, y] of truth) {
    expect(Math.min(...corners.map(([u, v]) => Math.hypot(u - x, v - y)))).toBeLessThan(0.01);
  }
});
