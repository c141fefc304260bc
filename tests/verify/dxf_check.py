"""Checks a plan.dxf against its plan.json by others' software: ezdxf reads it, shapely looks at the geometry.

    python dxf_check.py plan.dxf plan.json STOREY

Prints a line a check, `ok` or `FAILED` first, and ends with 1 where one failed.
"""

import json
import math
import sys

import ezdxf
from ezdxf import audit, disassemble
from shapely.geometry import Point, Polygon

AREA_SHARE = 1e-3
# m2
NO_AREA = 1e-6
# Chords that a bulge is taken apart into leave it by no more than this share of a metre.
SAGITTA = 1e-4
# Names of layers by both standards.
ROOM = ("A-AREA", "A-SPACE-E-E")
VOID = ("A-AREA-VOID", "A-VOID--E-E")
LABEL = ("A-AREA-IDEN", "A-SPACE-T-E")


def ring_of(polyline, metres):
    """Vertices of a polyline with its bulges taken apart."""
    path = ezdxf.path.make_path(polyline)
    return [(v.x, v.y) for v in path.flattening(SAGITTA / metres)]


def area_of(outline):
    """Of a polygon of plan.json, its arcs as such: segments beyond the chords are added."""
    rings = [outline["outer"], *outline["holes"]]
    total = 0.0
    for k, xy in enumerate(rings):
        signed = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(xy, xy[1:] + xy[:1])) / 2
        for arc in outline.get("arcs", []):
            if arc["ring"] == k:
                signed += beyond_chords(xy, arc)
        total += abs(signed) if k == 0 else -abs(signed)
    return total


def beyond_chords(xy, arc):
    (cx, cy), n, i, total = arc["centre"], len(xy), arc["from"], 0.0
    while True:
        (ax, ay), (bx, by) = ((x - cx, y - cy) for x, y in (xy[i], xy[(i + 1) % n]))
        turn = math.atan2(ax * by - ay * bx, ax * bx + ay * by)
        total += arc["radius"] ** 2 * (turn - math.sin(turn)) / 2
        i = (i + 1) % n
        if i == arc["to"]:
            return total


def heights(entity):
    """Every z of an entity."""
    if entity.dxftype() == "LWPOLYLINE":
        return [entity.dxf.elevation]
    if entity.dxftype() == "HATCH":
        return [entity.dxf.elevation.z]
    return [value.z for value in entity.dxfattribs().values() if hasattr(value, "z") and value.z != 1]


class Checks:
    def __init__(self):
        self.failed = 0

    def say(self, name, is_good, found):
        self.failed += not is_good
        print(f"{'ok' if is_good else 'FAILED'}  {name}: {found}")


def main(dxf, plan_json, storey):
    with open(plan_json, encoding="utf-8") as file:
        plan = json.load(file)
    plan = plan.get("plan", plan)
    floor = plan["storeys"][storey]
    metres = plan["frame"]["metresPerUnit"]
    checks = Checks()

    document = ezdxf.readfile(dxf)
    auditor = document.audit()
    trouble = [*auditor.errors, *auditor.fixes]
    checks.say("ezdxf audit", not trouble, f"{len(auditor.errors)} errors, {len(auditor.fixes)} fixes"
               + "".join(f"; {each.message}" for each in trouble[:3]))

    space = document.modelspace()
    on = lambda kind, layers: [e for e in space.query(kind) if e.dxf.layer in layers]
    polylines = on("LWPOLYLINE", ROOM)
    voids = [Polygon(ring_of(each, metres)) for each in on("LWPOLYLINE", VOID)]
    rooms = []
    for each in polylines:
        shell = Polygon(ring_of(each, metres))
        rooms.append(Polygon(shell.exterior, [v.exterior for v in voids if shell.contains(v)]))
    checks.say("rooms closed", all(p.closed for p in polylines), f"{len(polylines)} polylines")
    checks.say("rooms valid", all(r.is_valid for r in rooms), f"{sum(r.is_valid for r in rooms)} by shapely")

    # What rounding leaves no area of is in no drawing.
    wanted = sorted(a for a in (area_of(room["outline"]) for room in floor["rooms"]) if a > NO_AREA)
    found = sorted(room.area * metres**2 for room in rooms)
    off = max((abs(a - b) / max(a, 1e-9) for a, b in zip(wanted, found)), default=0)
    checks.say("room areas", len(wanted) == len(found) and off <= AREA_SHARE,
               f"{len(found)} of {len(wanted)}, {sum(found):.3f} m2, off by {off:.1e} at most")

    places = [Point(t.dxf.insert.x, t.dxf.insert.y) for t in on("MTEXT TEXT", LABEL)]
    counts = [sum(room.contains(place) for place in places) for room in rooms]
    checks.say("a text in each room", all(c == 1 for c in counts) and (not rooms or len(places) == len(rooms)),
               f"{counts.count(1)} of {len(rooms)}")

    entities = [*space, *(e for block in document.blocks for e in block)]
    raised = [e for e in entities if any(z != 0 for z in heights(e))]
    checks.say("z is 0", not raised, f"{len(entities)} entities, {len(raised)} off it")

    openings = [o for o in floor["openings"] if o["from"] != o["to"]]
    inserts = [(i.dxf.name.lower(), i.dxf.xscale * metres) for i in space.query("INSERT")]
    expected = sorted((o["type"], math.dist(o["from"], o["to"])) for o in openings)
    same = len(inserts) == len(expected) and all(
        a[0] == b[0] and abs(a[1] - b[1]) < 2e-4 for a, b in zip(sorted(inserts), expected))
    checks.say("openings are blocks", same, f"{len(inserts)} of {len(expected)}")

    dimensions = list(space.query("DIMENSION"))
    worst = 0.0
    for each in dimensions:
        a, b, angle = each.dxf.defpoint2, each.dxf.defpoint3, math.radians(each.dxf.angle)
        along = abs((b.x - a.x) * math.cos(angle) + (b.y - a.y) * math.sin(angle))
        worst = max(worst, abs(along - each.dxf.actual_measurement) * metres)
    checks.say("dimensions measure", worst < 2e-4, f"{len(dimensions)}, off by {worst * 1000:.2f} mm at most")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3])))
