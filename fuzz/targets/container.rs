//! Containers: `index.json` or `meta.yml`, a zero byte, a data file named `data`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (index, data) = fuzz::text_and_data(bytes);
    let name = if index.starts_with(b"{") { "index.json" } else { "meta.yml" };
    fuzz::read(&fuzz::packed(&[(name, index), ("data", data)]));
});
