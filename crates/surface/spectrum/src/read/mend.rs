//! Options with which a caller can fix an error.

/// A fix for an error by an option. Deliberately not `#[non_exhaustive]`: every front end must word every variant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadMend {
    /// Give all of these options, at least one, for what the file does not state.
    Give(Vec<Wanted>),
    /// Give the option another value.
    Correct(ReadOption),
    /// Leave out the option, because the file states it.
    LeaveOut(ReadOption),
}

/// An option to give, with suitable values.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// The option.
    pub option: ReadOption,
    /// Suitable values (for units only examples); empty if the value is a name in the file.
    pub values: Vec<String>,
}

/// A field of [`ReadOptions`](crate::ReadOptions).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadOption {
    /// Name of the column of the spectrum.
    Column,
    /// Convention of the spectrum.
    Convention,
    /// Quantity of the first column.
    X,
    /// Name of the series.
    Series,
    /// Name of the subject of the series.
    Subject,
    /// Unit of the abscissa.
    XUnit,
    /// Unit of the spectrum.
    PsdUnit,
}

impl ReadOption {
    /// The key of the option in scenes and in Python, e.g. `x_unit`.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            ReadOption::Column => "column",
            ReadOption::Convention => "convention",
            ReadOption::X => "x",
            ReadOption::Series => "series",
            ReadOption::Subject => "subject",
            ReadOption::XUnit => "x_unit",
            ReadOption::PsdUnit => "psd_unit",
        }
    }

    /// Asks for this option with a name from the file.
    pub(crate) fn name_in_file(self) -> Wanted {
        Wanted { option: self, values: Vec::new() }
    }

    /// Asks for this option with one of these values.
    pub(crate) fn one_of(self, values: impl IntoIterator<Item = impl ToString>) -> Wanted {
        Wanted { option: self, values: values.into_iter().map(|value| value.to_string()).collect() }
    }
}
