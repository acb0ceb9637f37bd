//! Bytes of a file put together field by field.

/// A file in the making. Numbers carry their own byte order: `bytes.put(7u16.to_le_bytes())`.
#[derive(Default, Clone)]
pub struct Bytes(pub Vec<u8>);

impl Bytes {
    pub fn put(&mut self, bytes: impl AsRef<[u8]>) -> &mut Self {
        self.0.extend_from_slice(bytes.as_ref());
        self
    }

    /// A text in a field of so many bytes, the rest of which are zero.
    pub fn text(&mut self, text: &str, bytes: usize) -> &mut Self {
        assert!(text.len() <= bytes, "{text} takes more than {bytes} bytes");
        self.put(text).zeros(bytes - text.len())
    }

    pub fn zeros(&mut self, bytes: usize) -> &mut Self {
        self.0.resize(self.0.len() + bytes, 0);
        self
    }

    /// Zero bytes up to this length of the file.
    pub fn pad_to(&mut self, length: usize) -> &mut Self {
        assert!(self.0.len() <= length, "{} bytes are there already", self.0.len());
        self.0.resize(length, 0);
        self
    }
}
