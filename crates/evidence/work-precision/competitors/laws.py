"""The asperity laws of docs/theory/models.md as a user of numpy and scipy writes them.

Interferences are in units of sigma; every law gives pressure and area fraction per
asperity height, that is force and area times the density of asperities. The scalar
forms are for adaptive quadrature and use `math`, three times as fast as numpy on
single numbers; the array forms are for fixed grids.
"""
import math

import numpy as np
from scipy.optimize import brentq

JUMP = 1.9


def law_of(case):
    spheres = {"hertz": Hertz, "ep-sphere": PlasticSphere}
    sinusoids = {"elastic-sine": ElasticSine, "ep-sine": PlasticSine}
    return {**spheres, **sinusoids}[case["model"]](case)


class Law:
    def __init__(self, case):
        self.sigma = case["sigma_s_m"]
        self.radius = case["radius_m"]
        self.density = case["density_per_m2"]
        self.nu = case["poisson_ratio"]
        self.modulus = case["youngs_modulus_pa"] / (1 - self.nu**2)
        self.strength = case["yield_strength_pa"]
        self.length = case.get("strain_gradient_length_m") or 0.0
        self.c = 1.295 * math.exp(0.736 * self.nu)

    def breaks(self):
        """Where the law bends or jumps, in units of sigma."""
        return []


class Hertz(Law):
    def __init__(self, case):
        super().__init__(case)
        self.force = (self.density * 4 / 3 * self.modulus * math.sqrt(self.radius)
                      * self.sigma**1.5)
        self.touching = self.density * math.pi * self.radius * self.sigma

    def pressure(self, s):
        return self.force * s * math.sqrt(s)

    def area(self, s):
        return self.touching * s

    def arrays(self, s):
        return self.force * s * np.sqrt(s), self.touching * s


class PlasticSphere(Hertz):
    def strength_and_critical(self, s, sqrt=math.sqrt):
        """The strength at an interference and the critical interference, in sigma, that it makes."""
        strength = self.strength
        if self.length:
            strength = strength * sqrt(1 + self.length / (s * self.sigma))
        return strength, (math.pi * self.c * strength / (2 * self.modulus))**2 * self.radius / self.sigma

    def onset(self):
        plain = (math.pi * self.c * self.strength / (2 * self.modulus))**2 * self.radius
        half = JUMP * plain / 2
        return (half + math.sqrt(half**2 + 2 * half * self.length)) / self.sigma

    def breaks(self):
        onset, whole = self.onset(), self.radius / self.sigma
        if whole <= onset:
            return [whole, onset]
        cap = brentq(lambda s: self.log_share(s), onset, whole * (1 + 1e-9), rtol=1e-15, xtol=1e-300)
        return [onset, cap]

    def log_share(self, s):
        """ln of the area over the sphere's cross section, beyond yielding."""
        strength, critical = self.strength_and_critical(s)
        b = 0.14 * math.exp(23 * strength / self.modulus)
        return math.log(s * self.sigma / self.radius) + b * math.log(s / critical / JUMP)

    def pressure(self, s):
        if s <= 0:
            return 0.0
        strength, critical = self.strength_and_critical(s)
        ratio = s / critical
        if ratio < JUMP:
            return self.force * s * math.sqrt(s)
        log_share = self.log_share(s)
        hardness = 2.84 * -math.expm1(-0.82 * math.exp(-0.35 * min(0.0, log_share)))
        first = math.exp(-0.25 * ratio**(5 / 12)) * ratio * math.sqrt(ratio)
        second = 4 * hardness / self.c * -math.expm1(-0.04 * ratio**(5 / 9)) * ratio
        scale = self.density * 2 / 3 * self.c * strength * math.pi * self.radius * critical * self.sigma
        return scale * (first + second)

    def area(self, s):
        if s <= 0:
            return 0.0
        cross_section = self.density * math.pi * self.radius**2
        if s < JUMP * self.strength_and_critical(s)[1]:
            return min(self.touching * s, cross_section)
        return cross_section * math.exp(min(0.0, self.log_share(s)))

    def arrays(self, s):
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            strength, critical = self.strength_and_critical(s, np.sqrt)
            ratio = s / critical
            yields = ratio >= JUMP
            b = 0.14 * np.exp(23 * strength / self.modulus)
            growth = np.where(yields, b * np.log(np.maximum(ratio / JUMP, 1)), 0.0)
            log_share = np.minimum(0.0, np.log(s * self.sigma / self.radius) + growth)
            hardness = 2.84 * -np.expm1(-0.82 * np.exp(-0.35 * log_share))
            first = np.exp(-0.25 * ratio**(5 / 12)) * ratio * np.sqrt(ratio)
            second = 4 * hardness / self.c * -np.expm1(-0.04 * ratio**(5 / 9)) * ratio
            scale = (self.density * 2 / 3 * self.c * strength * math.pi * self.radius
                     * critical * self.sigma)
            pressure = np.where(yields, scale * (first + second), self.force * s * np.sqrt(s))
        area = self.density * math.pi * self.radius**2 * np.exp(log_share)
        return np.where(s > 0, pressure, 0.0), np.where(s > 0, area, 0.0)


class ElasticSine(Law):
    def __init__(self, case):
        super().__init__(case)
        wavelength = math.sqrt(2 / self.density)
        amplitude = (wavelength / (2 * math.pi))**2 / self.radius
        self.aspect = amplitude / wavelength
        self.whole = amplitude / self.sigma
        self.p_star = math.sqrt(2) * math.pi * self.modulus * self.aspect

    def breaks(self):
        return [self.whole * (1 - (1 - math.sqrt(0.8))**2.5), self.whole]

    def t(self, s):
        """(p_el/p*)^(1/2) at an interference."""
        return -math.expm1(0.4 * math.log1p(-s / self.whole))

    def elastic_area(self, x):
        if x >= 1:
            return 1.0
        complete = 1 - 3 / (2 * math.pi) * (1 - x)
        if x >= 0.8:
            return complete
        return (math.pi * (3 * x / (8 * math.pi))**(2 / 3) * (1 - x**1.51) + complete * x**1.04)

    def pressure(self, s):
        return self.p_star if s >= self.whole else self.p_star * self.t(s)**2

    def area(self, s):
        return 1.0 if s >= self.whole else self.elastic_area(self.t(s)**2)

    def elastic_areas(self, x):
        complete = 1 - 3 / (2 * math.pi) * (1 - x)
        light = math.pi * (3 * x / (8 * math.pi))**(2 / 3) * (1 - x**1.51) + complete * x**1.04
        return np.where(x >= 1, 1.0, np.where(x >= 0.8, complete, light))

    def powers(self, s):
        with np.errstate(divide="ignore"):
            return -np.expm1(0.4 * np.log1p(-np.minimum(s / self.whole, 1)))

    def arrays(self, s):
        x = self.powers(s)**2
        return self.p_star * x, self.elastic_areas(x)


class PlasticSine(ElasticSine):
    def __init__(self, case):
        super().__init__(case)
        self.fixed = None if self.length else self.sinusoid(self.strength)

    def sinusoid(self, strength):
        """What depends on the strength: r, p*_ep, A1, A2, p_c, the light area and its exponent."""
        critical_aspect = (math.sqrt(2) * strength / (3 * math.pi * self.modulus)
                           * math.exp(2 * (self.nu + 1) / 3))
        r = self.aspect / critical_aspect
        flow, hard = self.c * strength, self.modulus * self.aspect
        if r <= 1:
            return r, self.p_star, 0.0, 0.5, math.inf, 0.0, 0.0
        d = 3.8 * (hard / strength)**0.11
        light = 2 * ((flow / (8 * hard))**2 / math.pi)**(1 / (1 + d)) * (0.75 / flow)**(d / (1 + d))
        return (r, self.p_star * (11 / (4 * r + 7))**0.6, -0.1 * math.log(r),
                (r - 1)**0.44 / 15 + 0.99**(0.44 * (r - 1)) - 0.5,
                (flow / 2)**3 / (6 * math.pi * hard**2), light, d / (1 + d))

    def at(self, s):
        return self.fixed or self.sinusoid(
            self.strength * math.sqrt(1 + self.length / (s * self.sigma)))

    @staticmethod
    def log_x(log_t, a1, a2):
        """u of (A1 e^u + A2) u = ln t by Newton's method inside its bracket."""
        low, high = log_t / (a1 + a2), log_t / a2
        u = high
        for _ in range(60):
            e = math.exp(u)
            value = (a1 * e + a2) * u - log_t
            low, high = (low, u) if value > 0 else (u, high)
            new = u - value / (a1 * e * (1 + u) + a2)
            if not low <= new <= high:
                new = 0.5 * (low + high)
            if abs(new - u) <= 1e-15 * abs(new):
                return new
            u = new
        return u

    def plastic_pressure(self, s, sinusoid):
        if s >= self.whole:
            return sinusoid[1]
        return sinusoid[1] * math.exp(self.log_x(math.log(self.t(s)), sinusoid[2], sinusoid[3]))

    def pressure(self, s):
        if s <= 0:
            return 0.0
        sinusoid = self.at(s)
        elastic = super().pressure(s)
        return elastic if sinusoid[0] <= 1 else min(elastic, self.plastic_pressure(s, sinusoid))

    def area(self, s):
        if s <= 0:
            return 0.0
        sinusoid = self.at(s)
        p = self.pressure(s)
        if sinusoid[0] <= 1 or p <= sinusoid[4]:
            return self.elastic_area(p / self.p_star)
        x = p / sinusoid[1]
        return 1.0 if x >= 1 else min(1.0, self.flowing_area(p, x, sinusoid))

    @staticmethod
    def flowing_area(p, x, sinusoid):
        complete = 1 - 3 / (2 * math.pi) * (1 - x)
        return sinusoid[5] * p**sinusoid[6] * (1 - x**1.51) + complete * x**1.04

    def switches(self, s):
        """Numbers that change sign where the law changes branch."""
        sinusoid = self.at(s)
        elastic = super().pressure(s)
        eight_tenths = elastic / self.p_star - 0.8
        if sinusoid[0] <= 1:
            return sinusoid[0] - 1, -1.0, -1.0, -1.0, eight_tenths
        flowing = self.plastic_pressure(s, sinusoid)
        p = min(elastic, flowing)
        x = p / sinusoid[1]
        flat = 1.0 if x >= 1 else self.flowing_area(p, x, sinusoid) - 1
        return sinusoid[0] - 1, elastic - flowing, p / sinusoid[4] - 1, flat, p / self.p_star - 0.8

    def breaks(self):
        grid = [self.whole * 10**(0.02 * i - 12) for i in range(600)] + [self.whole * (1 - 1e-12)]
        found = [self.whole]
        states = [self.switches(s) for s in grid]
        for a, b, before, after in zip(grid, grid[1:], states, states[1:]):
            for i, (left, right) in enumerate(zip(before, after)):
                if (left > 0) != (right > 0):
                    found.append(brentq(lambda s: 1.0 if self.switches(s)[i] > 0 else -1.0, a, b,
                                        xtol=1e-300, rtol=1e-15))
        return sorted(set(found))

    def arrays(self, s):
        if self.fixed:
            r, p_ep, a1, a2, p_c, light, power = self.fixed
        else:
            with np.errstate(divide="ignore"):
                strength = self.strength * np.sqrt(1 + self.length / (s * self.sigma))
                flow, hard = self.c * strength, self.modulus * self.aspect
                r = self.aspect / (math.sqrt(2) * strength / (3 * math.pi * self.modulus)
                                   * math.exp(2 * (self.nu + 1) / 3))
            over = np.maximum(r - 1, 1e-300)
            with np.errstate(over="ignore", invalid="ignore"):
                d = 3.8 * (hard / strength)**0.11
                power = d / (1 + d)
                light = 2 * ((flow / (8 * hard))**2 / math.pi)**(1 / (1 + d)) * (0.75 / flow)**power
                p_c = (flow / 2)**3 / (6 * math.pi * hard**2)
            p_ep = self.p_star * (11 / (4 * np.maximum(r, 1) + 7))**0.6
            a1 = -0.1 * np.log(np.maximum(r, 1))
            a2 = over**0.44 / 15 + 0.99**(0.44 * over) - 0.5
        t = self.powers(s)
        with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
            elastic = self.p_star * t**2
            u = self.log_xs(np.log(np.maximum(t, 1e-300)), a1, a2)
            p = np.where(r > 1, np.minimum(elastic, p_ep * np.exp(u)), elastic)
            x = np.minimum(p / p_ep, 1)
            complete = 1 - 3 / (2 * math.pi) * (1 - x)
            flowing = light * p**power * (1 - x**1.51) + complete * x**1.04
            flowing = np.where(x >= 1, 1.0, np.minimum(1.0, flowing))
            area = np.where((r > 1) & (p > p_c), flowing, self.elastic_areas(p / self.p_star))
        return np.where(s > 0, p, 0.0), np.where(s > 0, area, 0.0)

    @staticmethod
    def log_xs(log_t, a1, a2):
        low, high = log_t / (a1 + a2), log_t / a2
        u = high
        for _ in range(60):
            e = np.exp(u)
            value = (a1 * e + a2) * u - log_t
            low, high = np.where(value > 0, low, u), np.where(value > 0, u, high)
            new = u - value / (a1 * e * (1 + u) + a2)
            new = np.where((low <= new) & (new <= high), new, 0.5 * (low + high))
            if np.all(np.abs(new - u) <= 1e-15 * np.abs(new)):
                return new
            u = new
        return u
