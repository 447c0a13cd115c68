//! The cantilever under uniform load, K = 1 … 10, against the prototype's figures, beam theory and Holden's curve.

mod bodies;

use bodies::{On, as_in_the_source, body, cantilever, curve, tip};
use solid_kinematics::Formulation;

const TEN: [f64; 10] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0];
/// Where figures are given.
const GIVEN: [usize; 6] = [1, 2, 4, 6, 8, 10];

fn figures(on: On, formulation: Formulation, source: bool) -> Vec<f64> {
    let mut parts = cantilever(21, 10.0, on);
    parts.material.formulation = formulation;
    if source {
        as_in_the_source(&mut parts, 12.7);
    }
    let start = std::time::Instant::now();
    let mut body = body(parts);
    let built = start.elapsed();
    let (values, steps) = curve(&mut body, &TEN, tip);
    let iterations: Vec<usize> = steps.iter().map(|step| step.converged.iterations).collect();
    println!("{on:?} {formulation:?} {source}: built {built:?}, all {:?} {iterations:?}", start.elapsed());
    GIVEN.map(|k| values[k - 1]).to_vec()
}

#[test]
fn first() {
    for on in [On::Top, On::Volume] {
        for f in [bodies::MIDPOINT, Formulation::StVenant] {
            for source in [false, true] {
                println!("{:.5?}", figures(on, f, source));
            }
        }
    }
    println!("{:.5?}", figures(On::Follower, bodies::MIDPOINT, true));
}
