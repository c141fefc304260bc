/** Bytes looked at to tell a format. */
export const HEAD_BYTES = 1 << 16;

/** A file that is no point cloud: what it looks like, and what to do instead. */
export interface Foreign {
  readonly what: string;
  readonly hint?: string;
}

interface Signature extends Foreign {
  /** Latin-1 characters at `offset`, whatever their case. */
  readonly magic: string;
  readonly offset?: number;
}

const PICTURE = 'Load the scan itself, not a picture of it.';
const UNPACK = 'Unpack it and load the cloud in it.';
const DRAWING = 'Load the scan that it was drawn from: E57, LAS or PLY.';
const MODEL = 'Save the model as GLB, OBJ or PLY.';
const PAGE = 'A web page was saved in place of the scan; download the file itself.';
const UTF_8 = 'Save the text as UTF-8.';

/** Files people drop by mistake, and clouds of formats without a reader: worth a name in the message. */
const SIGNATURES: readonly Signature[] = [
  { what: 'a JPEG image', magic: '\xff\xd8\xff', hint: PICTURE },
  { what: 'a PNG image', magic: '\x89PNG\r\n', hint: PICTURE },
  { what: 'a GIF image', magic: 'GIF8', hint: PICTURE },
  { what: 'a TIFF image', magic: 'II*\0', hint: PICTURE },
  { what: 'a TIFF image', magic: 'MM\0*', hint: PICTURE },
  { what: 'a WebP image', magic: 'WEBP', offset: 8, hint: PICTURE },
  { what: 'a HEIC image or MP4 video', magic: 'ftyp', offset: 4, hint: PICTURE },
  { what: 'a PDF document', magic: '%PDF', hint: DRAWING },
  { what: 'a 7-Zip archive', magic: "7z\xbc\xaf'\x1c", hint: UNPACK },
  { what: 'a RAR archive', magic: 'Rar!', hint: UNPACK },
  { what: 'a Zstandard archive', magic: '\x28\xb5\x2f\xfd', hint: UNPACK },
  { what: 'a tar archive', magic: 'ustar', offset: 257, hint: UNPACK },
  { what: 'an IFC or STEP model', magic: 'ISO-10303-21', hint: DRAWING },
  { what: 'a DWG drawing', magic: 'AC10', hint: DRAWING },
  { what: 'a SketchUp model', magic: '\xff\xfe\xff\x0eS\0k\0', hint: MODEL },
  { what: 'an FBX model', magic: 'Kaydara FBX', hint: MODEL },
  { what: 'an STL model', magic: 'solid ', hint: MODEL },
  { what: 'a CloudCompare project', magic: 'CCB', hint: 'Save the cloud from CloudCompare as LAS or PLY.' },
  { what: 'an HTML page', magic: '<!doctype html', hint: PAGE },
  { what: 'an HTML page', magic: '<html', hint: PAGE },
  { what: 'an XML document', magic: '<?xml' },
  { what: 'an SVG drawing', magic: '<svg', hint: DRAWING },
  {
    what: 'a plan of this program',
    magic: '{"format":"grundriss-plan"',
    hint: 'Open it by itself: a plan is no part of a scan.',
  },
  { what: 'a JSON document', magic: '{' },
  { what: 'a program', magic: '\x7fELF' },
  { what: 'a program', magic: 'MZ' },
  { what: 'text in UTF-16', magic: '\xff\xfe', hint: UTF_8 },
  { what: 'text in UTF-16', magic: '\xfe\xff', hint: UTF_8 },
];
/** Bytes that hold every magic. */
const MAGIC_BYTES = 512;

/** By extension: projects of scanners' own programs, which bear no mark that is published, and drawings in text. */
const OWN_FORMATS: Readonly<Record<string, Foreign>> = {
  rcp: { what: 'an Autodesk ReCap project', hint: 'Export the scans from ReCap as E57 or PTS.' },
  rcs: { what: 'an Autodesk ReCap scan', hint: 'Export it from ReCap as E57 or PTS.' },
  fls: { what: 'a FARO scan', hint: 'Export it from FARO SCENE as E57.' },
  zfs: { what: 'a Zoller + Fröhlich scan', hint: 'Export it from LaserControl as E57 or PTX.' },
  lgs: { what: 'a Leica LGS file', hint: 'Export the scans from Cyclone as E57 or PTX.' },
  rdbx: { what: 'a RIEGL database', hint: 'Export the scans from RiSCAN PRO as E57 or LAZ.' },
  dxf: { what: 'a DXF drawing', hint: DRAWING },
  stl: { what: 'an STL model', hint: MODEL },
};

/** What the first bytes look like, where that is no table of points; null where nothing is recognised. */
export function recogniseForeign(head: Uint8Array): Foreign | null {
  const text = latin1(head.subarray(0, MAGIC_BYTES)).toLowerCase();
  return SIGNATURES.find(({ magic, offset = 0 }) => text.startsWith(magic.toLowerCase(), offset)) ?? null;
}

/** What a file that no reader knows is by its name; null where that tells nothing. */
export function foreignByName(name: string): Foreign | null {
  return OWN_FORMATS[extensionOf(name)] ?? null;
}

/** Without the dot, lower case. */
export function extensionOf(name: string): string {
  return name.slice(name.lastIndexOf('.') + 1).toLowerCase();
}

/** No byte that plain text lacks. */
export function isText(head: Uint8Array): boolean {
  return head.every((byte) => byte >= 32 || (byte >= 9 && byte <= 13));
}

/** More arguments than this overflow the stack somewhere. */
const MOST_ARGUMENTS = 4096;

/** One character a byte; for short texts several times faster than a TextDecoder. */
export function latin1(bytes: Uint8Array): string {
  if (bytes.length > MOST_ARGUMENTS) return new TextDecoder('latin1').decode(bytes);
  return String.fromCharCode.apply(null, bytes as unknown as number[]);
}
