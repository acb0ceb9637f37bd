//! Rows of measured resistances, on made files.

use interface::gas::NamedGas;
use nature::NatureError;
use nature::resistance::{GasPressure, read};

const HEADER: &str = "id,material_1,material_2,interstitial,gas,ra_low_um,ra_high_um,pressure_mpa,gas_pressure_as_stored,\
                      gas_pressure_pa_guess,temperature_c,tcr_mm2k_per_w,conductance_w_per_m2k\n";

fn row(cells: &str) -> Result<nature::resistance::MeasuredResistance, NatureError> {
    read(format!("{HEADER}{cells}\n").as_bytes()).map(|mut rows| rows.remove(0))
}

#[test]
fn a_row_has_units_of_the_system() {
    let row = row("7,al2o3,al6061,none,n2,0.8,1.6,0.15,7999.0,7.999,25.0,1000.0,1000.0").unwrap();
    assert_eq!((row.id, row.gas, row.interstitial), (7, NamedGas::Nitrogen, None));
    assert_eq!(row.solids.map(|solid| solid.name), ["al2o3", "al6061"]);
    assert_eq!(row.gas_pressure, GasPressure::Known(7.999));
    let near = |one: f64, other: f64| (one / other - 1.0).abs() < 1e-12;
    assert!(near(row.ra_m[0], 0.8e-6) && near(row.ra_m[1], 1.6e-6) && near(row.pressure_pa, 1.5e5));
    assert!(near(row.temperature_k, 298.15) && row.measured_w_per_m2_k == 1000.0);
}

#[test]
fn an_interstitial_is_named() {
    let row = row("8,si,ss304,graphene,he,0.2,0.2,0.1,8.0,8.0,300,500,2000").unwrap();
    assert_eq!(row.interstitial.as_deref(), Some("graphene"));
}

#[test]
fn a_gas_pressure_is_known_or_doubtful() {
    assert_eq!(GasPressure::decode(101_325.0, 101_325.0).unwrap(), GasPressure::Known(101_325.0));
    assert_eq!(GasPressure::decode(1_333_220.0, 1333.22).unwrap(), GasPressure::Known(1333.22));
    let stored = 101_324_720.0;
    assert_eq!(GasPressure::decode(stored, 101_324.72).unwrap(), GasPressure::Doubtful { stored });
    assert!(matches!(GasPressure::decode(100.0, 3.0), Err(NatureError::GasPressure(..))));
}

#[test]
fn unknown_names_are_refused() {
    let wood = row("7,wood,al6061,none,n2,0.8,1.6,0.15,10,10,25,1000,1000");
    assert!(matches!(wood, Err(NatureError::Unknown("material", name)) if name == "wood"));
    let argon = row("7,si,al6061,none,ar,0.8,1.6,0.15,10,10,25,1000,1000");
    assert!(matches!(argon, Err(NatureError::Unknown("gas", name)) if name == "ar"));
    assert!(matches!(read("id\n1\n".as_bytes()), Err(NatureError::Table(_))));
}
