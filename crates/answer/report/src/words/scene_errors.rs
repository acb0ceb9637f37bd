//! Errors of a scene, drawn like a compiler's message: file, line, the line itself, and the remedy. The command line
//! and the Python package show the same text.

use crate::{scan_words, spectrum_words};
use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use scans::ScanOption;
use scene::{FileContent, SceneError, SceneProblem, Template};
use spectrum::ReadOption;
use study::surface::SurfaceError;

/// The message with file, line, and the line itself. The caller adds the word `error`.
#[must_use]
pub fn drawn(error: &SceneError, scene: &str, name: &str) -> String {
    let message = match &error.problem {
        SceneProblem::Surface(error) if is_placeholder(error) => {
            format!(
                "\"{}\" is only an example; write the name of your own file in psd",
                Template::PLACEHOLDER
            )
        }
        _ => format!("{error}{}", mended(error, name)),
    };
    let title = Level::ERROR.primary_title(&message);
    let group = match &error.span {
        Some(span) => title.element(
            Snippet::source(scene).path(name).annotation(AnnotationKind::Primary.span(span.clone())),
        ),
        None => title.element(Origin::path(name)),
    };
    let drawn = Renderer::plain().render(&[group]);
    drawn.strip_prefix("error: ").unwrap_or(&drawn).to_owned()
}

/// Returns true if the file that the template of a scene names is missing.
fn is_placeholder(error: &SurfaceError) -> bool {
    matches!(error, SurfaceError::Reading { name, .. } if name == Template::PLACEHOLDER)
        && error.is_missing_file()
}

/// The remedy within the scene, in words that follow the error.
fn mended(error: &SceneError, name: &str) -> String {
    let error = match &error.problem {
        SceneProblem::Surface(error) => error,
        SceneProblem::NotAScene(FileContent::Foreign(_)) if name.ends_with("report.html") => {
            return "; a report has its scene beside it: name the folder, or scene.toml in it".to_owned();
        }
        SceneProblem::NotAScene(FileContent::Foreign(kind)) => return format!("; {}", kind.advice()),
        SceneProblem::NotAScene(_) => return format!("; try `truearea report {name}`"),
        _ => return String::new(),
    };
    let key = |option| match option {
        ScanOption::Unit => Some("unit = \"um\""),
        ScanOption::HeightUnit => Some("height_unit = \"um\""),
        ScanOption::Units => Some("unit = \"um\", and height_unit where they differ"),
        ScanOption::Size => Some("size = \"10 um\""),
        ScanOption::Channel => Some("channel = \"...\""),
        _ => None,
    };
    match error.as_ref() {
        SurfaceError::Scan { .. } => "; give it in scans = [...] instead of psd".to_owned(),
        SurfaceError::Spectrum { error, .. } => {
            let key = |option: ReadOption| option.key().to_owned();
            error.mend().map_or_else(String::new, |mend| spectrum_words::mend(&mend, key))
        }
        SurfaceError::Scans(error) => {
            error.mend().map_or_else(String::new, |mend| scan_words::mend(mend, key))
        }
        _ => String::new(),
    }
}
