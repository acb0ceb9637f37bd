//! A writer of Nanoscope files.

/// One image of a file.
pub struct Image<'h> {
    pub name: &'h str,
    pub direction: &'h str,
    /// Row after row from the top, in m.
    pub heights_m: &'h [f64],
}

/// A file with a scanner of 20 nm/V.
pub struct NanoscopeFile<'h> {
    pub version: u32,
    /// Value in the header, which sets the scale.
    pub bytes_per_pixel: usize,
    /// Bytes of the data.
    pub bytes_per_count: usize,
    pub columns: usize,
    pub rows: usize,
    /// As the header writes it.
    pub scan_size: &'h str,
    /// Lines between the scan list and the images.
    pub extra: &'h str,
    pub full_scale_v: f64,
    pub images: Vec<Image<'h>>,
}

pub const SENSITIVITY_M_PER_V: f64 = 20e-9;
const HEADER_BYTES: usize = 2048;

impl<'h> NanoscopeFile<'h> {
    /// A file of version 7 with 16-bit heights of up to some 10 nm.
    pub fn new(columns: usize, rows: usize, heights_m: &'h [f64]) -> Self {
        Self {
            version: 0x0720_0000,
            bytes_per_pixel: 2,
            bytes_per_count: 2,
            columns,
            rows,
            scan_size: "500 250 nm",
            extra: "",
            full_scale_v: 8.0,
            images: vec![Image { name: "Height", direction: "Trace", heights_m }],
        }
    }

    /// Height of one count in m.
    pub fn resolution_m(&self) -> f64 {
        self.full_scale_v / 256f64.powi(self.bytes_per_pixel as i32) * SENSITIVITY_M_PER_V
    }

    pub fn to_bytes(&self) -> Vec<u8> {
        let length = self.columns * self.rows * self.bytes_per_count;
        let mut text = format!(
            "\\*File list\r\n\\Version: 0x{:08X}\r\n\\Start context: OL2BIG\r\n\\*Scanner list\r\n\\@Sens. Zsens: V \
             20.00000 nm/V\r\n\\*Ciao scan list\r\n\\@Sens. Phase: V 1.000000 \r\n{}",
            self.version, self.extra
        );
        for (index, image) in self.images.iter().enumerate() {
            let offset = HEADER_BYTES + index * length;
            text += &format!(
                "\\*Ciao image list\r\n\\Data offset: {offset}\r\n\\Data length: {length}\r\n\\Bytes/pixel: {}\r\n\
                 \\Samps/line: {}\r\n\\Number of lines: {}\r\n\\Scan Size: {}\r\n\\Line Direction: {}\r\n\
                 \\@2:Image Data: S [{}] \"{}\"\r\n\\@2:Z scale: V [Sens. {}] (0.0001 V/LSB) {} V\r\n",
                self.bytes_per_pixel,
                self.columns,
                self.rows,
                self.scan_size,
                image.direction,
                image.name,
                image.name,
                if image.name == "Phase" { "Phase" } else { "Zsens" },
                self.full_scale_v,
            );
        }
        text += "\\*File list end\r\n\x1a";
        let mut bytes = text.into_bytes();
        assert!(bytes.len() <= HEADER_BYTES);
        bytes.resize(HEADER_BYTES, 0);
        for image in &self.images {
            for row in image.heights_m.chunks(self.columns).rev() {
                for height_m in row {
                    let count = (height_m / self.resolution_m()).round() as i32;
                    bytes.extend(&count.to_le_bytes()[..self.bytes_per_count]);
                }
            }
        }
        bytes
    }
}
