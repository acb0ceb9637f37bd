//! Division of the nominal area into elastic contact, plastic contact and gap.

/// The shares of the nominal area in elastic contact, in plastic contact, and out of contact; their sum is 1.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ContactAreas {
    /// Share in contact below the hardness, in \[0, 1\].
    pub elastic: f64,
    /// Share in contact at the hardness, in \[0, 1\].
    pub plastic: f64,
    /// Share out of contact, in \[0, 1\]. Stored because 1 - elastic - plastic loses all digits near full contact.
    pub gap: f64,
}

impl ContactAreas {
    /// Elastic contact everywhere.
    pub const FULL: ContactAreas = ContactAreas { elastic: 1.0, plastic: 0.0, gap: 0.0 };

    /// Share in contact, elastic plus plastic.
    #[must_use]
    pub fn contact(&self) -> f64 {
        self.elastic + self.plastic
    }

    /// Share of the contact that is plastic, in \[0, 1\].
    #[must_use]
    pub fn plastic_share(&self) -> f64 {
        self.plastic / self.contact()
    }
}
