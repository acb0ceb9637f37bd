//! Neighbours on the grid of a gap, and what is connected there.

use elements::half_space::Grid;

use crate::flow::{Ends, FlowDirection};

/// The grid, seen along the flow.
pub(super) struct Lattice {
    /// Number of points.
    pub points: usize,
    /// Direction of the flow.
    pub direction: FlowDirection,
    /// Distance of points across the flow over that along it.
    pub ratio: f64,
    /// Condition at the two ends along the flow.
    pub ends: Ends,
    columns: usize,
}

impl Lattice {
    pub(super) fn new(grid: &Grid, direction: FlowDirection, ends: Ends) -> Self {
        let (rows, columns) = (grid.rows(), grid.columns());
        let (step_x_m, step_y_m) = (grid.length_x_m() / columns as f64, grid.length_y_m() / rows as f64);
        let ratio = match direction {
            FlowDirection::X => step_y_m / step_x_m,
            FlowDirection::Y => step_x_m / step_y_m,
        };
        Lattice { points: grid.points(), direction, ratio, columns, ends }
    }

    /// Power that a slot of the mean gap dissipates.
    pub(super) fn power_of_slot(&self) -> f64 {
        self.points as f64 * self.ratio
    }

    /// The next point along the flow; the first behind the last.
    pub(super) fn next(&self, point: usize) -> usize {
        match self.direction {
            FlowDirection::X => self.right(point),
            FlowDirection::Y => self.below(point),
        }
    }

    /// The next point across the flow; the first behind the last.
    pub(super) fn beside(&self, point: usize) -> usize {
        match self.direction {
            FlowDirection::X => self.below(point),
            FlowDirection::Y => self.right(point),
        }
    }

    /// Returns true for points of the first row or column along the flow.
    pub(super) fn is_first(&self, point: usize) -> bool {
        match self.direction {
            FlowDirection::X => (point as u32).is_multiple_of(self.columns as u32),
            FlowDirection::Y => point < self.columns,
        }
    }

    /// Returns true for points of the last row or column along the flow.
    pub(super) fn is_last(&self, point: usize) -> bool {
        match self.direction {
            FlowDirection::X => (point as u32 + 1).is_multiple_of(self.columns as u32),
            FlowDirection::Y => point >= self.points - self.columns,
        }
    }

    fn right(&self, point: usize) -> usize {
        let is_end = (point as u32 + 1).is_multiple_of(self.columns as u32);
        if is_end { point + 1 - self.columns } else { point + 1 }
    }

    fn below(&self, point: usize) -> usize {
        if point + self.columns < self.points {
            point + self.columns
        } else {
            point + self.columns - self.points
        }
    }
}

/// Parts of a field that are connected, each point with its offset from the root of its part in turns around the field.
pub(super) struct Parts {
    parents: Vec<u32>,
    turns: Vec<i32>,
    /// True for roots of parts that lead around the field along the flow, or from one reservoir to the other.
    pub leads_through: Vec<bool>,
}

impl Parts {
    /// Connects the neighbours among the open points.
    pub(super) fn new(lattice: &Lattice, is_open: impl Fn(usize) -> bool) -> Self {
        let points = lattice.points;
        let mut parts = Parts {
            parents: (0..=points as u32).collect(),
            turns: vec![0; points + 1],
            leads_through: vec![false; points + 1],
        };
        // Both reservoirs are one point: a path from one to the other leads around the field.
        let reservoir = points as u32;
        for point in (0..points).filter(|&point| is_open(point)) {
            let (next, beside) = (lattice.next(point), lattice.beside(point));
            if is_open(beside) {
                parts.connect(point as u32, beside as u32, 0);
            }
            let is_last = lattice.is_last(point);
            if is_last && lattice.ends == Ends::Reservoirs {
                parts.connect(point as u32, reservoir, 1);
            } else if is_open(next) {
                parts.connect(point as u32, next as u32, i32::from(is_last));
            }
            if lattice.ends == Ends::Reservoirs && lattice.is_first(point) {
                parts.connect(reservoir, point as u32, 0);
            }
        }
        parts
    }

    /// Finds the root of a point and its turns from there, and shortens the way.
    pub(super) fn root(&mut self, point: u32) -> (u32, i32) {
        let (mut root, mut turns) = (point, 0);
        while self.parents[root as usize] != root {
            turns += self.turns[root as usize];
            root = self.parents[root as usize];
        }
        let (mut at, mut left) = (point, turns);
        while self.parents[at as usize] != root && at != root {
            let (next, own) = (self.parents[at as usize], self.turns[at as usize]);
            self.parents[at as usize] = root;
            self.turns[at as usize] = left;
            left -= own;
            at = next;
        }
        (root, turns)
    }

    /// Connects two points, with `turns` around the field from the first to the second.
    fn connect(&mut self, one: u32, other: u32, turns: i32) {
        let ((root, own), (second, others)) = (self.root(one), self.root(other));
        // The second root lies own + turns - others turns from the first.
        let between = own + turns - others;
        if root == second {
            self.leads_through[root as usize] |= between != 0;
            return;
        }
        self.parents[second as usize] = root;
        self.turns[second as usize] = between;
        self.leads_through[root as usize] |= self.leads_through[second as usize];
    }
}
