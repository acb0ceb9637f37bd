//! `index.json` and `meta.yml`: the measurements of a container, with their metadata.

use serde_json::Value;

use crate::error::{FilePlace, ScanReadError};
use crate::format::ScanFormat;
use crate::metadata::{MeasurementMetadata, file_name, instrument_length_m, probe};
use units::LengthUnit;

/// Reads the text of a container's `index.json` (JSON) or `meta.yml` (YAML), which `file` names.
///
/// [`MeasurementMetadata::names_file`] finds the entry of a data file, to be given to
/// [`ScanOptions::metadata`](crate::ScanOptions::metadata) where both lie side by side.
///
/// ```
/// # fn main() -> Result<(), scans::ScanReadError> {
/// let text = "surfaces:\n- topographies:\n  - name: line\n    datafile: {original: line.txt}\n    size: [2.5]\n    unit: mm\n";
/// let measurements = scans::read_metadata(text, "meta.yml")?;
/// let entry = measurements.iter().find(|entry| entry.names_file("scans/line.txt")).expect("it is there");
/// assert_eq!((entry.name.as_str(), entry.sizes[0]), ("line", 2.5));
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// [`ScanReadError::Syntax`] with the line, [`ScanReadError::BadField`] or [`ScanReadError::MissingField`] with the
/// path of the element.
pub fn read_metadata(text: &str, file: &str) -> Result<Vec<MeasurementMetadata>, ScanReadError> {
    let syntax = |problem: String| ScanReadError::Syntax { file: file_name(file).to_owned(), problem };
    let text = text.trim_start_matches('\u{feff}');
    let index: Value = if text.trim_start().starts_with('{') {
        serde_json::from_str(text).map_err(|error| syntax(error.to_string()))?
    } else {
        // The first line of the message has the place; the lines after it quote the file.
        let first_line =
            |error: String| error.lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned();
        serde_saphyr::from_str(text).map_err(|error| syntax(first_line(error.to_string())))?
    };
    let mut measurements = Vec::new();
    for (i, surface) in list(&index, "surfaces", "")?.iter().enumerate() {
        let path = format!("surfaces[{i}]");
        let surface_name = surface.get("name").and_then(Value::as_str);
        for (j, entry) in list(surface, "topographies", &path)?.iter().enumerate() {
            let entry = Entry { value: entry, path: format!("{path}.topographies[{j}]") };
            measurements.push(entry.read(surface_name)?);
        }
    }
    Ok(measurements)
}

fn list<'v>(value: &'v Value, name: &str, path: &str) -> Result<&'v [Value], ScanReadError> {
    let list = value.get(name).and_then(Value::as_array);
    list.map(Vec::as_slice).ok_or_else(|| {
        ScanFormat::Container.missing(
            if path.is_empty() { FilePlace::File } else { FilePlace::Element(path.to_owned()) },
            format!("list '{name}'"),
            "download the container again",
        )
    })
}

/// One of the topographies.
struct Entry<'v> {
    value: &'v Value,
    path: String,
}

impl Entry<'_> {
    fn read(&self, surface: Option<&str>) -> Result<MeasurementMetadata, ScanReadError> {
        let data_file = |key: &str| self.value.get("datafile")?.get(key)?.as_str().map(str::to_owned);
        let (original, squeezed) = (data_file("original"), data_file("squeezed-netcdf"));
        let name = self.get("name").and_then(Value::as_str).map(str::to_owned);
        let name = name
            .or_else(|| original.as_deref().or(squeezed.as_deref()).map(|path| file_name(path).to_owned()));
        let unit = self.get("unit").map(|unit| {
            let parsed = unit.as_str().and_then(LengthUnit::parse_instrument);
            parsed.ok_or_else(|| self.bad("unit", unit, &format!("one of {}", LengthUnit::accepted())))
        });
        let height_scale = self.get("height_scale").map(|scale| {
            let number = scale.as_f64().filter(|scale| scale.is_finite() && *scale != 0.0);
            number.ok_or_else(|| self.bad("height_scale", scale, "a finite number other than 0"))
        });
        let is_periodic = self
            .get("is_periodic")
            .map(|flag| flag.as_bool().ok_or_else(|| self.bad("is_periodic", flag, "true or false")));
        let data_source = self.get("data_source").map(|source| {
            let index = source.as_u64().and_then(|index| usize::try_from(index).ok());
            index.ok_or_else(|| self.bad("data_source", source, "a whole number from 0 on"))
        });
        Ok(MeasurementMetadata {
            surface: surface.map(str::to_owned),
            name: name.unwrap_or_else(|| self.path.clone()),
            original,
            squeezed,
            sizes: self.sizes()?,
            unit: unit.transpose()?,
            height_scale: height_scale.transpose()?,
            is_periodic: is_periodic.transpose()?,
            data_source: data_source.transpose()?,
            probe: probe(self.value),
            tip_radius_m: instrument_length_m(self.value, "tip_radius"),
            resolution_m: instrument_length_m(self.value, "resolution"),
            description: self.get("description").and_then(Value::as_str).map(str::to_owned),
        })
    }

    fn sizes(&self) -> Result<Vec<f64>, ScanReadError> {
        let Some(value) = self.get("size") else { return Ok(Vec::new()) };
        let list = value.as_array().map_or(std::slice::from_ref(value), Vec::as_slice);
        let length = |size: &Value| size.as_f64().filter(|size| size.is_finite() && *size > 0.0);
        let sizes: Option<Vec<f64>> = list.iter().map(length).collect();
        let sizes = sizes.filter(|sizes| sizes.len() <= 2);
        sizes.ok_or_else(|| self.bad("size", value, "one or two finite numbers above 0"))
    }

    /// A field that is there and not null.
    fn get(&self, key: &str) -> Option<&Value> {
        self.value.get(key).filter(|value| !value.is_null())
    }

    fn bad(&self, field: &str, value: &Value, bound: &str) -> ScanReadError {
        ScanFormat::Container.bad(
            FilePlace::Element(self.path.clone()),
            format!("'{field}'"),
            value.to_string().chars().take(60).collect::<String>(),
            bound,
            "correct it, or download the container again",
        )
    }
}
