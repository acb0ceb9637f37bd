//! Quantities, shares, spreads, ranges and requests for scans, as typed.
#![no_main]

use measurements::{Instrument, ScanRequest, SlopeUncertainty, TipRadius, ZCalibration};
use units::{
    Area, Force, IndentationHardness, Length, LengthUnit, Modulus, Pressure, PressureRange, Resistivity,
    Share, SignedLength, ThermalConductivity, TypedSpread, Viscosity, WorkOfAdhesion, log_spaced,
    without_comma,
};

libfuzzer_sys::fuzz_target!(|text: &str| {
    macro_rules! parse {
        ($($type:ty),* $(,)?) => {
            $(if let Err(error) = text.parse::<$type>() {
                fuzz::check_message(&error.to_string(), text.as_bytes());
            })*
        };
    }
    parse!(
        Area,
        Force,
        IndentationHardness,
        Instrument,
        Length,
        LengthUnit,
        Modulus,
        Pressure,
        PressureRange,
        Resistivity,
        ScanRequest,
        Share,
        SignedLength,
        SlopeUncertainty,
        ThermalConductivity,
        TipRadius,
        Viscosity,
        WorkOfAdhesion,
        ZCalibration,
    );
    let _ = (TypedSpread::parse(text), LengthUnit::parse_instrument(text), LengthUnit::parse_any_case(text));
    let _ = without_comma(text);
    if let Ok(range) = text.parse::<PressureRange>() {
        let ends_pa = [range.from, range.to].map(|end| end.pascals(Some(1e9)));
        if let [Some(from_pa), Some(to_pa)] = ends_pa {
            let mut pressures_pa = log_spaced(from_pa, to_pa, range.points.min(9));
            assert!(pressures_pa.all(|pressure_pa| pressure_pa > 0.0 && pressure_pa.is_finite()));
        }
    }
});
