//! Rows of boundary elements, and flow through their gaps and those of Persson's theory.

use elements::{Approach, Boundary, ImposedLoad, PressedLoad, Pressing, Relief, Surfaces};
use interface::leak::SealedJoint;
use interface::sealed_fluid::SealedFluid;
use numerics::parallel::Progress;
use persson::corrections::Correction;
use persson::sealing::{PercolationThreshold, SealingLaw};
use persson::{EnergyFactor, Roughness, SealFlow};
use spectrum::Moments;
use stat_contact::SeparationPoint;
use study::material::Material;
use study::surface::Surface;
use units::Remark;
use units::display::{counted, length, percent, pressure};

use super::card::Card;
use super::{LubricationQuestion, LubricationRange, SurfaceRow, evenly, pressures_pa};
use crate::QuestionError;
use crate::elements::{notes_on_maps, notes_on_spectrum, random_surfaces, remarks_on_pressed};
use crate::map_question::relief;

/// Rows, under each of which every surface is pressed.
const ROWS: u32 = 11;
/// Least area of the flows that the medium of Persson's gaps was compared with (`docs/develop/trials.md`).
const LEAST_TRIED_AREA: f64 = 0.02;
/// Length of a wave over the side of the seal whose range of flow is taken.
const WAVE: f64 = 0.1;
const FREE_EDGES: &str =
    "a map that does not repeat itself is pressed by loads, not to separations; give a range of pressures";
const NO_MAP: &str = "the surface holds no map to press as scanned; give the scan of a map";

/// Flow factors of a surface by the effective medium of Persson's gaps, at points whose separation is the mean gap; `None` for
/// contacts lighter than any flow that was tried.
pub(super) fn medium(
    roughness: &Roughness,
    modulus_pa: f64,
    energy_factor: EnergyFactor,
) -> impl Fn(&SeparationPoint) -> Option<[f64; 4]> {
    // Seals take this correction as well.
    let (correction, threshold) = (Some(Correction::AlgebraicNayak), PercolationThreshold::default());
    let law = SealingLaw::new(roughness, modulus_pa, energy_factor, correction, threshold);
    let flow = SealFlow::new(&law);
    let fluid = SealedFluid::Incompressible { viscosity_pa_s: 1.0 };
    let joint = SealedJoint::new(1.0, 1.0, 1.0, fluid).ok();
    move |&SeparationPoint { separation_m, pressure_pa, .. }| {
        let area_fraction = law.area_fraction(pressure_pa);
        if area_fraction < LEAST_TRIED_AREA {
            return None;
        }
        let Some(found) = flow.conductance(pressure_pa / law.tight_pressure_pa(), separation_m) else {
            return Some([0.0; 4]);
        };
        let rate = joint?.leak_rate([found.medium_m3, found.parallel_m3], area_fraction, WAVE);
        let slot = joint?.rate_m3_per_s(separation_m.powi(3));
        let medium = found.medium_m3 / separation_m.powi(3);
        Some([medium, medium, rate.low_m3_per_s / slot, rate.high_m3_per_s / slot])
    }
}

impl LubricationQuestion {
    /// Rows of boundary elements, with the moments of the band of random surfaces.
    pub(super) fn pressed(
        &self,
        material: &Material,
        surface: &Surface,
        progress: &dyn Progress,
    ) -> Result<(Card, Option<Moments>), QuestionError> {
        let saturation_pa = material.hardness_pa();
        let mut pressing = Pressing { saturation_pa, ..Pressing::between(&material.pair) };
        let mut band = None;
        let (surfaces, mut notes, source) = if self.as_scanned {
            let boundary = |periodic| if periodic { Boundary::Periodic } else { Boundary::Free };
            let maps = surface.maps().iter();
            let maps = maps.map(|patch| relief(&patch.map, patch.heights_m(), boundary(patch.is_periodic)));
            let maps: Vec<_> = maps.collect();
            let first = maps.first().ok_or_else(|| QuestionError::Other(NO_MAP.to_owned()))?;
            let source = format!(
                "{} as scanned, of {} x {} points",
                counted(maps.len(), "map"),
                first.columns,
                first.rows
            );
            let notes = notes_on_maps(material, &maps);
            (Surfaces::Maps(maps), notes, source)
        } else {
            let (random, made) = random_surfaces(surface, &self.random, &pressing)?;
            band = Some(random.band.moments());
            let ends = [random.band.longest_m(), random.band.shortest_m()];
            let [longest, shortest] = ends.map(length);
            let surfaces = counted(random.realisations, "random surface");
            let source = format!("{surfaces} with the waves from {longest} to {shortest}, which sigma is of");
            let notes = notes_on_spectrum(material, surface).into_iter().chain(made).collect();
            (Surfaces::Random(random), notes, source)
        };
        let mut lines = vec![format!("Boundary elements: {source}.")];
        if matches!(&surfaces, Surfaces::Maps(maps) if maps.iter().any(|map| map.boundary == Boundary::Free))
        {
            if matches!(self.range, LubricationRange::Separations(_)) {
                return Err(QuestionError::Other(FREE_EDGES.to_owned()));
            }
            lines.push(
                "Edges are free: the separation is that of the faces as they bend under the load.".to_owned(),
            );
        }
        let rms_height_m = rms_height_m(&surfaces);
        pressing.loads = match self.range {
            LubricationRange::Pressures(ends) => {
                pressures_pa(ends, material, ROWS)?.map(ImposedLoad::PressurePa).collect()
            }
            // From far to close, since smaller loads behind larger ones unload nothing.
            LubricationRange::Separations([from, to]) => evenly([to, from], ROWS)
                .map(|over_rms| ImposedLoad::Approach(Approach::MeanGapM(over_rms * rms_height_m)))
                .collect(),
        };
        let (pressed, flows) = press(&surfaces, &pressing, &mut notes, progress)?;
        lines.push(match saturation_pa {
            Some(hardness_pa) => {
                let means = pressed.iter().map(PressedLoad::mean);
                let flowed = means.map(|mean| mean.plastic_area_fraction / mean.area_fraction).fold(0.0, f64::max);
                format!(
                    "Up to {} of the contact flows at H = {}. The separation is the mean gap less the mean depth that has flowed.",
                    percent(flowed),
                    pressure(hardness_pa)
                )
            }
            None => "Nothing flows, since no hardness is given, and the separation is the mean gap.".to_owned(),
        });
        let row = |(load, flow): (&PressedLoad, Option<[f64; 4]>)| {
            let mean = load.mean();
            let point = SeparationPoint {
                separation_m: mean.mean_gap_m - mean.mean_plastic_depth_m,
                pressure_pa: load.nominal_pressure_pa,
                area_fraction: load.area_fraction(saturation_pa),
            };
            SurfaceRow { point, mean_gap_m: mean.mean_gap_m, flow }
        };
        let rows: Vec<SurfaceRow> = pressed.iter().zip(flows).map(row).collect();
        notes.extend(remarks_on_pressed(&pressed));
        let areas = rows.iter().map(|row| (row.point.pressure_pa, row.point.area_fraction));
        if saturation_pa.is_none() {
            notes.extend(self.by.doubts(material, areas, None));
        }
        let modulus_pa = material.pair.composite_modulus_pa();
        Ok((Card { rows, rms_height_m, modulus_pa, lines, notes }, band))
    }
}

/// Rms height of surfaces \[m\].
fn rms_height_m(surfaces: &Surfaces) -> f64 {
    let of_map_m2 = |map: &Relief| {
        let count = map.heights_m.len() as f64;
        let mean_m = map.heights_m.iter().sum::<f64>() / count;
        map.heights_m.iter().map(|height_m| (height_m - mean_m).powi(2)).sum::<f64>() / count
    };
    match surfaces {
        Surfaces::Random(random) => random.band.mean_square_height_m2().sqrt(),
        Surfaces::Maps(maps) => (maps.iter().map(of_map_m2).sum::<f64>() / maps.len() as f64).sqrt(),
        _ => 0.0,
    }
}

/// Loads on surfaces, and the flow factors of each, which the crate `transport` solves.
type PressedWithFlow = (Vec<PressedLoad>, Vec<Option<[f64; 4]>>);

fn press(
    surfaces: &Surfaces,
    pressing: &Pressing,
    notes: &mut Vec<Remark>,
    progress: &dyn Progress,
) -> Result<PressedWithFlow, QuestionError> {
    #[cfg(feature = "transport")]
    {
        use crate::flow::{MeanFlow, PressedFlow};
        let flow = PressedFlow::new(None, surfaces)?;
        let see = |field: &elements::ContactField<'_>| flow.solve(field, progress).map(drop);
        let mut pressed = elements::press::<QuestionError>(surfaces, pressing, see, progress)?;
        let factors = |MeanFlow { factors: [x, y], deviations, errors }: MeanFlow| {
            let [off_x, off_y] =
                [0, 1].map(|axis| deviations[axis].unwrap_or(0.0).hypot(errors[axis].unwrap_or(0.0)));
            Some([x, y, (x - off_x).min(y - off_y).max(0.0), (x + off_x).max(y + off_y)])
        };
        let flows = flow.means(&mut pressed, notes).into_iter().map(factors).collect();
        Ok((pressed, flows))
    }
    #[cfg(not(feature = "transport"))]
    {
        let _ = notes;
        let pressed = elements::press::<QuestionError>(surfaces, pressing, |_| Ok(()), progress)?;
        let flows = vec![None; pressed.len()];
        Ok((pressed, flows))
    }
}
