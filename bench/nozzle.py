"""The nozzle of the FDA's round robin as an axisymmetric flow, resolved."""
import numpy as np

import wedge

# Corners as in scenes/makeFdaNozzle [m]
BEGIN, CONE, THROAT, END = -100e-3, -62.685e-3, -40e-3, 120e-3
WIDE, NARROW = 6e-3, 2e-3
MEAN_VELOCITY, VISCOSITY = 0.04603, 3.3144e-6


def nozzleWedge(across):
    """`across`: cells from the axis of the throat to its wall."""
    mesh = wedge.Wedge()
    behind = (round(4.5 * across), 12)  # finer at the expansion
    for z, radii, axial in (((BEGIN, CONE), (WIDE, WIDE), (across, 0.5)), ((CONE, THROAT), (WIDE, NARROW), (2 * across, 0.3)),
                            ((THROAT, 0), (NARROW, NARROW), (3 * across, 0.5)), ((0, END), (NARROW, NARROW), behind)):
        mesh.block(z, (0, 0), radii, (across, 1), axial)
        if z[0] < 0:
            mesh.face("wall", "wall", (radii[0], z[0]), (radii[1], z[1]))
    mesh.block((0, END), (NARROW, NARROW), (WIDE, WIDE), (2 * across, 1), behind)
    mesh.face("wall", "wall", (NARROW, 0), (WIDE, 0))
    mesh.face("wall", "wall", (WIDE, 0), (WIDE, END))
    mesh.face("inlet", "patch", (0, BEGIN), (WIDE, BEGIN))
    mesh.face("outlet", "patch", (0, END), (NARROW, END))
    mesh.face("outlet", "patch", (NARROW, END), (WIDE, END))
    return mesh


def resolved(folder, points, across):
    """Axial velocity [m/s] at points (r, z) [m], with so many cells from the axis of the throat to its wall."""
    samples = folder / "postProcessing/points"
    if not samples.exists():
        places = " ".join("(%.9g 0 %.9g)" % (max(r, 1e-6), z) for r, z in points)
        wedge.solve(folder, nozzleWedge(across), meanVelocity=MEAN_VELOCITY, inletRadius=WIDE, viscosity=VISCOSITY,
                    functions="""
  points {type probes; libs ("libsampling.so"); writeControl writeTime; fields (U); interpolationScheme cellPoint;
          probeLocations (%s);}
""" % places)
    (file,) = samples.glob("*/U")
    last = file.read_text().splitlines()[-1]
    return np.array([vector.split()[2] for vector in last.replace(")", "").split("(")[1:]], dtype=float)
