"""`geos|cpp FILE LENGTH`: a peer's concave hull of raw float32 points, timed; prints what hull-child.ts prints."""

import json
import resource
import sys
import time

import numpy as np

RUNS = 15
ENOUGH_S = 3
# Longest edge as a share of the longest Delaunay edge: about 0.3 m in the bench's flat.
GEOS_RATIO = 0.03


def geos(xy):
    import shapely

    points = shapely.multipoints(xy)
    return lambda: shapely.get_coordinates(shapely.concave_hull(points, ratio=GEOS_RATIO))


def cpp(xy):
    from concave_hull import concave_hull_indexes

    return lambda: xy[concave_hull_indexes(xy, concavity=2.0)]


method, path, _ = sys.argv[1:]
run = {"geos": geos, "cpp": cpp}[method](np.fromfile(path, "<f4").reshape(-1, 2).astype(np.float64))
times = []
used = []
while len(times) < RUNS and sum(times) < ENOUGH_S:
    start = time.perf_counter()
    start_used = time.process_time()
    ring = run()
    used.append(time.process_time() - start_used)
    times.append(time.perf_counter() - start)
peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
result = {
    "firstMs": times[0] * 1000,
    "ms": min(times) * 1000,
    "cpuMs": min(used) * 1000,
    "peakMB": peak,
    "ring": ring.ravel().tolist(),
}
print(json.dumps(result))
