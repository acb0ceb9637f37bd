//! A writer of X3P files.

use super::zip_file::{stored, zipped};

/// A surface or, with one row, a profile.
pub struct X3p<'h> {
    pub feature: &'h str,
    /// `I`, `L`, `F` or `D`.
    pub data_type: char,
    pub columns: usize,
    pub rows: usize,
    pub increment_m: f64,
    pub offset_m: f64,
    pub heights_m: &'h [f64],
    /// Positions in m, for profiles at uneven spacing.
    pub positions_m: Option<&'h [f64]>,
    /// One bit for each point, the lowest first.
    pub valid: Option<&'h [u8]>,
}

pub const SPACING_M: [f64; 2] = [0.25e-6, 0.5e-6];

impl<'h> X3p<'h> {
    pub fn surface(data_type: char, columns: usize, heights_m: &'h [f64]) -> Self {
        let is_integer = "IL".contains(data_type);
        Self {
            feature: "SUR",
            data_type,
            columns,
            rows: heights_m.len() / columns,
            increment_m: if is_integer { 1e-12 } else { 1.0 },
            offset_m: if is_integer { 5e-9 } else { 0.0 },
            heights_m,
            positions_m: None,
            valid: None,
        }
    }

    pub fn main_xml(&self) -> String {
        let Self { feature, data_type, columns, rows, increment_m, offset_m, .. } = self;
        let [dx, dy] = SPACING_M;
        let (x_type, x_kind) = if self.positions_m.is_some() { ("A", "D") } else { ("I", "L") };
        let valid =
            if self.valid.is_some() { "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>" } else { "" };
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n\
             <Record1><Revision>ISO5436 - 2000</Revision><FeatureType>{feature}</FeatureType><Axes>\n\
             <CX><AxisType>{x_type}</AxisType><DataType>{x_kind}</DataType><Increment>{}</Increment><Offset>0</Offset></CX>\n\
             <CY><AxisType>I</AxisType><DataType>L</DataType><Increment>{dy}</Increment><Offset>0</Offset></CY>\n\
             <CZ><AxisType>A</AxisType><DataType>{data_type}</DataType><Increment>{increment_m}</Increment>\
             <Offset>{offset_m}</Offset></CZ>\n</Axes></Record1>\n<Record3><MatrixDimension><SizeX>{columns}</SizeX>\
             <SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension><DataLink>\
             <PointDataLink>bindata/data.bin</PointDataLink>{valid}</DataLink></Record3>\n</p:ISO5436_2>\n",
            if self.positions_m.is_some() { 1.0 } else { dx },
        )
    }

    pub fn data(&self) -> Vec<u8> {
        let mut bytes = Vec::new();
        for (index, height_m) in self.heights_m.iter().enumerate() {
            bytes.extend(self.positions_m.iter().flat_map(|positions_m| positions_m[index].to_le_bytes()));
            let raw = (height_m - self.offset_m) / self.increment_m;
            match self.data_type {
                'I' => bytes.extend((raw.round() as i16).to_le_bytes()),
                'L' => bytes.extend((raw.round() as i32).to_le_bytes()),
                'F' => bytes.extend((raw as f32).to_le_bytes()),
                _ => bytes.extend(raw.to_le_bytes()),
            }
        }
        bytes
    }

    pub fn to_bytes(&self) -> Vec<u8> {
        let (index, data) = (self.main_xml(), self.data());
        let mut files = vec![("main.xml", index.as_bytes()), ("bindata/data.bin", data.as_slice())];
        files.extend(self.valid.map(|valid| ("bindata/valid.bin", valid)));
        if self.data_type == 'D' { stored(&files) } else { zipped(&files) }
    }
}
