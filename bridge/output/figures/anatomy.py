"""What an agent is to the eye, in words and colours, and the line of the inner elastic lamina (IEL)."""

import numpy as np
import results
import style

PARTS = (
    ("muscle of the wall (media)", style.MEDIA),
    ("new tissue (neointima)", style.ORANGE),
    ("inner elastic lamina (IEL)", style.BLUE),
    ("outer elastic lamina (EEL)", style.GREEN),
    ("stent", style.STEEL),
)
MEDIA, NEOINTIMA, IEL, EEL, STENT = range(len(PARTS))
SMOOTHING = 2  # of the line, in radii of lamina agents, as bridge/surface/Histology has it
NODES = 2  # of the line's grid, per length of smoothing


class RadiusMap:
    """The distance of a lamina from the axis, as a smooth surface through the centres of its agents.

    It goes on where they are missing, by the nearest ones. A weight falls off as a Gaussian does.
    """

    def __init__(self, radius, angle, z, smoothing):
        around = max(8, int(np.ceil(NODES * 2 * np.pi * radius.mean() / smoothing)))
        along = 1 + int(np.ceil(NODES * np.ptp(z) / smoothing))
        self.start, self.length = z.min(), max(np.ptp(z), smoothing)
        box = [[-np.pi, np.pi], [self.start, self.start + self.length]]
        sums = np.histogram2d(angle, z, (around, along), box, weights=radius)[0]
        counts = np.histogram2d(angle, z, (around, along), box)[0]
        spacing = 2 * np.pi * radius.mean() / around
        turn = gaussian(wrapped(np.arange(around), around) * spacing / smoothing)
        shift = gaussian(differences(np.arange(along)) * self.length / along / smoothing)
        weight = turn @ counts @ shift
        with np.errstate(invalid="ignore"):
            values = (turn @ sums @ shift) / weight
        self.values = np.where(weight > 0, values, radius.mean())

    def at(self, angle, z):
        """The distance at an angle and a place along the vessel, bilinear between nodes."""
        around, along = self.values.shape
        u = (np.asarray(angle) / (2 * np.pi) + 0.5) * around - 0.5
        v = np.clip((np.asarray(z) - self.start) / self.length * along - 0.5, 0, along - 1)
        left, low = np.floor(u).astype(int), np.floor(v).astype(int)
        s, t = u - left, v - low
        left, right, high = left % around, (left + 1) % around, np.minimum(low + 1, along - 1)
        lower = (1 - s) * self.values[left, low] + s * self.values[right, low]
        upper = (1 - s) * self.values[left, high] + s * self.values[right, high]
        return (1 - t) * lower + t * upper


def differences(places):
    return places[:, None] - places[None, :]


def wrapped(places, count):
    """Differences of places on a circle of so many, the short way round."""
    return (differences(places) + count // 2) % count - count // 2


def gaussian(distance):
    return np.exp(-0.5 * distance**2)


def cylindrical(agents):
    """Distance from the axis [m], angle [rad] and place along the vessel [m]."""
    x, y, z = agents["position"].T
    return np.hypot(x, y), np.arctan2(y, x), z


def iel_line(agents):
    """The IEL's line; None where no agent is left of it."""
    iel = agents["kind"] == results.KINDS["iel"]
    if not iel.any():
        return None
    radius, angle, z = (values[iel] for values in cylindrical(agents))
    return RadiusMap(radius, angle, z, SMOOTHING * agents["radius"][iel].mean())


def is_new_tissue(agents, line):
    """Which cells are neointima: smooth muscle lumenward of the IEL's line; without an IEL, cells born in growth."""
    smc = agents["kind"] == results.KINDS["smc"]
    if line is None:
        return smc & (agents["daughter"] > 0)
    radius, angle, z = cylindrical(agents)
    return smc & (agents["injuredIel"] == 0) & (radius < line.at(angle, z))


def parts(agents, line):
    """The index into PARTS of each agent."""
    found = np.where(is_new_tissue(agents, line), NEOINTIMA, MEDIA)
    for number, name in ((IEL, "iel"), (EEL, "eel"), (STENT, "strut")):
        found[agents["kind"] == results.KINDS[name]] = number
    return found
