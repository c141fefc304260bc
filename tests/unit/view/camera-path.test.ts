import { Box3, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { ISOMETRIC, OVERHEAD, standFor } from '../../../src/view/camera-path.ts';

describe('standFor', () => {
  const box = new Box3(new Vector3(-3, 10, 0), new Vector3(9, 14, 2.5));

  it.each([
    ['isometric', ISOMETRIC, 1.6],
    ['overhead', OVERHEAD, 1.6],
    ['overhead on a phone', OVERHEAD, 0.5],
    ['from the front', new Vector3(0, -1, 0), 1],
  ])('%s: every corner is in view, and the box fills it', (_, direction, aspect) => {
    const camera = new PerspectiveCamera(26, aspect, 0.1, 1000);
    camera.up.set(0, 0, 1);
    const stand = standFor(box, direction, camera);
    camera.position.copy(stand.target).addScaledVector(stand.direction, stand.distance);
    camera.lookAt(stand.target);
    camera.updateMatrixWorld();
    const reaches: number[] = [];
    for (let corner = 0; corner < 8; corner++) {
      const seen = new Vector3(
        corner & 1 ? box.max.x : box.min.x,
        corner & 2 ? box.max.y : box.min.y,
        corner & 4 ? box.max.z : box.min.z,
      ).project(camera);
      reaches.push(Math.abs(seen.x), Math.abs(seen.y));
    }
    expect(Math.max(...reaches)).toBeLessThan(1);
    expect(Math.max(...reaches)).toBeGreaterThan(0.8);
  });

  it('looks from the south-east and above', () => {
    expect(ISOMETRIC.x).toBeGreaterThan(0);
    expect(ISOMETRIC.y).toBeLessThan(0);
    expect(ISOMETRIC.z).toBeGreaterThan(0);
  });
});
