"""The states at which run time is held against error: docs/develop/performance.md.

Three populations of three materials, every law with and without strain gradient,
five separations from far below the mean plane to where almost nothing touches.
"""
import argparse
import itertools
import multiprocessing
import pathlib

from mpmath import mp

from make_statistical import COLUMNS as COMPUTED_COLUMNS, compute, row
from make_statistical_many import LAWS, without_law
from statistical import SCHEMES
from tables import INPUT_NOTE, WORKING_DIGITS, write_table

# Young's modulus, Poisson's ratio, strength, strain-gradient length; radius, density, sigma.
POPULATIONS = {
    # Diamond at a cutoff of some nanometres, its sinusoids far beyond yield (B/B_c = 123).
    "diamond": (463e9, 0.2, 1.8e9, 5e-6, 4.56e-8, 2.6e13, 6.66e-9),
    # Ground steel: sigma is over half the sinusoids' amplitude, the deepest are flattened.
    "steel": (210e9, 0.3, 1e9, 1e-7, 1e-5, 1.5e10, 2e-7),
    # A hard polymer near the onset of yield.
    "polymer": (3e9, 0.4, 6e7, 2e-7, 5e-6, 1.6e11, 5e-8),
}
SEPARATIONS = (-3, 0, 3, 6, 20)     # in sigma


def states():
    for (name, body), (model, gradient), d in itertools.product(
            POPULATIONS.items(), LAWS, SEPARATIONS):
        youngs, poisson, strength, length, radius, density, sigma = body
        yield name, row(model, "", youngs, poisson, strength, length if gradient else None,
                        radius, density, sigma, d * sigma)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    names, todo = zip(*states())
    with multiprocessing.Pool(arguments.jobs) as pool:
        computed = pool.map(compute, todo, chunksize=1)
    mp.dps = WORKING_DIGITS
    write_table(arguments.output / "work_precision.csv",
                ["Statistical model, where run time is held against error: docs/theory/models.md, "
                 "section 3.", INPUT_NOTE,
                 "Computed with mpmath, panel by panel between every kink, by two schemes of "
                 f"{SCHEMES[0].digits} and {SCHEMES[1].digits} digits with different panels and "
                 "steps; printed with 20 digits.",
                 "agreement: larger relative deviation between the two schemes.",
                 "elastic-sine is Rostami & Jackson's law."],
                ["population", *without_law(COMPUTED_COLUMNS)],
                [[name, *without_law(cells)] for name, cells in zip(names, computed)])
    print("worst agreement", max((cells[-1] for cells in computed), key=float))


if __name__ == "__main__":
    main()
