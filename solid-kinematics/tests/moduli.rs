//! Elastic moduli: turned, compared, refused.

mod common;

use common::{rotation, unit, wood};
use solid_kinematics::*;

#[test]
fn moduli_turn_with_their_axes() {
    let axes = rotation([0.2, -0.7, 0.4], 1.1);
    let strain = Tensor::new(0.3, 0.1, -0.2, 0.1, -0.4, 0.05, -0.2, 0.05, 0.2);
    for moduli in [wood(), unit()] {
        let turned = moduli.turned(&axes);
        let direct = axes
            * stress_tensor(&moduli.stress(&strains(&(axes.transpose() * strain * axes))))
            * axes.transpose();
        let e = strains(&strain);
        for (row, &(i, j)) in PAIRS.iter().enumerate() {
            let found: f64 = (0..6).map(|k| turned[row][k] * e[k]).sum();
            assert!((found - direct[(i, j)]).abs() < 1e-14);
        }
    }
}

#[test]
fn equal_constants_are_isotropic() {
    let shear = 1.0 / 2.6;
    let equal = Orthotropic { young: [1.0; 3], poisson: [0.3; 3], shear: [shear; 3] };
    let moduli = Moduli::orthotropic(&equal).unwrap();
    let strain = [0.3, -0.1, 0.2, 0.5, -0.4, 0.6];
    let (a, b) = (moduli.stress(&strain), unit().stress(&strain));
    (0..6).for_each(|i| assert!((a[i] - b[i]).abs() < 1e-14));
    // one axis stretched alone: contraction by Poisson's ratios
    let pulled = wood();
    let along = [2.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert!((pulled.complementary(&along) - 2.0 / 3.0).abs() < 1e-14); // ½ σ²/E₁
}

#[test]
fn constants_that_are_no_material_are_refused() {
    for (young, poisson, word) in [
        (0.0, 0.3, "Young's modulus is 0"),
        (f64::NAN, 0.3, "Young's modulus is NaN"),
        (1.0, 0.5, "Poisson's ratio is 0.5"),
        (1.0, -1.0, "Poisson's ratio is -1"),
    ] {
        let error = Moduli::isotropic(young, poisson).unwrap_err().to_string();
        assert!(error.contains(word), "{error}");
    }
    let good = Orthotropic { young: [3.0, 1.0, 0.7], poisson: [0.3; 3], shear: [0.5; 3] };
    let bad = Orthotropic { young: [3.0, -1.0, 0.7], ..good };
    assert!(Moduli::orthotropic(&bad).unwrap_err().to_string().starts_with("E2 is -1"));
    let bad = Orthotropic { shear: [0.5, 0.5, 0.0], ..good };
    assert!(Moduli::orthotropic(&bad).unwrap_err().to_string().starts_with("G13 is 0"));
    for poisson in [[1.8, 0.3, 0.3], [0.3, 1.3, 0.3], [0.9, 0.8, 1.5]] {
        let error = Moduli::orthotropic(&Orthotropic { poisson, ..good }).unwrap_err();
        assert!(matches!(error, ElasticError::Indefinite { pivot } if pivot <= 0.0), "{poisson:?}: {error}");
    }
}
