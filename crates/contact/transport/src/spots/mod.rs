//! Electrical resistance of the spots of a contact, and the current through each.
//!
//! Discs of radii a_i at distances d_ij between two half-spaces, each at one potential: V = sum_j R_ij I_j with R_ii =
//! (rho_1 + rho_2)/(4 a_i) and R_ij = (rho_1 + rho_2)/(2 pi d_ij) (Greenwood 1966, Br. J. Appl. Phys. 17:1621). Two equal discs come out
//! low by 0.3 % at d/a = 4 and by 0.05 % at 10. On periodic maps 1/d is the sum over all images less its mean, which is the nominal
//! flow. A film adds its specific resistance over the area of the spot, and ballistic electrons add 4 rho l/(3 pi a^2) with their mean
//! free path l and rho the mean of both bodies (Sharvin 1965).
//!
//! Spots that are no discs, such as rings, are split into compact pieces, each the disc of its area without the staircase at the
//! outline: ellipses of 1:2 come out high by 3 %, of 1:10 low by 4.5 %. Over Barber's (2003) resistance, from the stiffness of the
//! elements on the same map, the result lies at 0.99 to 1.03 for areas up to 0.07, at 0.97 to 0.98 at 0.13, at 0.94 to 0.96 at 0.19, at
//! 0.87 to 0.90 at 0.31 and at 0.57 to 0.69 at 0.47, on periodic random surfaces of 12 spectra; with free edges at 0.99 to 1.02 up to
//! 0.41 (`examples/spots_against_stiffness.rs`). Beyond the range of [`largest_area_fraction`] Barber's value is the answer. The share of
//! the current through a spot was within 6 % of that of the elements for every spot that carries 0.5 % or more, for areas from 0.05 to
//! 0.42.

mod lattice;
mod pieces;
mod system;
mod tables;

use elements::half_space::{Grid, HalfSpaceError, Patch, Places, patches_with_places};
use elements::{Boundary, ContactField, PointState};
use interface::conductance::{RelativeStiffness, Resistivities};
use thiserror::Error;
use units::{Bound, OutOfBounds};

use lattice::LatticeSum;
pub use tables::{spots_table, with_resistances};

/// Returns the largest share of the nominal area that touches for which the spots give the resistance, within 6 % of that from the
/// stiffness.
#[must_use]
pub fn largest_area_fraction(boundary: Boundary) -> f64 {
    match boundary {
        Boundary::Periodic => 0.2,
        Boundary::Free => 0.4,
    }
}

/// Largest number of spots: their system takes 0.8 GB.
pub const MOST_SPOTS: usize = 20_000;

/// Conduction of two bodies, and what lies between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpotConduction {
    resistivities: Resistivities,
    /// Resistance in series with each part of a spot, times its area \[ohm m^2\].
    in_series_ohm_m2: f64,
}

impl SpotConduction {
    /// Creates bodies of these resistivities that touch without a film.
    #[must_use]
    pub fn new(resistivities: Resistivities) -> Self {
        SpotConduction { resistivities, in_series_ohm_m2: 0.0 }
    }

    /// Adds a film, such as an oxide, of a specific resistance \[ohm m^2\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless it is positive and within thirty decades of 1.
    pub fn with_film(mut self, film_ohm_m2: f64) -> Result<Self, OutOfBounds> {
        self.in_series_ohm_m2 +=
            Bound::Magnitude.check("specific resistance of the film in ohm m^2", film_ohm_m2)?;
        Ok(self)
    }

    /// Adds Sharvin's resistance of electrons with a mean free path \[m\].
    ///
    /// # Errors
    /// [`OutOfBounds`] unless it is positive and within thirty decades of 1.
    pub fn with_mean_free_path(mut self, path_m: f64) -> Result<Self, OutOfBounds> {
        let path_m = Bound::Magnitude.check("mean free path in m", path_m)?;
        self.in_series_ohm_m2 += 2.0 / 3.0 * self.resistivities.sum_ohm_m() * path_m;
        Ok(self)
    }
}

/// Region that touches without a break, and its share of the current.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactSpot {
    /// Middle along x from the first point of the map \[m\].
    pub x_m: f64,
    /// Middle along y from the first point of the map \[m\].
    pub y_m: f64,
    /// Area without the staircase at the outline \[m^2\].
    pub area_m2: f64,
    /// Share of the current through all spots.
    pub current_share: f64,
}

impl ContactSpot {
    /// Radius of the disc of equal area \[m\].
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        (self.area_m2 / std::f64::consts::PI).sqrt()
    }
}

/// Spots at one potential.
#[derive(Debug, Clone, PartialEq)]
pub struct Spots {
    /// Resistance of all spots together \[ohm\]; of a periodic map without that of the bodies to a uniform current.
    pub resistance_ohm: f64,
    /// Spots, the one of the most points first.
    pub spots: Vec<ContactSpot>,
    /// Number of discs into which they were split.
    pub discs: usize,
    /// Share of the nominal area that touches, without the staircase at the outlines.
    pub area_fraction: f64,
    /// True if the area is in the range of [`largest_area_fraction`].
    pub is_in_range: bool,
}

impl Spots {
    /// Largest share of the current through one spot.
    #[must_use]
    pub fn largest_share(&self) -> f64 {
        self.spots.iter().map(|spot| spot.current_share).fold(0.0, f64::max)
    }
}

/// Reason why the spots of a contact were not solved.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum SpotsError {
    /// The map has another size than its grid.
    #[error(transparent)]
    Grid(#[from] HalfSpaceError),
    /// A line has bands, which have no finite resistance.
    #[error(
        "spots of the contact: the map is a line, whose contacts are endless bands; press a map of several rows and columns"
    )]
    Line,
    /// Nothing touches.
    #[error("spots of the contact: no point touches")]
    NoContact,
    /// The system would not fit into memory.
    #[error(
        "spots of the contact: there are {spots} spots, and at most {MOST_SPOTS} are solved; use the resistance from the stiffness"
    )]
    TooMany {
        /// Number of spots.
        spots: usize,
    },
    /// Some current would run against the voltage: the discs overlap too much.
    #[error(
        "spots of the contact: current runs backwards through some of {spots} spots, which lie too close for discs; use the resistance from \
         the stiffness"
    )]
    Indefinite {
        /// Number of spots.
        spots: usize,
    },
}

impl Spots {
    /// Solves the spots of a map of contact, row by row. `nominal_share` of the map is the nominal area.
    ///
    /// # Errors
    /// [`SpotsError`] for maps without spots or out of the range of discs.
    pub fn solve(
        grid: &Grid,
        boundary: Boundary,
        is_contact: &[bool],
        nominal_share: f64,
        conduction: &SpotConduction,
    ) -> Result<Self, SpotsError> {
        let patches = patches_with_places(grid, boundary == Boundary::Periodic, is_contact)?;
        Self::solve_patches(grid, boundary, patches, nominal_share, conduction)
    }

    fn solve_patches(
        grid: &Grid,
        boundary: Boundary,
        patches: Vec<(Patch, Places)>,
        nominal_share: f64,
        conduction: &SpotConduction,
    ) -> Result<Self, SpotsError> {
        let is_periodic = boundary == Boundary::Periodic;
        if grid.is_line() {
            return Err(SpotsError::Line);
        }
        let lengths_m = [grid.length_x_m(), grid.length_y_m()];
        let touching_m2: f64 = patches.iter().map(|(patch, _)| patch.area_corrected_m2).sum();
        let area_fraction = touching_m2 / (lengths_m[0] * lengths_m[1] * nominal_share);
        let spots = patches.len();
        match spots {
            0 => return Err(SpotsError::NoContact),
            _ if spots > MOST_SPOTS => return Err(SpotsError::TooMany { spots }),
            _ => {}
        }
        let pieces = pieces::compact(grid, patches);
        let images = is_periodic.then(|| LatticeSum::new(lengths_m));
        let constriction_ohm_m = conduction.resistivities.sum_ohm_m();
        let per_distance_ohm_m = constriction_ohm_m / std::f64::consts::TAU;
        let of_images_per_m = images.as_ref().map_or(0.0, LatticeSum::own_per_m);
        let own_ohm = |area_m2: f64| {
            let radius_m = (area_m2 / std::f64::consts::PI).sqrt();
            constriction_ohm_m / (4.0 * radius_m)
                + per_distance_ohm_m * of_images_per_m
                + conduction.in_series_ohm_m2 / area_m2
        };
        let own_ohm: Vec<f64> = pieces.iter().map(|piece| own_ohm(piece.area_m2)).collect();
        let between_ohm = |row: usize, column: usize| {
            let (one, other) = (pieces[row].middle_m, pieces[column].middle_m);
            let distance_m = [one[0] - other[0], one[1] - other[1]];
            let per_m = match &images {
                Some(images) => images.at_per_m(distance_m),
                None => (distance_m[0].powi(2) + distance_m[1].powi(2)).sqrt().recip(),
            };
            per_distance_ohm_m * per_m
        };
        let indefinite = SpotsError::Indefinite { spots };
        let currents_a_per_v = system::currents(&own_ohm, between_ohm).map_err(|_| indefinite)?;
        let total_a_per_v: f64 = currents_a_per_v.iter().sum();
        let mut sums = vec![[0.0; 4]; spots];
        for (piece, current) in pieces.iter().zip(&currents_a_per_v) {
            let [x_m, y_m] = piece.middle_m;
            let parts = [piece.area_m2, piece.area_m2 * x_m, piece.area_m2 * y_m, current / total_a_per_v];
            sums[piece.spot].iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        let on_map_m =
            |middle_m: f64, length_m: f64| if is_periodic { middle_m.rem_euclid(length_m) } else { middle_m };
        let of_sums = |[area_m2, x, y, current_share]: [f64; 4]| ContactSpot {
            x_m: on_map_m(x / area_m2, lengths_m[0]),
            y_m: on_map_m(y / area_m2, lengths_m[1]),
            area_m2,
            current_share,
        };
        let spots: Vec<ContactSpot> = sums.into_iter().map(of_sums).collect();
        if !(total_a_per_v > 0.0 && spots.iter().all(|spot| spot.current_share > 0.0)) {
            return Err(indefinite);
        }
        Ok(Spots {
            resistance_ohm: total_a_per_v.recip(),
            spots,
            discs: pieces.len(),
            area_fraction,
            is_in_range: area_fraction <= largest_area_fraction(boundary),
        })
    }
}

/// Spots of one surface under one load.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldSpots {
    /// Index of the load.
    pub load: usize,
    /// Number of the surface.
    pub surface: usize,
    /// Nominal pressure \[Pa\].
    pub nominal_pressure_pa: f64,
    /// Nominal area of the map \[m^2\].
    pub nominal_area_m2: f64,
    /// Area that touches, without the staircase at its outlines \[m^2\].
    pub touching_area_m2: f64,
    /// Contact modulus E* \[Pa\].
    pub contact_modulus_pa: f64,
    /// The bodies.
    pub conduction: SpotConduction,
    /// The spots, or the reason why they were not solved.
    pub solved: Result<Spots, SpotsError>,
}

/// Resistance of a contact, and where it comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactResistance {
    /// Resistance of the spots \[ohm\].
    Spots(f64),
    /// Resistance from the stiffness \[ohm\], by Barber's analogy: the spots are out of range.
    Stiffness(f64),
}

impl ContactResistance {
    /// Resistance \[ohm\].
    #[must_use]
    pub fn ohm(&self) -> f64 {
        let (ContactResistance::Spots(ohm) | ContactResistance::Stiffness(ohm)) = *self;
        ohm
    }
}

impl FieldSpots {
    /// Solves the spots of a pressed surface.
    ///
    /// # Errors
    /// [`SpotsError`] for a field of another size than its grid, and for a line. Spots out of range are no error: their stiffness gives
    /// the resistance.
    pub fn new(field: &ContactField<'_>, conduction: SpotConduction) -> Result<Self, SpotsError> {
        let (grid, outline) = (field.relief.grid()?, field.relief.outline()?);
        let patches = patches_of(field, &grid)?;
        let touching_m2 = patches.iter().map(|(patch, _)| patch.area_corrected_m2).sum();
        let boundary = field.relief.boundary;
        let solved = Spots::solve_patches(&grid, boundary, patches, outline.share(), &conduction);
        match solved {
            Err(error @ (SpotsError::Grid(_) | SpotsError::Line)) => Err(error),
            solved => Ok(FieldSpots {
                load: field.load,
                surface: field.surface,
                nominal_pressure_pa: field.nominal_pressure_pa,
                nominal_area_m2: outline.area_m2(),
                touching_area_m2: touching_m2,
                contact_modulus_pa: field.contact_modulus_pa,
                conduction,
                solved,
            }),
        }
    }

    /// Returns the share of the current through the spot of each point of the field, row by row, 0 between spots; `None` if the spots
    /// were not solved.
    ///
    /// # Errors
    /// [`SpotsError`] for a field of another size than its grid.
    pub fn shares_at_points(&self, field: &ContactField<'_>) -> Result<Option<Vec<f64>>, SpotsError> {
        let Ok(solved) = &self.solved else { return Ok(None) };
        let grid = field.relief.grid()?;
        let patches = patches_of(field, &grid)?;
        let mut shares = vec![0.0; grid.points()];
        for (spot, (_, places)) in solved.spots.iter().zip(patches) {
            for [column, row] in places {
                let [column, row] =
                    [column.rem_euclid(grid.columns() as i32), row.rem_euclid(grid.rows() as i32)];
                shares[row as usize * grid.columns() + column as usize] = spot.current_share;
            }
        }
        Ok(Some(shares))
    }

    /// Returns the resistance by Barber's analogy from the stiffness \[Pa/m\] of the surface \[ohm\], with film and ballistic electrons
    /// over the area that touches.
    ///
    /// # Errors
    /// [`OutOfBounds`] for a stiffness or an area out of bounds.
    pub fn resistance_from_stiffness_ohm(&self, stiffness_pa_per_m: f64) -> Result<f64, OutOfBounds> {
        let relative = RelativeStiffness::new(stiffness_pa_per_m, self.contact_modulus_pa)?;
        let whole = relative.equivalent_spot(self.nominal_area_m2)?;
        let in_series_ohm = self.conduction.in_series_ohm_m2 / self.touching_area_m2;
        Ok(whole.electrical_resistance_ohm(&self.conduction.resistivities) + in_series_ohm)
    }

    /// Returns the resistance of the contact: of its spots, or beyond their range from its stiffness \[Pa/m\], if that is known.
    ///
    /// # Errors
    /// [`OutOfBounds`] for a stiffness or an area out of bounds.
    pub fn resistance(
        &self,
        stiffness_pa_per_m: Option<f64>,
    ) -> Result<Option<ContactResistance>, OutOfBounds> {
        match (&self.solved, stiffness_pa_per_m) {
            (Ok(spots), _) if spots.is_in_range => Ok(Some(ContactResistance::Spots(spots.resistance_ohm))),
            (_, Some(stiffness)) => {
                Ok(Some(ContactResistance::Stiffness(self.resistance_from_stiffness_ohm(stiffness)?)))
            }
            (_, None) => Ok(None),
        }
    }
}

/// Finds the patches of a pressed surface, the largest first, with their places.
fn patches_of(field: &ContactField<'_>, grid: &Grid) -> Result<Vec<(Patch, Places)>, HalfSpaceError> {
    let is_contact: Vec<bool> = field.states().map(|state| state != PointState::Open).collect();
    patches_with_places(grid, field.relief.boundary == Boundary::Periodic, &is_contact)
}
