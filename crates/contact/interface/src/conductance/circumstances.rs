//! Effects left out by the assumption of clean bodies, wide spots and elastic loading.

use serde::Serialize;
use units::{Bound, OutOfBounds};

/// Mean free path of electrons in a good metal at room temperature \[m\].
pub const ELECTRON_MEAN_FREE_PATH_M: f64 = 40e-9;

/// Largest plastic share of the contact for which the slope of an elastic loading curve is still the stiffness of the
/// contact.
pub const MOST_PLASTIC_SHARE: f64 = 0.03;

/// Known properties of the contact beside its stiffness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circumstances {
    spots: Option<Spots>,
    plastic_share: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Spots {
    radius_m: f64,
    mean_free_path_m: f64,
}

/// Effect that a conductance leaves out.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Flag {
    /// Films, such as oxide or dirt: both bodies are taken to be clean.
    FilmNotConsidered,
    /// Ballistic transport: carriers pass the spots without colliding, and the resistance exceeds that of diffusion
    /// (Sharvin 1965).
    SpotsBelowMeanFreePath {
        /// Typical radius of a spot \[m\].
        spot_radius_m: f64,
        /// Mean free path \[m\].
        mean_free_path_m: f64,
    },
    /// Plastic flow of more than [`MOST_PLASTIC_SHARE`] of the contact. The analogy takes the elastic stiffness
    /// against a small change of load, which is then neither the slope of the loading curve nor that of an elastic
    /// theory under this load.
    PlasticLoading {
        /// Plastic share of the contact.
        plastic_share: f64,
    },
}

impl Circumstances {
    /// Creates the circumstances of a contact with a plastic share in \[0, 1\].
    ///
    /// # Errors
    /// [`OutOfBounds`] for a share outside of \[0, 1\].
    pub fn new(plastic_share: f64) -> Result<Self, OutOfBounds> {
        let bound = Bound::Within { at_least: 0.0, at_most: 1.0 };
        let plastic_share = bound.check("plastic share of the contact", plastic_share)?;
        Ok(Circumstances { spots: None, plastic_share })
    }

    /// Adds the typical radius of a spot and the mean free path of the carriers \[m\]; [`ELECTRON_MEAN_FREE_PATH_M`]
    /// for current through a good metal.
    ///
    /// # Errors
    /// [`OutOfBounds`] unless both are positive and within thirty decades of 1.
    pub fn with_spots(self, typical_radius_m: f64, mean_free_path_m: f64) -> Result<Self, OutOfBounds> {
        let spots = Spots {
            radius_m: Bound::Magnitude.check("typical radius of a spot in m", typical_radius_m)?,
            mean_free_path_m: Bound::Magnitude.check("mean free path in m", mean_free_path_m)?,
        };
        Ok(Circumstances { spots: Some(spots), ..self })
    }

    /// Effects that a conductance leaves out.
    #[must_use]
    pub fn flags(&self) -> Vec<Flag> {
        let narrow = self.spots.filter(|spots| spots.radius_m < spots.mean_free_path_m).map(|spots| {
            Flag::SpotsBelowMeanFreePath {
                spot_radius_m: spots.radius_m,
                mean_free_path_m: spots.mean_free_path_m,
            }
        });
        let plastic_share = self.plastic_share;
        let plastic = (plastic_share > MOST_PLASTIC_SHARE).then_some(Flag::PlasticLoading { plastic_share });
        [Some(Flag::FilmNotConsidered), narrow, plastic].into_iter().flatten().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn films_are_always_flagged_and_other_effects_only_where_they_matter() {
        let clean = Circumstances::new(0.0).unwrap();
        assert_eq!(clean.flags(), [Flag::FilmNotConsidered]);
        let wide = clean.with_spots(1e-6, ELECTRON_MEAN_FREE_PATH_M).unwrap();
        assert_eq!(wide.flags(), [Flag::FilmNotConsidered]);
        let narrow = Circumstances::new(0.5).unwrap().with_spots(5e-9, ELECTRON_MEAN_FREE_PATH_M).unwrap();
        assert_eq!(
            narrow.flags()[1..],
            [
                Flag::SpotsBelowMeanFreePath { spot_radius_m: 5e-9, mean_free_path_m: 40e-9 },
                Flag::PlasticLoading { plastic_share: 0.5 }
            ]
        );
    }

    #[test]
    fn shares_and_lengths_out_of_range_are_refused() {
        assert!(Circumstances::new(1.1).is_err() && Circumstances::new(f64::NAN).is_err());
        assert!(Circumstances::new(0.0).unwrap().with_spots(0.0, 1e-8).is_err());
    }
}
