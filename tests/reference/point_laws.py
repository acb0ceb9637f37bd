"""The three single-asperity tables: inputs, outputs, and the map between them."""
from asperity import Sinusoid, Sphere, composite_modulus

SPHERE_INPUTS = ("youngs_modulus_pa", "poisson_ratio", "yield_strength_pa",
                 "radius_m", "interference_m")
SPHERE_OUTPUTS = ("hertz_force_n", "hertz_area_m2", "jackson_green_force_n",
                  "jackson_green_area_m2", "jackson_green_force_cosine_hardness_n")


def sphere_row(youngs, poisson, strength, radius, w):
    """The Jackson-Green area is capped at pi R^2, the Hertz area is not."""
    ball = Sphere(composite_modulus(youngs, poisson), poisson, strength, radius)
    return (ball.hertz_force(w), ball.hertz_area(w), ball.force(w), ball.capped_area(w),
            ball.force(w, "cosine"))


SINUSOID_INPUTS = ("youngs_modulus_pa", "poisson_ratio", "yield_strength_pa",
                   "aspect_ratio", "pressure_pa")
SINUSOID_OUTPUTS = ("complete_contact_pressure_elastic_pa", "area_fraction_elastic",
                    "critical_aspect_ratio", "complete_contact_pressure_ep_pa",
                    "area_fraction_ep", "mean_gap_over_amplitude")


def sinusoid_row(youngs, poisson, strength, aspect, p):
    """The gap is the elastic-plastic one (elastic while r <= 1 or p <= p_c)."""
    wave = Sinusoid(composite_modulus(youngs, poisson), poisson, strength, aspect)
    return (wave.p_star, wave.phi_elastic(p), wave.critical_aspect, wave.p_star_ep,
            wave.phi(p), wave.gap_ratio(p))


INTERFERENCE_INPUTS = ("youngs_modulus_pa", "poisson_ratio", "yield_strength_pa",
                       "wavelength_m", "aspect_ratio", "interference_m")
INTERFERENCE_OUTPUTS = ("pressure_elastic_pa", "area_fraction_elastic",
                        "pressure_ep_pa", "area_fraction_ep")


def interference_row(youngs, poisson, strength, wavelength, aspect, w):
    """Amplitude = aspect ratio x wavelength."""
    wave = Sinusoid(composite_modulus(youngs, poisson), poisson, strength, aspect)
    w_ratio = w / (aspect * wavelength)
    p_el, p = wave.pressure_elastic_at(w_ratio), wave.pressure_at(w_ratio)
    return p_el, wave.phi_elastic(p_el), p, wave.phi(p)


TABLES = {
    "sphere": (SPHERE_INPUTS, SPHERE_OUTPUTS, sphere_row),
    "sinusoid": (SINUSOID_INPUTS, SINUSOID_OUTPUTS, sinusoid_row),
    "sinusoid_interference": (INTERFERENCE_INPUTS, INTERFERENCE_OUTPUTS, interference_row),
}
