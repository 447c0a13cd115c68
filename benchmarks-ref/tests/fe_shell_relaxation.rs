//! Dynamic relaxation of the finite-element shell finds what Newton's method finds.
#![allow(clippy::unwrap_used)] // helpers of tests

use std::ops::ControlFlow;

use benchmarks_ref::fe_shell::{Load, Mesh, Model, Section, Side, Support};
use implicit_statics::{Equilibrium, Newton, NewtonOptions, RelaxationOptions, relax};
use nalgebra::Vector3;

#[test]
fn relaxation_finds_what_newton_finds() {
    let mesh = Mesh::plate(8, 3, 4.0, 1.0);
    let (clamped, end) = (mesh.side(Side::XiStart), mesh.side(Side::XiEnd));
    let section = Section::isotropic(1000.0, 0.3, 0.2, 1.0);
    let load = Load::Edge(end.clone(), Vector3::new(0.0, 0.0, 0.02));
    let mut model = Model::new(&mesh, section, Vector3::x(), &[Support::clamp(clamped)], &[load]).unwrap();
    let rest = model.save();
    Newton::new(&model, &NewtonOptions::default()).unwrap().at_level(&mut model, 1.0).unwrap();
    // The axes of directors depend on the way they came.
    let shape = |model: &Model| -> Vec<Vector3<f64>> {
        (0..model.nodes()).flat_map(|node| [model.displacement(node), model.director(node)]).collect()
    };
    let exact = shape(&model);
    let tip = model.displacement(end[0]).z;
    assert!(tip > 0.5, "{tip} is no large deflection of a strip of 4");
    model.restore(&rest);
    let options = RelaxationOptions::default();
    let found = relax(&mut model, &options, (0.0, 1.0), |_| ControlFlow::Continue(())).unwrap();
    let off = shape(&model).iter().zip(&exact).fold(0.0_f64, |m, (a, b)| m.max((a - b).norm())) / tip;
    println!("{off:.1e} after {} evaluations", found.evaluations);
    assert!(off < 1e-4, "{off:.1e} after {found:?}");
}
