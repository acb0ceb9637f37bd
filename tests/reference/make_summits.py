"""States of the summits of Gaussian surfaces (docs/theory/models.md, section 3.6): summits.csv, and elliptic averages.

    python3 make_summits.py OUT [--jobs N]

The integral over the ellipticity is taken over -ln(b/a) of the contact ellipse, K and E being mpmath's; that over the mean
curvature over panels between the points around which it bends; heights are parabolic cylinder and error functions, or their
series beyond thirty standard deviations. Two schemes, of different panels, nodes and digits; needs mpmath. About ten minutes.
"""
import argparse
import functools
import multiprocessing
import pathlib

from mpmath import ellipe, ellipk, erfc, exp, ff, fac, gamma, mp, mpf, pcfd, pi, rf, sqrt

from tables import INPUT_NOTE, write_table

STATES = {
    "1.5": ["-30", "-1.25", "0", "0.5", "3", "40"],
    "1.5000001": ["-2", "0.25", "4", "30"],
    "1.502": ["-40", "0", "1", "50"],
    "1.6": ["-3", "0", "2.5", "9", "60"],
    "2": ["-8", "-1", "0", "1", "4", "20"],
    "3.7": ["-0.001", "0.001", "1.7", "30"],
    "7.3": ["-5", "0.3", "5", "33"],
    "31": ["-12", "-0.7", "0", "3.3", "8.5"],
    "139.8": ["0", "2", "6", "30"],
    "1e4": ["-6", "0", "0.9", "2.2", "14", "60"],
    "2.5e6": ["-1", "0.4", "3", "30"],
    "1e12": ["-25", "0", "1.5", "5", "18"],
}


@functools.cache
def rule(count, digits):
    """Gauss-Legendre nodes and weights on [-1, 1] by Newton's method."""
    with mp.workdps(digits + 10):
        pairs = []
        for i in range(count):
            x = mp.cos(pi * (i + mpf(3) / 4) / (count + mpf(1) / 2))
            for _ in range(12):
                before, last = mpf(1), x
                for k in range(1, count):
                    before, last = last, ((2 * k + 1) * x * last - k * before) / (k + 1)
                slope = count * (before - x * last) / (1 - x * x)
                x -= last / slope
            pairs.append((x, 2 / ((1 - x * x) * slope**2)))
        return pairs


def over(low, high, count, digits):
    middle, half = (low + high) / 2, (high - low) / 2
    return [(middle + half * x, half * w) for x, w in rule(count, digits)]


@functools.cache
def ellipses(count, digits, ends):
    """(rho^2, rho (1 - rho^2) factor d rho) for area and force."""
    with mp.workdps(digits + 25):
        nodes = []
        for low, high in zip(ends, ends[1:]):
            for y, weight in over(mpf(low), mpf(high), count, digits + 25):
                q = exp(-y)
                k = sqrt(1 - q * q)
                first, second = ellipk(k * k), ellipe(k * k)
                a, b = first - second, second / q**2 - first
                # derivatives by k, and k dk = q^2 dy
                da = (a + b) / k
                db = -a / (k * q**2) + 2 * k * second / q**4 - b / k
                rho = (b - a) / (b + a)
                slope = 2 * (a * db - b * da) / (a + b) ** 2 * q**2 / k
                base = weight * slope * rho * (1 - rho**2)
                nodes.append((rho**2, base * second / (first * q),
                              base * pi / 2 * sqrt(second / first**3) / q))
        return nodes


def averages(x, scheme):
    nodes = ellipses(scheme["inner"], scheme["digits"], scheme["ends"])
    shares = [exp(-x * rho2) for rho2, _, _ in nodes]
    return (mp.fsum(s * area for s, (_, area, _) in zip(shares, nodes)),
            mp.fsum(s * force for s, (_, _, force) in zip(shares, nodes)))


FAR = 30


def mean_power(power, h):
    """Int_0^inf w^power exp(-(h + w)^2/2) dw/sqrt(2 pi), the mean of (Z - h)_+^power."""
    if h < -FAR:
        return mp.fsum(ff(power, 2 * k) / (fac(k) * 2**k) * (-h) ** (power - 2 * k)
                       for k in range(60))
    if h > FAR:
        series = mp.fsum((-1) ** k * rf(power + 1, 2 * k) / (fac(k) * 2**k * h ** (2 * k))
                         for k in range(60))
        return gamma(power + 1) * h ** (-power - 1) * exp(-h * h / 2) / sqrt(2 * pi) * series
    if power == 1:
        return exp(-h * h / 2) / sqrt(2 * pi) - h * erfc(h / sqrt(2)) / 2
    return gamma(power + 1) * pcfd(-power - 1, h) * exp(-h * h / 4) / sqrt(2 * pi)


def interferences(t, u, alpha):
    """Means of w and w^(3/2) of the summits of mean curvature t, in sqrt(m4), at the separation u."""
    mean, spread = 3 * t / (2 * sqrt(alpha)), sqrt(1 - 3 / (2 * alpha))
    if spread == 0:
        below = max(mean - u, mpf(0))
        return below, below ** (mpf(3) / 2)
    h = (u - mean) / spread
    return spread * mean_power(mpf(1), h), spread ** (mpf(3) / 2) * mean_power(mpf(3) / 2, h)


def ends_of_panels(u, alpha, scheme):
    """Around the Gaussian of flat summits, the bend, and the decay among sharp ones."""
    spread = sqrt(1 - 3 / (2 * alpha))
    edge, bend = 2 * sqrt(alpha) * u / 3, 2 * sqrt(alpha) * spread / 3
    points = {mpf(0)}
    if u > 0:
        peak = u / sqrt(alpha)
        points |= {peak + n * spread for n in scheme["deviations"]}
        decay = min(mpf(1), 1 / (sqrt(alpha) * u))
        points |= {edge + decay * n for n in scheme["decay"]}
    points |= {mpf(n) for n in scheme["curvatures"]}
    if bend > 0:
        for k in range(scheme["bends"]):
            points |= {edge + sign * bend * scheme["first"] * scheme["ratio"] ** k for sign in (-1, 1)}
    else:
        reach = 1 / (1 + abs(u))
        points |= {edge} | {edge + reach * mpf(4) ** -k for k in range(scheme["bends"] + 12)}
    top = max(mpf(12), edge + 90 * decay) if u > 0 else mpf(12)
    if bend == 0:
        points = {p for p in points if p >= edge}
    return sorted({p for p in points if 0 <= p <= top} | {max(mpf(0), edge) if bend == 0 else mpf(0)})


def state(alpha, u, scheme):
    """A/A0 and p/(E* sqrt(m2))."""
    with mp.workdps(scheme["digits"]):
        points = ends_of_panels(u, alpha, scheme)
        area = load = mpf(0)
        for low, high in zip(points, points[1:]):
            # over the root of the distance from the lower end, for what begins there with a half power
            for v, weight in over(mpf(0), sqrt(high - low), scheme["outer"], scheme["digits"]):
                t = low + v * v
                w, w_three_halves = interferences(t, u, alpha)
                of_area, of_force = averages(3 * t * t / 2, scheme)
                density = 2 * v * weight * sqrt(3 / (4 * pi)) * exp(-3 * t * t / 4)
                area += density * t**3 * of_area * w
                load += density * t ** (mpf(7) / 2) * of_force * w_three_halves
        return (3 * sqrt(alpha) / 2 * area, 2 / pi * alpha ** (mpf(3) / 4) * load)


SCHEMES = (
    {"digits": 30, "inner": 28, "ends": ("0", "0.02", "0.08", "0.3", "1", "3", "9", "40"), "outer": 22,
     "deviations": (-11, -8, -5, -3, -1, 1, 3, 5, 8, 11), "decay": (0, 1, 4, 12, 35, 90),
     "curvatures": (1, 2, 4, 7, 12), "bends": 14, "first": mpf(3), "ratio": mpf(4)},
    {"digits": 36, "inner": 34, "ends": ("0", "0.03", "0.1", "0.4", "1.3", "4", "12", "50"), "outer": 26,
     "deviations": (-12, -9, -6, -4, -2, 0, 2, 4, 6, 9, 12), "decay": (0, 2, 7, 20, 50, 90),
     "curvatures": (0.7, 1.5, 3, 5, 8, 12), "bends": 18, "first": mpf(2), "ratio": mpf(3)},
)


def row(point):
    alpha, u = point
    mp.dps = 40
    results = [state(mpf(float(alpha)), mpf(float(u)), scheme) for scheme in SCHEMES]
    agreement = max(abs(a / b - 1) for a, b in zip(*results))
    return [alpha, u, *results[1], mp.nstr(agreement, 2)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    points = [(alpha, u) for alpha, separations in STATES.items() for u in separations]
    with multiprocessing.Pool(arguments.jobs) as pool:
        rows = pool.map(row, points, chunksize=1)
    write_table(arguments.output / "summits.csv",
                ["Summits of Gaussian surfaces under Hertz's ellipses (Bush, Gibson & Thomas): "
                 "docs/theory/models.md, section 3.6.", INPUT_NOTE,
                 "Computed with mpmath by two schemes of 30 and 36 digits with different panels; printed with 20 digits.",
                 "agreement: larger relative deviation between the two schemes. Areas are not held at 1."],
                ["alpha", "d_over_sqrt_m0", "area_fraction", "pressure_over_e_sqrt_m2", "agreement"], rows)
    print(len(rows), "rows, worst agreement", max(float(row[-1]) for row in rows))


if __name__ == "__main__":
    main()
