/** What a LAS file says of its coordinate system, from GeoTIFF keys or well-known text. */
export interface CoordinateSystem {
  readonly kind: 'projected' | 'geographic' | 'geocentric' | 'unknown';
  /** `EPSG:25832`, else the WKT; absent where the file has neither. */
  readonly crs?: string;
  /** Metres a unit of x and y, and of the heights; absent where the file does not say. */
  readonly metresPerUnit?: number;
  readonly metresPerHeightUnit?: number;
}

/** User-defined, in GeoTIFF; codes of the register are below. */
const USER_DEFINED = 32_767;

/** `EPSG:…` of a code of the register. */
export function epsgOf(code: number | undefined): string | undefined {
  if (code === undefined || !Number.isInteger(code)) return undefined;
  return code > 0 && code !== USER_DEFINED ? `EPSG:${code}` : undefined;
}
