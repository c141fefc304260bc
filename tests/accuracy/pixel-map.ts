/** A pixel, whole numbers. */
export type Pixel = readonly [x: number, y: number];

/** Edge of the square map of the Structured3D protocol, px. */
export const MAP_SIZE = 256;

/** A map of zeros and ones, row by row. */
export type PixelMap = Uint8Array;

const put = (map: PixelMap, x: number, y: number): void => {
  if (x >= 0 && y >= 0 && x < MAP_SIZE && y < MAP_SIZE) map[y * MAP_SIZE + x] = 1;
};

/** A polygon filled as OpenCV's fillPoly does it: even-odd, its outline drawn with. */
export function filled(polygon: readonly Pixel[]): PixelMap {
  const map = new Uint8Array(MAP_SIZE ** 2);
  polygon.forEach((a, i) => {
    drawLine(map, a, polygon[(i + 1) % polygon.length]);
  });
  for (let y = 0; y < MAP_SIZE; y++) {
    const crossings = polygon.flatMap(([ax, ay], i) => {
      const [bx, by] = polygon[(i + 1) % polygon.length];
      return y >= Math.min(ay, by) && y < Math.max(ay, by) ? [ax + ((y - ay) * (bx - ax)) / (by - ay)] : [];
    });
    crossings.sort((a, b) => a - b);
    for (let k = 0; k + 1 < crossings.length; k += 2) {
      for (let x = Math.ceil(crossings[k]); x <= crossings[k + 1]; x++) put(map, x, y);
    }
  }
  return map;
}

/** Bresenham from left to right, ties as OpenCV breaks them. */
function drawLine(map: PixelMap, p: Pixel, q: Pixel): void {
  const [[ax, ay], [bx, by]] = p[0] <= q[0] ? [p, q] : [q, p];
  const stepY = by >= ay ? 1 : -1;
  const [dx, dy] = [bx - ax, Math.abs(by - ay)];
  const [long, short] = [Math.max(dx, dy), Math.min(dx, dy)];
  let error = long - 2 * short;
  let [x, y] = [ax, ay];
  for (let i = 0; i <= long; i++) {
    put(map, x, y);
    const isSide = error < 0;
    error += (isSide ? 2 * long : 0) - 2 * short;
    if (isSide || dx >= dy) x += 1;
    if (isSide || dx < dy) y += stepY;
  }
}

/** Pixels this near to an outline: what OpenCV's polylines draws 5 px wide. */
const BROAD = 3;

/** The outline drawn 5 px wide. */
export function broadOutline(polygon: readonly Pixel[]): PixelMap {
  const map = new Uint8Array(MAP_SIZE ** 2);
  polygon.forEach(([ax, ay], i) => {
    const [bx, by] = polygon[(i + 1) % polygon.length];
    const length2 = (bx - ax) ** 2 + (by - ay) ** 2;
    for (let y = Math.min(ay, by) - BROAD; y <= Math.max(ay, by) + BROAD; y++) {
      for (let x = Math.min(ax, bx) - BROAD; x <= Math.max(ax, bx) + BROAD; x++) {
        const along = length2 === 0 ? 0 : ((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / length2;
        const share = Math.max(0, Math.min(1, along));
        if (Math.hypot(ax + share * (bx - ax) - x, ay + share * (by - ay) - y) <= BROAD) put(map, x, y);
      }
    }
  });
  return map;
}

/** Half of the 5 × 5 px square that erodes. */
const ERODE = 2;

/** Ones that have only ones within 2 px; beyond the map nothing counts. */
export function eroded(map: PixelMap): PixelMap {
  const across = minimum(map, 1);
  return minimum(across, MAP_SIZE);
}

/** The least of five in a row or a column. */
function minimum(map: PixelMap, stride: 1 | typeof MAP_SIZE): PixelMap {
  return map.map((value, i) => {
    if (value === 0) return 0;
    const at = stride === 1 ? i % MAP_SIZE : Math.floor(i / MAP_SIZE);
    for (let k = -ERODE; k <= ERODE; k++) {
      if (at + k >= 0 && at + k < MAP_SIZE && map[i + k * stride] === 0) return 0;
    }
    return 1;
  });
}
