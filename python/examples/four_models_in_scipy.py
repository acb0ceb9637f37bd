"""Four statistical models in numpy and scipy, as a careful reader of the papers writes them in sixty lines."""

import math

from scipy.integrate import quad
from scipy.optimize import brentq


def hertz(E, nu, S, R, eta):
    Es = E / (1 - nu**2)
    return (lambda w: 4 / 3 * Es * math.sqrt(R) * eta * w**1.5, lambda w: math.pi * R * eta * w, [])


def ep_sphere(E, nu, S, R, eta):
    Es, C = E / (1 - nu**2), 1.295 * math.exp(0.736 * nu)
    wc, B = (math.pi * C * S / (2 * Es)) ** 2 * R, 0.14 * math.exp(23 * S / Es)
    Fc = 2 / 3 * C * S * math.pi * R * wc
    area = lambda w: min(math.pi * R * w * (max(w / wc / 1.9, 1) ** B), math.pi * R**2)

    def force(w):
        v = w / wc
        if v < 1.9:
            return 4 / 3 * Es * math.sqrt(R) * w**1.5
        a_over_R = math.sqrt(area(w) / math.pi) / R
        H_over_S = 2.84 * -math.expm1(-0.82 * a_over_R**-0.7)
        return Fc * (math.exp(-0.25 * v ** (5 / 12)) * v**1.5 + 4 * H_over_S / C * -math.expm1(-0.04 * v ** (5 / 9)) * v)

    full = wc * 1.9 * (R / (1.9 * wc)) ** (1 / (1 + B))
    return (lambda w: eta * force(w), lambda w: eta * area(w), [1.9 * wc, full])


def elastic_sine(E, nu, S, R, eta):
    wavelength = math.sqrt(2 / eta)
    amplitude = (wavelength / (2 * math.pi)) ** 2 / R
    p_star = math.sqrt(2) * math.pi * E / (1 - nu**2) * amplitude / wavelength
    t = lambda w: 1.0 if w >= amplitude else -math.expm1(0.4 * math.log1p(-w / amplitude))

    def area_at(x):
        full = 1 - 3 / (2 * math.pi) * (1 - x)
        return full if x >= 0.8 else math.pi * (3 * x / (8 * math.pi)) ** (2 / 3) * (1 - x**1.51) + full * x**1.04

    kinks = [amplitude * (1 - (1 - math.sqrt(0.8)) ** 2.5), amplitude]
    return (lambda w: p_star * t(w) ** 2, lambda w: area_at(t(w) ** 2), kinks, p_star, amplitude / wavelength, t, area_at)


def ep_sine(E, nu, S, R, eta):
    p_el, _, kinks, p_star, aspect, t, area_at = elastic_sine(E, nu, S, R, eta)
    Es, C = E / (1 - nu**2), 1.295 * math.exp(0.736 * nu)
    r = aspect * 3 * math.pi * Es / (math.sqrt(2) * S * math.exp(2 * (nu + 1) / 3))
    if r <= 1:
        return p_el, lambda w: area_at(p_el(w) / p_star), kinks
    p_ep, a1, a2 = p_star * (11 / (4 * r + 7)) ** 0.6, -0.1 * math.log(r), (r - 1) ** 0.44 / 15 + 0.99 ** (0.44 * (r - 1)) - 0.5
    d, H = 3.8 * (Es * aspect / S) ** 0.11, Es * aspect
    light = 2 * ((C * S / (8 * H)) ** 2 / math.pi) ** (1 / (1 + d)) * (0.75 / (C * S)) ** (d / (1 + d))
    log_x = lambda log_t: brentq(lambda u: (a1 * math.exp(u) + a2) * u - log_t, log_t / min(a2, a1 + a2) - 1, 0.0, rtol=1e-15)
    force = lambda w: 0.0 if w <= 0 else min(p_el(w), p_ep * math.exp(log_x(math.log(t(w)))))

    def area(w):
        p, p_c = force(w), (C * S / 2) ** 3 / (6 * math.pi * H**2)
        x = min(p / p_ep, 1.0)
        flowing = light * p ** (d / (1 + d)) * (1 - x**1.51) + (1 - 3 / (2 * math.pi) * (1 - x)) * x**1.04
        return area_at(p / p_star) if p <= p_c else 1.0 if x >= 1 else min(1.0, flowing)

    return force, area, kinks


def state(law, sigma, d, tolerance=1e-10):
    """Pressure and area fraction at a separation d."""
    top, g = max(0.0, -d) + 12 * sigma, lambda w: math.exp(-0.5 * ((d + w) / sigma) ** 2) / (sigma * math.sqrt(2 * math.pi))
    points = [w for w in law[2] if 0 < w < top] or None
    both = [quad(lambda w: f(w) * g(w), 0, top, points=points, epsabs=0, epsrel=tolerance, limit=500)[0] for f in law[:2]]
    return both[0], min(both[1], 1.0)


def at_pressure(law, sigma, pressure, tolerance=1e-10):
    """Separation and area fraction under a pressure."""
    misfit = lambda d: math.log(state(law, sigma, d, tolerance)[0] / pressure)
    d = brentq(misfit, -4 * sigma, 12 * sigma, xtol=1e-12 * sigma)
    return d, state(law, sigma, d, tolerance)[1]
