//! Moving least squares reproduce their basis with its derivatives; hexahedra integrate what Gauss's rule does.

use sph_core::{
    Basis, BlockLattice, Hexahedra, HexahedraError, MovingLeastSquares, NodePlaces, ShapeError, Support,
    Vec3, Weight, kernels,
};

const SIZE: [f64; 3] = [4.0, 3.0, 2.0];
const STEP: [f64; 3] = [0.5, 0.5, 0.4];

fn nodes(disorder: f64) -> Vec<Vec3> {
    let lattice = BlockLattice {
        dimensions: 3,
        lengths: SIZE,
        spacing: STEP,
        origin: Vec3::zeros(),
        nodes: NodePlaces::Edges,
        grading: [1.0; 3],
        disorder,
        seed: 5,
    };
    lattice.block().expect("a block").positions
}

/// Every basis on its support, with every weight.
fn all() -> Vec<(Basis, Support, Weight)> {
    let times = |f: [f64; 3]| [0, 1, 2].map(|k| f[k] * STEP[k]);
    let mut weights = vec![Weight::Csrbf2];
    weights.extend(kernels().map(Weight::Kernel));
    let mut out = Vec::new();
    for weight in weights {
        out.push((Basis::Linear, Support::sphere(1.25), weight));
        out.push((Basis::Quadratic, Support::ellipsoid(times([2.5; 3])), weight));
        out.push((Basis::Quadratic, Support::tensor(times([2.5; 3])), weight));
        for across in 0..3 {
            out.push((Basis::Plate17 { across }, Support::tensor(times([3.5; 3])), weight));
        }
    }
    out
}

fn places() -> [Vec3; 5] {
    // a corner, an edge, a face, the inside and a node
    [[0.0, 0.0, 0.0], [1.3, 0.0, 2.0], [4.0, 1.1, 0.9], [2.123, 1.456, 0.789], [2.0, 1.5, 0.8]]
        .map(|[x, y, z]| Vec3::new(x, y, z))
}

/// Monomials up to degree three that a basis reproduces, as exponents.
fn monomials(basis: Basis) -> Vec<[i32; 3]> {
    let mut out = vec![[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]];
    if basis != Basis::Linear {
        out.extend([[2, 0, 0], [0, 2, 0], [0, 0, 2], [1, 1, 0], [0, 1, 1], [1, 0, 1]]);
    }
    if let Basis::Plate17 { across } = basis {
        for [u, v, h] in [[3, 0, 0], [2, 1, 0], [1, 2, 0], [0, 3, 0], [2, 0, 1], [1, 1, 1], [0, 2, 1]] {
            let mut powers = [0; 3];
            (powers[(across + 1) % 3], powers[(across + 2) % 3], powers[across]) = (u, v, h);
            out.push(powers);
        }
    }
    out
}

fn monomial(x: &Vec3, e: [i32; 3]) -> f64 {
    x.x.powi(e[0]) * x.y.powi(e[1]) * x.z.powi(e[2])
}

#[test]
fn shape_functions_reproduce_their_basis_and_its_gradient() {
    for disorder in [0.0, 0.25] {
        let nodes = nodes(disorder);
        for (basis, support, weight) in all() {
            let squares = MovingLeastSquares::new(&nodes, basis, support, weight).unwrap();
            for place in places() {
                let shape = squares.at(&place).unwrap();
                for e in monomials(basis) {
                    let mut sums = [0.0; 4];
                    for (i, &node) in shape.nodes.iter().enumerate() {
                        let f = monomial(&nodes[node as usize], e);
                        sums[0] += shape.values[i] * f;
                        (0..3).for_each(|k| sums[k + 1] += shape.gradients[i][k] * f);
                    }
                    let slope = |k: usize| {
                        let mut less = e;
                        less[k] -= 1;
                        if e[k] > 0 { e[k] as f64 * monomial(&place, less) } else { 0.0 }
                    };
                    // Monomials are up to 64; moment matrices have condition numbers up to 1e6 here: measured 2e-10.
                    assert!((sums[0] - monomial(&place, e)).abs() < 1e-9, "{basis:?} {e:?}: {}", sums[0]);
                    for k in 0..3 {
                        let miss = (sums[k + 1] - slope(k)).abs();
                        assert!(miss < 1e-8, "{basis:?} {e:?} along {k}: {miss:e}");
                    }
                }
            }
        }
    }
}

#[test]
fn gradients_are_the_derivatives_of_the_values() {
    let nodes = nodes(0.25);
    let step = 1e-5;
    for (basis, support, weight) in all() {
        let squares = MovingLeastSquares::new(&nodes, basis, support, weight).unwrap();
        for place in places() {
            let shape = squares.at(&place).unwrap();
            for k in 0..3 {
                let beside = |sign: f64| {
                    let mut x = place;
                    x[k] += sign * step;
                    let shape = squares.at(&x).unwrap();
                    let mut full = vec![0.0; nodes.len()];
                    shape.nodes.iter().zip(&shape.values).for_each(|(&node, &v)| full[node as usize] = v);
                    full
                };
                let (after, before) = (beside(1.0), beside(-1.0));
                for (i, &node) in shape.nodes.iter().enumerate() {
                    let difference = (after[node as usize] - before[node as usize]) / (2.0 * step);
                    // third derivatives up to 1e3, times step²; rounding 1e-13/step where M is worst
                    let miss = (shape.gradients[i][k] - difference).abs();
                    assert!(miss < 1e-6, "{basis:?} node {node} along {k}: {miss:e}");
                }
            }
        }
    }
}

#[test]
fn too_few_and_coplanar_neighbours_are_named() {
    let nodes = nodes(0.0);
    let narrow =
        MovingLeastSquares::new(&nodes, Basis::Quadratic, Support::sphere(0.6), Weight::Csrbf2).unwrap();
    let error = narrow.at(&places()[3]).unwrap_err();
    assert!(matches!(error, ShapeError::TooFew { terms: 10, .. }), "{error}");
    assert!(error.to_string().contains("(2.1230e0, 1.4560e0, 7.8900e-1)"), "{error}");
    let sheet: Vec<Vec3> = nodes.iter().copied().filter(|x| x.z == 0.0).collect();
    let flat = MovingLeastSquares::new(&sheet, Basis::Linear, Support::sphere(1.25), Weight::Csrbf2).unwrap();
    let error = flat.at(&Vec3::new(2.0, 1.0, 0.0)).unwrap_err();
    assert!(matches!(error, ShapeError::Condition { .. }), "{error}");
    let none = MovingLeastSquares::new(&nodes, Basis::Linear, Support::sphere(0.0), Weight::Csrbf2);
    assert_eq!(none.err(), Some(ShapeError::Radius { axis: 0, value: 0.0 }));
}

fn planes() -> [Vec<f64>; 3] {
    [vec![0.0, 1.0, 3.0], vec![-1.0, 0.5], vec![2.0, 2.5, 3.5, 4.0]]
}

#[test]
fn hexahedra_integrate_volumes_and_areas() {
    let cells = Hexahedra::between(&planes()).unwrap();
    assert_eq!(cells.cells.len(), 6);
    for rule in 1..=4 {
        let points: Vec<_> = cells.volume_points(rule).unwrap().into_iter().flatten().collect();
        assert_eq!(points.len(), 6 * rule.pow(3));
        let degree = 2 * rule as i32 - 1; // Gauss's rule is exact up to it
        let sum: f64 = points.iter().map(|p| p.volume * p.place.x.powi(degree)).sum();
        let exact = 1.5 * 2.0 * 3.0_f64.powi(degree + 1) / f64::from(degree + 1);
        assert!((sum / exact - 1.0).abs() < 1e-13, "rule {rule}: {sum} for {exact}");
        let mut closed = Vec3::zeros();
        for (number, area) in [3.0, 3.0, 6.0, 6.0, 4.5, 4.5].into_iter().enumerate() {
            let points = cells.face_points(&cells.faces[number], rule).unwrap();
            let sum: Vec3 = points.iter().map(|p| p.area()).sum();
            let mut outward = Vec3::zeros();
            outward[number / 2] = if number % 2 == 0 { -area } else { area };
            assert!((sum - outward).norm() < 1e-13, "face {number}: {sum}");
            closed += sum;
        }
        assert!(closed.norm() < 1e-13);
    }
}

#[test]
fn a_sheared_cell_keeps_its_volume_and_a_folded_one_is_refused() {
    let mut cells = Hexahedra::between(&planes()).unwrap();
    cells.corners.iter_mut().for_each(|x| x.x += 0.4 * x.z - 0.2 * x.y);
    let volume: f64 = cells.volume_points(2).unwrap().iter().flatten().map(|p| p.volume).sum();
    assert!((volume - 9.0).abs() < 1e-13);
    cells.corners.iter_mut().for_each(|x| x.y = -x.y);
    assert!(matches!(cells.volume_points(2), Err(HexahedraError::Folded { cell: 0, .. })));
    assert_eq!(cells.volume_points(5).err(), Some(HexahedraError::Rule(5)));
    let planes = [vec![0.0, 1.0, 1.0], vec![0.0, 1.0], vec![0.0, 1.0]];
    let error = Hexahedra::between(&planes).unwrap_err();
    assert_eq!(error, HexahedraError::Planes { axis: 0, number: 2, value: 1.0 });
}
