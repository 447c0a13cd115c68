//! Forces are the derivative of the work at a fixed history, tangents that of the forces; unloading is elastic.

use shell_kinematics::{IsotropicSection, Memory, Pack, Plastic, PlasticSection, RValues, Section};

use crate::common::*;
use crate::plies::stack;

/// Sections with a history, and strains at which each flows in part.
fn states() -> impl Iterator<Item = (&'static str, Specimen, shell_kinematics::Strains)> {
    hardenings().into_iter().flat_map(|(name, hardening)| {
        [0.0, 1500.0].into_iter().flat_map(move |kinematic| {
            let mut random = Random(19);
            let plain = Plastic::new(elastic(), hardening.clone()).kinematic(kinematic).unwrap();
            let rolled = plain.clone().anisotropic(RValues::new(1.8, 1.2, 2.2).unwrap());
            (0..9).map(move |round| {
                let material = if round % 2 == 0 { &plain } else { &rolled };
                let section = match round {
                    8 => stack(1500.0, 0.0),
                    _ => PlasticSection::new(material.clone(), THICKNESS, 6).unwrap(),
                };
                let mut specimen = Specimen::new(section);
                let mut strains = random.strains(0.01, 0.02);
                specimen.commit(&strains);
                strains = plus(&strains, &random.strains(3e-3, 6e-3), 1.0);
                specimen.commit(&strains);
                (name, specimen, plus(&strains, &random.strains(1e-3, 2e-3), 1.0))
            })
        })
    })
}

/// A component of eight moved by a step.
fn moved(strains: &shell_kinematics::Strains, place: usize, by: f64) -> shell_kinematics::Strains {
    let mut parts = components(strains);
    parts[place] += Pack::splat(by);
    crate::common::strains(parts)
}

fn steps() -> [f64; 8] {
    std::array::from_fn(|i| if (3..6).contains(&i) { 1e-7 / THICKNESS } else { 1e-7 })
}

#[test]
fn forces_are_the_derivative_of_the_work() {
    let mut worst = Vec::new();
    for (_, specimen, strains) in states() {
        let energy = |s: &_| specimen.section.energy_from(s, &specimen.history);
        let force = forces(&specimen.resultants(&strains));
        for (place, step) in steps().into_iter().enumerate() {
            let slope = (energy(&moved(&strains, place, step)) - energy(&moved(&strains, place, -step)))
                * (0.5 / step);
            worst.extend((slope - force[place]).lanes().map(|apart| apart.abs() / sizes()[place]));
        }
    }
    worst.sort_by(f64::total_cmp);
    let at = |share: f64| worst[((worst.len() - 1) as f64 * share) as usize];
    println!("median {:.1e}, 99 % {:.1e}, most {:.1e}", at(0.5), at(0.99), at(1.0));
    // 8e-10, of the square of the step: a flow that turns. In one state of these a slice begins to flow within the step.
    assert!(at(0.99) < 3e-9 && at(1.0) < 3e-6, "{:.1e} {:.1e}", at(0.99), at(1.0));
}

#[test]
fn tangents_are_the_derivative_of_the_forces() {
    let mut worst = Vec::new();
    let stiffness = YOUNG / (1.0 - POISSON * POISSON);
    for (_, specimen, strains) in states() {
        let tangent = specimen.section.tangent_from(&strains, &specimen.history);
        for (column, step) in steps().into_iter().enumerate() {
            let force = |by: f64| forces(&specimen.resultants(&moved(&strains, column, by)));
            let (up, down) = (force(step), force(-step));
            for row in 0..8 {
                let slope = (up[row] - down[row]) * (0.5 / step);
                let size = stiffness * sizes()[row] * sizes()[column] / (YIELD * YIELD * THICKNESS);
                worst.extend((slope - tangent[row][column]).lanes().map(|apart| apart.abs() / size));
                assert!(tangent[row][column] == tangent[column][row], "not symmetric");
            }
        }
    }
    worst.sort_by(f64::total_cmp);
    let at = |share: f64| worst[((worst.len() - 1) as f64 * share) as usize];
    println!("median {:.1e}, 99 % {:.1e}, most {:.1e}", at(0.5), at(0.99), at(1.0));
    // 8e-10, of the square of the step: a flow that turns. In one state of these a slice begins to flow within the step.
    assert!(at(0.99) < 3e-9, "{:.1e}", at(0.99));
}

/// At the strains of the last commit points that flowed have the plastic tangent: the answer to going on, not to going back.
#[test]
fn a_step_begins_on_the_plastic_side() {
    let mut specimen = Specimen::new(linear(2000.0, 2));
    let mut now = membrane([0.01, 0.0, 0.0]);
    now = specimen.solved(&now, &[1, 2]);
    specimen.commit(&now);
    let on = specimen.section.tangent_from(&now, &specimen.history);
    let (a, b, c) = (first(on[0][0]), first(on[0][1]), first(on[1][1]));
    let uniaxial = (a - b * b / c) / THICKNESS;
    let exact = YOUNG * 2000.0 / (YOUNG + 2000.0);
    assert!((uniaxial / exact - 1.0).abs() < 1e-9, "{uniaxial} {exact}");
    // One part in a million of the yield stress below it is elastic.
    let below = membrane([0.01 - 1e-6 * YIELD / YOUNG, 0.0, 0.0]);
    let below = plus(&now, &plus(&below, &membrane([0.01, 0.0, 0.0]), -1.0), 1.0);
    let off = specimen.section.tangent_from(&below, &specimen.history);
    assert!((first(off[0][0]) / (YOUNG / (1.0 - POISSON * POISSON) * THICKNESS) - 1.0).abs() < 1e-14);
}

/// Below yield the section is the elastic one; held, it answers to any further strain as that one does.
#[test]
fn what_does_not_flow_is_elastic() {
    let closed = IsotropicSection::new(elastic(), THICKNESS).unwrap();
    let mut random = Random(23);
    let mut worst = 0.0_f64;
    for slices in [2, 3, 6, 40] {
        let specimen = Specimen::new(linear(2000.0, slices));
        let small = random.strains(2e-4, 2e-4);
        let (a, b) = (fresh(&specimen.section, &small), fresh(&closed, &small));
        let tangent = specimen.section.tangent(&small);
        let exact = closed.tangent(&small);
        for i in 0..8 {
            worst = worst.max(most(a[i] - b[i]) / sizes()[i]);
            for j in 0..8 {
                let size = YOUNG * sizes()[i] * sizes()[j] / (YIELD * YIELD * THICKNESS);
                worst = worst.max(most(tangent[i][j] - exact[i][j]) / size);
            }
        }
        worst = worst.max(most(specimen.section.energy(&small) - closed.energy(&small)));
    }
    println!("{worst:.1e}");
    // 1e-15: rounding.
    assert!(worst < 1e-14, "{worst:.1e}");

    let mut worst = 0.0_f64;
    // Those of one material.
    for (_, specimen, strains) in states().filter(|(_, specimen, _)| specimen.section.fewest_slices() == 6) {
        let further = random.strains(0.02, 0.0);
        let held = |s: &_| forces(&specimen.section.held_resultants(s, &specimen.history));
        let (from, to) = (held(&strains), held(&plus(&strains, &further, 1.0)));
        let elastic = fresh(&closed, &further);
        for i in [0, 1, 2, 6, 7] {
            worst = worst.max(most(to[i] - from[i] - elastic[i]) / sizes()[i]);
        }
    }
    println!("{worst:.1e}");
    // 1e-13 of forces a hundred times the yield force.
    assert!(worst < 1e-12, "{worst:.1e}");
}
