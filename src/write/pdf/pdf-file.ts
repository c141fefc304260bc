import { zlibSync } from 'fflate';

const encode = (text: string): Uint8Array => new TextEncoder().encode(text);

/** Assembles a PDF 1.7 file object by object [ISO32000 §7.5]. */
export class PdfFile {
  readonly #objects: (readonly Uint8Array[] | null)[] = [];

  /** A number for an object that is written later. */
  reserve(): number {
    return this.#objects.push(null);
  }

  write(number: number, body: string): number {
    this.#objects[number - 1] = [encode(body)];
    return number;
  }

  add(body: string): number {
    return this.write(this.reserve(), body);
  }

  /** @param facts entries of its dictionary beside length and filter */
  addStream(facts: string, content: Uint8Array): number {
    const packed = zlibSync(content, { level: 6 });
    const head = `<< ${facts} /Filter /FlateDecode /Length ${packed.length} >>\nstream\n`;
    return this.#objects.push([encode(head), packed, encode('\nendstream')]);
  }

  /** @param root number of the catalogue @param info number of the document's facts */
  end(root: number, info: number): Uint8Array<ArrayBuffer> {
    // The second line tells transports that the file is binary.
    const pieces: Uint8Array[] = [encode('%PDF-1.7\n%'), Uint8Array.of(0xe2, 0xe3, 0xcf, 0xd3, 0x0a)];
    let length = pieces.reduce((sum, piece) => sum + piece.length, 0);
    const push = (piece: Uint8Array) => {
      pieces.push(piece);
      length += piece.length;
    };
    const offsets = this.#objects.map((body, i) => {
      const offset = length;
      push(encode(`${i + 1} 0 obj\n`));
      for (const piece of body ?? [encode('null')]) push(piece);
      push(encode('\nendobj\n'));
      return offset;
    });
    const start = length;
    const rows = offsets.map((offset) => `${String(offset).padStart(10, '0')} 00000 n \n`);
    const count = offsets.length + 1;
    push(encode(`xref\n0 ${count}\n0000000000 65535 f \n${rows.join('')}`));
    push(
      encode(
        `trailer\n<< /Size ${count} /Root ${root} 0 R /Info ${info} 0 R >>\nstartxref\n${start}\n%%EOF\n`,
      ),
    );
    return joined(pieces, length);
  }
}

/** Text of any script as a hexadecimal string of UTF-16, byte order mark first [ISO32000 §7.9.2]. */
export function textString(text: string): string {
  let hex = 'FEFF';
  const sound = text.replace(/\p{Surrogate}/gu, '\ufffd');
  for (let i = 0; i < sound.length; i++)
    hex += sound.charCodeAt(i).toString(16).toUpperCase().padStart(4, '0');
  return `<${hex}>`;
}

/** Codes of one byte as a hexadecimal string. */
export function byteString(codes: readonly number[]): string {
  return `<${codes.map((code) => code.toString(16).toUpperCase().padStart(2, '0')).join('')}>`;
}

function joined(pieces: readonly Uint8Array[], length: number): Uint8Array<ArrayBuffer> {
  const file = new Uint8Array(length);
  let offset = 0;
  for (const piece of pieces) {
    file.set(piece, offset);
    offset += piece.length;
  }
  return file;
}
