"""States of rough contact by scipy and ContactMechanics, as careful users have them.

    states.py TABLE

TABLE is `work_precision.csv`: populations, laws, and states with values of 20 digits. scipy integrates by `quad` between the
breaks of the law, with the density factored out, and finds the separation at a pressure by `brentq` in ln p; finding the breaks
is not timed. ContactMechanics has Greenwood & Williamson's integral `Fn`, hence only Hertz, at a tolerance that cannot be set, and `brentq` is
put around it.
Prints a row for every state, question and program. Times are the shortest of several, in seconds of the processor.
"""
import csv
import math
import sys
import time
import warnings

from scipy.integrate import quad
from scipy.optimize import brentq

from laws import law_of

try:
    from ContactMechanics.ReferenceSolutions.GreenwoodTripp import Fn
except ImportError:
    Fn = None

TOLERANCE = 1e-10
SECONDS = 0.03
ROOT_TWO_PI = math.sqrt(2 * math.pi)
BRACKET = (-4.0, 30.0)
"""Separations over sigma; below, sinusoids that soften with depth carry less again."""

warnings.simplefilter("ignore")


def shortest(function):
    """The answer, and the shortest time of at least two calls."""
    best, spent, calls, answer = float("inf"), 0.0, 0, None
    while calls < 2 or spent < SECONDS:
        start = time.process_time()
        answer = function()
        took = time.process_time() - start
        best, spent, calls = min(best, took), spent + took, calls + 1
    return answer, best


def reach(u):
    """How far above the flat heights count: where the density has fallen by e^-40."""
    return -u + 9.0 if u < 0 else math.sqrt(u * u + 80.0) - u


def log_density(u):
    """ln of the density that is factored out of the integral: at the flat, or its peak."""
    return -0.5 * max(0.0, u)**2 - math.log(ROOT_TWO_PI)


def quad_sum(law_part, breaks, u):
    """The integral over the density that is factored out."""
    top = reach(u)
    points = [s for s in breaks if 0 < s < top] or None
    if u < 0:
        def integrand(s):
            return law_part(s) * math.exp(-0.5 * (u + s)**2)
    else:
        def integrand(s):
            return law_part(s) * math.exp(-s * (u + 0.5 * s))
    return quad(integrand, 0, top, points=points, epsabs=0, epsrel=TOLERANCE, limit=200)[0]


def quad_at_separation(law, breaks, u):
    density = math.exp(log_density(u))
    return u, density * quad_sum(law.pressure, breaks, u), density * quad_sum(law.area, breaks, u)


def quad_at_pressure(law, breaks, p):
    def excess(u):
        return math.log(quad_sum(law.pressure, breaks, u)) + log_density(u) - math.log(p)

    u = brentq(excess, *BRACKET, xtol=0.1 * TOLERANCE, rtol=1e-15)
    return u, p, math.exp(log_density(u)) * quad_sum(law.area, breaks, u)


def fn_at_separation(law, _breaks, u):
    return u, law.force * Fn(u, 1.5), law.touching * Fn(u, 1)


def fn_at_pressure(law, _breaks, p):
    u = brentq(lambda u: math.log(law.force * Fn(u, 1.5) / p), *BRACKET, xtol=1e-12, rtol=1e-15)
    return u, p, law.touching * Fn(u, 1)


def number(cell):
    try:
        return float(cell)
    except ValueError:
        return cell or None


def main():
    with open(sys.argv[1]) as file:
        states = [{name: number(cell) for name, cell in row.items()}
                  for row in csv.DictReader(line for line in file if not line.startswith("#"))]
    rows = csv.writer(sys.stdout, lineterminator="\n")
    rows.writerow(["law", "program", "seconds", "error"])
    for state in states:
        law = law_of(state)
        breaks = law.breaks()
        name = state["model"] + (", strain gradient" if state["strain_gradient_length_m"] else "")
        u, p, area = state["separation_m"] / state["sigma_s_m"], state["pressure_pa"], state["area_fraction"]
        programs = [("scipy, 1e-10", quad_at_separation, quad_at_pressure)]
        if Fn and name == "hertz":
            programs.append(("ContactMechanics", fn_at_separation, fn_at_pressure))
        for program, at_separation, at_pressure in programs:
            found, seconds = shortest(lambda: at_separation(law, breaks, u))
            error = max(abs(found[1] / p - 1), abs(found[2] / area - 1))
            rows.writerow([f"{name}, p(d)", program, seconds, error])
            found, seconds = shortest(lambda: at_pressure(law, breaks, p))
            error = max(abs(found[0] - u), abs(found[2] / area - 1))
            rows.writerow([f"{name}, d(p)", program, seconds, error])


if __name__ == "__main__":
    main()
