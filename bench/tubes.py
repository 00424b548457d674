"""Lumens of tubes, straight or bent, as scenes."""
import math

import numpy as np

SCENE = """[scene]
duration = "1 h"
[vessel]
lumenSurface = "lumen.stl"
lumenSurfaceUnit = "m"
[flow]
meanVelocity = "0.133 m/s"
[output]
pictures = false
"""
SIDES = 256


def writeTube(folder, corners, place):
    """scene.toml and lumen.stl, open at both ends; returns the scene's file.

    corners: (r, s, is strut) along the tube [m]; the piece from each to the next is of the first's kind.
    place(r, s, cosine, sine): where a corner lies, of a circle of radius r around the place s of the centreline.
    """
    folder.mkdir(parents=True, exist_ok=True)
    # A polygon of the circle's area
    wider = math.sqrt((2 * math.pi / SIDES) / math.sin(2 * math.pi / SIDES))

    def point(r, s, side):
        return place(r * wider, s, *(f(2 * math.pi * side / SIDES) for f in (math.cos, math.sin)))

    triangles = {"wall": [], "strut": []}
    for (r, s, isStrut), (r1, s1, _) in zip(corners, corners[1:]):
        for side in range(SIDES):
            a, b, c, d = point(r, s, side), point(r, s, side + 1), point(r1, s1, side + 1), point(r1, s1, side)
            triangles["strut" if isStrut else "wall"] += [(a, b, c), (a, c, d)]
    with open(folder / "lumen.stl", "w") as file:
        for name, own in triangles.items():
            if not own:
                continue
            file.write(f"solid {name}\n")
            for triangle in own:
                file.write("facet normal 0 0 0\nouter loop\n"
                           + "".join("vertex %.9g %.9g %.9g\n" % tuple(p) for p in triangle) + "endloop\nendfacet\n")
            file.write(f"endsolid {name}\n")
    (folder / "scene.toml").write_text(SCENE)
    return folder / "scene.toml"


def rotation(axis, angle):
    """Rodrigues' formula, around a unit vector."""
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


class Centreline:
    """Straight pieces and arcs of circles, each going on from the one before, without twist.

    pieces: (length [m], radius of the arc [m] or inf, direction of its centre around the axis [rad])
    """

    def __init__(self, pieces):
        self.pieces, self.begins = pieces, []
        at, frame, s = np.zeros(3), np.eye(3), 0.0
        for piece in pieces:
            self.begins.append((s, at, frame))
            at, frame = self.within(piece, at, frame, piece[0])
            s += piece[0]
        self.length = s

    @staticmethod
    def within(piece, at, frame, s):
        _, radius, direction = piece
        if math.isinf(radius):
            return at + s * frame[:, 2], frame
        towards = frame @ (math.cos(direction), math.sin(direction), 0)
        turned = rotation(np.cross(frame[:, 2], towards), s / radius)
        return at + radius * (towards - turned @ towards), turned @ frame

    def __call__(self, r, s, cosine, sine):
        n = max(i for i, (begin, _, _) in enumerate(self.begins) if begin <= s)
        begin, at, frame = self.begins[n]
        at, frame = self.within(self.pieces[n], at, frame, s - begin)
        return at + frame @ (r * cosine, r * sine, 0)
