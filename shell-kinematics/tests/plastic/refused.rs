//! What is refused, and in what words.

use shell_kinematics::{Hardening, MaterialError, Plastic, PlasticPly, PlasticSection, PlyMaterial, RValues};

use crate::common::*;

fn says<T>(result: Result<T, MaterialError>) -> String {
    result.err().unwrap().to_string()
}

#[test]
fn constants_out_of_bounds_are_refused() {
    let nan = f64::NAN;
    for (said, words) in [
        (says(Hardening::linear(0.0, 1.0)), "the yield stress is 0; it must be positive and finite"),
        (
            says(Hardening::linear(1.0, -1.0)),
            "the slope of linear hardening is -1; it must be zero or positive, and finite",
        ),
        (
            says(Hardening::voce(1.0, nan, 1.0)),
            "the rise of Voce's hardening is NaN; it must be zero or positive, and finite",
        ),
        (
            says(Hardening::voce(1.0, 1.0, 0.0)),
            "the rate of Voce's hardening is 0; it must be positive and finite",
        ),
        (
            says(Hardening::swift(1.0, 0.0, 0.2)),
            "the offset of Swift's hardening is 0; it must be positive and finite",
        ),
        (
            says(Hardening::swift(1.0, 0.1, 1.5)),
            "the exponent of Swift's hardening is 1.5; it must be from 0 to 1",
        ),
        (
            says(Hardening::table(&[[0.0, 1.0]])),
            "the number of rows of a hardening table is 1; it must be at least 2",
        ),
        (
            says(Hardening::table(&[[0.1, 1.0], [0.2, 1.0]])),
            "the plastic strain of row 1 of the hardening table is 0.1; it must be zero in the first row, and finite",
        ),
        (
            says(Hardening::table(&[[0.0, 1.0], [0.0, 2.0]])),
            "the plastic strain of row 2 of the hardening table is 0; it must be above that of the row before",
        ),
        (
            says(Hardening::table(&[[0.0, 2.0], [0.1, 1.0]])),
            "the yield stress of row 2 of the hardening table is 1; it must be at least that of the row before",
        ),
        (
            says(Hardening::table(&[[0.0, 0.0], [0.1, 1.0]])),
            "the yield stress of row 1 of the hardening table is 0; it must be positive and finite",
        ),
    ] {
        assert_eq!(said, words);
    }
}

#[test]
fn sections_without_bending_or_plies_are_refused() {
    let material = || Plastic::new(elastic(), Hardening::linear(1.0, 0.0).unwrap());
    let words = "the number of slices of a ply is 1; it must be at least 2";
    assert_eq!(says(PlasticSection::new(material(), 1.0, 1)), words);
    assert_eq!(PlasticSection::new(material(), 0.0, 2).err(), Some(MaterialError::Thickness(0.0)));
    assert_eq!(PlasticSection::layered(&[]).err(), Some(MaterialError::NoPlies));
    let ply =
        PlasticPly { material: PlyMaterial::Plastic(material(), 2), thickness: 1.0, angle: f64::INFINITY };
    assert_eq!(PlasticSection::layered(&[ply]).err(), Some(MaterialError::Angle(f64::INFINITY)));
    let words = "the modulus of kinematic hardening is -1; it must be zero or positive, and finite";
    assert_eq!(says(material().kinematic(-1.0)), words);
    let words = "the r-value at 45° is 0; it must be positive and finite";
    assert_eq!(says(RValues::new(1.0, 0.0, 1.0)), words);
}
