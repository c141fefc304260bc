import { beforeAll, describe, expect, test } from 'vitest';
import * as webIfc from 'web-ifc';
import { writeIfc } from '../../../../src/write/ifc/ifc.ts';
import { disc, type PlanFacts, planOf, rectangle, secondary, wallAround } from '../../solid/plans.ts';
import { FLAT_RING, flat, UTM } from './ifc-plans.ts';
import { IfcReader } from './ifc-reader.ts';

/** The writer needs the plan alone. */
const productOf = (facts: PlanFacts, name = 'flat') => {
  const plan = planOf(facts);
  return { name, plan, options: plan.options };
};

const ifcOf = (facts: PlanFacts, name?: string): string => writeIfc(productOf(facts, name));
const open = (facts: PlanFacts, name?: string): Promise<IfcReader> => IfcReader.open(ifcOf(facts, name));

/** Within 0.1 %. */
function expectNear(found: number, expected: number): void {
  expect(Math.abs(found - expected)).toBeLessThanOrEqual(1e-3 * expected);
}

const refs = (values: { value: number }[]): number[] => values.map(({ value }) => value);

describe('a flat read back by web-ifc', () => {
  let ifc: IfcReader;
  beforeAll(async () => {
    ifc = await open({ storeys: [flat(), { ...flat(), floor: 2.8 }], frame: UTM });
  });

  test('hangs together: project, site, building, storeys, spaces', () => {
    const wholes = new Map<string, string[]>();
    for (const { RelatingObject, RelatedObjects } of ifc.lines(webIfc.IFCRELAGGREGATES)) {
      const name = (id: number) => ifc.line(id).Name.value as string;
      wholes.set(name(RelatingObject.value), refs(RelatedObjects).map(name));
    }
    expect(wholes.get('Storey 0')).toEqual(['1', '2']);
    expect(wholes.get('Site')).toEqual(['flat']);
    expect(ifc.lines(webIfc.IFCBUILDINGSTOREY).map(({ Elevation }) => Elevation.value)).toEqual([0, 2.8]);
  });

  test('has a thing of its class for each of the plan', () => {
    const counts = [webIfc.IFCSPACE, webIfc.IFCWALL, webIfc.IFCDOOR, webIfc.IFCWINDOW].map(
      (type) => ifc.ids(type).length,
    );
    expect(counts).toEqual([4, 12, 2, 2]);
    const others = [webIfc.IFCCOLUMN, webIfc.IFCBUILDINGELEMENTPROXY, webIfc.IFCSLAB, webIfc.IFCFURNITURE];
    expect(others.map((type) => ifc.ids(type).length)).toEqual([2, 2, 2, 2]);
    const [shaft] = ifc.lines(webIfc.IFCBUILDINGELEMENTPROXY);
    expect(shaft.ObjectType.value).toBe('SHAFT');
  });

  test('voids every wall an opening goes through, and fills each opening once', () => {
    // A storey: the door in two walls, the window, the passage.
    expect(ifc.lines(webIfc.IFCRELVOIDSELEMENT)).toHaveLength(8);
    const filled = ifc
      .lines(webIfc.IFCRELFILLSELEMENT)
      .map((fills) => ifc.line(fills.RelatedBuildingElement.value));
    expect(filled.map(({ Name }) => Name.value)).toEqual(['Door 1', 'Window 1', 'Door 1', 'Window 1']);
    const sizes = filled.map(({ OverallWidth, OverallHeight }) => [OverallWidth.value, OverallHeight.value]);
    expect(sizes.slice(0, 2)).toEqual([
      [0.9, 2],
      [1.2, 1.2],
    ]);
  });

  test('spaces have the volumes and areas drawn', () => {
    const [kitchen, hall] = ifc.ids(webIfc.IFCSPACE);
    expectNear(ifc.volume(kitchen), 4 * 5 * 2.4);
    expectNear(ifc.volume(hall), 3.8 * 5 * 2.5);
    expect(ifc.set(kitchen, 'Qto_SpaceBaseQuantities')).toMatchObject({
      GrossFloorArea: 20,
      // Less the column, of 0.4 m × 0.4 m; less the doorway.
      NetFloorArea: 19.84,
      GrossPerimeter: 18,
      NetPerimeter: 17.1,
      Height: 2.4,
    });
    expect(ifc.set(hall, 'Qto_SpaceBaseQuantities')).toMatchObject({
      NetFloorArea: 18.5,
      NetPerimeter: 15.7,
    });
    expect(ifc.set(kitchen, 'Grundriss_Evidence')).toEqual({ Confidence: 0.75, UnseenOutline: 0.5 });
    expect(ifc.set(kitchen, 'Pset_SpaceCommon')).toEqual({ Reference: '1', IsExternal: false });
  });

  test('walls have the volumes drawn, openings cut', () => {
    const expected = [
      8.6 * 0.3 * 2.5 - 1.2 * 1.2 * 0.3,
      8.6 * 0.3 * 2.5,
      5 * 0.3 * 2.5,
      5 * 0.3 * 2.5 - 1 * 2.5 * 0.3,
      2.5 * 0.2 * 2.5 - 0.5 * 2 * 0.2,
      2.5 * 0.2 * 2.5 - 0.4 * 2 * 0.2,
    ];
    ifc.ids(webIfc.IFCWALL).forEach((wall, i) => {
      expectNear(ifc.volume(wall), expected[i % 6]);
      const said = ifc.set(wall, 'Qto_WallBaseQuantities') as { NetVolume: number };
      expectNear(said.NetVolume, expected[i % 6]);
      expect(ifc.set(wall, 'Pset_WallCommon')).toEqual({ IsExternal: i % 6 < 4 });
    });
  });

  test('walls are of a layer as thick as they are', () => {
    const thickness = new Map<number, number>();
    for (const { RelatedObjects, RelatingMaterial } of ifc.lines(webIfc.IFCRELASSOCIATESMATERIAL)) {
      const set = ifc.line(RelatingMaterial.value, true);
      for (const wall of refs(RelatedObjects))
        thickness.set(wall, set.MaterialLayers[0].LayerThickness.value);
    }
    const [outer, , , , inner] = ifc.ids(webIfc.IFCWALL);
    expect([thickness.get(outer), thickness.get(inner)]).toEqual([0.3, 0.2]);
  });

  test('columns, slabs and what fills openings are solid', () => {
    const [column] = ifc.ids(webIfc.IFCCOLUMN);
    expectNear(ifc.volume(column), 0.4 * 0.4 * 2.5);
    const [slab] = ifc.ids(webIfc.IFCSLAB);
    // Less the shaft, which is subtracted.
    expectNear(ifc.volume(slab), (8.6 * 5.6 - 0.5) * 0.1);
    const [door] = ifc.ids(webIfc.IFCDOOR);
    expectNear(ifc.volume(door), 0.9 * 2 * 0.04);
    const [window] = ifc.ids(webIfc.IFCWINDOW);
    expectNear(ifc.volume(window), (1.2 ** 2 - 1.08 ** 2) * 0.06 + 1.08 ** 2 * 0.02);
    const [table] = ifc.ids(webIfc.IFCFURNITURE);
    expectNear(ifc.volume(table), 1.2 * 0.8 * 0.75);
  });
});

describe('where it stands', () => {
  const conversionOf = async (frame: NonNullable<PlanFacts['frame']>) => {
    const ifc = await open({ storeys: [flat()], frame });
    const [conversion] = ifc.lines(webIfc.IFCMAPCONVERSION, true);
    return { ifc, conversion };
  };

  test('a UTM origin comes back to 0.1 mm', async () => {
    const { conversion } = await conversionOf(UTM);
    expect(conversion.TargetCRS.Name.value).toBe('EPSG:25832');
    const { Eastings, Northings, OrthogonalHeight, Scale } = conversion;
    const [east, north, height] = UTM.planOrigin;
    expect(Math.abs(Eastings.value - east)).toBeLessThan(1e-4);
    expect(Math.abs(Northings.value - north)).toBeLessThan(1e-4);
    expect(Math.abs(OrthogonalHeight.value - height)).toBeLessThan(1e-4);
    expect(Scale.value).toBe(1);
  });

  test('feet stay the unit of a map in feet, millimetres become metres', async () => {
    const planOrigin = [986000.1234, 212000.5678, 33] as const;
    const feet = 1200 / 3937;
    const survey = await conversionOf({ planOrigin, unit: 'us-ft', metresPerUnit: feet, crs: 'EPSG:2263' });
    expect(survey.conversion.Eastings.value).toBe(986000.1234);
    expect(survey.conversion.Scale.value).toBeCloseTo(1 / feet, 12);
    const { MapUnit } = survey.conversion.TargetCRS;
    expect(MapUnit.Name.value).toBe('US SURVEY FOOT');
    expect(MapUnit.ConversionFactor.ValueComponent.value).toBeCloseTo(feet, 12);
    const small = { planOrigin: [691880123, 5336026432, 1000], unit: 'mm', metresPerUnit: 1e-3 } as const;
    const { conversion } = await conversionOf({ ...small, crs: 'urn:ogc:def:crs:EPSG::25832' });
    expect(conversion.Eastings.value).toBeCloseTo(691880.123, 6);
    expect(conversion.Scale.value).toBe(1);
  });

  test('WKT tells the code of its projected system, not of a part', async () => {
    const crs =
      'COMPD_CS["a",PROJCS["ETRS89 / UTM 32N",GEOGCS["ETRS89",AUTHORITY["EPSG","4258"]],UNIT["metre",1],AUTHORITY["EPSG","25832"]],VERT_CS["h",AUTHORITY["EPSG","7837"]]]';
    const { conversion } = await conversionOf({ ...UTM, crs });
    expect(conversion.TargetCRS.Name.value).toBe('EPSG:25832');
  });

  test.each([undefined, 'EPSG:4326', 'LOCAL_CS["site"]', 'PROJCS["no code"]'])(
    'without a map (%s) near source coordinates are the site’s place, far ones its properties',
    async (crs) => {
      const named = crs === undefined ? {} : { crs };
      for (const [planOrigin, expected] of [
        [
          [12.5, -7, 1],
          [12.5, -7, 1],
        ],
        [
          [691880.1234, 5336026, 520],
          [0, 0, 0],
        ],
      ] as const) {
        const { ifc, conversion } = await conversionOf({ planOrigin, ...named });
        expect(conversion).toBeUndefined();
        const [site] = ifc.ids(webIfc.IFCSITE);
        const { ObjectPlacement } = ifc.line(site, true);
        const place = ObjectPlacement.RelativePlacement.Location.Coordinates;
        expect(place.map(({ value }: { value: number }) => value)).toEqual(expected);
        expect(ifc.set(site, 'Grundriss_Source')).toMatchObject({
          OriginX: planOrigin[0],
          OriginY: planOrigin[1],
          OriginZ: planOrigin[2],
        });
      }
    },
  );
});

test('rooms are numbered through the storeys, as the schedule has them', async () => {
  const ifc = await open({
    storeys: [flat(['Kitchen', 'Hall']), { ...flat(['Bath', 'Attic']), index: 1, floor: 2.8 }],
  });
  const spaces = ifc.lines(webIfc.IFCSPACE).map(({ Name, LongName }) => `${Name.value} ${LongName.value}`);
  expect(spaces).toEqual(['1 Kitchen', '2 Hall', '3 Bath', '4 Attic']);
});

describe('hostile plans', () => {
  test('names come back, the longest in the description', async () => {
    const long = '😀'.repeat(5000);
    const hostile = `<script>"&]]>'\\X2\\ \\ 😀𝒳 مرحبا‏ é\u2028`;
    const ifc = await open({ storeys: [flat([hostile, long])] }, hostile);
    const [first, second] = ifc.lines(webIfc.IFCSPACE);
    expect([first.Name.value, first.LongName.value]).toEqual(['1', hostile]);
    expect(second.LongName.value).toBe(`${'😀'.repeat(254)}…`);
    expect(second.Description.value).toBe(long);
    expect(ifc.lines(webIfc.IFCPROJECT)[0].Name.value).toBe(hostile);
  });

  test('control characters and halves of characters do no harm', async () => {
    const ifc = await open({ storeys: [flat(['a\u0000b\r\nc\u0085\u007f', 'x\ud800y'])] });
    const names = ifc.lines(webIfc.IFCSPACE).map(({ LongName }) => LongName.value);
    expect(names).toEqual(['a b  c  ', 'x\ufffdy']);
    expect(ifcOf({ storeys: [flat(['\u0000', '\ud800'])] })).toMatch(/^[\n -~]*$/);
  });

  test('a plan without rooms has walls and slab; nothing is said of what is outside', async () => {
    const ifc = await open({});
    expect(ifc.ids(webIfc.IFCSPACE)).toEqual([]);
    const [wall] = ifc.ids(webIfc.IFCWALL);
    expectNear(ifc.volume(wall), (4.4 * 3.4 - 12) * 2.5);
    expect(ifc.set(wall, 'Pset_WallCommon')).toEqual({});
    expectNear(ifc.volume(ifc.ids(webIfc.IFCSLAB)[0]), 4.4 * 3.4 * 0.1);
  });

  test('an empty storey, and none, are files', async () => {
    const nothing = { primary: [], walls: [], rooms: [] };
    expect((await open({ storeys: [nothing] })).names(webIfc.IFCBUILDINGSTOREY)).toEqual(['Storey 0']);
    expect((await open({ storeys: [] })).names(webIfc.IFCBUILDING)).toEqual(['flat']);
  });

  test('what has no area has no shape; a room stays', async () => {
    const storey = flat();
    const ifc = await open({
      storeys: [
        {
          ...storey,
          walls: [{ ...storey.walls![0], outline: FLAT_RING }, ...storey.walls!.slice(1)],
          rooms: [{ ...storey.rooms![0], outline: FLAT_RING }, storey.rooms![1]],
          secondary: [{ ...secondary(FLAT_RING.outer, 'subtract') }],
          openings: [{ ...storey.openings![0], to: storey.openings![0].from }, ...storey.openings!],
        },
      ],
    });
    expect(ifc.names(webIfc.IFCWALL)).toEqual(['Wall 2', 'Wall 3', 'Wall 4', 'Wall 5', 'Wall 6']);
    expect(ifc.lines(webIfc.IFCSPACE).map(({ Representation }) => Representation === null)).toEqual([
      true,
      false,
    ]);
    expect(ifc.ids(webIfc.IFCCOLUMN)).toEqual([]);
    expect(ifc.ids(webIfc.IFCDOOR)).toHaveLength(1);
    // The window's wall is gone: it stands by itself.
    expect(ifc.names(webIfc.IFCWINDOW)).toEqual(['Window 1']);
    expect(ifc.ids(webIfc.IFCRELVOIDSELEMENT)).toHaveLength(3);
  });
});

test('a round wall is its chords, cut by a door', async () => {
  const inner = disc(0, 0, 3, 72);
  const wall = wallAround(inner, 0.2);
  const door = {
    type: 'door',
    from: [3.1, -0.45],
    to: [3.1, 0.45],
    sill: 0,
    head: 2,
    confidence: 1,
  } as const;
  const room = { name: 'Hall', outline: { outer: inner, holes: [] }, height: 2.5, confidence: 1 };
  const ifc = await open({
    storeys: [
      {
        primary: [room.outline],
        walls: [{ outline: wall, thickness: 0.2, confidence: 1 }],
        rooms: [room],
        openings: [door],
      },
    ],
  });
  const area = 0.5 * 72 * 9 * Math.sin(Math.PI / 36);
  expectNear(ifc.volume(ifc.ids(webIfc.IFCSPACE)[0]), area * 2.5);
  const [id] = ifc.ids(webIfc.IFCWALL);
  const { GrossVolume, NetVolume } = ifc.set(id, 'Qto_WallBaseQuantities') as Record<string, number>;
  // The wall's edges are moved out by its thickness.
  const apothem = 3 * Math.cos(Math.PI / 72);
  expectNear(GrossVolume, area * ((1 + 0.2 / apothem) ** 2 - 1) * 2.5);
  expectNear(ifc.volume(id), NetVolume);
  const cut = GrossVolume - NetVolume;
  expect(cut).toBeGreaterThan(0.9 * 0.2 * 2);
  expect(cut).toBeLessThan(0.9 * 0.2 * 2 * 1.05);
});

test('structures that are added or subtracted take their place in the wall', async () => {
  const storey = flat();
  const column = { ...secondary(rectangle(-0.3, 1, 0.3, 1), 'add'), type: 'column' } as const;
  const ifc = await open({ storeys: [{ ...storey, secondary: [column] }] });
  expectNear(ifc.volume(ifc.ids(webIfc.IFCWALL)[2]), 4 * 0.3 * 2.5);
  expectNear(ifc.volume(ifc.ids(webIfc.IFCCOLUMN)[0]), 0.3 * 2.5);
});

test('slabs are as the parameters ask', async () => {
  const storeys = [flat()];
  const none = await open({ storeys, options: { floorSlab: false } });
  expect(none.ids(webIfc.IFCSLAB)).toEqual([]);
  const both = await open({ storeys, options: { ceilingSlab: true, slabThickness: 0.25 } });
  const types = both.lines(webIfc.IFCSLAB).map(({ PredefinedType }) => PredefinedType.value);
  expect(types).toEqual(['FLOOR', 'USERDEFINED']);
  for (const slab of both.ids(webIfc.IFCSLAB)) expectNear(both.volume(slab), (8.6 * 5.6 - 0.5) * 0.25);
});

test('of rooms called alike each has its own unseen outline and furniture', async () => {
  const storey = flat(['Office', 'Office']);
  const gaps = [...storey.gaps!, { from: [8, 1], to: [8, 3], width: 2, room: 'Office' } as const];
  const ifc = await open({ storeys: [{ ...storey, gaps }] });
  const unseen = ifc.ids(webIfc.IFCSPACE).map((id) => ifc.set(id, 'Grundriss_Evidence').UnseenOutline);
  expect(unseen).toEqual([0.5, 2]);
});

describe('ids', () => {
  const guidsOf = (file: string): string[] =>
    [...file.matchAll(/=IFC\w+\('([0-9A-Za-z_$]{22})',/g)].map(([, guid]) => guid);

  test('equal plans give equal bytes, and every id is one of its own', () => {
    const file = ifcOf({ storeys: [flat(['same', 'same']), flat(['same', 'same'])] });
    expect(ifcOf({ storeys: [flat(['same', 'same']), flat(['same', 'same'])] })).toBe(file);
    const guids = guidsOf(file);
    expect(new Set(guids).size).toBe(guids.length);
    expect(guids.every((guid) => /^[0-3]/.test(guid))).toBe(true);
  });

  test('a space keeps its id under another name', async () => {
    const idsOf = async (names: readonly [string, string]) =>
      (await open({ storeys: [flat(names)] })).lines(webIfc.IFCSPACE).map(({ GlobalId }) => GlobalId.value);
    expect(await idsOf(['Room 1', 'Room 2'])).toEqual(await idsOf(['Room 2', 'Kitchen']));
  });

  test('a wall keeps its id when another goes', async () => {
    const idOf = async (storey: ReturnType<typeof flat>) =>
      (await open({ storeys: [storey] })).lines(webIfc.IFCWALL).at(-1).GlobalId.value;
    const storey = flat();
    expect(await idOf({ ...storey, walls: storey.walls!.slice(1) })).toBe(await idOf(storey));
  });
});

test('the project and the day are those given for the sheet', async () => {
  const { name, plan, options } = productOf({ storeys: [flat()] });
  const given = { ...options, project: 'Town hall', sheetDate: '2026-11-23' };
  const text = writeIfc({ name, plan, options: given });
  expect(text).toContain("'2026-11-23T00:00:00'");
  expect((await IfcReader.open(text)).lines(webIfc.IFCPROJECT)[0].Name.value).toBe('Town hall');
  // Only an ISO date can stand there.
  expect(writeIfc({ name, plan, options: { ...options, sheetDate: 'May' } })).toContain(
    "'1970-01-01T00:00:00'",
  );
});
