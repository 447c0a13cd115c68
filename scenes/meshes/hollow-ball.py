#!/usr/bin/env python3
"""Writes hollow-ball.obj: the surface of an eighth of a thick hollow ball, radii 50 and 100, in the groups `cavity`, `outside` and `cuts`.

A face of an octahedron is divided n times along each edge and its vertices put on the ball, a little farther out than its radius, so that the
triangles enclose the volume of the true ball. Run it in this folder: python3 hollow-ball.py
"""

from math import pi, sqrt

INNER, OUTER, N = 50.0, 100.0, 20

grid, vertices = {}, []
for i in range(N + 1):
    for j in range(N + 1 - i):
        k = N - i - j
        length = sqrt(i * i + j * j + k * k)
        grid[i, j] = len(vertices)
        vertices.append([i / length, j / length, k / length])
ball = []
for i in range(N):
    for j in range(N - i):
        ball.append((grid[i, j], grid[i + 1, j], grid[i, j + 1]))
        if i + j + 2 <= N:
            ball.append((grid[i + 1, j], grid[i + 1, j + 1], grid[i, j + 1]))


def cone(face):
    (a, b, c), (d, e, f), (g, h, i) = (vertices[corner] for corner in face)
    return (a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)) / 6


out = (pi / 6 / sum(map(cone, ball))) ** (1 / 3)
count = len(vertices)
edges = [
    [grid[0, j] for j in range(N + 1)],
    [grid[N - i, 0] for i in range(N + 1)],
    [grid[i, N - i] for i in range(N + 1)],
]
cuts = []
for edge in edges:
    for a, b in zip(edge, edge[1:]):
        cuts.append((a + count, b + count, b, a))
groups = {
    "cavity": [(a, c, b) for a, b, c in ball],
    "outside": [tuple(corner + count for corner in face) for face in ball],
    "cuts": cuts,
}
with open("hollow-ball.obj", "w", encoding="ascii") as file:
    file.write("# Written by hollow-ball.py: an eighth of a hollow ball, its surface looks outwards.\n")
    for radius in (INNER, OUTER):
        for x in vertices:
            file.write("v {:.9g} {:.9g} {:.9g}\n".format(*(c * radius * out for c in x)))
    for name, faces in groups.items():
        file.write(f"g {name}\n")
        for face in faces:
            file.write("f " + " ".join(str(corner + 1) for corner in face) + "\n")
