//! Colour and dash of a model, the same in every figure of a page.

/// Colours for any colour vision on black or white, with their dashes: the pair is distinct for every model.
const COLOURS: [&str; 7] = ["#0b7a5a", "#b4530a", "#1f63b5", "#a6438c", "#8a6d00", "#5b5bd6", "#3f7f93"];
const DASHES: [&str; 3] = ["", "6 3", "2 2.5"];

/// The look of a model's line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct ModelStyle {
    pub colour: &'static str,
    pub dash: &'static str,
}

impl ModelStyle {
    /// Returns the look of the model at an index.
    pub fn new(index: usize) -> Self {
        ModelStyle {
            colour: COLOURS[index % COLOURS.len()],
            dash: DASHES[index / COLOURS.len() % DASHES.len()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::ModelStyle;

    #[test]
    fn no_two_models_look_alike() {
        let styles: Vec<ModelStyle> = (0..21).map(ModelStyle::new).collect();
        for (at, style) in styles.iter().enumerate() {
            assert!(!styles[..at].contains(style));
        }
    }
}
