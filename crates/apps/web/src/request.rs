//! The request of the page: surfaces, bodies and conditions, and the scene that it stands for.

use measurements::{Files, ScanProblem, ScanRequest};
use questions::{BodyText, ReportQuestion, ReportSurface};
use report::scan_words;
use scans::{Mend, ScanOption};
use scene::{SceneError, SceneProblem, SceneText};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use study::surface::SurfaceError;

use crate::example;

/// A request: everything that a link holds.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Request {
    /// The key of an example; absent if there are files.
    pub example: Option<String>,
    /// The files: scans, one spectrum, or one scene.
    pub files: Vec<FileRequest>,
    /// The rough body; absent if the scene has it.
    pub material: Option<BodyText>,
    /// The counterface, rigid if empty; absent if the scene has it.
    pub counterface: Option<BodyText>,
    /// The nominal pressure with its unit; absent for that of the scene.
    pub pressure: Option<String>,
    /// The shortest wavelength with its unit; absent for all of the spectrum.
    pub shortest_wavelength: Option<String>,
    /// True to ask from which pressure on the contact seals.
    pub seal: bool,
    /// Flatness of the nominal contact, height over length with units; absent for that of the scene, or flat.
    pub flatness: Option<String>,
}

/// A file with the options that the page was given for it.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct FileRequest {
    /// Its name, with the folders it was dropped in.
    pub name: String,
    /// Number of bytes, by which a changed file is told from an earlier one.
    pub bytes: u64,
    /// Options by their names on the command line.
    pub options: BTreeMap<String, String>,
    /// Its kind.
    pub kind: FileKind,
    /// True for a file of the other face.
    pub is_counterface: bool,
}

/// The kind of a file, by its content.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FileKind {
    /// Heights.
    #[default]
    Scan,
    /// A power spectrum.
    Spectrum,
    /// A scene.
    Scene,
    /// A file that describes others, or one that cannot be used.
    Other,
}

/// The refusal of a request, in words.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Refusal {
    /// The words.
    pub message: String,
    /// The file at fault, if one is.
    pub file: Option<String>,
    /// The option of the file that mends it: `unit` or `size`.
    pub option: Option<&'static str>,
}

impl Refusal {
    pub(crate) fn new(message: impl ToString) -> Self {
        Refusal { message: message.to_string(), file: None, option: None }
    }

    /// Words an error of a scene: of scans with the option that mends it, else with the place in the text.
    pub(crate) fn of_scene(error: SceneError, text: &str) -> Self {
        let SceneProblem::Surface(surface) = &error.problem else {
            return Refusal::new(report::scene_errors::drawn(&error, text, "the scene"));
        };
        match &**surface {
            SurfaceError::Scans(error) => Refusal::of_scans(error),
            other => Refusal::new(other),
        }
    }

    /// Words an error of scans, with the option that mends it.
    pub(crate) fn of_scans(error: &measurements::TopographyError) -> Self {
        let mend = error.mend();
        let words = mend.map_or_else(String::new, |mend| scan_words::mend(mend, option_name));
        let message = match &error.problem {
            ScanProblem::Reading(error) => error.to_string(),
            problem => problem.to_string(),
        };
        let option = match mend {
            Some(Mend::Give(option)) => option_name(option),
            _ => None,
        };
        Refusal { message: format!("{message}{words}"), file: error.file.clone(), option }
    }
}

/// The name of a scan's option in the page.
fn option_name(option: ScanOption) -> Option<&'static str> {
    match option {
        ScanOption::Unit | ScanOption::Units => Some("unit"),
        ScanOption::HeightUnit => Some("height-unit"),
        ScanOption::Size => Some("size"),
        ScanOption::Channel => Some("channel"),
        _ => None,
    }
}

impl FileRequest {
    /// Returns the request for the scans of the file.
    pub(crate) fn scan(&self) -> Result<ScanRequest, Refusal> {
        let mut request = ScanRequest { path: self.name.clone(), ..ScanRequest::default() };
        for (key, value) in self.options.iter().filter(|(_, value)| !value.trim().is_empty()) {
            request = request
                .with_option(key, value.trim())
                .map_err(|error| Refusal { file: Some(self.name.clone()), ..Refusal::new(error) })?;
        }
        Ok(request)
    }
}

impl Request {
    /// Returns the text of the scene without the conditions that sliders change. With `in_full` a scene of the user's
    /// own keeps its figures, which take long.
    pub(crate) fn scene_text(&self, files: &dyn Files, in_full: bool) -> Result<String, Refusal> {
        let scene_file = self.files.iter().find(|file| file.kind == FileKind::Scene && !file.is_counterface);
        let text = match (&self.example, scene_file) {
            (Some(key), _) => example::scene_text(key)
                .ok_or_else(|| Refusal::new(format!("there is no example called {key}")))?,
            (None, Some(file)) => {
                let bytes = files.read(&file.name).map_err(Refusal::new)?;
                String::from_utf8(bytes).map_err(Refusal::new)?
            }
            (None, None) => return Ok(self.question()?.scene_text()),
        };
        let mut scene = SceneText::parse(&text).map_err(Refusal::new)?;
        if self.example.is_some() {
            // An example runs every model that applies.
            scene.remove("curve");
        }
        if self.example.is_some() || !in_full {
            scene.remove("figure");
        }
        if self.pressure.is_some() {
            scene.remove("loads.force");
            scene.remove("loads.nominal_area");
        }
        for (section, body) in [("material", &self.material), ("counterface", &self.counterface)] {
            match body {
                None => {}
                // An empty body without a surface of its own is none.
                Some(body) if body.is_empty() && !scene.has(&format!("{section}.surface")) => {
                    scene.remove(section)
                }
                Some(body) => body.write(section, &mut scene).map_err(Refusal::new)?,
            }
        }
        if let Some(surface) = self.face(true)? {
            scene.set("counterface.surface", &surface).map_err(Refusal::new)?;
        }
        if self.seal && !scene.has("seal") {
            scene.set("seal", &BTreeMap::<String, String>::new()).map_err(Refusal::new)?;
        }
        if let Some(flatness) = &self.flatness {
            scene.set("interface.flatness", flatness).map_err(Refusal::new)?;
        }
        Ok(scene.to_string())
    }

    /// The surface of the files of a face; `None` for a counterface without files.
    fn face(&self, is_counterface: bool) -> Result<Option<ReportSurface>, Refusal> {
        let of_face = || self.files.iter().filter(|file| file.is_counterface == is_counterface);
        let usable: Vec<&FileRequest> = of_face().filter(|file| file.kind != FileKind::Other).collect();
        match usable[..] {
            [] if is_counterface && of_face().next().is_none() => Ok(None),
            [] => {
                let of = if is_counterface { " of the other face" } else { "" };
                Err(Refusal::new(format!("no file{of} holds heights or a spectrum; drop a scan")))
            }
            [one] if one.kind == FileKind::Spectrum => Ok(Some(ReportSurface::Psd(one.name.clone()))),
            _ => Ok(Some(ReportSurface::Scans(
                usable.iter().map(|file| file.scan()).collect::<Result<_, _>>()?,
            ))),
        }
    }

    /// The question about scans or a spectrum.
    fn question(&self) -> Result<ReportQuestion, Refusal> {
        let mut own = self.files.iter().filter(|file| file.kind != FileKind::Other && !file.is_counterface);
        let counterface = self.counterface.clone().filter(|body| !body.is_empty());
        Ok(ReportQuestion {
            // Of two faces the scene is called after both.
            title: own
                .next()
                .map(|file| file.name.clone())
                .filter(|_| !self.files.iter().any(|file| file.is_counterface)),
            surface: self.face(false)?.unwrap_or_default(),
            counterface_surface: self.face(true)?,
            material: self.material.clone().unwrap_or_default(),
            counterface,
            pressures: vec![self.pressure.clone().unwrap_or_else(|| "10 MPa".to_owned())],
            strength_cap: None,
            seal: self.seal,
            flatness: self.flatness.clone(),
        })
    }
}

/// The bodies and the loads that a scene states.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct StatedScene {
    material: BodyText,
    counterface: BodyText,
    loads: StatedLoads,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct StatedLoads {
    pressures: Vec<String>,
}

/// The bodies and the middle pressure that a scene states.
pub(crate) fn stated(text: &str) -> (BodyText, BodyText, Option<String>) {
    let StatedScene { material, counterface, loads } = toml::from_str(text).unwrap_or_default();
    let middle = loads.pressures.get(loads.pressures.len() / 2).cloned();
    (material, counterface, middle)
}
