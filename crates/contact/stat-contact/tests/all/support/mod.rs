//! Rows of reference tables as contacts.

use asperity::{ElasticBody, Hardness, MaterialPair, NixGao};
use stat_contact::{AsperityLaw, InterferenceLaw, Population, StatisticalContact};

/// One row: the contact, its height spread, and separation, pressure and area fraction.
pub struct Row {
    pub what: String,
    pub gradient: bool,
    pub contact: StatisticalContact,
    pub sigma_s_m: f64,
    pub separation_m: f64,
    pub pressure_pa: f64,
    pub area_fraction: f64,
}

/// Populations of diamond with heights of a standard deviation \[m\] under every law.
pub fn contacts_of_diamond(sigma_s_m: f64) -> [StatisticalContact; 7] {
    let pair = MaterialPair::against_rigid(ElasticBody::new(463e9, 0.2).unwrap());
    let population = Population::new(40e-9, 3e13, sigma_s_m).unwrap();
    let strength = NixGao::constant(1.8e9).unwrap();
    let hardening = strength.with_strain_gradient(5e-6).unwrap();
    let hardness = Hardness::default();
    let laws = [
        AsperityLaw::Hertz,
        AsperityLaw::EpSphere { strength, hardness, held_from: None },
        AsperityLaw::EpSphere { strength: hardening, hardness, held_from: None },
        AsperityLaw::ElasticSine { interference: InterferenceLaw::RostamiJackson },
        AsperityLaw::ElasticSine { interference: InterferenceLaw::Bem },
        AsperityLaw::EpSine { strength },
        AsperityLaw::EpSine { strength: hardening },
    ];
    laws.map(|law| StatisticalContact::new(&pair, &population, &law))
}

/// The rows of a table without its header, in the columns of the project's reference tables.
pub fn rows(table: &str) -> impl Iterator<Item = Row> {
    table.lines().map(|line| {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().unwrap();
        let constant = NixGao::constant(number(3)).unwrap();
        let gradient = !cells[4].is_empty();
        let strength = if gradient { constant.with_strain_gradient(number(4)).unwrap() } else { constant };
        let law = match cells[0] {
            "hertz" => AsperityLaw::Hertz,
            "ep-sphere" => AsperityLaw::EpSphere { strength, hardness: Hardness::default(), held_from: None },
            "elastic-sine" => AsperityLaw::ElasticSine { interference: InterferenceLaw::default() },
            "ep-sine" => AsperityLaw::EpSine { strength },
            other => panic!("no table has a law {other}"),
        };
        let pair = MaterialPair::against_rigid(ElasticBody::new(number(1), number(2)).unwrap());
        let population = Population::new(number(5), number(6), number(7)).unwrap();
        Row {
            what: line.to_owned(),
            gradient,
            contact: StatisticalContact::new(&pair, &population, &law),
            sigma_s_m: number(7),
            separation_m: number(8),
            pressure_pa: number(9),
            area_fraction: number(10),
        }
    })
}
