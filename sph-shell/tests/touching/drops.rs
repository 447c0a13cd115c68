//! Sheets thrown at each other at random: nothing crosses at moderate speeds, nothing crosses without a word at any, energy is kept.
//!
//! `DROPS=1000 cargo test --release -p sph-shell --test touching -- drops --nocapture` throws a thousand.

use crate::audit::crossings;
use crate::common::{DENSITY, POISSON, RandomNumbers, Sheets, X, Y, YOUNG, parts};
use contact::{Law, stiffness};
use explicit_dynamics::{Event, March, Transient};
use nalgebra::{Rotation3, Unit};
use sph_core::Vec3;
use sph_shell::{Formulation, OwnContact, Reach, Shell};

/// Cells of both have about this size.
const SPACING: f64 = 0.1;

/// A smaller sheet above a larger one, in any attitude, that flies at it at a speed over that of sound.
struct Drop {
    thickness: f64,
    speed: f64,
    friction: f64,
    shell: Shell,
    first: usize,
}

fn sound() -> f64 {
    (YOUNG / (DENSITY * (1.0 - POISSON * POISSON))).sqrt()
}

fn drop(seed: u64) -> Drop {
    let mut dice = RandomNumbers(seed.wrapping_mul(2654435761).wrapping_add(17));
    (0..8).for_each(|_| {
        dice.roll();
    });
    let mut between = |low: f64, high: f64| low + (high - low) * 0.5 * (1.0 + dice.roll());
    let thickness = SPACING * libm::exp2(between(-3.3, 0.0));
    let speed = libm::exp2(between(-9.0, -2.0));
    let friction = if between(0.0, 1.0) < 0.5 { 0.0 } else { 0.3 };
    let counts =
        [between(2.0, 5.0), between(1.0, 4.0), between(5.0, 8.0), between(5.0, 8.0)].map(|n| n as usize);
    let axis = Unit::new_normalize(Vec3::new(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0)));
    // Some lie flat but for a little, most stand somehow.
    let angle = between(0.0, 1.6).powi(2);
    let turn = Rotation3::from_axis_angle(&axis, angle);
    let size = SPACING * between(0.7, 1.3);
    let [u, v] = [X * (size * counts[0] as f64), Y * (size * counts[1] as f64)].map(|way| turn * way);
    let corners = [Vec3::zeros(), u, v, u + v];
    let low = corners.iter().map(|x| x.z).fold(f64::INFINITY, f64::min);
    let target = [X * (SPACING * counts[2] as f64), Y * (SPACING * counts[3] as f64)];
    let over = (target[0] * between(-0.1, 1.1)) + target[1] * between(-0.1, 1.1);
    let middle = (u + v) * 0.5;
    let up = Vec3::z() * (1.02 * thickness - low);
    let origin = Vec3::new(over.x - middle.x, over.y - middle.y, 0.0) + up;
    let cloud = Sheets::default()
        .add(Vec3::zeros(), target, [counts[2], counts[3]])
        .add(origin, [u, v], [counts[0], counts[1]])
        .apart();
    let first = (counts[2] + 1) * (counts[3] + 1);
    let stiffness = 0.5 * stiffness(YOUNG, thickness, cloud.spacing());
    let own = OwnContact { law: Law::new(0.05).unwrap(), stiffness, edges: true, friction };
    let aslant = Vec3::new(between(-0.7, 0.7), between(-0.7, 0.7), -1.0);
    let spin = Vec3::new(between(-1.0, 1.0), between(-1.0, 1.0), between(-1.0, 1.0));
    let mut shell = Shell::builder(parts(cloud, Formulation::StressPoint(Reach::Cell), thickness))
        .touching_itself(own)
        .build()
        .unwrap();
    let centre = origin + middle;
    for a in first..shell.len() {
        let about = spin.cross(&(shell.position(a) - centre)) / (middle.norm() * 2.0);
        let rate = spin.cross(&shell.director(a)) / (middle.norm() * 2.0);
        let speed = speed * sound();
        shell.set_rate(a, (aslant + about) * speed, rate * speed);
    }
    Drop { thickness, speed, friction, shell, first }
}

/// What became of it: the greatest error of the energy over that at the start, crossings, whether it ended before its time.
struct Course {
    energy: f64,
    crossed: usize,
    ended: bool,
    touched: bool,
}

fn course(shell: &mut Shell, speed: f64) -> Course {
    let duration = 4.0 * SPACING / (speed * sound());
    let run = Transient { duration, record_every: 0.05 * duration, damping: 0.0, safety: 0.8 };
    let mut march = March::start(run, shell).unwrap();
    let (mut found, mut start) =
        (Course { energy: 0.0, crossed: 0, ended: false, touched: false }, None::<f64>);
    loop {
        match march.advance(shell) {
            Ok(Event::Record(record)) => {
                let whole = *start.get_or_insert(record.energy.kinetic + record.energy.internal);
                found.energy = found.energy.max(record.balance_error.abs() / whole);
                found.crossed += crossings(shell);
            }
            Ok(Event::End) => return found,
            Ok(_) => {}
            Err(_) => return Course { ended: true, ..found },
        }
        found.touched |= shell.own_touch().unwrap().area > 0.0;
    }
}

/// Of the thousand: see docs/contact.md.
#[test]
fn sheets_thrown_at_random_do_not_cross_without_a_word_and_keep_their_energy() {
    let count = std::env::var("DROPS").ok().and_then(|count| count.parse().ok()).unwrap_or(24);
    let (mut touched, mut ended, mut worst, mut failures) = (0, 0, [0.0_f64; 2], Vec::new());
    for seed in 0..count {
        let Drop { thickness, speed, friction, mut shell, first } = drop(seed);
        let found = course(&mut shell, speed);
        touched += usize::from(found.touched);
        ended += usize::from(found.ended);
        let slow = speed < 0.1 * thickness / SPACING;
        let kept = usize::from(speed > 0.05);
        if !found.ended {
            worst[kept] = worst[kept].max(found.energy);
        }
        let fails =
            found.crossed > 0 || (slow && found.ended) || (kept == 0 && !found.ended && found.energy > 0.035);
        if fails {
            failures.push(seed);
            println!(
                "{seed}: t/h {:.3}, v/c {speed:.4}, friction {friction}, {first} of {}: {} crossings, energy {:.1e}, ended {}",
                thickness / SPACING,
                shell.len(),
                found.crossed,
                found.energy,
                found.ended
            );
        }
    }
    println!(
        "{count} thrown, {touched} touched, {ended} ended early; energy {:.1e}, faster {:.1e}",
        worst[0], worst[1]
    );
    assert!(touched * 2 > count as usize, "{touched} of {count}");
    assert!(failures.is_empty(), "{failures:?}");
}
