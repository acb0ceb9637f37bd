"""Coefficients of crates/stat-contact/src/hertz_load.rs.

The load of Gaussian asperities under Hertz's law is I(u) = Int_0^inf s^(3/2) exp(-(u+s)^2/2) ds, a parabolic cylinder
function. Here it is interpolated at Chebyshev points, stretch by stretch, with 60 digits, and written as powers:

    u >= 0       exp(u^2/2) I(u) (1 + u)^(5/2)   in t = (u - 3)/(u + 3)
    -3 <= u < 0  I(u)                            in t = -(u + 1.5)/1.5
    -6 <= u < -3 I(u)                            in t = -(u + 4.5)/1.5
    -9 <= u < -6 I(u)                            in t = -(u + 7.5)/1.5
    u < -9       I(u) (-u)^(-3/2)                in w = (9/u)^2

Needs mpmath. Prints Rust.
"""
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


STRETCHES = [
    ("NEAR", near, 32, False),
    ("FROM_0_TO_3", within(mp.mpf(3) / 2), 24, False),
    ("FROM_3_TO_6", within(mp.mpf(9) / 2), 24, False),
    ("FROM_6_TO_9", within(mp.mpf(15) / 2), 20, False),
    ("FAR", far, 12, True),
]

if __name__ == "__main__":
    for name, function, count, of_w in STRETCHES:
        found = chebyshev(function, count)
        print(f"/// The last Chebyshev coefficient is {mp.nstr(abs(found[-1]) / abs(found[0]), 1)} of the first.")
        print(f"const {name}: [f64; {count}] = [")
        for value in powers(found, of_w):
            print(f"    {float(value)!r},")
        print("];")
