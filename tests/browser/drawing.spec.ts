import { expect, test } from '@playwright/test';
import { build } from 'vite';

/** The parser alone, as a script that leaves it on the page. */
async function parserScript(): Promise<string> {
  const built = await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    build: {
      write: false,
      lib: { entry: 'src/view/parse-drawing.ts', formats: ['iife'], name: 'drawing' },
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
      await parserScript(),
      `${open}<metadata>{}</metadata><g><path d="M0 0h1" fill="url(#hatch)"/><text>A</text></g></svg>`,
      REFUSED,
    ] as const,
  );
  expect(results.good).toBe('1 0 0 -1 0 9');
  expect(results.bad).toEqual(Object.keys(REFUSED).map((name) => [name, 'input/malformed']));
});
