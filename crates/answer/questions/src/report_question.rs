//! A report on a contact: surfaces, bodies and loads, as a scene that repeats it.

use std::fmt::Write;

use measurements::{Files, ScanRequest, TipRadius};
use serde::{Deserialize, Serialize};
use spectrum::ReadOptions;
use study::surface::{Surface, SurfaceError};
use toml::Value;

/// The line that begins the scene of a report.
const FIRST_LINE: &str = "# Made by `truearea report`. `truearea run` on this file repeats it.";

/// A question for everything that follows from surfaces, bodies and loads: all models that apply, their verdicts and
/// intervals, and a report. Quantities are text with a unit, as a scene takes them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ReportQuestion {
    /// The title; that of the surface if absent.
    pub title: Option<String>,
    /// The roughness.
    pub surface: ReportSurface,
    /// The rough body.
    pub material: BodyText,
    /// The counterface; rigid if absent.
    pub counterface: Option<BodyText>,
    /// The nominal pressures.
    pub pressures: Vec<String>,
    /// Upper limit of the depth-dependent yield strength.
    pub strength_cap: Option<String>,
    /// True to ask from which pressure on the contact seals.
    pub seal: bool,
}

/// The roughness of a report.
#[derive(Debug, Clone, PartialEq)]
pub enum ReportSurface {
    /// Scans, whose spectrum is made.
    Scans(Vec<ScanRequest>),
    /// The file of a spectrum, or a built-in one.
    Psd(String),
}

impl Default for ReportSurface {
    fn default() -> Self {
        ReportSurface::Scans(Vec::new())
    }
}

impl ReportSurface {
    /// Takes one file as a spectrum if it holds one, and otherwise all files as scans.
    ///
    /// # Errors
    /// [`SurfaceError::NoSuchBuiltin`].
    pub fn of_files(requests: Vec<ScanRequest>, files: &dyn Files) -> Result<Self, SurfaceError> {
        if let [request] = &requests[..] {
            match Surface::load(&request.path, files, &ReadOptions::default()) {
                Ok(_) => return Ok(ReportSurface::Psd(request.path.clone())),
                Err(error @ SurfaceError::NoSuchBuiltin { .. }) => return Err(error),
                Err(_) => {}
            }
        }
        Ok(ReportSurface::Scans(requests))
    }

    /// Returns the section `[surface]` of a scene.
    #[must_use]
    pub fn section(&self) -> String {
        match self {
            ReportSurface::Psd(name) => format!("[surface]\npsd = {}\n", quoted(name)),
            ReportSurface::Scans(scans) => {
                let lines: Vec<String> =
                    scans.iter().map(|scan| format!("    {},\n", scan_keys(scan))).collect();
                format!("[surface]\nscans = [\n{}]\n", lines.concat())
            }
        }
    }
}

/// Properties of a body, as text with units.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BodyText {
    /// A name from the table of materials, which fills the other properties.
    pub name: Option<String>,
    /// Young's modulus.
    pub youngs_modulus: Option<String>,
    /// Poisson's ratio.
    pub poisson_ratio: Option<String>,
    /// Yield strength.
    pub yield_strength: Option<String>,
    /// Indentation hardness.
    pub indentation_hardness: Option<String>,
    /// Strain-gradient length.
    pub strain_gradient_length: Option<String>,
}

impl BodyText {
    /// Returns true if nothing is known about the body.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == BodyText::default()
    }

    fn keys(&self) -> [(&'static str, &Option<String>); 5] {
        [
            ("name", &self.name),
            ("youngs_modulus", &self.youngs_modulus),
            ("yield_strength", &self.yield_strength),
            ("indentation_hardness", &self.indentation_hardness),
            ("strain_gradient_length", &self.strain_gradient_length),
        ]
    }

    fn write(&self, section: &str, text: &mut String) {
        let _ = writeln!(text, "\n[{section}]");
        for (key, value) in self.keys() {
            if let Some(value) = value {
                let _ = writeln!(text, "{key} = {}", quoted(value));
            }
        }
        if let Some(ratio) = &self.poisson_ratio {
            // A number without quotes; anything else, as an uncertain ratio, is text.
            let value = ratio.parse::<f64>().map_or_else(|_| quoted(ratio), |ratio| ratio.to_string());
            let _ = writeln!(text, "poisson_ratio = {value}");
        }
    }
}

impl ReportQuestion {
    /// Returns true for the text of a scene that [`scene_text`](Self::scene_text) gave.
    #[must_use]
    pub fn wrote(text: &str) -> bool {
        text.starts_with(FIRST_LINE)
    }

    /// Returns the scene that gives the report. Without curves it runs all models that apply.
    #[must_use]
    pub fn scene_text(&self) -> String {
        let mut text = format!("{FIRST_LINE}\n\n");
        if let Some(title) = &self.title {
            let _ = writeln!(text, "title = {}\n", quoted(title));
        }
        text += &self.surface.section();
        self.material.write("material", &mut text);
        if let Some(counterface) = &self.counterface {
            counterface.write("counterface", &mut text);
        }
        let pressures: Vec<String> = self.pressures.iter().map(|pressure| quoted(pressure)).collect();
        let _ = writeln!(text, "\n[loads]\npressures = [{}]", pressures.join(", "));
        if let Some(cap) = &self.strength_cap {
            let _ = writeln!(text, "\n[options]\nstrength_cap = {}", quoted(cap));
        }
        if self.material.name.is_some() || self.material.youngs_modulus.is_some() {
            text += "\n[interface]\n";
        }
        if self.seal {
            text += "\n[seal]\n";
        }
        text + "\n[figures]\nformat = [\"svg\", \"py\"]\n"
    }
}

/// The keys of a scan as an inline table.
fn scan_keys(scan: &ScanRequest) -> String {
    let mut keys = vec![format!("file = {}", quoted(&scan.path))];
    let mut add = |key: &str, value: Option<String>| {
        keys.extend(value.map(|value| format!("{key} = {}", quoted(&value))));
    };
    add("unit", scan.unit.map(|unit| unit.to_string()));
    add("channel", scan.channel.clone());
    add("size", scan.size_m.map(metres));
    add(
        "tip_radius",
        scan.tip_radius.map(|radius| match radius {
            TipRadius::Known(radius_m) => metres(radius_m),
            TipRadius::Auto => "auto".to_owned(),
        }),
    );
    add("shortest_wavelength", scan.shortest_m.map(metres));
    add("gaps", scan.gaps.map(|gaps| gaps.to_string()));
    add("direction", scan.direction.map(|direction| direction.to_string()));
    add("detrend", scan.detrend.map(|detrend| detrend.to_string()));
    add("instrument", scan.instrument.clone());
    add("z_calibration", scan.z_calibration.map(|share| format!("{} %", 100.0 * share)));
    let slope = scan.slope_uncertainty.map(|error| format!("slope_uncertainty = {error}"));
    keys.extend(slope);
    format!("{{ {} }}", keys.join(", "))
}

fn metres(length_m: f64) -> String {
    format!("{length_m:e} m")
}

/// A text as TOML writes it.
fn quoted(text: &str) -> String {
    Value::String(text.to_owned()).to_string()
}

#[cfg(test)]
mod tests {
    use super::*;
    use scene::{Overrides, Scene};
    use std::collections::BTreeMap;

    fn question() -> ReportQuestion {
        ReportQuestion {
            surface: ReportSurface::Psd("builtin:uncd-measured".to_owned()),
            material: BodyText { name: Some("100Cr6".to_owned()), ..BodyText::default() },
            pressures: vec!["10 MPa".to_owned(), "1e-2 H".to_owned()],
            ..ReportQuestion::default()
        }
    }

    #[test]
    fn a_report_is_a_scene_that_runs_every_model_that_applies() {
        let scene = Scene::parse(&question().scene_text(), &study::NoFiles, &Overrides::default()).unwrap();
        let names: Vec<&str> = scene.needs.curves.iter().map(|curve| curve.name.as_str()).collect();
        for name in ["elastic", "elastic-plastic", "ep-sine", "persson-algebraic-nayak", "persson-plastic"] {
            assert!(names.contains(&name), "{names:?}");
        }
        // The steel has no strain-gradient length.
        assert!(names.iter().all(|name| !name.ends_with("strain-gradient")), "{names:?}");
        assert!(scene.interface.is_some_and(|asked| asked.seal.is_none()));
    }

    #[test]
    fn hostile_names_stay_text() {
        let name = "a \"b\"\\c\n[loads]\u{1b}.txt";
        let scan = ScanRequest {
            path: name.to_owned(),
            tip_radius: Some(TipRadius::Known(2e-6)),
            ..ScanRequest::default()
        };
        let question = ReportQuestion {
            title: Some(name.to_owned()),
            surface: ReportSurface::Scans(vec![scan]),
            ..question()
        };
        let parsed: toml::Table = question.scene_text().parse().unwrap();
        assert_eq!(parsed["title"].as_str(), Some(name));
        let scan = &parsed["surface"]["scans"][0];
        assert_eq!(scan["file"].as_str(), Some(name));
        assert_eq!(scan["tip_radius"].as_str(), Some("2e-6 m"));
        assert_eq!(parsed["loads"]["pressures"].as_array().map(Vec::len), Some(2));
    }

    #[test]
    fn options_of_scans_reach_the_scene() {
        let heights: String = (0..200).map(|at| format!("{} {}\n", at, (at * at) % 7)).collect();
        let files = BTreeMap::from([("line.txt".to_owned(), heights.into_bytes())]);
        let request: ScanRequest =
            "line.txt:unit=um,shortest=4um,detrend=mean,instrument=stylus,z-calibration=2%".parse().unwrap();
        let question = ReportQuestion { surface: ReportSurface::Scans(vec![request]), ..question() };
        let scene = Scene::parse(&question.scene_text(), &files, &Overrides::default()).unwrap();
        assert!(scene.surface.psd.shortest_wavelength_m() >= 3.9e-6);
        let scans = &scene.surface.made_from.unwrap().spectrum.scans;
        assert_eq!(scans[0].preparation.detrend, topography::Detrend::Mean);
    }
}
