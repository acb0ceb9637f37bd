//! The desk: a scene that is open, and its answer in closed forms at every move of a slider.

use conclusions::{Conclusions, Evidence};
use findings::answer::SceneAnswer;
use measurements::Files;
use questions::{BodyText, retune};
use report::page::{LiveScreen, SpectrumCurve};
use report::scans_table;
use scene::{Overrides, Scene};
use serde::Serialize;
use units::display::length;
use units::{Remark, RemarkLevel, Spelling};

use crate::request::{Refusal, Request, stated};

/// The scene that is open, and the text that it was read from.
#[derive(Default)]
pub struct Desk {
    open: Option<(Request, String, Scene)>,
}

/// The reply to a request.
#[derive(Debug, Serialize)]
pub struct Reply {
    /// The surface and the bodies, if they were read anew.
    pub opened: Option<Opened>,
    /// The answer; absent if the scene has no load with an area.
    pub screen: Option<LiveScreen>,
    /// The scene in text, with these conditions.
    pub scene: String,
}

/// The surface and the bodies of a scene.
#[derive(Debug, Serialize)]
pub struct Opened {
    /// The title.
    pub title: String,
    /// The rough body.
    pub material: BodyText,
    /// The counterface.
    pub counterface: BodyText,
    /// The wavelengths of the spectrum \[m\], falling.
    pub wavelengths_m: Vec<f64>,
    /// These wavelengths in print.
    pub wavelengths: Vec<String>,
    /// The spectrum, as an element of the page, with its values.
    pub spectrum: SpectrumCurve,
    /// The scans and their trusted bands, as a table in text; empty for a spectrum.
    pub scans: String,
    /// The names of its maps, which can be pressed.
    pub maps: Vec<String>,
    /// The composite spectrum \[m^3\] at these wavelengths, for scripts.
    pub c1d_m3: Vec<f64>,
    /// Notes on surface and scene, warnings first.
    pub notes: Vec<PageNote>,
}

/// A note on a surface or a scene.
#[derive(Debug, Serialize)]
pub struct PageNote {
    /// True for a warning.
    pub is_warning: bool,
    /// The words.
    pub text: String,
}

/// Options of a page, whose options of scans are filled in beside the files.
struct BesideFiles;

impl Spelling for BesideFiles {
    fn option(&self, option: &str) -> String {
        option.replace("counterface_surface", "the other face")
    }

    fn of_scan(&self, _: &str, value: &str) -> String {
        format!("fill it in beside the file, such as {value}")
    }
}

/// Gives a scene the conditions of a request, or its own.
pub(crate) fn with_conditions(scene: &mut Scene, request: &Request) -> Result<(), Refusal> {
    let own = stated(&scene.text).2;
    match request.pressure.as_ref().or(own.as_ref()) {
        Some(pressure) => {
            retune(scene, pressure, request.shortest_wavelength.as_deref()).map_err(Refusal::new)
        }
        None => Ok(()),
    }
}

impl Desk {
    /// Answers a request in closed forms. Reads the surface only if surface or bodies differ from the last request.
    ///
    /// # Errors
    /// [`Refusal`] in words.
    pub fn answer(&mut self, request: &Request, files: &dyn Files) -> Result<Reply, Refusal> {
        let (scene, opened) = self.scene(request, files)?;
        let results = scene.plan().compute().map_err(Refusal::new)?;
        let answer = SceneAnswer::from_results(scene, &results);
        let evidence =
            Evidence { scene, results: &results, answer: &answer, judgement: None, uncertainty: None };
        let conclusions = Conclusions::new(&evidence);
        let screen = LiveScreen::new(evidence, &conclusions);
        Ok(Reply { opened, screen, scene: scene.text.clone() })
    }

    /// Returns the scene of a request with its conditions, and what was read anew for it.
    pub(crate) fn scene(
        &mut self,
        request: &Request,
        files: &dyn Files,
    ) -> Result<(&Scene, Option<Opened>), Refusal> {
        let fixed = Request { pressure: None, shortest_wavelength: None, ..request.clone() };
        let opened = match &self.open {
            Some((open, ..)) if *open == fixed => None,
            _ => Some(self.read(request, fixed, files)?),
        };
        let Some((_, text, scene)) = &mut self.open else { return Err(Refusal::new("nothing is open")) };
        scene.text.clone_from(text);
        with_conditions(scene, request)?;
        Ok((scene, opened))
    }

    /// Reads surface and bodies.
    fn read(&mut self, request: &Request, fixed: Request, files: &dyn Files) -> Result<Opened, Refusal> {
        self.open = None;
        let text = request.scene_text(files, false)?;
        let scene = Scene::parse(&text, files, &Overrides::default())
            .map_err(|error| Refusal::of_scene(error, &text))?;
        let psd = &scene.surface.psd;
        let (material, counterface, _) = stated(&text);
        let wavelengths_m = psd.wavelengths_m().to_vec();
        let of_faces = scene.surface.each().into_iter().filter_map(|face| face.made_from.as_ref());
        let page_note = |note: &Remark| PageNote {
            is_warning: note.level == RemarkLevel::Caution,
            text: note.words(&BesideFiles),
        };
        let mut notes: Vec<PageNote> =
            scene.surface.notes.iter().chain(&scene.notes).map(page_note).collect();
        notes.sort_by_key(|note| !note.is_warning);
        let opened = Opened {
            title: scene.title.clone(),
            material,
            counterface,
            wavelengths: wavelengths_m.iter().map(|wavelength_m| length(*wavelength_m)).collect(),
            c1d_m3: psd.c1d_m3().to_vec(),
            wavelengths_m,
            spectrum: SpectrumCurve::new(&scene.surface),
            maps: scene.surface.maps().iter().map(|map| map.name.clone()).collect(),
            scans: of_faces.map(|scans| scans_table::scans_table(&scans.spectrum)).collect(),
            notes,
        };
        self.open = Some((fixed, text, scene));
        Ok(opened)
    }
}
