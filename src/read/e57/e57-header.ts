import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import { cutOffAt } from '../cut-off.ts';
import { malformedE57 } from './e57-error.ts';
import { PAGE_BYTES, readLogical } from './pages.ts';
import { parseXml, type XmlElement, XmlError } from './xml.ts';

const HEADER_BYTES = 48;
/** A thousand scans take some 4 MB; a header that promises more than this is not believed. */
const MOST_XML_BYTES = 1 << 26;

/** Reads the file header and the XML section it points to ([E2807] §6). @throws input/malformed, input/truncated, input/too-large */
export async function readE57Root(source: ByteSource): Promise<XmlElement> {
  const { name } = source;
  const head = await source.slice(0, HEADER_BYTES);
  if (head.length < HEADER_BYTES) throw cutOffAt(name, `a header of ${HEADER_BYTES} bytes`, head.length);
  const view = viewOf(head);
  const [fileBytes, xmlOffset, xmlBytes, pageBytes] = [16, 24, 32, 40].map((at) =>
    Number(view.getBigUint64(at, true)),
  );
  if (pageBytes !== PAGE_BYTES)
    throw malformedE57(name, `expected pages of ${PAGE_BYTES} bytes, found ${pageBytes}`, { offset: 40 });
  if (source.size !== undefined && fileBytes > source.size)
    throw cutOffAt(name, `${fileBytes} bytes as the header says`, source.size);
  if (xmlBytes > MOST_XML_BYTES) throw xmlTooLarge(name, xmlBytes);
  if (xmlOffset + xmlBytes > fileBytes || xmlOffset < HEADER_BYTES || xmlBytes === 0) {
    throw malformedE57(
      name,
      `expected the XML section within ${fileBytes} bytes, found ${xmlBytes} bytes at byte ${xmlOffset}`,
      { offset: 24 },
    );
  }
  return parseSection(name, xmlOffset, await readLogical(source, xmlOffset, xmlBytes));
}

function parseSection(name: string, offset: number, bytes: Uint8Array): XmlElement {
  try {
    return parseXml(new TextDecoder().decode(bytes));
  } catch (error) {
    if (!(error instanceof XmlError)) throw error;
    throw malformedE57(
      name,
      `expected ${error.message} at character ${error.character} of the XML section at byte ${offset}`,
      { offset, character: error.character },
    );
  }
}

function xmlTooLarge(name: string, bytes: number): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected an XML section of at most ${MOST_XML_BYTES} bytes, found ${bytes}`,
    { hint: 'Export the scans again, in several files.', detail: { bytes, offset: 32 } },
  );
}
