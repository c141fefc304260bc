import type { Opening, Storey } from '../../core/types.ts';
import { type Depth, type OpeningBox, openingBoxes } from '../../solid/opening-boxes.ts';
import { decimal } from '../decimals.ts';
import { jambDepths } from '../jamb-depths.ts';
import type { DxfDrawing } from './dxf-drawing.ts';
import type { DxfTags } from './dxf-tags.ts';

/** Depth of an opening off every wall where none tells how thick walls are, m. */
const DEPTH = 0.1;
/** Height of attributes, m; they are not shown. */
const ATTRIBUTE_HEIGHT = 0.1;
/** Decimals of a confidence. */
const CONFIDENCE_DIGITS = 3;

type Line = readonly [x0: number, y0: number, x1: number, y1: number];

interface OpeningBlock {
  readonly name: string;
  readonly lines: readonly Line[];
  /** Lines of the layer's own kind; others are whole. */
  readonly onLayer: readonly Line[];
}

const JAMBS: readonly Line[] = [
  [-0.5, -0.5, -0.5, 0.5],
  [0.5, -0.5, 0.5, 0.5],
];
const across = (y: number): Line => [-0.5, y, 0.5, y];

/**
 * Openings of unit width and depth about their middle, as the sheet draws them: for a door a line, since nobody knows the
 * hinge side, for a window one on either face and one in the middle, for a passage the dashed edges of its head.
 */
const BLOCKS: Readonly<Record<Opening['type'], OpeningBlock>> = {
  door: { name: 'DOOR', lines: JAMBS, onLayer: [across(0)] },
  window: { name: 'WINDOW', lines: JAMBS, onLayer: [-0.5, 0, 0.5].map(across) },
  passage: { name: 'PASSAGE', lines: JAMBS, onLayer: [-0.5, 0.5].map(across) },
};

const ATTRIBUTES = {
  TYPE: 'Door, window or passage',
  WIDTH: 'Clear width, drawing units',
  SILL: 'Height of the sill above the floor, drawing units',
  HEAD: 'Height of the head above the floor, drawing units',
  CONFIDENCE: 'From 0 to 1',
} as const;

/** Puts a block in place for every opening that has a width. */
export function drawOpeningBlocks(drawing: DxfDrawing, storey: Storey, nextHandle: () => string): void {
  const isWide = ({ from, to }: Opening) => from[0] !== to[0] || from[1] !== to[1];
  const thickest = Math.max(0, ...storey.walls.map(({ thickness }) => thickness)) || DEPTH;
  for (const type of Object.keys(BLOCKS) as Opening['type'][]) {
    if (!storey.openings.some((opening) => opening.type === type && isWide(opening))) continue;
    const { name } = BLOCKS[type];
    const write = (tags: DxfTags, owner: string) => writeOpeningBlock(tags, owner, BLOCKS[type]);
    drawing.blocks.push({ name, handle: nextHandle(), flags: 2, write });
  }
  const boxes = new Map(openingBoxes(storey).map((box) => [box.number, box]));
  storey.openings.forEach((opening, number) => {
    if (!isWide(opening)) return;
    const { type, from, to, sill, head, confidence } = opening;
    const box = boxes.get(number);
    const { low, high } = box === undefined ? { low: -thickest / 2, high: thickest / 2 } : meanDepth(box);
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    const aside = (low + high) / 2 / length;
    const middle = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    drawing.insert(type, {
      block: BLOCKS[type].name,
      at: [middle[0] - aside * (to[1] - from[1]), middle[1] + aside * (to[0] - from[0])],
      scale: [length, high - low],
      angle: Math.atan2(to[1] - from[1], to[0] - from[0]),
      attributes: {
        ...{ TYPE: type, WIDTH: drawing.length(length), SILL: drawing.length(sill) },
        ...{ HEAD: drawing.length(head), CONFIDENCE: decimal(confidence, CONFIDENCE_DIGITS) },
      },
      textHeight: ATTRIBUTE_HEIGHT,
    });
  });
}

/** How deep the wall is, the mean of both jambs: a block's faces run along its axis, and a curved wall bulges between. */
function meanDepth(box: OpeningBox): Depth {
  const [left, right] = jambDepths(box);
  return { low: (left.low + right.low) / 2, high: (left.high + right.high) / 2 };
}

function writeOpeningBlock(tags: DxfTags, owner: string, { lines, onLayer }: OpeningBlock): void {
  const write = ([x0, y0, x1, y1]: Line, isWhole: boolean) => {
    tags.entity('LINE', owner, '0');
    if (isWhole) tags.add([6, 'Continuous']);
    tags.add([100, 'AcDbLine'], [10, x0], [20, y0], [30, '0.0'], [11, x1], [21, y1], [31, '0.0']);
  };
  for (const line of lines) write(line, true);
  for (const line of onLayer) write(line, false);
  for (const [name, prompt] of Object.entries(ATTRIBUTES)) {
    tags.entity('ATTDEF', owner, '0');
    tags.add([100, 'AcDbText'], [10, '0.0'], [20, '0.0'], [30, '0.0'], [40, ATTRIBUTE_HEIGHT], [1, '']);
    tags.add([100, 'AcDbAttributeDefinition'], [3, prompt], [2, name], [70, 1]);
  }
}
