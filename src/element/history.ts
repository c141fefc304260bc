/** Steps one can go back and forth between. */
export class History<State> {
  readonly #past: State[] = [];
  readonly #future: State[] = [];

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  /** Remembers the state that is about to be left. */
  leave(state: State): void {
    this.#past.push(state);
    this.#future.length = 0;
  }

  undo(now: State): State {
    if (!this.canUndo) return now;
    this.#future.push(now);
    return this.#past.pop()!;
  }

  redo(now: State): State {
    if (!this.canRedo) return now;
    this.#past.push(now);
    return this.#future.pop()!;
  }
}
