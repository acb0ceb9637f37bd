//! What a scene found, for people: area, real pressure and convergence per load.

use std::fmt::Write;

use asperity::FLAGGED_ASPECT_RATIO_OVER_CRITICAL;
use stacked_contact::{Convergence, Level, convergence, largest_full_contact_pressure_pa};

use crate::display::{length, pressure, three_digits};
use crate::plan::{Curve, Results, scales_per_decade};
use crate::scene::Scene;

/// The tolerances within which the area counts as converged.
const TOLERANCES: [(f64, &str); 2] = [(0.01, "1 %"), (0.001, "0.1 %")];

/// The summary of a scene's results.
pub fn summary(scene: &Scene, results: &Results) -> String {
    let mut text = format!("{}\n{}\n", scene.title, sampling(results));
    for (curve, loads) in scene.needs.curves.iter().zip(&results.curves) {
        text.push('\n');
        text.push_str(&curve_summary(scene, results, curve, loads));
    }
    text
}

/// How the spectrum is sampled, which the stacked area depends on.
pub fn sampling(results: &Results) -> String {
    let psd = &results.psd;
    let density =
        scales_per_decade(psd).map_or(String::new(), |n| format!(", {} per decade", three_digits(n)));
    format!(
        "{} scales from {} to {}{density}",
        psd.len(),
        length(psd.longest_wavelength_m()),
        length(psd.shortest_wavelength_m())
    )
}

fn curve_summary(scene: &Scene, results: &Results, curve: &Curve, loads: &[Vec<Level>]) -> String {
    let hardness_pa = scene.material.and_then(|material| material.hardness_pa());
    let mut rows = vec![
        ["nominal pressure", "area fraction", "real pressure"]
            .map(str::to_owned)
            .into_iter()
            .chain(TOLERANCES.map(|(_, name)| format!("converged within {name} at")))
            .collect::<Vec<_>>(),
    ];
    for (load, levels) in scene.needs.loads.iter().zip(loads) {
        let Some(last) = levels.last() else { continue };
        let real_pressure = match hardness_pa {
            Some(hardness_pa) => format!("{} H", three_digits(last.real_pressure_pa / hardness_pa)),
            None => pressure(last.real_pressure_pa),
        };
        let mut row = vec![load.label.clone(), three_digits(last.area_fraction), real_pressure];
        row.extend(TOLERANCES.map(|(tolerance, _)| converged(convergence(levels, tolerance))));
        rows.push(row);
    }
    let mut text = format!("{}\n{}", curve.name, aligned(&rows));
    if let Some(beyond) = beyond_fitted_range(loads) {
        let _ = writeln!(text, "  {beyond}");
    }
    if let Some(limit_pa) = largest_full_contact_pressure_pa(&curve.model, results.scales.iter().copied()) {
        let in_hardnesses = hardness_pa
            .map_or(String::new(), |hardness_pa| format!(" = {} H", three_digits(limit_pa / hardness_pa)));
        let _ =
            writeln!(text, "  limit of dense sampling: area = load / {}{in_hardnesses}", pressure(limit_pa));
    }
    text
}

/// How many levels lie beyond what the elastic-plastic sinusoid is trusted for, if any.
pub fn beyond_fitted_range(curve: &[Vec<Level>]) -> Option<String> {
    let flagged =
        |level: &&Level| level.aspect_ratio_over_critical > Some(FLAGGED_ASPECT_RATIO_OVER_CRITICAL);
    let levels = curve.iter().flatten();
    let (all, beyond) = (levels.clone().count(), levels.filter(flagged).count());
    (beyond > 0).then(|| {
        format!(
            "{beyond} of {all} levels have B/B_c above {FLAGGED_ASPECT_RATIO_OVER_CRITICAL}, beyond what the \
         elastic-plastic sinusoid is trusted for"
        )
    })
}

fn converged(found: Option<Convergence>) -> String {
    match found {
        Some(Convergence { wavelength_m, converged: true }) => length(wavelength_m),
        Some(Convergence { wavelength_m, converged: false }) => {
            format!("not converged ({})", length(wavelength_m))
        }
        None => String::new(),
    }
}

/// Rows as indented columns of equal width.
pub fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|at| rows.iter().filter_map(|row| row.get(at)).map(|c| c.chars().count()).max().unwrap_or(0))
        .collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for (cell, width) in row.iter().zip(&widths) {
            let _ = write!(line, " {cell:<width$} ");
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}
