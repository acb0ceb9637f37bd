"""A second road to part of the statistical table, sharing no quadrature with the first.

* hertz: closed form with parabolic cylinder functions (docs/theory/models.md, section 3).
* ep-sine without strain gradient: integral over x = p/p*_ep, where the
  interference is explicit, so that neither inversion nor search is involved.
* ep-sphere without strain gradient: library quadrature between explicit kinks.
* ep-sphere and ep-sine with strain gradient: a plain midpoint rule in doubles
  over ln w, good to a few digits; catches gross mistakes only.  The elastic sinusoid too.
"""
import argparse
import multiprocessing
import pathlib

from mpmath import mp, mpf, pi, sqrt, exp, log, gamma, pcfd, expm1

from asperity import Sinusoid
from statistical import (SineAsperity, PlasticSphere, THRESHOLD, bisect, integration_range,
                         make_asperity, surface_from)
from tables import WORKING_DIGITS, as_double, read_table


def hertz_closed_form(surface, d):
    def moment(n):
        u = d / surface.sigma
        return (surface.sigma**n * gamma(n + 1) / sqrt(2 * pi) * exp(-u * u / 4)
                * pcfd(-n - 1, u))
    pressure = (surface.density * mpf(4) / 3 * surface.e_star * sqrt(surface.radius)
                * moment(mpf(3) / 2))
    area = surface.density * pi * surface.radius * moment(1)
    return pressure, min(mpf(1), area)


def gaussian(surface, d, w):
    return exp(-(((d + w) / surface.sigma) ** 2) / 2) / (surface.sigma * sqrt(2 * pi))


def ladder(surface, d, low, high):
    """Panels that follow the Gaussian weight."""
    u0 = max(mpf(0), d) / surface.sigma
    step = 3 * surface.sigma / max(mpf(1), u0)
    points, w = [], low
    while w < high:
        points.append(w)
        w += step
    return points + [high]


def quad_both(function, points):
    """Integrals of both components; scaled, because mp.quad's tolerance is absolute."""
    points = sorted(set(points))
    middles = [function((a + b) / 2) for a, b in zip(points, points[1:])]
    result = []
    for i in (0, 1):
        scale = max(abs(m[i]) * (b - a) for m, a, b in zip(middles, points, points[1:]))
        result.append(scale * mp.quad(lambda v: function(v)[i] / scale, points))
    return result


def sphere_by_quad(surface, d):
    asperity = PlasticSphere(surface)
    low, high = integration_range(surface.sigma, d)
    ball = asperity.ball(mpf(1), fixed=True)
    yields = THRESHOLD * ball.w_c
    # w' (w'/1.9)^b = R/w_c beyond yield, w = R before it
    capped = ball.w_c * exp((log(surface.radius / ball.w_c) + ball.b * log(THRESHOLD))
                            / (1 + ball.b))
    kinks = [yields, capped if capped > yields else surface.radius, surface.radius]
    points = ladder(surface, d, low, high) + [k for k in kinks if low < k < high]
    w = min(kinks) / 100
    while w < high:
        points += [w] if w > low else []
        w *= 10

    def integrand(w):
        weight = gaussian(surface, d, w) * surface.density
        return weight * ball.force(w), weight * ball.capped_area(w)

    pressure, area = quad_both(integrand, points)
    return pressure, min(mpf(1), area)


def sine_by_pressure(surface, d):
    """Integral over u = ln x; needs r > 1 and no strain gradient.

    The branch p = p_el holds where the elastic pressure is the smaller one;
    which parts of the range those are is decided by a scan in u.
    """
    asperity = SineAsperity(surface, True)
    wave, amplitude = asperity.fixed, asperity.amplitude
    low, high = integration_range(surface.sigma, d)

    def interference(u):
        log_t = (wave.a1 * exp(u) + wave.a2) * u
        return amplitude * -expm1(mpf(5) / 2 * log(-expm1(log_t)))

    def slope(u):
        e_u = exp(u)
        log_t = (wave.a1 * e_u + wave.a2) * u
        t = exp(log_t)
        return (amplitude * mpf(5) / 2 * (-expm1(log_t)) ** (mpf(3) / 2) * t
                * (wave.a1 * e_u * (1 + u) + wave.a2))

    def pressure(u):
        t = exp((wave.a1 * exp(u) + wave.a2) * u)
        return min(wave.p_star * t**2, wave.p_star_ep * exp(u))

    def integrand(u):
        w, p = interference(u), pressure(u)
        weight = gaussian(surface, d, w) * slope(u)
        return weight * p, weight * wave.phi(p)

    # x from very small (nothing lies below) to one, i.e. w up to Delta
    bottom = mpf(-130) / wave.a2
    tests = (lambda u: wave.p_star * exp(2 * (wave.a1 * exp(u) + wave.a2) * u)
             > wave.p_star_ep * exp(u),
             lambda u: pressure(u) > wave.p_critical,
             lambda u: pressure(u) < wave.p_star_ep
             and wave.phi_plastic_unclamped(pressure(u)) >= 1,
             lambda u: pressure(u) > wave.p_star * mpf(8) / 10)
    grid = [bottom * (mpf(1) - mpf(i) / 400) ** 3 for i in range(400)]
    grid = sorted({*grid, *(-mpf(10) ** -k for k in range(1, 30))})
    points = {bottom, mpf(0)}
    for test in tests:
        states = [test(u) for u in grid]
        for u1, u2, s1, s2 in zip(grid, grid[1:], states, states[1:]):
            if s1 != s2:
                points.add(bisect(test, u1, u2, s1))
    for w in ladder(surface, d, low, high):
        if 0 < w < amplitude:
            points.add(bisect(lambda u: interference(u) > w, bottom, -mpf(10) ** -60, False))
    points.update(bottom * mpf(2) ** -k for k in range(1, 14))
    totals = quad_both(integrand, list(points))
    # complete contact, w > Delta: constant
    tail = mp.erfc((d + amplitude) / surface.sigma / sqrt(mpf(2))) / 2
    return totals[0] + wave.p_star_ep * tail, min(mpf(1), totals[1] + tail)


def crude(model, surface, d, cells=3000):
    mp.dps = 17
    asperity = make_asperity(model, surface)
    low, high = integration_range(surface.sigma, d)
    low = max(low, high * mpf(10) ** -9)
    step = log(high / low) / cells
    totals = [0.0, 0.0]
    for i in range(cells):
        w = low * exp(step * (i + mpf(1) / 2))
        weight = gaussian(surface, d, w) * w * step
        for j, v in enumerate(asperity.response(w)):
            totals[j] += weight * v
    return totals[0], min(1, totals[1])


def one(item):
    index, row = item
    mp.dps = WORKING_DIGITS
    surface, d = surface_from(row, as_double)
    mp.dps = 20
    model, length = row["model"], row["strain_gradient_length_m"]
    given = mpf(row["pressure_pa"]), mpf(row["area_fraction"])
    if model == "hertz":
        kind, values = "closed form", hertz_closed_form(surface, d)
    elif length:
        kind, values = "crude", crude(model, surface, d)
    elif model == "ep-sphere":
        kind, values = "quad in w", sphere_by_quad(surface, d)
    elif model == "ep-sine" and SineAsperity(surface, True).fixed.plastic:
        kind, values = "integral over x", sine_by_pressure(surface, d)
    else:
        kind, values = "crude", crude(model, surface, d)
    return model, kind, index, max(float(abs(v / g - 1)) for v, g in zip(values, given))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1, help="take every n-th row")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    rows = read_table(arguments.table)
    worst = {}
    with multiprocessing.Pool(arguments.jobs) as pool:
        for model, kind, index, error in pool.imap_unordered(
                one, list(enumerate(rows))[::arguments.every]):
            print(model, kind, index, f"{error:.1e}", flush=True)
            worst.setdefault((model, kind), []).append((error, index))
    for key, errors in worst.items():
        errors.sort(reverse=True)
        print(*key, len(errors), "rows, largest deviations",
              ", ".join(f"{e:.1e} (row {i})" for e, i in errors[:4]))


if __name__ == "__main__":
    main()
