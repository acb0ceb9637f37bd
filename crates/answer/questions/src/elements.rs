//! Maps and random surfaces pressed by boundary elements.

use std::str::FromStr;

use findings::doubts::{self, PressedBodies};
use spectrum::random_surfaces::{AreaSpectrum, GridBand, Phases};

use elements::{
    Approach, Boundary, ContactField, ElementsError, ImposedLoad, PressedLoad, PressedState, Pressing,
    RandomChoices, RandomSurfaces, Relief, SpecimenCompliance, Surfaces,
};
use numerics::parallel::Progress;
use serde::{Deserialize, Serialize};
use study::material::Material;
use study::surface::Surface;
use study::validity::SMALL_SLOPE_PRESSURE;
use units::display::{length, pressure};
use units::{Pressure, PressureRange, QuantityError, Remark, RemarkCode};

use crate::loads::{LoadInput, nominal_pressure, pressures_pa};
use crate::{MaterialInput, QuestionError};

/// Random surfaces of a spectrum; an absent choice is the usual one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RandomInput {
    /// Points along each side.
    pub grid: Option<usize>,
    /// Number of surfaces.
    pub realisations: Option<usize>,
    /// Seed of their phases.
    pub seed: Option<u64>,
    /// The longest wavelength \[m\].
    pub longest_m: Option<f64>,
    /// The shortest wavelength \[m\].
    pub shortest_m: Option<f64>,
    /// Length of a side \[m\].
    pub side_m: Option<f64>,
    /// The random part of the surfaces: phases alone, or phases and moduli.
    pub phases: Option<Phases>,
}

/// Name of the method in doubts.
pub(crate) const ELEMENTS: &str = "boundary elements";

/// A surface pressed by boundary elements.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ElementsQuestion {
    /// The bodies in contact.
    pub material: MaterialInput,
    /// Loads, or distances in their place.
    pub loads: Vec<ElementsLoad>,
    /// Nominal pressures as ranges, behind the others.
    pub pressure_ranges: Vec<PressureRange>,
    /// The pressure at which the surface yields; elastic throughout if absent.
    pub saturation: Option<Pressure>,
    /// The largest residual, above 0 and at most 0.1; [`Pressing::TOLERANCE`] if absent.
    pub tolerance: Option<f64>,
    /// Random surfaces, for a spectrum.
    pub random: RandomInput,
    /// Compliance of the specimen that is taken out of the stiffness of maps with free edges; nothing if absent.
    pub compliance: Option<SpecimenCompliance>,
}

/// Load that elements are pressed by, or a distance that they are pressed to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum ElementsLoad {
    /// A nominal pressure.
    Pressure(LoadInput),
    /// A nominal pressure as a multiple of E*.
    Moduli {
        /// The multiple.
        moduli: f64,
    },
    /// A nominal pressure as a multiple of E* h', with the rms gradient h' of each surface.
    ReducedModuli {
        /// The multiple.
        reduced_moduli: f64,
    },
    /// A mean gap, less the mean depth that has yielded.
    MeanGap {
        /// The gap \[m\].
        mean_gap_m: f64,
    },
    /// An indentation from where the highest point touches.
    Indentation {
        /// The indentation \[m\].
        indentation_m: f64,
    },
}

impl From<LoadInput> for ElementsLoad {
    fn from(load: LoadInput) -> Self {
        ElementsLoad::Pressure(load)
    }
}

impl FromStr for ElementsLoad {
    type Err = QuantityError;

    /// Reads a pressure with its unit, which may be `E*` or `E* h'`.
    fn from_str(text: &str) -> Result<Self, QuantityError> {
        let multiple_of = |unit: &str| text.trim_end().strip_suffix(unit)?.trim().parse::<f64>().ok();
        let reduced = ["E* h'", "E*h'", "E* h′", "E*h′"].into_iter().find_map(multiple_of);
        let load = match (reduced, multiple_of("E*")) {
            (Some(reduced_moduli), _) => ElementsLoad::ReducedModuli { reduced_moduli },
            (None, Some(moduli)) => ElementsLoad::Moduli { moduli },
            (None, None) => ElementsLoad::Pressure(text.parse()?),
        };
        Ok(load)
    }
}

impl ElementsLoad {
    fn load(&self, material: &Material) -> Result<ImposedLoad, QuestionError> {
        let modulus_pa = material.pair.composite_modulus_pa();
        Ok(match self {
            ElementsLoad::Pressure(LoadInput { pressure, label }) => {
                let pressure = nominal_pressure("pressure", Some(label), *pressure, material)?;
                ImposedLoad::PressurePa(pressure.pa())
            }
            ElementsLoad::Moduli { moduli } => ImposedLoad::PressurePa(moduli * modulus_pa),
            ElementsLoad::ReducedModuli { reduced_moduli } => ImposedLoad::ReducedPressure(*reduced_moduli),
            ElementsLoad::MeanGap { mean_gap_m } => ImposedLoad::Approach(Approach::MeanGapM(*mean_gap_m)),
            ElementsLoad::Indentation { indentation_m } => {
                ImposedLoad::Approach(Approach::IndentationM(*indentation_m))
            }
        })
    }
}

/// Surfaces ready to be pressed in some way.
pub struct Prepared<P> {
    /// The surfaces.
    pub surfaces: Surfaces,
    /// Notes on the surfaces and on the material.
    pub notes: Vec<Remark>,
    pub(crate) pressing: P,
    /// Hardness of the body that yields \[Pa\], if one is known.
    pub(crate) hardness_pa: Option<f64>,
}

/// Surfaces ready to be pressed by a flat.
pub type PreparedElements = Prepared<Pressing>;

impl RandomInput {
    /// The options, and whether each is given.
    #[must_use]
    pub fn given(&self) -> [(&'static str, bool); 7] {
        [
            ("grid", self.grid.is_some()),
            ("realisations", self.realisations.is_some()),
            ("seed", self.seed.is_some()),
            ("shortest", self.shortest_m.is_some()),
            ("longest", self.longest_m.is_some()),
            ("side", self.side_m.is_some()),
            ("phases", self.phases.is_some()),
        ]
    }

    fn choices(&self) -> RandomChoices {
        let usual = RandomChoices::default();
        RandomChoices {
            points: self.grid.unwrap_or(usual.points),
            realisations: self.realisations.unwrap_or(usual.realisations),
            seed: self.seed.unwrap_or(usual.seed),
            longest_m: self.longest_m,
            shortest_m: self.shortest_m,
            side_m: self.side_m,
            phases: self.phases.unwrap_or_default(),
        }
    }
}

impl ElementsQuestion {
    /// Finds input that contradicts itself or is missing, and loads that no surface can carry.
    ///
    /// # Errors
    /// [`QuestionError`] with the first of them.
    pub fn check(&self) -> Result<(), QuestionError> {
        self.pressing().map(drop)
    }

    /// Prepares random surfaces of a spectrum.
    ///
    /// # Errors
    /// [`QuestionError`].
    pub fn on(&self, surface: &Surface) -> Result<PreparedElements, QuestionError> {
        let (material, pressing) = self.pressing()?;
        let mut notes = notes_on_spectrum(&material, surface);
        let (random, made) = random_surfaces(surface, &self.random, &pressing)?;
        notes.extend(made);
        let hardness_pa = material.hardness_pa();
        Ok(Prepared { surfaces: Surfaces::Random(random), notes, pressing, hardness_pa })
    }

    /// Prepares maps as measured.
    ///
    /// # Errors
    /// [`QuestionError`]; choices of random surfaces mean nothing for maps.
    pub fn on_maps(&self, maps: Vec<Relief>) -> Result<PreparedElements, QuestionError> {
        let (material, pressing) = self.pressing()?;
        let mut notes = notes_on_maps(&material, &maps);
        for map in &maps {
            notes.extend(note_on_missing(map)?);
        }
        let is_free = maps.iter().any(|map| map.boundary == Boundary::Free);
        match (is_free, self.compliance) {
            (true, None) => notes.push(Remark::new(RemarkCode::StiffnessOfPunch)),
            (false, Some(_)) => {
                return Err(QuestionError::Unused(Box::new(
                    Remark::new(RemarkCode::NoFreeEdges).on("compliance"),
                )));
            }
            _ => {}
        }
        let hardness_pa = material.hardness_pa();
        Ok(Prepared { surfaces: Surfaces::Maps(maps), notes, pressing, hardness_pa })
    }

    fn pressing(&self) -> Result<(Material, Pressing), QuestionError> {
        let material = self.material.material()?;
        let saturation_pa = self.saturation.map(|saturation| {
            saturation.pascals(material.hardness_pa()).ok_or(QuestionError::SaturationWithoutHardness)
        });
        let loads = self.loads.iter().map(|load| load.load(&material)).collect::<Result<Vec<_>, _>>()?;
        let ranges = pressures_pa(&[], &self.pressure_ranges, &material)?;
        let pressing = Pressing {
            loads: loads.into_iter().chain(ranges.into_iter().map(ImposedLoad::PressurePa)).collect(),
            saturation_pa: saturation_pa.transpose()?,
            tolerance: self.tolerance.unwrap_or(Pressing::TOLERANCE),
            stiffness: true,
            compliance: self.compliance.unwrap_or_default(),
            ..Pressing::between(&material.pair)
        };
        pressing.check().map_err(ElementsError::from)?;
        Ok((material, pressing))
    }
}

impl PreparedElements {
    /// Number of steps that the progress will count.
    #[must_use]
    pub fn steps(&self) -> usize {
        elements::progress_steps(&self.surfaces, &self.pressing)
    }

    /// Number of loads.
    #[must_use]
    pub fn loads(&self) -> usize {
        self.pressing.loads.len()
    }

    /// Presses the surfaces; `see` is shown each one under each load as it is solved.
    ///
    /// # Errors
    /// Returns the errors of `see`, and [`ElementsError`].
    pub fn answer<E: From<ElementsError> + Send>(
        &self,
        see: impl Fn(&ContactField<'_>) -> Result<(), E> + Sync + Send,
        progress: &dyn Progress,
    ) -> Result<(Vec<PressedLoad>, Vec<Remark>), E> {
        let pressed = elements::press(&self.surfaces, &self.pressing, see, progress)?;
        let Pressing { contact_modulus_pa: modulus_pa, saturation_pa, .. } = self.pressing;
        let hardness_pa = self.hardness_pa.filter(|_| saturation_pa.is_none());
        let bodies = PressedBodies { name: ELEMENTS, modulus_pa, hardness_pa, is_elastic: true };
        let area = |load: &PressedLoad| (load.nominal_pressure_pa, load.mean().best_area_fraction());
        let areas: Vec<_> = pressed.iter().map(area).collect();
        let notes = [
            remarks_on_pressed(&pressed),
            remarks_on_compliance(&pressed, self.pressing.compliance),
            doubts::of_contact(&bodies, Some(("saturation", "1H")), &areas),
        ]
        .concat();
        Ok((pressed, notes))
    }
}

/// Notes on a material and on the spectrum of its surfaces.
pub(crate) fn notes_on_spectrum(material: &Material, surface: &Surface) -> Vec<Remark> {
    let of_material = doubts::of_bodies(material).into_iter();
    let of_surface = surface.notes.iter().cloned();
    let of_spectrum = doubts::of_spectrum(&surface.psd).into_iter();
    of_material.chain(of_surface).chain(of_spectrum).collect()
}

/// Notes on a material and on maps of its surface, for all of which the steepest counts.
pub(crate) fn notes_on_maps(material: &Material, maps: &[Relief]) -> Vec<Remark> {
    let steepest = maps.iter().max_by(|one, other| one.rms_slope().total_cmp(&other.rms_slope()));
    steepest.map_or_else(Vec::new, |relief| notes_on_map(material, relief))
}

/// Notes on a material and on a map of its surface.
pub(crate) fn notes_on_map(material: &Material, relief: &Relief) -> Vec<Remark> {
    let Relief { rows, columns, length_x_m, length_y_m, .. } = relief;
    let spacing = [length_x_m / *columns as f64, length_y_m / *rows as f64];
    let of_spacing = doubts::of_spacing(spacing).filter(|_| *rows > 1);
    let doubts = doubts::of_bodies(material).into_iter().chain(doubts::of_slope(relief.rms_slope()));
    doubts.chain(of_spacing).collect()
}

/// Random surfaces with the spectrum in the band that the grid holds.
pub(crate) fn random_surfaces(
    surface: &Surface,
    random: &RandomInput,
    pressing: &Pressing,
) -> Result<(RandomSurfaces, Vec<Remark>), QuestionError> {
    pressing.check().map_err(ElementsError::from)?;
    let named = |error| QuestionError::RandomSurfaces { surface: surface.name.clone(), error };
    let area = AreaSpectrum::from_profile(&surface.psd).map_err(named)?;
    let (random, grid) = random.choices().surfaces(&area).map_err(named)?;
    let remarks = remarks_on_surfaces(&area, &random, &grid, pressing.contact_modulus_pa);
    Ok((random, remarks))
}

/// Remarks on surfaces made of a spectrum.
fn remarks_on_surfaces(
    spectrum: &AreaSpectrum,
    random: &RandomSurfaces,
    grid: &GridBand,
    contact_modulus_pa: f64,
) -> Vec<Remark> {
    let band = &random.band;
    let (longest_m, shortest_m) = (band.longest_m(), band.shortest_m());
    let gradient = band.mean_square_gradient().sqrt();
    let mut remarks = vec![
        Remark::new(RemarkCode::RandomSurfaces)
            .with("surfaces", random.realisations)
            .with("points", grid.points)
            .with("side_m", grid.length_m)
            .with("longest_m", longest_m)
            .with("shortest_m", shortest_m)
            .with("points_per_shortest", grid.points_per_shortest())
            .with("lengths", grid.lengths()),
        Remark::new(RemarkCode::RandomGradient)
            .with("gradient", gradient)
            .with("reduced_modulus_pa", contact_modulus_pa * gradient),
    ];
    let left_out = [
        (spectrum.longest_m() > 1.001 * longest_m).then(|| format!("above {}", length(longest_m))),
        (spectrum.shortest_m() < 0.999 * shortest_m).then(|| format!("below {}", length(shortest_m))),
    ];
    let left_out: Vec<String> = left_out.into_iter().flatten().collect();
    if !left_out.is_empty() {
        remarks.push(Remark::new(RemarkCode::WavesLeftOut).with("where", left_out.join(" and ")));
    }
    remarks.extend(doubts::of_conversion(spectrum.conversion()));
    if 0.5 * gradient > SMALL_SLOPE_PRESSURE {
        let steep = Remark::new(RemarkCode::SteepWaves).with("pressure_over_modulus", 0.5 * gradient);
        remarks.push(steep.with("bound", SMALL_SLOPE_PRESSURE));
    }
    remarks
}

/// Remarks on pressed surfaces: grids too coarse, residuals held by rounding, closed paths, and smaller loads that unload nothing.
pub(crate) fn remarks_on_pressed(loads: &[PressedLoad]) -> Vec<Remark> {
    let at = |code, is_found: &dyn Fn(&PressedLoad) -> bool| {
        let found: Vec<&PressedLoad> = loads.iter().filter(|load| is_found(load)).collect();
        let labels: Vec<String> = found.iter().map(|load| pressure(load.nominal_pressure_pa)).collect();
        let all = if found.len() == loads.len() { "every load".to_owned() } else { labels.join(", ") };
        (!found.is_empty()).then(|| Remark::new(code).with("loads", all))
    };
    let is_coarse = |load: &PressedLoad| {
        load.states.iter().all(|state| state.area_fraction_coarser.is_some()) && !load.shows_spots()
    };
    let coarse = at(RemarkCode::CoarseForSpots, &is_coarse);
    let is_rounded = |load: &PressedLoad| {
        load.states.iter().any(|state| state.numbers.ending == elements::half_space::Ending::Rounding)
    };
    let rounded = at(RemarkCode::RoundedResidual, &is_rounded);
    let is_unloaded = |pair: &[PressedLoad]| {
        let [before, after] = pair else { return false };
        after.nominal_pressure_pa < before.nominal_pressure_pa && before.mean().plastic_area_fraction > 0.0
    };
    let unloading = loads.windows(2).any(is_unloaded).then(|| Remark::new(RemarkCode::Unloading));
    let of_loads = coarse.into_iter().chain(rounded).chain(closed_paths(loads));
    of_loads.chain(unloading).collect()
}

/// Remarks on the compliance of the specimen that was taken out of the stiffness.
fn remarks_on_compliance(loads: &[PressedLoad], kind: SpecimenCompliance) -> Vec<Remark> {
    let code = match kind {
        SpecimenCompliance::None => return Vec::new(),
        SpecimenCompliance::Punch => RemarkCode::StiffnessWithoutPunch,
        SpecimenCompliance::Even => RemarkCode::StiffnessWithoutEven,
    };
    let of_map =
        |state: &PressedState| Remark::new(code).with("compliance_m_per_pa", state.compliance_m_per_pa);
    let is_gone = |load: &&PressedLoad| load.states.iter().any(|state| state.stiffness_pa_per_m.is_none());
    let gone: Vec<String> =
        loads.iter().filter(is_gone).map(|load| pressure(load.nominal_pressure_pa)).collect();
    let nothing =
        (!gone.is_empty()).then(|| Remark::new(RemarkCode::NoStiffnessLeft).with("loads", gone.join(", ")));
    loads.iter().take(1).flat_map(|load| load.states.iter().map(of_map)).chain(nothing).collect()
}

/// Note on the missing points of a map; `None` if it has none.
fn note_on_missing(map: &Relief) -> Result<Option<Remark>, QuestionError> {
    if map.is_missing.is_empty() {
        return Ok(None);
    }
    let outline = map.outline().map_err(ElementsError::from)?;
    let missing = map.is_missing.iter().filter(|is_missing| **is_missing).count();
    let outside = map.is_missing.len() - outline.points();
    let [length_x_m, length_y_m] = [map.length_x_m, map.length_y_m];
    Ok(Some(
        Remark::new(RemarkCode::MissingPointsOpen)
            .with("outside", outside)
            .with("holes", missing - outside)
            .with("share", outline.share())
            .with("length_x_m", length_x_m)
            .with("length_y_m", length_y_m),
    ))
}

/// The loads at which contact closes the paths from edge to edge; `None` if every surface is open in both directions.
fn closed_paths(loads: &[PressedLoad]) -> Option<Remark> {
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
    (!clauses.is_empty()).then(|| Remark::new(RemarkCode::ClosedPaths).with("paths", clauses.join("; ")))
}
