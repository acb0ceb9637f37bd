//! Kinks and jumps of laws, which a quadrature must not step across.

/// A kink or a jump of a law, at one value of its variable (an interference in m, or a pressure in Pa, as the law's own
/// documentation says). A quadrature ends a panel there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Break {
    /// Value of the law's variable \[m or Pa\], above 0.
    pub at: f64,
    /// Description of the kink or jump, in the law's own terms.
    pub what: &'static str,
    /// Relative step of the law's result, value above over value below minus one; zero at a kink.
    pub step: f64,
}

impl Break {
    pub(crate) fn kink(at: f64, what: &'static str) -> Self {
        Break { at, what, step: 0.0 }
    }

    pub(crate) fn jump(at: f64, what: &'static str, below: f64, above: f64) -> Self {
        Break { at, what, step: above / below - 1.0 }
    }
}
