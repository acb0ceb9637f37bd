"""Stacked model, level by level (docs/theory/models.md, section 4 with 2.3 to 2.5 and 2.7)."""
import argparse
import pathlib

from mpmath import mp, mpf, pi

from asperity import INFINITY, Sinusoid, composite_modulus, gradient_strength
from spectrum import amplitude_eq5, read_spectrum, resample
from tables import INPUT_NOTE, PRECISION_NOTE, WORKING_DIGITS, show, write_table

COLUMNS = ["model", "strain_gradient_length_m", "youngs_modulus_pa", "poisson_ratio",
           "yield_strength_pa", "nominal_pressure_pa", "wavelength_m", "amplitude_m",
           "area_fraction", "real_pressure_pa", "pressure_in_pa", "yield_strength_level_pa",
           "regime"]

# name: (E, nu, Sy, h*), SI units
MATERIALS = {"uncd": (463e9, 0.2, 1.8e9, 5e-6),
             "metal": (70e9, 0.33, 0.1e9, 1e-6),
             "polymer": (3e9, 0.4, 60e6, 10e-6)}

UNCD_PRESSURES = (5.4e5, 5.4e6, 5.4e7, 5.4e8)         # 1e-4 to 1e-1 of H = 3 Sy = 5.4 GPa


def plan():
    """(file stem, spectrum stem, scales per decade or None, material,
    [(plastic?, strain gradient?)], pressures)."""
    elastic, plastic, gradient = (False, False), (True, False), (True, True)
    full, measured = "uncd_psd_reconstructed", "uncd_psd_measured"
    yield "stacked_uncd_elastic", full, None, "uncd", [elastic], UNCD_PRESSURES
    for part, pressures in (("low", UNCD_PRESSURES[:2]), ("high", UNCD_PRESSURES[2:])):
        yield f"stacked_uncd_ep_{part}", full, None, "uncd", [plastic], pressures
        yield f"stacked_uncd_gradient_{part}", full, None, "uncd", [gradient], pressures
    yield ("stacked_uncd_measured", measured, None, "uncd", [elastic, plastic, gradient],
           (5.4e7,))
    # pressures above the complete contact of the long scales
    yield ("stacked_metal", measured, None, "metal", [plastic, gradient],
           (1e4, 1e7, 1e8))
    yield ("stacked_polymer", measured, None, "polymer", [plastic, gradient],
           (1e3, 1e6, 3e7))
    yield "stacked_metal_flattened", full, None, "metal", [elastic, gradient], (1e9,)
    yield "stacked_resampled_5", full, 5, "uncd", [elastic, plastic, gradient], (5.4e7,)
    yield "stacked_resampled_20", full, 20, "uncd", [gradient], (5.4e7,)


def stack(spectrum, material, plastic, gradient, nominal_pressure):
    """Yields the seven level columns after wavelength, for long to short scales."""
    youngs, poisson, strength, length = map(mpf, material)
    e_star = composite_modulus(youngs, poisson)
    pressure, area = mpf(nominal_pressure), mpf(1)
    depth = None                                      # h_p left by the scale above
    for wavelength, psd in spectrum:
        amplitude = amplitude_eq5(wavelength, psd)
        local_strength = strength if plastic else INFINITY
        if gradient and depth is not None:
            local_strength = gradient_strength(strength, length, depth)
        wave = Sinusoid(e_star, poisson, local_strength, amplitude / wavelength)
        phi = wave.phi(pressure)
        if phi == 1:
            regime = "flattened"
        else:
            regime = "plastic" if wave.is_plastic_at(pressure) else "elastic"
        pressure_in = pressure
        depth = amplitude * wave.descent_ratio(pressure)
        area *= phi
        pressure /= phi
        yield (wavelength, amplitude, area, pressure, pressure_in,
               local_strength if plastic else None, regime)


def cell(value):
    if value is None or value == INFINITY:
        return "" if value is None else "inf"
    return value


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("spectra", type=pathlib.Path, help="folder of the PSD tables")
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    for stem, source, per_decade, material_name, variants, pressures in plan():
        spectrum = read_spectrum(arguments.spectra / (source + ".csv"))
        text = f"spectrum {source}.csv as it stands ({len(spectrum)} scales)"
        if per_decade:
            before = len(spectrum)
            spectrum = resample(spectrum, per_decade)
            text = (f"spectrum {source}.csv ({before} samples) resampled to {per_decade} per "
                    f"decade ({len(spectrum)} scales)")
        material = MATERIALS[material_name]
        rows, count = [], {}
        for plastic, gradient in variants:
            for nominal in pressures:
                for level in stack(spectrum, material, plastic, gradient, nominal):
                    wavelength, amplitude = level[:2]
                    rows.append(["elastic-plastic" if plastic else "elastic",
                                 material[3] if gradient else None, *material[:3], nominal,
                                 *map(cell, level)])
                    count[level[-1]] = count.get(level[-1], 0) + 1
        write_table(arguments.output / (stem + ".csv"),
                    [f"Stacked model, {text}: docs/theory/models.md, section 4. Amplitudes by Eq. (5).",
                     "area_fraction: A_i/A_n, all scales so far; pressure_in_pa: p_i; "
                     "real_pressure_pa: p_i/phi_i; strength of the level empty in the elastic "
                     "model; regime flattened: phi = 1.",
                     INPUT_NOTE, PRECISION_NOTE], COLUMNS, rows)
        size = (arguments.output / (stem + ".csv")).stat().st_size
        print(f"{stem}: {len(rows)} rows, {size} bytes, {count}; last area "
              f"{show(rows[-1][8])}")


if __name__ == "__main__":
    main()
