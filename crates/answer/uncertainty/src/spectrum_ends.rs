//! The ends of a spectrum as power laws, to prolong it and to see whether an area can settle.

use spectrum::ProfilePsd;

/// The decades at an end that define its power law.
const TELLING_DECADES: f64 = 1.0;

/// The decades by which a spectrum is prolonged.
const PROLONGED_DECADES: f64 = 0.5;

/// The fewest samples of a power law with a scatter.
const MIN_SAMPLES: usize = 3;

/// An end of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// The end at long wavelengths.
    Long,
    /// The end at short wavelengths.
    Short,
}

/// A power law through an end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PowerLaw {
    /// d ln C/d ln q.
    pub slope: f64,
    /// Its standard error from the scatter about the law.
    pub standard_error: f64,
}

impl PowerLaw {
    /// Fits the last decade at an end; `None` with fewer than three samples.
    pub fn at(end: End, psd: &ProfilePsd) -> Option<Self> {
        let wavelengths_m = psd.wavelengths_m();
        let end_m = match end {
            End::Long => psd.longest_wavelength_m(),
            End::Short => psd.shortest_wavelength_m(),
        };
        let is_near = |wavelength_m: f64| (wavelength_m / end_m).log10().abs() <= TELLING_DECADES;
        let samples: Vec<(f64, f64)> = wavelengths_m
            .iter()
            .zip(psd.c1d_m3())
            .filter(|(wavelength_m, _)| is_near(**wavelength_m))
            .map(|(wavelength_m, c1d_m3)| (-wavelength_m.ln(), c1d_m3.ln()))
            .collect();
        let count = samples.len() as f64;
        if samples.len() < MIN_SAMPLES {
            return None;
        }
        let mean = |of: fn(&(f64, f64)) -> f64| samples.iter().map(of).sum::<f64>() / count;
        let (mean_x, mean_y) = (mean(|sample| sample.0), mean(|sample| sample.1));
        let squares: f64 = samples.iter().map(|(x, _)| (x - mean_x).powi(2)).sum();
        let slope = samples.iter().map(|(x, y)| (x - mean_x) * (y - mean_y)).sum::<f64>() / squares;
        let off: f64 = samples.iter().map(|(x, y)| (y - mean_y - slope * (x - mean_x)).powi(2)).sum();
        Some(PowerLaw { slope, standard_error: (off / (count - 2.0) / squares).sqrt() })
    }
}

/// Prolongs a spectrum by half a decade at an end, from its last sample on, by a power law of this slope.
pub(crate) fn prolonged(psd: &ProfilePsd, end: End, slope: f64) -> Option<ProfilePsd> {
    let mut samples: Vec<(f64, f64)> =
        psd.wavelengths_m().iter().copied().zip(psd.c1d_m3().iter().copied()).collect();
    const STEPS: i32 = 5;
    let (last_m, last_m3) = match end {
        End::Long => *samples.first()?,
        End::Short => *samples.last()?,
    };
    for step in 1..=STEPS {
        let decades = PROLONGED_DECADES * f64::from(step) / f64::from(STEPS);
        let longer = 10f64.powf(if end == End::Long { decades } else { -decades });
        samples.push((last_m * longer, last_m3 * longer.powf(-slope)));
    }
    samples.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (wavelengths_m, c1d_m3) = samples.into_iter().unzip();
    ProfilePsd::new(wavelengths_m, c1d_m3).ok()
}

/// The new end \[m\] of a prolonged spectrum.
pub(crate) fn prolonged_to_m(psd: &ProfilePsd, end: End) -> f64 {
    let factor = 10f64.powf(PROLONGED_DECADES);
    match end {
        End::Long => psd.longest_wavelength_m() * factor,
        End::Short => psd.shortest_wavelength_m() / factor,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_power_law_goes_on_as_it_is() {
        let wavelengths_m: Vec<f64> = (0..21).map(|at| 10f64.powf(-5.0 - 0.1 * f64::from(at))).collect();
        let law = |wavelength_m: f64| 1e-20 * (wavelength_m / 1e-6).powf(2.6);
        let psd =
            ProfilePsd::new(wavelengths_m.clone(), wavelengths_m.iter().map(|&m| law(m)).collect()).unwrap();
        for end in [End::Long, End::Short] {
            let found = PowerLaw::at(end, &psd).unwrap();
            assert!((found.slope + 2.6).abs() < 1e-10 && found.standard_error < 1e-10, "{found:?}");
            let longer = prolonged(&psd, end, found.slope).unwrap();
            assert_eq!(longer.len(), 26);
            for (wavelength_m, c1d_m3) in longer.wavelengths_m().iter().zip(longer.c1d_m3()) {
                assert!((c1d_m3 / law(*wavelength_m) - 1.0).abs() < 1e-9);
            }
        }
        assert_eq!(PowerLaw::at(End::Short, &ProfilePsd::new(vec![2.0, 1.0], vec![1.0, 1.0]).unwrap()), None);
    }
}
