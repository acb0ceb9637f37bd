"""Extra single-asperity reference tables in the regions where doubles struggle.

Inputs are generated in double precision (their ``repr`` is what is printed, so
reading them back gives exactly the numbers used) and placed by asking the
formulas themselves where the thresholds lie.  Points next to a jump keep a
relative distance of at least 1e-9 from it.
"""
import argparse
import pathlib
import random

from mpmath import mp, mpf, pi, sqrt

from asperity import Sinusoid, Sphere, composite_modulus
from point_laws import TABLES
from tables import (INPUT_NOTE, PRECISION_NOTE, WORKING_DIGITS, condition_number,
                    write_table)

SEED = 20260
CONDITION_NOTE = (
    "condition: max over the outputs of sum over the inputs of |d ln out/d ln in|, central "
    "differences with relative step 1e-18; a distance to a jump is not part of it.")


def rounded(value, digits=6):
    """A double with few printed digits, for the inputs that need no placing."""
    return float(f"{float(value):.{digits}g}")


# -- sphere -------------------------------------------------------------------
def sphere_inputs(rng):
    """(E, nu, Sy, R, w)."""
    def ball(youngs, poisson, strength, radius):
        return Sphere(composite_modulus(mpf(youngs), mpf(poisson)), mpf(poisson),
                      mpf(strength), mpf(radius))

    def place(poisson, strain, ratios):
        """Points at w' = ratios for a given Sy/E*."""
        youngs = rounded(10 ** rng.uniform(9, 12))
        radius = rounded(10 ** rng.uniform(-10, -3))
        strength = rounded(strain * float(composite_modulus(mpf(youngs), mpf(poisson))))
        w_c = ball(youngs, poisson, strength, radius).w_c
        for ratio in ratios:
            yield youngs, poisson, strength, radius, float(mpf(ratio) * w_c)

    edge = mpf(19) / 10
    near = [edge * (1 + sign * mpf(10) ** -k) for k in (9, 6, 3) for sign in (-1, 1)]
    # both sides of the jump at w' = 1.9, every sign of nu, small to large Sy/E*
    for poisson, strain in ((0.0, 1e-4), (0.2, 1e-3), (0.3, 0.01), (0.4, 0.05),
                            (0.5, 0.003), (-0.3, 0.02), (-0.9, 0.005), (0.2, 0.08),
                            (0.25, 0.5)):
        yield from place(poisson, strain, near)
    # wide range of w' at moderate strain, including very deep (a/R = 1, cap on the area)
    for poisson, strain in ((0.3, 1e-5), (0.5, 1e-4), (-0.9, 1e-3), (0.0, 3e-3), (-0.5, 0.01)):
        yield from place(poisson, strain, [mpf(10) ** k for k in (-12, -3, 1, 2, 4, 6, 8)])
    # large b: the power law of the area runs away just above w' = 1.9
    for poisson, strain in ((0.2, 0.1), (0.45, 0.2), (-0.2, 0.3), (0.0, 0.4), (0.5, 0.5)):
        exponent = mpf("0.14") * mp.exp(23 * mpf(strain))
        growths = (mpf("0.01"), mpf("0.3"), 1, 3, 30, 300)
        yield from place(poisson, strain,
                         [edge * mp.exp(g / exponent) for g in growths])
    # contact radius on both sides of its limit a/R = 1
    for poisson, strain in ((0.1, 0.002), (0.35, 0.01), (-0.7, 0.03)):
        for shift in (mpf(-1) / 10**3, -mpf(10) ** -7, mpf(10) ** -7, mpf(1) / 10):
            youngs = rounded(10 ** rng.uniform(9, 12))
            radius = rounded(10 ** rng.uniform(-10, -3))
            strength = rounded(strain * youngs)
            one = ball(youngs, poisson, strength, radius)
            # A = pi R^2: w' (w'/1.9)^b = R/w_c
            log_ratio = ((mp.log(one.radius / one.w_c) + one.b * mp.log(edge))
                         / (1 + one.b))
            w = one.w_c * mp.exp(log_ratio) * (1 + shift)
            yield youngs, poisson, strength, radius, float(w)
    # generic points
    for _ in range(20):
        yield from place(rounded(rng.uniform(-0.9, 0.5), 4), 10 ** rng.uniform(-5, -1.5),
                         [mpf(10) ** rng.uniform(-1, 5)])


# -- sinusoid -----------------------------------------------------------------
def sinusoid_with_r(rng, poisson, r):
    """(E, nu, Sy, B) with B/B_c = r as nearly as doubles allow."""
    youngs = rounded(10 ** rng.uniform(9, 12))
    strength = rounded(youngs * 10 ** rng.uniform(-4, -2))
    probe = Sinusoid(composite_modulus(mpf(youngs), mpf(poisson)), mpf(poisson),
                     mpf(strength), mpf(1))
    return youngs, poisson, strength, float(probe.critical_aspect * r)


def wave_of(youngs, poisson, strength, aspect):
    return Sinusoid(composite_modulus(mpf(youngs), mpf(poisson)), mpf(poisson),
                    mpf(strength), mpf(aspect))


def sinusoid_inputs(rng):
    """(E, nu, Sy, B, p)."""
    tiny = [mpf(10) ** -k for k in (2, 4, 6)]
    # elastic: near x = 0.8, near and beyond complete contact
    eighth = mpf(8) / 10
    for poisson, r in ((0.3, mpf("0.5")), (-0.9, mpf("0.99")), (0.5, 1 - mpf(10) ** -9)):
        body = sinusoid_with_r(rng, poisson, r)
        for x in ([eighth * (1 - t) for t in tiny] + [eighth * (1 + t) for t in tiny]
                  + [1 - t for t in tiny] + [mpf("1.000001"), mpf(3), mpf(10) ** -12]):
            yield *body, float(x * wave_of(*body).p_star)
    # r from just above one to 1e4, both sides of p_c, through complete contact
    ratios = [1 + mpf(10) ** -k for k in (9, 6, 3)]
    ratios += [mpf(v) for v in ("1.5", "3", "37", "300", "391", "393", "395", "1e3", "1e4")]
    poissons = (0.2, -0.5, 0.5, 0.0, 0.33, -0.9, 0.4, 0.2, 0.3, 0.49, 0.1, 0.25)
    for poisson, r in zip(poissons, ratios):
        body = sinusoid_with_r(rng, poisson, r)
        wave = wave_of(*body)
        pressures = [wave.p_critical * (1 + s * mpf(10) ** -k)
                     for k in (9, 3) for s in (-1, 1)]
        pressures += [wave.p_star_ep * x for x in
                      (mpf("1e-3"), mpf("0.3"), mpf("0.8"), mpf("0.99"),
                       1 - mpf(10) ** -4, 1 - mpf(10) ** -6, mpf("1.5"))]
        for p in pressures:
            yield *body, float(p)
    for _ in range(8):
        body = sinusoid_with_r(rng, rounded(rng.uniform(-0.9, 0.5), 4),
                               mpf(10) ** rng.uniform(-2, 3))
        yield *body, float(wave_of(*body).p_star * mpf(10) ** rng.uniform(-6, 0))


def interference_inputs(rng):
    """(E, nu, Sy, lambda, B, w)."""
    depths = [mpf(v) for v in ("1e-12", "1e-9", "1e-6", "1e-3", "0.1", "0.5", "0.9",
                               "0.999", "0.999999", "1.5")]
    ratios = [mpf("0.1"), 1 - mpf(10) ** -9] + [1 + mpf(10) ** -k for k in (9, 4)]
    ratios += [mpf(v) for v in ("1.5", "10", "37", "380", "393", "410", "1e3", "1e4")]
    poissons = (0.3, 0.5, -0.9, 0.0, 0.2, 0.45, -0.4, 0.33, 0.25, 0.1, 0.5, 0.2)
    for poisson, r in zip(poissons, ratios):
        body = sinusoid_with_r(rng, poisson, r)
        wavelength = rounded(10 ** rng.uniform(-9, -2))
        amplitude = mpf(body[3]) * mpf(wavelength)
        for depth in depths:
            yield *body[:3], wavelength, body[3], float(depth * amplitude)
    # where the elastic pressure passes 0.8 p*: w/Delta = 1 - (1 - sqrt 0.8)^(5/2)
    special = 1 - (1 - sqrt(mpf(8) / 10)) ** (mpf(5) / 2)
    for poisson, r in ((0.3, mpf("0.7")), (0.2, mpf(20))):
        body = sinusoid_with_r(rng, poisson, r)
        wavelength = rounded(10 ** rng.uniform(-9, -2))
        for shift in (-tiny_shift(3), -tiny_shift(9), tiny_shift(9), tiny_shift(3)):
            w = special * (1 + shift) * mpf(body[3]) * mpf(wavelength)
            yield *body[:3], wavelength, body[3], float(w)
    # where the pressure passes p_c: found by bisection in ln w
    for poisson, r in ((0.3, mpf("1.2")), (0.4, mpf(5)), (-0.2, mpf(100))):
        body = sinusoid_with_r(rng, poisson, r)
        wavelength = rounded(10 ** rng.uniform(-9, -2))
        wave = wave_of(*body)
        low, high = mpf(10) ** -40, mpf(1)
        for _ in range(200):
            middle = sqrt(low * high)
            if wave.pressure_at(middle) > wave.p_critical:
                high = middle
            else:
                low = middle
        for shift in (-tiny_shift(3), -tiny_shift(9), tiny_shift(9), tiny_shift(3)):
            w = low * (1 + shift) * mpf(body[3]) * mpf(wavelength)
            yield *body[:3], wavelength, body[3], float(w)


def tiny_shift(k):
    return mpf(10) ** -k


GENERATORS = {"sphere": sphere_inputs, "sinusoid": sinusoid_inputs,
              "sinusoid_interference": interference_inputs}
TITLES = {
    "sphere": "One asperity, sphere: Hertz and Jackson-Green (docs/theory/models.md, sections 2.1, "
              "2.2); the Jackson-Green area is capped at pi R^2, forces and the Hertz area are not.",
    "sinusoid": "One sinusoid at a mean pressure: docs/theory/models.md, sections 2.3, 2.4, 2.5.",
    "sinusoid_interference": "One sinusoid pressed to an interference: docs/theory/models.md, section "
                             "2.6; amplitude = aspect_ratio x wavelength.",
}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    for name, generate in GENERATORS.items():
        inputs, outputs, function = TABLES[name]
        rng = random.Random(SEED)
        rows = []
        for point in generate(rng):
            values = [mpf(value) for value in point]
            results = function(*values)
            # a double can hold every output, and nearly every input is a plain number
            assert all(out == 0 or mpf("1e-300") < abs(out) < mpf("1e300") for out in results)
            condition = condition_number(function, values)
            rows.append([*point, *results, mp.nstr(condition, 4)])
        write_table(arguments.output / (name + ".csv"),
                    [TITLES[name] + " Hard regions.", INPUT_NOTE, PRECISION_NOTE,
                     CONDITION_NOTE],
                    [*inputs, *outputs, "condition"], rows)
        print(name, len(rows), "rows, largest condition",
              max((row[-1] for row in rows), key=float))


if __name__ == "__main__":
    main()
