//! The provenance of a written file: program, request, and remarks of the spectrum's own file.

use study::plan::Sampling;
use study::surface::Surface;
use units::number;

/// The line that begins the provenance of any file.
pub fn program(asked: &str) -> String {
    format!("truearea {}: {asked}", env!("CARGO_PKG_VERSION"))
}

/// The comment lines of a file made from a spectrum.
pub fn provenance(asked: &str, surface: &Surface, sampling: Sampling) -> Vec<String> {
    let mut lines = vec![program(asked)];
    lines.extend(of_surface(surface));
    if let Some(n) = sampling.scales_per_decade {
        lines.push(format!("resampled to {n} scales per decade"));
    }
    if let Some(cutoff_m) = sampling.cutoff_m {
        lines.push(format!("cut off at {} m", number(cutoff_m)));
    }
    lines
}

/// The comment lines on the spectrum of a file, with the remarks of its own file.
pub fn of_surface(surface: &Surface) -> Vec<String> {
    let says = surface.remarks.iter().map(|remark| format!("spectrum says: {remark}"));
    let made_of = surface.each().into_iter().filter_map(|part| part.roughness).map(|given| {
        let parameters = given.profile.parameters();
        format!(
            "spectrum made from Rq = {} m, Rdq = {}, roll-off wavelength {} m, Hurst exponent {}",
            number(parameters.rms_height_m),
            number(parameters.rms_slope),
            number(parameters.rolloff_m),
            number(parameters.hurst_exponent)
        )
    });
    std::iter::once(format!("spectrum: {}", surface.name)).chain(says).chain(made_of).collect()
}
