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
PRESSURES = numpy.geomspace(1e4, 1e8, 1000)
FEW = PRESSURES[::20]
HEIGHTS = 1e-9 * numpy.random.default_rng(1).standard_normal((1024, 1024)).cumsum(axis=1)
SIZE = 10e-6
WAVEVECTORS = numpy.geomspace(1e5, 1e10, 20001)
SPECTRUM = 1e-2 * WAVEVECTORS**-2.6
SURFACE = truearea.Spectrum(2 * numpy.pi / WAVEVECTORS, SPECTRUM)
SCALES = 2001
STACK = SURFACE.amplitudes()


def states_ours():
    states = truearea.contact(
        model="hertz", radius=RADIUS, density=DENSITY, sigma_s=SIGMA, material=STEEL, pressure=FEW, tolerance=1e-10
    )
    return states.area_fraction


def states_theirs():
    def moment(u, power):
        density = lambda s: s**power * numpy.exp(-0.5 * (u + s) ** 2) / numpy.sqrt(2 * numpy.pi)
        return quad(density, 0, max(0, -u) + 9, epsabs=0, epsrel=1e-10)[0]

    scale = 4 / 3 * MODULUS * DENSITY * RADIUS**0.5 * SIGMA**1.5
    at = [brentq(lambda u: numpy.log(scale * moment(u, 1.5) / pressure), -5, 8) for pressure in FEW]
    return numpy.pi * DENSITY * RADIUS * SIGMA * numpy.array([moment(u, 1) for u in at])


def spectrum_ours():
    spectrum = truearea.Spectrum.from_heights(
        HEIGHTS, size=SIZE, detrend="none", window="none", tip_radius="1 nm", bins_per_decade=0
    )
    return spectrum.c1d_m3[:100]


def spectrum_theirs():
    columns = HEIGHTS.shape[1]
    waves = numpy.fft.rfft(HEIGHTS - HEIGHTS.mean(), axis=1)[:, 1:101]
    power = (numpy.abs(waves) ** 2).mean(axis=0)
    return power * SIZE / columns**2 * 2 / (2 * numpy.pi)


def persson_ours():
    curve = truearea.persson(SURFACE, STEEL, pressure=1e7, band="1d")
    return curve.area_fraction[0, 1000:]


def persson_theirs():
    integrand = WAVEVECTORS**3 * SPECTRUM
    steps = 0.5 * (integrand[1:] + integrand[:-1]) * numpy.diff(numpy.log(WAVEVECTORS))
    gradient = numpy.sqrt(2 * numpy.cumsum(steps))
    return erf(1e7 / (numpy.sqrt(2) * 0.5 * MODULUS * gradient))[999:]


TASKS = {
    "50 loads on elastic spheres": (states_ours, states_theirs),
    "spectrum of 1024² heights": (spectrum_ours, spectrum_theirs),
    "area at 20,000 cutoffs, Persson": (persson_ours, persson_theirs),
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
    for task, (ours, theirs) in TASKS.items():
        (a, own), (b, other) = shortest(ours), shortest(theirs)
        print(task, own, other, lines(ours), lines(theirs), a[:3], b[:3], abs(a / b - 1).max() if len(a)==len(b) else (len(a), len(b)))


if __name__ == "__main__":
    main()
