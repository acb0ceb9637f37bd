//! The plan of a scene, computed for draws of its inputs.

use std::num::NonZeroU32;
use std::sync::OnceLock;

use scene::Scene;
use study::Unobserved;
use study::models::CurveModel;
use study::plan::{
    Curve, CurveResult, Cutoffs, Distinct, Load, Needs, Plan, PreparedSpectrum, Results, Sampling, Tolerance,
    Work,
};

use spectrum::ProfilePsd;

/// Cutoffs a decade at which statistical curves are followed in draws, for bands.
const STATES_PER_DECADE: u32 = 4;

/// The relative tolerance of statistical states in draws, far below the error of any number of draws.
const TOLERANCE: f64 = 1e-6;

/// An area along the cutoff.
pub(crate) type Points = Vec<(f64, f64)>;

/// The scene's curves under its loads, to be computed for many spectra and materials.
#[derive(Debug)]
pub(crate) struct Areas {
    /// The curves and loads that differ; names and repetitions need nothing new in a draw.
    needs: Needs,
    /// The curves of the scene, and the place of each among those that differ.
    pub curves: Vec<Curve>,
    curve_at: Vec<usize>,
    /// The place of each load of the scene among those that differ.
    load_at: Vec<usize>,
    sampling: Sampling,
    /// The prepared spectrum of the scene, for draws that keep it.
    prepared: PreparedSpectrum,
    /// The final areas of the scene itself, for curves that a draw of the bodies does not change.
    plain: OnceLock<Vec<Vec<Option<f64>>>>,
}

/// The areas of a draw.
#[derive(Debug, Clone)]
pub(crate) struct DrawnAreas {
    /// ln A of every curve under every load, curve by curve; `None` without an area.
    pub ln_areas: Vec<Option<f64>>,
    /// The work that it took.
    pub work: Work,
}

impl Areas {
    pub fn new(scene: &Scene, results: &Results) -> Self {
        let own = &scene.needs;
        let curves = Distinct::compared(own.curves.iter().map(|curve| (&curve.model, curve.cutoffs)));
        let curve = |(model, cutoffs): (&CurveModel, Cutoffs)| Curve {
            name: String::new(),
            model: model.clone(),
            cutoffs,
        };
        let loads = Distinct::compared(own.loads.iter().map(|load| load.nominal_pressure));
        let load = |nominal_pressure| Load { nominal_pressure, label: String::new() };
        let needs = Needs {
            moments: own.moments,
            amplitudes: own.amplitudes,
            curves: curves.items.into_iter().map(curve).collect(),
            loads: loads.items.into_iter().map(load).collect(),
            tolerance: Tolerance::new(own.tolerance.value().max(TOLERANCE)).unwrap_or(own.tolerance),
            areas_alone: true,
            ..Needs::default()
        };
        Areas {
            needs,
            curves: own.curves.clone(),
            curve_at: curves.index_of,
            load_at: loads.index_of,
            sampling: scene.sampling,
            prepared: PreparedSpectrum::from_results(results),
            plain: OnceLock::new(),
        }
    }

    /// The curves that differ, which draws compute.
    pub fn distinct_curves(&self) -> &[Curve] {
        &self.needs.curves
    }

    /// The number of loads of the scene.
    pub fn loads(&self) -> usize {
        self.load_at.len()
    }

    /// Places of a curve and a load of the scene among those that differ: the same areas have the same places.
    pub fn place(&self, curve: usize, load: usize) -> (usize, usize) {
        (self.curve_at[curve], self.load_at[load])
    }

    /// The curve and the load of an area of a draw.
    pub fn curve_and_load(&self, area: usize) -> (usize, usize) {
        (area / self.loads(), area % self.loads())
    }

    /// Maps all areas of a draw, once for those of one place.
    pub fn map_distinct<T: Clone + Send>(&self, map: impl Fn(usize) -> T + Sync) -> Vec<T> {
        let place = |area: usize| {
            let (curve, load) = self.curve_and_load(area);
            self.place(curve, load)
        };
        map_distinct(self.count(), place, map)
    }

    /// Hands a value of each curve and load that differ out to all curves and loads of the scene, curve by curve.
    fn handed_out<T: Clone>(&self, values: &[Vec<T>]) -> Vec<Vec<T>> {
        let of_curve =
            |&curve: &usize| self.load_at.iter().map(|&load| values[curve][load].clone()).collect();
        self.curve_at.iter().map(of_curve).collect()
    }

    /// The cutoff that the scene sets \[m\].
    pub fn cutoff_m(&self) -> Option<f64> {
        self.sampling.cutoff_m
    }

    /// The number of areas of a draw.
    pub fn count(&self) -> usize {
        self.curves.len() * self.loads()
    }

    /// The final areas of a spectrum (the scene's own if `None`) and of the curves that differ, with these bodies. A model
    /// out of its range has no area.
    pub fn at_the_end(&self, psd: Option<&ProfilePsd>, curves: Vec<Curve>) -> DrawnAreas {
        let found = match psd {
            Some(psd) => self.ends_on(psd, curves).map(|(drawn, _)| drawn),
            None => self.ends_with(curves),
        };
        found.unwrap_or_else(|| self.nothing())
    }

    /// The final areas of a spectrum and of the curves that differ, with the results that they come from.
    pub fn ends_on(&self, psd: &ProfilePsd, curves: Vec<Curve>) -> Option<(DrawnAreas, Results)> {
        let results = self.results(Some(psd), curves, Cutoffs::Shortest)?;
        let ln_areas = self.handed_out(&self.of_all(&results, ln_end)).concat();
        Some((DrawnAreas { ln_areas, work: results.work }, results))
    }

    /// The final areas of the scene's own spectrum. Curves that have the scene's own bodies are computed once for all draws.
    fn ends_with(&self, curves: Vec<Curve>) -> Option<DrawnAreas> {
        let are_own: Vec<bool> =
            curves.iter().zip(&self.needs.curves).map(|(curve, own)| curve.model == own.model).collect();
        let moved = curves.into_iter().zip(&are_own).filter(|(_, is_own)| !**is_own).map(|(curve, _)| curve);
        let results = self.results(None, moved.collect(), Cutoffs::Shortest)?;
        let mut of_moved = self.of_all(&results, ln_end).into_iter();
        let own = are_own.iter().any(|is_own| *is_own).then(|| self.plain());
        let of_curve = |(at, is_own): (usize, &bool)| match own.filter(|_| *is_own) {
            Some(own) => own.get(at).cloned(),
            None => of_moved.next(),
        };
        let values: Option<Vec<Vec<Option<f64>>>> = are_own.iter().enumerate().map(of_curve).collect();
        Some(DrawnAreas { ln_areas: self.handed_out(&values?).concat(), work: results.work })
    }

    /// ln A of every curve and load that differ, for the scene itself.
    fn plain(&self) -> &[Vec<Option<f64>>] {
        let compute = || {
            let results = self.results(None, self.needs.curves.clone(), Cutoffs::Shortest);
            results.map(|results| self.of_all(&results, ln_end)).unwrap_or_default()
        };
        self.plain.get_or_init(compute)
    }

    /// The areas of a draw that has none.
    pub fn nothing(&self) -> DrawnAreas {
        DrawnAreas { ln_areas: vec![None; self.count()], work: Work::default() }
    }

    /// The areas along the cutoff, at a few cutoffs per decade: for every curve and load that differ ([`Areas::place`]), points of
    /// cutoff \[m\] and area fraction.
    pub fn along(&self, psd: Option<&ProfilePsd>, curves: Vec<Curve>) -> Option<(Vec<Vec<Points>>, Work)> {
        let results = self.results(psd, curves, Cutoffs::Every)?;
        Some((self.of_all(&results, |curve, load| curve.area_fractions(load)), results.work))
    }

    /// Takes a value of each curve and load that differ.
    fn of_all<T>(&self, results: &Results, value: impl Fn(&CurveResult, usize) -> T) -> Vec<Vec<T>> {
        let of_curve =
            |curve: &CurveResult| (0..self.needs.loads.len()).map(|load| value(curve, load)).collect();
        results.curves.iter().map(of_curve).collect()
    }

    fn results(&self, psd: Option<&ProfilePsd>, curves: Vec<Curve>, cutoffs: Cutoffs) -> Option<Results> {
        let at_cutoffs = |curve: Curve| Curve { cutoffs, ..curve };
        let curves = curves.into_iter().map(at_cutoffs).collect();
        let states_per_decade = NonZeroU32::new(STATES_PER_DECADE);
        let needs = Needs { curves, states_per_decade, ..self.needs.clone() };
        let psd_of_plan = psd.unwrap_or(&self.prepared.psd);
        let plan = Plan { psd: psd_of_plan, sampling: self.sampling, needs };
        match psd {
            Some(_) => plan.compute().ok(),
            None => plan.compute_on(self.prepared.clone(), &Unobserved).ok(),
        }
    }
}

/// ln A at the last cutoff of a curve.
fn ln_end(curve: &CurveResult, load: usize) -> Option<f64> {
    let (_, area_fraction) = *curve.area_fractions(load).last()?;
    (area_fraction > 0.0).then(|| area_fraction.ln())
}

/// Maps the numbers below `count`, once for those of one place: curves and loads may repeat under other names.
pub(crate) fn map_distinct<T: Clone + Send>(
    count: usize,
    place: impl Fn(usize) -> (usize, usize),
    map: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    let distinct = Distinct::by_key(0..count, |&at| place(at));
    let found = numerics::parallel::map(&distinct.items, |&at| map(at));
    distinct.index_of.into_iter().map(|at| found[at].clone()).collect()
}
