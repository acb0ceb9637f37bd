//! What is done to heights before they are transformed.

use serde::{Deserialize, Serialize};

use crate::detrend::Detrend;
use crate::window::Window;

/// What is done to the heights before they are transformed.
///
/// The default suits data that are not periodic: a plane (of a line: a straight line) is subtracted and the Hann window
/// applied. Periodic data, such as computed surfaces, want [`Detrend::Mean`] and [`Window::None`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct Preparation {
    /// What is subtracted.
    pub detrend: Detrend,
    /// What the remainder is multiplied by.
    pub window: Window,
}

impl Preparation {
    /// For periodic data: the mean subtracted, no window.
    pub const PERIODIC: Self = Self { detrend: Detrend::Mean, window: Window::None };

    /// How many of the first bins, from q = 2 pi/L on, do not show the spectrum of the surface.
    ///
    /// The first one wherever a slope was subtracted, which takes most of its content from it, or a window applied, which
    /// mixes it with the mean that has gone; none for [`Preparation::PERIODIC`].
    pub const fn flagged_bins(self) -> usize {
        match (self.detrend, self.window) {
            (Detrend::Mean, Window::None) => 0,
            _ => 1,
        }
    }
}
