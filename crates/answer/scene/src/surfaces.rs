//! The surfaces of a scene: a spectrum, scans to make one of, or roughness parameters; with the surface of the
//! counterface added if it has one.

use serde_spanned::Spanned;
use spectrum::ReadOptions;

use super::error::SceneError;
use super::raw::{RawScan, RawSurface, given};
use super::roughness::{keys as roughness_keys, resolve_roughness};
use super::values::count;
use measurements::{Files, ScanRequest};
use study::surface::{Surface, SurfaceError};
use topography::{DEFAULT_BINS_PER_DECADE, Recipe};

/// The surface under this key of the scene, its files from `files`.
pub(super) fn resolve_surface(
    key: &str,
    raw: &Spanned<RawSurface>,
    files: &dyn Files,
) -> Result<Surface, SceneError> {
    let surface = raw.get_ref();
    let parameter = roughness_keys(surface).into_iter().find(|(_, given)| *given).map(|(name, _)| name);
    match (&surface.psd, &surface.scans[..], parameter) {
        (Some(psd), [], None) => {
            refuse_idle_keys(key, raw)?;
            spectrum(surface, psd, files)
        }
        (None, [_, ..], None) => {
            refuse_idle_keys(key, raw)?;
            composite(key, surface, files)
        }
        (None, [], Some(_)) => {
            refuse_idle_keys(key, raw)?;
            resolve_roughness(key, raw)
        }
        (Some(_), [_, ..], _) => {
            Err(SceneError::at(raw.span(), format!("[{key}] has both psd and scans; keep one of them")))
        }
        (psd, _, Some(parameter)) => {
            let measured = if psd.is_some() { "psd" } else { "scans" };
            let message = format!(
                "[{key}] has both {measured} and {parameter}; roughness parameters stand in place of a measured spectrum: keep \
                 one of them"
            );
            Err(SceneError::at(raw.span(), message))
        }
        (None, [], None) => {
            let message = format!(
                "[{key}] needs psd = \"...\", or scans = [{{ file = \"...\" }}], or rms_height, rms_slope and mean_width or \
                 rolloff_wavelength"
            );
            Err(SceneError::at(raw.span(), message))
        }
    }
}

/// Refuses keys that have no effect on the given kind of surface: silently ignoring them would be worse than an error.
fn refuse_idle_keys(key: &str, raw: &Spanned<RawSurface>) -> Result<(), SceneError> {
    let surface = raw.get_ref();
    let of_spectra = [
        ("column", surface.column.is_some()),
        ("x", surface.x.is_some()),
        ("convention", surface.convention.is_some()),
        ("series", surface.series.is_some()),
        ("subject", surface.subject.is_some()),
        ("x_unit", surface.x_unit.is_some()),
        ("psd_unit", surface.psd_unit.is_some()),
    ];
    let of_scans = [
        ("detrend", surface.detrend.is_some()),
        ("window", surface.window.is_some()),
        ("average", surface.average.is_some()),
        ("line_average", surface.line_average.is_some()),
        ("remove_spikes", surface.remove_spikes.is_some()),
        ("bins_per_decade", surface.bins_per_decade.is_some()),
    ];
    let [spectra, scans] = [(&of_spectra[..], "a psd"), (&of_scans[..], "scans")];
    let (idle, given) = match (&surface.psd, &surface.scans[..]) {
        (Some(_), _) => (vec![scans], "psd"),
        (None, [_, ..]) => (vec![spectra], "scans"),
        (None, []) => (vec![spectra, scans], "roughness parameters"),
    };
    let first_of = |(keys, what): (&[(&'static str, bool)], &'static str)| {
        keys.iter().find(|(_, given)| *given).map(|(name, _)| (*name, what))
    };
    match idle.into_iter().find_map(first_of) {
        Some((name, what)) => {
            let verb = if given == "roughness parameters" { "are" } else { "is" };
            let message = format!("key {key}.{name} is for {what}, and {given} {verb} given; leave it out");
            Err(SceneError::at(raw.span(), message))
        }
        None => Ok(()),
    }
}

fn spectrum(surface: &RawSurface, psd: &Spanned<String>, files: &dyn Files) -> Result<Surface, SceneError> {
    let options = ReadOptions {
        column: surface.column.clone(),
        x: given(&surface.x),
        convention: given(&surface.convention),
        series: surface.series.clone(),
        subject: surface.subject.clone(),
        x_unit: surface.x_unit.clone(),
        psd_unit: surface.psd_unit.clone(),
    };
    Surface::load(psd.get_ref(), files, &options).map_err(|error| SceneError::at(psd.span(), error))
}

fn composite(key: &str, surface: &RawSurface, files: &dyn Files) -> Result<Surface, SceneError> {
    let bins_per_decade = surface.bins_per_decade.as_ref();
    let recipe = Recipe {
        detrend: surface.detrend,
        window: surface.window,
        average: surface.average.unwrap_or_default(),
        line_average: surface.line_average.unwrap_or_default(),
        remove_spikes: surface.remove_spikes.unwrap_or_default(),
        bins_per_decade: bins_per_decade
            .map(|raw| count(&format!("{key}.bins_per_decade"), raw))
            .transpose()?
            .unwrap_or(DEFAULT_BINS_PER_DECADE),
        ..Recipe::default()
    };
    let requests: Vec<ScanRequest> = surface.scans.iter().map(|raw| request(raw.get_ref())).collect();
    Surface::from_scans(&requests, files, &recipe).map_err(|error| {
        let all = surface.scans[0].span().start..surface.scans[surface.scans.len() - 1].span().end;
        let request = match &error {
            SurfaceError::Scans(error) => error.request,
            _ => None,
        };
        SceneError::at(request.map_or(all, |request| surface.scans[request].span()), error)
    })
}

fn request(raw: &RawScan) -> ScanRequest {
    let raw = match raw {
        RawScan::Table(keys) => keys,
        RawScan::Other(file) => return ScanRequest { path: file.clone(), ..ScanRequest::default() },
    };
    ScanRequest {
        path: raw.file.clone(),
        unit: given(&raw.unit),
        height_unit: given(&raw.height_unit),
        channel: raw.channel.clone(),
        measurement: None,
        size_m: given(&raw.size).map(|size| size.m),
        tip_radius: given(&raw.tip_radius),
        gaps: raw.gaps,
        direction: raw.direction,
        detrend: raw.detrend,
        instrument: raw.instrument.as_ref().map(|typed| typed.value.0.clone()),
        z_calibration: given(&raw.z_calibration).map(|calibration| calibration.share),
        slope_uncertainty: given(&raw.slope_uncertainty).map(|slope| slope.standard_uncertainty),
        shortest_m: given(&raw.shortest_wavelength).map(|wavelength| wavelength.m),
    }
}
