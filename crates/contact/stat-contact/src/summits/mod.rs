//! Summits of a Gaussian surface, whose curvatures are spread as well as their heights (Nayak 1971), under Hertz's
//! ellipses (Bush, Gibson & Thomas 1975).
//!
//! [`nayak`] has their statistics, [`ellipticity`] the average over the difference of the two curvatures,
//! [`stretches`] the intervals of the integral over the mean curvature, and [`integrals`] the sums.

pub mod ellipticity;
pub mod integrals;
pub mod nayak;
pub mod stretches;
