//! Boundary elements in words: the provenance of surfaces, and a load that they cannot carry.

use elements::RandomSurfaces;
use units::display::pressure;

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

/// The error for a load that is not below the pressure at which the surface yields.
#[must_use]
pub fn cannot_be_carried(nominal_pressure_pa: f64, saturation_pa: f64) -> String {
    format!(
        "{} is more than a surface that yields at {} can carry; use a smaller pressure, or a larger saturation or hardness",
        pressure(nominal_pressure_pa),
        pressure(saturation_pa)
    )
}
