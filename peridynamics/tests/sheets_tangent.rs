//! Second derivatives of plates of two sheets: against differences of forces, zero modes, strips that must not lock.

mod plates;

use explicit_dynamics::{Amplitude, LinearisedDynamics};
use implicit_statics::{Equilibrium, linear_response, tangent_error};
use nalgebra::DMatrix;
use peridynamics::{AppliedLoad, Crack, Elastic, Solid, StaticSolid, Support, Supported};
use plates::{ALUMINIUM, noise, parts, put, shake};
use sph_core::Vec3;

/// The tangent at the present state, both triangles.
fn dense(plate: &mut StaticSolid) -> DMatrix<f64> {
    let (count, pattern) = (plate.unknowns(), plate.pattern());
    let mut values = vec![0.0; pattern.len()];
    plate.tangent(1.0, &mut values);
    let mut out = DMatrix::zeros(count, count);
    for (&(row, column), value) in pattern.iter().zip(&values) {
        out[(row, column)] = *value;
        out[(column, row)] = *value;
    }
    out
}

/// A small plate bent at rest, torn in its upper sheet.
fn torn() -> peridynamics::Parts {
    let mut block = plates::block([5.0, 4.0], 0.7, 1.0);
    block.positions.iter_mut().for_each(|x| x.z = 0.03 * x.x * x.y);
    let [below, above] = [0.0, 2.0];
    let corner = |x: f64, z: f64| Vec3::new(x, 2.5, z);
    let crack =
        vec![corner(-1.0, below + 0.1), corner(2.6, below + 0.1), corner(2.6, above), corner(-1.0, above)];
    let mut parts = parts(block, ALUMINIUM);
    parts.cracks = vec![Crack::Polygon(crack)];
    parts
}

#[test]
fn the_tangent_is_the_derivative_of_the_forces() {
    let solid = Solid::new(torn()).expect("a plate");
    let hurt: Vec<[f64; 2]> = (0..solid.len()).filter_map(|node| solid.damage_of_sheets(node)).collect();
    assert!(hurt.iter().any(|of| of[0] > 0.3) && hurt.iter().all(|of| of[1] == 0.0));
    let mut plate = StaticSolid::new(solid);
    shake(plate.solid_mut(), 0.03, 5);
    let mut noise = noise(8);
    let change: Vec<f64> = (0..plate.unknowns()).map(|_| noise()).collect();
    let error = tangent_error(&mut plate, 1.0, &change, 1e-5);
    println!("{error:.1e}");
    // Differences: the fifth derivative by h⁴, and 1e-16/h of rounding.
    assert!(error <= 4e-10, "{error:.1e}");
}

/// What the stable step and modes of motion are found by, `M^{-½} K M^{-½} v`, against the same from the assembled tangent.
#[test]
fn the_tangent_times_a_motion_is_that_of_the_assembled_one() {
    let mut plate = StaticSolid::new(Solid::new(torn()).expect("a plate"));
    shake(plate.solid_mut(), 0.03, 5);
    let tangent = dense(&mut plate);
    let scale: Vec<f64> = plate.masses().iter().map(|mass| 1.0 / mass.sqrt()).collect();
    let mut noise = noise(2);
    let v: Vec<f64> = scale.iter().map(|_| noise()).collect();
    let scaled = nalgebra::DVector::from_fn(v.len(), |i, _| v[i] * scale[i]);
    let assembled = tangent * scaled;
    let mut out = vec![0.0; v.len()];
    plate.solid_mut().apply(&v, &mut out);
    let greatest = out.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (i, value) in out.iter().enumerate() {
        // Rounding; measured 3.7e-16.
        assert!((value - assembled[i] * scale[i]).abs() <= 1.2e-15 * greatest, "{i}: {value}");
    }
}

#[test]
fn a_free_plate_has_six_zero_modes_wherever_it_lies() {
    let mut plate = StaticSolid::new(Solid::new(torn()).expect("a plate"));
    for angle in [0.0, 1.2] {
        let axis = nalgebra::Unit::new_normalize(Vec3::new(0.3, 1.0, -0.5));
        let turn = nalgebra::Rotation3::from_axis_angle(&axis, angle);
        let solid = plate.solid_mut();
        for node in 0..solid.len() {
            let (x, d) = (solid.position(node), solid.director(node).expect("one"));
            solid.put(node, turn * x);
            solid.set_director(node, turn * d);
        }
        let mut values: Vec<f64> = dense(&mut plate).symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        let top = values[values.len() - 1];
        // Rounding; measured 1.4e-16.
        assert!(values[..6].iter().all(|value| value.abs() <= 1e-14 * top), "{:?}", &values[..6]);
        // The softest deformation is a twist, 5.5e-4 of the stiffest.
        assert!(values[6] > 1e-4 * top, "{:?}", &values[..7]);
    }
}

/// A strip held at one end and bent by a force at the other, `F l³/(3EI) + F l/(⅚ μ A)`: thin or as thick as its spacing.
#[test]
fn a_strip_bends_as_a_beam_however_thin_it_is() {
    let material = Elastic { poisson: 0.0, ..ALUMINIUM };
    for (spacing, bound) in [(1.0, 0.028), (0.5, 0.014)] {
        for thickness in [0.01, 0.1, 0.3, 1.0] {
            let thickness = thickness * spacing;
            let block = plates::block([16.0, 3.0], thickness, spacing);
            let on = |face: usize| block.faces[face].clone();
            let clamp = Supported {
                nodes: on(0).iter().map(|&(node, _)| node).collect(),
                support: Support::Held {
                    displacement: vec![Vec3::x(), Vec3::y(), Vec3::z()],
                    director: vec![Vec3::x(), Vec3::y(), Vec3::z()],
                },
            };
            let inertia = 3.0 * thickness.powi(3) / 12.0;
            let (e, mu) = (material.young, 0.5 * material.young);
            let force = 3.0 * e * inertia / 16.0_f64.powi(3);
            let forces = on(1)
                .iter()
                .map(|&(node, area)| (node, Vec3::z() * (force * area / (3.0 * thickness))))
                .collect();
            let mut parts = parts(block, material);
            parts.supports = vec![clamp];
            parts.loads = vec![AppliedLoad { forces, amplitude: Amplitude::default() }];
            let mut plate = StaticSolid::new(Solid::new(parts).expect("a strip"));
            let response = linear_response(&mut plate, 0.0).expect("a stable strip");
            plate.update(&response);
            let solid = plate.solid();
            let tip: f64 = solid.block().faces[1]
                .iter()
                .map(|&(node, area)| solid.displacement(node as usize).z * area / (3.0 * thickness))
                .sum();
            let beam = force * 16.0_f64.powi(3) / (3.0 * e * inertia)
                + force * 16.0 / (5.0 / 6.0 * mu * 3.0 * thickness);
            // Too far by .94 % with 17 columns along, by .45 % with 33, the same to four digits for any thickness.
            assert!((tip / beam - 1.0).abs() <= bound, "t {thickness}: {tip} against {beam}");
        }
    }
}

/// A field of bending far beyond small rotations keeps its energy: a strip rolled to a half circle.
#[test]
fn a_strip_rolled_up_has_the_energy_of_its_curvature() {
    let material = Elastic { poisson: 0.0, ..ALUMINIUM };
    let mut solid = Solid::new(parts(plates::block([20.0, 3.0], 0.1, 0.5), material)).expect("a strip");
    let curvature = std::f64::consts::PI / 20.0;
    put(&mut solid, |x| {
        let (s, c) = libm::sincos(curvature * x.x);
        (Vec3::new(s / curvature, x.y, (1.0 - c) / curvature), Vec3::new(-s, 0.0, c))
    });
    solid.evaluate_internal(true);
    let bending = material.young * 0.1_f64.powi(3) / 12.0;
    let ratio = solid.internal_energy() / (0.5 * bending * curvature * curvature * 60.0);
    // Sheets see chords of the arc, (κr)²/24 too short: .26 % of the energy at five thicknesses a spacing.
    assert!((ratio - 1.0).abs() <= 8e-3, "{ratio}");
}
