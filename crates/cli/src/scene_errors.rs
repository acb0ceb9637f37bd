//! What is wrong in a scene, drawn like a compiler's message.

use annotate_snippets::{AnnotationKind, Level, Origin, Renderer, Snippet};
use report::scan_words;
use scans::ScanOption;
use study::scene::{SceneError, SceneProblem};
use study::surface::SurfaceError;

/// The message with file, line, and the line itself; that it is an error is said where it is reported.
pub fn drawn(error: &SceneError, scene: &str, name: &str) -> String {
    let message = match &error.problem {
        SceneProblem::Surface(SurfaceError::Scan { .. }) => {
            format!("{error}; give it in scans = [...] instead of psd")
        }
        _ => format!("{error}{}", mended(error)),
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

/// The key of a scan that mends the error, where one does.
fn mended(error: &SceneError) -> String {
    let SceneProblem::Surface(SurfaceError::Scans(error)) = &error.problem else { return String::new() };
    let key = |option| match option {
        ScanOption::Unit => Some("unit"),
        ScanOption::Size => Some("size"),
        ScanOption::Channel => Some("channel"),
        _ => None,
    };
    error.mend().map_or_else(String::new, |mend| scan_words::mend(mend, key))
}
