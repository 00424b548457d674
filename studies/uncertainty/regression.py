"""A linear regression of the study's runs, in all parameters but the seed."""
import csv
from pathlib import Path

import numpy

FOLDS = 5


def shares(block):
    """Where the values of each run of a block lie in the ranges of parameters.csv, from -1 to 1."""
    with open(Path(__file__).resolve().parent / "parameters.csv", newline="") as file:
        ranges = {line["key"]: (float(line["lowest"]), float(line["highest"])) for line in csv.DictReader(file)}

    def share(key, value):
        low, high = ranges[key]
        return 2 * (float(value.split()[0]) - low) / (high - low) - 1

    return [[share(key, value) for key, value in run.point] for run in block]


def fitted(points, values):
    """Constant and coefficients by least squares; points and values are lists by block."""
    rows = [[1, *point] for block in points for point in block]
    return numpy.linalg.lstsq(numpy.array(rows), numpy.array(values).ravel(), rcond=None)[0]


def regression(points, values):
    """Of each parameter its share of the variance of the regression, and what its whole range changes the value by."""
    slopes = fitted(points, values)[1:]
    return list(zip(slopes**2 / (slopes**2).sum(), 2 * slopes))


def predicted_share(points, values):
    """Share of the variance of the runs that is predicted from the runs of other blocks.

    Whole blocks are left out, as most points of a block have the same seed. What is not predicted is chance, and what is
    not linear.
    """
    values = numpy.array(values)
    wrong = 0
    for fold in range(FOLDS):
        others = [place for place in range(len(values)) if place % FOLDS != fold]
        constant, *slopes = fitted([points[n] for n in others], values[others])
        wrong += ((values[fold::FOLDS] - constant - numpy.array(points[fold::FOLDS]) @ slopes) ** 2).sum()
    return 1 - wrong / ((values - values.mean()) ** 2).sum()
