/** Okabe and Ito's palette: told apart with any kind of colour vision. */
const OKABE_ITO = [
  '#0072b2',
  '#e69f00',
  '#009e73',
  '#cc79a7',
  '#56b4e9',
  '#d55e00',
  '#f0e442',
  '#999999',
] as const;
/** More points than this look the same in a small picture. */
const MOST_POINTS = 20_000;
const MARGIN = 4;

/**
 * A small picture of a slice seen from above, in ink or with each group in its colour.
 *
 * @param xy x, y a point, m
 * @param groups group of every point
 */
export function drawSlice(canvas: HTMLCanvasElement, xy: Float64Array, groups?: Uint8Array): void {
  const ratio = globalThis.devicePixelRatio || 1;
  const width = Math.round(canvas.clientWidth * ratio);
  const height = Math.round(canvas.clientHeight * ratio);
  Object.assign(canvas, { width, height });
  const context = canvas.getContext('2d');
  if (!context || xy.length === 0) return;
  const { low, high } = boundsOf(xy);
  const margin = MARGIN * ratio;
  const scale = Math.min(
    (width - 2 * margin) / Math.max(high[0] - low[0], Number.EPSILON),
    (height - 2 * margin) / Math.max(high[1] - low[1], Number.EPSILON),
  );
  const ink = getComputedStyle(canvas).color;
  const step = Math.max(1, Math.ceil(xy.length / 2 / MOST_POINTS));
  for (let i = 0; i < xy.length / 2; i += step) {
    const x = width / 2 + scale * (xy[2 * i] - (low[0] + high[0]) / 2);
    const y = height / 2 - scale * (xy[2 * i + 1] - (low[1] + high[1]) / 2);
    context.fillStyle = groups ? OKABE_ITO[groups[i] % OKABE_ITO.length] : ink;
    context.fillRect(x, y, ratio, ratio);
  }
}

function boundsOf(xy: Float64Array): { low: [number, number]; high: [number, number] } {
  const low: [number, number] = [Infinity, Infinity];
  const high: [number, number] = [-Infinity, -Infinity];
  for (let i = 0; i < xy.length; i++) {
    low[i % 2] = Math.min(low[i % 2], xy[i]);
    high[i % 2] = Math.max(high[i % 2], xy[i]);
  }
  return { low, high };
}
