"""Statistical model, section 3 of docs/theory/models.md: pressure and area fraction at a separation.

The integrals over the interference w run over panels bounded by every kink and
jump of the asperity law, and by a ladder of points that follows the Gaussian
and the decades of w.  Each panel is integrated by the tanh-sinh rule, which
does not mind the algebraic singularities at its ends.  ``scheme`` changes the
ladders, the step and the range of the rule, so that two schemes
check each other.
"""
from dataclasses import dataclass
from functools import lru_cache

from mpmath import mp, mpf, pi, sqrt, exp, log, cosh, sinh

from asperity import (INFINITY, Sinusoid, Sphere, THRESHOLD, composite_modulus,
                      gradient_strength)


@dataclass(frozen=True)
class Scheme:
    """How to cut the range into panels and how finely to integrate each."""
    digits: int
    inverse_step: int       # tanh-sinh step is 1/inverse_step
    gauss_step: str         # ladder across the Gaussian, in sigma
    decade: str             # ladder ratio in w
    scan: int               # points per decade in the search for kinks


SCHEMES = (Scheme(36, 11, "3.5", "20", 12), Scheme(44, 14, "2.3", "7.3", 17))


@lru_cache(maxsize=None)
def tanh_sinh_rule(digits, inverse_step):
    """[(distance from the near end as a share of the panel, weight, side)]."""
    rule = []
    k = 0
    while True:
        s = mpf(k) / inverse_step
        inner = pi / 2 * sinh(s)
        share = 1 / (1 + exp(2 * inner))             # from the near end
        weight = pi / 2 * cosh(s) / cosh(inner) ** 2 / 2 / inverse_step
        if weight < mpf(10) ** (-digits):
            return rule
        rule.append((share, weight, 1))
        if k:
            rule.append((share, weight, -1))
        k += 1


def integrate_panel(function, left, right, scheme):
    """Integrals of a vector-valued function over one panel."""
    width = right - left
    totals = None
    for share, weight, side in tanh_sinh_rule(mp.dps, scheme.inverse_step):
        w = left + share * width if side < 0 else right - share * width
        values = function(w)
        if totals is None:
            totals = [weight * v for v in values]
        else:
            for i, v in enumerate(values):
                totals[i] += weight * v
    return [width * t for t in totals]


# --------------------------------------------------------------------------
# Asperities: response(w) = (eta F, eta A), switches(w) = the numbers whose signs
# tell the branch apart.
# --------------------------------------------------------------------------
class HertzAsperity:
    def __init__(self, surface):
        self.density = surface.density
        self.ball = Sphere(surface.e_star, surface.poisson, mpf(1), surface.radius)

    def response(self, w):
        return (self.density * self.ball.hertz_force(w),
                self.density * self.ball.hertz_area(w))

    def landmarks(self):
        return []

    def switches(self, w):
        return ()


class PlasticSphere:
    """ep-sphere: h_p = w, area capped at pi R^2."""

    def __init__(self, surface):
        self.s = surface
        base = self.ball(mpf(1), fixed=True)
        self.base_critical = base.w_c
        self.limit = pi * surface.radius**2

    def ball(self, w, fixed=False):
        s = self.s
        strength = s.strength if fixed else gradient_strength(s.strength, s.length, w)
        return Sphere(s.e_star, s.poisson, strength, s.radius)

    def response(self, w):
        ball = self.ball(w)
        return self.s.density * ball.force(w), self.s.density * ball.capped_area(w)

    def yield_interference(self):
        """Positive root of w^2 - 1.9 w_c0 w - 1.9 w_c0 h* = 0."""
        half = THRESHOLD * self.base_critical / 2
        length = self.s.length or mpf(0)
        return half + sqrt(half**2 + 2 * half * length)

    def landmarks(self):
        start = self.yield_interference()
        after = [start * (1 + mpf(10) ** (-mpf(k) / 4)) for k in range(1, 25 * 4)]
        return [start, self.s.radius], after

    def switches(self, w):
        return (self.ball(w).log_area(w) - log(self.limit),)


class SineAsperity:
    """elastic-sine and ep-sine: lambda = sqrt(2/eta), Delta = (lambda/2 pi)^2/R."""

    def __init__(self, surface, plastic):
        self.s = surface
        self.plastic = plastic
        wavelength = sqrt(2 / surface.density)
        self.amplitude = (wavelength / (2 * pi)) ** 2 / surface.radius
        self.aspect = self.amplitude / wavelength
        self.fixed = None
        if not plastic or not surface.length:
            self.fixed = Sinusoid(surface.e_star, surface.poisson,
                                  surface.strength if plastic else INFINITY, self.aspect)

    def wave(self, w):
        if self.fixed:
            return self.fixed
        strength = gradient_strength(self.s.strength, self.s.length, w)
        return Sinusoid(self.s.e_star, self.s.poisson, strength, self.aspect)

    def response(self, w):
        wave = self.wave(w)
        ratio = w / self.amplitude
        pressure = wave.pressure_at(ratio)
        return pressure, mpf(1) if ratio >= 1 else wave.phi(pressure)

    def landmarks(self):
        """Kinks known in closed form, and points crowding after r(w) = 1."""
        eighth = self.amplitude * (1 - (1 - sqrt(mpf(8) / 10)) ** (mpf(5) / 2))
        known, after = [self.amplitude, eighth], []
        if self.plastic and self.s.length:
            base = Sinusoid(self.s.e_star, self.s.poisson, self.s.strength, self.aspect)
            if base.r > 1:
                start = self.s.length / (base.r**2 - 1)
                known.append(start)
                after = [start * (1 + mpf(10) ** (-mpf(k) / 4)) for k in range(-4, 25 * 4)]
        return known, after

    def switches(self, w):
        if not self.plastic:
            return ()
        wave = self.wave(w)
        ratio = w / self.amplitude
        p_el = wave.pressure_elastic_at(ratio)
        if not wave.plastic:
            return mpf(-1), mpf(-1), mpf(-1), p_el / wave.p_star - mpf(8) / 10
        p_ep = wave.pressure_plastic_at(ratio)
        p = min(p_el, p_ep)
        clamped = p >= wave.p_star_ep or wave.phi_plastic_unclamped(p) >= 1
        return (p_el - p_ep, p / wave.p_critical - 1,
                mpf(1) if clamped else mpf(-1), p / wave.p_star - mpf(8) / 10)


@dataclass
class Surface:
    e_star: mpf
    poisson: mpf
    strength: mpf
    length: mpf             # strain-gradient length, None without
    radius: mpf
    density: mpf
    sigma: mpf


def make_asperity(model, surface):
    if model == "hertz":
        return HertzAsperity(surface)
    if model == "ep-sphere":
        return PlasticSphere(surface)
    return SineAsperity(surface, plastic=model == "ep-sine")


# --------------------------------------------------------------------------
# Panels
# --------------------------------------------------------------------------
def find_kinks(asperity, low, high, scheme):
    """Places inside (low, high) where the law changes branch."""
    landmarks = asperity.landmarks()
    known, after = landmarks if landmarks else ([], [])
    known = [w for w in known if low < w < high]
    if not asperity.switches(high):
        return known
    points = sorted({low, high, *known, *(w for w in after if low < w < high)})
    full = mp.dps
    grid = []
    for a, b in zip(points, points[1:]):
        a_pos = max(a, b * mpf(10) ** -30)
        decades = log(b / a_pos) / log(mpf(10))
        steps = max(2, int(scheme.scan * decades) + 1)
        ends = mpf(10) ** -25
        piece = [a_pos * (b / a_pos) ** (mpf(i) / steps) for i in range(1, steps)]
        # stay strictly inside, so that a jump at a known point belongs to neither side
        grid.append([a_pos + (b - a_pos) * ends, *piece, b - (b - a_pos) * ends])
    kinks = []
    for piece in grid:
        signs = [tuple(v > 0 for v in asperity.switches(w)) for w in piece]
        for (w1, s1), (w2, s2) in zip(zip(piece, signs), list(zip(piece, signs))[1:]):
            for i, (before, after_) in enumerate(zip(s1, s2)):
                if before != after_:
                    kinks.append(bisect(lambda w: asperity.switches(w)[i] > 0, w1, w2, before))
    return sorted({*known, *kinks})


def bisect(positive, low, high, at_low):
    """Where a sign changes, to full precision."""
    for _ in range(int(3.4 * mp.dps)):
        middle = (low + high) / 2
        if positive(middle) == at_low:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def integration_range(sigma, d):
    """Where exp(-u^2/2) relative to its largest value is above about 1e-60."""
    span = mpf(17)
    if d < 0:
        return max(mpf(0), -d - span * sigma), -d + span * sigma
    u = d / sigma
    return mpf(0), sigma * (sqrt(u**2 + span**2) - u)


def panels(asperity, surface, d, scheme):
    sigma = surface.sigma
    low, high = integration_range(sigma, d)
    points = {low, high}
    kinks = find_kinks(asperity, low, high, scheme)
    points.update(kinks)
    u0 = max(mpf(0), d) / sigma
    step = mpf(scheme.gauss_step)
    if u0 > step:                                    # nearly exponential decay
        scale = 2 * step * sigma / u0
        w = low + scale
    else:
        scale = step * sigma
        w = low + scale
    while w < high:
        points.add(w)
        w += scale
    # decades of w, down to well below the smallest feature
    smallest = min([sigma / (1 + u0), *kinks]) / 10**3
    w = max(low, smallest)
    while w < high:
        points.add(w)
        w *= mpf(scheme.decade)
    ordered = sorted(p for p in points if low <= p <= high)
    return [(a, b) for a, b in zip(ordered, ordered[1:]) if b > a]


def evaluate(model, surface, d, scheme):
    """(pressure, area fraction at most 1) by one scheme."""
    mp.dps = scheme.digits
    asperity = make_asperity(model, surface)
    norm = 1 / (surface.sigma * sqrt(2 * pi))

    def integrand(w):
        weight = norm * exp(-(((d + w) / surface.sigma) ** 2) / 2)
        pressure, area = asperity.response(w)
        return weight * pressure, weight * area

    totals = [mpf(0), mpf(0)]
    for left, right in panels(asperity, surface, d, scheme):
        part = integrate_panel(integrand, left, right, scheme)
        totals = [t + v for t, v in zip(totals, part)]
    return totals[0], min(mpf(1), totals[1])


def surface_from(row, read):
    """A Surface and a separation from a table row."""
    youngs, poisson = read(row["youngs_modulus_pa"]), read(row["poisson_ratio"])
    length = row["strain_gradient_length_m"]
    surface = Surface(composite_modulus(youngs, poisson), poisson,
                      read(row["yield_strength_pa"]), read(length) if length else None,
                      read(row["radius_m"]), read(row["density_per_m2"]),
                      read(row["sigma_s_m"]))
    return surface, read(row["separation_m"])
