#!/usr/bin/env python3
"""Writes lumen.stl: a piece of an artery, narrowed on one side, open at both ends. Lengths in mm."""
import math

LENGTH, RADIUS = 1.2, 0.9          # of the vessel
DEPTH, WIDTH = 0.06, 0.3           # of the plaque, and how far it reaches along the vessel
AROUND, ALONG = 96, 48             # points of a ring, and rings


def point(i, j):
    angle, z = 2 * math.pi * i / AROUND, LENGTH * j / ALONG
    plaque = DEPTH * math.exp(-((z - LENGTH / 2) / WIDTH) ** 2) * (1 + math.cos(angle)) / 2
    radius = RADIUS - plaque
    return radius * math.cos(angle), radius * math.sin(angle), z


def facet(a, b, c):
    corners = "".join("      vertex {:.6f} {:.6f} {:.6f}\n".format(*corner) for corner in (a, b, c))
    return "  facet normal 0 0 0\n    outer loop\n" + corners + "    endloop\n  endfacet\n"


with open("lumen.stl", "w") as stl:
    stl.write("solid wall\n")
    for j in range(ALONG):
        for i in range(AROUND):
            a, b = point(i, j), point(i + 1, j)
            c, d = point(i + 1, j + 1), point(i, j + 1)
            stl.write(facet(a, b, c) + facet(a, c, d))
    stl.write("endsolid wall\n")
