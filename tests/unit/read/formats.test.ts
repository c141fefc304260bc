import { describe, expect, it } from 'vitest';
import type { FloorPlanError } from '../../../src/core/errors.ts';
import { detectFormat, READ_FORMATS } from '../../../src/read/formats.ts';
import { openScan } from '../../../src/read/open-scan.ts';
import { bytesOf, memorySource } from './memory-source.ts';

describe('detection', () => {
  it.each([
    ['ply', 'ply\nformat ascii 1.0\n', 'scan.txt'],
    ['ply', 'ply\r\nformat ascii 1.0\n', 'scan'],
    ['csv', 'x,y,z\n1,2,3\n', 'scan.ply'],
    ['csv', '1 2 3\n', 'download'],
    ['pcd', '# .PCD v.7 - Point Cloud Data file format\nVERSION .7\n', 'scan.txt'],
    ['pcd', '# mine\nVERSION 0.7\nFIELDS x y z\n', 'scan'],
    ['obj', '# room\nmtllib a.mtl\no Room\nv 1 2 3\nvn 0 0 1\nf 1 1 1\n', 'room'],
    ['obj', '# nothing but a comment\n', 'room.obj'],
    ['glb', 'glTF\x02\0\0\0', 'room'],
    ['glb', '{ "asset": { "version": "2.0" } }', 'room.json'],
    ['csv', 'no numbers here\n', 'scan.csv'],
  ])('%s by content, else by extension: %j as %s', (format, text, name) => {
    expect(detectFormat(bytesOf(text), name)).toBe(format);
  });

  it.each([
    ['photo.ply', Uint8Array.of(0xff, 0xd8, 0xff, 0xe0, 0, 16, 74, 70), 'a JPEG image'],
    ['photo.csv', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10), 'a PNG image'],
    ['scan.txt', bytesOf('%PDF-1.7\n1 0 obj\n'), 'a PDF document'],
    ['scan.csv', bytesOf('<!DOCTYPE html><html>404'), 'an HTML page'],
    ['scan.xyz', Uint8Array.of(1, 2, 3, 0, 200), 'bytes of no known kind'],
    ['sketch.skp', Uint8Array.of(255, 254, 255, 14, 83, 0, 107, 0), 'a SketchUp model'],
    ['plan.dxf', bytesOf('  0\nSECTION\n  2\nHEADER\n'), 'a DXF drawing'],
    ['hall.rcs', Uint8Array.of(1, 2, 3, 0, 200), 'an Autodesk ReCap scan'],
    ['letter', bytesOf('Dear Sir,\nin 2019 there were 3 rooms.\n'), 'text that is no table of points'],
  ])('names what %s looks like', (name, bytes, found) => {
    expect(() => detectFormat(bytes, name)).toThrow(
      expect.objectContaining({ code: 'input/unknown-format', message: expect.stringContaining(found) }),
    );
  });

  it('says what to do instead, where that is known, else what can be read', () => {
    const hintOf = (name: string, text: string | Uint8Array) => {
      try {
        return detectFormat(typeof text === 'string' ? bytesOf(text) : text, name) && '';
      } catch (error) {
        return (error as FloorPlanError).hint;
      }
    };
    expect(hintOf('project.rcp', '<?xml version="1.0"?>')).toMatch(/ReCap as E57 or PTS/);
    expect(hintOf('a.txt', Uint8Array.of(255, 254, 49, 0))).toMatch(/UTF-8/);
    expect(hintOf('scan.las', '<!DOCTYPE html>')).toMatch(/download/);
    expect(hintOf('letter', 'Dear Sir,')).toMatch(/^Read are PLY, .* and Text table\.$/);
  });

  it('refuses an empty file', async () => {
    await expect(openScan([memorySource('', 'a.ply')])).rejects.toMatchObject({ code: 'input/empty' });
  });
});

it('gives every extension to one format', () => {
  const all = Object.values(READ_FORMATS).flatMap(({ extensions }) => extensions);
  expect(new Set(all).size).toBe(all.length);
});
