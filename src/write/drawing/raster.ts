/** The part of a 2D canvas context that painting a sheet needs; writers know no DOM. */
export interface RasterContext {
  fillStyle: unknown;
  strokeStyle: unknown;
  lineWidth: number;
  lineCap: unknown;
  lineJoin: unknown;
  globalAlpha: number;
  font: string;
  textAlign: unknown;
  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void;
  save(): void;
  restore(): void;
  rotate(angle: number): void;
  translate(x: number, y: number): void;
  setLineDash(lengths: number[]): void;
  beginPath(): void;
  closePath(): void;
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  arc(x: number, y: number, radius: number, from: number, to: number, isBackwards?: boolean): void;
  fill(rule?: 'nonzero' | 'evenodd'): void;
  stroke(): void;
  fillRect(x: number, y: number, width: number, height: number): void;
  fillText(text: string, x: number, y: number): void;
  measureText(text: string): { readonly width: number };
  getImageData(x: number, y: number, width: number, height: number): { readonly data: Uint8ClampedArray };
}

/** A canvas that can be saved. */
export interface RasterCanvas {
  readonly context: RasterContext;
  toPng(): Promise<Uint8Array>;
}

/** What an environment alone can do for writers. */
export interface WriteTools {
  /** A blank canvas of so many pixels; null where the environment has none. */
  makeCanvas?(width: number, height: number): RasterCanvas | null;
}

/** Faces that look alike wherever a sheet is drawn. */
export const SHEET_FONT = 'Helvetica Neue, Helvetica, Arial, sans-serif';
