//! A report on a contact: surfaces, bodies and loads, as a scene that repeats it.

use std::collections::BTreeMap;

use measurements::{Files, ScanRequest};
use scene::SceneText;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
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
    /// The roughness of the counterface; smooth if absent.
    pub counterface_surface: Option<ReportSurface>,
    /// The nominal pressures.
    pub pressures: Vec<String>,
    /// Upper limit of the depth-dependent yield strength.
    pub strength_cap: Option<String>,
    /// True to ask from which pressure on the contact seals.
    pub seal: bool,
    /// The deviation of the nominal contact from a plane; flat if absent.
    pub flatness: Option<String>,
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
    /// [`SurfaceError::NoSuchBuiltin`], and [`SurfaceError::Spectrum`] with the line at fault in what is a spectrum by its header.
    pub fn of_files(requests: Vec<ScanRequest>, files: &dyn Files) -> Result<Self, SurfaceError> {
        if let [request] = &requests[..] {
            match Surface::load(&request.path, files, &ReadOptions::default()) {
                Ok(_) => {
                    request.check_takes(&[])?;
                    return Ok(ReportSurface::Psd(request.path.clone()));
                }
                Err(error @ SurfaceError::NoSuchBuiltin { .. }) => return Err(error),
                Err(SurfaceError::Spectrum { name, error }) if error.is_of_a_spectrum() => {
                    return Err(SurfaceError::Spectrum { name, error });
                }
                Err(_) => {}
            }
        }
        Ok(ReportSurface::Scans(requests))
    }
}

impl Serialize for ReportSurface {
    /// Writes the section `[surface]` of a scene.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            ReportSurface::Psd(name) => serializer.collect_map([("psd", name)]),
            ReportSurface::Scans(scans) => {
                let scans: Vec<ScanSection<'_>> = scans.iter().map(ScanSection).collect();
                serializer.collect_map([("scans", scans)])
            }
        }
    }
}

/// Properties of a body, as text with units. It is read from a section of a scene too, whose other keys it ignores.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct BodyText {
    /// A name from the table of materials, which fills the other properties.
    #[serde(deserialize_with = "as_typed")]
    pub name: Option<String>,
    /// Young's modulus.
    #[serde(deserialize_with = "as_typed")]
    pub youngs_modulus: Option<String>,
    /// Poisson's ratio.
    #[serde(deserialize_with = "as_typed")]
    pub poisson_ratio: Option<String>,
    /// Yield strength.
    #[serde(deserialize_with = "as_typed")]
    pub yield_strength: Option<String>,
    /// Indentation hardness.
    #[serde(deserialize_with = "as_typed")]
    pub indentation_hardness: Option<String>,
    /// Strain-gradient length.
    #[serde(deserialize_with = "as_typed")]
    pub strain_gradient_length: Option<String>,
}

impl BodyText {
    /// Returns true if nothing is known about the body.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        *self == BodyText::default()
    }

    /// Writes the section of a body, whose own surface stays. A ratio that is a plain number has no quotes.
    ///
    /// # Errors
    /// None: text and numbers fit in every scene.
    pub fn write(&self, section: &str, text: &mut SceneText) -> Result<(), toml_edit::ser::Error> {
        text.set_except(section, self, "surface")?;
        match self.poisson_ratio.as_ref().map(|ratio| ratio.parse::<f64>()) {
            Some(Ok(ratio)) => text.set(&format!("{section}.poisson_ratio"), &ratio),
            _ => Ok(()),
        }
    }
}

impl ReportQuestion {
    /// Returns the text of the scene that gives the report. Without curves it runs all models that apply.
    #[must_use]
    pub fn scene_text(&self) -> String {
        let mut text = SceneText::default();
        // Text, numbers and lists of them fit in every scene.
        self.write(&mut text).expect("TOML holds every value of a report");
        format!("{FIRST_LINE}\n\n{text}")
    }

    fn write(&self, text: &mut SceneText) -> Result<(), toml_edit::ser::Error> {
        let nothing: [(&str, &str); 0] = [];
        let nothing = BTreeMap::from(nothing);
        if let Some(title) = &self.title {
            text.set("title", title)?;
        }
        text.set("surface", &self.surface)?;
        self.material.write("material", text)?;
        if let Some(counterface) = &self.counterface {
            counterface.write("counterface", text)?;
        }
        if let Some(surface) = &self.counterface_surface {
            text.set("counterface.surface", surface)?;
        }
        text.set("loads", &BTreeMap::from([("pressures", &self.pressures)]))?;
        if let Some(cap) = &self.strength_cap {
            text.set("options", &BTreeMap::from([("strength_cap", cap)]))?;
        }
        if self.material.name.is_some() || self.material.youngs_modulus.is_some() {
            text.set("interface", &nothing)?;
        }
        if let Some(flatness) = &self.flatness {
            text.set("interface.flatness", flatness)?;
        }
        if self.seal {
            text.set("seal", &nothing)?;
        }
        text.set("figures", &BTreeMap::from([("format", ["svg", "py"])]))
    }
}

/// A value as it is typed in a scene: text without quotes.
fn as_typed<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<String>, D::Error> {
    Ok(Option::<Value>::deserialize(deserializer)?.map(|value| match value {
        Value::String(text) => text,
        other => other.to_string(),
    }))
}

/// A scan as a scene lists it.
struct ScanSection<'s>(&'s ScanRequest);

impl Serialize for ScanSection<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let ScanSection(scan) = self;
        let keys = [
            ("file", Some(scan.path.clone())),
            ("unit", scan.unit.map(|unit| unit.to_string())),
            ("height_unit", scan.height_unit.map(|unit| unit.to_string())),
            ("channel", scan.channel.clone()),
            ("size", scan.size_m.map(metres)),
            ("tip_radius", scan.tip_radius.map(|radius| radius.to_string())),
            ("shortest_wavelength", scan.shortest_m.map(metres)),
            ("gaps", scan.gaps.map(|gaps| gaps.to_string())),
            ("direction", scan.direction.map(|direction| direction.to_string())),
            ("detrend", scan.detrend.map(|detrend| detrend.to_string())),
            ("instrument", scan.instrument.clone()),
            ("z_calibration", scan.z_calibration.map(|share| format!("{} %", 100.0 * share))),
        ];
        let keys = keys.into_iter().filter_map(|(key, value)| Some((key, Value::String(value?))));
        let slope = scan.slope_uncertainty.map(|error| ("slope_uncertainty", Value::Float(error)));
        serializer.collect_map(keys.chain(slope))
    }
}

fn metres(length_m: f64) -> String {
    format!("{length_m:e} m")
}

#[cfg(test)]
mod tests {
    use super::*;
    use measurements::TipRadius;
    use scene::{Overrides, Scene};

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
    fn a_second_face_is_the_surface_of_the_counterface() {
        let face = ReportSurface::Psd("builtin:contact-challenge".to_owned());
        for counterface in
            [None, Some(BodyText { name: Some("steel C45".to_owned()), ..BodyText::default() })]
        {
            let own = ReportQuestion { counterface, ..question() };
            let both = ReportQuestion { counterface_surface: Some(face.clone()), ..own.clone() };
            let [own, both] = [own, both].map(|question| {
                Scene::parse(&question.scene_text(), &study::NoFiles, &Overrides::default()).unwrap()
            });
            assert_eq!(own.bodies, both.bodies);
            assert!(own.surface.parts.is_none());
            let faces = both.surface.parts.unwrap();
            assert_eq!(faces[0].psd, own.surface.psd);
            assert_eq!(faces[1].name, "builtin:contact-challenge");
        }
    }

    #[test]
    fn options_of_scans_reach_the_scene() {
        let heights: String = (0..200).map(|at| format!("{} {}\n", at, (at * at) % 7)).collect();
        let files = BTreeMap::from([("line.txt".to_owned(), heights.into_bytes())]);
        let of = |request: &str| {
            let scans = ReportSurface::Scans(vec![request.parse().unwrap()]);
            let question = ReportQuestion { surface: scans, ..question() };
            Scene::parse(&question.scene_text(), &files, &Overrides::default()).unwrap()
        };
        let scene = of("line.txt:unit=um,shortest=4um,detrend=mean,instrument=stylus,z-calibration=2%");
        assert!(scene.surface.psd.shortest_wavelength_m() >= 3.9e-6);
        let scans = &scene.surface.made_from.unwrap().spectrum.scans;
        assert_eq!(scans[0].preparation.detrend, topography::Detrend::Mean);
        for (tip, is_unknown) in [("auto", true), ("none", false), ("2um", false)] {
            let scans =
                of(&format!("line.txt:unit=um,tip-radius={tip}")).surface.made_from.unwrap().spectrum.scans;
            assert_eq!(scans[0].tip_remarks.is_empty(), !is_unknown, "{tip}");
        }
    }
}
