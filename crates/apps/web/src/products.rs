//! The bench: boundary elements, intervals, and the files of a report.

use measurements::Files;
use questions::{RunOptions, Watch, run_scene};
use report::page::LiveScreen;
use report::products::SceneProducts;
use report::run_stamp::RunStamp;
use scene::{Overrides, Scene};
use serde::Serialize;
use tables::Format;

use crate::answer::{Desk, with_conditions};
use crate::request::{Refusal, Request};

/// A file to download.
#[derive(Debug, Serialize)]
pub struct ProductFile {
    /// Its name.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// An answer with verdicts.
#[derive(Debug, Serialize)]
pub struct Judged {
    /// The answer; absent if the scene has no load with an area.
    pub screen: Option<LiveScreen>,
    /// True if uncertain inputs would widen its range, and were not drawn.
    pub may_widen: bool,
}

/// Returns the answer with the verdicts of boundary elements, and with `draws` also with intervals of the inputs.
///
/// # Errors
/// [`Refusal`] in words.
pub fn judged(
    desk: &mut Desk,
    request: &Request,
    files: &dyn Files,
    draws: bool,
    watch: &dyn Watch,
) -> Result<Judged, Refusal> {
    let (scene, _) = desk.scene(request, files)?;
    let options = RunOptions { report: false, judge: Some(true), uncertainty: Some(draws) };
    let outcome = run_scene(scene, options, watch).map_err(Refusal::new)?;
    Ok(Judged {
        screen: LiveScreen::new(outcome.evidence(scene), &outcome.conclusions),
        may_widen: !draws && RunOptions { uncertainty: Some(true), ..options }.is_drawn(scene),
    })
}

/// Returns the files of a report: page, tables, figures and scene.
///
/// # Errors
/// [`Refusal`] in words.
pub fn products(
    request: &Request,
    files: &dyn Files,
    run_stamp: &RunStamp,
    watch: &dyn Watch,
) -> Result<Vec<ProductFile>, Refusal> {
    let scene = scene(request, files)?;
    let options = RunOptions { report: true, judge: None, uncertainty: None };
    let outcome = run_scene(&scene, options, watch).map_err(Refusal::new)?;
    let products = SceneProducts {
        evidence: outcome.evidence(&scene),
        conclusions: &outcome.conclusions,
        sensitivities: outcome.sensitivities.as_deref(),
        run_stamp,
    };
    let mut made = vec![ProductFile { name: "scene.toml".to_owned(), text: scene.text.clone() }];
    let taken = products.each_file(Format::Csv, |name, write| {
        let mut bytes = Vec::new();
        write(&mut bytes)?;
        made.push(ProductFile { name: name.to_owned(), text: String::from_utf8_lossy(&bytes).into_owned() });
        Ok::<(), std::io::Error>(())
    });
    taken.map_err(Refusal::new)?;
    Ok(made)
}

/// Reads the scene of a request with its conditions.
fn scene(request: &Request, files: &dyn Files) -> Result<Scene, Refusal> {
    let text = request.scene_text(files, true)?;
    let mut scene =
        Scene::parse(&text, files, &Overrides::default()).map_err(|error| Refusal::of_scene(error, &text))?;
    with_conditions(&mut scene, request)?;
    Ok(scene)
}
