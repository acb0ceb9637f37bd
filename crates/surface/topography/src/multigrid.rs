//! Multigrid preconditioner for Laplace's equation in a hole of any shape.

/// Index of a missing neighbour.
pub(crate) const NONE: u32 = u32::MAX;
/// Ratio of ties above which only the direction with the stronger ones is coarsened.
const STRONGER: f32 = 2.0;

/// Factor of a tie between cells twice as far apart.
const TWICE_AS_LONG: f32 = 0.5;
/// Factor of a tie to the fixed boundary: from one cell to one and a half.
const LONGER_TO_THE_EDGE: f32 = 2.0 / 3.0;

/// The cells of a grid that belong to a hole, row by row.
#[derive(Default)]
pub(crate) struct Cells {
    pub(crate) rows: Vec<u32>,
    pub(crate) columns: Vec<u32>,
}

/// Ties of cells to their neighbours to the right and below, and to the boundary of the hole; 0 without a neighbour.
#[derive(Default)]
pub(crate) struct Ties {
    pub(crate) right: Vec<f32>,
    pub(crate) below: Vec<f32>,
    pub(crate) boundary_x: Vec<f32>,
    pub(crate) boundary_y: Vec<f32>,
}

/// Grids of a hole, each with cells up to twice as wide and high as those of the one before, down to a single cell.
///
/// Single precision suffices for a preconditioner.
pub(crate) struct Multigrid {
    grids: Vec<Grid>,
}

struct Grid {
    inverse_diagonal: Vec<f32>,
    /// Tie to the next cell, which is the right neighbour if the tie is not 0.
    right: Vec<f32>,
    below: Vec<f32>,
    /// Indices of the cells below and above.
    lower: Vec<u32>,
    upper: Vec<u32>,
    /// Cell of the next grid for each cell; empty on the last grid.
    parents: Vec<u32>,
    load: Vec<f32>,
    values: Vec<f32>,
}

impl Multigrid {
    pub(crate) fn new(mut cells: Cells, mut ties: Ties) -> Self {
        let mut grids = Vec::new();
        loop {
            let mut grid = Grid::new(&cells, &ties);
            if cells.rows.len() <= 1 {
                grids.push(grid);
                return Self { grids };
            }
            let halved = halved(&cells, &ties);
            let coarse;
            (coarse, grid.parents) = parents(&cells, halved);
            ties = coarser_ties(&grid, &ties, coarse.rows.len(), halved);
            cells = coarse;
            grids.push(grid);
        }
    }

    /// Neighbours below of the cells of the finest grid.
    pub(crate) fn lower(&self) -> &[u32] {
        &self.grids[0].lower
    }

    /// Approximates the values for a load. The operator is symmetric and positive, as conjugate gradients need.
    pub(crate) fn solve(&mut self, load: impl Iterator<Item = f32>) -> &[f32] {
        let finest = &mut self.grids[0];
        finest.load.iter_mut().zip(load).for_each(|(to, load)| *to = load);
        cycle(&mut self.grids);
        &self.grids[0].values
    }
}

/// Runs a V-cycle: a forward sweep, the residual on the next grid, a backward sweep.
fn cycle(grids: &mut [Grid]) {
    let [grid, coarser @ ..] = grids else { return };
    grid.sweep_forwards_from_zero();
    let Some(next) = coarser.first_mut() else { return };
    next.load.fill(0.0);
    for (cell, &parent) in grid.parents.iter().enumerate() {
        next.load[parent as usize] += grid.left_after_forwards(cell);
    }
    cycle(coarser);
    let next = &coarser[0];
    for (value, &parent) in grid.values.iter_mut().zip(&grid.parents) {
        *value += next.values[parent as usize];
    }
    grid.sweep_backwards();
}

impl Grid {
    fn new(cells: &Cells, ties: &Ties) -> Self {
        let count = cells.rows.len();
        let lower = lower(cells);
        let mut upper = vec![NONE; count];
        let mut diagonal: Vec<f32> =
            ties.boundary_x.iter().zip(&ties.boundary_y).map(|(x, y)| x + y).collect();
        for cell in 0..count {
            if ties.right[cell] > 0.0 {
                diagonal[cell] += ties.right[cell];
                diagonal[cell + 1] += ties.right[cell];
            }
            if lower[cell] != NONE {
                upper[lower[cell] as usize] = cell as u32;
                diagonal[cell] += ties.below[cell];
                diagonal[lower[cell] as usize] += ties.below[cell];
            }
        }
        Self {
            inverse_diagonal: diagonal.into_iter().map(f32::recip).collect(),
            right: ties.right.clone(),
            below: ties.below.clone(),
            lower,
            upper,
            parents: Vec::new(),
            load: vec![0.0; count],
            values: vec![0.0; count],
        }
    }

    /// Gauss-Seidel sweep from zero: later neighbours are still 0.
    fn sweep_forwards_from_zero(&mut self) {
        let mut left = 0.0;
        for cell in 0..self.load.len() {
            let mut load = self.load[cell] + left;
            if self.upper[cell] != NONE {
                let upper = self.upper[cell] as usize;
                load += self.below[upper] * self.values[upper];
            }
            self.values[cell] = load * self.inverse_diagonal[cell];
            left = self.right[cell] * self.values[cell];
        }
    }

    /// Residual after the forward sweep: the contributions of later neighbours.
    fn left_after_forwards(&self, cell: usize) -> f32 {
        let mut left = 0.0;
        if self.right[cell] > 0.0 {
            left += self.right[cell] * self.values[cell + 1];
        }
        if self.lower[cell] != NONE {
            left += self.below[cell] * self.values[self.lower[cell] as usize];
        }
        left
    }

    fn sweep_backwards(&mut self) {
        let mut right = 0.0;
        for cell in (0..self.load.len()).rev() {
            let mut load = self.load[cell] + self.right[cell] * right;
            if cell > 0 {
                load += self.right[cell - 1] * self.values[cell - 1];
            }
            if self.lower[cell] != NONE {
                load += self.below[cell] * self.values[self.lower[cell] as usize];
            }
            if self.upper[cell] != NONE {
                let upper = self.upper[cell] as usize;
                load += self.below[upper] * self.values[upper];
            }
            right = load * self.inverse_diagonal[cell];
            self.values[cell] = right;
        }
    }
}

/// Finds the cell below each cell.
fn lower(cells: &Cells) -> Vec<u32> {
    let count = cells.rows.len();
    let place = |cell: usize| (cells.rows[cell], cells.columns[cell]);
    let mut below = 0;
    let of_cell = |cell: usize| {
        let wanted = (cells.rows[cell] + 1, cells.columns[cell]);
        while below < count && place(below) < wanted {
            below += 1;
        }
        if below < count && place(below) == wanted { below as u32 } else { NONE }
    };
    (0..count).map(of_cell).collect()
}

/// Chooses the directions to coarsen: both, unless cells are tied far more strongly along one.
fn halved(cells: &Cells, ties: &Ties) -> [bool; 2] {
    let strongest = |ties: &[f32]| ties.iter().copied().fold(0.0, f32::max);
    let (x, y) = (strongest(&ties.right), strongest(&ties.below));
    let extends = |places: &[u32]| places.iter().any(|&place| place != places[0]);
    match (extends(&cells.columns), extends(&cells.rows)) {
        (true, true) if x > STRONGER * y => [true, false],
        (true, true) if y > STRONGER * x => [false, true],
        _ => [true, true],
    }
}

/// Computes the cells of the next grid, and the parent of each cell.
fn parents(cells: &Cells, [halve_x, halve_y]: [bool; 2]) -> (Cells, Vec<u32>) {
    let (shift_x, shift_y) = (u32::from(halve_x), u32::from(halve_y));
    let count = cells.rows.len();
    let (mut coarse, mut parents) = (Cells::default(), vec![0; count]);
    let mut first = 0;
    while first < count {
        // Merge one or two rows.
        let row = cells.rows[first] >> shift_y;
        let rows_end = first + cells.rows[first..].partition_point(|&other| other >> shift_y == row);
        let middle = first + cells.rows[first..rows_end].partition_point(|&other| other == cells.rows[first]);
        let (mut a, mut b) = (first, middle);
        while a < middle || b < rows_end {
            let column_of = |cell: usize, end: usize| (cell < end).then(|| cells.columns[cell] >> shift_x);
            let columns = [column_of(a, middle), column_of(b, rows_end)];
            let Some(column) = columns.into_iter().flatten().min() else { break };
            let parent = coarse.rows.len() as u32;
            for (cell, end) in [(&mut a, middle), (&mut b, rows_end)] {
                while *cell < end && cells.columns[*cell] >> shift_x == column {
                    parents[*cell] = parent;
                    *cell += 1;
                }
            }
            coarse.rows.push(row);
            coarse.columns.push(column);
        }
        first = rows_end;
    }
    (coarse, parents)
}

/// Computes the ties of the next grid: those that cross between its cells, weakened by their length.
fn coarser_ties(grid: &Grid, ties: &Ties, count: usize, [halved_x, halved_y]: [bool; 2]) -> Ties {
    let mut coarse = Ties {
        right: vec![0.0; count],
        below: vec![0.0; count],
        boundary_x: vec![0.0; count],
        boundary_y: vec![0.0; count],
    };
    let factor = |halved: bool, factor: f32| if halved { factor } else { 1.0 };
    let (factor_x, factor_y) = (factor(halved_x, TWICE_AS_LONG), factor(halved_y, TWICE_AS_LONG));
    let (edge_x, edge_y) = (factor(halved_x, LONGER_TO_THE_EDGE), factor(halved_y, LONGER_TO_THE_EDGE));
    for (cell, &parent) in grid.parents.iter().enumerate() {
        let at = parent as usize;
        coarse.boundary_x[at] += edge_x * ties.boundary_x[cell];
        coarse.boundary_y[at] += edge_y * ties.boundary_y[cell];
        if ties.right[cell] > 0.0 && grid.parents[cell + 1] != parent {
            coarse.right[at] += factor_x * ties.right[cell];
        }
        if grid.lower[cell] != NONE && grid.parents[grid.lower[cell] as usize] != parent {
            coarse.below[at] += factor_y * ties.below[cell];
        }
    }
    coarse
}
