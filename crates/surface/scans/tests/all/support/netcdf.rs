//! A writer of NetCDF classic files.

/// A type that values are written in.
#[derive(Clone, Copy)]
pub enum Kind {
    I8,
    I16,
    F32,
    F64,
}

pub enum Attribute<'a> {
    Text(&'a str),
    Number(f64),
}

pub struct Variable<'a> {
    pub name: &'a str,
    pub dimensions: Vec<usize>,
    pub attributes: Vec<(&'a str, Attribute<'a>)>,
    pub kind: Kind,
    pub values: Vec<f64>,
}

/// A file; a dimension of length 0 is that of the records.
#[derive(Default)]
pub struct NetCdf<'a> {
    pub version: u8,
    pub records: u32,
    pub dimensions: Vec<(&'a str, usize)>,
    pub attributes: Vec<(&'a str, Attribute<'a>)>,
    pub variables: Vec<Variable<'a>>,
}

impl<'a> NetCdf<'a> {
    /// A map as contact.engineering writes it: x is the slow dimension; heights and lengths in µm.
    pub fn map(version: u8, kind: Kind, columns: usize, heights_m: &[f64]) -> Self {
        let rows = heights_m.len() / columns;
        let transposed = (0..columns).flat_map(|x| (0..rows).map(move |y| heights_m[y * columns + x] * 1e6));
        let axis = |name: &'a str, dimension: usize, points: usize, length: f64| Variable {
            name,
            dimensions: vec![dimension],
            attributes: vec![
                ("length", Attribute::Number(length)),
                ("periodic", Attribute::Number(1.0)),
                ("unit", Attribute::Text("um")),
            ],
            kind: Kind::F64,
            values: (0..points).map(|i| length * i as f64 / points as f64).collect(),
        };
        let heights = Variable {
            name: "heights",
            dimensions: vec![0, 1],
            attributes: vec![("unit", Attribute::Text("um"))],
            kind,
            values: transposed.collect(),
        };
        Self {
            version,
            dimensions: vec![("x", columns), ("y", rows)],
            variables: vec![heights, axis("x", 0, columns, 2.5), axis("y", 1, rows, 1.5)],
            ..Self::default()
        }
    }

    /// A line with one dimension of this name.
    pub fn line(dimension: &'a str, positions_um: Vec<f64>, heights_m: &[f64]) -> Self {
        let variable = |name, values, length| Variable {
            name,
            dimensions: vec![0],
            attributes: vec![("unit", Attribute::Text("um")), ("length", Attribute::Number(length))],
            kind: Kind::F64,
            values,
        };
        Self {
            version: 2,
            dimensions: vec![(dimension, heights_m.len())],
            variables: vec![
                variable("x", positions_um, 2.5),
                variable("heights", heights_m.iter().map(|height| height * 1e6).collect(), 0.0),
            ],
            ..Self::default()
        }
    }

    pub fn to_bytes(&self) -> Vec<u8> {
        let header = self.header(&vec![0; self.variables.len()]).len() as u64;
        let mut begins = Vec::new();
        let mut data = Vec::new();
        for variable in &self.variables {
            begins.push(header + data.len() as u64);
            let raw = variable.values.iter().flat_map(|&value| variable.kind.bytes(value));
            data.extend(raw);
            data.resize(data.len().next_multiple_of(4), 0);
        }
        let mut bytes = self.header(&begins);
        bytes.extend(data);
        bytes
    }

    fn header(&self, begins: &[u64]) -> Vec<u8> {
        let mut out = Out { bytes: b"CDF".to_vec(), is_cdf5: self.version == 5 };
        out.bytes.push(self.version);
        out.count(self.records as usize);
        out.list(10, self.dimensions.len());
        for (name, length) in &self.dimensions {
            out.padded(name.as_bytes());
            out.count(*length);
        }
        out.attributes(&self.attributes);
        out.list(11, self.variables.len());
        for (variable, begin) in self.variables.iter().zip(begins) {
            out.padded(variable.name.as_bytes());
            out.count(variable.dimensions.len());
            variable.dimensions.iter().for_each(|&index| out.count(index));
            out.attributes(&variable.attributes);
            out.u32(variable.kind.code());
            out.count(variable.values.len() * variable.kind.bytes(0.0).len());
            if self.version == 1 { out.u32(*begin as u32) } else { out.bytes.extend(begin.to_be_bytes()) }
        }
        out.bytes
    }
}

impl Kind {
    fn code(self) -> u32 {
        match self {
            Self::I8 => 1,
            Self::I16 => 3,
            Self::F32 => 5,
            Self::F64 => 6,
        }
    }

    fn bytes(self, value: f64) -> Vec<u8> {
        match self {
            Self::I8 => (value as i8).to_be_bytes().to_vec(),
            Self::I16 => (value as i16).to_be_bytes().to_vec(),
            Self::F32 => (value as f32).to_be_bytes().to_vec(),
            Self::F64 => value.to_be_bytes().to_vec(),
        }
    }
}

struct Out {
    bytes: Vec<u8>,
    is_cdf5: bool,
}

impl Out {
    fn u32(&mut self, value: u32) {
        self.bytes.extend(value.to_be_bytes());
    }

    fn count(&mut self, value: usize) {
        if self.is_cdf5 { self.bytes.extend((value as u64).to_be_bytes()) } else { self.u32(value as u32) }
    }

    fn list(&mut self, tag: u32, count: usize) {
        self.u32(if count == 0 { 0 } else { tag });
        self.count(count);
    }

    fn padded(&mut self, text: &[u8]) {
        self.count(text.len());
        self.bytes.extend(text);
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
    }

    fn attributes(&mut self, attributes: &[(&str, Attribute)]) {
        self.list(12, attributes.len());
        for (name, value) in attributes {
            self.padded(name.as_bytes());
            match value {
                Attribute::Text(text) => {
                    self.u32(2);
                    self.padded(text.as_bytes());
                }
                Attribute::Number(number) => {
                    self.u32(6);
                    self.count(1);
                    self.bytes.extend(number.to_be_bytes());
                }
            }
        }
    }
}
