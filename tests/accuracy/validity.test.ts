import { describe, expect, it } from 'vitest';
import { rectangle, type XY } from '../../fixtures/simulator/ring.ts';
import { isValidPolygon } from './validity.ts';

const outer = rectangle(0, 0, 10, 10);

describe('isValidPolygon', () => {
  it.each<[string, XY[][]]>([
    ['a square', [outer]],
    ['a square turned the other way', [[...outer].reverse()]],
    [
      'vertices on a straight edge',
      [
        [
          [0, 0],
          [5, 0],
          [10, 0],
          [10, 10],
          [0, 10],
        ],
      ],
    ],
    [
      'a repeated vertex',
      [
        [
          [0, 0],
          [10, 0],
          [10, 0],
          [10, 10],
          [0, 10],
        ],
      ],
    ],
    ['two holes apart', [outer, rectangle(1, 1, 2, 2), rectangle(5, 5, 2, 2)]],
    [
      'a hole that touches the outer ring in one point',
      [
        outer,
        [
          [0, 5],
          [3, 4],
          [3, 6],
        ],
      ],
    ],
    ['two holes that touch in one corner', [outer, rectangle(1, 1, 2, 2), rectangle(3, 3, 2, 2)]],
  ])('accepts %s', (_, polygon) => {
    expect(isValidPolygon(polygon)).toBe(true);
  });

  it.each<[string, XY[][]]>([
    ['nothing', []],
    [
      'two points',
      [
        [
          [0, 0],
          [1, 0],
        ],
      ],
    ],
    [
      'a point that is not finite',
      [
        [
          [0, 0],
          [1, 0],
          [Number.NaN, 1],
        ],
      ],
    ],
    [
      'a bow tie',
      [
        [
          [0, 0],
          [10, 10],
          [10, 0],
          [0, 10],
        ],
      ],
    ],
    [
      'a ring that touches itself',
      [
        [
          [0, 0],
          [10, 0],
          [10, 10],
          [5, 0],
          [0, 10],
        ],
      ],
    ],
    [
      'a spike',
      [
        [
          [0, 0],
          [10, 0],
          [10, 10],
          [10, 15],
          [10, 10],
          [0, 10],
        ],
      ],
    ],
    [
      'a triangle without area',
      [
        [
          [0, 0],
          [5, 0],
          [10, 0],
        ],
      ],
    ],
    ['a hole outside', [outer, rectangle(20, 20, 2, 2)]],
    ['a hole across the outer ring', [outer, rectangle(8, 8, 4, 1)]],
    ['a hole in a hole', [outer, rectangle(1, 1, 6, 6), rectangle(2, 2, 2, 2)]],
    ['a hole along the outer ring', [outer, rectangle(0, 2, 2, 2)]],
    [
      'a hole that cuts the inside in two',
      [
        outer,
        [
          [0, 5],
          [5, 4],
          [10, 5],
          [5, 6],
        ],
      ],
    ],
    [
      'holes that close a chain',
      [
        outer,
        [
          [0, 5],
          [5, 4],
          [5, 6],
        ],
        [
          [5, 4],
          [10, 5],
          [6, 6],
        ],
      ],
    ],
  ])('refuses %s', (_, polygon) => {
    expect(isValidPolygon(polygon)).toBe(false);
  });
});
