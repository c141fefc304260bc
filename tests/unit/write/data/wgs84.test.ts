import { describe, expect, it } from 'vitest';
import { writeGeoJson } from '../../../../src/write/data/geojson.ts';
import { writeGeoJsonWgs84 } from '../../../../src/write/data/geojson-wgs84.ts';
import { NATIONAL_SYSTEMS } from '../../../../src/write/data/national-systems.ts';
import { toWgs84 } from '../../../../src/write/data/wgs84.ts';
import { planOf } from '../../solid/plans.ts';
import { home } from '../products.ts';
import { HOSTILE_NAMES, twoRooms } from './rooms-plans.ts';

/** Code, easting, northing, longitude, latitude: by PROJ 9 (pyproj 3.7.2), without grids. */
const KNOWN: readonly (readonly [number, number, number, number, number])[] = [
  [32632, 691880.1234, 5336026.5678, 11.579782416, 48.1485201766],
  [25832, 691880.1234, 5336026.5678, 11.5797824161, 48.1485201777],
  [25831, 430000, 4580000, 2.1629978643, 41.3684702951],
  [32733, 500123.5, 6200456.25, 15.0013426635, -34.3371880608],
  [26918, 583960, 4507523, -74.0059695268, 40.7143492135],
  [6347, 583960, 4507523, -74.0059695268, 40.7143492135],
  [31983, 333000, 7394000, -46.6361856198, -23.5557823508],
  [7856, 334000, 6252000, 151.2055146869, -33.8592617054],
  [28355, 320000, 5812000, 144.9548751171, -37.8216734346],
  [3857, 1290000, 6130000, 11.5882671651, 48.1389357732],
  [2039, 193346.088, 585940.482, 34.9300000028, 31.3649999969],
  [2056, 2660013.544, 1185171.982, 8.2250000117, 46.8150000125],
  [2100, 494168.081, 4240480.131, 23.9349999891, 38.3149999879],
  [2154, 489353.588, 6587552.204, 0.2600000032, 46.3549999997],
  [2157, 603324.377, 739986.434, -7.9499999933, 53.4099999993],
  [2176, 5521578.89, 5852517.238, 15.3200000055, 52.8049999959],
  [2177, 6500000.0, 5836334.701, 18.0, 52.6599999992],
  [2178, 7500000.0, 5742873.499, 21.0, 51.8200000005],
  [2179, 8453342.082, 5730294.964, 23.3250000031, 51.7050000042],
  [2180, 509847.901, 511024.243, 19.1450000069, 52.4650000031],
  [2193, 1557768.545, 5492759.657, 172.5000000018, -40.7150000039],
  [2229, 6631142.589, 1926178.466, -117.7700000003, 34.2849999995],
  [2263, 1252460.553, 263192.275, -73.0299999984, 40.8849999994],
  [2326, 831954.804, 823986.751, 114.1349999998, 22.3550000019],
  [3003, 1497117.608, 4625918.38, 8.9650000023, 41.7849999996],
  [3004, 2561682.593, 4531111.835, 15.495000008, 40.9300000026],
  [3006, 609924.449, 6877630.371, 17.1000000002, 62.014999996],
  [3067, 419924.4, 7149882.001, 25.3350000042, 64.4650000035],
  [3301, 516493.161, 6513417.968, 24.2850000042, 58.7599999985],
  [3414, 27630.672, 31372.914, 103.8300000009, 1.3000000021],
  [3763, 22183.287, -12542.934, -7.8749999991, 39.554999998],
  [3765, 494427.782, 4922223.758, 16.4300000048, 44.4399999968],
  [3794, 499613.77, 112247.58, 14.9949999989, 46.1499999987],
  [3812, 655767.97, 632694.782, 4.4500000062, 50.5049999987],
  [3942, 1806133.465, 1221898.917, 4.2850000044, 42.190000003],
  [3943, 1694308.356, 2218886.833, 2.9300000061, 43.1700000032],
  [3944, 1696789.871, 3195556.683, 2.9599999997, 43.9599999964],
  [3945, 1709855.009, 4200007.602, 3.1250000009, 45.0000000025],
  [3946, 1659335.535, 5200134.02, 2.4749999956, 45.999999999],
  [3947, 1580610.273, 6201196.378, 1.4299999988, 46.9999999969],
  [3948, 1601507.759, 7200843.179, 1.6799999945, 47.9999999972],
  [3949, 1603426.35, 8200839.621, 1.6799999967, 48.9999999998],
  [3950, 1701789.638, 9207785.717, 3.0249999955, 50.0699999969],
  [4647, 32500348.05, 5690971.607, 9.0049999972, 51.3700000024],
  [5179, 1091416.737, 1605023.489, 128.4949999996, 34.434999999],
  [5514, -544006.669, -1144002.812, 17.3250000087, 49.3950000021],
  [5650, 33381693.719, 5678435.227, 13.3049999983, 51.2450000008],
  [21781, 660013.544, 185171.982, 8.2250000117, 46.8150000125],
  [23700, 684692.785, 201865.842, 19.505000009, 47.1599999994],
  [25884, 477490.201, 6311324.522, 23.6299999918, 56.9449999988],
  [27700, 305055.406, 610582.448, -3.49999998, 55.3799999974],
  [28992, 142892.193, 470783.867, 5.2100000078, 52.225000002],
  [29902, 183756.129, 239987.44, -8.2449999889, 53.4100000016],
  [31254, 26674.955, 227959.913, 10.6849999991, 47.1900000098],
  [31255, 181.429, 272918.619, 13.3350000072, 47.5950000104],
  [31256, -24888.572, 294643.411, 16.0000000111, 47.7900000033],
  [31257, 176674.955, 227959.913, 10.6849999991, 47.1900000098],
  [31258, 450181.429, 272918.619, 13.3350000072, 47.5950000104],
  [31259, 725111.428, 294643.411, 16.0000000111, 47.7900000033],
  [31287, 401306.826, 423398.183, 13.3500000055, 47.7100000029],
  [31370, 155763.883, 132693.383, 4.4499999996, 50.5050000058],
  [31466, 2547649.712, 5703045.701, 6.6850000005, 51.4600000035],
  [31467, 3500423.031, 5671670.91, 9.0050000087, 51.1800000065],
  [31468, 4500456.149, 5650531.595, 12.0050000022, 50.9900000053],
  [31469, 5402325.267, 5401677.636, 13.6700000007, 48.7450000008],
];
/** Metres a degree of latitude and, at the equator, of longitude; enough for differences of millimetres. */
const PER_DEGREE = 111_320;
const FEET = /us-ft/;

const metresApart = ([a, b]: readonly number[], [c, d]: readonly number[]) =>
  PER_DEGREE * Math.hypot((a - c) * Math.cos((b * Math.PI) / 180), b - d);

const planIn = (crs: string | undefined, origin: readonly [number, number], frame = {}) =>
  planOf({ ...home(), frame: { ...(crs && { crs }), planOrigin: [...origin, 0], ...frame } });

describe('the way to WGS 84', () => {
  it.each(KNOWN)('of EPSG:%i agrees with PROJ within a millimetre', async (code, east, north, lon, lat) => {
    const isFeet = FEET.test(NATIONAL_SYSTEMS[code]?.[1] ?? '');
    const unit = isFeet ? { unit: 'us-ft' as const, metresPerUnit: 1200 / 3937 } : {};
    const { lonLat, accuracyM } = await toWgs84(planIn(`EPSG:${code}`, [east, north], unit).frame);
    expect(metresApart(lonLat(0, 0), [lon, lat])).toBeLessThan(0.001);
    expect(accuracyM).toBeLessThanOrEqual(6);
    // A metre of the plan is a metre on the ground, but for the scale of the map.
    const scale = Math.cos((lat * Math.PI) / 180);
    const isMercator = code === 3857;
    expect(metresApart(lonLat(100, 0), lonLat(0, 0)) / (isMercator ? scale : 1)).toBeGreaterThan(99);
    expect(metresApart(lonLat(100, 0), lonLat(0, 0)) / (isMercator ? scale : 1)).toBeLessThan(101);
  });

  it('has every national system held against PROJ', () => {
    const known = KNOWN.map(([code]) => code);
    expect(
      Object.keys(NATIONAL_SYSTEMS)
        .map(Number)
        .filter((code) => !known.includes(code)),
    ).toEqual([]);
  });

  const UTM_WKT =
    'PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]]';

  it.each([
    ['well-known text', UTM_WKT],
    [
      'text for plane and height',
      `COMPD_CS["both",${UTM_WKT},VERT_CS["h",VERT_DATUM["h",2005],UNIT["metre",1]]]`,
    ],
  ])('is read from %s', async (_, wkt) => {
    const { lonLat } = await toWgs84(planIn(wkt, [691880.1234, 5336026.5678]).frame);
    expect(metresApart(lonLat(0, 0), [11.579782416, 48.1485201766])).toBeLessThan(0.001);
  });

  it('takes a scan in another unit than its system', async () => {
    const frame = { metresPerUnit: 0.001, unit: 'mm' as const };
    const { lonLat } = await toWgs84(planIn('EPSG:32632', [691880123.4, 5336026567.8], frame).frame);
    expect(metresApart(lonLat(0, 0), [11.579782416, 48.1485201766])).toBeLessThan(0.001);
    expect(metresApart(lonLat(0, 0), lonLat(10, 0))).toBeCloseTo(10, 1);
  });

  const local = UTM_WKT.replaceAll('6378137,298.257223563', '6377397.155,299.1528128').replace(
    'WGS_1984',
    'Own',
  );
  it.each([
    ['no system', undefined, 'found none'],
    ['a code of no table', 'EPSG:2001', 'EPSG:2001'],
    ['degrees', 'EPSG:4326', 'EPSG:4326'],
    ['text of degrees', 'GEOGCS["WGS 84",DATUM["WGS_1984"]]', 'WGS 84'],
    ['a datum of its own', local, 'datum'],
    ['text that breaks off', UTM_WKT.slice(0, 200), 'brackets'],
    ['text of nothing', 'PROJCS["<script>]]>",UNIT["x",1]]', '<script>'],
  ])('is refused for %s, saying why', async (_, crs, words) => {
    const found = toWgs84(planIn(crs, [500_000, 5_000_000]).frame);
    await expect(found).rejects.toMatchObject({
      code: 'result/cannot-write',
      message: expect.stringContaining(words),
    });
    await expect(found).rejects.toMatchObject({ hint: expect.stringMatching(/./) });
  });

  it('is refused where coordinates are none of the system', async () => {
    const far = toWgs84(planIn('EPSG:32632', [9e8, 9e8]).frame);
    await expect(far).rejects.toMatchObject({ code: 'result/cannot-write' });
    const pixels = toWgs84(planIn('EPSG:32632', [5e5, 5e6], { unit: 'px', metresPerUnit: 0.01 }).frame);
    await expect(pixels).rejects.toMatchObject({ code: 'result/cannot-write' });
  });
});

interface Collection {
  readonly bbox: number[];
  readonly features: readonly {
    readonly geometry: { coordinates: number[][][] };
    readonly properties: object;
  }[];
}

describe('plan.wgs84.geojson', () => {
  const origin = [691880.1234, 5336026.5678] as const;

  it('has every feature of plan.geojson with its measures, in longitude and latitude', async () => {
    const plan = planIn('EPSG:25832', origin);
    const text = await writeGeoJsonWgs84({ plan });
    const [file, own]: Collection[] = [JSON.parse(text), JSON.parse(writeGeoJson({ plan }))];
    expect(Object.keys(file)).not.toContain('crs');
    expect(file.features.map(({ properties }) => properties)).toEqual(
      own.features.map(({ properties }) => properties),
    );
    const [west, south] = file.bbox;
    const flat = file.features.flatMap(({ geometry }) => geometry.coordinates.flat(2));
    const [lons, lats] = [0, 1].map((axis) => flat.filter((_, i) => i % 2 === axis));
    expect([Math.min(...lons), Math.min(...lats), Math.max(...lons), Math.max(...lats)]).toEqual(file.bbox);
    expect(west).toBeCloseTo(11.58, 2);
    expect(south).toBeCloseTo(48.15, 2);
  });

  it('turns outer rings to the left, holes to the right, and closes them', async () => {
    const { features }: Collection = JSON.parse(
      await writeGeoJsonWgs84({ plan: planIn('EPSG:32733', [5e5, 62e5]) }),
    );
    for (const { geometry } of features.filter(({ geometry }) => Array.isArray(geometry.coordinates[0][0]))) {
      for (const [i, ring] of geometry.coordinates.entries()) {
        expect(ring.at(-1)).toEqual(ring[0]);
        const twice = ring
          .slice(1)
          .reduce((sum, [x, y], k) => sum + (ring[k][0] - x) * (ring[k][1] + y - 2 * ring[0][1]), 0);
        expect(Math.sign(twice)).toBe(i === 0 ? 1 : -1);
      }
    }
  });

  it('is safe with any name, and there without rooms', async () => {
    const frame = { crs: 'EPSG:25832', planOrigin: [...origin, 0] as const };
    for (const name of HOSTILE_NAMES) {
      const plan = planOf({ ...twoRooms([name, 'b']), frame });
      const { features } = JSON.parse(await writeGeoJsonWgs84({ plan }));
      expect(
        features.some((feature: { properties: { name?: string } }) => feature.properties.name === name),
      ).toBe(true);
    }
    expect(JSON.parse(await writeGeoJsonWgs84({ plan: planOf({ frame }) })).features.length).toBeGreaterThan(
      0,
    );
  });
});
