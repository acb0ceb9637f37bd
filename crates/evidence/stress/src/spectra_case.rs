//! Tables of spectra: their numbers, and the promises of everything computed from a spectrum.

use std::f64::consts::PI;
use std::num::NonZeroU32;

use spectrum::random_surfaces::AreaSpectrum;
use spectrum::{
    AmplitudeDefinition, AsperityParameters, Convention, Moments, Normalisation, ProfilePsd, Psd, amplitudes,
    cumulative_moments, fit_self_affine, superpose,
};

use crate::drawn_spectrum::drawn_spectrum;
use crate::tally::{Case, Refused, Trial};
use crate::{Draw, Reach};

/// Wavelengths \[m\] and densities \[m^3\], in any order and with repeats; printed, it is a literal that recreates it.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectraCase {
    /// The table.
    pub rows: Vec<(f64, f64)>,
    /// Samples per decade of a new sampling.
    pub per_decade: u32,
}

impl SpectraCase {
    fn profile(&self) -> Result<ProfilePsd, spectrum::PsdError> {
        let (wavelengths_m, c1d_m3) = self.rows.iter().copied().unzip();
        ProfilePsd::new(wavelengths_m, c1d_m3)
    }

    fn is_in_order(&self) -> bool {
        self.rows.windows(2).all(|pair| pair[0].0 > pair[1].0 * (1.0 + 16.0 * f64::EPSILON))
    }
}

impl Case for SpectraCase {
    fn draw(draw: &mut Draw) -> (Self, Reach) {
        let reach = Reach::draw(draw);
        let mut rows = drawn_spectrum(draw, reach);
        let place = draw.between(0.0, rows.len() as f64) as usize;
        match draw.between(0.0, 1.0) {
            share if share < 0.05 => rows.insert(place, rows[place]),
            share if share < 0.1 => rows.reverse(),
            share if share < 0.13 => rows[place].1 = draw.one_of(&[0.0, -1.0, f64::NAN, f64::INFINITY]),
            share if share < 0.16 => rows[place].0 = draw.one_of(&[0.0, -1.0, f64::NAN, f64::INFINITY]),
            _ => (),
        }
        (SpectraCase { rows, per_decade: draw.between(1.0, 60.0) as u32 }, reach)
    }

    fn test(trial: &mut Trial<Self>) -> Result<(), Refused> {
        let case = trial.case;
        let within = |value: f64, decades: i32| (10f64.powi(-decades)..=10f64.powi(decades)).contains(&value);
        let is_sample = |row: &(f64, f64)| within(row.0, 30) && within(row.1, 90);
        let is_table = case.rows.iter().all(is_sample) && case.is_in_order();
        let profile = match case.profile() {
            Ok(profile) => profile,
            Err(_) => {
                trial.hold("a table of a spectrum is taken", !is_table);
                return Err(Refused);
            }
        };
        trial.hold("other tables are refused", is_table);
        moments(&profile, trial);
        sizes(&profile, trial);
        sampled_again(&profile, trial);
        fitted(&profile, trial);
        converted(trial);
        if trial.reach != Reach::Edge {
            of_area(&profile, trial);
        }
        Ok(())
    }
}

/// Checks the moments along a spectrum.
fn moments(profile: &ProfilePsd, trial: &mut Trial<SpectraCase>) {
    let moments = cumulative_moments(profile, Normalisation::Parseval);
    trial.hold("a row of moments per interval", moments.len() + 1 == profile.len());
    let values = |row: &Moments| [row.m0_m2, row.m2, row.m4_per_m2];
    let finite = moments.iter().flat_map(values).all(|value| value >= 0.0 && value.is_finite());
    trial.hold("moments finite, at least 0", finite);
    for power in 0..3 {
        let rises = moments.is_sorted_by(|long, short| values(long)[power] <= values(short)[power]);
        trial.hold("moments rise along the spectrum", rises);
    }
    for row in &moments {
        let alpha = (row.m0_m2 / row.m2) * (row.m4_per_m2 / row.m2);
        // Denormal moments have no digits.
        if values(row).iter().all(|value| value.is_normal()) {
            trial.bound("alpha at least 1", 1.0 / alpha, 1.0 + 1e-12);
        }
        if let Some(asperities) = AsperityParameters::from_moments(row) {
            let sizes =
                [asperities.radius_m, asperities.density_per_m2, asperities.sigma_s_m, asperities.offset_m];
            trial
                .hold("asperities finite, above 0", sizes.iter().all(|size| *size > 0.0 && size.is_finite()));
        }
    }
    let printed = cumulative_moments(profile, Normalisation::AsPrinted);
    if let (Some(last), Some(printed)) = (moments.last(), printed.last())
        && last.m2.is_normal()
    {
        trial.bound("normalisations differ by pi", (printed.m2 / last.m2 / PI - 1.0).abs(), 1e-14);
    }
}

/// Checks the amplitudes of the scales.
fn sizes(profile: &ProfilePsd, trial: &mut Trial<SpectraCase>) {
    for definition in AmplitudeDefinition::ALL {
        let scales = amplitudes(profile, *definition);
        let sound = scales.iter().all(|scale| scale.amplitude_m >= 0.0 && scale.amplitude_m.is_finite());
        trial.hold("amplitudes finite, at least 0", sound && scales.len() == profile.len());
    }
    let squares: f64 = amplitudes(profile, AmplitudeDefinition::Parseval)
        .iter()
        .map(|scale| scale.amplitude_m * scale.amplitude_m)
        .sum();
    if let Some(last) = cumulative_moments(profile, Normalisation::Parseval).last()
        && last.m0_m2 > 1e-290
        && last.m0_m2 < 1e290
    {
        trial.bound(
            "squares of amplitudes are twice the variance",
            (0.5 * squares / last.m0_m2 - 1.0).abs(),
            1e-11,
        );
    }
}

/// Checks values between samples, new samples, cuts and holes.
fn sampled_again(profile: &ProfilePsd, trial: &mut Trial<SpectraCase>) {
    let case = trial.case;
    let ends = |profile: &ProfilePsd| [profile.longest_wavelength_m(), profile.shortest_wavelength_m()];
    let decades = (ends(profile)[0] / ends(profile)[1]).log10();
    if let Some(per_decade) = NonZeroU32::new(case.per_decade).filter(|_| decades < 200.0) {
        let again = profile.resampled(per_decade);
        trial.hold("new samples keep both ends", ends(&again) == ends(profile));
        let falls = again.wavelengths_m().is_sorted_by(|long, short| long > short);
        trial.hold("new wavelengths fall", falls);
        let sound = again.c1d_m3().iter().all(|value| *value > 0.0 && value.is_finite());
        trial.hold("new densities finite, above 0", sound);
    }
    for (at, (&wavelength_m, &value)) in profile.wavelengths_m().iter().zip(profile.c1d_m3()).enumerate() {
        trial.hold("value at a sample", profile.value_at(wavelength_m) == Some(value));
        let cut = profile.truncated_at(wavelength_m);
        trial.hold("a cut keeps the samples from it up", cut.is_some_and(|cut| cut.len() == at + 1));
    }
    for hole in profile.holes() {
        let [longest_m, shortest_m] = ends(profile);
        let inside = hole.longest_m <= longest_m && hole.shortest_m >= shortest_m;
        trial.hold("holes within the spectrum", inside && hole.longest_m > hole.shortest_m);
        let share = hole.share_of(longest_m, shortest_m);
        trial.hold("share of a hole in [0, 1]", (0.0..=1.0 + 1e-12).contains(&share));
    }
    let twice = superpose(profile, profile);
    let doubled = twice.psd.c1d_m3().iter().all(|value| *value > 0.0);
    trial.hold(
        "a spectrum on itself",
        doubled && twice.psd.wavelengths_m().is_sorted_by(|long, short| long > short),
    );
}

/// Checks the self-affine fit.
fn fitted(profile: &ProfilePsd, trial: &mut Trial<SpectraCase>) {
    match fit_self_affine(profile, ..) {
        Err(_) => trial.hold("two samples have a fit", profile.len() < 2),
        Ok(fit) => {
            trial.hold("Hurst exponent finite", fit.hurst_exponent.is_finite());
            let residual = fit.rms_log10_residual;
            trial.hold("residual of the fit finite, at least 0", residual >= 0.0 && residual.is_finite());
            let error = fit.hurst_exponent_se.is_none_or(|error| error >= 0.0 && error.is_finite());
            trial.hold("error of the Hurst exponent finite, at least 0", error);
            let inside = |wavelength_m: f64| {
                (profile.shortest_wavelength_m()..=profile.longest_wavelength_m()).contains(&wavelength_m)
            };
            let rolls =
                fit.rolloff.is_none_or(|rolloff| rolloff.plateau_m3 > 0.0 && inside(rolloff.wavelength_m));
            trial.hold("roll-off within the spectrum", rolls);
        }
    }
}

/// Checks conventions there and back.
fn converted(trial: &mut Trial<SpectraCase>) {
    let case = trial.case;
    let [from, to] = [0, 1].map(|_| trial.draw.one_of(Convention::ALL));
    let (wavelengths_m, values): (Vec<f64>, Vec<f64>) = case.rows.iter().copied().unzip();
    let Ok(psd) = Psd::new(wavelengths_m, values, from) else {
        trial.hold("two rows are a spectrum", case.rows.len() < 2);
        return;
    };
    let Ok(there) = psd.to(to) else { return };
    let sound = there.values().iter().all(|value| *value > 0.0 && value.is_finite());
    trial.hold("converted densities finite, above 0", sound);
    let Ok(back) = there.to(from) else {
        trial.hold("a factor has an inverse", false);
        return;
    };
    let off = psd.values().iter().zip(back.values()).filter(|(value, _)| value.is_normal());
    let off = off.map(|(here, there)| (there / here - 1.0).abs()).fold(0.0, f64::max);
    let normal = there.values().iter().all(|value| value.is_normal());
    trial.bound("conventions there and back", if normal { off } else { 0.0 }, 1e-12);
}

/// Checks the spectrum of the area.
fn of_area(profile: &ProfilePsd, trial: &mut Trial<SpectraCase>) {
    let Ok(area) = AreaSpectrum::from_profile(profile) else {
        // One that rises somewhere may be smoothed to a level, which no surface has.
        let falls = profile.c1d_m3().windows(2).all(|pair| pair[1] < pair[0]);
        trial.hold("a spectrum that falls has a surface", profile.len() < 2 || !falls);
        return;
    };
    let values =
        [area.mean_square_height_m2(), area.mean_square_gradient(), area.mean_square_laplacian_per_m2()];
    trial.hold(
        "moments of the area finite, at least 0",
        values.iter().all(|value| *value >= 0.0 && value.is_finite()),
    );
    let of_profiles = area.moments();
    if of_profiles.m2.is_normal() {
        let ratio = area.mean_square_gradient() / of_profiles.m2;
        trial.bound("gradient of the area is twice the slope of profiles", (0.5 * ratio - 1.0).abs(), 1e-12);
    }
    let conversion = area.conversion();
    let shares = [conversion.levelled_share];
    trial.hold("shares of the conversion in [0, 1]", shares.iter().all(|share| (0.0..=1.0).contains(share)));
    let middle_m = (area.longest_m() * area.shortest_m()).sqrt();
    trial.hold("density of the area at least 0", area.ciso_m4(std::f64::consts::TAU / middle_m) >= 0.0);
}
