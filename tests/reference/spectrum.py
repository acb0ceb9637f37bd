"""Piecewise power-law spectra: moments, McCool's parameters, amplitudes, resampling.

Sections 1.4 to 1.6 and the resampling rule of section 4 of docs/theory/models.md.  A spectrum is two
lists, wavelengths (long to short) and PSD values in the C1D convention; the
wavevectors are 2 pi / wavelength, whatever else a file may list.
"""
from mpmath import mp, mpf, pi, sqrt, exp, expm1, log, nint

from tables import as_double, read_table

PSD_COLUMN = "C1D_m3"
WAVELENGTH_COLUMN = "lambda_m"


def read_spectrum(path):
    """[(wavelength, PSD)], long wavelengths first."""
    pairs = [(as_double(row[WAVELENGTH_COLUMN]), as_double(row[PSD_COLUMN]))
             for row in read_table(path)]
    return sorted(pairs, reverse=True)


def power_law_integral(k, q1, c1, q2, c2):
    """Integral of q^k C over one interval, closed form of section 1.4."""
    length = log(q2 / q1)
    exponent = k + 1 + log(c2 / c1) / length
    if abs(exponent) < mpf(10) ** (8 - mp.dps):
        factor = length                              # a -> 0
    else:
        factor = expm1(exponent * length) / exponent
    return c1 * q1 ** (k + 1) * factor


def moments(spectrum):
    """(wavelength, m0, m2, m4) from the second wavelength on, norm 1/pi."""
    totals = [mpf(0)] * 3
    for (long, c1), (short, c2) in zip(spectrum, spectrum[1:]):
        q1, q2 = 2 * pi / long, 2 * pi / short
        for i, k in enumerate((0, 2, 4)):
            totals[i] += power_law_integral(k, q1, c1, q2, c2) / pi
        yield short, *totals


def mccool(m0, m2, m4):
    """radius, density, sigma_s, offset of the asperity mean plane, Nayak's alpha."""
    radius = mpf("0.375") * sqrt(pi / m4)
    density = m4 / (6 * pi * sqrt(mpf(3)) * m2)
    product = density * radius
    variance = m0 - mpf("3.717e-4") / product**2
    sigma_s = sqrt(variance) if variance > 0 else None
    return radius, density, sigma_s, mpf("0.045944") / product, m0 * m4 / m2**2


def amplitude_eq5(wavelength, psd):
    return sqrt(psd / (mpf("1.5") * wavelength))


def amplitudes_parseval(spectrum):
    """sqrt(2 x (1/pi) x integral of C over the sample's own band).

    Band edges are the geometric means of neighbouring wavevectors; the first
    band starts at the first sample, the last one ends at the last sample.
    """
    halves = []                   # integrals over the two halves of each interval
    for (long, c1), (short, c2) in zip(spectrum, spectrum[1:]):
        q1, q2 = 2 * pi / long, 2 * pi / short
        middle_q, middle_c = sqrt(q1 * q2), sqrt(c1 * c2)
        halves.append((power_law_integral(0, q1, c1, middle_q, middle_c),
                       power_law_integral(0, middle_q, middle_c, q2, c2)))
    for i in range(len(spectrum)):
        band = mpf(0)
        if i > 0:
            band += halves[i - 1][1]
        if i < len(halves):
            band += halves[i][0]
        yield sqrt(2 * band / pi)


def resample(spectrum, per_decade):
    """round(n x decades) + 1 geometric points, both ends kept."""
    first, last = spectrum[0][0], spectrum[-1][0]
    decades = log(first / last) / log(mpf(10))
    count = int(nint(per_decade * decades)) + 1
    result = []
    interval = 0
    for j in range(count):
        if j == 0 or j == count - 1:
            result.append(spectrum[0 if j == 0 else -1])
            continue
        wavelength = first * exp(log(last / first) * j / (count - 1))
        while spectrum[interval + 1][0] > wavelength:
            interval += 1
        (long, c1), (short, c2) = spectrum[interval], spectrum[interval + 1]
        share = log(long / wavelength) / log(long / short)
        result.append((wavelength, c1 * exp(share * log(c2 / c1))))
    return result
