"""Calls of the Python package beside numpy and scipy code of the same length.

    python_calls.py

Every task is a pair of functions: one calls truearea, the other is what a careful script has in its place, and both are
a few lines. Times are the shortest of several, in seconds of the processor, on one thread. *Differ* is the largest
relative difference of what both return; scipy and numpy set it, by their tolerance and their trapezoids.
"""
import inspect
import os

for threads in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "RAYON_NUM_THREADS"):
    os.environ[threads] = "1"

import time

import numpy
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import erf

import truearea

SECONDS = 0.5
MODULUS = 1e11
STEEL = truearea.Material(MODULUS * (1 - 0.3**2), 0.3, yield_strength=1e9)
RADIUS, DENSITY, SIGMA = 1e-5, 1e10, 1e-7
PRESSURES = numpy.geomspace(1e4, 1e8, 50)
PRESSURE = 1e7
WAVEVECTORS = numpy.geomspace(1e5, 1e10, 20001)
DENSITIES = 1e-8 * WAVEVECTORS**-2.6
SURFACE = truearea.Spectrum(WAVEVECTORS, DENSITIES)
SCALES = SURFACE.amplitudes()


def states_ours():
    states = truearea.contact(
        model="hertz", radius=RADIUS, density=DENSITY, sigma_s=SIGMA, material=STEEL, pressure=PRESSURES, tolerance=1e-10
    )
    return states.area_fraction


def states_theirs():
    def moment(u, power):
        density = lambda s: s**power * numpy.exp(-0.5 * (u + s) ** 2) / numpy.sqrt(2 * numpy.pi)
        return quad(density, 0, max(0, -u) + 9, epsabs=0, epsrel=1e-10)[0]

    scale = 4 / 3 * MODULUS * DENSITY * RADIUS**0.5 * SIGMA**1.5
    at = [brentq(lambda u: numpy.log(scale * moment(u, 1.5) / pressure), -5, 8) for pressure in PRESSURES]
    return numpy.pi * DENSITY * RADIUS * SIGMA * numpy.array([moment(u, 1) for u in at])


def persson_ours():
    curve = truearea.persson(SURFACE, STEEL, pressure=PRESSURE, band="1d")
    return curve.area_fraction[0, 1:]


def persson_theirs():
    integrand = WAVEVECTORS**3 * DENSITIES / numpy.pi
    steps = 0.5 * (integrand[1:] + integrand[:-1]) * numpy.diff(numpy.log(WAVEVECTORS))
    spread = 0.5 * MODULUS * numpy.sqrt(2 * numpy.cumsum(steps))
    return erf(PRESSURE / (numpy.sqrt(2) * spread))


def stack_ours():
    curve = truearea.stacked(SURFACE, STEEL, pressure=PRESSURE, model="elastic")
    return curve.area_fraction[0]


def stack_theirs():
    pressure, areas = PRESSURE, []
    for slope in SCALES.amplitude_m / SCALES.wavelength_m:
        x = pressure / (numpy.sqrt(2) * numpy.pi * MODULUS * slope)
        full = 1 - 3 / (2 * numpy.pi) * (1 - x)
        joined = numpy.pi * (3 * x / (8 * numpy.pi)) ** (2 / 3) * (1 - x**1.51) + full * x**1.04
        pressure /= joined if x < 0.8 else min(full, 1)
        areas.append(PRESSURE / pressure)
    return numpy.array(areas)


TASKS = {
    "50 loads on elastic spheres (Greenwood & Williamson)": (states_ours, states_theirs),
    "area at 20,000 cutoffs (Persson)": (persson_ours, persson_theirs),
    "area at 20,001 scales (Archard's stack of elastic sinusoids)": (stack_ours, stack_theirs),
}


def shortest(function):
    best, spent = float("inf"), 0.0
    while spent < SECONDS:
        start = time.process_time()
        answer = function()
        took = time.process_time() - start
        best, spent = min(best, took), spent + took
    return answer, best


def lines(function):
    """Lines of a function without its head."""
    return len([line for line in inspect.getsource(function).splitlines()[1:] if line.strip()])


def main():
    print("task,lines,their_lines,seconds,their_seconds,differ")
    for task, (ours, theirs) in TASKS.items():
        (found, own_s), (other, their_s) = shortest(ours), shortest(theirs)
        differ = abs(found / other - 1).max()
        print(f'"{task}",{lines(ours)},{lines(theirs)},{own_s:.2e},{their_s:.2e},{differ:.1e}', flush=True)


if __name__ == "__main__":
    main()
