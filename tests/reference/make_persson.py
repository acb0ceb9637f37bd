"""Persson's theory of constant and of growing hardness.

Constant hardness by eigenfunctions and by images, of which the better conditioned is kept once they agree; growing
hardness, H^2 = H0^2 + c V, by Kummer's functions.

    python3 make_persson.py OUT [--jobs N]
"""
import argparse
import multiprocessing
import pathlib

from mpmath import erf, erfc, exp, findroot, hyp1f1, log1p, mp, mpf, npdf, pi, quad, sin, sqrt

from tables import INPUT_NOTE, as_double, write_table

COLUMNS = ["kind", "p_pa", "s_pa", "h0_pa", "c", "area_contact", "area_elastic", "area_plastic", "area_gap",
           "density_at_0p9_h_per_pa", "agreement"]
CONSTANT = [(p, s) for p in ("1e-10", "0.003", "0.5", "0.8", "0.9999999") for s in ("0.03", "0.12", "0.499", "0.8", "3.0")]
GROWING = [("1e-8", "0.7", "0.7"), ("0.02", "0.4", "4"), ("0.3", "2.0", "1e-4"), ("0.75", "0.5", "20"),
           ("0.9999999", "0.6", "0.7"), ("0.9999999", "0.6", "100"), ("0.1", "18.0", "100"), ("0.1", "18.0", "4"),
           ("0.5", "1.0", "0.01")]


def constant(p, s):
    """Shares of the nominal area for H = 1."""
    mp.dps = 50
    p, s = as_double(p), as_double(s)
    v = s * s
    b, h = p / (sqrt(2) * s), 1 / (sqrt(2) * s)

    def images():
        d = lambda j: erfc(j * h - b) - erfc(j * h + b)
        count = 4 + int(40 * s)
        plastic = sum(d(j) for j in range(1, 2 * count, 2))
        contact = erf(b) + sum(d(j) for j in range(2, 2 * count, 2))
        at = mpf("0.9")
        density = sum(npdf(at - p - 2 * k, 0, s) - npdf(at + p - 2 * k, 0, s) for k in range(-count, count + 1))
        return contact, plastic, density

    def modes():
        count = 4 + int(16 / s)
        e = lambda n: exp(-n * n * pi**2 * v / 2)
        contact = p + 2 / pi * sum(sin(n * pi * p) / n * e(n) for n in range(1, count))
        plastic = p + 2 / pi * sum((-1) ** n * sin(n * pi * p) / n * e(n) for n in range(1, count))
        density = 2 * sum(sin(n * pi * p) * sin(n * pi * mpf("0.9")) * e(n) for n in range(1, count))
        return contact, plastic, density

    mp.dps = 330
    one, other = images(), modes()
    agreement = max(abs(a / b - 1) for a, b in zip(one, other))
    contact, plastic, density = one if s < mpf("0.5") else other
    result = [contact, contact - plastic, plastic, 1 - contact, density]
    mp.dps = 50
    return [+x for x in result] + [+agreement]


def eigenvalues(c, elapsed):
    """Zeros in lambda of M(lambda/c + 1/2, 3/2, -c/2), by steps narrower than their distance, while modes matter."""
    shape = lambda x: hyp1f1(x * x / c + mpf(1) / 2, mpf(3) / 2, -c / 2)
    largest = sqrt(48 / elapsed) + 6
    step = mpf("0.3")
    x, found = step, []
    before = shape(x)
    while x < largest:
        after = shape(x + step)
        if before * after < 0:
            found.append(findroot(shape, (x, x + step), solver="anderson", tol=mpf(10) ** (-mp.dps + 8)) ** 2)
        x, before = x + step, after
    return found


def growing(p, s, c):
    # The weight grows to exp(c/2), and the sums cancel by as much.
    mp.dps = 26 + int(float(c) / 3)
    p, s, c = as_double(p), as_double(s), as_double(c)
    elapsed = log1p(c * s * s) / c
    root = sqrt(c / 2)
    # C/p less its final form, and its slopes at both ends, mode by mode.
    contact = 2 / sqrt(pi) * root / erf(root)
    plastic = contact * exp(-c / 2)
    w = lambda y: exp(c * y * y / 2)
    smallest = None
    for value in eigenvalues(c, elapsed):
        a = value / c + mpf(1) / 2
        f = lambda y: y * hyp1f1(a, mpf(3) / 2, -c * y * y / 2)
        pieces = int(sqrt(2 * value) / pi) + 2
        grid = [mpf(i) / pieces for i in range(pieces + 1)]
        norm = quad(lambda y: w(y) * f(y) ** 2, grid)
        up_to_p = [p * t for t in grid]
        moment = quad(lambda y: y * w(y) * f(y), up_to_p)
        coefficient = -(w(p) * f(p) - c * moment) / (2 * value * norm) * exp(-value * elapsed) / p
        slope_at_one = hyp1f1(a, mpf(3) / 2, -c / 2) - c * 2 * a / 3 * hyp1f1(a + 1, mpf(5) / 2, -c / 2)
        contact -= coefficient
        plastic -= coefficient * slope_at_one
        smallest = abs(coefficient)
    now = sqrt(1 + c * s * s)
    contact, plastic = contact * p / now, plastic * p / now
    return [contact, contact - plastic, plastic, 1 - contact, None, smallest or mpf(0)]


def of_case(case):
    kind, values = case
    if kind == "constant":
        p, s = values
        return [kind, p, s, "1", None, *constant(p, s)]
    p, s, c = values
    return [kind, p, s, "1", c, *growing(p, s, c)]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    cases = ([("constant", case) for case in CONSTANT] + [("growing", case) for case in GROWING])
    with multiprocessing.Pool(given.jobs) as pool:
        rows = list(pool.imap(of_case, cases))
    comments = [
        "Persson's theory: docs/theory/models.md. H0 = 1.",
        INPUT_NOTE,
        "agreement: relative deviation between images and eigenfunctions; of growing hardness the last mode left in.",
    ]
    mp.dps = 20
    write_table(given.out / "persson.csv", comments, COLUMNS, rows)


if __name__ == "__main__":
    main()
