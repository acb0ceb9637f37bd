//! The words for what boundary elements press, and for what to think of what comes out.

use gaussian_surfaces::{AreaSpectrum, GridBand};
use rough_bem::{PressedLoad, RandomSurfaces};
use units::display::{length, pressure, three_digits};

/// Slopes are small to a linear-elastic half-space while the pressures that flatten them, E* h'/2, are below this share of
/// E*.
const LARGEST_SHARE: f64 = 0.1;

/// What becomes of a spectrum that was given as that of an area.
pub const TAKEN_AS_IT_IS: &str =
    "surfaces are made of the spectrum of areas as it is, without the Abel integral and all of its samples";

/// What is made of a spectrum, a line for its file.
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

/// What a reader has to know of surfaces made of a spectrum, a sentence each.
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
            "the spectrum rises where that of profiles of a surface cannot ({} % of the roughness came out negative): it \
             was smoothed to the nearest one that nowhere rises",
            three_digits(100.0 * conversion.negative_share)
        ));
    } else if conversion.clipped_share > 1e-6 {
        words.push(format!(
            "{} % of the roughness came out negative, as profiles of a surface cannot have it, and was left out",
            three_digits(100.0 * conversion.clipped_share)
        ));
    }
    if 0.5 * gradient > LARGEST_SHARE {
        words.push(format!(
            "doubtful: pressures of {} E* flatten such slopes, and a linear-elastic half-space holds for slopes that are \
             small",
            three_digits(0.5 * gradient)
        ));
    }
    words
}

/// What to think of results, a sentence each.
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
            "at {} the corrected area falls from every second point to all of them: the grid does not show the spots, and no \
             step to a finer one is taken; more points for the shortest wavelength would tell",
            all(falling)
        ));
    }
    let rounded = |load: &&PressedLoad| load.states.iter().any(|state| state.is_rounded);
    let rounded: Vec<&PressedLoad> = loads.iter().filter(rounded).collect();
    if !rounded.is_empty() {
        words.push(format!("at {} rounding kept the residual above the tolerance", all(rounded)));
    }
    words.extend(ways_shut(loads));
    words
}

/// At which loads contact shuts ways from edge to edge; nothing where every surface is open in both directions.
fn ways_shut(loads: &[PressedLoad]) -> Option<String> {
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
    (!clauses.is_empty()).then(|| format!("contact shuts ways from edge to edge: {}", clauses.join("; ")))
}

/// Why a load is refused that is not below the saturation, which `option` gives.
#[must_use]
pub fn cannot_be_carried(nominal_pressure_pa: f64, saturation_pa: f64, option: &str) -> String {
    format!(
        "a nominal pressure of {} cannot be carried: {option} lets no point carry more than {}; give a smaller pressure, or a \
         larger saturation",
        pressure(nominal_pressure_pa),
        pressure(saturation_pa)
    )
}

fn counted(count: usize, what: &str) -> String {
    if count == 1 { format!("1 {what}") } else { format!("{count} {what}s") }
}
