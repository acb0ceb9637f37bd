"""Many random states of the statistical model: what an error estimate has to cover.

A hundred states for each law, with and without strain gradient. Half of them are
of the kind met in practice: separations of a few sigma and roughness of the order
of the asperities. The other half go far out: separations up to 60 sigma either
way, and four more decades of every ratio.
"""
import argparse
import math
import multiprocessing
import pathlib
import random

from mpmath import mp, mpf

from asperity import Sinusoid, composite_modulus
from make_statistical import COLUMNS as COMPUTED_COLUMNS, compute, row
from statistical import SCHEMES
from tables import INPUT_NOTE, WORKING_DIGITS, write_table

SEED = 6
STATES_PER_LAW = 100
LAWS = (("hertz", False), ("ep-sphere", False), ("elastic-sine", False), ("ep-sine", False),
        ("ep-sphere", True), ("ep-sine", True))
UNUSED = COMPUTED_COLUMNS.index("law")


def without_law(cells):
    return [*cells[:UNUSED], *cells[UNUSED + 1:]]


def separation_in_sigma(rng, far):
    """A few sigma, or up to sixty with small ones as frequent as large ones."""
    if not far:
        return rng.uniform(-4, 8)
    return rng.choice((-1, 1)) * 10 ** rng.uniform(-1, math.log10(60))


def decades(rng, low, high, far):
    """A random power of ten; far out the range is two decades wider at both ends."""
    return 10 ** (rng.uniform(low - 2, high + 2) if far else rng.uniform(low, high))


def sphere_state(rng, model, gradient, far):
    youngs, poisson = 10 ** rng.uniform(9, 12), rng.uniform(0, 0.5)
    strength = youngs * decades(rng, -3.5, -1.5, far)
    radius = 10 ** rng.uniform(-8, -3)
    sigma = radius * decades(rng, -3, 0, far)
    length = sigma * decades(rng, -1, 3, far) if gradient else None
    density = min(1, decades(rng, -2.5, -1, far)) / (radius * sigma)
    return row(model, "", youngs, poisson, strength, length, radius, density, sigma,
               separation_in_sigma(rng, far) * sigma)


def sinusoid_state(rng, model, gradient, far):
    youngs, poisson = 10 ** rng.uniform(9, 12), rng.uniform(0, 0.5)
    strength = youngs * 10 ** rng.uniform(-4, -2)
    probe = Sinusoid(composite_modulus(mpf(youngs), mpf(poisson)), mpf(poisson),
                     mpf(strength), mpf(1))
    aspect = float(probe.critical_aspect) * decades(rng, -1, 2, far)
    wavelength = 10 ** rng.uniform(-9, -3)
    amplitude = aspect * wavelength
    sigma = amplitude * decades(rng, -2, 0, far)
    length = amplitude * decades(rng, -2, 2, far) if gradient else None
    return row(model, "", youngs, poisson, strength, length,
               wavelength**2 / (4 * math.pi**2 * amplitude), 2 / wavelength**2, sigma,
               separation_in_sigma(rng, far) * sigma)


def states(rng):
    for model, gradient in LAWS:
        state = sinusoid_state if model.endswith("sine") else sphere_state
        for index in range(STATES_PER_LAW):
            yield state(rng, model, gradient, far=index % 2 == 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    todo = list(states(random.Random(SEED)))
    rows = []
    with multiprocessing.Pool(arguments.jobs) as pool:
        for result in pool.imap(compute, todo):
            rows.append(without_law(result))
            if len(rows) % 20 == 0:
                print(len(rows), "of", len(todo), flush=True)
    mp.dps = WORKING_DIGITS
    write_table(arguments.output / "statistical_many.csv",
                ["Many random states of the statistical model: docs/theory/models.md, section 3.",
                 INPUT_NOTE,
                 "Computed with mpmath, panel by panel between every kink, by two schemes of "
                 f"{SCHEMES[0].digits} and {SCHEMES[1].digits} digits with different panels and "
                 "steps; printed with 20 digits.",
                 "agreement: larger relative deviation between the two schemes.",
                 "elastic-sine is Rostami & Jackson's law. Values below 1e-308 are out of the "
                 "range of doubles."],
                without_law(COMPUTED_COLUMNS), rows)
    print("worst agreement", max((r[-1] for r in rows), key=float))


if __name__ == "__main__":
    main()
