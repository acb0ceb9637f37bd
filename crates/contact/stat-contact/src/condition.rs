//! The given quantity of a state.

/// The quantity that is given of a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Condition {
    /// A pressure over the nominal area \[Pa\].
    Pressure(f64),
    /// A separation \[m\] from the mean of the asperity heights, of either sign.
    Separation(f64),
}

impl Condition {
    /// Returns the pressure \[Pa\], or nothing for a separation.
    #[must_use]
    pub fn pressure_pa(self) -> Option<f64> {
        match self {
            Condition::Pressure(pressure_pa) => Some(pressure_pa),
            Condition::Separation(_) => None,
        }
    }
}
