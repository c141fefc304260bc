import { decimal } from '../decimals.ts';
import type { Product, WrittenFile } from '../plan-writer.ts';
import { oneLine, sourceNotes, sourceSpace } from './model-notes.ts';
import { MATERIALS, type MaterialName, type ModelPart, modelParts } from './model-parts.ts';

const MATERIAL_FILE = 'plan.mtl';
/** Of colours in the material file. */
const COLOUR_DIGITS = 3;

/**
 * Writes plan.obj and the plan.mtl it names: an object a part, z up, true source coordinates to 0.1 mm in the source's
 * unit, as every text format.
 */
export function writeObj(product: Product): WrittenFile[] {
  const parts = modelParts(product);
  return [
    { name: 'plan.obj', mime: 'model/obj', content: modelText(product, parts) },
    { name: MATERIAL_FILE, mime: 'model/mtl', content: materialText(parts) },
  ];
}

function modelText({ name, plan }: Product, parts: readonly ModelPart[]): string {
  const { x, y, z, digits } = sourceSpace(plan.frame);
  const lines = [
    ...sourceNotes(name, plan.frame).map((note) => `# ${note}`),
    `mtllib ${MATERIAL_FILE}`,
    's off',
  ];
  for (const storey of plan.storeys) {
    const rooms = storey.rooms.map((room) => oneLine(room.name)).join(', ');
    if (rooms !== '') lines.push(`# rooms of storey ${storey.index}: ${rooms}`);
  }
  let first = 1;
  for (const part of parts) {
    lines.push(`o ${part.name}`, `g ${part.name} storey-${plan.storeys[part.storey].index}`);
    for (const { material, mesh } of part.surfaces) {
      const { positions: p, indices } = mesh;
      for (let i = 0; i < p.length; i += 3) {
        const place = [x(p[i]), y(p[i + 1]), z(p[i + 2])];
        lines.push(`v ${place.map((value) => decimal(value, digits)).join(' ')}`);
      }
      lines.push(`usemtl ${material}`);
      for (let i = 0; i < indices.length; i += 3) {
        lines.push(`f ${first + indices[i]} ${first + indices[i + 1]} ${first + indices[i + 2]}`);
      }
      first += p.length / 3;
    }
  }
  return `${lines.join('\n')}\n`;
}

function materialText(parts: readonly ModelPart[]): string {
  const used = new Set(parts.flatMap(({ surfaces }) => surfaces.map(({ material }) => material)));
  return [...used].map(materialLines).join('\n');
}

function materialLines(name: MaterialName): string {
  const { colour, opacity } = MATERIALS[name];
  const diffuse = colour.map((value) => value.toFixed(COLOUR_DIGITS)).join(' ');
  return `newmtl ${name}\nKd ${diffuse}\nKs 0 0 0\nd ${opacity}\nillum 1\n`;
}
