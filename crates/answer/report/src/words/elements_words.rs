//! Boundary elements in words: the surfaces, and the limits of the results.

use elements::{IndenterCaution, IndenterShape, PressedLoad, RandomSurfaces};
use interface::adhesion::{FullerTabor, PastewkaRobbins};
use questions::AdhesionNote;
use spectrum::random_surfaces::{AreaSpectrum, GridBand};
use study::validity::SMALL_SLOPE_PRESSURE;
use units::display::{counted, length, percent, pressure, three_digits};

/// Says why the contact of an indenter is doubtful.
#[must_use]
pub fn of_indenter(shape: IndenterShape, caution: &IndenterCaution) -> String {
    let radius = match shape {
        IndenterShape::Ball => "radius",
        IndenterShape::Cylinder => "half-width",
    };
    match (caution, shape) {
        (IndenterCaution::CoarseGrid { points_per_radius }, _) => format!(
            "Hertz's {radius} has {} points of the grid, and 8 are needed for an answer",
            three_digits(*points_per_radius)
        ),
        (IndenterCaution::NarrowMap { radii_across_map, .. }, IndenterShape::Ball) => format!(
            "the map is {} of Hertz's radii wide; below 4 its edges carry load",
            three_digits(*radii_across_map)
        ),
        (IndenterCaution::NarrowMap { radii_across_map, pressure_excess }, IndenterShape::Cylinder) => {
            format!(
                "the surface is {} of Hertz's half-widths wide; its images raise the pressure of a smooth cylinder by {}",
                three_digits(*radii_across_map),
                percent(*pressure_excess)
            )
        }
        (IndenterCaution::LargeContact { radius_share }, _) => format!(
            "Hertz's {radius} is {} of the radius of the {shape}; from 0.1 on a {shape} is not a parabola",
            three_digits(*radius_share)
        ),
    }
}

/// Says what was found on surfaces that attract each other.
#[must_use]
pub fn of_adhesion(found: &AdhesionNote) -> String {
    match *found {
        AdhesionNote::CoarseGrid { points } => format!(
            "the process zone E* rho^2/w has {} points of the grid; from 2 on areas are good to 1 %, below they are up to 10 % \
             too large: take a finer grid or a longer range",
            three_digits(points)
        ),
        AdhesionNote::Metastable => {
            "a disturbance may end the contact under a negative pressure; pull the surfaces apart for the largest pull"
                .to_owned()
        }
        AdhesionNote::Hysteresis { nominal_pressure_pa, apart, contact } => format!(
            "the area depends on the history: at {} it is {} on approach and {} coming from full contact",
            pressure(nominal_pressure_pa),
            percent(apart),
            percent(contact)
        ),
        AdhesionNote::PullOff { nominal_pressure_pa, mean_gap_m, area_fraction } => format!(
            "pull-off at {}, with {} of the area in contact and a mean gap of {}",
            pressure(nominal_pressure_pa),
            percent(area_fraction),
            length(mean_gap_m)
        ),
        AdhesionNote::Indicators { fuller_tabor, pastewka_robbins } => {
            let fuller_tabor = fuller_tabor.map_or_else(String::new, |theta| {
                format!(
                    "Fuller & Tabor {} (above {} not sticky), ",
                    three_digits(theta),
                    FullerTabor::NOT_STICKY_ABOVE
                )
            });
            format!(
                "indicators of adhesion: {fuller_tabor}Pastewka & Robbins {} (sticky below {})",
                three_digits(pastewka_robbins),
                three_digits(PastewkaRobbins::LIMIT)
            )
        }
    }
}

/// The note on a spectrum that was given as the spectrum of an area.
pub const TAKEN_AS_IT_IS: &str =
    "surfaces are made of the spectrum of areas as it is, without the Abel integral and all of its samples";

/// The surfaces made of a spectrum, in a line of provenance.
#[must_use]
pub fn random_surfaces(random: &RandomSurfaces) -> String {
    let synthesis = &random.synthesis;
    format!(
        "{} surfaces of {} x {} points over {} m, waves from {} m to {} m, seed {}, {} phases, each at the rms gradient {}",
        random.realisations,
        synthesis.points_x,
        synthesis.points_y,
        units::number(synthesis.length_x_m),
        units::number(random.band.longest_m()),
        units::number(random.band.shortest_m()),
        synthesis.seed,
        synthesis.phases,
        units::number(random.band.mean_square_gradient().sqrt())
    )
}

/// The notes on surfaces made of a spectrum, a sentence each.
#[must_use]
pub fn of_surfaces(
    spectrum: &AreaSpectrum,
    random: &RandomSurfaces,
    grid: &GridBand,
    contact_modulus_pa: f64,
) -> Vec<String> {
    let band = &random.band;
    let mut words = vec![format!(
        "{} of {} x {} points over {}, with waves from {} to {}: {} points for the shortest, {} lengths of the longest",
        counted(random.realisations, "surface"),
        grid.points,
        grid.points,
        length(grid.length_m),
        length(band.longest_m()),
        length(band.shortest_m()),
        three_digits(grid.points_per_shortest()),
        three_digits(grid.lengths())
    )];
    let gradient = band.mean_square_gradient().sqrt();
    words.push(format!(
        "each surface has the rms gradient of the band, h' = {}, so that E* h' = {}",
        three_digits(gradient),
        pressure(contact_modulus_pa * gradient)
    ));
    let left_out = [
        (spectrum.longest_m() > 1.001 * band.longest_m())
            .then(|| format!("above {}", length(band.longest_m()))),
        (spectrum.shortest_m() < 0.999 * band.shortest_m())
            .then(|| format!("below {}", length(band.shortest_m()))),
    ];
    let left_out: Vec<String> = left_out.into_iter().flatten().collect();
    if !left_out.is_empty() {
        words.push(format!("waves of the spectrum {} are left out", left_out.join(" and ")));
    }
    let conversion = spectrum.conversion();
    if conversion.smoothed {
        words.push(format!(
            "the spectrum rises where that of profiles cannot ({} of the roughness came out negative); it was smoothed to the \
             nearest one that never rises",
            percent(conversion.negative_share)
        ));
    } else if conversion.clipped_share > 1e-6 {
        words.push(format!(
            "{} of the roughness came out negative, which profiles of a surface cannot have, and was left out",
            percent(conversion.clipped_share)
        ));
    }
    if 0.5 * gradient > SMALL_SLOPE_PRESSURE {
        words.push(format!(
            "doubtful: these slopes take {} E* to flatten, and a linear-elastic half-space needs small slopes (up to \
             {SMALL_SLOPE_PRESSURE} E*)",
            three_digits(0.5 * gradient)
        ));
    }
    words
}

/// The notes on results, a sentence each.
#[must_use]
pub fn of_results(loads: &[PressedLoad]) -> Vec<String> {
    let mut words = Vec::new();
    let all = |which: Vec<&PressedLoad>| {
        if which.len() == loads.len() {
            "every load".to_owned()
        } else {
            let pressures: Vec<String> =
                which.iter().map(|load| pressure(load.nominal_pressure_pa)).collect();
            pressures.join(", ")
        }
    };
    let falls = |load: &&PressedLoad| {
        load.states.iter().all(|state| state.area_fraction_coarser.is_some()) && !load.shows_spots()
    };
    let falling: Vec<&PressedLoad> = loads.iter().filter(falls).collect();
    if !falling.is_empty() {
        words.push(format!(
            "at {} the grid is too coarse for the contact spots, and the area is not extrapolated to finer grids; use more points \
             for the shortest wavelength",
            all(falling)
        ));
    }
    let rounded = |load: &&PressedLoad| load.states.iter().any(|state| state.is_rounded);
    let rounded: Vec<&PressedLoad> = loads.iter().filter(rounded).collect();
    if !rounded.is_empty() {
        words.push(format!("at {} rounding kept the residual above the tolerance", all(rounded)));
    }
    words.extend(closed_paths(loads));
    words
}

/// The loads at which contact closes the paths from edge to edge; `None` if every surface is open in both directions.
fn closed_paths(loads: &[PressedLoad]) -> Option<String> {
    let (mut clauses, mut shut) = (Vec::new(), Vec::new());
    for load in loads {
        let count = load.states.len();
        let along_x = load.states.iter().filter(|state| state.open.along_x).count();
        let along_y = load.states.iter().filter(|state| state.open.along_y).count();
        let pressure = pressure(load.nominal_pressure_pa);
        if along_x + along_y == 0 {
            shut.push(pressure);
        } else if along_x + along_y < 2 * count {
            clauses.push(match (count, along_x) {
                (1, 1) => format!("at {pressure} only those along x are open"),
                (1, _) => format!("at {pressure} only those along y are open"),
                _ => format!(
                    "at {pressure} {along_x} of {count} surfaces are open along x and {along_y} along y"
                ),
            });
        }
    }
    if !shut.is_empty() {
        clauses.push(format!("at {} none is open", shut.join(", ")));
    }
    (!clauses.is_empty())
        .then(|| format!("contact closes the paths from edge to edge: {}", clauses.join("; ")))
}

/// The error for a load that is not below the saturation, which `option` sets.
#[must_use]
pub fn cannot_be_carried(nominal_pressure_pa: f64, saturation_pa: f64, option: &str) -> String {
    format!(
        "{} is more than the saturation can carry: {option} is {}; use a smaller pressure or a larger saturation",
        pressure(nominal_pressure_pa),
        pressure(saturation_pa)
    )
}
