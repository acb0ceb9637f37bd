//! How the nominal area is shared.

/// The shares of the nominal area that touch elastically, that touch and flow, and that do not touch; their sum is 1.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ContactAreas {
    /// In contact below the hardness, in \[0, 1\].
    pub elastic: f64,
    /// In contact at the hardness, in \[0, 1\].
    pub plastic: f64,
    /// Out of contact, in \[0, 1\]. Kept beside the other two because near full contact 1 less their sum has no digits.
    pub gap: f64,
}

impl ContactAreas {
    /// Elastic contact everywhere.
    pub const FULL: ContactAreas = ContactAreas { elastic: 1.0, plastic: 0.0, gap: 0.0 };

    /// The share in contact, elastic or not.
    #[must_use]
    pub fn contact(&self) -> f64 {
        self.elastic + self.plastic
    }
}
