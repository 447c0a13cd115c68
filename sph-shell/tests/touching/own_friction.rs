//! A shell that rubs on itself: momentum, energy with what friction takes, stops on the way.

use crate::common::{DENSITY, POISSON, YOUNG, momenta, parts};
use contact::{Law, stiffness};
use explicit_dynamics::{Event, March, Transient};
use sph_core::{Cylinder, EndWeights, Vec3, lattice};
use sph_shell::{Formulation, OwnContact, Reach, Shell};

const THICKNESS: f64 = 0.05;
/// Of the walls over that of sound.
const SPEED: f64 = 0.05;

fn sound() -> f64 {
    (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt()
}

/// A tube, open along its length, whose walls are thrown at each other, the upper one along the axis as well.
fn thrown(friction: f64, threads: usize) -> Shell {
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.1], length: 1.0 };
    let cloud = lattice(&shape, [41, 8], EndWeights::Trapezoid).unwrap();
    let rest = cloud.positions.clone();
    let stiffness = 0.5 * stiffness(YOUNG, THICKNESS, cloud.spacing());
    let own = OwnContact { law: Law::new(0.05).unwrap(), stiffness, edges: true, friction };
    let parts = parts(cloud, Formulation::StressPoint(Reach::Cell), THICKNESS);
    let builder = Shell::builder(sph_shell::Parts { threads, ..parts });
    let mut shell = builder.touching_itself(own).build().unwrap();
    for (a, x) in rest.iter().enumerate() {
        let wave = 1.0 + 0.3 * libm::sin(5.0 * x.y + 3.0 * x.x);
        shell.set_rate(a, Vec3::new(0.1 * x.x, 0.1 * x.z, -x.z * wave) * (SPEED * sound()), Vec3::zeros());
    }
    shell
}

fn transient() -> Transient {
    let duration = 1.6 / (SPEED * sound());
    Transient { duration, record_every: 0.02 * duration, damping: 0.0, safety: 0.8 }
}

/// Energy and losses measured 1.4e-3 of the energy at the start, momentum to rounding; friction takes 4 % of it, but for the last step that at the
/// particles.
#[test]
fn walls_that_rub_keep_momentum_and_lose_what_friction_takes() {
    let mut shell = thrown(0.3, 1);
    let (first, sizes) = momenta(&shell);
    let mut march = March::start(transient(), &mut shell).unwrap();
    let (mut energy, mut most, mut start, mut taken) = (0.0_f64, [0.0_f64; 2], None, 0.0);
    loop {
        match march.advance(&mut shell).unwrap() {
            Event::Record(record) => {
                let whole = *start.get_or_insert(record.energy.kinetic + record.energy.internal);
                energy = energy.max(record.balance_error.abs() / whole);
                taken = record.energy.dissipated / whole;
                let (now, _) = momenta(&shell);
                for i in 0..2 {
                    most[i] = most[i].max((now[i] - first[i]).norm() / sizes[i]);
                }
            }
            Event::End => break,
            _ => {}
        }
    }
    let lost: f64 = (0..shell.len()).map(|a| shell.friction_loss(a)).sum::<f64>() / start.unwrap();
    println!("energy {energy:.1e}, momentum {most:?}, taken {taken:.2e}, at particles {lost:.2e}");
    assert!(energy < 4.5e-3 && most.iter().all(|error| *error < 1e-13), "{energy:.1e} {most:?}");
    assert!(taken > 1e-3 && (lost / taken - 1.0).abs() < 1e-3, "{taken} {lost}");
}

#[test]
fn threads_and_a_stop_on_the_way_leave_the_bits_as_they_are() {
    let mut lasts = Vec::new();
    for (threads, stops) in [(1, [u64::MAX; 2]), (3, [u64::MAX; 2]), (1, [271, 321])] {
        let mut shell = thrown(0.3, threads);
        let mut march = March::start(transient(), &mut shell).unwrap();
        let mut stopped = 0;
        while !matches!(march.advance(&mut shell).unwrap(), Event::End) {
            if let Some(at) = march.state().filter(|at| stops.contains(&at.clock.steps)) {
                let (history, kept, [state, rates]) =
                    (shell.history(), shell.contact_state(), shell.motion());
                let mut other = thrown(0.3, threads);
                assert!(other.take_up([state, rates]));
                assert!(!other.take_up_history(&history[1..]));
                assert!(other.take_up_history(&history) && other.take_up_contact(&kept));
                march = March::resume(transient(), at.clone());
                shell = other;
                stopped += 1;
            }
        }
        assert_eq!(stopped, if stops[0] < u64::MAX { 2 } else { 0 });
        let lost: f64 = (0..shell.len()).map(|a| shell.friction_loss(a)).sum();
        assert!(lost > 0.0);
        lasts.push((shell.motion()[0].to_vec(), march.clock().steps, lost.to_bits()));
    }
    assert!(lasts[1] == lasts[0], "threads");
    assert!(lasts[2] == lasts[0], "a stop");
}

/// Smooth walls are those without a coefficient, to the bit; negative ones are refused.
#[test]
fn a_coefficient_of_zero_is_none_and_a_negative_one_is_refused() {
    let shell = thrown(0.0, 1);
    assert!(!shell.has_friction() && shell.history().is_empty());
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.1], length: 1.0 };
    let cloud = lattice(&shape, [11, 4], EndWeights::Trapezoid).unwrap();
    let own = OwnContact { law: Law::SHARP, stiffness: 1.0, edges: false, friction: -0.1 };
    let parts = parts(cloud, Formulation::StressPoint(Reach::Cell), THICKNESS);
    assert!(Shell::builder(parts).touching_itself(own).build().is_err());
}
