"""Persson's theory at every cutoff of a spectrum, elastic and with a constant hardness, where run time is held against error.

The surface of the Contact-Mechanics Challenge from 0.1 mm to 0.1 um (roll-off at 20 um, Hurst exponent 0.8, rms gradient 1), 20
cutoffs in each decade, under E* = 25 MPa and a hardness of 10 MPa, which is the unit of all stresses. Shares come from
make_persson.py: images and eigenfunctions of 330 digits, which agree.

    python3 make_persson_states.py OUT [--jobs N]
"""
import argparse
import functools
import multiprocessing
import pathlib

from mpmath import erf, mp, sqrt

from make_persson import constant
from tables import INPUT_NOTE, as_double, write_table

COLUMNS = ["p_over_h", "s_over_h", "area_contact", "area_plastic", "area_elastic_theory"]
LOADS = ["0.0001", "0.01", "0.3"]
SPREAD_AT_THE_END = 1.25


def mean_square_gradient(wavenumber):
    """Of the waves from 1 to this wavenumber, up to a factor: constant up to the roll-off at 5, then self-affine."""
    flat = (min(wavenumber, 5.0) ** 4 - 1) / 4
    return flat + (5 ** 4 * ((wavenumber / 5) ** 0.4 - 1) / 0.4 if wavenumber > 5 else 0)


def spreads():
    """Spreads at 20 cutoffs in each decade from half the longest wavelength on, rounded to the digits that are printed."""
    cutoffs = [10 ** (at / 20) for at in range(6, 61)]
    end = mean_square_gradient(cutoffs[-1])
    return [f"{SPREAD_AT_THE_END * (mean_square_gradient(cutoff) / end) ** 0.5:.6g}" for cutoff in cutoffs]


def state(load, spread):
    contact, _, plastic, *_ = constant(load, spread)
    mp.dps = 50
    return [load, spread, contact, plastic, erf(as_double(load) / (sqrt(2) * as_double(spread)))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    with multiprocessing.Pool(given.jobs) as pool:
        rows = [row for load in LOADS for row in pool.imap(functools.partial(state, load), spreads())]
    comments = [
        "Persson's theory at the cutoffs of a spectrum: docs/theory/models.md. Stresses in units of the hardness.",
        INPUT_NOTE,
        "area_elastic_theory: without a hardness.",
    ]
    mp.dps = 20
    write_table(given.out / "persson_states.csv", comments, COLUMNS, rows)


if __name__ == "__main__":
    main()
