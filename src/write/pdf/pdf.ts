import {
  LINE_STYLES,
  type LineStyle,
  type Sheet,
  type SheetItem,
  type SheetLayer,
  type SheetPath,
  type SheetText,
  TEXT_SIZES,
} from '../../core/sheet.ts';
import { type ArcStroke, arcCentre, arcStrokes } from '../arc-strokes.ts';
import { decimal } from '../decimals.ts';
import type { WriteTools } from '../drawing/raster.ts';
import { INK, POINT_INK, POINT_SIZE } from '../drawing/sheet-ink.ts';
import { advanceOf, winAnsi } from '../helvetica.ts';
import type { Product } from '../plan-writer.ts';
import { type DisplayUnit, INCHES_PER_FOOT, METRES_PER_FOOT } from '../sheet/measure-words.ts';
import { byteString, PdfFile, textString } from './pdf-file.ts';
import { drawTextImage } from './text-image.ts';

/** PostScript points in a millimetre. */
const POINTS_PER_MM = 72 / 25.4;
const MM_PER_METRE = 1000;
/** Decimals of a millimetre on the page. */
const DIGITS = 4;
/** One cubic curve follows up to a quarter of a circle to within 3/10,000 of the radius. */
const LONGEST_CURVE = Math.PI / 2;

/**
 * Writes plan.pdf: a storey's sheet on one page of its paper, true to scale, in lines, with the layers as such, text that
 * can be searched, and the scale told to viewers' measuring tools [ISO32000 §12.9].
 *
 * Letters Helvetica has none of are drawn by the environment's canvas and set as pictures of text; where there is no
 * canvas, as question marks. Either way they are found and copied as they are.
 */
export function writePdf(
  { sheet, options }: Product,
  storey: number,
  tools: WriteTools = {},
): Uint8Array<ArrayBuffer> {
  return new PdfPage(sheet[storey], options.displayUnits, tools).write();
}

/** A print is as large as the page, so that its scale is true. */
const VIEWING = '<< /PrintScaling /None /DisplayDocTitle true >>';

class PdfPage {
  readonly #file = new PdfFile();
  readonly #sheet: Sheet;
  readonly #unit: DisplayUnit;
  readonly #tools: WriteTools;
  readonly #lines: string[] = [];
  readonly #images: number[] = [];
  /** Shares of ink other than 1, by number of their state. */
  readonly #inks: number[] = [];

  constructor(sheet: Sheet, unit: DisplayUnit, tools: WriteTools) {
    this.#sheet = sheet;
    this.#unit = unit;
    this.#tools = tools;
  }

  write(): Uint8Array<ArrayBuffer> {
    const { paper, layers, title, description } = this.#sheet;
    const file = this.#file;
    const box = `[0 0 ${points(paper.width)} ${points(paper.height)}]`;
    // Millimetres with y down, as on the sheet.
    this.#lines.push(
      `${points(1)} 0 0 -${points(1)} 0 ${points(paper.height)} cm`,
      `${INK_RGB} rg`,
      `${INK_RGB} RG`,
    );
    layers.forEach((layer, i) => {
      this.#drawLayer(layer, i);
    });
    const groups = layers.map(({ name }) => file.add(`<< /Type /OCG /Name ${textString(name)} >>`));
    const content = file.addStream('', new TextEncoder().encode(this.#lines.join('\n')));
    const [pages, page] = [file.reserve(), file.reserve()];
    file.write(pages, `<< /Type /Pages /Kids [${page} 0 R] /Count 1 >>`);
    const measure = `/VP [<< /Type /Viewport /BBox ${box} /Measure ${this.#measure()} >>]`;
    file.write(
      page,
      `<< /Type /Page /Parent ${pages} 0 R /MediaBox ${box} /Contents ${content} 0 R ${measure} /Resources ${this.#resources(groups)} >>`,
    );
    const hidden = groups.filter((_, i) => !layers[i].isVisible);
    const layering = `<< /OCGs [${refs(groups)}] /D << /Order [${refs(groups)}] /OFF [${refs(hidden)}] >> >>`;
    const root = file.add(
      `<< /Type /Catalog /Pages ${pages} 0 R /OCProperties ${layering} /Lang (en) /ViewerPreferences ${VIEWING} >>`,
    );
    const info = file.add(
      `<< /Title ${textString(title)} /Subject ${textString(description)} /Creator ${textString('Grundriss')} >>`,
    );
    return file.end(root, info);
  }

  #resources(groups: readonly number[]): string {
    const named = (prefix: string, numbers: readonly number[]) =>
      numbers.map((number, i) => `/${prefix}${i} ${number} 0 R`).join(' ');
    const inks = this.#inks.map((ink, i) => `/K${i} << /CA ${ink} /ca ${ink} >>`).join(' ');
    const font = '<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>';
    return `<< /Font << /F ${font} >> /Properties << ${named('L', groups)} >> /XObject << ${named('I', this.#images)} >> /ExtGState << ${inks} >> >>`;
  }

  /** Lengths and areas that a viewer measures are those of the building. */
  #measure(): string {
    const { scale } = this.#sheet;
    const metres = scale / POINTS_PER_MM / MM_PER_METRE;
    const [name, ofPoint] = this.#unit === 'm' ? ['m', metres] : ['ft', metres / METRES_PER_FOOT];
    const ratio = this.#unit === 'm' ? `1:${scale}` : `1 in = ${decimal(scale / INCHES_PER_FOOT, 3)} ft`;
    const format = (unit: string, factor: number) =>
      `[<< /Type /NumberFormat /U ${textString(unit)} /C ${factor} /D 1000 >>]`;
    const whole = format(name, 1);
    return `<< /Type /Measure /Subtype /RL /R ${textString(ratio)} /X ${format(name, ofPoint)} /D ${whole} /A ${format(`${name}²`, 1)} >>`;
  }

  #drawLayer({ items }: SheetLayer, number: number): void {
    this.#lines.push(`/OC /L${number} BDC`);
    for (const item of items) this.#drawItem(item);
    this.#lines.push('EMC');
  }

  #drawItem(item: SheetItem): void {
    if (item.kind === 'text') this.#drawText(item);
    else if (item.kind === 'path') this.#drawPath(item);
    else this.#drawPoints(item.xy);
  }

  #drawPath(path: SheetPath): void {
    const look: LineStyle = LINE_STYLES[path.style];
    if (path.lines.length === 0) return;
    const strokes = path.lines.map((line, ring) => pathOf(path, line, ring));
    const paint = look.isFilled ? (look.width > 0 ? 'B*' : 'f*') : 'S';
    const dash = look.dash ? `[${look.dash.join(' ')}] 0 d ` : '';
    const ink = look.ink === undefined ? '' : `${this.#ink(look.ink)} gs `;
    this.#lines.push(`q ${ink}${dash}${look.width} w`, ...strokes, `${paint} Q`);
  }

  #drawPoints(xy: Float64Array): void {
    this.#lines.push(`q ${this.#ink(POINT_INK)} gs 1 J ${POINT_SIZE} w`);
    for (let i = 0; i < xy.length; i += 2)
      this.#lines.push(`${mm(xy[i])} ${mm(xy[i + 1])} m ${mm(xy[i])} ${mm(xy[i + 1])} l`);
    this.#lines.push('S Q');
  }

  #ink(share: number): string {
    const known = this.#inks.indexOf(share);
    return `/K${known >= 0 ? known : this.#inks.push(share) - 1}`;
  }

  #drawText(item: SheetText): void {
    const size = TEXT_SIZES[item.size];
    const codes = winAnsi(item.text);
    if (codes !== null) {
      this.#showText(item, codes);
      return;
    }
    // What is seen is not what is meant: viewers find and copy this.
    this.#lines.push(`/Span << /ActualText ${textString(item.text)} >> BDC`);
    const image = drawTextImage(item.text, size, this.#tools);
    const substitutes = [...item.text].flatMap((letter) => winAnsi(letter) ?? [QUESTION_MARK]);
    this.#showText(item, substitutes, { isSeen: image === null });
    if (image !== null) {
      const facts = `/Type /XObject /Subtype /Image /Width ${image.columns} /Height ${image.rows} /ImageMask true /BitsPerComponent 1 /Decode [1 0]`;
      const name = this.#images.push(this.#file.addStream(facts, image.bits)) - 1;
      const start = startOf(item.anchor, image.width);
      const [a, b, c, d] = item.isUpright
        ? [0, -image.width, -image.height, 0]
        : [image.width, 0, 0, -image.height];
      const [x, y] = item.isUpright
        ? [item.x + image.below, item.y - start]
        : [item.x + start, item.y + image.below];
      this.#lines.push(`q ${[a, b, c, d, x, y].map(mm).join(' ')} cm /I${name} Do Q`);
    }
    this.#lines.push('EMC');
  }

  /** Text that is not seen is found all the same. */
  #showText(
    { x, y, anchor, isUpright, size }: SheetText,
    codes: readonly number[],
    { isSeen = true } = {},
  ): void {
    const start = startOf(anchor, advanceOf(codes, TEXT_SIZES[size]));
    // Letters stand upright on a page whose y runs down.
    const place = isUpright ? `0 -1 -1 0 ${mm(x)} ${mm(y - start)}` : `1 0 0 -1 ${mm(x + start)} ${mm(y)}`;
    this.#lines.push(
      `BT ${isSeen ? 0 : 3} Tr /F ${TEXT_SIZES[size]} Tf ${place} Tm ${byteString(codes)} Tj ET`,
    );
  }
}

const QUESTION_MARK = 63;

const INK_RGB = [1, 3, 5].map((at) => decimal(Number.parseInt(INK.slice(at, at + 2), 16) / 255, 4)).join(' ');

const mm = (value: number): string => decimal(value, DIGITS);
const points = (millimetres: number): string => decimal(millimetres * POINTS_PER_MM, DIGITS);
const refs = (numbers: readonly number[]): string => numbers.map((number) => `${number} 0 R`).join(' ');

/** Where a text begins, from its anchor. */
function startOf(anchor: SheetText['anchor'], width: number): number {
  return { start: 0, middle: -width / 2, end: -width }[anchor];
}

function pathOf({ arcs = [], isClosed }: SheetPath, line: Float64Array, ring: number): string {
  const own = arcs.filter((arc) => arc.ring === ring);
  if (own.length === 0) {
    let path = '';
    for (let i = 0; i < line.length; i += 2)
      path += `${mm(line[i])} ${mm(line[i + 1])} ${i === 0 ? 'm' : 'l'} `;
    return isClosed ? `${path}h` : path;
  }
  const strokes = arcStrokes(line, own);
  const ways = strokes.map((stroke, i) => {
    const end = strokes[(i + 1) % strokes.length];
    return stroke.turn === 0 ? `${mm(end.x)} ${mm(end.y)} l` : curves(stroke, end);
  });
  return `${mm(strokes[0].x)} ${mm(strokes[0].y)} m ${ways.join(' ')} h`;
}

/** Cubic curves along an arc that turns by an angle, from x towards y, of at most half a circle. */
function curves(from: ArcStroke, to: ArcStroke): string {
  const [cx, cy] = arcCentre(from, to, from.turn);
  const count = Math.ceil(Math.abs(from.turn) / LONGEST_CURVE);
  const step = from.turn / count;
  const pull = (4 / 3) * Math.tan(step / 4);
  const [cos, sin] = [Math.cos(step), Math.sin(step)];
  let [x, y] = [from.x - cx, from.y - cy];
  const parts: string[] = [];
  for (let k = 0; k < count; k++) {
    const [toX, toY] = [x * cos - y * sin, x * sin + y * cos];
    const places = [x - pull * y, y + pull * x, toX + pull * toY, toY - pull * toX, toX, toY];
    parts.push(`${places.map((value, i) => mm(value + (i % 2 === 0 ? cx : cy))).join(' ')} c`);
    [x, y] = [toX, toY];
  }
  return parts.join(' ');
}
