/** Which points stay: `count` places, rising, of points from `first` on. */
export interface KeptPlaces {
  readonly places: Uint32Array;
  readonly count: number;
  readonly first?: number;
}

/** Moves the values of the points that stay, `width` each, together; no value is written over before it has moved. */
export function closeRanks(
  values: Float64Array | Float32Array | Uint16Array | Uint8Array,
  width: number,
  { places, count, first = 0 }: KeptPlaces,
): void {
  for (let i = 0; i < count; i++)
    for (let k = 0; k < width; k++) values[width * (first + i) + k] = values[width * places[i] + k];
}
