"""Moments, McCool's parameters and amplitudes of given spectra and of a synthetic one."""
import argparse
import pathlib

from mpmath import mp, mpf

from spectrum import (PSD_COLUMN, WAVELENGTH_COLUMN, amplitude_eq5, amplitudes_parseval,
                      mccool, moments, read_spectrum)
from tables import INPUT_NOTE, PRECISION_NOTE, WORKING_DIGITS, write_table

SYNTHETIC = "psd_synthetic.csv"


def write_synthetic(path):
    """A spectrum made of awkward pieces; every wavelength is an exact double.

    Pieces whose wavelengths halve and whose PSD falls by 2, 8 or 32 have the
    exponents -1, -3, -5 exactly, in binary as well as on paper, and make one of
    the three closed forms degenerate (a = 0).
    """
    wavelength, psd = 2.0**-8, 2.0**-64
    points = [(wavelength, psd)]

    def step(shrink, fall):
        nonlocal wavelength, psd
        wavelength, psd = wavelength / shrink, psd / fall
        points.append((wavelength, psd))

    for fall in (1.0, 2.0, 2.0, 8.0, 8.0, 32.0, 32.0):      # 0, then exactly -1, -3, -5
        step(2.0, fall)
    step(1.0 + 1e-6, 1.0)                                    # a very short interval
    step(1.0 + 1e-6, 1.0 + 1e-6)
    step(1.0 + 1e-6, (1.0 + 1e-6) ** 5)
    for exponent in (1.0, 3.0, 5.0):                         # within 1e-9 of degenerate
        for shift in (1e-9, -1e-9, 1e-12, -1e-7):
            step(2.0, 2.0 ** (exponent + shift))
    step(1.0 + 1e-6, 2.0**-10)                               # a jump up, and down again
    step(2.0, 1.0)
    step(1.0 + 1e-6, 2.0**20)
    step(1.0009765625, 4.0)                                  # another, over 0.1 %
    step(2.0, 2.0**-3)                                       # a rising piece
    step(8.0, 8.0**4)                                        # a wide interval
    step(1.0 + 1e-6, 1.0)
    for i in range(12):                                      # a rough, irregular descent
        step((1.25, 1.5, 1.125, 2.0)[i % 4], (0.5, 8.0, 2.0, 4.0, 1.0)[i % 5])
    for i in range(12):                                      # steeper than -5
        step(1.25, 4.0)
    for exponent in (5.0, 3.0, 1.0):
        step(1.5, 1.5**exponent)                             # degenerate to rounding only
    step(1.25, 1.0)
    for _ in range(3):
        step(1.0 + 1e-6, 1.0)
    for _ in range(4):
        step(1.5, 2.25)
    write_table(path, ["Synthetic spectrum to try the closed-form moments: no surface has it. "
                       "C1D convention.",
                       "Exponents exactly -1, -3, -5 and within 1e-7 to 1e-12 of them, jumps, "
                       "wavevector ratios of 1 + 1e-6, steep and rising pieces.",
                       "Numbers are the repr of doubles."],
                [WAVELENGTH_COLUMN, PSD_COLUMN], points)
    return len(points)


def write_moments(spectrum, name, path):
    rows = [(wavelength, m0, m2, m4, *mccool(m0, m2, m4))
            for wavelength, m0, m2, m4 in moments(spectrum)]
    write_table(path,
                [f"Cumulative moments (norm 1/pi) and McCool's parameters of {name}: "
                 "docs/theory/models.md, sections 1.4, 1.5; from the second wavelength on.",
                 "Wavevectors are 2 pi / lambda_m (any wavevector column is ignored), the PSD "
                 "is a power law between samples.", INPUT_NOTE, PRECISION_NOTE],
                ["wavelength_m", "m0_m2", "m2", "m4_per_m2", "radius_m", "density_per_m2",
                 "sigma_s_m", "offset_m", "nayak_alpha"], rows)


def write_amplitudes(spectrum, name, path):
    rows = [(wavelength, amplitude_eq5(wavelength, psd), parseval)
            for (wavelength, psd), parseval in zip(spectrum, amplitudes_parseval(spectrum))]
    write_table(path,
                [f"Amplitudes of {name}: docs/theory/models.md, section 1.6, Eq. (5) and the Parseval "
                 "option (band edges at geometric midpoints, ends at the first and last sample).",
                 INPUT_NOTE, PRECISION_NOTE],
                ["wavelength_m", "amplitude_eq5_m", "amplitude_parseval_m"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", type=pathlib.Path, help="folder to write to")
    parser.add_argument("spectra", type=pathlib.Path, nargs="*", help="PSD tables")
    arguments = parser.parse_args()
    mp.dps = WORKING_DIGITS
    synthetic = arguments.output / SYNTHETIC
    print(SYNTHETIC, write_synthetic(synthetic), "points")
    for source in [*arguments.spectra, synthetic]:
        spectrum = read_spectrum(source)
        write_moments(spectrum, source.name, arguments.output / f"moments_{source.stem}.csv")
        write_amplitudes(spectrum, source.name,
                         arguments.output / f"amplitudes_{source.stem}.csv")
        # Parseval: the band amplitudes carry exactly the variance
        *_, last = moments(spectrum)
        total = sum(a**2 for a in amplitudes_parseval(spectrum)) / 2
        print(source.name, len(spectrum), "samples; Parseval residue",
              mp.nstr(abs(total / last[1] - 1), 3))


if __name__ == "__main__":
    main()
