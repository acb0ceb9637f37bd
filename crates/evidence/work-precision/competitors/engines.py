"""What users integrate the statistical model with, as careful users would.

An engine is a function of (law, u, setting) for the state at a separation u, in
units of sigma, or of (law, ln p, setting) for the state at a pressure; it answers
(u, p, A/An). Preparing the law and finding its breaks is not timed.
"""
import math
import warnings

import numpy as np
from scipy.integrate import quad
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq

ROOT_TWO_PI = math.sqrt(2 * math.pi)
# Below, sinusoids that soften with depth carry less again.
BRACKET = (-4.0, 30.0)
# One batch: as many states as here, over these separations.
BATCH = 1000
BATCH_RANGE = (-3.5, 20.5)
# Elements of the matrix of densities that stay in the cache together.
BLOCK = 1 << 15
# Heights above the flat that a grid reaches which serves all separations.
SHARED_REACH = 12.0

warnings.simplefilter("ignore")


def reach(u):
    """How far above the flat heights count: where the density has fallen by e^-40."""
    return -u + 9.0 if u < 0 else math.sqrt(u * u + 80.0) - u


def log_density(u):
    """ln of the density that is factored out of the integral: at the flat, or its peak."""
    return -0.5 * max(0.0, u)**2 - math.log(ROOT_TWO_PI)


# --- scipy: adaptive quadrature between the breaks, Brent's method in ln p -------------------

def quad_sum(law_part, breaks, u, tolerance):
    """The integral over the density that is factored out."""
    top = reach(u)
    points = [s for s in breaks if 0 < s < top] or None
    if u < 0:
        def integrand(s):
            return law_part(s) * math.exp(-0.5 * (u + s)**2)
    else:
        def integrand(s):
            return law_part(s) * math.exp(-s * (u + 0.5 * s))
    return quad(integrand, 0, top, points=points, epsabs=0, epsrel=tolerance, limit=200)[0]


def quad_at_separation(law, u, tolerance):
    density = math.exp(log_density(u))
    return (u, density * quad_sum(law.pressure, law.found_breaks, u, tolerance),
            density * quad_sum(law.area, law.found_breaks, u, tolerance))


def quad_at_pressure(law, log_p, tolerance):
    def excess(u):
        return math.log(quad_sum(law.pressure, law.found_breaks, u, tolerance)) + log_density(u) - log_p

    u = brentq(excess, *BRACKET, xtol=0.1 * tolerance, rtol=1e-15)
    area = quad_sum(law.area, law.found_breaks, u, tolerance)
    return u, math.exp(log_p), math.exp(log_density(u)) * area


class InNumpy:
    """A law as most scripts have it: written once, in numpy, for single numbers and for arrays."""

    def __init__(self, law):
        self.law, self.found_breaks = law, law.found_breaks

    def pressure(self, s):
        return self.law.arrays(np.float64(s))[0]

    def area(self, s):
        return self.law.arrays(np.float64(s))[1]


def numpy_at_separation(law, u, tolerance):
    return quad_at_separation(InNumpy(law), u, tolerance)


def numpy_at_pressure(law, log_p, tolerance):
    return quad_at_pressure(InNumpy(law), log_p, tolerance)


# --- ContactMechanics: its integral Fn, which is Greenwood & Williamson's with Hertz's law ----

def fn_at_separation(law, u, _):
    return u, law.force * law.fn(u, 1.5), law.touching * law.fn(u, 1)


def fn_at_pressure(law, log_p, _):
    u = brentq(lambda u: math.log(law.force * law.fn(u, 1.5)) - log_p, *BRACKET, xtol=1e-12, rtol=1e-15)
    return u, math.exp(log_p), law.touching * law.fn(u, 1)


# --- a fixed grid and the trapezoidal rule, one state at a time --------------------------------

def grid_at_separation(law, u, nodes):
    s = np.linspace(0.0, reach(u), nodes)
    density = np.exp(-0.5 * (u + s)**2) if u < 0 else np.exp(-s * (u + 0.5 * s))
    pressure, area = law.arrays(s)
    scale = math.exp(log_density(u))
    return u, scale * np.trapezoid(pressure * density, s), scale * np.trapezoid(area * density, s)


def grid_at_pressure(law, log_p, nodes):
    # One grid for the whole search: the law is evaluated once, each step only sums densities.
    s = np.linspace(0.0, SHARED_REACH, nodes)
    pressure, area = law.arrays(s)
    weight = s[1] / ROOT_TWO_PI
    fall = 0.5 * s * s

    def log_sum(values, u):
        return math.log(weight * (values @ np.exp(-u * s - fall))) - 0.5 * u * u

    u = brentq(lambda u: log_sum(pressure, u) - log_p, -3.5, 30.0, xtol=1e-13, rtol=1e-15)
    return u, math.exp(log_p), math.exp(log_sum(area, u))


# --- a fixed grid, a thousand states at once -----------------------------------------------------

def batch_sums(law, us, nodes):
    """Pressures and areas at many separations: one law, one matrix of densities, one product."""
    s = np.linspace(0.0, SHARED_REACH, nodes)
    values = np.stack(law.arrays(s), axis=1) * (s[1] / ROOT_TWO_PI)
    fall = 0.5 * s * s
    sums = np.empty((len(us), 2))
    rows = max(1, BLOCK // nodes)
    for first in range(0, len(us), rows):
        part = us[first:first + rows]
        sums[first:first + rows] = np.exp(np.multiply.outer(-part, s) - fall) @ values
    return sums * np.exp(-0.5 * us * us)[:, None]


def batch_at_separations(law, us, nodes):
    sums = batch_sums(law, us, nodes)
    return us, sums[:, 0], sums[:, 1]


def batch_at_pressures(law, log_ps, nodes):
    """As many separations as there are loads make a table, and splines in ln p read it."""
    table = np.linspace(*BATCH_RANGE, len(log_ps))
    log_p, log_a = np.log(batch_sums(law, table, nodes))[::-1].T
    u = CubicSpline(log_p, table[::-1])(log_ps)
    return u, np.exp(log_ps), np.exp(CubicSpline(log_p, log_a)(log_ps))


SINGLE = {"quad": (quad_at_separation, quad_at_pressure),
          "quad numpy": (numpy_at_separation, numpy_at_pressure),
          "Fn": (fn_at_separation, fn_at_pressure),
          "grid": (grid_at_separation, grid_at_pressure)}
BATCHED = {"grid batch": (batch_at_separations, batch_at_pressures)}
