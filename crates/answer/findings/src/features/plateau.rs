//! Plateaus: level stretches of a curve.

use std::collections::VecDeque;

use super::Point;

/// A stretch of a curve that hardly changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plateau {
    /// Its longest wavelength \[m\].
    pub longest_m: f64,
    /// Its shortest wavelength \[m\].
    pub shortest_m: f64,
    /// The lowest value on it.
    pub lowest: f64,
    /// The highest value on it.
    pub highest: f64,
}

impl Plateau {
    /// Its width in decades of wavelength.
    pub fn decades(&self) -> f64 {
        (self.longest_m / self.shortest_m).log10()
    }
}

/// The stretch, widest in decades, over which the highest value of a curve is at most `factor` >= 1 times the lowest; of
/// equally wide ones that of the longest wavelengths. `None` of no points.
pub fn widest_plateau(curve: &[Point], factor: f64) -> Option<Plateau> {
    let mut widest: Option<Plateau> = None;
    let mut begin = 0;
    // The points from `begin` on that are lower, and higher, than all that follow: their fronts are the extremes.
    let (mut lowest, mut highest) = (VecDeque::new(), VecDeque::new());
    for (end, &(shortest_m, value)) in curve.iter().enumerate() {
        push(&mut lowest, end, |other: usize| curve[other].1 >= value);
        push(&mut highest, end, |other: usize| curve[other].1 <= value);
        while curve[highest[0]].1 > factor * curve[lowest[0]].1 {
            begin += 1;
            for extremes in [&mut lowest, &mut highest] {
                if extremes[0] < begin {
                    extremes.pop_front();
                }
            }
        }
        let plateau = Plateau {
            longest_m: curve[begin].0,
            shortest_m,
            lowest: curve[lowest[0]].1,
            highest: curve[highest[0]].1,
        };
        if widest.is_none_or(|widest| plateau.decades() > widest.decades()) {
            widest = Some(plateau);
        }
    }
    widest
}

fn push(extremes: &mut VecDeque<usize>, at: usize, surpassed: impl Fn(usize) -> bool) {
    while extremes.back().is_some_and(|&other| surpassed(other)) {
        extremes.pop_back();
    }
    extremes.push_back(at);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_widest_level_stretch_is_found() {
        let curve = [
            (1e-2, 9.0),
            (1e-3, 4.0),
            (1e-4, 4.2),
            (1e-5, 4.1),
            (1e-6, 2.0),
            (5e-7, 2.0),
            (2e-7, 2.0),
            (1e-7, 2.0),
        ];
        let found = widest_plateau(&curve, 1.05).unwrap();
        let expected = Plateau { longest_m: 1e-3, shortest_m: 1e-5, lowest: 4.0, highest: 4.2 };
        assert_eq!(found, expected);
        assert!((found.decades() - 2.0).abs() < 1e-12);
        assert_eq!(widest_plateau(&curve, 1.0).unwrap().longest_m, 1e-6);
        assert_eq!(widest_plateau(&curve, 10.0).unwrap().shortest_m, 1e-7);
    }

    #[test]
    fn a_curve_without_a_level_stretch_has_one_of_no_width() {
        assert_eq!(widest_plateau(&[(1.0, 1.0), (0.1, 5.0)], 1.5).unwrap().decades(), 0.0);
        assert_eq!(widest_plateau(&[], 1.5), None);
    }

    #[test]
    fn every_stretch_is_tried() {
        // Against the definition, on a curve without order.
        let value = |i: u32| 1.0 + f64::from(i * 7919 % 101) / 100.0;
        let curve: Vec<Point> = (0..60).map(|i| (10f64.powf(-f64::from(i * i) / 500.0), value(i))).collect();
        let level = |stretch: &[Point]| {
            let values = || stretch.iter().map(|(_, value)| *value);
            values().fold(0.0, f64::max) <= 1.4 * values().fold(f64::INFINITY, f64::min)
        };
        let mut widest = 0.0f64;
        for begin in 0..60 {
            for end in begin..60 {
                if level(&curve[begin..=end]) {
                    widest = widest.max((curve[begin].0 / curve[end].0).log10());
                }
            }
        }
        assert_eq!(widest_plateau(&curve, 1.4).unwrap().decades(), widest);
    }
}
