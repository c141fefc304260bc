import { describe, expect, it } from 'vitest';
import { parseWkt } from '../../../../src/read/las/wkt.ts';
import { openScan } from '../../../../src/read/open-scan.ts';
import { memorySource, readAll } from '../memory-source.ts';
import { CORNERS, geoKeys, type LasContent, lasBytes, wktRecord } from './las-bytes.ts';

async function cloudOf(content: Partial<LasContent>) {
  const bytes = lasBytes({ format: 0, minor: 4, points: CORNERS, ...content });
  return (await openScan([memorySource(bytes, 'a.las')])).cloud;
}

const DEGREES =
  'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257]],UNIT["degree",0.01745329]]';
const NEW_YORK = `PROJCS["NAD83 / New York Long Island (ftUS)",${DEGREES},PROJECTION["Lambert_Conformal_Conic_2SP"],UNIT["US survey foot",0.304800609601219,AUTHORITY["EPSG","9003"]],AXIS["X",EAST],AUTHORITY["EPSG","2263"]]`;
const UTM_2 = `PROJCRS["WGS 84 / UTM zone 32N",BASEGEOGCRS["WGS 84",DATUM["World Geodetic System 1984",ELLIPSOID["WGS 84",6378137,298.257,LENGTHUNIT["metre",1]]],ID["EPSG",4326]],CONVERSION["UTM zone 32N",METHOD["Transverse Mercator",ID["EPSG",9807]]],CS[Cartesian,2],AXIS["(E)",east,ORDER[1],LENGTHUNIT["metre",1]],AXIS["(N)",north,ORDER[2],LENGTHUNIT["metre",1]],ID["EPSG",32632]]`;

describe('units and CRS', () => {
  it.each<[string, Record<number, number>, object]>([
    ['metres', { 1024: 1, 3072: 31_467, 3076: 9001 }, { unit: 'm', crs: 'EPSG:31467' }],
    ['feet', { 1024: 1, 3072: 2222, 3076: 9002 }, { unit: 'ft', crs: 'EPSG:2222' }],
    ['survey feet', { 1024: 1, 3072: 2263, 3076: 9003 }, { unit: 'us-ft', crs: 'EPSG:2263' }],
    ['UTM without a unit', { 1024: 1, 3072: 32_733 }, { unit: 'm', crs: 'EPSG:32733' }],
    ['a unit alone', { 3076: 9002 }, { unit: 'ft', crs: undefined }],
    ['a system of the user', { 1024: 1, 3072: 32_767, 3076: 9001 }, { unit: 'm', crs: undefined }],
    ['state plane without a unit', { 1024: 1, 3072: 2227 }, { unit: 'us-ft', crs: 'EPSG:2227' }],
    ['state plane in other feet', { 1024: 1, 3072: 2281 }, { unit: 'ft', crs: 'EPSG:2281' }],
    ['a code without a unit', { 1024: 1, 3072: 31_467 }, { unit: undefined, crs: 'EPSG:31467' }],
    ['nothing', {}, { unit: undefined, crs: undefined }],
  ])('GeoTIFF keys: %s', async (_, keys, expected) => {
    expect({
      unit: undefined,
      crs: undefined,
      ...(await cloudOf({ records: [geoKeys(keys)] })),
    }).toMatchObject(expected);
  });

  it.each([
    ['WKT 1', NEW_YORK, { unit: 'us-ft', crs: 'EPSG:2263' }],
    ['WKT 2', UTM_2, { unit: 'm', crs: 'EPSG:32632' }],
    [
      'round brackets',
      NEW_YORK.replaceAll('[', '(').replaceAll(']', ')'),
      { unit: 'us-ft', crs: 'EPSG:2263' },
    ],
    [
      'compound with a code of its own',
      `COMPD_CS["a",${NEW_YORK},VERT_CS["h",UNIT["US survey foot",0.3048006096]],AUTHORITY["EPSG","6360"]]`,
      { unit: 'us-ft', crs: 'EPSG:6360' },
    ],
    ['bound', `BOUNDCRS[SOURCECRS[${UTM_2}],TARGETCRS[${DEGREES}]]`, { unit: 'm', crs: 'EPSG:32632' }],
    [
      'local',
      'LOCAL_CS["site",UNIT["foot",0.3048]]',
      { unit: 'ft', crs: 'LOCAL_CS["site",UNIT["foot",0.3048]]' },
    ],
    ['not to be parsed', 'PROJCS["cut', { unit: undefined, crs: 'PROJCS["cut' }],
  ])('%s', async (_, text, expected) => {
    const cloud = await cloudOf({ records: [wktRecord(text)], hasWkt: true });
    expect({ unit: undefined, ...cloud, warnings: cloud.warnings }).toMatchObject({
      ...expected,
      warnings: [],
    });
    // Also behind the points, as long ones are.
    const behind = await cloudOf({
      extended: [{ user: 'other', id: 1, bytes: new Uint8Array(9) }, wktRecord(text)],
      hasWkt: true,
    });
    expect({ unit: undefined, ...behind }).toMatchObject(expected);
  });

  it('follows the header where there are both', async () => {
    const records = [geoKeys({ 1024: 1, 3072: 31_467, 3076: 9001 }), wktRecord(NEW_YORK)];
    expect((await cloudOf({ records, hasWkt: true })).crs).toBe('EPSG:2263');
    expect((await cloudOf({ records })).crs).toBe('EPSG:31467');
  });

  it('converts heights of another unit and says so', async () => {
    const records = [geoKeys({ 1024: 1, 3072: 2222, 3076: 9002, 4099: 9001 })];
    const bytes = lasBytes({ format: 0, minor: 2, points: CORNERS, records, offset: [0, 0, 1] });
    const source = memorySource(bytes, 'a.las');
    const { cloud } = await openScan([source]);
    expect(cloud).toMatchObject({ unit: 'ft', warnings: [{ code: 'read/heights-converted' }] });
    const { xyz } = await readAll(source);
    expect(xyz[7].slice(0, 2)).toEqual([4, 3]);
    expect(xyz[7][2]).toBeCloseTo(3.5 / 0.3048, 9);
  });

  it('says when it does not know the unit', async () => {
    const cloud = await cloudOf({ records: [wktRecord('LOCAL_CS["a",UNIT["yard",0.9144]]')], hasWkt: true });
    expect(cloud).toMatchObject({ warnings: [{ code: 'read/unit-not-known' }] });
    expect(cloud.unit).toBeUndefined();
  });
});

describe('places without a plan', () => {
  const inMunich = {
    bounds: [
      [11.57, 48.13, 510],
      [11.571, 48.131, 530],
    ],
  } as const;
  it.each([
    ['GeoTIFF keys', { records: [geoKeys({ 1024: 2, 2048: 4326 })] }, /EPSG:4326/],
    ['WKT', { records: [wktRecord(DEGREES)], hasWkt: true }, /degrees/],
  ])('refuses degrees told by %s and names the UTM zone', async (_, content, says) => {
    await expect(cloudOf({ ...content, ...inMunich })).rejects.toMatchObject({
      code: 'input/geographic-coordinates',
      message: expect.stringMatching(says),
      hint: expect.stringContaining('EPSG:32632'),
    });
  });

  it('refuses Earth-centred coordinates', async () => {
    const bounds = [
      [4_177_000, 855_000, 4_727_000],
      [4_177_010, 855_010, 4_727_010],
    ] as const;
    const records = [wktRecord('GEODCRS["WGS 84",CS[Cartesian,3],LENGTHUNIT["metre",1]]')];
    await expect(cloudOf({ records, bounds, hasWkt: true })).rejects.toMatchObject({
      code: 'input/geographic-coordinates',
    });
  });

  it.each([
    [
      'a room',
      [
        [0, 0, 0],
        [6, 4, 3],
      ],
    ],
    [
      'UTM',
      [
        [691_000, 5_334_000, 500],
        [691_010, 5_334_010, 503],
      ],
    ],
  ] as const)('passes the label over where the coordinates are those of %s', async (_, bounds) => {
    const cloud = await cloudOf({ records: [geoKeys({ 1024: 2, 2048: 4326 })], bounds });
    expect(cloud).toMatchObject({ warnings: [{ code: 'read/crs-ignored' }] });
    expect(cloud.crs).toBeUndefined();
  });
});

describe('parseWkt', () => {
  it('reads texts with quotes and brackets, numbers and names', () => {
    expect(parseWkt('A["x""[y]",-1.5e3,east,B(2)]')).toEqual({
      keyword: 'A',
      values: ['x"[y]', -1500, 'east'],
      children: [{ keyword: 'B', values: [2], children: [] }],
    });
  });

  it.each(['', 'A', 'A[', 'A["x"', 'A["x" "y"]', '[1]', 'A[1,]', '{"a":1}', 'A[1', 'A['.repeat(10_000)])(
    'is null for %j',
    (text) => {
      expect(parseWkt(text)).toBeNull();
    },
  );
});
