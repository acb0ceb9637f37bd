//! A writer of TIFF files: pages of tags.

/// A tag with its value.
#[derive(Clone)]
pub struct Tag {
    pub number: u16,
    kind: u16,
    count: u32,
    value: Vec<u8>,
}

impl Tag {
    pub fn short(number: u16, value: u16) -> Self {
        Self { number, kind: 3, count: 1, value: value.to_le_bytes().to_vec() }
    }

    pub fn long(number: u16, value: u32) -> Self {
        Self { number, kind: 4, count: 1, value: value.to_le_bytes().to_vec() }
    }

    pub fn longs(number: u16, values: &[u32]) -> Self {
        let value = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        Self { number, kind: 4, count: values.len() as u32, value }
    }

    pub fn double(number: u16, value: f64) -> Self {
        Self { number, kind: 12, count: 1, value: value.to_le_bytes().to_vec() }
    }

    pub fn text(number: u16, text: &str) -> Self {
        let value = [text.as_bytes(), b"\0"].concat();
        Self { number, kind: 2, count: value.len() as u32, value }
    }

    pub fn bytes(number: u16, value: Vec<u8>) -> Self {
        Self { number, kind: 7, count: value.len() as u32, value }
    }
}

/// A little-endian file of these pages; values of more than four bytes stand behind the tags of their page.
pub fn tiff(pages: &[Vec<Tag>]) -> Vec<u8> {
    let mut bytes = b"II*\0".to_vec();
    bytes.extend(8u32.to_le_bytes());
    for (index, tags) in pages.iter().enumerate() {
        let mut place = bytes.len() + 2 + 12 * tags.len() + 4;
        bytes.extend((tags.len() as u16).to_le_bytes());
        let mut values: Vec<u8> = Vec::new();
        for tag in tags {
            bytes.extend(tag.number.to_le_bytes());
            bytes.extend(tag.kind.to_le_bytes());
            bytes.extend(tag.count.to_le_bytes());
            if tag.value.len() <= 4 {
                let mut value = tag.value.clone();
                value.resize(4, 0);
                bytes.extend(value);
            } else {
                bytes.extend((place as u32).to_le_bytes());
                place += tag.value.len();
                values.extend(&tag.value);
            }
        }
        let next = if index + 1 < pages.len() { place as u32 } else { 0 };
        bytes.extend(next.to_le_bytes());
        bytes.extend(values);
    }
    bytes
}
