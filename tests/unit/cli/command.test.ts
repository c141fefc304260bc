import { execFile, spawn } from 'node:child_process';
import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { gzipSync } from 'node:zlib';
import { unzipSync } from 'fflate';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { measurePlan } from '../../accuracy/measure.ts';
import { BAD_INPUTS } from '../../bad-inputs.ts';

const root = resolve(import.meta.dirname, '../../..');
const sample = join(root, 'public/samples/home.ply');
const hallway = join(root, 'public/samples/hallway.csv');
let folder = '';

beforeAll(async () => {
  folder = await mkdtemp(join(tmpdir(), 'grundriss-'));
});
afterAll(() => rm(folder, { recursive: true, force: true }));

interface Outcome {
  readonly exitCode: number;
  readonly stdout: string;
  readonly stderr: string;
  readonly ms: number;
}

function grundriss(...words: string[]): Promise<Outcome> {
  const start = performance.now();
  return new Promise((done) => {
    const child = execFile(process.execPath, [join(root, 'dist/cli.js'), ...words], (_, stdout, stderr) => {
      done({ exitCode: child.exitCode ?? -1, stdout, stderr, ms: performance.now() - start });
    });
  });
}

describe('a good scan', () => {
  it('becomes every file of the contract, and a true report', async () => {
    const out = join(folder, 'all');
    const { exitCode, stdout, stderr } = await grundriss(sample, '-o', out);
    expect(stderr).toBe('');
    expect(exitCode).toBe(0);
    const contract = ['svg', 'pdf', 'minimal.svg', 'geojson', 'dxf', 'glb', 'json', 'frame.json'].map(
      (end) => `plan.${end}`,
    );
    expect((await readdir(out)).sort()).toEqual(
      [...contract, 'slice.csv', 'rooms.csv', 'report.json'].sort(),
    );
    const report = JSON.parse(stdout.trim().split('\n').at(-1)!);
    expect(report).toEqual(JSON.parse(await readFile(join(out, 'report.json'), 'utf8')));
    const header = (await readFile(sample)).subarray(0, 300).toString('latin1');
    expect(report.input.pointsRead).toBe(Number(/element vertex (\d+)/.exec(header)![1]));
    expect(report.input.bytes).toBe((await readFile(sample)).length);
    expect(report.mesh.watertight).toBe(true);
    const plan = JSON.parse(await readFile(join(out, 'plan.geojson'), 'utf8'));
    const truth = JSON.parse(await readFile(join(root, 'fixtures/samples/home.gt.json'), 'utf8'));
    // Its hall once opened to the outside through a wall that the scan hardly shows.
    expect(measurePlan(plan, truth).footprintIou).toBeGreaterThan(0.99);
    expect(report.levels.filter((level: { chosen: boolean }) => level.chosen)).toHaveLength(1);
  });

  it('is written again from its plan.json, but for its points', async () => {
    const [first, again] = [join(folder, 'all'), join(folder, 'again')];
    const { exitCode, stderr } = await grundriss(join(first, 'plan.json'), '-o', again);
    expect([exitCode, stderr]).toEqual([0, '']);
    const names = (await readdir(first)).filter((name) => name !== 'slice.csv');
    expect((await readdir(again)).sort()).toEqual(names.sort());
    for (const name of names.filter((other) => other !== 'report.json')) {
      const [was, is] = await Promise.all([readFile(join(first, name)), readFile(join(again, name))]);
      expect(is.equals(was), name).toBe(true);
    }
    const slice = await grundriss(join(first, 'plan.json'), '-o', again, '--formats', 'slice');
    expect(slice.exitCode).toBe(4);
    expect(slice.stderr).toMatch(/^grundriss: result\/cannot-write: slice\.csv: .*without its scan/);
  });

  it('is scaled by --metres-per-unit and cut to --crop, in its own coordinates', async () => {
    const out = join(folder, 'scaled');
    // Twice as large, and the half with x up to 7.
    const words = ['--metres-per-unit', '2', '--crop', '-100,-100,7,100', '--formats', 'geojson'];
    const { exitCode, stdout } = await grundriss(sample, '-o', out, ...words);
    expect(exitCode).toBe(0);
    expect(JSON.parse(stdout).input).toMatchObject({ unit: 'custom', metresPerUnit: 2 });
    const { frame, features } = JSON.parse(await readFile(join(out, 'plan.geojson'), 'utf8'));
    expect(frame).toEqual({ unit: 'custom', metresPerUnit: 2 });
    const primary = features.find((feature: { properties: { kind: string } }) =>
      feature.properties.kind.startsWith('primary'),
    );
    const xs = primary.geometry.coordinates[0].map(([x]: number[]) => x);
    expect(Math.max(...xs)).toBeLessThan(7.2);
    expect(Math.max(...xs)).toBeGreaterThan(6);
    const beside = await grundriss(sample, '-o', join(folder, 'beside'), '--crop', '50,50,60,60');
    expect(beside.exitCode).toBe(3);
    expect(beside.stderr).toMatch(/^grundriss: input\/too-few-points: crop: .*50,50,60,60 m, found 0/);
  });

  it('gives equal bytes for equal input', async () => {
    const [a, b] = [join(folder, 'a'), join(folder, 'b')];
    await grundriss(sample, '-o', a);
    await grundriss(sample, '-o', b);
    for (const name of await readdir(a)) {
      if (name === 'report.json') continue;
      expect((await readFile(join(a, name))).equals(await readFile(join(b, name))), name).toBe(true);
    }
  });

  it('is written whole when nobody reads the report to its end', async () => {
    const out = join(folder, 'unread');
    const words = [join(root, 'dist/cli.js'), hallway, '-o', out, '--formats', 'svg'];
    const child = spawn(process.execPath, words, { stdio: ['ignore', 'pipe', 'pipe'] });
    child.stdout.destroy();
    let said = '';
    child.stderr.on('data', (part) => {
      said += part;
    });
    const exitCode = await new Promise((done) => child.on('close', done));
    expect(said).toBe('');
    expect(exitCode).toBe(0);
    expect(await readdir(out)).toContain('plan.svg');
  });

  it('writes several inputs into folders and only the formats asked for', async () => {
    const out = join(folder, 'several');
    const { exitCode, stdout } = await grundriss(
      sample,
      hallway,
      sample,
      '-o',
      out,
      '--formats',
      'geojson,report',
    );
    expect(exitCode).toBe(0);
    expect(stdout.trim().split('\n')).toHaveLength(3);
    expect((await readdir(out)).sort()).toEqual(['hallway', 'home', 'home-2']);
    expect((await readdir(join(out, 'home-2'))).sort()).toEqual(['plan.geojson', 'report.json']);
  });

  it('takes several inputs as parts of one scan when asked, packed or not', async () => {
    const rows = (await readFile(hallway, 'utf8')).trim().split('\n');
    const [header, ...points] = rows;
    const parts = [points.slice(0, 700), points.slice(700)].map(
      (part) => `${[header, ...part].join('\n')}\n`,
    );
    const [plain, packed] = [join(folder, 'part-1.csv'), join(folder, 'part-2.csv.gz')];
    await writeFile(plain, parts[0]);
    await writeFile(packed, gzipSync(parts[1]));
    const [together, whole] = [join(folder, 'together'), join(folder, 'whole')];
    const { exitCode, stdout } = await grundriss(
      plain,
      packed,
      '--merge',
      '-o',
      together,
      '--formats',
      'geojson',
    );
    expect(exitCode).toBe(0);
    expect(JSON.parse(stdout).input).toMatchObject({ name: 'part-1.csv + 1', pointsRead: points.length });
    await grundriss(hallway, '-o', whole, '--formats', 'geojson');
    expect(await readFile(join(together, 'plan.geojson'), 'utf8')).toBe(
      await readFile(join(whole, 'plan.geojson'), 'utf8'),
    );
  });

  it('packs the formats named beside zip', async () => {
    const out = join(folder, 'packed');
    const { exitCode } = await grundriss(hallway, '-o', out, '--formats', 'dxf,rooms,zip');
    expect(exitCode).toBe(0);
    expect((await readdir(out)).sort()).toEqual(['plan.dxf', 'plan.zip', 'report.json', 'rooms.csv']);
    const entries = unzipSync(await readFile(join(out, 'plan.zip')));
    expect(Object.keys(entries)).toEqual(['plan.dxf', 'rooms.csv', 'README.txt']);
  });

  it('draws the stages when asked', async () => {
    const out = join(folder, 'pictures');
    const { exitCode } = await grundriss(hallway, '-o', out, '--formats', 'pictures');
    expect(exitCode).toBe(0);
    const names = (await readdir(out)).filter((name) => name.startsWith('picture-'));
    expect(names).toHaveLength(8);
    expect(names).toContain('picture-04-hull.svg');
    expect(await readFile(join(out, 'picture-04-hull.svg'), 'utf8')).toMatch(/^<\?xml/);
    const usual = join(folder, 'usual');
    await grundriss(hallway, '-o', usual);
    expect((await readdir(usual)).filter((name) => name.startsWith('picture-'))).toEqual([]);
  });
});

describe('bad input', () => {
  it('of a run that fails, the pictures asked for are those before the failing stage', async () => {
    const out = join(folder, 'evidence');
    const failing = ['--boundary', 'alpha-shape', '--alpha', '0.001'];
    const { exitCode, stderr } = await grundriss(hallway, '-o', out, ...failing, '--formats', 'svg,pictures');
    expect(exitCode).toBe(4);
    expect(stderr).toContain('result/no-boundary');
    expect((await readdir(out)).sort()).toEqual(['picture-01-cloud.svg', 'picture-03-slice.svg']);
    await grundriss(hallway, '-o', join(folder, 'no-evidence'), ...failing);
    await expect(readdir(join(folder, 'no-evidence'))).rejects.toThrow('ENOENT');
  });

  it.each(BAD_INPUTS.map((bad) => [bad.name, bad] as const))(
    '%s gives its error and leaves nothing',
    async (_, bad) => {
      const input = join(folder, bad.name);
      const out = join(folder, `out-${bad.name}`);
      await writeFile(input, bad.bytes);
      const { exitCode, stdout, stderr, ms } = await grundriss(input, '-o', out);
      expect(stderr).toMatch(new RegExp(`^grundriss: ${bad.code}: [^\n]+ \\([^\n]+\\)\n$`));
      expect(stderr).toMatch(bad.says);
      expect(exitCode).toBe(3);
      expect(stdout).toBe('');
      expect(ms).toBeLessThan(5000);
      await expect(readdir(out)).rejects.toThrow('ENOENT');
    },
  );

  it('tells errors as JSON when asked', async () => {
    const { stderr } = await grundriss(join(folder, 'absent.ply'), '-o', folder, '--json');
    expect(JSON.parse(stderr).error).toMatchObject({ code: 'input/unreadable' });
  });
});

describe('bad words', () => {
  it.each([
    [['--epsilon', 'wide', sample, '-o', 'x'], /option\/invalid: epsilon/],
    [['--eplison', '1', sample, '-o', 'x'], /option\/unknown: --eplison/],
    [['--formats', 'svg,pdx', sample, '-o', 'x'], /option\/invalid: --formats/],
    [[sample], /option\/invalid: No output folder/],
    [['-o', 'x'], /option\/invalid: No input/],
    [[sample, '-o'], /option\/invalid: -o: expected a value, found the end/],
    [[sample, '-o', '--formats', 'svg'], /option\/invalid: -o: expected a value, found --formats/],
  ])('%j exit with 2', async (words, says) => {
    const { exitCode, stderr } = await grundriss(...words);
    expect(stderr).toMatch(says);
    expect(exitCode).toBe(2);
  });

  it('prints help and version', async () => {
    const help = (await grundriss('--help')).stdout;
    expect(help).toContain('--wall-thickness');
    expect(help).toContain('Default empty.');
    expect(help).toMatch(/^ {2}geojson-wgs84 The same/m);
    expect((await grundriss('--version')).stdout).toMatch(/^\d+\.\d+\.\d+\n$/);
  });

  it('says so when the folder cannot be written', async () => {
    const file = join(folder, 'a-file');
    await writeFile(file, '');
    const { exitCode, stderr } = await grundriss(sample, '-o', join(file, 'below'));
    expect(stderr).toMatch(/environment\/file-system/);
    expect(exitCode).toBe(5);
  });

  it.skipIf(process.platform !== 'linux')('says so where folders cannot be made at all', async () => {
    const { exitCode, stderr } = await grundriss(sample, '-o', '/proc/plan/below');
    expect(stderr).toMatch(/environment\/file-system/);
    expect(exitCode).toBe(5);
  });
});
