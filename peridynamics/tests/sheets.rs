//! Plates of two sheets: forces are the derivative of the energy, uniform fields have the energy of a thin plate.

mod plates;

use peridynamics::Solid;
use plates::{ALUMINIUM, free, noise, parts, put, shake};
use sph_core::Vec3;

/// Work of all internal forces on a change of places and directors.
fn work(solid: &Solid, change: &[(Vec3, Vec3)]) -> f64 {
    let of = |node: usize| {
        solid.internal_force(node).dot(&change[node].0)
            + solid.internal_couple(node).expect("a plate").dot(&change[node].1)
    };
    (0..solid.len()).map(of).sum()
}

#[test]
fn forces_are_the_derivative_of_the_energy() {
    for bent in [0.0, 0.3] {
        let mut block = plates::block([6.0, 4.0], 0.7, 1.0);
        for x in &mut block.positions {
            x.z = bent * libm::sin(0.5 * x.x) * libm::sin(0.4 * x.y);
        }
        let mut solid = Solid::new(parts(block, ALUMINIUM)).expect("a plate");
        shake(&mut solid, 0.05, 4);
        solid.evaluate_internal(false);
        let mut noise = noise(9);
        let change: Vec<(Vec3, Vec3)> = (0..solid.len())
            .map(|_| (Vec3::from_fn(|_, _| noise()), Vec3::from_fn(|_, _| noise())))
            .collect();
        let work = work(&solid, &change);
        let mut energy = |eps: f64| {
            for (node, (u, d)) in change.iter().enumerate() {
                let (place, director) =
                    (solid.position(node) + u * eps, solid.director(node).expect("one") + d * eps);
                solid.put(node, place);
                solid.set_director(node, director);
            }
            solid.evaluate_internal(true);
            solid.internal_energy()
        };
        let eps = 1e-6;
        let slope = (energy(eps) - energy(-2.0 * eps)) / (2.0 * eps);
        // Central differences lose 1e-12 of the third derivative and 1e-16/1e-6 to rounding; measured 1.4e-9.
        assert!((slope - work).abs() <= 4e-9 * work.abs(), "bent {bent}: {slope} against {work}");
    }
}

#[test]
fn a_plate_at_rest_bears_nothing_and_one_that_turns_neither() {
    let mut block = plates::block([6.0, 4.0], 0.7, 1.0);
    block.positions.iter_mut().for_each(|x| x.z = 0.05 * x.x * x.y / 6.0);
    let mut solid = Solid::new(parts(block, ALUMINIUM)).expect("a plate");
    let greatest = |solid: &mut Solid| {
        solid.evaluate_internal(false);
        let of = |node: usize| {
            solid.internal_force(node).norm().max(solid.internal_couple(node).expect("a plate").norm())
        };
        (0..solid.len()).map(of).fold(0.0, f64::max)
    };
    let at_rest = greatest(&mut solid);
    let rest: Vec<(Vec3, Vec3)> =
        (0..solid.len()).map(|node| (solid.position(node), solid.director(node).expect("one"))).collect();
    let mut to = |map: &dyn Fn(Vec3) -> Vec3| {
        for (node, (x, d)) in rest.iter().enumerate() {
            solid.put(node, map(*x));
            solid.set_director(node, map(*d));
        }
        greatest(&mut solid)
    };
    let stretched = to(&|v| v * 1.01);
    let axis = nalgebra::Unit::new_normalize(Vec3::new(1.0, 2.0, -0.5));
    for angle in [0.3, 1.6, 3.0] {
        let turned = to(&|v| nalgebra::Rotation3::from_axis_angle(&axis, angle) * v);
        // Rounding of lengths, 1e-16 of the places over 1e-2 of stretch; measured 1.6e-13.
        assert!(turned <= 5e-13 * stretched, "{angle}: {turned} against {stretched}");
    }
    assert_eq!(at_rest, 0.0);
}

/// Fields of uniform strain, curvature or transverse shear, each with its energy per area.
#[test]
fn uniform_fields_have_the_energy_of_a_thin_plate() {
    let (e, nu, t) = (ALUMINIUM.young, ALUMINIUM.poisson, 0.7);
    let (membrane, bending) = (e * t / (1.0 - nu * nu), e * t.powi(3) / (12.0 * (1.0 - nu * nu)));
    let s = 1e-7;
    type Field = (&'static str, Box<dyn Fn(Vec3) -> (Vec3, Vec3)>, f64);
    let flat = |map: fn(Vec3) -> Vec3| move |x: Vec3| (x + map(x) * s, Vec3::z());
    let fields: Vec<Field> = vec![
        ("strain along x", Box::new(flat(|x| Vec3::new(x.x, 0.0, 0.0))), 0.5 * membrane * s * s),
        ("strain along y", Box::new(flat(|x| Vec3::new(0.0, x.y, 0.0))), 0.5 * membrane * s * s),
        ("strain both ways", Box::new(flat(|x| Vec3::new(x.x, x.y, 0.0))), membrane * (1.0 + nu) * s * s),
        ("shear", Box::new(flat(|x| Vec3::new(x.y, 0.0, 0.0))), 0.25 * membrane * (1.0 - nu) * s * s),
        (
            "bending about y",
            Box::new(move |x| (x + Vec3::z() * (0.5 * s * x.x * x.x), Vec3::new(-s * x.x, 0.0, 1.0))),
            0.5 * bending * s * s,
        ),
        (
            "bending about both",
            Box::new(move |x| {
                let w = 0.5 * s * (x.x * x.x + x.y * x.y);
                (x + Vec3::z() * w, Vec3::new(-s * x.x, -s * x.y, 1.0))
            }),
            bending * (1.0 + nu) * s * s,
        ),
        (
            "twist",
            Box::new(move |x| (x + Vec3::z() * (s * x.x * x.y), Vec3::new(-s * x.y, -s * x.x, 1.0))),
            bending * (1.0 - nu) * s * s,
        ),
        ("stretch of the thickness", Box::new(move |x| (x, Vec3::z() * (1.0 + s))), 0.5 * e * t * s * s),
    ];
    let mut solid = free([8.0, 6.0], t, 1.0);
    for (name, field, density) in &fields {
        put(&mut solid, field);
        solid.evaluate_internal(true);
        let ratio = solid.internal_energy() / (density * 48.0);
        // Second-order terms of the fields are 1e-7 of the first: measured 1.0e-7. At the four corners shear strains bring a
        // dilatation, which the even correction does not know: 9e-5 of this plate.
        let bound = if ["shear", "twist"].contains(name) { 3e-4 } else { 3e-7 };
        assert!((ratio - 1.0).abs() <= bound, "{name}: {ratio}");
    }
}

#[test]
fn threads_change_no_bit() {
    let forces = |threads: usize| {
        let mut parts = parts(plates::block([60.0, 10.0], 0.7, 1.0), ALUMINIUM);
        parts.threads = threads;
        let mut solid = Solid::new(parts).expect("a plate");
        shake(&mut solid, 0.05, 4);
        solid.evaluate_internal(true);
        let of = |node: usize| [solid.internal_force(node), solid.internal_couple(node).expect("a plate")];
        let forces: Vec<[Vec3; 2]> = (0..solid.len()).map(of).collect();
        (solid.internal_energy().to_bits(), forces)
    };
    let one = forces(1);
    assert!([2, 4].into_iter().all(|threads| forces(threads) == one));
}

#[test]
fn a_plate_turned_upside_down_has_the_same_bits() {
    let mut energies = [0.0; 2];
    let mut forces = [Vec::new(), Vec::new()];
    for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
        let mut block = plates::block([6.0, 4.0], 0.7, 1.0);
        block
            .positions
            .iter_mut()
            .for_each(|x| x.z = sign * 0.1 * libm::sin(0.5 * x.x) * libm::sin(0.7 * x.y));
        let mut solid = Solid::new(parts(block, ALUMINIUM)).expect("a plate");
        let over = |x: Vec3| Vec3::new(x.x, x.y, sign * x.z);
        let mut noise = noise(3);
        for node in 0..solid.len() {
            let (u, d) = (Vec3::from_fn(|_, _| 0.05 * noise()), Vec3::from_fn(|_, _| 0.05 * noise()));
            let (place, director) = (solid.position(node) + over(u), solid.director(node).expect("one"));
            solid.put(node, place);
            solid.set_director(node, director + Vec3::new(sign * d.x, sign * d.y, d.z));
        }
        solid.evaluate_internal(true);
        energies[side] = solid.internal_energy();
        forces[side] = (0..solid.len()).map(|node| over(solid.internal_force(node))).collect();
    }
    assert_eq!(energies[0].to_bits(), energies[1].to_bits());
    assert_eq!(forces[0], forces[1]);
}

#[test]
fn what_is_no_thin_plate_is_refused() {
    let message = |change: &dyn Fn(&mut peridynamics::Parts)| {
        let mut parts = parts(plates::block([6.0, 4.0], 0.7, 1.0), ALUMINIUM);
        change(&mut parts);
        Solid::new(parts).map(|_| ()).expect_err("refused").to_string()
    };
    let steep = message(&|parts| parts.block.positions.iter_mut().for_each(|x| x.z = x.x));
    assert!(
        steep.contains("the slope of the plate at rest is 1") && steep.contains("at most 0.2"),
        "{steep}"
    );
    let thick = message(&|parts| parts.block.spacing[2] = 0.6);
    assert!(thick.contains("the thickness of the plate is 0.7"), "{thick}");
    let solid = message(&|parts| parts.block.dimensions = 3);
    assert!(solid.contains("plane stress"), "{solid}");
}
