"""Checks a plan.ifc against the plan.json it was written with: schema and rules, areas, volumes, place.

    python ifc_check.py plan.ifc plan.json

Needs ifcopenshell and shapely; with pytest installed ifcopenshell checks the schema's where rules too. One line a check;
exits 1 where one failed. What is expected is computed here from the plan alone, by other libraries than the writer's.
"""

import json
import logging
import math
import sys
from collections import Counter

import ifcopenshell
import ifcopenshell.geom
import ifcopenshell.util.element
import ifcopenshell.util.placement
import ifcopenshell.validate
from shapely import make_valid
from shapely.geometry import Polygon
from shapely.ops import unary_union

# Areas and volumes agree to this share of themselves, or to what 10 µm of rounding along an edge makes of the smallest.
SHARE = 1e-3
LEAST = 1e-5
# Lengths and places, m.
PLACE = 1e-4
FEET = {'ft', 'us-ft'}

failures = 0


def check(name, problems, said):
    global failures
    failures += bool(problems)
    print(f"{'FAILED' if problems else 'ok':6} {name}: {said}" + ''.join(f'\n         {p}' for p in problems[:5]))


def shape(polygon):
    return make_valid(Polygon(polygon['outer'], polygon['holes']))


def near(found, expected):
    return abs(found - expected) <= max(SHARE * abs(expected), LEAST)


def compare(name, pairs):
    """pairs: what, found, expected"""
    bad = [f'{what}: expected {e:.6f}, found {f:.6f}' for what, f, e in pairs if not near(f, e)]
    worst = max((abs(f - e) / e for _, f, e in pairs if e > LEAST / SHARE), default=0)
    check(name, bad, f'{len(pairs)} compared, worst {100 * worst:.4f} %')


class Collected(logging.Handler):
    def __init__(self):
        super().__init__()
        self.said = []

    def emit(self, record):
        if record.levelno >= logging.WARNING:
            self.said.append(str(record.getMessage()).replace('\n', ' ')[:300])


def check_schema(path):
    logger, collected = logging.Logger('ifc'), Collected()
    logger.addHandler(collected)
    try:
        import _pytest.assertion  # noqa: F401  ifcopenshell's rules are run by it

        rules = True
    except ImportError:
        rules = False
    ifcopenshell.validate.validate(path, logger, express_rules=rules)
    check('schema', collected.said, 'IFC4 with its rules' if rules else 'IFC4 without its rules (no pytest)')


def quantities(thing, name):
    return ifcopenshell.util.element.get_psets(thing, qtos_only=True).get(name, {})


class Bodies:
    """Volumes of bodies, openings cut, by the geometry engine; what is no closed two-manifold is collected."""

    def __init__(self):
        self.settings = ifcopenshell.geom.settings()
        self.open = []
        self.count = 0

    def volume(self, thing):
        if thing.Representation is None:
            return 0.0
        body = ifcopenshell.geom.create_shape(self.settings, thing).geometry
        # Corners one to 1 µm are one.
        corners = [tuple(round(v, 6) for v in body.verts[i : i + 3]) for i in range(0, len(body.verts), 3)]
        faces = [body.faces[i : i + 3] for i in range(0, len(body.faces), 3)]
        edges = Counter()
        total = 0.0
        for face in faces:
            a, b, c = (corners[i] for i in face)
            edges.update([(a, b), (b, c), (c, a)])
            total += (
                a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0])
            ) / 6
        self.count += 1
        if not faces or any(n != edges[(b, a)] for (a, b), n in edges.items() if a != b):
            self.open.append(f'{thing.is_a()} {thing.Name}')
        return total


def strip(opening, low, high, inset=0.0):
    (ax, ay), (bx, by) = opening['from'], opening['to']
    length = math.hypot(bx - ax, by - ay)
    ux, uy = (bx - ax) / length, (by - ay) / length
    ax, ay, bx, by = ax + inset * ux, ay + inset * uy, bx - inset * ux, by - inset * uy
    at = lambda x, y, d: (x - d * uy, y + d * ux)  # noqa: E731
    return Polygon([at(ax, ay, low), at(bx, by, low), at(bx, by, high), at(ax, ay, high)])


def hole(opening, walls):
    """The rectangle an opening takes out of the walls on its axis, as deep as they are there, 1 mm deeper to cut flush.

    How deep is looked for off the jambs first, since walls behind a corner may touch them. None off every wall.
    """
    length = math.dist(opening['from'], opening['to'])
    if length == 0 or opening['head'] <= opening['sill']:
        return None
    reach = max((t for _, t in walls), default=0) / 2 + 0.25
    own = depth(opening, walls, (-reach, reach), min(0.01, length / 4))
    if own is None:
        return None
    low, high = depth(opening, walls, (own[0] - 0.01, own[1] + 0.01), 0)
    return strip(opening, low - 1e-3, high + 1e-3)


def depth(opening, walls, within, inset):
    (ax, ay), (bx, by) = opening['from'], opening['to']
    length = math.dist(opening['from'], opening['to'])
    ux, uy = (bx - ax) / length, (by - ay) / length
    looked = strip(opening, *within, inset)
    axis = strip(opening, -1e-3, 1e-3, inset)
    wall = unary_union([w for w, _ in walls if w.intersects(looked)]).intersection(looked)
    parts = [p for p in getattr(wall, 'geoms', [wall]) if p.intersection(axis).area > 1e-9]
    aside = [(y - ay) * ux - (x - ax) * uy for p in parts for x, y in p.exterior.coords]
    return (min(aside), max(aside)) if aside else None


def is_in_way(wall, box):
    """Whether more of a wall than 1 cm² is in an opening's way; what its box only touches stays whole."""
    return wall.intersection(box.buffer(-3e-3, join_style=2)).area > 1e-4


def by_name(things):
    return {thing.Name: thing for thing in things}


def elements(storey):
    return [e for rel in storey.ContainsElements for e in rel.RelatedElements]


def spaces(storey):
    return [s for rel in storey.IsDecomposedBy for s in rel.RelatedObjects]


def check_spaces(ifc_storey, storey, bodies):
    found = spaces(ifc_storey)
    rooms = storey['rooms']
    wrong = [] if len(found) == len(rooms) else [f'expected {len(rooms)}, found {len(found)}']
    names = [f'{s.LongName!r:.60} for {r["name"]!r:.60}' for s, r in zip(found, rooms) if not same_name(s, r['name'])]
    check(f'{ifc_storey.Name}, spaces', wrong + names, f'{len(found)}, names as the rooms')
    areas, volumes = [], []
    structures = unary_union([shape(s['outline']) for s in storey['secondary']])
    for space, room in zip(found, rooms):
        outline = shape(room['outline'])
        within = structures.intersection(Polygon(room['outline']['outer']).buffer(0))
        q = quantities(space, 'Qto_SpaceBaseQuantities')
        what = f'{room["name"]:.60}'
        areas.append((f'{what} gross', q.get('GrossFloorArea', -1), outline.union(within).area))
        areas.append((f'{what} net', q.get('NetFloorArea', -1), outline.difference(within).area))
        volumes.append((what, bodies.volume(space), outline.area * max(0, room['height'])))
    compare(f'{ifc_storey.Name}, areas of spaces', areas)
    compare(f'{ifc_storey.Name}, volumes of spaces', volumes)


def same_name(thing, name):
    return thing.LongName == clean(name) or (len(name) > 255 and thing.Description == clean(name))


def clean(name):
    return ''.join(' ' if ord(c) < 32 or 127 <= ord(c) < 160 else c for c in name)


def check_walls(ifc_storey, storey, bodies):
    found = by_name(e for e in elements(ifc_storey) if e.is_a('IfcWall'))
    cut = unary_union([shape(s['outline']) for s in storey['secondary'] if s['operation'] != 'independent'])
    whole = [(shape(w['outline']), w['thickness']) for w in storey['walls']]
    holes = [(o, hole(o, whole)) for o in storey['openings']]
    feet, gross, net, measured, missing = [], [], [], [], []
    for i, (outline, _) in enumerate(whole):
        foot = outline.difference(cut)
        name = f'Wall {i + 1}'
        if name not in found:
            if foot.area > LEAST:
                missing.append(name)
            continue
        q = quantities(found[name], 'Qto_WallBaseQuantities')
        feet.append((name, q['GrossFootprintArea'], foot.area))
        gross.append((name, q['GrossVolume'], foot.area * storey['height']))
        left = net_volume(foot, holes, storey['height'])
        net.append((name, q['NetVolume'], left))
        measured.append((name, bodies.volume(found[name]), left))
    check(f'{ifc_storey.Name}, walls', missing, f'{len(found)} of {len(whole)}')
    compare(f'{ifc_storey.Name}, feet of walls', feet)
    compare(f'{ifc_storey.Name}, gross volumes of walls', gross)
    compare(f'{ifc_storey.Name}, net volumes of walls as said', net)
    compare(f'{ifc_storey.Name}, volumes of walls, openings cut', measured)


def net_volume(foot, holes, height):
    boxes = [(o, h) for o, h in holes if h is not None and is_in_way(foot, h)]
    levels = sorted({0, height, *(min(height, max(0, o[k])) for o, _ in boxes for k in ('sill', 'head'))})
    total = 0.0
    for low, high in zip(levels, levels[1:]):
        open_ = unary_union([h for o, h in boxes if o['sill'] < (low + high) / 2 < o['head']])
        total += foot.difference(open_).area * (high - low)
    return total


def check_slabs(ifc_storey, storey, options, bodies):
    slabs = [e for e in elements(ifc_storey) if e.is_a('IfcSlab')]
    outlines = [*storey['primary'], *(r['outline'] for r in storey['rooms']), *(w['outline'] for w in storey['walls'])]
    # Walls stand a hairline apart where they were rounded; slabs go on under it.
    covered = unary_union([shape(p) for p in outlines]).buffer(1e-4, join_style=2).buffer(-1e-4, join_style=2)
    away = [s['outline'] for s in storey['secondary'] if s['type'] != 'column' and s['operation'] == 'subtract']
    area = covered.difference(unary_union([shape(p) for p in away])).area
    layers = (options['floorSlab'] + options['ceilingSlab']) * (options['slabThickness'] > 0)
    said = sum(quantities(s, 'Qto_SlabBaseQuantities')['NetArea'] for s in slabs)
    volume = sum(bodies.volume(s) for s in slabs)
    compare(
        f'{ifc_storey.Name}, slabs',
        [('area', said, layers * area), ('volume', volume, layers * area * options['slabThickness'])],
    )


def check_rest(ifc_storey, storey, bodies):
    here = Counter(e.is_a() for e in elements(ifc_storey))
    expected = Counter(
        {'door': 'IfcDoor', 'window': 'IfcWindow', 'passage': None}[o['type']]
        for o in storey['openings']
        if o['from'] != o['to'] and o['head'] > o['sill']
    )
    secondary = [s for s in storey['secondary'] if shape(s['outline']).area > LEAST]
    expected.update('IfcColumn' if s['type'] == 'column' else 'IfcBuildingElementProxy' for s in secondary)
    kinds = ('IfcDoor', 'IfcWindow', 'IfcColumn', 'IfcBuildingElementProxy')
    bad = [f'{k}: expected {expected[k]}, found {here[k]}' for k in kinds if here[k] != expected[k]]
    check(f'{ifc_storey.Name}, elements', bad, ', '.join(f'{here[k]} {k}' for k in kinds))
    for e in elements(ifc_storey):
        if e.is_a() in kinds:
            bodies.volume(e)
    columns = [e for e in elements(ifc_storey) if e.is_a('IfcColumn')]
    outlines = [s['outline'] for s in secondary if s['type'] == 'column']
    if len(columns) == len(outlines):
        pairs = [(c.Name, bodies.volume(c), shape(o).area * storey['height']) for c, o in zip(columns, outlines)]
        compare(f'{ifc_storey.Name}, volumes of columns', pairs)


def check_fillings(model):
    """Doors and windows lie in the openings they fill."""
    settings = ifcopenshell.geom.settings()
    settings.set('use-world-coords', True)

    def box(thing):
        verts = ifcopenshell.geom.create_shape(settings, thing).geometry.verts
        return [f(verts[axis::3]) for f in (min, max) for axis in range(3)]

    out = []
    fills = model.by_type('IfcRelFillsElement')
    for rel in fills:
        hole, filling = box(rel.RelatingOpeningElement), box(rel.RelatedBuildingElement)
        within = [h - PLACE <= f for h, f in zip(hole[:3], filling[:3])]
        within += [f <= h + PLACE for h, f in zip(hole[3:], filling[3:])]
        if not all(within):
            out.append(f'{rel.RelatedBuildingElement.Name}: {filling} out of {hole}')
    check('fillings', out, f'{len(fills)} doors and windows in their openings')


def check_place(model, plan):
    """A corner of each storey, taken through placements and map conversion, against the source's coordinates."""
    frame = plan['frame']
    conversions = model.by_type('IfcMapConversion')
    metres = frame['metresPerUnit']
    bad = []
    for found, storey in zip(model.by_type('IfcBuildingStorey'), plan['storeys']):
        x, y, z = (float(v) for v in ifcopenshell.util.placement.get_local_placement(found.ObjectPlacement)[:3, 3])
        expected = [frame['planOrigin'][0] * metres, frame['planOrigin'][1] * metres, frame['planOrigin'][2] * metres]
        expected[2] += storey['floor']
        if conversions:
            c = conversions[0]
            unit = metres if frame['unit'] in FEET else 1
            x, y, z = ((c.Eastings + x * c.Scale) * unit, (c.Northings + y * c.Scale) * unit,
                       (c.OrthogonalHeight + z * c.Scale) * unit)
        elif max(abs(v) for v in frame['planOrigin']) * metres > 1000:
            expected = [0, 0, storey['floor']]
        off = max(abs(a - b) for a, b in zip((x, y, z), expected))
        if off > PLACE:
            bad.append(f'{found.Name}: expected {expected}, found {(x, y, z)}')
    source = ifcopenshell.util.element.get_psets(model.by_type('IfcSite')[0]).get('Grundriss_Source', {})
    if [source.get(f'Origin{axis}') for axis in 'XYZ'] != [float(v) for v in frame['planOrigin']]:
        bad.append(f'origin said: {source}')
    crs = f' in {conversions[0].TargetCRS.Name}' if conversions else ''
    check('place', bad, f'storeys where the source has them{crs}')


def main(ifc_path, plan_path):
    with open(plan_path, encoding='utf8') as file:
        plan = json.load(file)
    check_schema(ifc_path)
    model = ifcopenshell.open(ifc_path)
    storeys = model.by_type('IfcBuildingStorey')
    wrong = [] if len(storeys) == len(plan['storeys']) else [f'expected {len(plan["storeys"])}']
    check('storeys', wrong, f'{len(storeys)}')
    check_place(model, plan)
    bodies = Bodies()
    for ifc_storey, storey in zip(storeys, plan['storeys']):
        check_spaces(ifc_storey, storey, bodies)
        check_walls(ifc_storey, storey, bodies)
        check_slabs(ifc_storey, storey, plan['options'], bodies)
        check_rest(ifc_storey, storey, bodies)
    check_fillings(model)
    check('closed', bodies.open, f'{bodies.count} bodies are closed two-manifolds')
    return 1 if failures else 0


if __name__ == '__main__':
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2]))
