import { expect, it } from 'vitest';
import { experimentSections } from './experiment-sections.ts';

const shares = { cases: 100, robust: 0.93, paper: 0.05, paperInner: 0.5 };

it('shows the experiments of a run, a row each', () => {
  const { text } = experimentSections({
    narrowSpaces: [{ width: 0.3, giftOpening: 0.951, alphaShape: 0.949, alphaShapeRegularised: 0.9 }],
    doorGaps: {
      byWidth: [{ width: 0.9, worst: 0.018, mean: 0.004, worstWithout: 0.97, meanWithout: 0.4 }],
      byOpeningLength: [{ openingLength: 2, worst: { ell: 0.017 }, own: 0.033 }],
    },
    recesses: [{ mouth: 1.2, lowest: 0.981, mean: 0.99 }],
    structureCases: { development: shares, keptBack: shares, byDifficulty: { 'l & <round>': shares } },
  });
  expect(text).toContain('<th scope="row">0.30 m</th><td>0.951</td><td>0.949</td><td>0.900</td>');
  expect(text).toContain(
    '<th scope="row">0.90 m</th><td>1.8 %</td><td>0.4 %</td><td>97.0 %</td><td>40.0 %</td>',
  );
  expect(text).toContain('<th scope="row">1.20 m</th><td>0.981</td><td>0.990</td>');
  expect(text.match(/<td>100<\/td><td>93.0 %<\/td><td>5.0 %<\/td><td>50.0 %<\/td>/g)).toHaveLength(3);
  expect(text).toContain('l &amp; &lt;round&gt;');
});
