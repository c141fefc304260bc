import fc from 'fast-check';
import { expect, it } from 'vitest';
import { MinCut } from '../../../../src/core/building/space/max-flow.ts';

interface Graph {
  readonly terminals: readonly (readonly [atSink: number, atSource: number])[];
  readonly edges: readonly (readonly [a: number, b: number, cost: number])[];
}

function costOf({ terminals, edges }: Graph, isSource: (node: number) => boolean): number {
  const own = terminals.reduce((sum, [atSink, atSource], i) => sum + (isSource(i) ? atSource : atSink), 0);
  return edges.reduce((sum, [a, b, cost]) => sum + (isSource(a) === isSource(b) ? 0 : cost), own);
}

const graphs: fc.Arbitrary<Graph> = fc.integer({ min: 2, max: 8 }).chain((nodes) => {
  const node = fc.integer({ min: 0, max: nodes - 1 });
  const cost = fc.integer({ min: 0, max: 9 });
  return fc.record({
    terminals: fc.array(fc.tuple(cost, cost), { minLength: nodes, maxLength: nodes }),
    edges: fc.array(
      fc.tuple(node, node, cost).filter(([a, b]) => a !== b),
      { maxLength: 16 },
    ),
  });
});

it('no other cut is cheaper', () => {
  fc.assert(
    fc.property(graphs, (graph) => {
      const cut = new MinCut(graph.terminals.length);
      graph.terminals.forEach(([atSink, atSource], i) => {
        cut.addTerminals(i, atSink, atSource);
      });
      for (const [a, b, cost] of graph.edges) cut.addEdge(a, b, cost);
      const side = cut.solve();
      const found = costOf(graph, (node) => side[node] === 1);
      for (let bits = 0; bits < 1 << graph.terminals.length; bits++) {
        expect(costOf(graph, (node) => ((bits >> node) & 1) === 1)).toBeGreaterThanOrEqual(found);
      }
    }),
  );
});

it('a path of a hundred thousand nodes is no problem', () => {
  const cut = new MinCut(100_000);
  for (let i = 1; i < 100_000; i++) cut.addEdge(i - 1, i, i === 70_000 ? 1 : 2);
  cut.addTerminals(0, 9, 0);
  cut.addTerminals(99_999, 0, 9);
  const side = cut.solve();
  expect([side[69_999], side[70_000]]).toEqual([1, 0]);
});
