//! Roughness parameters of the scans in files, one row each.

use roughness::{Evaluation, Parameter, ParameterValue, ScaleLimitedSurface, parameters};
use scans::ScanFile;
use tables::Table;
use units::display::counted;
use units::printable::printable_line;

use crate::channels::channel;
use crate::error::{ScanProblem, TopographyError};
use crate::files::Files;
use crate::load::load;
use crate::request::ScanRequest;

/// Conventions of parameters that the standards leave open.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Conventions {
    /// The first of each parameter.
    #[default]
    Usual,
    /// All that are in use.
    All,
}

units::named!(Conventions, "convention", { Usual => "usual", All => "all" });

/// Settings of [`RoughnessOfFiles::read`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoughnessSettings {
    /// Form and filters.
    pub evaluation: Evaluation,
    /// Height \[m\] from the mean at which the material ratio is taken.
    pub ratio_height_m: f64,
    /// Conventions to list.
    pub conventions: Conventions,
}

/// The roughness of the scans in some files.
#[derive(Debug, Default)]
#[non_exhaustive]
pub struct RoughnessOfFiles {
    surfaces: Vec<RoughSurface>,
    /// Files without a result, with the error of each.
    pub unreadable: Vec<TopographyError>,
}

#[derive(Debug)]
struct RoughSurface {
    file: String,
    channel: String,
    parameters: Vec<Parameter>,
    missing: usize,
}

impl RoughnessOfFiles {
    /// Evaluates the scans that a spectrum would be made of. A file that cannot be evaluated is listed in
    /// [`RoughnessOfFiles::unreadable`].
    #[must_use]
    pub fn read(requests: &[ScanRequest], files: &dyn Files, settings: &RoughnessSettings) -> Self {
        let mut found = RoughnessOfFiles::default();
        for request in requests {
            match of_file(request, files, settings) {
                Ok(surfaces) => found.surfaces.extend(surfaces),
                Err(error) => found.unreadable.push(error),
            }
        }
        found
    }

    /// Evaluates a scan in memory.
    ///
    /// # Errors
    /// [`TopographyError`] if no heights are left to evaluate.
    pub fn of_scan(
        request: &ScanRequest,
        scan: &ScanFile,
        settings: &RoughnessSettings,
    ) -> Result<Self, TopographyError> {
        let surface = rough_surface(request, scan, settings)?;
        Ok(RoughnessOfFiles { surfaces: vec![surface], unreadable: Vec::new() })
    }

    /// Makes a table with the columns `file, channel, parameter, value, unit, convention`; lengths are in um, as in the
    /// standards.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows = || {
            self.surfaces
                .iter()
                .flat_map(|surface| surface.parameters.iter().map(move |parameter| (surface, parameter)))
        };
        Table::default()
            .with_text("file", rows().map(|(surface, _)| surface.file.clone()))
            .with_text("channel", rows().map(|(surface, _)| surface.channel.clone()))
            .with_text("parameter", rows().map(|(_, parameter)| parameter.symbol.to_owned()))
            .with_numbers("value", rows().map(|(_, parameter)| in_unit(parameter.value).0))
            .with_text("unit", rows().map(|(_, parameter)| in_unit(parameter.value).1.to_owned()))
            .with_text("convention", rows().map(|(_, parameter)| parameter.convention.clone()))
    }

    /// Describes the parameters for people, with three digits.
    #[must_use]
    pub fn describe(&self) -> String {
        let described = self.surfaces.iter().map(|surface| {
            let mut lines = vec![printable_line(&surface.title()).into_owned()];
            lines.extend(surface.parameters.iter().map(|parameter| match parameter.convention.as_str() {
                "" => parameter.to_string(),
                convention => format!("{parameter} ({convention})"),
            }));
            lines.join("\n  ") + "\n"
        });
        described.collect()
    }

    /// Lists what a reader should know of the surfaces, a sentence each without a full stop.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let incomplete = self.surfaces.iter().filter(|surface| surface.missing > 0);
        incomplete.map(|surface| left_out(&surface.file, &surface.channel, surface.missing)).collect()
    }
}

impl RoughSurface {
    fn title(&self) -> String {
        title(&self.file, &self.channel)
    }
}

/// The name of a scan: its file, and its channel if the file names one.
fn title(file: &str, channel: &str) -> String {
    match channel {
        "" => file.to_owned(),
        channel => format!("{file}, {channel}"),
    }
}

/// The note that points of a scan have no height.
pub(crate) fn left_out(file: &str, channel: &str, missing: usize) -> String {
    format!("{}: {} without a height left out", title(file, channel), counted(missing, "point"))
}

fn of_file(
    request: &ScanRequest,
    files: &dyn Files,
    settings: &RoughnessSettings,
) -> Result<Vec<RoughSurface>, TopographyError> {
    let loaded = load(request, files)?;
    loaded.scans.iter().map(|scan| rough_surface(request, scan, settings)).collect()
}

fn rough_surface(
    request: &ScanRequest,
    scan: &ScanFile,
    settings: &RoughnessSettings,
) -> Result<RoughSurface, TopographyError> {
    let relief = ScaleLimitedSurface::new(&scan.scan, &settings.evaluation)
        .map_err(|error| TopographyError::for_file(&request.path, ScanProblem::Relief(error)))?;
    let mut parameters = parameters(&relief, settings.ratio_height_m);
    parameters.retain(|parameter| settings.conventions == Conventions::All || parameter.is_first);
    Ok(RoughSurface {
        file: request.path.clone(),
        channel: channel(request, scan),
        parameters,
        missing: relief.missing(),
    })
}

/// Returns a value in the unit of tables.
fn in_unit(value: ParameterValue) -> (Option<f64>, &'static str) {
    match value {
        ParameterValue::LengthM(value_m) => (Some(1e6 * value_m), "um"),
        ParameterValue::Number(value) => (Some(value), "1"),
        ParameterValue::Share(share) => (Some(100.0 * share), "%"),
        ParameterValue::VolumeM(value_m) => (Some(1e6 * value_m), "um3/um2"),
        ParameterValue::NotDetermined => (None, ""),
    }
}
