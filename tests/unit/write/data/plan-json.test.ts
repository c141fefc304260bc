import { expect, test } from 'vitest';
import { FloorPlanError } from '../../../../src/core/errors.ts';
import { parsePlanJson, writePlanJson } from '../../../../src/write/data/plan-json.ts';
import { home, productOf } from '../products.ts';

test('a plan comes back as it was', async () => {
  const { plan } = await productOf({
    ...home(),
    frame: { planOrigin: [0.1, 1 / 3, 5e6], crs: 'EPSG:25832' },
  });
  const text = writePlanJson({ ...(await productOf()), plan });
  expect(parsePlanJson(text)).toEqual(plan);
});

test('rings are lists of pairs, in metres', async () => {
  const { storeys } = JSON.parse(writePlanJson(await productOf())) as {
    storeys: { primary: { outer: number[][] }[] }[];
  };
  expect(storeys[0].primary[0].outer).toEqual([
    [0, 0],
    [4, 0],
    [4, 3],
    [0, 3],
  ]);
});

type Draft = {
  version: number;
  storeys: Record<string, unknown>[];
  frame: Record<string, unknown>;
  options: Record<string, unknown>;
};

test.each<[string, (draft: Draft) => void, string, string]>([
  [
    'another version',
    (draft) => {
      draft.version = 2;
    },
    'input/malformed',
    'format',
  ],
  [
    'storeys that are no list',
    (draft) => {
      draft.storeys = {} as never;
    },
    'input/malformed',
    'storeys',
  ],
  [
    'a ring of two',
    (draft) => {
      draft.storeys[0].primary = [
        {
          outer: [
            [0, 0],
            [1, 1],
          ],
          holes: [],
        },
      ];
    },
    'input/malformed',
    'storeys[0].primary[0].outer',
  ],
  [
    'a coordinate that is no number',
    (draft) => {
      draft.storeys[0].walls = [
        {
          outline: {
            outer: [
              [0, 0],
              [1, 1],
              [2, null],
            ],
            holes: [],
          },
        },
      ];
    },
    'input/malformed',
    'storeys[0].walls[0].outline.outer[2]',
  ],
  [
    'a short origin',
    (draft) => {
      draft.frame.origin = [0, 0];
    },
    'input/malformed',
    'frame.origin',
  ],
  [
    'an unknown option',
    (draft) => {
      draft.options.nonsense = 1;
    },
    'option/unknown',
    'nonsense',
  ],
])('refuses %s, saying where', async (_, spoil, code, place) => {
  const draft = JSON.parse(writePlanJson(await productOf())) as Draft;
  spoil(draft);
  const failure = (() => {
    try {
      return parsePlanJson(JSON.stringify(draft));
    } catch (error) {
      return error;
    }
  })();
  expect(failure).toBeInstanceOf(FloorPlanError);
  expect(failure).toMatchObject({ code });
  expect((failure as FloorPlanError).message).toContain(place);
});

test('refuses what is no JSON', () => {
  expect(() => parsePlanJson('{"format":')).toThrow(expect.objectContaining({ code: 'input/malformed' }));
});
