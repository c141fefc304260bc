import { expect, test } from '@playwright/test';
import { build } from 'vite';
import { areaOf } from '../../src/core/geometry/areas.ts';
import type { Operation, Polygon, Solid, SolidGroup, Storey } from '../../src/core/types.ts';
import { checkSolid } from '../../src/solid/check-solid.ts';
import { wallSection } from '../../src/solid/sections.ts';
import { writeMinimalSvg } from '../../src/write/drawing/minimal-svg.ts';
import { disc, rectangle, reversed, secondary, wallAround } from '../unit/solid/plans.ts';
import { productOf } from '../unit/write/products.ts';
import type { Extruded } from './extrude-drawing.ts';

/** A module alone, as a script that leaves it on the page under `name`. */
async function scriptOf(entry: string, name: string): Promise<string> {
  const built = await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    build: {
      write: false,
      lib: { entry, formats: ['iife'], name },
    },
  });
  const [output] = [built].flat();
  if (!('output' in output)) throw new Error('Vite built nothing.');
  return output.output[0].code;
}

const open = '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9" data-plan-to-sheet="1 0 0 -1 0 9">';

const REFUSED: Readonly<Record<string, string>> = {
  'a script': `${open}<script>alert(1)</script></svg>`,
  'foreign content': `${open}<foreignObject><p xmlns="http://www.w3.org/1999/xhtml"/></foreignObject></svg>`,
  'html inside': `${open}<g><p xmlns="http://www.w3.org/1999/xhtml">x</p></g></svg>`,
  'an image from elsewhere': `${open}<image href="https://example.org/x.png"/></svg>`,
  'an event handler': `${open}<g onload="alert(1)"/></svg>`,
  'a link out': `${open}<use href="https://example.org/x.svg#a"/></svg>`,
  'an inline style': `${open}<g style="fill:url(https://example.org)"/></svg>`,
  'a reference out': `${open}<path fill="url(https://example.org/x.svg#a)"/></svg>`,
  'no transform': '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>',
  'no svg': '<p>x</p>',
  'broken text': `${open}<g></svg>`,
};

test('a drawing of shapes and text is taken; anything that could run or reach out is refused', async ({
  page,
}) => {
  await page.goto('./?src=');
  const results = await page.evaluate(
    ([script, good, bad]) => {
      const { parseDrawing } = new Function(`${script}; return drawing`)();
      const outcome = (text: string) => {
        try {
          return parseDrawing(text).planToSheet.join(' ');
        } catch (error) {
          return (error as { code?: string }).code ?? String(error);
        }
      };
      return { good: outcome(good), bad: Object.entries(bad).map(([name, text]) => [name, outcome(text)]) };
    },
    [
      await scriptOf('src/view/parse-drawing.ts', 'drawing'),
      `${open}<metadata>{}</metadata><g><path d="M0 0h1" fill="url(#hatch)"/><text>A</text></g></svg>`,
      REFUSED,
    ] as const,
  );
  expect(results.good).toBe('1 0 0 -1 0 9');
  expect(results.bad).toEqual(Object.keys(REFUSED).map((name) => [name, 'input/malformed']));
});

const outer = rectangle(0, 0, 8, 6);
const court: Polygon = { outer, holes: [reversed(rectangle(3, 2, 2, 2))] };
const courtWall: Polygon = {
  outer: rectangle(3, 2, 2, 2),
  holes: [reversed(rectangle(3.2, 2.2, 1.6, 1.6))],
};
const wall = (outline: Polygon) => ({ outline, thickness: 0.2, confidence: 1 });
/** A round column half in the wall and a hollow cubicle in the room. */
const structured = (operation: Operation): Partial<Storey> => ({
  primary: [{ outer, holes: [] }],
  walls: [wall(wallAround(outer, 0.2))],
  secondary: [
    secondary(disc(8.1, 3, 0.5, 24), operation),
    secondary(rectangle(1, 1, 1.5, 1), operation, [reversed(rectangle(1.2, 1.2, 1.1, 0.6))]),
  ],
});

const EXTRUDED: Readonly<Record<string, Partial<Storey>>> = {
  'structures subtracted': structured('subtract'),
  'structures added': structured('add'),
  'structures independent': structured('independent'),
  'a courtyard': { primary: [court], walls: [wall(wallAround(outer, 0.2)), wall(courtWall)] },
};

const HEIGHT = 2.5;

function extentOf({ positions, indices, groups }: Solid): number[] {
  const used = groups.flatMap(({ start, count }) => [...indices.subarray(start, start + count)]);
  return [0, 1, 2].flatMap((axis) => {
    const values = used.map((vertex) => positions[3 * vertex + axis]);
    return [Math.min(...values), Math.max(...values)];
  });
}

for (const [name, storey] of Object.entries(EXTRUDED)) {
  test(`plan.minimal.svg through SVGLoader and ExtrudeGeometry is the solid: ${name}`, async ({ page }) => {
    const facts = { storeys: [{ height: HEIGHT, ...storey }], options: { floorSlab: false } };
    const product = await productOf(facts);
    const { plan, solid } = product;
    const of = (kind: SolidGroup['kind']): Solid => ({
      ...solid,
      groups: solid.groups.filter((group) => group.kind === kind),
    });
    const svg = writeMinimalSvg(product, 0);
    await page.goto('./?src=');
    const extruded = await page.evaluate(
      ([script, text, height]) =>
        new Function(`${script}; return loaded`)().extrudeDrawing(text, height) as Extruded[],
      [await scriptOf('tests/browser/extrude-drawing.ts', 'loaded'), svg, HEIGHT] as const,
    );
    const [walls, ...structures] = extruded;
    expect(walls).toMatchObject({ id: 'walls', isClosed: true });
    expect(walls.area).toBeCloseTo(areaOf(wallSection(plan.storeys[0])), 4);
    expect(walls.volume).toBeCloseTo(checkSolid(of('wall')).volume, 4);
    extentOf(of('wall')).forEach((value, i) => {
      expect(walls.bounds[i]).toBeCloseTo(value, 4);
    });
    // Structures are there each as a path of its own; those that stand alone are solids of ours too.
    expect(structures.map(({ id }) => id)).toEqual((storey.secondary ?? []).map((_, i) => `secondary-${i}`));
    const alone = of('secondary');
    if (alone.groups.length === 0) return;
    const volume = structures.reduce((sum, structure) => sum + structure.volume, 0);
    expect(volume).toBeCloseTo(checkSolid(alone).volume, 4);
    expect(structures.every(({ isClosed }) => isClosed)).toBe(true);
  });
}
