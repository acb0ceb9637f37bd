//! Tables and figures of `docs/guide/nature.md`, from the committed tables.

use std::collections::BTreeMap;

use elements::SpecimenCompliance;
use study::figure::{Axis, BandKind, FigureBand, FigureData, Mark, Series, Shows};
use tables::markdown::{table, with_section};
use units::display::{percent, three_digits};

use crate::NatureError;
use crate::joint::{JointRow, Seat};
use crate::table::{ResistanceRow, exponents, percentile};

/// Modulus of the columns by seat and compliance \[GPa\].
const MIDDLE_GPA: f64 = 11.0;
/// Nominal pressure from which ranges of what rows state are counted \[MPa\].
const HEAVY_MPA: f64 = 1.0;
/// Factor between the abscissas of rows under one pressure, which would hide each other.
const SPREAD: f64 = 1.012;

/// States of the gas between the faces, up to 10 Pa, up to 50 kPa, and above.
const GAS_STATES: [&str; 3] = ["vacuum", "rarefied", "1 atm"];

/// Index of the state of the gas.
fn gas_state(row: &ResistanceRow) -> usize {
    [10.0, 5e4].into_iter().filter(|bound_pa| row.gas_pressure_pa > *bound_pa).count()
}

/// Groups of rows of one pair under one state of the gas, by name.
fn groups(rows: &[ResistanceRow]) -> BTreeMap<String, Vec<&ResistanceRow>> {
    let mut groups: BTreeMap<String, Vec<&ResistanceRow>> = BTreeMap::new();
    for row in rows {
        groups.entry(format!("{}, {}", row.pair, GAS_STATES[gas_state(row)])).or_default().push(row);
    }
    groups
}

/// Rewrites the tables of the page.
///
/// # Errors
/// [`NatureError::Page`] if the page lacks a section.
pub fn written(page: &str, rows: &[ResistanceRow], joints: &[JointRow]) -> Result<String, NatureError> {
    sections(rows, joints)
        .into_iter()
        .try_fold(page.to_owned(), |page, (name, contents)| with_section(&page, name, &contents))
        .map_err(NatureError::Page)
}

/// Names and contents of the sections that both tables make; an empty table makes none.
#[must_use]
pub fn sections(rows: &[ResistanceRow], joints: &[JointRow]) -> Vec<(&'static str, String)> {
    let of_resistances = || {
        let shares = format!("{}\n{}", shares(rows), summary(rows));
        [("resistances", shares), ("exponents", exponents_by_pair(rows))]
    };
    let resistances = (!rows.is_empty()).then(of_resistances).into_iter().flatten();
    let joints = (!joints.is_empty()).then(|| ("joints", joints_by_load(joints)));
    resistances.chain(joints).collect()
}

fn median(values: impl Iterator<Item = f64>) -> String {
    percentile(values, 0.5).map_or_else(String::new, three_digits)
}

/// A row for each pair and state of the gas.
fn shares(rows: &[ResistanceRow]) -> String {
    let cells = groups(rows).into_iter().map(|(name, rows)| {
        let over = || rows.iter().map(|row| row.measured / row.predicted);
        vec![
            name,
            format!("{} of {}", rows.iter().filter(|row| row.is_inside()).count(), rows.len()),
            median(over()),
            median(rows.iter().map(|row| row.stated_width())),
            median(rows.iter().map(|row| row.width())),
        ]
    });
    let columns = ["pair, gas", "inside", "measured/predicted", "high/low, stated", "high/low, all"];
    table(&columns, &cells.collect::<Vec<_>>())
}

/// Numbers over all rows, in a sentence.
fn summary(rows: &[ResistanceRow]) -> String {
    let inside = rows.iter().filter(|row| row.is_inside()).count();
    let widest = percentile(rows.iter().map(ResistanceRow::width), 0.9).unwrap_or_default();
    let heavy = rows.iter().filter(|row| row.pressure_mpa >= HEAVY_MPA).map(ResistanceRow::stated_width);
    let by_limit = |limit: fn(&ResistanceRow) -> f64| {
        let over = || rows.iter().map(|row| row.measured / limit(row));
        let near = over().filter(|ratio| (0.5..=2.0).contains(ratio)).count();
        format!("{} in the median, within a factor of 2 in {near} rows", median(over()))
    };
    format!(
        "{inside} of {} rows ({}) lie inside. High over low is at most {} in nine of ten rows; from {HEAVY_MPA} MPa up, what the \
         rows state leaves at most a factor of {}. Measured over predicted by the cap alone is {}; by the long wave, {}.",
        rows.len(),
        percent(inside as f64 / rows.len() as f64),
        three_digits(widest),
        three_digits(heavy.fold(1.0, f64::max)),
        by_limit(|row| row.cap),
        by_limit(|row| row.long_wave)
    )
}

fn exponents_by_pair(rows: &[ResistanceRow]) -> String {
    let cells = groups(rows).into_iter().filter_map(|(name, rows)| {
        let found = exponents(rows.into_iter())?;
        Some([vec![name], found.map(|n| format!("{n:.2}")).to_vec()].concat())
    });
    let columns = ["pair, gas", "measured", "computed", "without gas", "long wave", "cap"];
    table(&columns, &cells.collect::<Vec<_>>())
}

/// Joints in the order of the table, each with its pressures.
fn loads(joints: &[JointRow]) -> Vec<(&str, f64)> {
    let mut loads: Vec<(&str, f64)> = Vec::new();
    for row in joints {
        if !loads.contains(&(row.joint.as_str(), row.pressure_mpa)) {
            loads.push((&row.joint, row.pressure_mpa));
        }
    }
    loads
}

/// Least and largest of a quantity of a joint under a load.
fn ends(joints: &[JointRow], load: (&str, f64), of: fn(&JointRow) -> f64) -> [f64; 2] {
    let chosen = joints.iter().filter(|row| (row.joint.as_str(), row.pressure_mpa) == load).map(of);
    chosen.fold([f64::INFINITY, 0.0], |[least, most], it| [least.min(it), most.max(it)])
}

fn joints_by_load(joints: &[JointRow]) -> String {
    let over = |row: &JointRow| row.stiffness_pa_per_m / row.measured_pa_per_m;
    let cells = loads(joints).into_iter().map(|(joint, pressure_mpa)| {
        let load = (joint, pressure_mpa);
        let of = |seat: Seat, compliance: SpecimenCompliance| {
            let is_it = |row: &&JointRow| {
                (row.joint.as_str(), row.pressure_mpa) == load
                    && (row.seat, row.compliance) == (seat, compliance)
                    && row.youngs_modulus_gpa == MIDDLE_GPA
            };
            joints.iter().find(is_it).map_or_else(String::new, |row| format!("{:.2}", over(row)))
        };
        let [least, most] = ends(joints, load, over);
        vec![
            format!("{joint}, {pressure_mpa:.2}"),
            of(Seat::Published, SpecimenCompliance::Punch),
            of(Seat::Published, SpecimenCompliance::Even),
            of(Seat::Levelled, SpecimenCompliance::Punch),
            of(Seat::Levelled, SpecimenCompliance::Even),
            format!("{least:.2}–{most:.2}"),
        ]
    });
    let columns =
        ["joint, MPa", "published, punch", "published, even", "levelled, punch", "levelled, even", "range"];
    table(&columns, &cells.collect::<Vec<_>>())
}

/// Draws measured over predicted conductance by pressure. A bar is the measured value over the ends of the range: it crosses 1 where
/// the value lies inside.
#[must_use]
pub fn resistances_figure(rows: &[ResistanceRow]) -> FigureData {
    let mark = |(at, row): (usize, &ResistanceRow)| {
        let earlier = rows[..at].iter().filter(|other| other.pressure_mpa == row.pressure_mpa).count();
        let all = rows.iter().filter(|other| other.pressure_mpa == row.pressure_mpa).count();
        let is_alike = row.pair == "al6061-al6061";
        let label = if is_alike { "aluminium on itself" } else { "other pairs" };
        Mark {
            label: label.to_owned(),
            column: label.to_owned(),
            is_ring: !is_alike,
            condition_index: Some(gas_state(row)),
            x: row.pressure_mpa * SPREAD.powf(earlier as f64 - 0.5 * (all - 1) as f64),
            y: row.measured / row.predicted,
            low: row.measured / row.high,
            high: row.measured / row.low,
        }
    };
    let named = |(at, state): (usize, &&str)| Series::under(&format!("gas: {state}"), at, Vec::new());
    let one = Series::alone("one", vec![(0.06, 1.0), (2.0, 1.0)]);
    let series = GAS_STATES.iter().enumerate().map(named).chain([one]).collect();
    let x = Axis { column: "x", label: "nominal pressure (MPa)" };
    FigureData {
        title: "Thermal resistances of bare joints".to_owned(),
        marks: rows.iter().enumerate().map(mark).collect(),
        ..FigureData::new(
            "nature-resistances",
            Shows::Response,
            x,
            "measured over predicted conductance",
            series,
        )
    }
}

/// Draws the stiffness of joints by load: the measured one as a line, the range of the computed ones as a band.
#[must_use]
pub fn joints_figure(joints: &[JointRow]) -> FigureData {
    let mut names: Vec<&str> = joints.iter().map(|row| row.joint.as_str()).collect();
    names.dedup();
    let (mut series, mut bands) = (Vec::new(), Vec::new());
    for (at, name) in names.into_iter().enumerate() {
        let of_joint = || loads(joints).into_iter().filter(move |(joint, _)| *joint == name);
        let measured = |load: (&str, f64)| (load.1, ends(joints, load, |row| row.measured_pa_per_m)[0]);
        let computed = |load: (&str, f64)| (load.1, ends(joints, load, |row| row.stiffness_pa_per_m));
        series.push(Series::under(&format!("{name}, measured"), at, of_joint().map(measured).collect()));
        bands.push(FigureBand {
            label: "computed, all choices".to_owned(),
            kind: BandKind::Interval,
            load: Some(at),
            curve_index: 0,
            points: of_joint().map(computed).collect(),
        });
    }
    let x = Axis { column: "x", label: "mean normal stress (MPa)" };
    FigureData {
        title: "Stiffness of two rock joints".to_owned(),
        bands,
        ..FigureData::new("nature-joints", Shows::Response, x, "stiffness (Pa/m)", series)
    }
}
