//! Comparison with tolerance, field by field.

/// Implements `AbsDiffEq` and `RelativeEq` for a struct of `f64` fields.
///
/// The default absolute tolerance is zero: next to SI values of nanometre surfaces any fixed tolerance is enormous.
macro_rules! approximate {
    ($type:ident { $($field:ident),+ }) => {
        impl approx::AbsDiffEq for $type {
            type Epsilon = f64;

            fn default_epsilon() -> f64 {
                0.0
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
                $(f64::abs_diff_eq(&self.$field, &other.$field, epsilon))&&+
            }
        }

        impl approx::RelativeEq for $type {
            fn default_max_relative() -> f64 {
                f64::EPSILON
            }

            fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
                $(f64::relative_eq(&self.$field, &other.$field, epsilon, max_relative))&&+
            }
        }
    };
}
pub(crate) use approximate;
