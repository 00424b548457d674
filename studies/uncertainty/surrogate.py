"""A surrogate of the study's runs: sparse polynomial chaos (OpenTURNS) in all parameters but the seed."""
import csv
from pathlib import Path

import openturns

DEGREE = 3
SPARSITY = 0.6  # of the hyperbolic rule: few terms that join parameters
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
    """Legendre polynomials that LARS chooses, by least squares; points and values are lists by block."""
    points = openturns.Sample([point for block in points for point in block])
    values = openturns.Sample([[value] for block in values for value in block])
    count = points.getDimension()
    terms = openturns.HyperbolicAnisotropicEnumerateFunction(count, SPARSITY)
    basis = openturns.OrthogonalProductPolynomialFactory([openturns.LegendreFactory()] * count, terms)
    selection = openturns.LeastSquaresMetaModelSelectionFactory(openturns.LARS(), openturns.CorrectedLeaveOneOut())
    algorithm = openturns.FunctionalChaosAlgorithm(
        points, values, openturns.ComposedDistribution([openturns.Uniform(-1, 1)] * count),
        openturns.FixedStrategy(basis, terms.getStrataCumulatedCardinal(DEGREE)), openturns.LeastSquaresStrategy(selection))
    algorithm.run()
    return algorithm.getResult()


def surrogate(points, values):
    """First index of each parameter: its share of the variance of the surrogate."""
    found = openturns.FunctionalChaosSobolIndices(fitted(points, values))
    return [found.getSobolIndex(place) for place in range(len(points[0][0]))]


def predicted_share(points, values):
    """Share of the variance of the runs that is predicted from the runs of other blocks.

    Whole blocks are left out, as most points of a block have the same seed. What is not predicted is chance and the error
    of the surrogate.
    """
    numbers = [value for block in values for value in block]
    mean = sum(numbers) / len(numbers)
    wrong = 0
    for fold in range(FOLDS):
        others = [place for place in range(len(values)) if place % FOLDS != fold]
        model = fitted([points[n] for n in others], [values[n] for n in others]).getMetaModel()
        wrong += sum((value - model(point)[0]) ** 2 for n in range(fold, len(values), FOLDS)
                     for point, value in zip(points[n], values[n]))
    return 1 - wrong / sum((number - mean) ** 2 for number in numbers)
