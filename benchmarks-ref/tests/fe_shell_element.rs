//! What every shell element must fulfil: derivatives, rigid motions, zero modes, patches.
#![allow(clippy::unwrap_used)] // helpers of tests

use approx::assert_relative_eq;
use benchmarks_ref::fe_shell::{Load, Mesh, Model, Orthotropic, Ply, Section, Side, Support};
use implicit_statics::{Converged, Equilibrium, Newton, NewtonOptions};
use nalgebra::{DMatrix, Rotation3, Vector3};

fn isotropic() -> Section {
    Section::isotropic(1000.0, 0.3, 0.2, 1.0)
}

fn layered() -> Section {
    let material = Orthotropic {
        along: 3300.0,
        across: 1100.0,
        poisson: 0.25,
        shear: 660.0,
        shear_across: 440.0,
        density: 1.0,
    };
    Section::layered(&material, &[Ply { thickness: 0.1, angle: 0.2 }, Ply { thickness: 0.1, angle: 1.3 }])
}

/// A plate whose inner nodes are moved within its plane.
fn distorted(columns: usize, rows: usize) -> Mesh {
    let mut mesh = Mesh::plate(columns, rows, 3.0, 2.0);
    for (node, x) in mesh.positions.iter_mut().enumerate() {
        let inner = x.x > 0.01 && x.x < 2.99 && x.y > 0.01 && x.y < 1.99;
        if inner {
            let phase = node as f64;
            *x += Vector3::new(libm::sin(2.3 * phase), libm::cos(3.1 * phase), 0.0) * 0.15;
        }
    }
    mesh
}

fn meshes() -> Vec<(&'static str, Mesh)> {
    vec![
        ("plate", distorted(3, 2)),
        ("cylinder", Mesh::cylinder(2, 3, 2.0, 3.0, 1.2, 1.3)),
        ("belt", Mesh::belt(3, 3, 2.0, 1.0)),
        ("twisted", Mesh::twisted(4, 2, 6.0, 1.1)),
    ]
}

fn free(mesh: &Mesh, section: Section) -> Model {
    Model::new(mesh, section, Vector3::new(1.0, 0.3, 0.2), &[], &[]).unwrap()
}

/// A smooth, not small increment of every unknown.
fn increment(size: usize, amplitude: f64) -> Vec<f64> {
    (0..size).map(|i| amplitude * libm::sin(1.7 * i as f64 + 0.3)).collect()
}

fn forces(model: &mut Model) -> Vec<f64> {
    let mut out = vec![0.0; model.unknowns()];
    model.internal(0.0, &mut out);
    out
}

fn dense(model: &mut Model) -> DMatrix<f64> {
    let pattern = model.pattern();
    let mut values = vec![0.0; pattern.len()];
    model.tangent(0.0, &mut values);
    let mut matrix = DMatrix::zeros(model.unknowns(), model.unknowns());
    for ((row, column), value) in pattern.into_iter().zip(values) {
        matrix[(row, column)] = value;
        matrix[(column, row)] = value;
    }
    matrix
}

#[test]
fn forces_are_the_slope_of_the_energy_and_the_tangent_the_slope_of_the_forces() {
    for (name, mesh) in meshes() {
        for section in [isotropic(), layered()] {
            let edge = mesh.side(Side::XiStart);
            let supports = [Support::clamp(edge)];
            let mut model = Model::new(&mesh, section, Vector3::new(1.0, 0.3, 0.2), &supports, &[]).unwrap();
            let size = model.unknowns();
            model.update(&increment(size, 0.1));
            let (state, force, tangent) = (model.save(), forces(&mut model), dense(&mut model));
            let (largest, stiffest) = (force.iter().fold(0.0_f64, |m, f| m.max(f.abs())), tangent.amax());
            let step = 1e-5;
            let mut along = |unknown: usize, step: f64| {
                let mut one = vec![0.0; size];
                one[unknown] = step;
                model.restore(&state);
                model.update(&one);
                (model.energy(), forces(&mut model), model.save())
            };
            for unknown in 0..size {
                let ((low, back, _), (high, ahead, _)) = (along(unknown, -step), along(unknown, step));
                assert_relative_eq!((high - low) / (2.0 * step), force[unknown], epsilon = 1e-6 * largest);
                for other in 0..size {
                    let slope = (ahead[other] - back[other]) / (2.0 * step);
                    let difference = (slope - tangent[(other, unknown)]).abs();
                    assert!(difference < 1e-6 * stiffest, "{name}: ({other}, {unknown}) {difference}");
                }
            }
        }
    }
}

#[test]
fn a_free_patch_has_six_zero_modes_and_no_more() {
    for (name, mesh) in meshes() {
        for section in [isotropic(), layered()] {
            let mut values: Vec<f64> =
                dense(&mut free(&mesh, section)).symmetric_eigenvalues().iter().copied().collect();
            values.sort_by(f64::total_cmp);
            let largest = values[values.len() - 1];
            assert!(
                values[5].abs() < 1e-12 * largest && values[0] > -1e-12 * largest,
                "{name}: {}",
                values[5]
            );
            assert!(values[6] > 1e-7 * largest, "{name}: {:e}", values[6] / largest);
        }
    }
}

#[test]
fn a_rigid_motion_of_any_size_meets_no_force() {
    let rotation = Rotation3::new(Vector3::new(1.0, -2.0, 0.7));
    for (name, mesh) in meshes() {
        let mut model = free(&mesh, layered());
        let moved: Vec<f64> = model
            .save()
            .chunks(3)
            .enumerate()
            .flat_map(|(index, v)| {
                let shift = if index % 3 == 0 { Vector3::new(5.0, -3.0, 1.0) } else { Vector3::zeros() };
                let turned = rotation * Vector3::new(v[0], v[1], v[2]) + shift;
                [turned.x, turned.y, turned.z]
            })
            .collect();
        model.restore(&moved);
        let largest = forces(&mut model).iter().fold(0.0_f64, |m, f| m.max(f.abs()));
        assert!(largest < 1e-10, "{name}: {largest}");
        assert!(model.energy() < 1e-20, "{name}: {}", model.energy());
    }
}

#[test]
fn a_homogeneous_stretch_of_any_size_is_in_balance_on_a_distorted_mesh() {
    let gradient = nalgebra::Matrix3::new(1.3, 0.2, 0.0, -0.1, 0.8, 0.0, 0.0, 0.0, 1.0);
    let mesh = distorted(4, 3);
    let mut model = free(&mesh, isotropic());
    let moved: Vec<f64> = model
        .save()
        .chunks(9)
        .flat_map(|node| {
            let x = gradient * Vector3::new(node[0], node[1], node[2]);
            [vec![x.x, x.y, x.z], node[3..].to_vec()].concat()
        })
        .collect();
    model.restore(&moved);
    let force = forces(&mut model);
    let largest = force.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    for j in 1..3 {
        for i in 1..4 {
            let start = 5 * mesh.node(i, j);
            assert!(force[start..start + 5].iter().all(|f| f.abs() < 1e-12 * largest), "node ({i}, {j})");
        }
    }
}

#[test]
fn constant_curvatures_are_in_balance_on_a_distorted_mesh() {
    let mesh = distorted(4, 3);
    let mut model = free(&mesh, layered());
    let stiffness = dense(&mut model);
    for curvature in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
        let state = model.save();
        let mut motion = nalgebra::DVector::zeros(model.unknowns());
        for (node, x) in mesh.positions.iter().enumerate() {
            let [a, b, c] = curvature;
            let first = Vector3::from_column_slice(&state[9 * node + 6..9 * node + 9]);
            let slope = -Vector3::new(a * x.x + c * x.y, b * x.y + c * x.x, 0.0);
            motion[5 * node + 2] = 0.5 * (a * x.x * x.x + b * x.y * x.y) + c * x.x * x.y;
            motion[5 * node + 3] = slope.dot(&first);
            motion[5 * node + 4] = slope.dot(&Vector3::z().cross(&first));
        }
        // the coupling of the plies leaves a constant membrane force, which is in balance as well
        let force = &stiffness * motion;
        for j in 1..3 {
            for i in 1..4 {
                let node = force.rows(5 * mesh.node(i, j), 5).amax();
                assert!(node < 1e-12 * force.amax(), "{curvature:?}, node ({i}, {j}): {node}");
            }
        }
    }
}

#[test]
fn loads_on_a_cut_add_up_to_their_totals() {
    let mesh = Mesh::plate(4, 3, 3.0, 2.0);
    let edge = mesh.side(Side::XiEnd);
    let loads = [Load::Area(Vector3::z() * 2.0), Load::Edge(edge.clone(), Vector3::x() * 5.0)];
    let mut model = Model::new(&mesh, isotropic(), Vector3::x(), &[], &loads).unwrap();
    let mut force = vec![0.0; model.unknowns()];
    model.external(1.5, &mut force);
    let total = |axis: usize| force.iter().skip(axis).step_by(5).sum::<f64>();
    assert_relative_eq!(total(0), 7.5, max_relative = 1e-14);
    assert_relative_eq!(total(2), 18.0, max_relative = 1e-14);
    let names = [model.name_unknown(2), model.name_unknown(8)];
    assert_eq!(names[0], "displacement of node 0 along (0.000, 0.000, 1.000)");
    assert!(names[1].starts_with("turn of the director of node 1"), "{}", names[1]);
}

/// A strip of bending stiffness 100 lifted by its end in one step: how it converged, and the state.
fn lifted(thickness: f64, predicts: bool) -> (Converged, Vec<f64>) {
    let mesh = Mesh::plate(8, 1, 10.0, 1.0);
    let section = Section::isotropic(1200.0 / thickness.powi(3), 0.0, thickness, 1.0);
    let supports = [Support::clamp(mesh.side(Side::XiStart))];
    let loads = [Load::Edge(mesh.side(Side::XiEnd), Vector3::z())];
    let model = Model::new(&mesh, section, Vector3::x(), &supports, &loads).unwrap();
    let mut model = if predicts { model.predict_resultants() } else { model };
    // in the thin strip rounding of the forces is 1e-9 of the load
    let options = NewtonOptions { line_search: false, tolerance: 1e-8, ..NewtonOptions::default() };
    let converged = Newton::new(&model, &options).unwrap().at_level(&mut model, 0.1).unwrap();
    (converged, model.save())
}

#[test]
fn newton_converges_with_the_square_of_the_residual() {
    let (converged, _) = lifted(1.0, false);
    let [_, first, second, third, ..] = converged.residuals[..] else { panic!("{:?}", converged.residuals) };
    let (early, late) = (second / (first * first), third / (second * second));
    assert!(third < 1e-4 * second && late < 10.0 * early, "{:?}", converged.residuals);
}

#[test]
fn predicted_resultants_lead_to_the_same_state_sooner() {
    let ((plain, state), (predicted, other)) = (lifted(0.1, false), lifted(0.1, true));
    for (value, same) in state.iter().zip(&other) {
        assert_relative_eq!(value, same, epsilon = 1e-8);
    }
    assert!(predicted.iterations < plain.iterations, "{} and {}", predicted.iterations, plain.iterations);
}
