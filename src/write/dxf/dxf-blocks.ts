import type { DxfTag, DxfTags } from './dxf-tags.ts';

/** A block: what is drawn once and inserted, or the drawing of a dimension. */
export interface DxfBlock {
  readonly name: string;
  /** Of its block record. */
  readonly handle: string;
  /** 1 for a block without a name of its own, 2 where attributes go with it. */
  readonly flags: 0 | 1 | 2;
  readonly write: (tags: DxfTags, owner: string) => void;
}

/** Writes the BLOCKS section. @param spaces handles of the block records of model and paper space */
export function writeBlocks(
  tags: DxfTags,
  spaces: { readonly model: string; readonly paper: string },
  blocks: readonly DxfBlock[],
): void {
  const nothing = () => {};
  tags.section('BLOCKS', () => {
    writeBlock(tags, { name: '*Model_Space', handle: spaces.model, flags: 0, write: nothing });
    writeBlock(tags, { name: '*Paper_Space', handle: spaces.paper, flags: 0, write: nothing }, true);
    for (const block of blocks) writeBlock(tags, block);
  });
}

function writeBlock(tags: DxfTags, { name, handle, flags, write }: DxfBlock, isPaper = false): void {
  const space: readonly DxfTag[] = isPaper ? [[67, 1]] : [];
  tags.add([0, 'BLOCK'], [5, tags.handle()], [330, handle], [100, 'AcDbEntity'], ...space, [8, '0']);
  tags.add([100, 'AcDbBlockBegin'], [2, name], [70, flags], [10, 0], [20, 0], [30, 0], [3, name], [1, '']);
  write(tags, handle);
  tags.add([0, 'ENDBLK'], [5, tags.handle()], [330, handle], [100, 'AcDbEntity'], ...space, [8, '0']);
  tags.add([100, 'AcDbBlockEnd']);
}
