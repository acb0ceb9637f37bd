//! What the columns of a table hold: positions, heights, signals. Names and units decide, then the numbers.

use super::columns::Columns;
use super::even_columns::{is_constant, is_counting, is_even, is_grid, is_monotone};
use super::heads::{Heads, Role};
use crate::error::ScanReadError;

/// Fewest rows in which positions that rise are no chance.
const TELLING: usize = 3;
/// Fewest rows in which a column of a map hardly rises by chance while others do not.
pub(super) const SURE: usize = 8;

/// The columns of a table, from 0.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Roles {
    /// Positions along x and y.
    pub(super) positions: [Option<usize>; 2],
    /// Positions of further profiles, each for the heights behind it.
    pub(super) more_positions: Vec<usize>,
    /// Tells which heights do not count.
    pub(super) mask: Option<Mask>,
    /// A channel each.
    pub(super) heights: Vec<usize>,
    /// Values that are no heights, a channel each.
    pub(super) signals: Vec<usize>,
}

/// A column that tells which heights do not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mask {
    /// The column, from 0.
    pub(super) column: usize,
    /// True if numbers other than 0 mark what counts, false if they mark what does not.
    pub(super) marks_valid: bool,
}

impl Roles {
    /// The column of positions of a column of heights: the last before it, else the first of all.
    pub(super) fn position_of(&self, height: usize) -> Option<usize> {
        let more = self.more_positions.iter().rfind(|position| **position < height).copied();
        more.or(self.positions[0]).or(self.positions[1])
    }
}

/// Arrangement of the numbers of a text.
#[derive(Debug, PartialEq)]
pub(super) enum Layout {
    /// Heights row after row.
    Map,
    /// Columns of different kinds.
    Table(Roles),
}

/// Decides what the columns hold. `is_map` is true where a size along both axes is known; `wanted` is the column of
/// heights that the caller chose by its number.
pub(super) fn decide(
    columns: &Columns,
    heads: &Heads,
    is_map: bool,
    wanted: Option<usize>,
    notes: &mut Vec<String>,
) -> Result<Layout, ScanReadError> {
    // A unit of length says more than a name of signals that may be lengths.
    let named: Vec<Option<Role>> = (0..columns.count)
        .map(|column| {
            let role = Role::of(&heads.of(column)?.name)?;
            (role != Role::Signal || heads.unit(column).is_none()).then_some(role)
        })
        .collect();
    // Columns of one name each with its number are those of a map.
    let are_alike = columns.count > 3 && named[0].is_some() && named.iter().all(|role| *role == named[0]);
    if are_alike && !heads.differ_in_units() {
        notes.push("the columns are named alike: they are taken for those of a map".to_owned());
        return Ok(Layout::Map);
    }
    if named.iter().any(Option::is_some) && !(is_map && !heads.differ_in_units() && columns.count > 3)
        || heads.differ_in_units() && columns.count > 2
    {
        return by_name(columns, heads, &named, wanted, notes).map(Layout::Table);
    }
    if is_map {
        return Ok(Layout::Map);
    }
    by_numbers(columns, wanted, notes)
}

/// Roles by names and units, what they leave open by the numbers.
fn by_name(
    columns: &Columns,
    heads: &Heads,
    named: &[Option<Role>],
    wanted: Option<usize>,
    notes: &mut Vec<String>,
) -> Result<Roles, ScanReadError> {
    let is_length = |column: &usize| heads.foreign(*column).is_none();
    let of = |role: Role| (0..columns.count).filter(move |column| named[*column] == Some(role));
    let (mut x, mut y) = (of(Role::X).next(), of(Role::Y).next());
    let mut heights: Vec<usize> = of(Role::Height).filter(is_length).collect();
    let mut open: Vec<usize> =
        (0..columns.count).filter(|column| named[*column].is_none()).filter(is_length).collect();
    let xs: Vec<usize> = of(Role::X).filter(is_length).collect();
    // Of `x y` the second is a height, as of `x y x y`; so it is of two positions.
    if heights.is_empty() && open.is_empty() {
        heights.extend(of(Role::Y).filter(is_length));
        y = None;
        if let ([_, second], true) = (&xs[..], heights.is_empty()) {
            heights.push(*second);
        }
    }
    let more_positions: Vec<usize> = match y {
        None => xs.iter().skip(1).copied().filter(|column| !heights.contains(column)).collect(),
        Some(_) => Vec::new(),
    };
    if x.is_none() && y.is_none() {
        let rising: Vec<usize> =
            open.iter().copied().filter(|column| is_monotone(columns, *column)).collect();
        let is_only = columns.count == 2 || rising.len() == 1;
        x = rising.first().copied().filter(|_| is_only && !(heights.is_empty() && open.len() == 1));
        open.retain(|column| Some(*column) != x);
        if let Some(x) = x {
            notes.push(format!("{} rises or falls throughout: it is taken for positions", heads.name(x)));
        }
    }
    // Of heights with units others have them, too; what counts is none.
    let has_units = heights.iter().any(|column| heads.unit(*column).is_some());
    let is_told = !heights.is_empty();
    let (more, unknown): (Vec<usize>, Vec<usize>) = open.into_iter().partition(|column| {
        !is_told || heads.unit(*column).is_some() || !has_units && !is_counting(columns, *column)
    });
    let names = |of: &[usize]| of.iter().map(|column| heads.name(*column)).collect::<Vec<_>>().join(", ");
    if is_told && more.iter().any(|column| heads.unit(*column).is_none()) {
        notes.push(format!(
            "what these columns hold is not known, they are listed as heights: {}",
            names(&more)
        ));
    }
    if !unknown.is_empty() {
        notes.push(format!("what these columns hold is not known, they are not read: {}", names(&unknown)));
    }
    heights.extend(more);
    // A map has positions along both axes; those of a line along one of them do not change.
    if let (Some(at_x), Some(at_y)) = (x, y) {
        if is_constant(columns, at_y) {
            y = None;
        } else if is_constant(columns, at_x) {
            (x, y) = (Some(at_y), None);
        }
    } else if x.is_none() {
        x = y.take();
    }
    heights.sort_unstable();
    if let Some(wanted) = wanted.filter(|wanted| heights.contains(wanted)) {
        heights.retain(|column| *column == wanted);
    }
    if heights.is_empty() {
        return Err(no_heights(columns, heads));
    }
    let signals = (0..columns.count)
        .filter(|column| !heights.contains(column) && ![x, y].contains(&Some(*column)))
        .filter(|column| !matches!(named[*column], Some(Role::Counter | Role::Validity | Role::Defect)))
        .filter(|column| heads.foreign(*column).is_some() || named[*column] == Some(Role::Signal))
        .collect();
    let mask = mask(columns, of(Role::Validity).next(), of(Role::Defect).next(), heads, notes);
    Ok(Roles { positions: [x, y], more_positions, mask, heights, signals })
}

/// The column that tells which heights count: a name such as `mask` does not say how, so what is rarer marks what does
/// not count.
fn mask(
    columns: &Columns,
    valid: Option<usize>,
    defect: Option<usize>,
    heads: &Heads,
    notes: &mut Vec<String>,
) -> Option<Mask> {
    if let Some(column) = valid {
        return Some(Mask { column, marks_valid: true });
    }
    let column = defect?;
    let all = columns.measured(column).flatten().count();
    let marked = columns.measured(column).flatten().filter(|mark| *mark != 0.0).count();
    let marks_valid = 2 * marked > all;
    let left_out = if marks_valid { all - marked } else { marked };
    notes.push(format!("{}: {left_out} of {all} points are left out as gaps", heads.name(column)));
    Some(Mask { column, marks_valid })
}

/// The error of a table without a column of heights: the first whose unit is no length, else the last.
fn no_heights(columns: &Columns, heads: &Heads) -> ScanReadError {
    let column =
        (0..columns.count).find(|column| heads.foreign(*column).is_some()).unwrap_or(columns.count - 1);
    let (line, unit) = heads.foreign(column).unwrap_or((columns.first_line, ""));
    ScanReadError::NoLength { line, column: column + 1, unit: unit.to_owned() }
}

/// Roles by the numbers alone.
fn by_numbers(
    columns: &Columns,
    wanted: Option<usize>,
    notes: &mut Vec<String>,
) -> Result<Layout, ScanReadError> {
    let (count, rows) = (columns.count, columns.measured(0).flatten().count());
    let rising: Vec<usize> = (0..count).filter(|column| is_monotone(columns, *column)).collect();
    let ask = || {
        Err(ScanReadError::AmbiguousColumns {
            line: columns.first_line,
            columns: rising.iter().map(|column| column + 1).collect(),
        })
    };
    let table = |position: usize, heights: Vec<usize>| {
        Ok(Layout::Table(Roles { positions: [Some(position), None], heights, ..Roles::default() }))
    };
    if let Some(wanted) = wanted {
        let before = rising.iter().rfind(|column| **column < wanted);
        let position = before.or_else(|| rising.iter().find(|column| **column != wanted)).copied();
        return table(position.unwrap_or(usize::from(wanted == 0)), vec![wanted]);
    }
    match count {
        2 if rows < TELLING || rising == [0] || rising.is_empty() => table(0, vec![1]),
        2 if rising == [1] => ask(),
        2 if rows >= SURE && is_even(columns, 0) && !is_even(columns, 1) => table(0, vec![1]),
        2 => ask(),
        3 if counts_points(columns) => {
            notes.push("the first column counts the points: the others are a profile".to_owned());
            table(1, vec![2])
        }
        3 if rows >= TELLING && rising.first() == Some(&0) => match rising.len() {
            _ if is_constant(columns, 1) => table(0, vec![2]),
            1 => several(0, count, notes),
            _ => ask(),
        },
        3 => Ok(Layout::Table(Roles { positions: [Some(0), Some(1)], heights: vec![2], ..Roles::default() })),
        // A map that is tilted rises in all its columns.
        _ if rows >= SURE && is_grid(columns) => {
            notes.push(
                "the first two columns are the places of points, each other one holds heights of them"
                    .to_owned(),
            );
            let heights = (2..count).collect();
            Ok(Layout::Table(Roles { positions: [Some(0), Some(1)], heights, ..Roles::default() }))
        }
        _ if rows < SURE || rising.is_empty() || rising.len() == count => Ok(Layout::Map),
        _ if count % 2 == 0 && rising == (0..count).step_by(2).collect::<Vec<_>>() => {
            notes.push(
                "every other column rises or falls throughout: it is taken for the positions of the next"
                    .to_owned(),
            );
            let heights = (1..count).step_by(2).collect();
            let more_positions = (2..count).step_by(2).collect();
            let positions = [Some(0), None];
            Ok(Layout::Table(Roles { positions, more_positions, heights, ..Roles::default() }))
        }
        _ if rising[0] == 0 && is_even(columns, 0) => several(0, count, notes),
        _ if rising.len() == 1 => ask(),
        _ => Ok(Layout::Map),
    }
}

/// A table of several profiles over the positions in one column.
fn several(position: usize, count: usize, notes: &mut Vec<String>) -> Result<Layout, ScanReadError> {
    notes.push(format!(
        "column {} rises or falls throughout: it is taken for positions, and each other column for heights",
        position + 1
    ));
    let heights = (0..count).filter(|column| *column != position).collect();
    Ok(Layout::Table(Roles { positions: [Some(position), None], heights, ..Roles::default() }))
}

/// Returns true if the first of three columns only counts the rows: it rises by one from row to row, and the second
/// rises or falls throughout as no coordinate of a map does.
fn counts_points(columns: &Columns) -> bool {
    let counter: Vec<f64> = columns.column(0).collect();
    columns.rows() >= TELLING
        && counter.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
        && is_monotone(columns, 1)
}
