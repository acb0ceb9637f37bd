//! Lines of a Gaussian surface that are not periodic.

use numerics::transforms::Complex64;

use super::instrument::Instrument;
use super::random::Normals;
use super::surface::KnownSurface;
use crate::TrialError;

/// Length of the periodic line, in lengths of a line cut from it.
const PERIODS: usize = 4;

/// Waves of a periodic line, from which lines are cut.
#[derive(Debug, Clone)]
pub(crate) struct LineMaker {
    points: usize,
    /// Root mean square of the waves n = 1, 2, ... \[m\].
    of_waves_m: Vec<f64>,
}

impl LineMaker {
    pub(crate) fn new(surface: &KnownSurface, instrument: &Instrument) -> Result<Self, TrialError> {
        let points = PERIODS * instrument.points;
        let period_m = PERIODS as f64 * instrument.length_m;
        let wavelengths_m: Vec<f64> = (1..points / 2).map(|wave| period_m / wave as f64).collect();
        let profile = surface.profile(&wavelengths_m)?;
        // The variance is (1/pi) Int C1D dq, and waves are 2 pi/period apart.
        let of_waves_m = profile.c1d_m3().iter().map(|c1d_m3| (2.0 * c1d_m3 / period_m).sqrt()).collect();
        Ok(LineMaker { points: instrument.points, of_waves_m })
    }

    /// Heights \[m\].
    pub(crate) fn line(&self, normals: &mut Normals) -> Vec<f64> {
        let transform = numerics::transforms::inverse_to_real(PERIODS * self.points);
        let mut waves = transform.make_input_vec();
        for (wave, rms_m) in waves[1..].iter_mut().zip(&self.of_waves_m) {
            *wave = Complex64::new(normals.next(), normals.next()) * (0.5 * rms_m);
        }
        let mut heights_m = transform.make_output_vec();
        transform.process(&mut waves, &mut heights_m).expect("the buffers come from the transform");
        heights_m.truncate(self.points);
        heights_m
    }
}
