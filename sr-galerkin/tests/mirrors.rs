//! Half, quarter and eighth of a body behind planes of symmetry against the whole.

mod bodies;

use bodies::derivatives::{the_tangent_derives_from_forces, wiggle};
use bodies::{block, body, newton, nodes};
use implicit_statics::Equilibrium;
use sph_core::{Basis, Support, Vec3};
use sr_galerkin::{Condition, Essential, Galerkin, Load, Mirror, Parts, Supports};

/// A block of 4 by 3 by 2 about the origin, or what of it lies beyond planes through it; pressed from above by what follows.
fn part(cut: [bool; 3], mirrored: bool, essential: Essential) -> Parts {
    let whole = [4.0, 3.0, 2.0];
    let lengths = [0, 1, 2].map(|k| if cut[k] { whole[k] / 2.0 } else { whole[k] });
    let counts = [0, 1, 2].map(|k| (2.0 * lengths[k]) as usize + 1);
    let mut parts = block(lengths, counts, 0.0);
    let origin = Vec3::from_fn(|k, _| if cut[k] { 0.0 } else { -whole[k] / 2.0 });
    parts.nodes.iter_mut().chain(&mut parts.cells.corners).for_each(|x| *x += origin);
    parts.support = Support::ellipsoid([1.25; 3]);
    parts.essential = essential;
    for axis in (0..3).filter(|&axis| cut[axis]) {
        let normal = Vec3::ith(axis, 1.0);
        parts.conditions.push(Condition::held(nodes(&parts, |x| x[axis] == 0.0), normal));
        if mirrored {
            parts.mirrors.push(Mirror { point: Vec3::zeros(), normal });
        }
    }
    // Both ends stay; both faces are pressed.
    for end in [-2.0, 2.0] {
        parts.conditions.extend(
            Condition::fixed(&nodes(&parts, |x| x.x == end)).into_iter().filter(|c| !c.nodes.is_empty()),
        );
    }
    for (face, at) in [(4, -1.0), (5, 1.0)] {
        if at > 0.0 || !cut[2] {
            parts.loads.push(Load::Pressure { faces: parts.cells.faces[face].clone(), pressure: 0.02 });
        }
    }
    parts
}

fn solved(parts: Parts) -> Galerkin {
    let mut body = body(parts);
    let mut newton = newton(&body);
    newton.options.tolerance = 1e-11;
    newton.at_level(&mut body, 1.0).expect("equilibrium");
    body
}

/// The greatest difference of displacements at nodes of the part, over the greatest of them.
fn differs(part: &Galerkin, whole: &Galerkin) -> f64 {
    let (mut worst, mut most): (f64, f64) = (0.0, 0.0);
    for (node, x) in part.rest().iter().enumerate() {
        let twin = whole.rest().iter().position(|y| (x - y).norm() < 1e-9).expect("a node of the whole");
        worst = worst.max((part.displacement(node) - whole.displacement(twin)).norm());
        most = most.max(whole.displacement(twin).norm());
    }
    assert!(most > 1e-3, "{most}");
    worst / most
}

#[test]
fn a_part_behind_planes_moves_as_the_whole() {
    for essential in [Essential::Collocation, Essential::Direct] {
        let mut whole = solved(part([false; 3], false, essential));
        for cut in
            [[false, false, true], [false, true, false], [true, false, false], [true, true, false], [true; 3]]
        {
            let mut half = solved(part(cut, true, essential));
            let miss = differs(&half, &whole);
            assert!(miss < 1e-9, "{cut:?} {essential:?}: {miss:e}"); // what Newton's tolerance leaves
            let count = cut.iter().filter(|cut| **cut).count() as i32;
            let ratio = half.energy() * 2.0_f64.powi(count) / whole.energy();
            assert!((ratio - 1.0).abs() < 1e-9, "{cut:?} {essential:?}: {ratio}");
            let alone = differs(&solved(part(cut, false, essential)), &whole);
            assert!(alone > 1e-4, "{cut:?} without images: {alone:e}");
        }
    }
}

/// Thin parts repeat between two planes; planes aslant to each other, and those that a support is not symmetric to, have no images.
#[test]
fn between_two_planes_the_body_repeats() {
    // A slab between y = 0 and y = 1 that may not bulge: plane strain, whatever is behind. The same three times as wide.
    let slab = |width: f64| {
        let mut parts = block([4.0, width, 2.0], [9, (2.0 * width) as usize + 1, 5], 0.0);
        parts.support = Support::ellipsoid([1.25; 3]);
        for at in [0.0, width] {
            let normal = Vec3::y();
            parts.conditions.push(Condition::held(nodes(&parts, |x| x.y == at), normal));
            parts.mirrors.push(Mirror { point: normal * at, normal });
        }
        parts.conditions.extend(Condition::fixed(&nodes(&parts, |x| x.x == 0.0)));
        parts.loads.push(Load::Pressure { faces: parts.cells.faces[5].clone(), pressure: 0.005 });
        solved(parts)
    };
    let (thin, wide) = (slab(1.0), slab(3.0));
    assert!(differs(&thin, &wide) < 1e-9, "{:e}", differs(&thin, &wide));
    for (node, x) in wide.rest().iter().enumerate() {
        let twin = thin.rest().iter().position(|y| x.x == y.x && x.z == y.z && y.y == 0.0).expect("a row");
        assert!((wide.displacement(node) - thin.displacement(twin)).norm() < 1e-9);
    }
    let aslant = |mirrors: Vec<Mirror>| {
        let mut parts = part([true, true, false], false, Essential::Collocation);
        parts.mirrors = mirrors;
        solved(parts)
    };
    let origin = Vec3::zeros();
    let one = Mirror { point: origin, normal: Vec3::x() };
    let other = Mirror { point: origin, normal: Vec3::new(-1.0, 1.0, 0.0) };
    assert_eq!(differs(&aslant(vec![one, other]), &aslant(Vec::new())), 0.0);
}

/// What planes and other supports bear balances the loads, as if there were no images.
#[test]
fn reactions_in_planes_balance_the_loads() {
    for essential in [Essential::Collocation, Essential::Direct] {
        let mut parts = part([true, true, false], true, essential);
        parts.loads = vec![Load::Body(Vec3::new(3e-3, -2e-3, 1e-3))];
        let conditions = parts.conditions.clone();
        let mut body = solved(parts);
        let supports = Supports::new(&body, &conditions, essential, None);
        let mut forces = vec![Vec3::zeros(); body.nodes()];
        supports.forces(&mut body, 1.0, &mut forces);
        let [load, _] = body.load_resultant(1.0);
        assert!((load - Vec3::new(18e-3, -12e-3, 6e-3)).norm() < 1e-14, "{load}"); // on six of volume
        let borne: Vec3 = forces.iter().sum();
        assert!((borne + load).norm() < 1e-9 * load.norm(), "{essential:?}: {borne} for {load}");
    }
}

/// Forces are the derivative of St Venant's energy, the tangent that of forces, with images as well.
#[test]
fn tangents_are_derivatives_of_the_forces() {
    let mut parts = part([true, true, false], true, Essential::Collocation);
    parts.basis = Basis::Quadratic;
    parts.material.formulation = solid_kinematics::Formulation::StVenant;
    parts.material.moduli = solid_kinematics::Moduli::isotropic(1.0, 0.45).expect("moduli");
    parts.conditions.truncate(2);
    let mut body = body(parts);
    wiggle(&mut body, 0.05);
    the_tangent_derives_from_forces("with images", &mut body, 7);
}
