//! What every brick must fulfil: patches, zero modes, derivatives, and closed forms.
#![allow(clippy::unwrap_used)] // helpers of tests

use benchmarks_ref::fe_solid::{Held, Mesh, Model, Moduli, cantilever, plate};
use benchmarks_ref::reference;
use implicit_statics::{Equilibrium, Newton, NewtonOptions, linear_response};
use nalgebra::{DMatrix, Matrix3, Rotation3, Vector3};

/// Bricks whose inner corners are moved; middles of edges stay in the middle, so that sides are straight.
fn distorted() -> Mesh {
    let mut mesh = Mesh::block([2.0, 2.0, 2.0], [2, 2, 2]);
    // Every node moves by a trilinear bump that vanishes on the faces: edges of bricks stay straight.
    for x in &mut mesh.positions {
        let hat = |x: f64| 1.0 - (x - 1.0).abs();
        let bump = hat(x.x) * hat(x.y) * hat(x.z);
        *x += Vector3::new(0.2, -0.15, 0.1) * bump;
    }
    mesh
}

fn moduli() -> Moduli {
    Moduli::isotropic(1000.0, 0.3)
}

fn free(mesh: &Mesh, rule: usize) -> Model {
    Model::new(mesh, moduli(), rule, &[], &[]).unwrap()
}

/// A smooth, not small motion of every unknown.
fn increment(size: usize, amplitude: f64) -> Vec<f64> {
    (0..size).map(|i| amplitude * libm::sin(1.7 * i as f64 + 0.3)).collect()
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

fn newton(model: &Model) -> Newton {
    let options = NewtonOptions { line_search: false, ..NewtonOptions::default() };
    Newton::new(model, &options).unwrap()
}

#[test]
fn forces_are_the_slope_of_the_energy_and_the_tangent_the_slope_of_the_forces() {
    for rule in [2, 3] {
        let mut model = free(&Mesh::block([1.0, 1.2, 0.7], [1, 1, 1]), rule);
        let n = model.unknowns();
        model.update(&increment(n, 0.05));
        let (rest, matrix) = (model.save(), dense(&mut model));
        let (mut forces, mut ahead, mut behind) = (vec![0.0; n], vec![0.0; n], vec![0.0; n]);
        model.internal(0.0, &mut forces);
        let (step, scale) = (1e-5, matrix.amax());
        for i in 0..n {
            let mut unit = vec![0.0; n];
            unit[i] = step;
            model.update(&unit);
            let high = model.energy();
            model.internal(0.0, &mut ahead);
            unit[i] = -2.0 * step;
            model.update(&unit);
            let low = model.energy();
            model.internal(0.0, &mut behind);
            model.restore(&rest);
            // central differences of second order: 1e-10 of the third derivative, and rounding of 1e-16 over the step
            assert!(((high - low) / (2.0 * step) - forces[i]).abs() < 1e-8 * scale, "force {i}");
            for j in 0..n {
                let slope = (ahead[j] - behind[j]) / (2.0 * step);
                assert!((slope - matrix[(j, i)]).abs() < 1e-8 * scale, "tangent {j} {i}");
            }
        }
    }
}

#[test]
fn a_free_brick_has_six_zero_modes_and_with_two_points_six_more() {
    let zeros = |mesh: &Mesh, rule: usize| {
        let eigenvalues = dense(&mut free(mesh, rule)).symmetric_eigenvalues();
        eigenvalues.iter().filter(|value| value.abs() < 1e-10 * eigenvalues.amax()).count()
    };
    let lone = Mesh::block([1.0, 1.2, 0.7], [1, 1, 1]);
    assert_eq!([zeros(&lone, 3), zeros(&lone, 2)], [6, 12]);
    assert_eq!(zeros(&distorted(), 3), 6);
    assert_eq!(zeros(&Mesh::block([2.0, 2.0, 1.0], [2, 2, 1]), 2), 6);
}

#[test]
fn a_rigid_motion_of_any_size_meets_no_force() {
    let mesh = distorted();
    let mut model = free(&mesh, 3);
    let turn = Rotation3::new(Vector3::new(0.9, -1.4, 0.6));
    let motion: Vec<f64> = mesh
        .positions
        .iter()
        .flat_map(|x| {
            let u = turn * x - x + Vector3::new(1.0, 2.0, 3.0);
            [u.x, u.y, u.z]
        })
        .collect();
    model.update(&motion);
    let mut forces = vec![0.0; model.unknowns()];
    model.internal(0.0, &mut forces);
    assert!(forces.iter().all(|force| force.abs() < 1e-11 * 1000.0), "rounding of the modulus");
}

/// A homogeneous deformation of any size on the boundary goes through distorted bricks exactly.
#[test]
fn a_homogeneous_deformation_is_in_balance_on_a_distorted_mesh() {
    let mesh = distorted();
    let slope = Matrix3::new(0.1, 0.2, -0.1, 0.05, -0.08, 0.12, 0.15, -0.03, 0.06);
    let boundary = mesh.nodes(|x| (0..3).any(|k| x[k] < 1e-9 || x[k] > 2.0 - 1e-9));
    let held: Vec<Held> = boundary
        .iter()
        .flat_map(|&node| (0..3).map(move |axis| (node, axis)))
        .map(|(node, axis)| Held { node, axis, by: (slope * mesh.positions[node])[axis] })
        .collect();
    for rule in [2, 3] {
        let mut model = Model::new(&mesh, moduli(), rule, &held, &[]).unwrap();
        newton(&model).at_level(&mut model, 1.0).unwrap();
        for (node, x) in mesh.positions.iter().enumerate() {
            assert!((model.displacement(node) - slope * x).norm() < 1e-9, "Newton's tolerance");
        }
        // The force of a face is that of one stress over its area.
        let gradient = Matrix3::identity() + slope;
        let green = (gradient.transpose() * gradient - Matrix3::identity()) * 0.5;
        let (lame, shear) = (1000.0 * 0.3 / (1.3 * 0.4), 1000.0 / 2.6);
        let stress = gradient * (Matrix3::identity() * (lame * green.trace()) + green * (2.0 * shear));
        let inner = mesh.nodes(|x| x.x > 2.0 - 1e-9 && [x.y, x.z].iter().all(|c| (0.01..1.99).contains(c)));
        assert!(model.reaction(&inner, 1.0).dot(&(stress * Vector3::x())) > 0.0);
        let sum = model.reaction(&boundary, 1.0).norm();
        assert!(sum < 1e-8 * 1000.0, "supports of one stress have no sum: {sum}");
    }
}

/// A bar under its own weight, ν = 0: `u = ρ g (L x − x²/2)/E`, which quadratic functions hold exactly.
#[test]
fn a_heavy_bar_stretches_by_its_closed_form() {
    let mesh = Mesh::block([3.0, 1.0, 1.0], [2, 1, 1]);
    let held: Vec<Held> = mesh
        .nodes(|x| x.x == 0.0)
        .into_iter()
        .flat_map(|node| (0..3).map(move |axis| Held { node, axis, by: 0.0 }))
        .collect();
    let loads = mesh.body_force(Vector3::x());
    let mut model = Model::new(&mesh, Moduli::isotropic(1000.0, 0.0), 3, &held, &loads).unwrap();
    let motion = linear_response(&mut model, 0.0).unwrap();
    model.update(&motion);
    for (node, x) in mesh.positions.iter().enumerate() {
        let exact = (3.0 * x.x - 0.5 * x.x * x.x) / 1000.0;
        assert!((model.displacement(node).x - exact).abs() < 1e-12);
    }
    let (mut internal, mut external) = (vec![0.0; model.unknowns()], vec![0.0; model.unknowns()]);
    model.restore(&vec![0.0; 3 * model.nodes()]);
    model.internal(0.0, &mut internal);
    model.external(1.0, &mut external);
    assert!(internal.iter().all(|force| *force == 0.0) && external.iter().any(|force| *force != 0.0));
    let total: f64 = model.masses().iter().sum();
    assert!(total > 0.0);
}

/// Another program's bricks of the same law, whose figures have five digits and its own tolerance of balance: 2e-5 apart at most.
#[test]
fn the_cantilever_is_that_of_calculix() {
    let table = reference("calculix_cantilever").unwrap();
    let levels: Vec<f64> = (1..=10).map(f64::from).collect();
    for (row, counts) in [(1, [10, 1, 1]), (4, [20, 2, 2])] {
        let solved = cantilever(counts, 0.2, &levels, false).unwrap();
        for k in [1, 4, 8, 10] {
            let given = table.number(row, &format!("w/L at K = {k}")).unwrap();
            let found = solved.rows[k][1];
            assert!((found - given).abs() < 5e-5, "K = {k}: {found} for {given}");
        }
        assert_eq!(solved.nodes as f64, table.number(row, "nodes").unwrap());
    }
}

/// A slender beam loaded through its volume, linear: `w/L = K/8`, and shear adds `K (1 + ν)/(12 κ) (h/L)²`, .58 % here with κ = 5/6 and
/// ν = .2 .
#[test]
fn a_small_load_bends_the_beam_by_its_closed_form() {
    let solved = cantilever([10, 1, 1], 0.2, &[1e-4], true).unwrap();
    let beam = 1e-4 * (0.125 + 1.2 / 12.0 / (5.0 / 6.0) * 0.01);
    let ratio = solved.rows[1][1] / beam;
    // the clamp, which lets no section contract, and ten bricks: .5 % stiff
    assert!((ratio - 1.0).abs() < 0.015, "{ratio}");
}

/// Held on a line, a plate gives way there a little: .36 % more than von Kármán's at a/h = 100 on 5² and 10² bricks, .53 on 20².
#[test]
fn a_thin_plate_is_von_karmans() {
    let table = reference("levy_plate").unwrap();
    let known: Vec<(f64, f64)> = (3..table.rows.len())
        .map(|row| (table.number(row, "P").unwrap(), table.number(row, "w_immovable_normal").unwrap()))
        .collect();
    let levels: Vec<f64> = known.iter().map(|row| row.0).collect();
    let solved = plate(5, &levels).unwrap();
    for (row, known) in solved.rows[1..].iter().zip(&known) {
        let off = row[1] / known.1 - 1.0;
        assert!(off.abs() < 5e-3, "P = {}: {off}", row[0]);
    }
}
