"""Extra statistical-model reference values over a deliberately wide range.

Each value is computed twice, with different precisions, tanh-sinh steps and
panel ladders, and kinks searched on different grids; the `agreement` column is
the larger of the two relative deviations.
"""
import argparse
import math
import multiprocessing
import pathlib
import random

from mpmath import mp, mpf

from asperity import Sinusoid, composite_modulus
from statistical import SCHEMES, Scheme, evaluate, surface_from
from tables import INPUT_NOTE, WORKING_DIGITS, as_double, write_table

SEED = 4
TARGET = 1e-16
REFINED = Scheme(50, 22, "1.7", "4.1", 40)
COLUMNS = ["model", "law", "youngs_modulus_pa", "poisson_ratio", "yield_strength_pa",
           "strain_gradient_length_m", "radius_m", "density_per_m2", "sigma_s_m",
           "separation_m", "pressure_pa", "area_fraction", "agreement"]
SEPARATIONS = (-60, -20, -8, -3, -1, 0, 1, 3, 6, 10, 20, 37, 60)       # in sigma
POISSONS = (0.0, 0.2, 0.3, 0.4, 0.5)


def rounded(value):
    return float(f"{float(value):.6g}")


def row(model, law, youngs, poisson, strength, length, radius, density, sigma, separation):
    values = [youngs, poisson, strength, length, radius, density, sigma, separation]
    return [model, law, *(None if v is None else rounded(v) for v in values)]


def sphere_rows(rng):
    """Hertz and Jackson-Green: sigma/R from 1e-6 to 1e3, Sy/E* from 1e-5 to 0.5."""
    def body(strain, poisson):
        youngs = rounded(10 ** rng.uniform(9, 12))
        return youngs, poisson, rounded(strain * youngs / (1 - poisson**2))

    roughness = [1e-6, 1e3, 1e-3, 0.1, 1.0, 30.0, 1e-5, 1e-2, 10.0, 1e-4, 0.3, 1e-6, 1e-3]
    for d, ratio in zip(SEPARATIONS, roughness):
        radius, poisson = 10 ** rng.uniform(-10, -3), rng.choice(POISSONS)
        youngs, _, strength = body(1e-3, poisson)
        yield row("hertz", "", youngs, poisson, strength, None, radius,
                  10 ** rng.uniform(-4, 0) / radius**2, ratio * radius, d * ratio * radius)
    strains = (1e-5, 1e-4, 1e-3, 5e-3, 0.02, 0.08, 0.2, 0.5)
    for gradient in (False, True):
        for index in range(22):
            strain = strains[index % len(strains)]
            poisson = POISSONS[index % len(POISSONS)]
            d = SEPARATIONS[(5 * index + 2) % len(SEPARATIONS)]
            youngs, _, strength = body(strain, poisson)
            radius = 10 ** rng.uniform(-10, -3)
            ratio = 10 ** rng.uniform(-6, 1.5) if index % 4 else strain**2 * 10
            length = radius * 10 ** rng.uniform(-5, 2) if gradient else None
            yield row("ep-sphere", "", youngs, poisson, strength, length, radius,
                      10 ** rng.uniform(-4, 0) / radius**2, ratio * radius,
                      d * ratio * radius)


def sine_rows(rng):
    """Sinusoids: sigma/Delta from 1e-6 to 1e3, B/B_c of the bulk strength up to 1e4."""
    def one(model, law, bulk_ratio, spread, d, poisson, gradient):
        youngs = rounded(10 ** rng.uniform(9, 12))
        strength = rounded(youngs * 10 ** rng.uniform(-4, -2))
        probe = Sinusoid(composite_modulus(mpf(youngs), mpf(poisson)), mpf(poisson),
                         mpf(strength), mpf(1))
        aspect = float(probe.critical_aspect) * bulk_ratio
        wavelength = 10 ** rng.uniform(-9, -3)
        amplitude = aspect * wavelength
        length = amplitude * gradient if gradient else None
        sigma = amplitude * spread
        return row(model, law, youngs, poisson, strength, length,
                   wavelength**2 / (4 * math.pi**2 * amplitude), 2 / wavelength**2,
                   sigma, d * sigma)

    spreads = (1e-6, 1e-3, 0.1, 0.3, 1.0, 3.0, 30.0, 1e3, 1e-4, 0.03)
    for index in range(17):
        yield one("elastic-sine", "rostami-jackson", 10 ** rng.uniform(-2, 3),
                  spreads[index % len(spreads)], SEPARATIONS[(3 * index) % 13],
                  POISSONS[index % 5], None)
    ratios = (0.5, 1.00001, 1.1, 1.5, 4.0, 37.0, 150.0, 393.0, 1e3, 1e4)
    for index in range(24):
        yield one("ep-sine", "", ratios[index % len(ratios)],
                  spreads[(3 * index + index // 10) % len(spreads)],
                  SEPARATIONS[(5 * index + 1) % 13], POISSONS[index % 5], None)
    lengths = (1e-4, 1e-2, 0.3, 3.0, 30.0, 1e3)
    for index in range(26):
        yield one("ep-sine", "", ratios[index % len(ratios)],
                  spreads[(7 * index + index // 10) % len(spreads)],
                  SEPARATIONS[(5 * index + 3) % 13], POISSONS[index % 5],
                  lengths[index % len(lengths)])


def extra_rows(rng):
    """Where sigma, the separation and the kinks all meet; complete contact far below."""
    for d, spread in ((-2.0, 0.5), (-1.0, 1.0), (0.5, 0.2), (2.0, 0.05), (-30.0, 0.02),
                      (-8.0, 0.125)):
        sigma = 2e-8 * spread
        for model, length in (("elastic-sine", None), ("ep-sine", None), ("ep-sine", 5e-8)):
            law = "rostami-jackson" if model == "elastic-sine" else ""
            wavelength = 1e-6
            yield row(model, law, 2e11, 0.3, 1e9, length,
                      wavelength**2 / (4 * math.pi**2 * 2e-8), 2 / wavelength**2, sigma,
                      d * sigma)


def compute(cells):
    mp.dps = WORKING_DIGITS
    named = dict(zip(COLUMNS, ["" if c is None else str(c) if isinstance(c, str) else repr(c)
                               for c in cells]))
    surface, d = surface_from(named, as_double)
    first = evaluate(named["model"], surface, d, SCHEMES[0])
    second = evaluate(named["model"], surface, d, SCHEMES[1])
    spread = max(float(abs(a / b - 1)) for a, b in zip(first, second))
    if spread > TARGET:                              # a third opinion, much finer
        third = evaluate(named["model"], surface, d, REFINED)
        print("refined:", named["model"], spread, flush=True)
        spread = max(float(abs(a / b - 1)) for a, b in zip(second, third))
        second = third
    return [*cells, *second, f"{spread:.1e}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    rng = random.Random(SEED)
    todo = [*sphere_rows(rng), *sine_rows(rng), *extra_rows(rng)]
    with multiprocessing.Pool(arguments.jobs) as pool:
        rows = []
        for result in pool.imap(compute, todo):
            rows.append(result)
            if len(rows) % 20 == 0:
                print(len(rows), "of", len(todo), flush=True)
    mp.dps = WORKING_DIGITS
    write_table(arguments.output / "statistical_extra.csv",
                ["Statistical model over a wide range: docs/theory/models.md, section 3.", INPUT_NOTE,
                 "Computed with mpmath, panel by panel between every kink, by two schemes of "
                 f"{SCHEMES[0].digits} and {SCHEMES[1].digits} digits with different panels and "
                 "steps; printed with 20 digits.",
                 "agreement: larger relative deviation between the two schemes.",
                 "Values below 1e-308 are out of the range of doubles. Relative conditioning "
                 "grows like (separation/sigma)^2."],
                COLUMNS, rows)
    print("worst agreement", max((r[-1] for r in rows), key=float))
    mp.dps = WORKING_DIGITS


if __name__ == "__main__":
    main()
