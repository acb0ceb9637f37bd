//! What a quadrature needs to know of a population's law: its smooth pieces, and its values on them.

/// What a population answers if every asperity were pressed to the same interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Response {
    /// eta F \[Pa\].
    pub pressure_pa: f64,
    /// eta A.
    pub area_fraction: f64,
}

/// What a law answers at the points of a chart, a row for each quantity.
pub(crate) struct Points<'a> {
    pub interferences_m: &'a mut [f64],
    /// Derivative of the interference by the coordinate.
    pub slopes_m: &'a mut [f64],
    /// eta F \[Pa\] and eta A.
    pub pressures_pa: &'a mut [f64],
    pub area_fractions: &'a mut [f64],
}

/// The coordinate in which a piece of a law is smooth up to its ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Chart {
    /// The quadrature's own coordinate of the interference, good for powers of it.
    Interference,
    /// Of a sinusoid from first touch on.
    SineLight,
    /// Of a sinusoid towards complete contact.
    SineHeavy,
    /// Of a yielding sinusoid, its pressure explicit: from the onset of plastic flow on.
    FlowLight,
    /// The same towards complete contact.
    FlowHeavy,
    /// Of tabulated pressures: below the first, between two of them, and above the last.
    TableLight,
    Table,
    TableHeavy,
}

/// An interval of interferences \[m\] on which a law is smooth in the coordinate of `chart`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Piece {
    pub from_m: f64,
    pub to_m: f64,
    pub chart: Chart,
}

/// A population under a contact law.
pub(crate) trait Asperities: std::fmt::Debug + Send + Sync {
    /// The response at an interference > 0 \[m\].
    fn at_interference(&self, interference_m: f64) -> Response;

    /// The responses \[Pa, 1\] at interferences > 0 \[m\] that no break of the law divides.
    fn at_interferences(
        &self,
        interferences_m: &[f64],
        pressures_pa: &mut [f64],
        area_fractions: &mut [f64],
    ) {
        for ((w, pressure_pa), area_fraction) in interferences_m.iter().zip(pressures_pa).zip(area_fractions)
        {
            let response = self.at_interference(*w);
            (*pressure_pa, *area_fraction) = (response.pressure_pa, response.area_fraction);
        }
    }

    /// The responses' pressures \[Pa\] alone, at interferences > 0 \[m\] wherever the breaks are.
    fn pressures_at_interferences(&self, interferences_m: &[f64], pressures_pa: &mut [f64]) {
        for (w, pressure_pa) in interferences_m.iter().zip(pressures_pa) {
            *pressure_pa = self.at_interference(*w).pressure_pa;
        }
    }

    /// Hertz's law, where asperities follow it at first.
    fn hertzian(&self) -> Option<Hertzian> {
        None
    }

    /// The smooth pieces that cover the interferences from `low_m` to `high_m`, in rising order; those outside may be
    /// left out. The last one ends at infinity or where [`saturation`](Self::saturation) begins.
    fn pieces(&self, low_m: f64, high_m: f64) -> Vec<Piece>;

    /// The interference from which on the response no longer changes, and that response.
    fn saturation(&self) -> Option<(f64, Response)> {
        None
    }

    /// The interference \[m\] of the kink that shows most, where one stands out: complete contact.
    fn strongest_kink_m(&self) -> Option<f64> {
        self.saturation().map(|(from_m, _)| from_m)
    }

    /// The coordinate, on a chart of this law other than [`Chart::Interference`], of an interference.
    fn coordinate(&self, chart: Chart, _interference_m: f64) -> f64 {
        unreachable!("the law has no chart {chart:?}")
    }

    /// The points at coordinates of a chart of this law other than [`Chart::Interference`], that no break of the law
    /// divides.
    fn at_coordinates(&self, chart: Chart, _coordinates: &[f64], _points: Points<'_>) {
        unreachable!("the law has no chart {chart:?}")
    }

    /// The intervals of interference \[m\], below `high_m`, in which the law is used beyond what it was fitted to.
    fn out_of_fitted_range(&self, _high_m: f64) -> Vec<(f64, f64)> {
        Vec::new()
    }

    /// The largest eta F \[Pa\] at any interference, infinite where it grows without end.
    fn highest_response_pa(&self) -> f64 {
        f64::INFINITY
    }

    /// How the force goes with the interference, seen through a Gaussian of standard deviation `sigma_s_m`.
    fn course(&self, _sigma_s_m: f64) -> Course {
        Course::Rises
    }

    /// For a force that rises on the whole: interferences \[m\] between which it falls smoothly, where it does.
    fn dip_m(&self) -> Option<[f64; 2]> {
        None
    }

    /// For a force with a maximum: an interference \[m\] from which on it certainly falls.
    fn falls_from_m(&self) -> Option<f64> {
        None
    }
}

/// A population that is Hertz's at small interferences.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hertzian {
    /// The interference \[m\] up to which every asperity is.
    pub until_m: f64,
    /// The area fraction per interference \[1/m\].
    pub area_per_m: f64,
    /// eta F per interference^(3/2) \[Pa/m^1.5\].
    pub pressure_per_three_halves: f64,
}

/// How a force goes with the interference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Course {
    /// It never falls.
    Rises,
    /// It rises to a maximum and falls from there on. `certain` unless further maxima may follow, which are not looked for.
    Peaks { certain: bool },
    /// It steps down at one interference \[m\] and rises elsewhere.
    StepsDown { at_m: f64 },
}

/// The pieces between neighbouring breaks, all on one chart.
pub(crate) fn pieces_between(breaks_m: &[f64], chart: Chart) -> Vec<Piece> {
    breaks_m
        .windows(2)
        .filter(|pair| pair[0] < pair[1])
        .map(|pair| Piece { from_m: pair[0], to_m: pair[1], chart })
        .collect()
}
