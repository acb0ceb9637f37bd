//! States of one population over a range of separations, from polynomials.

mod piece;

use std::sync::OnceLock;

use asperity::AsperityError;

use crate::asperities::answers::Asperities;
use crate::far::FAR;
use crate::quadrature::Precision;
use crate::quadrature::frames::Frames;
use crate::{Condition, ContactState, Sweep};
use piece::{Piece, coordinate, separation};

/// States between two separations, which cost some tenths of a microsecond each once the table is built
/// ([`StatisticalContact::table`](crate::StatisticalContact::table)). Building it takes some ten to fifty states.
///
/// ln p and ln A are polynomials over a few pieces of the range, each fitted until the terms left out are below the
/// tolerance. The error estimate of a state bounds these terms and the errors of the states that they were fitted to. A
/// state depends on the ends of the table, but not on what is asked before. Its `evaluations` are 0.
///
/// Conditions outside of the table, and pressures where the pressure does not fall with the separation all over it, are
/// computed as single states.
///
/// ```
/// use asperity::{ElasticBody, MaterialPair};
/// use stat_contact::{AsperityLaw, Condition, InterferenceLaw, Population, StatisticalContact};
///
/// let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2)?);
/// let law = AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson };
/// let contact = StatisticalContact::new(&pair, &Population::new(45.6e-9, 26e12, 6.66e-9)?, &law);
/// let table = contact.table([Condition::Pressure(1e3), Condition::Pressure(1e9)], 1e-10)?;
/// let state = table.at_pressure(50e6)?;
/// let single = contact.at_pressure(50e6, 1e-10, None)?;
/// assert!((state.area_fraction / single.area_fraction - 1.0).abs() <= state.error_estimate);
/// assert!(state.evaluations == 0 && table.evaluations > 0);
/// # Ok::<(), asperity::AsperityError>(())
/// ```
#[must_use]
#[derive(Debug)]
pub struct StateTable<'a> {
    asperities: &'a dyn Asperities,
    sigma_s_m: f64,
    precision: Precision,
    /// Pieces in the order of their separations, which leave out what no polynomial fits.
    pieces: Vec<Piece>,
    /// True if every pressure of the table has one separation, which is in the table; found when first asked.
    has_one_separation: OnceLock<bool>,
    /// Number of evaluations of the law of one asperity that the polynomials have cost.
    pub evaluations: usize,
}

impl<'a> StateTable<'a> {
    pub(crate) fn new(mut frames: Frames<'a>, ends: [Condition; 2]) -> Result<Self, AsperityError> {
        let Frames { asperities, sigma_s_m, precision, .. } = frames;
        let mut table = StateTable {
            asperities,
            sigma_s_m,
            precision,
            pieces: Vec::new(),
            has_one_separation: OnceLock::new(),
            evaluations: 0,
        };
        let [first, second] = ends.map(|end| table.separation_of(end));
        // More than the asperities carry has no separation. A closed form needs no polynomials.
        if let (Some(first_m), Some(second_m)) = (first?, second?)
            && first_m.min(second_m) > -FAR * sigma_s_m
            && !frames.have_closed_form()
        {
            let [low, high] =
                [first_m.min(second_m), first_m.max(second_m)].map(|d| coordinate(d / sigma_s_m));
            table.fit(&mut frames, low, high);
            table.evaluations += frames.evaluations();
        }
        Ok(table)
    }

    /// Separation \[m\] of a condition; `None` if none carries it.
    fn separation_of(&mut self, condition: Condition) -> Result<Option<f64>, AsperityError> {
        match condition {
            Condition::Separation(separation_m) => {
                Sweep::SEPARATION_M.check("separation in m", separation_m).map(Some)
            }
            Condition::Pressure(pressure_pa) => {
                let state = self.alone().at_pressure(pressure_pa)?;
                self.evaluations += state.evaluations;
                Ok(state.separation_m)
            }
        }
    }

    /// Fits pieces between two coordinates, halving what no polynomial fits.
    fn fit(&mut self, frames: &mut Frames<'_>, from_x: f64, to_x: f64) {
        // Rounding of a search that ends at the ends of the table.
        const MARGIN: f64 = 1e-9;
        // Narrower ones cost more than the states they serve.
        const LEAST_WIDTH: f64 = 0.05;
        let mut open = vec![[from_x - MARGIN, to_x + MARGIN]];
        while let Some([from_x, to_x]) = open.pop() {
            match Piece::fit(frames, from_x, to_x) {
                Some(piece) => self.pieces.push(piece),
                None if to_x - from_x > LEAST_WIDTH => {
                    let middle = 0.5 * (from_x + to_x);
                    open.extend([[middle, to_x], [from_x, middle]]);
                }
                None => {}
            }
        }
    }

    fn has_one_separation(&self) -> bool {
        *self.has_one_separation.get_or_init(|| self.falls() && !self.is_repeated_beyond())
    }

    /// Returns true if the pieces leave out nothing and the pressure falls all over them.
    fn falls(&self) -> bool {
        let joined = self.pieces.windows(2).all(|pair| pair[0].to_x == pair[1].from_x);
        joined && self.pieces.iter().all(Piece::falls)
    }

    /// Returns true if the pressure at the end of the table is carried by a larger separation as well.
    fn is_repeated_beyond(&self) -> bool {
        // More than the search and the table may differ by.
        const APART: f64 = 1e-3;
        let Some(last) = self.pieces.last() else { return false };
        let end = last.integrals(last.to_x, separation(last.to_x));
        let pressure_pa = ContactState::of(&end, 0.0, self.sigma_s_m).pressure_pa;
        // Pressures below the smallest double are carried only where every law rises.
        let largest = self.alone().at_pressure(pressure_pa);
        let largest_m = largest.ok().and_then(|state| state.separation_m);
        largest_m.is_some_and(|d| coordinate(d / self.sigma_s_m) > last.to_x + APART)
    }

    /// Computes a state without the table.
    fn alone(&self) -> Sweep<'a> {
        Sweep::on(Frames::new(self.asperities, self.sigma_s_m, self.precision))
    }

    /// Returns the state at a pressure or a separation.
    ///
    /// # Errors
    /// The errors of [`at_pressure`](Self::at_pressure) and [`at_separation`](Self::at_separation).
    pub fn at(&self, condition: Condition) -> Result<ContactState, AsperityError> {
        match condition {
            Condition::Pressure(pressure_pa) => self.at_pressure(pressure_pa),
            Condition::Separation(separation_m) => self.at_separation(separation_m),
        }
    }

    /// Returns the state at a separation d \[m\] from the mean of the asperity heights, of either sign.
    ///
    /// # Errors
    /// The errors of [`StatisticalContact::at_separation`](crate::StatisticalContact::at_separation).
    pub fn at_separation(&self, separation_m: f64) -> Result<ContactState, AsperityError> {
        let u = separation_m / self.sigma_s_m;
        let x = coordinate(u);
        let at = self.pieces.partition_point(|piece| piece.to_x < x);
        let Some(piece) = self.pieces.get(at).filter(|piece| piece.from_x <= x) else {
            return self.alone().at_separation(separation_m);
        };
        let state = ContactState::at_separation(&piece.integrals(x, u), separation_m, self.sigma_s_m);
        Ok(state.with_flattened_share(self.asperities, self.sigma_s_m))
    }

    /// Returns the state at the largest separation that carries a pressure \[Pa\] over the nominal area.
    ///
    /// # Errors
    /// The errors of [`StatisticalContact::at_pressure`](crate::StatisticalContact::at_pressure).
    pub fn at_pressure(&self, pressure_pa: f64) -> Result<ContactState, AsperityError> {
        let ln_pressure_pa = pressure_pa.ln();
        let at = self.pieces.partition_point(|piece| piece.log_pressure_at_end() > ln_pressure_pa);
        let is_there = |piece: &&Piece| {
            self.has_one_separation()
                && ln_pressure_pa <= piece.log_pressure_at_start()
                && pressure_pa.is_normal()
        };
        let Some(piece) = self.pieces.get(at).filter(is_there) else {
            return self.alone().at_pressure(pressure_pa);
        };
        let x = piece.coordinate_of(ln_pressure_pa);
        let u = separation(x);
        let state = ContactState::of(&piece.integrals(x, u), 0.0, self.sigma_s_m);
        let state =
            ContactState { separation_m: Some(u * self.sigma_s_m), pressure_pa, ln_pressure_pa, ..state };
        Ok(state.with_flattened_share(self.asperities, self.sigma_s_m))
    }
}
