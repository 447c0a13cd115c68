//! Parameters that are no temperatures: the same bar by its nodes, and by parameters of which the temperatures are sums.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

use heat_conduction::{
    Capacity, Conduction, ConductionError, Conducts, Eliminated, Entry, HeatCourse, Network, Radiation,
};

const NODES: usize = 6;

/// Pairs of neighbours, and one across.
fn pairs() -> Vec<(u32, u32, f64)> {
    let mut out: Vec<_> = (0..NODES as u32 - 1).map(|a| (a, a + 1, 2.0 + f64::from(a))).collect();
    out.push((1, 4, 0.7));
    out
}

/// Temperatures from parameters: rows that sum to one.
fn phi(node: usize, parameter: usize) -> f64 {
    match node.abs_diff(parameter) {
        0 if node == 0 || node == NODES - 1 => 0.8,
        0 => 0.6,
        1 => 0.2,
        _ => 0.0,
    }
}

/// The bar by such parameters.
struct Summed;

impl Conducts for Summed {
    fn parameters(&self) -> usize {
        NODES
    }

    fn visit(&self, _temperatures: &[f64], mut found: impl FnMut(Entry)) {
        // ΦᵀKΦ, from pairs: g (φ_a − φ_b)ᵀ(φ_a − φ_b).
        for (a, b, conductance) in pairs() {
            let along = |c: usize| phi(a as usize, c) - phi(b as usize, c);
            for row in 0..NODES {
                for column in 0..NODES {
                    let value = conductance * along(row) * along(column);
                    found(Entry { row: row as u32, column: column as u32, value, factor: 1.0 });
                }
            }
        }
    }

    fn eliminate(&self, held: &[u32]) -> Option<Vec<Eliminated>> {
        // The first node alone is held here.
        assert_eq!(held, [0]);
        let terms = (1..NODES).filter(|&c| phi(0, c) != 0.0).map(|c| (c as u32, -phi(0, c) / phi(0, 0)));
        Some(vec![Eliminated { parameter: 0, terms: terms.collect(), moves: vec![(0, 1.0 / phi(0, 0))] }])
    }

    fn at_nodes(&self, parameters: &[f64]) -> Vec<f64> {
        (0..NODES).map(|a| (0..NODES).map(|c| phi(a, c) * parameters[c]).sum()).collect()
    }
}

const LAST: u32 = NODES as u32 - 1;
const RADIATES: Radiation = Radiation { factor: 1e-9, surroundings: 250.0, zero: 0.0 };

/// By nodes: held at the first, a film and radiation at the last, heat in the middle.
fn by_nodes() -> Conduction<Network> {
    let mut bar = Conduction::new(Network::new(NODES, pairs()));
    bar.hold(&[0], 400.0).unwrap();
    bar.supply(2, 30.0);
    bar.film(LAST, 1.5, 300.0);
    bar.radiate(LAST, RADIATES);
    bar
}

/// The same by parameters.
fn by_parameters() -> Conduction<Summed> {
    let parts = |node: usize| {
        (0..NODES).map(|c| (c as u32, phi(node, c))).filter(|own| own.1 != 0.0).collect::<Vec<_>>()
    };
    let mut bar = Conduction::with_places(Summed);
    bar.hold(&[0], 400.0).unwrap();
    parts(2).into_iter().for_each(|(c, share)| bar.supply(c, 30.0 * share));
    let last = bar.place(parts(NODES - 1));
    bar.film(last, 1.5, 300.0);
    bar.radiate(last, RADIATES);
    bar
}

fn off(found: &[f64], other: &[f64]) -> f64 {
    found.iter().zip(other).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn sums_of_parameters_find_the_temperatures_of_nodes() {
    let (one, other) = (by_nodes().steady().unwrap(), by_parameters().steady().unwrap());
    // Numbers of some hundreds through a factor of five unknowns.
    assert!(off(&one.values, &other.values) < 1e-9, "{:?} {:?}", one.values, other.values);
    assert!(off(&one.held, &other.held) < 1e-9 && (one.balance.film - other.balance.film).abs() < 1e-9);
    let sum = one.balance.supplied + one.balance.held + one.balance.film + one.balance.radiated;
    assert!(sum.abs() < 1e-9, "{sum}");
}

/// The same in time, where parameters store heat in pairs.
#[test]
fn sums_of_parameters_find_the_course_of_nodes() {
    let stores = |a: usize| 1.0 + 0.3 * a as f64;
    let capacity = Capacity { own: (0..NODES).map(stores).collect(), pairs: Vec::new() };
    let product = |c: usize, d: usize| (0..NODES).map(|a| stores(a) * phi(a, c) * phi(a, d)).sum::<f64>();
    let all = (0..NODES).flat_map(|c| (0..c).map(move |d| (c, d)));
    let pairs = all.map(|(c, d)| (c as u32, d as u32, product(c, d))).filter(|own| own.2 != 0.0).collect();
    let summed = Capacity { own: (0..NODES).map(|c| product(c, c)).collect(), pairs };
    let (nodes, parameters) = (by_nodes(), by_parameters());
    let mut one = HeatCourse::new(&nodes, capacity, &[280.0; NODES]).unwrap();
    let mut other = HeatCourse::new(&parameters, summed, &[280.0; NODES]).unwrap();
    one.advance(&nodes, 0.7, 1e-5).unwrap();
    other.advance(&parameters, 0.7, 1e-5).unwrap();
    let (here, there) = (one.temperatures(), other.temperatures());
    // Estimates are of parameters, and choose steps by themselves: what steps leave is some tolerances.
    assert!(off(&here.values, &there.values) < 1e-3, "{:?} {:?}", here.values, there.values);
    assert!(off(&here.held, &there.held) < 1e-2, "{:?} {:?}", here.held, there.held);
    for course in [&one, &other] {
        let came = course.came();
        let sum = came.supplied + came.held + came.film + came.radiated;
        assert!((sum / course.stored() - 1.0).abs() < 1e-11, "{sum} {}", course.stored());
    }
}

#[test]
fn pieces_and_contradictions_are_named() {
    let mut two = Conduction::new(Network::new(5, vec![(0, 1, 1.0), (3, 2, 1.0)]));
    let pieces = two.conductor().pieces();
    assert_eq!(pieces, [vec![0, 1], vec![2, 3], vec![4]]);
    two.hold(&[1], 4.0).unwrap();
    assert_eq!(two.untold(&pieces), Some(2));
    let other = two.hold(&[1], 5.0);
    assert!(matches!(other, Err(ConductionError::Contradiction { particle: 1, .. })), "{other:?}");
    two.film(3, 1.0, 8.0);
    assert_eq!(two.untold(&pieces), Some(4));
    two.film(4, 2.0, 9.0);
    assert_eq!(two.untold(&pieces), None);
    let found = two.steady().unwrap();
    assert!(off(&found.values, &[4.0, 4.0, 8.0, 8.0, 9.0]) < 1e-12);
}
