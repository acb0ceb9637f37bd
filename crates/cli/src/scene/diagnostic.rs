//! Messages that point into a scene file.

use std::ops::Range;

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// Something wrong in a scene, and where.
#[derive(Debug)]
pub(super) struct SceneError {
    pub message: String,
    /// The bytes of the file to point at; the whole file where absent.
    pub span: Option<Range<usize>>,
}

impl SceneError {
    pub fn at(span: Range<usize>, message: impl std::fmt::Display) -> Self {
        SceneError { message: message.to_string(), span: Some(span) }
    }

    pub fn anywhere(message: impl std::fmt::Display) -> Self {
        SceneError { message: message.to_string(), span: None }
    }

    /// The message with file, line, and the line itself; that it is an error is said where it is reported.
    pub fn render(&self, text: &str, name: &str) -> String {
        let title = Level::ERROR.primary_title(&self.message);
        let group = match &self.span {
            Some(span) => title.element(
                Snippet::source(text).path(name).annotation(AnnotationKind::Primary.span(span.clone())),
            ),
            None => title.element(annotate_snippets::Origin::path(name)),
        };
        let rendered = Renderer::plain().render(&[group]);
        rendered.strip_prefix("error: ").unwrap_or(&rendered).to_owned()
    }
}
