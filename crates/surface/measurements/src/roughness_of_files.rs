//! Roughness parameters of the scans in files, one row each.

use roughness::{Evaluation, Parameter, ParameterValue, parameters};
use scans::ScanFile;
use tables::Table;
use units::printable::printable_line;

use crate::error::TopographyError;
use crate::evaluated::EvaluatedScan;
use crate::files::Files;
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
#[derive(Debug)]
#[non_exhaustive]
pub struct RoughnessOfFiles {
    scans: Vec<EvaluatedScan<Vec<Parameter>>>,
    /// Files without a result, with the error of each.
    pub unreadable: Vec<TopographyError>,
}

impl RoughnessOfFiles {
    /// Evaluates the scans that a spectrum would be made of. A file that cannot be evaluated is listed in
    /// [`RoughnessOfFiles::unreadable`].
    #[must_use]
    pub fn read(requests: &[ScanRequest], files: &dyn Files, settings: &RoughnessSettings) -> Self {
        let of = |request: &ScanRequest, scan: &ScanFile| evaluated(request, scan, settings);
        let (scans, unreadable) = EvaluatedScan::of_files(requests, files, of);
        RoughnessOfFiles { scans, unreadable }
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
        let scans = vec![evaluated(request, scan, settings)?];
        Ok(RoughnessOfFiles { scans, unreadable: Vec::new() })
    }

    /// Makes a table with the columns `file, channel, parameter, value, unit, convention`; lengths are in um, as in the
    /// standards.
    #[must_use]
    pub fn table(&self) -> Table {
        let rows =
            || self.scans.iter().flat_map(|scan| scan.found.iter().map(move |parameter| (scan, parameter)));
        Table::default()
            .with_text("file", rows().map(|(scan, _)| scan.file.clone()))
            .with_text("channel", rows().map(|(scan, _)| scan.channel.clone()))
            .with_text("parameter", rows().map(|(_, parameter)| parameter.symbol.to_owned()))
            .with_numbers("value", rows().map(|(_, parameter)| in_unit(parameter.value).0))
            .with_text("unit", rows().map(|(_, parameter)| in_unit(parameter.value).1.to_owned()))
            .with_text("convention", rows().map(|(_, parameter)| parameter.convention.clone()))
    }

    /// Describes the parameters for people, with three digits.
    #[must_use]
    pub fn describe(&self) -> String {
        let described = self.scans.iter().map(|scan| {
            let mut lines = vec![printable_line(&scan.title()).into_owned()];
            lines.extend(scan.found.iter().map(|parameter| match parameter.convention.as_str() {
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
        self.scans.iter().flat_map(|scan| scan.notes().chain(scan.left_out())).collect()
    }
}

fn evaluated(
    request: &ScanRequest,
    scan: &ScanFile,
    settings: &RoughnessSettings,
) -> Result<EvaluatedScan<Vec<Parameter>>, TopographyError> {
    EvaluatedScan::new(request, scan, &settings.evaluation, |relief| {
        let mut parameters = parameters(relief, settings.ratio_height_m);
        parameters.retain(|parameter| settings.conventions == Conventions::All || parameter.is_first);
        parameters
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
