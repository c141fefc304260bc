import { FIELDS } from './point-buffer.ts';

/** Names of columns and properties met in the wild, simplified; the best first. */
const NAMES: Record<(typeof FIELDS)[number], readonly string[]> = {
  x: [
    'x',
    'easting',
    'east',
    'xcoord',
    'xcoordinate',
    'coordx',
    'posx',
    'positionx',
    'pointsx',
    'xm',
    'px',
    'points0',
  ],
  y: [
    'y',
    'northing',
    'north',
    'ycoord',
    'ycoordinate',
    'coordy',
    'posy',
    'positiony',
    'pointsy',
    'ym',
    'py',
    'points1',
  ],
  z: [
    ...['z', 'elevation', 'altitude', 'height', 'zcoord', 'zcoordinate'],
    ...['coordz', 'posz', 'positionz', 'pointsz', 'zm', 'pz', 'points2'],
  ],
  red: ['red', 'r', 'diffusered', 'colorr', 'colourr', 'rf'],
  green: ['green', 'g', 'diffusegreen', 'colorg', 'colourg', 'gf'],
  blue: ['blue', 'b', 'diffuseblue', 'colorb', 'colourb', 'bf'],
  intensity: ['intensity', 'i', 'scalarintensity', 'reflectance', 'scalarreflectance', 'reflectivity'],
  classification: ['classification', 'class', 'scalarclassification', 'scalarclass'],
};

/** For each field of {@link FIELDS} the column that bears one of its names, or −1: `//X`, `"x [m]"`, `diffuse_red`. */
export function columnsOfFields(names: readonly string[]): number[] {
  const simple = names.map(simplifyName);
  return FIELDS.map((field) => {
    const best = NAMES[field].find((name) => simple.includes(name));
    return best === undefined ? -1 : simple.indexOf(best);
  });
}

/** Lower case, without a unit in brackets and without anything but letters and digits. */
function simplifyName(name: string): string {
  return name
    .toLowerCase()
    .replace(/\[.*?\]|\(.*?\)/g, '')
    .replace(/[^a-z0-9]/g, '');
}
