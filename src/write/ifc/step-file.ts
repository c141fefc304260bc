import { type StepValue, text } from './step-text.ts';

/** An instance of a STEP file, by its number. */
export type Ref = `#${number}`;

export interface StepHeader {
  readonly description: string;
  readonly fileName: string;
  /** ISO 8601, e.g. `1970-01-01T00:00:00`. */
  readonly timeStamp: string;
  readonly program: string;
  readonly schema: string;
}

/** The instances of a STEP file (ISO 10303-21, edition 2), numbered in the order they are added. */
export class StepFile {
  readonly #lines: string[] = [];
  readonly #shared = new Map<string, Ref>();

  add(type: string, ...values: readonly StepValue[]): Ref {
    const ref: Ref = `#${this.#lines.length + 1}`;
    this.#lines.push(`${ref}=${type}(${values.join(',')});`);
    return ref;
  }

  /** As {@link add}, but one instance stands for all that say the same: points, directions, properties. */
  share(type: string, ...values: readonly StepValue[]): Ref {
    const key = `${type}(${values.join(',')})`;
    const known = this.#shared.get(key);
    if (known !== undefined) return known;
    const ref = this.add(type, ...values);
    this.#shared.set(key, ref);
    return ref;
  }

  end({ description, fileName, timeStamp, program, schema }: StepHeader): string {
    const header = [
      'ISO-10303-21;',
      'HEADER;',
      `FILE_DESCRIPTION((${text(description)}),'2;1');`,
      `FILE_NAME(${text(fileName)},${text(timeStamp)},(''),(''),${text(program)},${text(program)},'');`,
      `FILE_SCHEMA((${text(schema)}));`,
      'ENDSEC;',
      'DATA;',
    ];
    return `${[...header, ...this.#lines, 'ENDSEC;', 'END-ISO-10303-21;'].join('\n')}\n`;
  }
}
