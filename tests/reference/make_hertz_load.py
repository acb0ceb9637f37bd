"""Makes crates/contact/stat-contact/src/gaussian/coefficients.rs, the polynomials of integrals over Gaussian heights.

The load of Gaussian asperities under Hertz's law is I(u) = Int_0^inf s^(3/2) exp(-(u+s)^2/2) ds, a parabolic cylinder
function. Here it is interpolated at Chebyshev points, stretch by stretch, with 60 digits, and written as powers:

    u >= 0       exp(u^2/2) I(u) (1 + u)^(5/2)   in t = (u - 3)/(u + 3)
    -3 <= u < 0  I(u)                            in t = -(u + 1.5)/1.5
    -6 <= u < -3 I(u)                            in t = -(u + 4.5)/1.5
    -9 <= u < -6 I(u)                            in t = -(u + 7.5)/1.5
    u < -9       I(u) (-u)^(-3/2)                in w = (9/u)^2

Their area is the first moment phi(u) - u Q(u): over phi(u) and times (1 + u)^2, it is the Chebyshev series in
t = (u - 5)/(u + 5), u >= 0, cut off after 26 terms.

    python3 make_hertz_load.py           writes the file
    python3 make_hertz_load.py --check   ends with 1 where the file is not what would be written

Needs mpmath.
"""
import sys
from pathlib import Path
import mpmath as mp

mp.mp.dps = 60
NU = mp.mpf(3) / 2


def load(u):
    """I(u), times exp(u^2/2) for positive u."""
    cylinder = mp.pcfd(-NU - 1, u)
    return mp.gamma(NU + 1) * cylinder * mp.exp(u * u / 4 if u > 0 else -u * u / 4)


def near(t):
    u = 3 * (1 + t) / (1 - t)
    if u < 1000:
        return load(u) * (1 + u) ** (NU + 1)
    term = lambda k: (-1) ** k * mp.rf(NU + 1, 2 * k) / (mp.factorial(k) * 2**k * u ** (2 * k))
    return mp.gamma(NU + 1) * mp.fsum(term(k) for k in range(14)) * (1 + 1 / u) ** (NU + 1)


def first_moment(t):
    u = 5 * (1 + t) / (1 - t)
    if u < 200:
        over_density = mp.erfc(u / mp.sqrt(2)) / 2 * mp.sqrt(2 * mp.pi) * mp.exp(u * u / 2)
        return (1 - u * over_density) * (1 + u) ** 2
    return mp.fsum((-1) ** k * mp.fac2(2 * k + 1) / u ** (2 * k + 2) for k in range(30)) * (1 + u) ** 2


def within(middle):
    return lambda t: load(-(middle + mp.mpf(3) / 2 * t))


def far(t):
    w = (1 + t) / 2
    a = 9 / mp.sqrt(w)
    if a < 1000:
        return load(-a) / a**NU
    term = lambda k: mp.ff(NU, 2 * k) / (mp.factorial(k) * 2**k * a ** (2 * k))
    return mp.sqrt(2 * mp.pi) * mp.fsum(term(k) for k in range(14))


def chebyshev(function, count):
    angles = [mp.pi * (2 * k + 1) / (2 * count) for k in range(count)]
    values = [function(mp.cos(angle)) for angle in angles]
    coefficient = lambda j: 2 * mp.fsum(v * mp.cos(j * a) for v, a in zip(values, angles)) / count
    return [coefficient(0) / 2] + [coefficient(j) for j in range(1, count)]


def powers(coefficients, of_w=False):
    """The same polynomial in powers of t, or of w = (1 + t)/2."""
    argument = [mp.mpf(-1), mp.mpf(2)] if of_w else [mp.mpf(0), mp.mpf(1)]

    def times(a, b):
        product = [mp.mpf(0)] * (len(a) + len(b) - 1)
        for i, x in enumerate(a):
            for j, y in enumerate(b):
                product[i + j] += x * y
        return product

    before, last = [mp.mpf(1)], argument
    total = [mp.mpf(0)] * len(coefficients)
    for j, c in enumerate(coefficients):
        polynomial = before if j == 0 else last
        for i, x in enumerate(polynomial):
            total[i] += c * x
        if j > 0:
            doubled = [2 * x for x in times(argument, last)]
            before, last = last, [x - (before[i] if i < len(before) else 0) for i, x in enumerate(doubled)]
    return total


# Name, function, number of Chebyshev points, number of coefficients, whether in powers of w, what it is.
STRETCHES = [
    ("NEAR", near, 32, 32, False,
     ["In t = (u - 3)/(u + 3) for u >= 0: the load over exp(-u^2/2), times (1 + u)^(5/2)."]),
    ("FROM_0_TO_3", within(mp.mpf(3) / 2), 24, 24, False, ["In t = -(u + 1.5)/1.5 for -3 <= u < 0: the load."]),
    ("FROM_3_TO_6", within(mp.mpf(9) / 2), 24, 24, False, ["In t = -(u + 4.5)/1.5 for -6 <= u < -3: the load."]),
    ("FROM_6_TO_9", within(mp.mpf(15) / 2), 20, 20, False, ["In t = -(u + 7.5)/1.5 for -9 <= u < -6: the load."]),
    ("FAR", far, 12, 12, True, ["In w = (9/u)^2 for u < -9: the load over (-u)^(3/2)."]),
    ("FIRST_MOMENT", first_moment, 40, 26, False,
     ["In t = (u - 5)/(u + 5) for u >= 0: phi(u) - u Q(u) over phi(u), times (1 + u)^2; filled up with zeros to make up",
      "fours."]),
]

PATH = Path(__file__).parents[2] / "crates/contact/stat-contact/src/gaussian/coefficients.rs"


def literal(value):
    """The shortest decimal of a double, its digits in threes after the point."""
    mantissa, _, exponent = repr(float(value)).partition("e")
    whole, _, digits = mantissa.partition(".")
    threes = "_".join(digits[i:i + 3] for i in range(0, len(digits), 3))
    return f"{whole}.{threes}" + (f"e{exponent}" if exponent else "")


def generated():
    lines = ["// Made by tests/reference/make_hertz_load.py; do not edit.",
             "",
             "//! Coefficients of the polynomials that stand for integrals over Gaussian heights, lowest power first."]
    for name, function, points, count, of_w, description in STRETCHES:
        values = [literal(value) for value in powers(chebyshev(function, points)[:count], of_w)]
        values += ["0.0"] * (-count % 4)
        lines += ["", *(f"/// {line}" for line in description)]
        lines += [f"pub const {name}: [f64; {len(values)}] = [", *(f"    {value}," for value in values), "];"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    text = generated()
    if sys.argv[1:] == ["--check"]:
        if PATH.read_text() != text:
            sys.exit(f"{PATH} is not what {Path(__file__).name} makes")
    else:
        PATH.write_text(text)
