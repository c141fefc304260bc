/** Middle and main axis of weighted places. */
export interface Spread {
  readonly x: number;
  readonly y: number;
  /** Direction of the main axis, −π/2 to π/2. */
  readonly angle: number;
  /** Variance across it. */
  readonly variance: number;
}

/** Sums of weighted places; those far from 0, 0 cancel out, so tell them from a place among them. */
export class Moments {
  #weight = 0;
  #x = 0;
  #y = 0;
  #xx = 0;
  #xy = 0;
  #yy = 0;

  get weight(): number {
    return this.#weight;
  }

  add(x: number, y: number, weight: number): void {
    this.#weight += weight;
    this.#x += weight * x;
    this.#y += weight * y;
    this.#xx += weight * x * x;
    this.#xy += weight * x * y;
    this.#yy += weight * y * y;
  }

  /** The line of total least squares runs along the main axis through the middle. */
  spread(): Spread {
    const [x, y] = [this.#x / this.#weight, this.#y / this.#weight];
    const xx = this.#xx / this.#weight - x * x;
    const xy = this.#xy / this.#weight - x * y;
    const yy = this.#yy / this.#weight - y * y;
    // The smaller eigenvalue; rounding may take it below 0.
    const variance = Math.max(0, (xx + yy - Math.hypot(xx - yy, 2 * xy)) / 2);
    return { x, y, angle: Math.atan2(2 * xy, xx - yy) / 2, variance };
  }
}
