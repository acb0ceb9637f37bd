//! Compact pieces of spots.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use elements::half_space::{Grid, Patch};
use ordered_float::OrderedFloat;

/// Most pieces into which the spots of a map are split; a map of more spots has a piece for each.
const MOST_PIECES: usize = 6000;

/// Largest polar second moment of a compact piece over that of a disc of its area: a rectangle of 1:2 has 1.31, a square 1.05.
const COMPACT: f64 = 1.3;

/// Piece of a spot that conducts as the disc of its area does.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    /// Index of the spot.
    pub spot: usize,
    /// Middle \[m\] from the first point; beyond the map where a spot of a periodic map runs on.
    pub middle_m: [f64; 2],
    /// Area without the staircase at the outline of its spot \[m^2\].
    pub area_m2: f64,
    /// Columns and rows of its points.
    places: Vec<[i32; 2]>,
    /// Polar second moment over that of a disc of its area.
    extent: f64,
    /// Axis along which it is longest.
    axis: [f64; 2],
}

impl Piece {
    /// Creates a piece of a spot whose points conduct over an area of `point_m2` each.
    fn new(spot: usize, places: Vec<[i32; 2]>, point_m2: f64, steps_m: [f64; 2]) -> Self {
        let count = places.len() as f64;
        let mean = |axis: usize| places.iter().map(|place| f64::from(place[axis])).sum::<f64>() / count;
        let middle = [mean(0), mean(1)];
        let [mut xx, mut yy, mut xy] = [0.0; 3];
        for place in &places {
            let [x_m, y_m] = [0, 1].map(|axis| (f64::from(place[axis]) - middle[axis]) * steps_m[axis]);
            xx += x_m * x_m;
            yy += y_m * y_m;
            xy += x_m * y_m;
        }
        let [xx, yy] = [xx / count + steps_m[0].powi(2) / 12.0, yy / count + steps_m[1].powi(2) / 12.0];
        let angle = 0.5 * (2.0 * xy / count).atan2(xx - yy);
        Piece {
            spot,
            middle_m: [middle[0] * steps_m[0], middle[1] * steps_m[1]],
            area_m2: count * point_m2,
            extent: (xx + yy) * std::f64::consts::TAU / (count * steps_m[0] * steps_m[1]),
            axis: [angle.cos(), angle.sin()],
            places,
        }
    }

    /// Length by which the piece is no disc: pieces with the largest are split first; 0 of a compact piece.
    fn excess_m(&self) -> f64 {
        if self.extent > COMPACT && self.places.len() > 1 {
            (self.extent - 1.0) * self.area_m2.sqrt()
        } else {
            0.0
        }
    }

    /// Splits the piece across its longest axis into two with the same number of points, or nearly so.
    fn split(self, steps_m: [f64; 2]) -> [Self; 2] {
        let Piece { spot, area_m2, axis, mut places, .. } = self;
        let point_m2 = area_m2 / places.len() as f64;
        let along = |place: &[i32; 2]| {
            let [x_m, y_m] = [0, 1].map(|axis| f64::from(place[axis]) * steps_m[axis]);
            (OrderedFloat(x_m * axis[0] + y_m * axis[1]), *place)
        };
        let half = places.len() / 2;
        places.select_nth_unstable_by_key(half, along);
        let rest = places.split_off(half);
        [places, rest].map(|places| Piece::new(spot, places, point_m2, steps_m))
    }
}

/// Splits patches until their pieces are compact, the ones that are furthest from a disc first.
pub(super) fn compact(grid: &Grid, patches: Vec<(Patch, Vec<[i32; 2]>)>) -> Vec<Piece> {
    let steps_m = [grid.length_x_m() / grid.columns() as f64, grid.length_y_m() / grid.rows() as f64];
    let most = MOST_PIECES.max(patches.len());
    let whole = patches.into_iter().enumerate().map(|(spot, (patch, places))| {
        Piece::new(spot, places, patch.area_corrected_m2 / patch.points as f64, steps_m)
    });
    let mut pieces: Vec<Piece> = whole.collect();
    let rank = |at: usize, piece: &Piece| (OrderedFloat(piece.excess_m()), Reverse(at));
    let mut queue: BinaryHeap<_> = pieces.iter().enumerate().map(|(at, piece)| rank(at, piece)).collect();
    while let Some((excess_m, Reverse(at))) = queue.pop()
        && excess_m.0 > 0.0
        && pieces.len() < most
    {
        let [one, other] = pieces[at].clone().split(steps_m);
        queue.push(rank(at, &one));
        queue.push(rank(pieces.len(), &other));
        pieces[at] = one;
        pieces.push(other);
    }
    pieces
}
