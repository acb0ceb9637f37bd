//! The paper's statements on the spectrum: rows 1, 2, 3 and 14.

use std::f64::consts::TAU;

use findings::features::{between, log_slope, log_slopes};
use spectrum::{Convention, Moments, Normalisation, Psd, cumulative_moments};
use units::display::{length, three_digits};

use super::numbers;
use crate::ledger::{Finding, Statement, Verdict, verdict};

/// Largest aspect ratio as printed, and its wavelength.
pub(super) const PRINTED_ASPECT_RATIO: f64 = 0.0463;
pub(super) const PRINTED_WAVELENGTH_M: f64 = 5.65e-9;

pub(super) const LARGEST_ASPECT_RATIO: Statement = Statement {
    number: 1,
    statement: "The largest aspect ratio is 0.0463, at a wavelength of 5.65 nm.",
    how: "Largest B of the amplitude spectrum (Eq. 5). Reproduced if B agrees to the printed digits and the wavelength \
              within a tenth of a decade.",
    unit: "",
    check: |evidence| {
        let curve = evidence.aspect_ratios();
        let &(wavelength_m, largest) = curve.iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("scales");
        let near = (wavelength_m / PRINTED_WAVELENGTH_M).log10().abs() <= 0.1;
        let agrees = near && (largest - PRINTED_ASPECT_RATIO).abs() <= 0.00005;
        Finding::new(
            largest,
            format!("B = {largest:.4} at {}", length(wavelength_m)),
            if evidence.is_reconstruction() { Verdict::ByConstruction } else { verdict(agrees) },
            if evidence.is_reconstruction() {
                "The reconstruction is pinned to these two numbers, so their return tests nothing.".to_owned()
            } else if wavelength_m == evidence.shortest_m() {
                "B still grows at the end of this spectrum, so its largest value is not in it.".to_owned()
            } else {
                format!(
                    "The composite of the real scans has its steepest scale {} times as long, with {} of the printed B.",
                    three_digits(wavelength_m / PRINTED_WAVELENGTH_M),
                    three_digits(largest / PRINTED_ASPECT_RATIO)
                )
            },
        )
    },
};

pub(super) const COURSE_OF_ASPECT_RATIO: Statement = Statement {
    number: 2,
    statement: "The aspect ratio is nearly constant below about 10 nm and a straight slope above.",
    how: "Exponent of B against wavelength by least squares below 10 nm, and above it with the rms distance from the \
              straight line. Reproduced if the former lies within 0.15 of 0 and the latter is below 0.1 decade.",
    unit: "exponent below 10 nm",
    check: |evidence| {
        let curve = evidence.aspect_ratios();
        let below = between(&curve, 10e-9, evidence.shortest_m());
        let above = between(&curve, f64::INFINITY, 10e-9);
        let (level, slope) = (log_slope(below).unwrap_or(f64::NAN), log_slope(above).unwrap_or(f64::NAN));
        let offsets: Vec<f64> = above.iter().map(|(x, y)| y.log10() - slope * x.log10()).collect();
        let mean = offsets.iter().sum::<f64>() / offsets.len() as f64;
        let rms = (offsets.iter().map(|o| (o - mean).powi(2)).sum::<f64>() / offsets.len() as f64).sqrt();
        let (constant, straight) = (level.abs() <= 0.15, rms <= 0.1);
        let local = numbers(log_slopes(above).into_iter().map(|(_, slope)| slope));
        Finding::new(
            level,
            format!(
                "exponent {} below 10 nm; {} above, rms {} decades off the line, local exponents {local}",
                three_digits(level),
                three_digits(slope),
                three_digits(rms)
            ),
            verdict(constant && straight),
            match (constant, straight) {
                (true, true) => "Level below and straight above, as stated.",
                (true, false) => {
                    "Level below 10 nm as stated; above it the slope changes with the wavelength, so no single straight line \
                     describes it."
                }
                (false, true) => "Straight above 10 nm as stated, but not level below it.",
                (false, false) => "Neither level below 10 nm nor one straight line above it.",
            }
            .to_owned(),
        )
    },
};

pub(super) const MOMENTS: Statement = Statement {
    number: 3,
    statement: "Of the spectral moments m0 changes least with the cutoff; m2 and m4 change by many orders of magnitude.",
    how: "Orders of magnitude of each moment between the second and the last wavelength. Reproduced if they rise from m0 to \
              m4, and m2 and m4 change by more than three.",
    unit: "orders of magnitude of m4",
    check: |evidence| {
        let moments: Vec<Moments> = evidence.results.moments.iter().map(|(moments, _)| *moments).collect();
        let (first, last) = (moments[0], moments[moments.len() - 1]);
        let orders = |of: fn(&Moments) -> f64| (of(&last) / of(&first)).log10();
        let (m0, m2, m4) = (orders(|m| m.m0_m2), orders(|m| m.m2), orders(|m| m.m4_per_m2));
        let holds = m0 < m2 && m2 < m4 && m2 > 3.0;
        Finding::new(
            m4,
            format!(
                "m0 changes by {}, m2 by {} and m4 by {} orders of magnitude",
                three_digits(m0),
                three_digits(m2),
                three_digits(m4)
            ),
            verdict(holds),
            if holds {
                "The order is that of the powers of q, whatever self-affine spectrum is taken.".to_owned()
            } else {
                "The order is as stated, but this spectrum is too short for three orders of m2.".to_owned()
            },
        )
    },
};

pub(super) const SLOPE: Statement = Statement {
    number: 14,
    statement: "The average slope, published before for the same surface, is 50 degrees.",
    how: "arctan of sqrt(m2) at the last cutoff, with m2 over pi (Parseval) and as Eq. (1) is printed. Reproduced if the \
              former lies within 5 degrees and is the nearer one.",
    unit: "degrees",
    check: |evidence| {
        let (own, printed) = slopes_degrees(evidence.results.moments.last().map_or(0.0, |(m, _)| m.m2));
        let mut found = format!(
            "{} with 1/pi, {} as printed, down to {}",
            three_digits(own),
            three_digits(printed),
            length(evidence.shortest_m())
        );
        if evidence.is_reconstruction() {
            let (own, printed) = slopes_degrees(closed_form_m2());
            found += &format!(
                "; {} and {} for its closed form down to 0.1 nm",
                three_digits(own),
                three_digits(printed)
            );
        }
        let agrees = (own - 50.0).abs() <= 5.0 && (own - 50.0).abs() < (printed - 50.0).abs();
        Finding::new(
            own,
            found,
            verdict(agrees),
            if agrees {
                "The factor 1/pi, which Parseval's theorem asks for, keeps the published slope; Eq. (1) as printed does not."
            } else {
                "This spectrum ends before the scales that make the slope; the factor of Eq. (1) cannot be told from it."
            }
            .to_owned(),
        )
    },
};

/// Slopes for m2 over pi and as printed.
fn slopes_degrees(m2: f64) -> (f64, f64) {
    (m2.sqrt().atan().to_degrees(), (std::f64::consts::PI * m2).sqrt().atan().to_degrees())
}

/// m2 of the five-parameter form behind the reconstruction (written in its file), from its longest wavelength to 0.1
/// nm, sampled so densely that the power law between samples is exact to four digits.
fn closed_form_m2() -> f64 {
    const C0_M3: f64 = 1.215386e-22;
    const Q1_RAD_PER_M: f64 = 3.592462e6;
    const A: f64 = 1.90737;
    const Q2_RAD_PER_M: f64 = 4.120091e8;
    const B: f64 = 1.24263;
    const LONGEST_M: f64 = 8.954647e-3;
    const PER_DECADE: i32 = 100;
    let decades = (LONGEST_M / 1e-10).log10();
    let steps = (f64::from(PER_DECADE) * decades).ceil() as i32;
    let wavelengths_m: Vec<f64> =
        (0..=steps).map(|i| LONGEST_M * 10f64.powf(-decades * f64::from(i) / f64::from(steps))).collect();
    let c1d_m3 = |wavelength_m: &f64| {
        let q = TAU / wavelength_m;
        C0_M3
            * (1.0 + (q / Q1_RAD_PER_M).powi(2)).powf(-A / 2.0)
            * (1.0 + (q / Q2_RAD_PER_M).powi(2)).powf(-B / 2.0)
    };
    let values = wavelengths_m.iter().map(c1d_m3).collect();
    let psd = Psd::new(wavelengths_m, values, Convention::C1D).expect("a falling form of positive values");
    let moments = cumulative_moments(&psd.profile().expect("C1D is a profile's"), Normalisation::Parseval);
    moments.last().map_or(f64::NAN, |moments| moments.m2)
}
