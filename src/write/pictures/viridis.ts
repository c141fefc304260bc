/** Ten samples of matplotlib's viridis (CC0), evenly spaced, sRGB. */
const ANCHORS = [
  0x440154, 0x482878, 0x3e4989, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6ece58, 0xb5de2b, 0xfde725,
] as const;

/** Viridis at `t` from 0 to 1: r, g, b from 0 to 255, linear between samples. */
export function viridis(t: number): readonly [r: number, g: number, b: number] {
  const place = Math.min(1, Math.max(0, t)) * (ANCHORS.length - 1);
  const i = Math.min(ANCHORS.length - 2, Math.floor(place));
  const mix = (shift: number) => {
    const [low, high] = [(ANCHORS[i] >> shift) & 255, (ANCHORS[i + 1] >> shift) & 255];
    return low + (high - low) * (place - i);
  };
  return [mix(16), mix(8), mix(0)];
}
