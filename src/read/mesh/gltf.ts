import type { ReadFormat } from '../cloud-reader.ts';
import { isText, latin1 } from '../signatures.ts';
import { isGlb } from './glb-mark.ts';

/** A JSON object with an entry that models have and maps have not. */
const JSON_MODEL = /^(\xef\xbb\xbf)?\s*\{[\s\S]*"(asset|accessors|bufferViews|meshes)"\s*:/;

export const GLTF_FORMAT: ReadFormat = {
  label: 'GLB',
  extensions: ['glb', 'gltf'],
  doc: 'glTF 2.0 model, with its data inside: triangles are sampled to the working resolution; metres. Packed by Draco or meshopt too.',
  detect: (head) => isGlb(head) || (isText(head) && JSON_MODEL.test(latin1(head))),
  open: async (source) => (await import('./gltf-reader.ts')).openGltf(source),
};
