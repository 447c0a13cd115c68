//! Heat that runs through solids, in balance and in time, and what solids do as they are warm.

mod bodies;

use std::f64::consts::PI;

use bodies::cylinder::{RADII, cylinder, radius};
use bodies::derivatives::{forces_derive_from_the_energy, the_tangent_derives_from_forces, wiggle};
use bodies::{block, body, curve, nodes};
use heat_conduction::HeatCourse;
use implicit_statics::Equilibrium;
use solid_kinematics::{Formulation, Moduli, Tangent, Tensor};
use sph_core::{FacePoint, Vec3};
use sr_galerkin::{Condition, Galerkin, Parts, Volumes};

/// Off a linear temperature by the quadrature, measured below a third of it.
const SUPPLIED: f64 = 4.4e-3;
/// Mean hoop stress of cells over that within: measured 4.5e-3 at ν = .3 and .017 at .45.
const TUBE: f64 = 0.05;

fn isotropic(conductivity: f64) -> Tensor {
    Tensor::identity() * conductivity
}

fn face(parts: &Parts, number: usize) -> Vec<FacePoint> {
    parts.cells.face_points(&parts.cells.faces[number], 3).expect("faces")
}

fn largest(body: &Galerkin, found: &[f64], exact: impl Fn(&Vec3) -> f64) -> f64 {
    body.rest().iter().zip(found).map(|(x, t)| (t - exact(x)).abs()).fold(0.0, f64::max)
}

/// A temperature that is linear in space, held at all nodes of the surface: what motions between held nodes leave is some thousandths of the greatest difference, as of
/// displacements (page of the crate).
#[test]
fn linear_temperatures_are_left_by_the_boundary_between_nodes() {
    let linear = |x: &Vec3| 3.0 + 2.0 * x.x - 5.0 * x.y + x.z;
    for (disorder, most) in [(0.0, 4e-3), (0.25, 1e-2)] {
        let parts = block([1.0, 0.8, 0.6], [7, 6, 5], disorder);
        let outside = nodes(&parts, |x| {
            [0, 1, 2].into_iter().any(|k| x[k].abs() < 1e-9 || (x[k] - [1.0, 0.8, 0.6][k]).abs() < 1e-9)
        });
        let body = body(parts);
        let tensor = Tensor::new(3.0, 0.5, 0.0, 0.5, 2.0, 0.2, 0.0, 0.2, 1.0);
        let mut conduction = body.conduction(&tensor);
        outside.iter().for_each(|&a| conduction.hold(&[a], linear(&body.rest()[a as usize])).unwrap());
        let found = conduction.steady().unwrap();
        let off = largest(&body, &found.values, linear) / 6.6;
        println!("disorder {disorder}: {off:.2e}, balance {:.1e}", found.balance.held);
        assert!(off < most, "{disorder}: {off}");
        assert!(found.balance.held.abs() < 1e-11);
    }
}

/// A slab with one face held and a film on the other: `q = (T₀ − T_∞)/(L/k + 1/h)`, whatever lies between.
#[test]
fn a_slab_gives_its_heat_to_a_film() {
    let parts = block([0.4, 0.2, 0.2], [9, 5, 5], 0.0);
    let (cold, hot) = (face(&parts, 1), nodes(&parts, |x| x.x == 0.0));
    let body = body(parts);
    let mut conduction = body.conduction(&isotropic(2.0));
    conduction.hold(&hot, 100.0).unwrap();
    conduction.film(&body, &cold, 30.0, 20.0).unwrap();
    let found = conduction.steady().unwrap();
    let flux = 80.0 / (0.4 / 2.0 + 1.0 / 30.0);
    let off = largest(&body, &found.values, |x| 100.0 - flux / 2.0 * x.x) / 80.0;
    println!("slab: {off:.2e}, heat {:.2e}", found.balance.held / (0.04 * flux) - 1.0);
    // Between nodes that are held, and by the quadrature: 1.8e-3; of the heat 7e-5.
    assert!(off < 6e-3 && (found.balance.held / (0.04 * flux) - 1.0).abs() < 2.2e-4);
    // All that enters leaves.
    assert!((found.balance.held + found.balance.film).abs() < 1e-11 * found.balance.held);
    // Where heat is supplied and not held, a linear temperature is left by the quadrature alone.
    let mut supplied = body.conduction(&isotropic(2.0));
    supplied.supply(&body, &face(&block([0.4, 0.2, 0.2], [9, 5, 5], 0.0), 0), flux).unwrap();
    supplied.film(&body, &cold, 30.0, 20.0).unwrap();
    let found = supplied.steady().unwrap();
    let off = largest(&body, &found.values, |x| 100.0 - flux / 2.0 * x.x) / 80.0;
    println!("supplied: {off:.2e}");
    assert!(off < SUPPLIED, "{off}");
}

/// Radii of a tube's wall and the logarithm between them; heat through a quarter of it, `k π/2 ΔT l/ln(b/a)`.
#[test]
fn the_wall_of_a_tube_has_a_logarithm() {
    let mut before = f64::INFINITY;
    for (across, most) in [(4, 3.3e-2), (8, 1e-2)] {
        let parts = cylinder(across);
        let long = parts.nodes.iter().map(|x| x.y).fold(0.0, f64::max);
        let [inner, outer] = RADII.map(|r| nodes(&parts, |x| (radius(x) - r).abs() < 1e-9));
        let body = body(parts);
        let mut conduction = body.conduction(&isotropic(3.0));
        conduction.hold(&inner, 1.0).unwrap();
        conduction.hold(&outer, 0.0).unwrap();
        let found = conduction.steady().unwrap();
        let exact = |x: &Vec3| 1.0 - libm::log(radius(x)) / libm::log(2.0);
        let off = largest(&body, &found.values, exact);
        let heat: f64 = inner.iter().map(|&a| found.held[a as usize]).sum();
        let whole = 3.0 * 0.5 * PI * long / libm::log(2.0);
        println!("{across} cells: {off:.2e}, heat {:.2e}", heat / whole - 1.0);
        assert!(off < most && off < before && (heat / whole - 1.0).abs() < 1e-2);
        before = off;
    }
}

/// A slab that is warm all through and cold at its ends from one moment on, by Fourier's series; what enters is what is stored, and halving what steps may be off by takes the error along.
#[test]
fn a_quenched_slab_cools_by_its_series() {
    let parts = block([1.0, 0.125, 0.125], [17, 3, 3], 0.0);
    let ends = nodes(&parts, |x| x.x == 0.0 || (x.x - 1.0).abs() < 1e-9);
    let middle = nodes(&parts, |x| (x - Vec3::new(0.5, 0.0625, 0.0625)).norm() < 1e-9)[0] as usize;
    let body = body(parts);
    let mut conduction = body.conduction(&isotropic(1.0));
    conduction.hold(&ends, 0.0).unwrap();
    let exact = |time: f64| {
        let term = |k: usize| {
            let n = (2 * k + 1) as f64;
            let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            sign * 4.0 / (n * PI) * libm::exp(-(n * PI).powi(2) * time)
        };
        (0..40).map(term).sum::<f64>()
    };
    let at = |tolerance: f64| {
        let capacity = conduction.capacity(&body, 1.0).unwrap();
        let mut course = HeatCourse::new(conduction.heat(), capacity, &vec![1.0; body.nodes()]).unwrap();
        course.advance(conduction.heat(), 0.1, tolerance).unwrap();
        let came = course.came().held;
        assert!((came / course.stored() - 1.0).abs() < 1e-11, "{came} {}", course.stored());
        (course.temperatures().values[middle], course.steps())
    };
    let (coarse, steps) = at(1e-3);
    let (fine, more) = at(1e-6);
    println!("series {:.6}: {coarse:.6} in {steps}, {fine:.6} in {more}", exact(0.1));
    // 16 cells leave 1.0e-4, steps of the tolerance .001 3.4e-4.
    assert!((fine - exact(0.1)).abs() < 3.1e-4 && (coarse - fine).abs() < 1e-3);
}

/// A free block of one temperature, or of one that is linear in space, is free of stress whatever its law.
#[test]
fn a_free_block_is_free_of_stress() {
    for (formulation, poisson) in
        [(bodies::MIDPOINT, 0.3), (Formulation::StVenant, 0.3), (bodies::MIDPOINT, 0.45)]
    {
        for slope in [0.0, 1.0] {
            let mut parts = block([1.0, 0.8, 0.6], [5, 4, 4], 0.0);
            parts.material.formulation = formulation;
            parts.material.moduli = Moduli::isotropic(1.0, poisson).expect("moduli");
            // One node wholly, one along y and z, one along z.
            let corner = |at: [f64; 3]| {
                nodes(&block([1.0, 0.8, 0.6], [5, 4, 4], 0.0), |x| (x - Vec3::from(at)).norm() < 1e-9)
            };
            parts.conditions.extend(Condition::fixed(&corner([0.0; 3])));
            let along = corner([1.0, 0.0, 0.0]);
            parts.conditions.push(Condition::held(along.clone(), Vec3::y()));
            parts.conditions.push(Condition::held(along, Vec3::z()));
            parts.conditions.push(Condition::held(corner([0.0, 0.8, 0.0]), Vec3::z()));
            let mut body = body(parts);
            let strain = |x: &Vec3| 1e-3 * (1.0 + slope * x.z);
            let strains = body.point_results().iter().map(|point| strain(&point.place)).collect();
            body.warm(strains);
            curve(&mut body, &[0.5, 1.0], |_| 0.0);
            let most = body
                .point_results()
                .iter()
                .flat_map(|point| point.stress)
                .fold(0.0_f64, |m, s| m.max(s.abs()));
            println!("{formulation:?}, ν = {poisson}, slope {slope}: {most:.1e}");
            // Of a temperature that is even 3e-15; a block that bends is free but for squares of its turns, 7e-8.
            assert!(most < if slope == 0.0 { 1e-14 } else { 2.1e-7 }, "{most}");
            let far =
                body.rest().iter().position(|x| x.x == 1.0 && x.y == 0.0 && x.z == 0.0).expect("corner");
            assert!((body.displacement(far).x - 1e-3).abs() < 3e-6);
        }
    }
}

/// Stresses of a tube whose wall is warm by `1 − ln(r/a)/ln(b/a)`, in plane strain \[boley1960\]: along the wall
/// `σ_θ = Eα/(1 − ν) (1/r² (r² + a²)/(b² − a²) ∫_a^b T r dr + 1/r² ∫_a^r T r dr − T)`.
#[test]
fn a_tube_that_is_warm_within_is_pressed_there() {
    let [a, b] = RADII;
    let warm = |r: f64| 1.0 - libm::log(r / a) / libm::log(b / a);
    let part = |r: f64| {
        let primitive = |r: f64| 0.5 * r * r * (1.0 - (libm::log(r / a) - 0.5) / libm::log(b / a));
        primitive(r) - primitive(a)
    };
    for poisson in [0.3, 0.45] {
        let size = 1e-5 / (1.0 - poisson);
        let exact = |r: f64| {
            size * ((r * r + a * a) / (b * b - a * a) * part(b) + part(r) - warm(r) * r * r) / (r * r)
        };
        let mut parts = cylinder(8);
        parts.loads.clear();
        parts.material.moduli = Moduli::isotropic(1.0, poisson).expect("moduli");
        let mut body = body(parts);
        let strains = body.point_results().iter().map(|point| 1e-5 * warm(radius(&point.place))).collect();
        body.warm(strains);
        curve(&mut body, &[1.0], |_| 0.0);
        let hoop = |own: &sr_galerkin::PointResult| {
            let [xx, _, zz, _, _, xz] = own.stress;
            let (r, x, z) = (radius(&own.place), own.place.x, own.place.z);
            (xx * z * z + zz * x * x - 2.0 * xz * x * z) / (r * r)
        };
        // Points of a cell share a part of their change of volume beyond ν = ⅓: the mean of each cell is read.
        let off = |cell: &[sr_galerkin::PointResult]| {
            let sum: f64 = cell.iter().map(|own| hoop(own) - exact(radius(&own.place))).sum();
            (sum / cell.len() as f64 / exact(a)).abs()
        };
        let most = body.point_results().chunks(27).map(off).fold(0.0, f64::max);
        println!("ν = {poisson}: {most:.2e} of {:.3e}", exact(a));
        assert!(most < TUBE, "{poisson}: {most}");
    }
}

/// A warm body keeps what every body keeps: forces derive from its energy, the tangent from its forces, and the load rate from both.
#[test]
fn warm_bodies_keep_their_derivatives() {
    for (volumes, formulation) in [
        (Volumes::Points, Formulation::StVenant),
        (Volumes::Mean, Formulation::StVenant),
        (Volumes::Mean, bodies::MIDPOINT),
    ] {
        let mut parts = block([1.0, 0.7, 0.5], [3, 3, 3], 0.1);
        (parts.volumes, parts.material.formulation) = (volumes, formulation);
        parts.tangent = Tangent::Consistent;
        parts.conditions.extend(Condition::fixed(&[0, 1]));
        let mut body = body(parts);
        let strains = (0..body.points()).map(|g| 0.02 * ((g * 5 % 7) as f64 - 2.0)).collect();
        body.warm(strains);
        wiggle(&mut body, 0.02);
        let mut forces = vec![0.0; body.unknowns()];
        // The energy is that of the level last put.
        body.internal(0.0, &mut forces);
        if formulation == Formulation::StVenant {
            forces_derive_from_the_energy(&mut body);
        }
        the_tangent_derives_from_forces("warm", &mut body, 7);
        let at = |level: f64, body: &mut Galerkin| {
            let mut out = vec![0.0; body.unknowns()];
            body.internal(level, &mut out);
            out
        };
        let mut rate = vec![0.0; body.unknowns()];
        body.load_rate(0.8, &mut rate);
        let (above, below) = (at(0.8 + 1e-4, &mut body), at(0.8 - 1e-4, &mut body));
        let scale = rate.iter().fold(0.0_f64, |most, own| most.max(own.abs()));
        assert!(scale > 0.0);
        for (i, rate) in rate.iter().enumerate() {
            let difference = -(above[i] - below[i]) / 2e-4;
            assert!((rate - difference).abs() < 1e-6 * scale, "{i}: {rate} {difference}");
        }
    }
}

/// Behind a plane of symmetry nodes have images: a half warms as the whole does.
#[test]
fn a_half_conducts_as_the_whole() {
    let whole = block([1.0, 0.25, 0.25], [9, 3, 3], 0.0);
    let mut half = block([0.5, 0.25, 0.25], [5, 3, 3], 0.0);
    let on = nodes(&half, |x| (x.x - 0.5).abs() < 1e-9);
    half.mirrors.push(sr_galerkin::Mirror { point: Vec3::new(0.5, 0.0, 0.0), normal: Vec3::x() });
    half.conditions.push(Condition::held(on, Vec3::x()));
    let answer = |parts: Parts| {
        let ends = nodes(&parts, |x| x.x == 0.0 || (x.x - 1.0).abs() < 1e-9);
        let body = body(parts);
        let mut conduction = body.conduction(&isotropic(1.0));
        conduction.hold(&ends, 1.0).unwrap();
        conduction.source(&body, 8.0);
        let found = conduction.steady().unwrap();
        let along =
            |(x, t): (&Vec3, &f64)| (x.y == 0.0 && x.z == 0.0 && x.x <= 0.5 + 1e-9).then_some((x.x, *t));
        body.rest().iter().zip(&found.values).filter_map(along).collect::<Vec<_>>()
    };
    for ((x, own), (_, other)) in answer(half).into_iter().zip(answer(whole)) {
        // One along x: 1 + 4 x (1 − x), which the quadratic basis has.
        println!("{x}: {own} {other}");
        assert!((own - other).abs() < 1e-9, "{x}: {own} {other}");
        assert!((own - (1.0 + 4.0 * x * (1.0 - x))).abs() < 6e-3);
    }
}
