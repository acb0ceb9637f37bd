//! The paper's statements on the area over cutoff and load: rows 4, 6, 7, 8, 10, 19 and 20.

use findings::features::{
    Convergence, Dip, Plateau, Point, between, convergence, dips, log_slope, widest_plateau,
};
use stacked_contact::largest_full_contact_pressure_pa;
use stat_contact::ContactState;
use units::display::{length, three_digits};

use super::spectrum::PRINTED_WAVELENGTH_M;
use super::{LEVEL, VISIBLE, final_slopes, furthest_from_one, highest, lengths, lowest, numbers};
use crate::evidence::{ALL, ELASTIC, Evidence, HERTZ, PLASTIC, SINE, SINE_ELASTIC, SPHERE, is_carried};
use crate::ledger::{Finding, Statement, verdict};

pub(super) const STACK_CONVERGES: Statement = Statement {
    number: 4,
    statement: "The stacked area converges near 5.65 nm, at the same wavelength for every load, elastic or not.",
    how: "Convergence wavelength at 1 % and 0.1 % of both stacked models under every load. Reproduced if those at 1 % mean \
              convergence, lie within a factor of 2 of 5.65 nm, and do not depend on the load.",
    unit: "m, elastic-plastic at 1 %",
    check: |evidence| {
        let at = |name, tolerance| converged(&evidence.areas(name), tolerance);
        let (elastic, plastic) = (at(ELASTIC, 0.01), at(PLASTIC, 0.01));
        let both = || elastic.iter().chain(&plastic);
        let certain = both().all(|found| found.converged);
        let near = both().all(|found| (found.wavelength_m / PRINTED_WAVELENGTH_M).log2().abs() <= 1.0);
        let same = [&elastic, &plastic].iter().all(|found| found.windows(2).all(|two| two[0] == two[1]));
        let list = |found: &[Convergence]| lengths(found.iter().map(|found| found.wavelength_m));
        Finding::new(
            plastic[0].wavelength_m,
            format!(
                "elastic {} (1 %) and {} (0.1 %), elastic-plastic {} and {}; the spectrum ends at {}",
                list(&elastic),
                list(&at(ELASTIC, 0.001)),
                list(&plastic),
                list(&at(PLASTIC, 0.001)),
                length(evidence.shortest_m())
            ),
            verdict(certain && near && same),
            match (certain, near && same) {
                (true, true) => {
                    "It converges there under every load; the two models differ by a sample or two, and both wavelengths follow \
                     the largest aspect ratio."
                }
                (true, false) => "It converges, but elsewhere or not at one wavelength for every load.",
                (false, _) => {
                    "Less than half a decade of this spectrum lies below these wavelengths, so it cannot show convergence."
                }
            }
            .to_owned(),
        )
    },
};

pub(super) const PROPORTIONAL_TO_LOAD: Statement = Statement {
    number: 6,
    statement: "The contact area is proportional to the load.",
    how: "Exponent of area against load at the last cutoff, by least squares over the four loads, for every model. \
              Reproduced if all lie within 0.05 of 1.",
    unit: "exponent furthest from 1",
    check: |evidence| {
        let exponent = |name| log_slope(&evidence.final_areas(name)).unwrap_or(f64::NAN);
        let exponents: Vec<f64> = ALL.iter().map(|name| exponent(*name)).collect();
        let off: Vec<String> = ALL
            .iter()
            .zip(&exponents)
            .filter(|(_, exponent)| (*exponent - 1.0).abs() > 0.05)
            .map(|(name, exponent)| format!("{} ({})", name.0, three_digits(*exponent)))
            .collect();
        let holds = exponents.iter().all(|exponent| (exponent - 1.0).abs() <= 0.05);
        Finding::new(
            furthest_from_one(&exponents),
            format!(
                "exponents {} over nine models; {} for the stacked elastic-plastic one",
                numbers(exponents),
                three_digits(exponent(PLASTIC))
            ),
            verdict(holds),
            if holds {
                "Every model is proportional within a few per cent over three decades of load.".to_owned()
            } else {
                format!("All models are proportional but {}.", off.join(", "))
            },
        )
    },
};

pub(super) const ELASTIC_DECADES: Statement = Statement {
    number: 7,
    statement: "The elastic statistical area falls by about one decade when the cutoff falls by two.",
    how: "Decades between the Hertz areas at 100 times and once the shortest wavelength, at every load of figure 5 whose area \
              is below a tenth at both. Reproduced if the median lies between 0.75 and 1.25.",
    unit: "decades of area",
    check: |evidence| {
        let sweeps = evidence.sweeps(HERTZ);
        let at = |multiple: f64| {
            sweeps.iter().find(|(known, ..)| *known == multiple).map(|(_, _, states)| *states)
        };
        let (Some(long), Some(short)) = (at(100.0), at(1.0)) else {
            unreachable!("figure 5 has these cutoffs");
        };
        let light = |(long, short): &(&ContactState, &ContactState)| {
            long.area_fraction.max(short.area_fraction) < 0.1
        };
        let pairs = long.iter().zip(short).filter(light);
        let mut decades: Vec<f64> = pairs.map(|(l, s)| (l.area_fraction / s.area_fraction).log10()).collect();
        decades.sort_by(f64::total_cmp);
        let median = decades.get(decades.len() / 2).copied().unwrap_or(f64::NAN);
        let holds = (0.75..=1.25).contains(&median);
        Finding::new(
            median,
            format!(
                "{} decades in the median of {} loads, {} over all of them",
                three_digits(median),
                decades.len(),
                numbers(decades.iter().copied())
            ),
            verdict(holds),
            if holds {
                "With a Hurst exponent near one half the slope grows as the root of the wavevector, and the area falls with it."
            } else {
                "The fall follows the growth of the slope with the cutoff, which is another one in this spectrum."
            }
            .to_owned(),
        )
    },
};

pub(super) const SPHERES_LEVEL_OFF: Statement = Statement {
    number: 8,
    statement: "The elastic-plastic sphere model gives nearly one curve of area against load for cutoffs at 1, 10 and 100 \
                    times the shortest wavelength; against cutoff it dips near 1 um, is level from about 100 nm and falls again \
                    in the last decade.",
    how: "Largest ratio of areas between the three cutoffs at one load; dips of 10 % or more; widest stretch below the dip that is level within a \
              factor of 1.2; exponent of area against cutoff over the last decade. Reproduced if the ratio is below 2, a dip \
              lies at 0.3 to 3 um, the level stretch begins at 30 to 300 nm, and the last exponent is above 0.1.",
    unit: "largest ratio between cutoffs",
    check: |evidence| {
        let spread = spread(evidence);
        let curves = evidence.areas(SPHERE);
        let Shape { dips, plateaus, slopes } = Shape::new(&curves);
        let one_curve = spread < 2.0;
        let dips_there = dips.iter().flatten().any(|dip| (0.3e-6..=3e-6).contains(&dip.wavelength_m));
        let level = !curves.is_empty()
            && plateaus.len() == curves.len()
            && plateaus
                .iter()
                .all(|plateau| plateau.decades() >= 0.5 && (30e-9..=300e-9).contains(&plateau.longest_m));
        let falls = lowest(slopes.iter().copied()) > 0.1;
        let parts = [
            (one_curve, "one curve against load"),
            (dips_there, "the dip near 1 um"),
            (level, "the level part from about 100 nm"),
            (falls, "the last fall"),
        ];
        Finding::of_parts(
            spread,
            format!(
                "areas differ up to {} times between the cutoffs; {}; level from {} down to {}; last exponent {}",
                three_digits(spread),
                describe_dips(&dips),
                lengths(plateaus.iter().map(|plateau| plateau.longest_m)),
                lengths(plateaus.iter().map(|plateau| plateau.shortest_m)),
                numbers(slopes)
            ),
            &parts,
        )
    },
};

pub(super) const NEVER_LEVEL: Statement = Statement {
    number: 10,
    statement: "The elastic and the sinusoidal statistical models never level off.",
    how: "Exponent of area against cutoff over the last decade for hertz, elastic-sine and ep-sine at every load. Reproduced \
              if all are above 0.1.",
    unit: "smallest exponent",
    check: |evidence| {
        let slopes = |name| final_slopes(&evidence.areas(name));
        let all = [HERTZ, SINE_ELASTIC, SINE].map(slopes);
        let least = lowest(all.iter().flatten().copied());
        Finding::new(
            least,
            format!(
                "hertz {}, elastic-sine {}, ep-sine {}",
                numbers(all[0].iter().copied()),
                numbers(all[1].iter().copied()),
                numbers(all[2].iter().copied())
            ),
            verdict(least > 0.1),
            if least > 0.1 {
                "All three still fall at the shortest wavelength, so what they give there is the end of the data."
            } else {
                "One of them is all but level over the last decade."
            }
            .to_owned(),
        )
    },
};

pub(super) const STEEPEST_SCALE_DECIDES: Statement = Statement {
    number: 19,
    statement: "The scale of the largest aspect ratio is the scale of convergence, and the area is close to the load over the \
                    largest full-contact pressure.",
    how: "Wavelength of the largest B over the elastic convergence wavelength at 1 %; elastic area over load / max p*. \
              Reproduced if the former lies within a factor of 1.5 of 1, the latter within 5 %, and the area has converged.",
    unit: "elastic area over load / max p*",
    check: |evidence| {
        let curve = evidence.aspect_ratios();
        let &(steepest_m, _) = curve.iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("scales");
        let found = converged(&evidence.areas(ELASTIC), 0.01);
        let (model, _) = evidence.stack(ELASTIC);
        let scales = evidence.results.scales.iter().copied();
        let limit_pa = largest_full_contact_pressure_pa(&model, scales).unwrap_or(f64::NAN);
        let shares: Vec<f64> = evidence
            .final_areas(ELASTIC)
            .into_iter()
            .map(|(load_pa, area)| area * limit_pa / load_pa)
            .collect();
        let together = found.iter().all(|found| (steepest_m / found.wavelength_m).ln().abs() <= 1.5f64.ln());
        let certain = found.iter().all(|found| found.converged);
        let close = shares.iter().all(|share| (share - 1.0).abs() <= 0.05);
        Finding::new(
            furthest_from_one(&shares),
            format!(
                "steepest scale {}, convergence {}; area {} times load / max p*",
                length(steepest_m),
                lengths(found.iter().map(|found| found.wavelength_m)),
                numbers(shares.iter().copied())
            ),
            verdict(together && certain && close),
            match (together && close, certain) {
                (true, true) => "Both hold: Jackson's limit of dense sampling is reached within the sampling's own effect.",
                (true, false) => "Both hold, but the spectrum ends too soon below that scale to speak of convergence.",
                (false, _) => "The steepest scale and the convergence of the area, or its limit, lie apart in this spectrum.",
            }
            .to_owned(),
        )
    },
};

pub(super) const LAST_FALL: Statement = Statement {
    number: 20,
    statement: "The last fall of the elastic-plastic sphere model stays above its dip near 1 um, and its convergence does not \
                    depend on load.",
    how: "Last area over the area of the lowest dip at every load; convergence wavelength at 1 % at every load. Reproduced if \
              there is a dip, every ratio is above 1, and the wavelengths are one.",
    unit: "smallest ratio of last area to dip",
    check: |evidence| {
        let curves = evidence.areas(SPHERE);
        let Shape { dips, .. } = Shape::new(&curves);
        let ratio = |(curve, dips): (&Vec<Point>, &Vec<Dip>)| {
            let lowest = dips.iter().map(|dip| dip.value).reduce(f64::min)?;
            Some(curve.last()?.1 / lowest)
        };
        let ratios: Vec<Option<f64>> = curves.iter().zip(&dips).map(ratio).collect();
        let known: Vec<f64> = ratios.iter().copied().flatten().collect();
        let above =
            !known.is_empty() && known.len() == ratios.len() && known.iter().all(|ratio| *ratio > 1.0);
        let found = converged(&curves, 0.01);
        let same = found.windows(2).all(|two| two[0] == two[1]);
        let certain = found.iter().all(|found| found.converged);
        let parts = [
            (above, "the last area above the dip"),
            (same && certain, "one wavelength of convergence for every load"),
        ];
        // Without a dip, compare with the lowest area of the curve.
        let value = if known.is_empty() {
            lowest(curves.iter().filter_map(|curve| {
                Some(curve.last()?.1 / curve.iter().map(|(_, area)| *area).reduce(f64::min)?)
            }))
        } else {
            lowest(known.iter().copied())
        };
        Finding::of_parts(
            value,
            format!(
                "{}; last area over the lowest dip {}; within 1 % from {} on{}",
                describe_dips(&dips),
                if known.is_empty() { "absent".to_owned() } else { numbers(known) },
                lengths(found.iter().map(|found| found.wavelength_m)),
                if certain { "" } else { ", which is the end of the spectrum and no convergence" }
            ),
            &parts,
        )
    },
};

/// Shape of a family of curves, one entry per load.
struct Shape {
    dips: Vec<Vec<Dip>>,
    plateaus: Vec<Plateau>,
    slopes: Vec<f64>,
}

impl Shape {
    fn new(curves: &[Vec<Point>]) -> Self {
        Shape {
            dips: curves.iter().map(|curve| dips(curve, VISIBLE)).collect(),
            plateaus: curves.iter().filter_map(|curve| level_part(curve)).collect(),
            slopes: final_slopes(curves),
        }
    }
}

/// Widest level stretch below the last dip, and below complete contact, which is level for another reason.
pub(super) fn level_part(curve: &[Point]) -> Option<Plateau> {
    let open = curve.partition_point(|(_, area)| *area >= 1.0);
    let last_dip = dips(curve, VISIBLE).pop();
    let below_dip = last_dip
        .map_or(0, |dip| curve.partition_point(|(wavelength_m, _)| *wavelength_m >= dip.wavelength_m));
    widest_plateau(&curve[open.max(below_dip)..], LEVEL)
}

pub(super) fn converged(curves: &[Vec<Point>], tolerance: f64) -> Vec<Convergence> {
    curves.iter().filter_map(|curve| convergence(curve, tolerance)).collect()
}

/// Largest ratio of areas between the cutoffs of figure 5, over all its loads.
fn spread(evidence: &Evidence) -> f64 {
    let sweeps = evidence.sweeps(SPHERE);
    let loads = sweeps.iter().map(|(_, _, states)| states.len()).min().unwrap_or(0);
    let carried = |load: &usize| sweeps.iter().all(|(_, _, states)| is_carried(&states[*load]));
    let ratio = |load: usize| {
        let areas = || sweeps.iter().map(|(_, _, states)| states[load].area_fraction);
        highest(areas()) / lowest(areas())
    };
    highest((0..loads).filter(carried).map(ratio))
}

fn describe_dips(dips: &[Vec<Dip>]) -> String {
    let all = || dips.iter().flatten();
    if all().next().is_none() {
        return "no dip of 10 %".to_owned();
    }
    let loads = dips.iter().filter(|dips| !dips.is_empty()).count();
    format!(
        "dips at {} ({} deep) under {loads} of {} loads",
        lengths(all().map(|dip| dip.wavelength_m)),
        numbers(all().map(|dip| dip.depth)),
        dips.len()
    )
}

/// Part of a curve below a wavelength, and its slope.
pub(super) fn slope_below(curve: &[Point], longest_m: f64) -> Option<f64> {
    let (shortest_m, _) = *curve.last()?;
    log_slope(between(curve, longest_m, shortest_m))
}
