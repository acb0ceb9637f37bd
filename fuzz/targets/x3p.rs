//! X3P: `main.xml`, a zero byte, the binary data, which also stand for the bits of valid points.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (index, data) = fuzz::text_and_data(bytes);
    let files = [("main.xml", index), ("bindata/data.bin", data), ("bindata/valid.bin", data)];
    fuzz::read(&fuzz::packed(&files));
});
