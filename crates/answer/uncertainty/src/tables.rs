//! The results of draws as tables for scripts.

use study::interface::Slot;
use study::plan::Needs;
use tables::Table;

use crate::group::{Group, Index, Indices};
use crate::results::{
    Advice, AreaBand, AreaInterval, BandPoint, QuantityInterval, Step, StepKind, Uncertainty,
};

/// The largest standard error of a share that is reported.
pub const LARGEST_ERROR_OF_A_SHARE: f64 = 0.1;

/// The column of each group's share.
const SHARES: [(&str, Group); 5] = [
    ("share_scans", Group::Scans),
    ("share_instruments", Group::Instruments),
    ("share_material", Group::Material),
    ("share_strength", Group::Strength),
    ("share_holes", Group::Holes),
];

impl Uncertainty {
    /// The interval of a curve under a load.
    #[must_use]
    pub fn interval(&self, curve: usize, load: usize) -> Option<&AreaInterval> {
        self.areas.iter().find(|area| (area.curve, area.load) == (curve, load))
    }

    /// The interval of a quantity of the interface.
    #[must_use]
    pub fn quantity(&self, slot: Slot) -> Option<&QuantityInterval> {
        self.quantities.iter().find(|interval| interval.slot == slot)
    }

    /// The share of draws in which a seal is open under a load; `None` without a seal.
    #[must_use]
    pub fn share_open(&self, load: usize) -> Option<f64> {
        self.open_channels.iter().find(|channel| channel.load == load).map(|channel| channel.share)
    }

    /// The advice for a curve under a load.
    #[must_use]
    pub fn advice_for(&self, curve: usize, load: usize) -> Option<&Advice> {
        self.advice.iter().find(|advice| (advice.curve, advice.load) == (curve, load))
    }

    /// The indices of a group for an area; `None` where the group does not scatter or no shares were computed.
    #[must_use]
    pub fn indices_of(&self, area: &AreaInterval, group: Group) -> Option<Indices> {
        let at = self.groups.iter().position(|other| *other == group)?;
        area.indices.get(at).copied()
    }

    /// The share of the variance of ln A that a group carries alone: 0 if it is certain, `None` if the standard error
    /// exceeds [`LARGEST_ERROR_OF_A_SHARE`] or the area does not vary.
    #[must_use]
    pub fn share(&self, area: &AreaInterval, group: Group) -> Option<f64> {
        if !self.groups.contains(&group) {
            return Some(0.0);
        }
        let Index { value, standard_error } = self.indices_of(area, group)?.first_order;
        let is_known = area.ln_area_sd > 0.0 && standard_error <= LARGEST_ERROR_OF_A_SHARE;
        (is_known && value.is_finite()).then_some(value)
    }

    /// The share of interactions between groups, and of the errors of the shares. `None` if a share is unknown.
    #[must_use]
    pub fn share_of_others(&self, area: &AreaInterval) -> Option<f64> {
        SHARES.iter().try_fold(1.0, |left, (_, group)| Some(left - self.share(area, *group)?))
    }

    /// A row per curve and load: `curve, nominal_pressure_pa, area_fraction, median, low, high, level, monte_carlo_error,
    /// share_scans, share_instruments, share_material, share_strength, share_other`. Shares are first-order indices; those that
    /// are not known are empty.
    #[must_use]
    pub fn intervals_table(&self, needs: &Needs) -> Table {
        let found = |of: fn(&AreaInterval) -> f64| self.areas.iter().map(of);
        let table = of_loads(needs, self.areas.iter().map(|area| (area.curve, area.load)))
            .with_numbers("area_fraction", found(|area| area.area_fraction))
            .with_numbers("median", found(|area| area.median))
            .with_numbers("low", found(|area| area.low))
            .with_numbers("high", found(|area| area.high))
            .with_numbers("level", self.areas.iter().map(|_| self.settings.level))
            .with_numbers("monte_carlo_error", found(|area| area.monte_carlo_error));
        let with_share = |table: Table, (column, group): &(&str, Group)| {
            table.with_numbers(column, self.areas.iter().map(|area| self.share(area, *group)))
        };
        SHARES
            .iter()
            .fold(table, with_share)
            .with_numbers("share_other", self.areas.iter().map(|area| self.share_of_others(area)))
    }

    /// A row per curve, load and uncertain group: `curve, nominal_pressure_pa, group, first_order, first_order_error,
    /// total, total_error`. Indices have any standard error.
    #[must_use]
    pub fn indices_table(&self, needs: &Needs) -> Table {
        let rows: Vec<(&AreaInterval, Group, Indices)> = self
            .areas
            .iter()
            .flat_map(|area| {
                self.groups
                    .iter()
                    .filter_map(move |group| Some((area, *group, self.indices_of(area, *group)?)))
            })
            .collect();
        let found = |of: fn(&Indices) -> f64| rows.iter().map(move |(.., indices)| finite(of(indices)));
        of_loads(needs, rows.iter().map(|(area, ..)| (area.curve, area.load)))
            .with_words("group", rows.iter().map(|(_, group, _)| group.name()))
            .with_numbers("first_order", found(|indices| indices.first_order.value))
            .with_numbers("first_order_error", found(|indices| indices.first_order.standard_error))
            .with_numbers("total", found(|indices| indices.total.value))
            .with_numbers("total_error", found(|indices| indices.total.standard_error))
    }

    /// A row per followed curve, load and cutoff, from long to short: `curve, nominal_pressure_pa, wavelength_m, low, high`.
    #[must_use]
    pub fn bands_table(&self, needs: &Needs) -> Table {
        let rows: Vec<(&AreaBand, &BandPoint)> =
            self.bands.iter().flat_map(|band| band.points.iter().map(move |point| (band, point))).collect();
        let found = |of: fn(&BandPoint) -> f64| rows.iter().map(move |(_, point)| of(point));
        of_loads(needs, rows.iter().map(|(band, _)| (band.curve, band.load)))
            .with_numbers("wavelength_m", found(|point| point.wavelength_m))
            .with_numbers("area_fraction", found(|point| point.area_fraction))
            .with_numbers("median", found(|point| point.median))
            .with_numbers("low", found(|point| point.low))
            .with_numbers("high", found(|point| point.high))
    }

    /// A row per curve, load and step, the best first: `curve, nominal_pressure_pa, rank, step, instrument,
    /// added_scans, wavelength_m, width_ratio, area_ratio`. Cells that do not apply are empty.
    #[must_use]
    pub fn advice_table(&self, needs: &Needs) -> Table {
        let rows: Vec<(&Advice, usize, &Step)> = self
            .advice
            .iter()
            .flat_map(|advice| advice.steps.iter().enumerate().map(move |(at, step)| (advice, at + 1, step)))
            .collect();
        let instrument = |kind: &StepKind| {
            let named = kind.instrument().and_then(|instrument| self.instruments.get(instrument));
            named.map_or_else(String::new, |instrument| instrument.name.text().to_owned())
        };
        of_loads(needs, rows.iter().map(|(advice, ..)| (advice.curve, advice.load)))
            .with_numbers("rank", rows.iter().map(|(_, rank, _)| *rank as f64))
            .with_words("step", rows.iter().map(|(.., step)| step.kind.key()))
            .with_text("instrument", rows.iter().map(|(.., step)| instrument(&step.kind)))
            .with_numbers(
                "added_scans",
                rows.iter().map(|(.., step)| step.kind.added_scans().map(|added| added as f64)),
            )
            .with_numbers("wavelength_m", rows.iter().map(|(.., step)| step.kind.wavelength_m()))
            .with_numbers("width_ratio", rows.iter().map(|(.., step)| step.width_ratio))
            .with_numbers("area_ratio", rows.iter().map(|(.., step)| step.area_ratio))
    }
}

/// The first columns of every table: the curve and the load of each row.
fn of_loads(needs: &Needs, rows: impl Iterator<Item = (usize, usize)> + Clone) -> Table {
    Table::default()
        .with_text("curve", rows.clone().map(|(curve, _)| needs.curves[curve].name.clone()))
        .with_numbers("nominal_pressure_pa", rows.map(|(_, load)| needs.loads[load].nominal_pressure_pa()))
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
