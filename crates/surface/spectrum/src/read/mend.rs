//! What a caller can do about an error with an option.

/// A way out of an error; front ends know what the options are called there, and have words for all of these.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadMend {
    /// Give what the file does not tell: all of these, at least one.
    Give(Vec<Wanted>),
    /// Give it as another text.
    Correct(ReadOption),
    /// Leave out what the file tells itself.
    LeaveOut(ReadOption),
}

/// An option to give, and what may be given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// The option.
    pub option: ReadOption,
    /// Values that would do, of units not all of them; none where it is a name that stands in the file.
    pub values: Vec<String>,
}

/// A field of [`ReadOptions`](crate::ReadOptions). Whoever has names has one for each: a match on them is whole.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReadOption {
    /// Which column is the spectrum.
    Column,
    /// The convention of the spectrum.
    Convention,
    /// What the first column holds.
    X,
    /// Which series is read.
    Series,
    /// Whose series is read.
    Subject,
    /// The unit of the abscissa.
    XUnit,
    /// The unit of the spectrum.
    PsdUnit,
}

impl ReadOption {
    /// The option as one to give a name to that stands in the file.
    pub(crate) fn name_in_file(self) -> Wanted {
        Wanted { option: self, values: Vec::new() }
    }

    /// The option as one to give one of these values.
    pub(crate) fn one_of(self, values: impl IntoIterator<Item = impl ToString>) -> Wanted {
        Wanted { option: self, values: values.into_iter().map(|value| value.to_string()).collect() }
    }
}
