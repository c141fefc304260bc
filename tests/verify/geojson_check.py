"""Checks GeoJSON files of plans with shapely, and those on WGS 84 with pyproj where it is there.

    python tests/verify/geojson_check.py DIR|FILE

Each folder holds plan.geojson and, where the scan told its coordinate system, plan.wgs84.geojson. One line a check; ends
with 1 where one failed.
"""

import json
import sys
from pathlib import Path

from shapely.geometry import shape
from shapely.validation import explain_validity

try:
    import pyproj
except ImportError:
    pyproj = None

# Areas are of the plan, vertices rounded to 0.1 mm: so much a metre of outline, m².
AREA_PER_METRE = 1e-4
# What a place may be off by on its way there and back, m.
WGS84_ERROR = 1e-4

failures = 0


def check(name, is_right, words):
    global failures
    failures += not is_right
    print(f"{'ok' if is_right else 'FAILED'}  {name}: {words}")


def polygons(collection):
    return [f for f in collection["features"] if f["geometry"]["type"] == "Polygon"]


def is_turned_right(feature):
    polygon = shape(feature["geometry"])
    return polygon.exterior.is_ccw and not any(ring.is_ccw for ring in polygon.interiors)


def check_shapes(name, collection):
    bad = []
    for feature in collection["features"]:
        geometry = shape(feature["geometry"])
        if not geometry.is_valid or geometry.is_empty:
            bad.append(explain_validity(geometry))
    check(name, not bad, f"{len(collection['features'])} features valid" if not bad else "; ".join(bad[:3]))
    areas = polygons(collection)
    wrong = [feature["properties"]["kind"] for feature in areas if not is_turned_right(feature)]
    check(name, not wrong, f"{len(areas)} polygons by the right-hand rule, {len(wrong)} not")


def check_areas(name, collection):
    metres = collection["frame"]["metresPerUnit"]
    worst = 0
    count = 0
    for feature in polygons(collection):
        told = feature["properties"].get("areaM2")
        if told is None:
            continue
        polygon = shape(feature["geometry"])
        error = abs(polygon.area * metres**2 - told)
        worst = max(worst, error / max(1, polygon.length * metres))
        count += 1
    check(name, worst <= AREA_PER_METRE, f"{count} areas as told, worst {worst:.1e} m² a metre of outline")


def check_wgs84(name, plain, wgs84):
    check(name, "crs" not in wgs84, "no member crs")
    flat = [position for f in wgs84["features"] for position in positions(f)]
    lon, lat = [p[0] for p in flat], [p[1] for p in flat]
    check(name, [min(lon), min(lat), max(lon), max(lat)] == wgs84.get("bbox"), f"box {wgs84.get('bbox')}")
    same = [f["properties"]["kind"] for f in plain["features"]] == [f["properties"]["kind"] for f in wgs84["features"]]
    check(name, same, f"the features of plan.geojson, {len(wgs84['features'])}")
    crs = plain["frame"].get("crs")
    if pyproj is None or not same:
        print(f"skip  {name}: {'pyproj is not installed' if same else 'nothing to compare'}")
        return
    # By the same change of datum as the file: none where the datum is as good as WGS 84.
    source = pyproj.CRS(crs)
    if abs(source.ellipsoid.inverse_flattening - 298.257) > 0.001:
        print(f"skip  {name}: the change of datum of {crs} is chosen by each program")
        return
    geodetic = source.geodetic_crs
    back = pyproj.Transformer.from_crs(geodetic, source, always_xy=True)
    unit = source.axis_info[0].unit_conversion_factor
    worst = 0
    for a, b in zip(plain["features"], wgs84["features"]):
        there = [back.transform(*p) for p in positions(b)]
        worst = max(worst, hausdorff(positions(a), there) * unit)
    check(name, worst <= WGS84_ERROR, f"back in {source.name} within {1000 * worst:.3f} mm")


def hausdorff(first, second):
    """Greatest distance of a vertex of one to the nearest of the other: rounding may drop one of two that meet."""
    nearest = lambda p, others: min(((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2) ** 0.5 for q in others)
    return max(max(nearest(p, second) for p in first), max(nearest(p, first) for p in second))


def positions(feature):
    coordinates = feature["geometry"]["coordinates"]
    return coordinates if feature["geometry"]["type"] == "LineString" else [p for ring in coordinates for p in ring]


def main(folders):
    for folder in folders:
        plain = Path(folder) / "plan.geojson"
        wgs84 = Path(folder) / "plan.wgs84.geojson"
        if not plain.exists():
            check(str(plain), False, "is not there")
            continue
        collection = json.loads(plain.read_text("utf-8"))
        check_shapes(str(plain), collection)
        check_areas(str(plain), collection)
        if wgs84.exists():
            other = json.loads(wgs84.read_text("utf-8"))
            check_shapes(str(wgs84), other)
            check_wgs84(str(wgs84), collection, other)
    sys.exit(1 if failures else 0)


main([path.parent if path.is_file() else path for path in map(Path, sys.argv[1:2])])
