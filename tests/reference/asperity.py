"""Single-asperity laws at arbitrary precision.

Every function below restates one formula of docs/theory/models.md, whose section
numbers the docstrings cite.  Nothing here is shared with the package under
test: the two only have the formulas in common, which is the point.

Numbers are mpmath ``mpf``; the precision is whatever ``mp.dps`` says when a
function is called.
"""
from mpmath import mp, mpf, pi, sqrt, exp, log, expm1, log1p

THRESHOLD = mpf(19) / 10          # w' at which the sphere leaves Hertz
INFINITY = mpf("inf")


def composite_modulus(youngs_modulus, poisson_ratio):
    """E* of one elastic body against a rigid counterface."""
    return youngs_modulus / (1 - poisson_ratio**2)


def yield_coefficient(poisson_ratio):
    """C of section 2.2."""
    return mpf("1.295") * exp(mpf("0.736") * poisson_ratio)


# --------------------------------------------------------------------------
# Sphere, sections 2.1 and 2.2
# --------------------------------------------------------------------------
class Sphere:
    """Hertz and Jackson-Green sphere with a fixed yield strength."""

    def __init__(self, e_star, poisson_ratio, yield_strength, radius):
        self.e_star, self.radius = e_star, radius
        self.strength = yield_strength
        self.c = yield_coefficient(poisson_ratio)
        self.slope = pi * self.c * yield_strength / (2 * e_star)
        self.w_c = self.slope**2 * radius
        self.area_c = pi * radius * self.w_c
        self.force_c = mpf(2) / 3 * self.c * yield_strength * self.area_c
        self.b = mpf("0.14") * exp(23 * yield_strength / e_star)

    def hertz_force(self, w):
        return mpf(4) / 3 * self.e_star * sqrt(self.radius) * w * sqrt(w)

    def hertz_area(self, w):
        return pi * self.radius * w

    def log_area(self, w):
        """ln of the uncapped contact area (the power can overflow)."""
        ratio = w / self.w_c
        value = log(pi * self.radius * w)
        if ratio >= THRESHOLD:
            value += self.b * log(ratio / THRESHOLD)
        return value

    def area(self, w):
        """Area without the pi R^2 cap."""
        if w < THRESHOLD * self.w_c:
            return self.hertz_area(w)
        return exp(self.log_area(w))

    def capped_area(self, w):
        """min(A, pi R^2), the cap of section 2.2; also below w' = 1.9."""
        limit = pi * self.radius**2
        return limit if self.log_area(w) >= log(limit) else self.area(w)

    def contact_radius_ratio(self, w):
        """a/R = sqrt(A / (pi R^2)), at most 1."""
        log_square = self.log_area(w) - log(pi * self.radius**2)
        return mpf(1) if log_square >= 0 else exp(log_square / 2)

    def hardness_ratio(self, w, form):
        a_over_r = self.contact_radius_ratio(w)
        if form == "cosine":
            return mpf("2.84") - mpf("0.92") * (1 - mp.cos(pi * a_over_r))
        return mpf("2.84") * -expm1(-mpf("0.82") * a_over_r ** mpf("-0.7"))

    def force(self, w, form="2005"):
        ratio = w / self.w_c
        if ratio < THRESHOLD:
            return self.hertz_force(w)
        hardness = self.hardness_ratio(w, form)          # H_G / Sy
        elastic_part = exp(-(ratio ** (mpf(5) / 12)) / 4) * ratio * sqrt(ratio)
        plastic_part = -expm1(-(ratio ** (mpf(5) / 9)) / 25) * ratio
        return self.force_c * (elastic_part + 4 * hardness / self.c * plastic_part)


# --------------------------------------------------------------------------
# Sinusoid, sections 2.3 to 2.6
# --------------------------------------------------------------------------
class Sinusoid:
    """Elastic-plastic sinusoid of aspect ratio B with a fixed yield strength.

    ``yield_strength`` may be infinite: the sinusoid is then elastic.
    """

    def __init__(self, e_star, poisson_ratio, yield_strength, aspect_ratio):
        self.e_star, self.aspect = e_star, aspect_ratio
        self.strength = yield_strength
        self.p_star = sqrt(mpf(2)) * pi * e_star * aspect_ratio
        if yield_strength == INFINITY:
            self.critical_aspect = self.p_critical = INFINITY
            self.r = mpf(0)
        else:
            c_sy = yield_coefficient(poisson_ratio) * yield_strength
            eb = e_star * aspect_ratio
            self.critical_aspect = (sqrt(mpf(2)) * yield_strength / (3 * pi * e_star)
                                    * exp(2 * (poisson_ratio + 1) / 3))
            self.r = aspect_ratio / self.critical_aspect
            self.p_critical = (c_sy / 2) ** 3 / (6 * pi * eb**2)
            self.c_sy = c_sy
        self.plastic = self.r > 1
        self.p_star_ep = self.p_star
        if self.plastic:
            self.p_star_ep *= (11 / (4 * self.r + 7)) ** (mpf(3) / 5)
            self.phi_c = 2 / pi * (c_sy / (8 * eb)) ** 2
            self.d = mpf("3.8") * (eb / yield_strength) ** mpf("0.11")
            excess = self.r - 1
            self.a1 = -log(self.r) / 10
            self.a2 = (excess ** mpf("0.44") / 15
                       + mpf("0.99") ** (mpf("0.44") * excess) - mpf(1) / 2)

    # -- area fraction -----------------------------------------------------
    @staticmethod
    def _near_complete(x):
        return 1 - 3 / (2 * pi) * (1 - x)

    def phi_elastic(self, p):
        x = p / self.p_star
        if x >= 1:
            return mpf(1)
        if x >= mpf(8) / 10:
            return self._near_complete(x)
        dilute = pi * (3 * x / (8 * pi)) ** (mpf(2) / 3)
        return (dilute * (1 - x ** mpf("1.51"))
                + self._near_complete(x) * x ** mpf("1.04"))

    def is_plastic_at(self, p):
        return self.plastic and p > self.p_critical

    def phi_plastic_unclamped(self, p):
        x = p / self.p_star_ep
        d = self.d
        dilute = (2 * (self.phi_c / 2) ** (1 / (1 + d))
                  * (3 * p / (4 * self.c_sy)) ** (d / (1 + d)))
        return (dilute * (1 - x ** mpf("1.51"))
                + self._near_complete(x) * x ** mpf("1.04"))

    def phi(self, p):
        """Elastic-plastic area fraction, section 2.4."""
        if not self.is_plastic_at(p):
            return self.phi_elastic(p)
        if p >= self.p_star_ep:
            return mpf(1)
        return min(mpf(1), self.phi_plastic_unclamped(p))

    # -- mean gap, section 2.5 ------------------------------------------------
    @staticmethod
    def _log_contact_variable(sinusoid, p):
        """ln t, where gap/Delta = (1 - t)^(5/2); zero at complete contact."""
        if not sinusoid.is_plastic_at(p):
            return log(p / sinusoid.p_star) / 2
        x = p / sinusoid.p_star_ep
        return (sinusoid.a1 * x + sinusoid.a2) * log(x)

    def gap_ratio(self, p, elastic_only=False):
        """Mean gap over amplitude."""
        return 1 - self.descent_ratio(p, elastic_only)

    def descent_ratio(self, p, elastic_only=False):
        """1 - gap/Delta, without the cancellation: the h_p of Eq. (9) over Delta."""
        plastic = self.is_plastic_at(p) and not elastic_only
        if p >= (self.p_star_ep if plastic else self.p_star):
            return mpf(1)
        if plastic:
            log_t = self._log_contact_variable(self, p)
        else:
            log_t = log(p / self.p_star) / 2
        one_minus_t = -expm1(log_t)
        return -expm1(mpf(5) / 2 * log(one_minus_t))

    # -- pressed to an interference, section 2.6 --------------------------------
    def pressure_elastic_at(self, w_ratio):
        """p_el for w/Delta."""
        if w_ratio >= 1:
            return self.p_star
        return self.p_star * contact_variable(w_ratio) ** 2

    def pressure_at(self, w_ratio):
        """The smaller of the elastic and the elastic-plastic pressure."""
        p_el = self.pressure_elastic_at(w_ratio)
        if not self.plastic:
            return p_el
        return min(p_el, self.pressure_plastic_at(w_ratio))

    def pressure_plastic_at(self, w_ratio):
        if w_ratio >= 1:
            return self.p_star_ep
        log_t = log(contact_variable(w_ratio))
        return self.p_star_ep * exp(self.log_x_of_log_t(log_t))

    def log_x_of_log_t(self, log_t):
        """u = ln x of (A1 e^u + A2) u = ln t: unique, since the left side rises.

        Bracketed by the two constant exponents A1 + A2 <= A1 x + A2 <= A2,
        then Newton's method with bisection as its safety net.
        """
        a1, a2 = self.a1, self.a2
        low, high = log_t / (a1 + a2), log_t / a2
        u = high
        tolerance = mpf(10) ** (-mp.dps + 3)
        for _ in range(400):
            e_u = exp(u)
            value = (a1 * e_u + a2) * u - log_t
            if value > 0:
                high = u
            elif value < 0:
                low = u
            else:
                return u
            step = value / (a1 * e_u * (1 + u) + a2)
            new = u - step
            if not low <= new <= high:
                new = (low + high) / 2
            if abs(new - u) <= tolerance * abs(new):
                return new
            u = new
        raise ArithmeticError("no convergence in x(t)")


def contact_variable(w_ratio):
    """t = 1 - (1 - w/Delta)^(2/5)."""
    return -expm1(mpf(2) / 5 * log1p(-w_ratio))


# --------------------------------------------------------------------------
# Strength, section 2.7
# --------------------------------------------------------------------------
def gradient_strength(strength, gradient_length, depth):
    """Nix-Gao strength at a deformation depth; infinite at zero depth."""
    if not gradient_length:
        return strength
    if depth == 0:
        return INFINITY
    return strength * sqrt(1 + gradient_length / depth)
