//! Resistance of the spots of a contact over that from its stiffness (Barber 2003), on random surfaces of twelve spectra with
//! 512^2 points, periodic and with free edges, by area. Prints a table; takes some minutes on one processor.

use std::sync::Mutex;

use elements::{
    Boundary, ContactField, ElementsError, ImposedLoad, Pressing, RandomSurfaces, Surfaces, press,
};
use interface::conductance::Resistivities;
use numerics::parallel::Unobserved;
use spectrum::random_surfaces::{AreaSpectrum, Phases, SelfAffine, Size, Synthesis};
use transport::spots::{FieldSpots, SpotConduction};

const POINTS: usize = 512;
/// Waves per box: the longest, the roll-off, and the shortest.
const BANDS: [[f64; 3]; 4] = [[2.0, 2.0, 32.0], [2.0, 8.0, 64.0], [4.0, 4.0, 64.0], [8.0, 8.0, 64.0]];
const HURST_EXPONENTS: [f64; 3] = [0.5, 0.7, 0.9];
/// Pressures over E* h', for areas of about 0.01 to 0.4 by Persson's theory.
const PRESSURES: [f64; 9] = [0.0063, 0.0188, 0.0314, 0.0628, 0.0946, 0.1267, 0.1594, 0.1929, 0.2629];

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for boundary in [Boundary::Periodic, Boundary::Free] {
        println!(
            "{boundary}: area less its perimeter, spots, discs, resistance over that from the stiffness"
        );
        let mut ratios = vec![Vec::new(); PRESSURES.len()];
        for (number, waves) in BANDS.into_iter().enumerate() {
            for hurst_exponent in HURST_EXPONENTS {
                let [longest_m, rolloff_m, shortest_m] = waves.map(f64::recip);
                let band = AreaSpectrum::self_affine(&SelfAffine {
                    hurst_exponent,
                    longest_m,
                    rolloff_m,
                    shortest_m,
                    size: Size::RmsGradient(1.0),
                })?;
                let synthesis = Synthesis::square(POINTS, 1.0, 1 + number as u64, Phases::FixedModulus);
                let random = Surfaces::Random(RandomSurfaces { band, synthesis, realisations: 1 });
                let mut relief = random.relief(0)?.into_owned();
                relief.boundary = boundary;
                let pressing = Pressing {
                    loads: PRESSURES.into_iter().map(ImposedLoad::ReducedPressure).collect(),
                    stiffness: true,
                    ..Pressing::elastic(1.0)
                };
                let conduction = SpotConduction::new(Resistivities::new(0.5, 0.5)?);
                let found = Mutex::new(Vec::new());
                let see = |field: &ContactField<'_>| -> Result<(), ElementsError> {
                    let spots = FieldSpots::new(field, conduction).expect("a map of several rows");
                    found.lock().expect("no thread has panicked").push(spots);
                    Ok(())
                };
                let pressed = press(&Surfaces::Maps(vec![relief]), &pressing, see, &Unobserved)?;
                for field in found.into_inner()? {
                    let state = pressed[field.load].states[0];
                    let area = state.numbers.area_fraction_corrected;
                    let Some(stiffness) = state.stiffness_pa_per_m else { continue };
                    let from_stiffness = field.resistance_from_stiffness_ohm(stiffness)?;
                    match field.solved {
                        Ok(spots) => {
                            let ratio = spots.resistance_ohm / from_stiffness;
                            println!(
                                "H {hurst_exponent}, {waves:?}, {area:.4}, {}, {}, {ratio:.4}",
                                spots.spots.len(),
                                spots.discs
                            );
                            ratios[field.load].push((area, ratio));
                        }
                        Err(error) => println!("H {hurst_exponent}, {waves:?}, {area:.4}, {error}"),
                    }
                }
            }
        }
        println!("{boundary}: mean area, surfaces, least ratio, mean, largest");
        for of_load in ratios.iter().filter(|of_load| !of_load.is_empty()) {
            let count = of_load.len() as f64;
            let mean_area = of_load.iter().map(|(area, _)| area).sum::<f64>() / count;
            let mean = of_load.iter().map(|(_, ratio)| ratio).sum::<f64>() / count;
            let least = of_load.iter().map(|(_, ratio)| *ratio).fold(f64::INFINITY, f64::min);
            let most = of_load.iter().map(|(_, ratio)| *ratio).fold(0.0, f64::max);
            println!("{mean_area:.3}, {count}, {least:.3}, {mean:.3}, {most:.3}");
        }
    }
    Ok(())
}
