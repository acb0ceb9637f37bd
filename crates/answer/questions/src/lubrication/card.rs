//! The file for a solver: rows, the nearest Greenwood-Tripp law, and what a reader has to know.

use std::f64::consts::SQRT_2;

use spectrum::{AsperityParameters, Moments};
use stat_contact::{GreenwoodTripp, GreenwoodTrippFit, Population, SeparationPoint};
use study::gap_law::GapError;
use tables::Table;
use units::display::{length, percent, pressure, three_digits};
use units::{Remark, RemarkLevel, Spelling};

use super::SurfaceRow;
use crate::QuestionError;
use crate::gap::cautions;

/// Least separation over the rms height at which Patir & Cheng's flow factor of isotropic faces holds.
const PATIR_CHENG_FROM: f64 = 0.5;
const NO_ROWS: &str =
    "no separation of the range has a pressure; choose smaller separations or other pressures";
const NO_FIT: &str = "No Greenwood-Tripp law is fitted: the rows span less than 1 of h/sigma = 0.5 to 3.";
const SEPARATION: &str = "Pressures are nominal, force over the area that seems to touch. h is nominal_separation_m, the distance of \
                          the mean planes of both faces; mean_gap_m is the mean of the open gap over all points. Above the last row \
                          asperities carry next to nothing.";
const INTEGRALS: &str =
    "F_n(x) is the integral of (s - x)^n over the standard normal density of s from x on.";
const UNIDENTIFIED: &str = "Since sigma is known, this fit has two numbers: areas fix eta beta sigma, pressure and area together \
                            sigma/beta; eta and beta apart follow by sigma. Pressures alone fix (eta beta sigma)^2 sqrt(sigma/beta) \
                            E*, and a length where sigma is free, but neither eta nor beta nor the area. They are \
                            numbers of a fit, and no geometry of summits.";
const FLOW: &str = "A fluid of viscosity mu flows at flow_factor mean_gap_m^3/(12 mu) per width and pressure gradient. flow_factor_low \
                    and _high are the range of single surfaces: that of trials for closed forms, a standard deviation with the error of \
                    the grid for elements. Empty where none is known. patir_cheng_flow_factor = 1 - 0.90 exp(-0.56 h/sigma) of isotropic \
                    faces that do not deform multiplies h^3, from h/sigma = 0.5 on (Patir & Cheng 1978, J. Lubr. Technol. 100:12).";

/// Table of asperity pressures for a solver, with what its reader has to know.
#[derive(Debug)]
pub struct FoundLubrication {
    /// A row for each separation, from close to far. Columns: `nominal_pressure_pa, area_fraction, mean_gap_m, nominal_separation_m,
    /// separation_over_rms_height, fitted_pressure_pa, fitted_area_fraction, flow_factor_x, flow_factor_y, flow_factor_low,
    /// flow_factor_high, patir_cheng_flow_factor`.
    pub table: Table,
    /// The Greenwood-Tripp law nearest to the rows; `None` if they span too little of its range.
    pub fit: Option<GreenwoodTrippFit>,
    /// Notes for the reader.
    pub notes: Vec<Remark>,
    lines: Vec<String>,
}

impl FoundLubrication {
    /// Describes source, laws, conventions and every caution in lines, for the comments of a file.
    #[must_use]
    pub fn description(&self, spelling: &dyn Spelling) -> Vec<String> {
        let notes = self.notes.iter().filter(|note| note.level != RemarkLevel::Caution);
        let notes = notes.map(|note| format!("Note: {}.", note.words(spelling)));
        self.lines.iter().cloned().chain(notes).chain(cautions(&self.notes, spelling)).collect()
    }
}

/// Rows of a source, with the lines on it.
pub(super) struct Card {
    pub rows: Vec<SurfaceRow>,
    pub rms_height_m: f64,
    pub modulus_pa: f64,
    pub lines: Vec<String>,
    pub notes: Vec<Remark>,
}

impl Card {
    /// Fits the rows, and makes the file.
    pub fn found(self) -> Result<FoundLubrication, QuestionError> {
        let Card { mut rows, rms_height_m, modulus_pa, mut lines, notes } = self;
        if rows.is_empty() {
            return Err(QuestionError::Other(NO_ROWS.to_owned()));
        }
        rows.sort_by(|one, other| one.point.separation_m.total_cmp(&other.point.separation_m));
        let points: Vec<SeparationPoint> = rows.iter().map(|row| row.point).collect();
        let fit = GreenwoodTripp::fit(modulus_pa, rms_height_m, &points);
        lines.push(SEPARATION.to_owned());
        lines.push(format!(
            "sigma = {}, the rms height of the sum of both faces. E* = {}, 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2; a code with E' = \
             2/((1 - nu1^2)/E1 + (1 - nu2^2)/E2) = 2 E* has half of the coefficient of p.",
            length(rms_height_m),
            pressure(modulus_pa)
        ));
        match &fit {
            Some(fit) => lines.extend([of_fit(fit), UNIDENTIFIED.to_owned()]),
            None => lines.push(NO_FIT.to_owned()),
        }
        lines.push(FLOW.to_owned());
        let over_rms = points.iter().map(|point| point.separation_m / rms_height_m);
        let fitted = |of: fn(&GreenwoodTripp, f64) -> f64| {
            points.iter().map(move |point| fit.map(|fit| of(&fit.law, point.separation_m)))
        };
        let patir_cheng = |over_rms: f64| {
            (over_rms >= PATIR_CHENG_FROM - 1e-9).then(|| 1.0 - 0.90 * (-0.56 * over_rms).exp())
        };
        let mut table = Table::default()
            .with_numbers("nominal_pressure_pa", points.iter().map(|point| point.pressure_pa))
            .with_numbers("area_fraction", points.iter().map(|point| point.area_fraction))
            .with_numbers("mean_gap_m", rows.iter().map(|row| row.mean_gap_m))
            .with_numbers("nominal_separation_m", points.iter().map(|point| point.separation_m))
            .with_numbers("separation_over_rms_height", over_rms.clone())
            .with_numbers("fitted_pressure_pa", fitted(GreenwoodTripp::pressure_pa))
            .with_numbers("fitted_area_fraction", fitted(GreenwoodTripp::area_fraction));
        for (at, of) in ["x", "y", "low", "high"].into_iter().enumerate() {
            let factors = rows.iter().map(|row| row.flow.map(|flow| flow[at]));
            table = table.with_numbers(&format!("flow_factor_{of}"), factors);
        }
        table = table.with_numbers("patir_cheng_flow_factor", over_rms.map(patir_cheng));
        Ok(FoundLubrication { table, fit, notes, lines })
    }
}

/// Words a law by its triple and its products.
pub(super) fn of_law(law: &GreenwoodTripp) -> String {
    format!(
        "{}, eta beta sigma = {}, sigma/beta = {}.",
        triple(law.summits(), ["beta", "sigma"]),
        three_digits(law.density_radius_sigma()),
        three_digits(law.sigma_over_radius())
    )
}

/// Words density, radius and height of summits, the last two by their symbols.
fn triple(summits: &Population, [radius, height]: [&str; 2]) -> String {
    let density = three_digits(summits.density_per_m2());
    let [of_radius, of_height] = [summits.radius_m(), summits.sigma_s_m()].map(length);
    format!("eta = {density} per m^2, {radius} = {of_radius}, {height} = {of_height}")
}

fn of_fit(fit: &GreenwoodTrippFit) -> String {
    let off = |[rms, most]: [f64; 2]| {
        format!("a factor of {} rms and {} at most", three_digits(rms.exp()), three_digits(most.exp()))
    };
    let [least, most] = fit.range.map(three_digits);
    format!(
        "Nearest Greenwood-Tripp law (1970, Proc. Inst. Mech. Eng. 185:625), p = (16 sqrt(2) pi/15) (eta beta sigma)^2 sqrt(sigma/beta) \
         E* F_5/2(h/sigma) and A = pi^2 (eta beta sigma)^2 F_2(h/sigma), by least squares of ln p and ln A from h/sigma = {least} to \
         {most}: {} Its pressures are off by {}, its areas by {}.",
        of_law(&fit.law),
        off(fit.ln_pressure_errors),
        off(fit.ln_area_errors)
    )
}

/// Describes the summits that spectral moments have at their cutoff: of one rough face on a plane, and of two rough faces; `None` without
/// roughness.
pub(super) fn of_summits(
    sum: Option<Moments>,
    faces: Option<(Moments, Moments)>,
    modulus_pa: f64,
) -> Result<Option<[String; 3]>, GapError> {
    let summits = |moments: &Moments| {
        let of = AsperityParameters::from_moments(moments).ok_or(GapError::NoRoughness)?;
        Ok::<_, GapError>((Population::new(of.radius_m, of.density_per_m2, of.sigma_s_m)?, of.offset_m))
    };
    let Some(moments) = sum else { return Ok(None) };
    let (sum, offset_m) = summits(&moments)?;
    let (law, offsets_m, of) = match &faces {
        Some((one, other)) => {
            let [(one, first_m), (other, second_m)] = [summits(one)?, summits(other)?];
            let law = GreenwoodTripp::from_faces(modulus_pa, [&one, &other])?;
            (
                law,
                first_m + second_m,
                "Both faces, each by its own spectrum, act like two alike faces (Greenwood & Tripp)",
            )
        }
        // Half of the moments has the density, and sqrt(2) of the radius, of which offsets are the inverse.
        None => (
            GreenwoodTripp::from_sum(modulus_pa, &sum)?,
            SQRT_2 * offset_m,
            "Two alike faces (Greenwood & Tripp), if each has half of this roughness",
        ),
    };
    let on_plane = format!(
        "Summits by spectral moments (McCool 1987, J. Tribol. 109:264) down to the cutoff of {}, which they depend on. One rough face on \
         a plane, with the roughness of the sum: {}, the mean summit {} above the mean plane; p = (4/3) eta E* sqrt(R) sigma_s^(3/2) \
         F_3/2 with h from the mean summit (Greenwood & Williamson 1966, Proc. R. Soc. A 295:300).",
        length(moments.wavelength_m),
        triple(&sum, ["R", "sigma_s"]),
        length(offset_m)
    );
    let rms_height_m = moments.rms_height_m();
    let of_two = format!(
        "{of}: {} Their h is that of the mean summits, {} less than that of the mean planes; with the latter in its place the pressure \
         at h = {} would be {} of that.",
        of_law(&law),
        length(offsets_m),
        length(rms_height_m),
        percent(law.pressure_pa(rms_height_m) / law.pressure_pa(rms_height_m - offsets_m))
    );
    Ok(Some([on_plane, of_two, INTEGRALS.to_owned()]))
}
