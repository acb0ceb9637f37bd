//! Elements of the XML of a file, each with its path for messages.

use roxmltree::Node;

use super::axis::{Coordinate, ScanAxis};
use super::{FORMAT, INDEX};
use crate::archive::leads_outside;
use crate::error::{FilePlace, ScanReadError, quoted};
use crate::numbers;
use crate::raster::NumberType;

/// An element with its path, for messages.
pub(super) struct Element<'a, 'd> {
    pub(super) node: Node<'a, 'd>,
    pub(super) path: String,
}

impl<'a, 'd> Element<'a, 'd> {
    pub(super) fn child(&self, name: &str) -> Result<Self, ScanReadError> {
        let path = if self.path.is_empty() { name.to_owned() } else { format!("{}/{name}", self.path) };
        let node = self.node.children().find(|node| node.is_element() && node.tag_name().name() == name);
        let missing = || {
            FORMAT.missing(
                FilePlace::Element(if self.path.is_empty() { INDEX.to_owned() } else { self.path.clone() }),
                format!("element '{name}'"),
                "export the file again",
            )
        };
        Ok(Self { node: node.ok_or_else(missing)?, path })
    }

    pub(super) fn text(&self) -> &'a str {
        self.node.text().unwrap_or_default().trim()
    }

    pub(super) fn one_of(&self, name: &str, accepted: &[&str]) -> Result<&'a str, ScanReadError> {
        let child = self.child(name)?;
        let is_accepted = accepted.contains(&child.text());
        if is_accepted {
            Ok(child.text())
        } else {
            Err(child.bad(&accepted.join(" or "), "export the file otherwise"))
        }
    }

    pub(super) fn count(&self) -> Result<usize, ScanReadError> {
        numbers::count(self.text()).ok_or_else(|| self.bad("a whole number above 0", "export the file again"))
    }

    pub(super) fn number(&self) -> Result<f64, ScanReadError> {
        numbers::finite(self.text()).ok_or_else(|| self.bad("a finite number", "export the file again"))
    }

    pub(super) fn positive(&self) -> Result<f64, ScanReadError> {
        let number = self.number()?;
        if number > 0.0 { Ok(number) } else { Err(self.bad("above 0", "export the file again")) }
    }

    pub(super) fn axis(&self) -> Result<ScanAxis, ScanReadError> {
        match self.one_of("AxisType", &["I", "A"])? {
            "I" => Ok(ScanAxis::Even(self.child("Increment")?.positive()?)),
            _ => Ok(ScanAxis::Given(self.coordinate()?)),
        }
    }

    /// The type and scale of an axis whose values are in the data.
    ///
    /// Floating-point values are lengths in m: the schema of openGPS gives an increment to integers alone, and real
    /// files with one, of x3ptools, have their lengths without it.
    pub(super) fn coordinate(&self) -> Result<Coordinate, ScanReadError> {
        let kind = self.child("DataType")?;
        let stored = match kind.text() {
            "I" => NumberType::I16,
            "L" => NumberType::I32,
            "F" => NumberType::F32,
            "D" => NumberType::F64,
            _ => return Err(kind.bad("I, L, F or D", "export the file again")),
        };
        let is_integer = matches!(stored, NumberType::I16 | NumberType::I32);
        let increment = self.optional("Increment")?.filter(|_| is_integer).unwrap_or(1.0);
        if increment == 0.0 {
            return Err(self.child("Increment")?.bad("other than 0", "export the file again"));
        }
        Ok(Coordinate { number: stored, increment, offset: self.optional("Offset")?.unwrap_or(0.0) })
    }

    /// A note on an increment that floating-point values do not take.
    pub(super) fn unused_increment(&self) -> Result<Option<String>, ScanReadError> {
        let is_float = self.child("DataType").is_ok_and(|kind| ["F", "D"].contains(&kind.text()));
        let increment = self.optional("Increment")?.filter(|&increment| is_float && increment != 1.0);
        Ok(increment.map(|increment| {
            format!("heights are floating-point numbers in m: the increment {increment} of the file is not applied")
        }))
    }

    /// A number that may be left out, or left empty.
    fn optional(&self, name: &str) -> Result<Option<f64>, ScanReadError> {
        let child = self.child(name).ok().filter(|child| !child.text().is_empty());
        child.map(|child| child.number()).transpose()
    }

    /// The path of a file of the archive, given within its folder.
    pub(super) fn path_inside(&self, folder: &str) -> Result<String, ScanReadError> {
        let path = self.text().to_owned();
        if leads_outside(&path) {
            Err(ScanReadError::PathOutside { path })
        } else {
            Ok(format!("{folder}{path}"))
        }
    }

    pub(super) fn bad(&self, bound: &str, mend: &'static str) -> ScanReadError {
        FORMAT.bad(FilePlace::Element(self.path.clone()), "the text", quoted(self.text()), bound, mend)
    }
}
