//! How far the results of a scene can be trusted, where that was asked.

use judge::Judgement;
use uncertainty::Uncertainty;

/// What boundary elements and draws say of the results of a scene.
#[derive(Debug, Clone, Copy, Default)]
pub struct Trust<'a> {
    /// What boundary elements say of its curves, where they were asked.
    pub judgement: Option<&'a Judgement>,
    /// What draws of its inputs say of its areas, where some were made.
    pub uncertainty: Option<&'a Uncertainty>,
}
