"""Ten modes of a square plate, side 1, thickness .01, supported on all edges, which turn about themselves alone; bending alone.

    python opensees_plate.py ELEMENTS

ShellMITC4 on ELEMENTS x ELEMENTS squares, the plate of scenes/plate.toml. Prints one line of JSON: circular frequencies, seconds by the
clock and by the processor, from the first node to the last frequency (Python's own start is not counted).
"""

import json
import math
import sys
from time import perf_counter, process_time

import openseespy.opensees as ops

n = int(sys.argv[1])
wall, processor = perf_counter(), process_time()
ops.wipe()
ops.model("basic", "-ndm", 3, "-ndf", 6)
for j in range(n + 1):
    for i in range(n + 1):
        node = 1 + i + (n + 1) * j
        ops.node(node, i / n, j / n, 0.0)
        u, v = i in (0, n), j in (0, n)
        # On sides along y nothing turns about x, on those along x nothing about y; nowhere about z.
        ops.fix(node, 1, 1, int(u or v), int(u), int(v), 1)
ops.section("ElasticMembranePlateSection", 1, 1.092e7, 0.3, 0.01, 100.0)
for j in range(n):
    for i in range(n):
        a = 1 + i + (n + 1) * j
        ops.element("ShellMITC4", 1 + i + n * j, a, a + 1, a + n + 2, a + n + 1, 1)
ops.system("UmfPack")
answers = [math.sqrt(value) for value in ops.eigen("-genBandArpack", 10)]
wall, processor = perf_counter() - wall, process_time() - processor
print(json.dumps({"answers": answers, "cost": wall, "processor": processor}))
