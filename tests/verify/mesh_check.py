"""mesh_check.py FILE.glb plan.json: what trimesh says of the GLB and of the plan.obj, plan.ply and plan.stl beside it.

Every part must be closed and of positive volume, the volumes of all formats equal within 0.1 %, and walls and slabs as
large as shapely works out from plan.json. One line a check; exit code 1 where one fails.
"""

import json
import math
import re
import sys
from pathlib import Path

import numpy as np
import shapely
import trimesh

EQUAL = 1e-3
MILLIMETRES = 1e-9
failures = 0

# Meshes by the name of their node.
Parts = dict[str, list[trimesh.Trimesh]]


def check(what: str, is_fine: bool, facts: str = "") -> None:
    global failures
    failures += not is_fine
    print(f"{'ok' if is_fine else 'FAILED'}  {what}{': ' + facts if facts else ''}")


def check_equal(what: str, found: float, expected: float) -> None:
    off = abs(found - expected) / expected if expected else abs(found)
    check(what, off <= EQUAL, f"{found:.4f} m³, expected {expected:.4f} m³ ({100 * off:.4f} %)")


def closed(mesh: trimesh.Trimesh) -> bool:
    """Every directed edge has its partner: also where shells that touch were merged."""
    edges = mesh.edges
    there, back = [sorted(map(tuple, side)) for side in (edges, edges[:, ::-1])]
    return there == back


def volume(mesh: trimesh.Trimesh) -> float:
    """About the mesh's own corner: at UTM coordinates the tetrahedra would eat the digits."""
    near = mesh.copy()
    near.apply_translation(-mesh.bounds[0])
    return near.volume


def polygon(outline: dict) -> shapely.Polygon:
    return shapely.Polygon(outline["outer"], outline["holes"])


def across(opening: dict, low: float, high: float) -> shapely.Polygon:
    """The rectangle along an opening between two distances to the left of its axis."""
    (ax, ay), (bx, by) = opening["from"], opening["to"]
    length = math.hypot(bx - ax, by - ay)
    nx, ny = (ay - by) / length, (bx - ax) / length
    corners = [(ax, ay, low), (bx, by, low), (bx, by, high), (ax, ay, high)]
    return shapely.Polygon([(x + d * nx, y + d * ny) for x, y, d in corners])


def hole(opening: dict, walls: shapely.Geometry, reach: float) -> shapely.Geometry:
    """What the opening takes out of the wall it is in."""
    (ax, ay), (bx, by) = opening["from"], opening["to"]
    length = math.hypot(bx - ax, by - ay)
    if length == 0:
        return shapely.Polygon()
    inset = min(0.01, length / 4) / length
    ends = [(ax + s * (bx - ax), ay + s * (by - ay)) for s in (inset, 1 - inset)]
    inner = {"from": ends[0], "to": ends[1]}
    axis = across(inner, -1e-3, 1e-3)
    pieces = shapely.get_parts(walls.intersection(across(inner, -reach, reach)))
    own = [piece for piece in pieces if piece.intersects(axis)]
    if not own:
        return shapely.Polygon()
    nx, ny = (ay - by) / length, (bx - ax) / length
    depths = [(x - ax) * nx + (y - ay) * ny for x, y in shapely.get_coordinates(own)]
    return across(opening, min(depths) - 1e-3, max(depths) + 1e-3)


def changed(area: shapely.Geometry, storey: dict) -> shapely.Geometry:
    for structure in storey["secondary"]:
        outline = polygon(structure["outline"])
        if structure["operation"] == "subtract":
            area = area.difference(outline)
        if structure["operation"] == "add":
            area = area.union(outline)
    return area


def wall_volume(storey: dict) -> float:
    walls = shapely.union_all([polygon(wall["outline"]) for wall in storey["walls"]])
    reach = max([wall["thickness"] for wall in storey["walls"]], default=0) / 2 + 0.25
    added = [polygon(s["outline"]) for s in storey["secondary"] if s["operation"] == "add"]
    holes = [(o, hole(o, walls, reach)) for o in storey["openings"]]
    whole = changed(walls, storey)
    height = storey["height"]
    levels = sorted({0, height, *(min(max(o[k], 0), height) for o, _ in holes for k in ("sill", "head"))})
    total = 0.0
    for low, high in zip(levels, levels[1:]):
        open_here = [h for o, h in holes if o["sill"] < (low + high) / 2 < o["head"]]
        cut = shapely.union_all(open_here).difference(shapely.union_all(added))
        total += whole.difference(cut).area * (high - low)
    return total


def slab_volume(storey: dict, thickness: float) -> float:
    outlines = [wall["outline"] for wall in storey["walls"]] + [room["outline"] for room in storey["rooms"]]
    area = shapely.union_all([polygon(outline) for outline in outlines + storey["primary"]])
    return changed(area, storey).area * thickness


def parts_of_glb(path: Path) -> Parts:
    scene = trimesh.load_scene(path)
    parts: Parts = {}
    for node in scene.graph.nodes_geometry:
        mesh = scene.geometry[scene.graph[node][1]].copy()
        if isinstance(mesh, trimesh.Trimesh):
            mesh.merge_vertices(merge_norm=True, merge_tex=True)
            # Where a node has several materials, trimesh makes a node of each and adds to the name.
            name = re.match(r"[a-z]+-\d+", node)
            parts.setdefault(name.group() if name else node, []).append(mesh)
    return parts


def check_glb(parts: Parts, plan: dict) -> float:
    """Volume of all parts, m³."""
    volumes: dict[str, float] = {}
    open_parts = [name for name, meshes in parts.items() if not all(m.is_watertight for m in meshes)]
    hollow = [name for name, meshes in parts.items() if not all(m.volume > 0 for m in meshes)]
    check("plan.glb: every part watertight", not open_parts, ", ".join(open_parts) or f"{len(parts)} parts")
    check("plan.glb: every part of positive volume", not hollow, ", ".join(hollow))
    for name, meshes in parts.items():
        kind = name.split("-")[0]
        volumes[kind] = volumes.get(kind, 0) + sum(mesh.volume for mesh in meshes)
    options = plan["options"]
    check_equal("plan.glb: walls", volumes.get("wall", 0), sum(map(wall_volume, plan["storeys"])))
    check_equal("plan.glb: columns", volumes.get("column", 0), column_volume(plan))
    for kind in ("floor", "ceiling"):
        if options[f"{kind}Slab"]:
            expected = sum(slab_volume(storey, options["slabThickness"]) for storey in plan["storeys"])
            check_equal(f"plan.glb: {kind}", volumes.get(kind, 0), expected)
    return sum(volumes.values())


def filled(parts: Parts) -> float:
    """Frames and panes: parts of the model that are none of the print's, m³."""
    return sum(m.volume for name, meshes in parts.items() if name.startswith(("door-", "window-")) for m in meshes)


def column_volume(plan: dict) -> float:
    """Columns as high as their storey; those cut out of the slabs go through them."""
    options = plan["options"]
    slabs = (options["floorSlab"] + options["ceilingSlab"]) * options["slabThickness"]
    return sum(
        polygon(s["outline"]).area * (storey["height"] + (slabs if s["operation"] == "subtract" else 0))
        for storey in plan["storeys"]
        for s in storey["secondary"]
        if s["operation"] != "add" and s["type"] == "column"
    )


def main() -> None:
    glb = Path(sys.argv[1])
    folder = glb.parent
    plan = json.loads(Path(sys.argv[2]).read_text(encoding="utf-8"))
    parts = parts_of_glb(glb)
    whole = check_glb(parts, plan)
    scale = plan["frame"]["metresPerUnit"]
    origin = np.array(plan["frame"]["planOrigin"])
    places = np.vstack([m.bounds for ms in parts.values() for m in ms])
    # From glTF's axes, y up, to the plan's.
    corner = np.array([places[:, 0].min(), -places[:, 2].max(), places[:, 1].min()])
    for name in ("plan.obj", "plan.ply"):
        path = folder / name
        if not path.exists():
            continue
        mesh = trimesh.load_mesh(path, process=False)
        starts = {"plan.obj": b"o ", "plan.ply": b"comment part "}[name]
        lines = [line for line in path.read_bytes().split(b"\n") if line.startswith(starts)]
        named = {line.split(b" ")[-1].decode() for line in lines}
        check(f"{name}: the parts of plan.glb by name", named == set(parts), f"{len(named)} parts")
        check(f"{name}: closed", closed(mesh), f"{len(mesh.faces)} triangles")
        check_equal(f"{name}: volume", volume(mesh) * scale**3, whole)
        off = np.abs((mesh.bounds[0] - origin) * scale - corner).max()
        check(f"{name}: at its source coordinates", off < 3e-4, f"{off:.6f} m off")
    path = folder / "plan.stl"
    if path.exists():
        mesh = trimesh.load_mesh(path)
        check("plan.stl: closed", closed(mesh), f"{len(mesh.faces)} triangles")
        check_equal("plan.stl: volume", volume(mesh) * MILLIMETRES, whole - filled(parts))


main()
sys.exit(1 if failures else 0)
