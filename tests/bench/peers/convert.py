"""IN.ply OUT.laz|OUT.e57: the points of a binary PLY of float x, y, z as a file that independent software wrote."""
import sys
import numpy as np

source, target = sys.argv[1:3]
with open(source, "rb") as file:
    while file.readline().strip() != b"end_header":
        pass
    xyz = np.fromfile(file, "<f4").reshape(-1, 3).astype(float)

if target.endswith(".laz"):
    import laspy

    header = laspy.LasHeader(point_format=2, version="1.2")
    header.scales = [0.0001] * 3
    las = laspy.LasData(header)
    las.x, las.y, las.z = xyz.T
    las.intensity = (1000 + 200 * np.sin(3 * xyz[:, 0])).astype(np.uint16)
    las.red, las.green, las.blue = (128 + 60 * np.sin(xyz.T)).astype(np.uint16) * 256
    las.write(target)
else:
    import pye57

    names = ["cartesianX", "cartesianY", "cartesianZ"]
    data = {name: np.ascontiguousarray(column) for name, column in zip(names, xyz.T)}
    data["intensity"] = (0.5 + 0.2 * np.sin(3 * xyz[:, 0])).astype(np.float32)
    pye57.E57(target, mode="w").write_scan_raw(data)
