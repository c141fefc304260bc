import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import { cutOffAt } from '../cut-off.ts';
import { malformed } from './las-header.ts';
import type { VariableRecord } from './variable-records.ts';

/** The record a COPC file begins with (COPC 1.0, copc.io). */
export interface CopcInfo {
  /** Spacing of the points in the octree's root, source units; half of it with every level. */
  readonly spacing: number;
  readonly root: Page;
}

interface Page {
  readonly level: number;
  readonly offset: number;
  readonly bytes: number;
}

/** A chunk of LAZ: the points that a cell of the octree adds to those above it. */
export interface CopcNode {
  readonly level: number;
  readonly offset: number;
  readonly bytes: number;
  readonly points: number;
}

const INFO_BYTES = 160;
const ENTRY_BYTES = 32;
/** A key of more levels than this has no number for its cells. */
const DEEPEST = 31;
/** Entries of a whole country; more are not believed. */
const MOST_BYTES = 1 << 28;

/** @throws input/malformed */
export function readCopcInfo(name: string, records: readonly VariableRecord[]): CopcInfo {
  const bytes = records.find(({ user, id }) => user === 'copc' && id === 1)?.bytes;
  if (!bytes || bytes.length < INFO_BYTES)
    throw copcError(name, 'the record "copc" of 160 bytes', bytes?.length ?? 0);
  const view = viewOf(bytes);
  const spacing = view.getFloat64(32, true);
  if (!(spacing > 0 && spacing < Number.POSITIVE_INFINITY))
    throw copcError(name, 'a spacing above 0', spacing);
  const [offset, size] = [Number(view.getBigUint64(40, true)), Number(view.getBigUint64(48, true))];
  return { spacing, root: { level: 0, offset, bytes: size } };
}

/**
 * The octree of a COPC file, whose pages are fetched when their level is asked for.
 *
 * What pages and nodes take together cannot be more than the file: pages that lead back to themselves end there.
 */
export class CopcHierarchy {
  readonly nodes: CopcNode[] = [];
  readonly #source: ByteSource;
  readonly #mostPoints: number;
  #pages: readonly Page[];
  #pageBytes = 0;
  /** As far as pages reach that were found: the file is no shorter, where it does not tell its size. */
  #end = 0;
  #nodeBytes = 0;
  #points = 0;

  constructor(source: ByteSource, root: Page, mostPoints: number) {
    this.#source = source;
    this.#pages = [root];
    this.#mostPoints = mostPoints;
  }

  /** Whether there may be nodes of this level or deeper. */
  reaches(level: number): boolean {
    return this.#pages.length > 0 || this.nodes.some((node) => node.level >= level);
  }

  /** Fetches what tells the nodes down to a level. @throws input/malformed, input/truncated */
  async load(level: number): Promise<void> {
    for (let due = this.#takePages(level); due.length > 0; due = this.#takePages(level))
      for (const page of due) this.#parse(page, await this.#fetch(page));
  }

  #takePages(level: number): readonly Page[] {
    const due = this.#pages.filter((page) => page.level <= level);
    this.#pages = this.#pages.filter((page) => page.level > level);
    return due;
  }

  async #fetch({ offset, bytes }: Page): Promise<Uint8Array> {
    const { name } = this.#source;
    this.#pageBytes += bytes;
    if (bytes === 0 || bytes % ENTRY_BYTES !== 0 || this.#pageBytes > MOST_BYTES)
      throw malformed(name, offset, 'a page of the octree', `${bytes} bytes`);
    const page = await this.#source.slice(offset, offset + bytes);
    if (page.length < bytes)
      throw cutOffAt(name, `${bytes} bytes of the octree at byte ${offset}`, offset + page.length);
    this.#end = Math.max(this.#end, offset + bytes);
    if (this.#pageBytes > this.#end) throw malformed(name, offset, 'a page of the octree', 'one read before');
    return page;
  }

  #parse(page: Page, bytes: Uint8Array): void {
    const view = viewOf(bytes);
    const pages: Page[] = [];
    for (let at = 0; at < bytes.length; at += ENTRY_BYTES) {
      const entry = {
        level: view.getInt32(at, true),
        offset: Number(view.getBigUint64(at + 16, true)),
        bytes: view.getInt32(at + 24, true),
      };
      const points = view.getInt32(at + 28, true);
      if (entry.level < page.level || entry.level > DEEPEST || entry.bytes < 0 || points < -1)
        throw malformed(this.#source.name, page.offset + at, 'a cell of the octree', `level ${entry.level}`);
      if (points === -1) pages.push(entry);
      else if (points > 0) this.#add({ ...entry, points }, page.offset + at);
    }
    this.#pages = [...this.#pages, ...pages];
  }

  #add(node: CopcNode, at: number): void {
    const { name, size = Number.MAX_SAFE_INTEGER } = this.#source;
    this.#points += node.points;
    this.#nodeBytes += node.bytes;
    const isInside = node.offset + node.bytes <= size && this.#nodeBytes <= size;
    if (!isInside || this.#points > this.#mostPoints) {
      const found = `${node.points} in ${node.bytes} bytes at byte ${node.offset}`;
      throw malformed(name, at, `points of the ${this.#mostPoints} within the file`, found);
    }
    this.nodes.push(node);
  }
}

function copcError(name: string, expected: string, found: string | number): FloorPlanError {
  return new FloorPlanError('input/malformed', `${name}: expected ${expected}, found ${found}`, {
    hint: 'The octree is damaged; save the cloud as plain LAZ.',
  });
}
