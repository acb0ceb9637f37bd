//! Options with a fixed list of names, used alike in messages, on the command line and in scene files.

use thiserror::Error;

/// A name that an option does not have.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("reading the {what}: '{given}' is not one of {accepted}")]
pub struct UnknownName {
    /// The option, such as `convention`.
    pub what: &'static str,
    /// The unknown name.
    pub given: String,
    /// The accepted names.
    pub accepted: String,
}

/// Gives a field-less enum its list of values `ALL`, its names, `Display` and `FromStr`.
#[macro_export]
macro_rules! named {
    ($type:ident, $what:literal, { $($variant:ident => $name:literal),+ $(,)? }) => {
        impl $type {
            /// All values.
            pub const ALL: &'static [Self] = &[$(Self::$variant),+];

            /// The name in messages, options and files.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),+ }
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }

        impl std::str::FromStr for $type {
            type Err = $crate::UnknownName;

            fn from_str(text: &str) -> Result<Self, Self::Err> {
                Self::ALL.iter().copied().find(|value| value.name() == text).ok_or_else(|| Self::Err {
                    what: $what,
                    given: text.to_owned(),
                    accepted: [$($name),+].join(", "),
                })
            }
        }
    };
}
