//! Own strain measure: curvature freed of the stretch along its own direction alone, asked what the library asks of its own.
//!
//! A [`StrainMeasure`] turns products of the vectors of a point into strains. Its tangent is exact because `∂²ε/∂m²` does not depend on the
//! state: strains are of second degree in the products, no more. This one drops the shares of shear from [`StretchCorrected`]:
//!
//! ```text
//! κ11 = k11 − k11⁰ − e11 k11     κ22 = k22 − k22⁰ − e22 k22     κ12 = k12 − k12⁰ − ½ (e11 + e22) k12
//! ```
//!
//! Bent to a circle both are the same; under shear of the membrane they part, by `¼ g k12`.
//!
//! `cargo run -p shell-kinematics --example own_strain_measure`

use shell_kinematics::{
    Matrix8, MeasureForces, Measures, Pack, Resultants, StrainMeasure, Strains, StretchCorrected,
};

struct AlongItself;

impl StrainMeasure for AlongItself {
    fn name(&self) -> &'static str {
        "along-itself"
    }

    fn describe(&self) -> &'static str {
        "curvature freed of the stretch along its own direction"
    }

    fn strains(&self, now: &Measures, reference: &Measures) -> Strains {
        let change = now.change(reference);
        let [e11, e22, _] = change.membrane;
        let [k11, k22, k12] = now.curvature;
        let [c11, c22, c12] = change.curvature;
        let curvature = [c11 - e11 * k11, c22 - e22 * k22, c12 - (e11 + e22) * k12 * 0.5];
        Strains { membrane: change.membrane, curvature, shear: change.shear }
    }

    fn transpose(&self, now: &Measures, reference: &Measures, stress: &Resultants) -> MeasureForces {
        let [e11, e22, _] = now.change(reference).membrane;
        let [k11, k22, k12] = now.curvature;
        let [n11, n22, n12] = stress.membrane;
        let [m11, m22, m12] = stress.moment;
        let (one, half) = (Pack::splat(1.0), k12 * m12 * 0.5);
        MeasureForces {
            membrane: [n11 - k11 * m11 - half, n22 - k22 * m22 - half, n12],
            curvature: [(one - e11) * m11, (one - e22) * m22, (one - (e11 + e22) * 0.5) * m12],
            shear: stress.shear,
        }
    }

    fn gradient(&self, now: &Measures, reference: &Measures) -> Matrix8 {
        let [e11, e22, _] = now.change(reference).membrane;
        let [k11, k22, k12] = now.curvature;
        let one = Pack::splat(1.0);
        let mut j = [[Pack::splat(0.0); 8]; 8];
        (0..8).for_each(|i| j[i][i] = one);
        (j[3][0], j[3][3]) = (-k11, one - e11);
        (j[4][1], j[4][4]) = (-k22, one - e22);
        (j[5][0], j[5][1], j[5][5]) = (k12 * -0.5, k12 * -0.5, one - (e11 + e22) * 0.5);
        j
    }

    fn second_gradient(&self, _: &Measures, _: &Measures, stress: &Resultants) -> Matrix8 {
        let [m11, m22, m12] = stress.moment;
        let mut out = [[Pack::splat(0.0); 8]; 8];
        for (i, j, value) in [(0, 3, -m11), (1, 4, -m22), (0, 5, m12 * -0.5), (1, 5, m12 * -0.5)] {
            (out[i][j], out[j][i]) = (value, value);
        }
        out
    }
}

/// Products by their eight numbers.
fn measures(m: [f64; 8]) -> Measures {
    let [a, b, c, d, e, f, g, h] = m.map(Pack::splat);
    Measures { membrane: [a, b, c], curvature: [d, e, f], shear: [g, h] }
}

fn numbers(strains: &Strains) -> [f64; 8] {
    let [a, b, c] = strains.membrane;
    let [d, e, f] = strains.curvature;
    let [g, h] = strains.shear;
    [a, b, c, d, e, f, g, h].map(|pack| pack.lanes()[0])
}

fn main() -> Result<(), String> {
    let reference = [0.5, 0.5, 0.0, 0.1, 0.0, 0.05, 0.0, 0.0];
    let now = [0.55, 0.48, 0.03, 0.4, -0.2, 0.1, 0.02, -0.01];
    let stress = [0.7, -0.4, 0.2, 0.9, 0.3, -0.6, 0.1, 0.5];
    let [a, b, c, d, e, f, g, h] = stress.map(Pack::splat);
    let resultants = Resultants { membrane: [a, b, c], moment: [d, e, f], shear: [g, h] };
    let (there, before) = (measures(now), measures(reference));
    let forces = AlongItself.transpose(&there, &before, &resultants).components();
    let (gradient, second) =
        (AlongItself.gradient(&there, &before), AlongItself.second_gradient(&there, &before, &resultants));
    let mut worst = 0.0_f64;
    for i in 0..8 {
        // Of second degree: central differences of any size are exact but for rounding.
        let moved = |by: f64| std::array::from_fn(|j| now[j] + if i == j { by } else { 0.0 });
        let (ahead, behind) = (measures(moved(0.1)), measures(moved(-0.1)));
        let (high, low) = (AlongItself.strains(&ahead, &before), AlongItself.strains(&behind, &before));
        let slope: [f64; 8] = std::array::from_fn(|k| (numbers(&high)[k] - numbers(&low)[k]) / 0.2);
        let power = (0..8).map(|k| stress[k] * slope[k]).sum::<f64>();
        worst = worst.max((power - forces[i].lanes()[0]).abs());
        let pull = |m: &Measures| AlongItself.transpose(m, &before, &resultants).components();
        for k in 0..8 {
            worst = worst.max((slope[k] - gradient[k][i].lanes()[0]).abs());
            let bend = (pull(&ahead)[k].lanes()[0] - pull(&behind)[k].lanes()[0]) / 0.2;
            worst = worst.max((bend - second[k][i].lanes()[0]).abs());
        }
    }
    // A strip bent to a circle of curvature .4: no stretch along it, the same curvature as the library's.
    let circle = measures([0.5, 0.5, 0.0, 0.4, 0.0, 0.0, 0.0, 0.0]);
    let flat = measures([0.5, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    let bent = numbers(&AlongItself.strains(&circle, &flat))[3];
    let library = numbers(&StretchCorrected.strains(&circle, &flat))[3];
    println!("derivatives off by {worst:.1e}; a circle has κ = {bent}, by the library {library}");
    let sheared = |measure: &dyn StrainMeasure| numbers(&measure.strains(&there, &before))[3];
    let apart = sheared(&AlongItself) - sheared(&StretchCorrected);
    println!("under shear they part by {apart:.5}, ¼ g k12 = {:.5}", 0.25 * 0.03 * 0.1);
    if worst > 1e-14 * 100.0 || bent != library || (apart - 0.25 * 0.03 * 0.1).abs() > 1e-15 {
        return Err(format!("off by {worst:e}"));
    }
    Ok(())
}
