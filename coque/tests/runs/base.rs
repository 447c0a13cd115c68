//! A base that is shaken in time: one degree of freedom under a record against the recurrence that is exact for it, bodies that nothing holds, a record in
//! g against its numbers in the units of the scene.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use std::f64::consts::TAU;

use crate::common::{column, overridden, ran, text};
use coque::{Ended, Outcome, Scene};

/// A record of 0.4 s, from nothing to nothing, in parts of g.
const RECORD: [f64; 11] = [0.0, 0.21, -0.13, 0.34, 0.05, -0.4, -0.22, 0.31, 0.17, -0.08, 0.0];
const STEP: f64 = 0.04;
const G: f64 = 9.80665;

/// The record as PEER writes it.
fn at2() -> String {
    let numbers: Vec<String> = RECORD.iter().map(|x| format!("{x:.7E}")).collect();
    let numbers = numbers.chunks(5).map(|five| five.join(" ")).collect::<Vec<_>>().join("\n");
    format!(
        "A RECORD\nSOMEWHERE\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 11, DT= .0400 SEC\n{numbers}\n"
    )
}

/// A stiff plate that moves as one body along x alone, of 3 kg in SI, on a spring of one hertz and a half.
fn oscillator(units: &str, [metre, newton]: [f64; 2], amplitude: &str, response: &str) -> Outcome {
    let (length, force) = (1.0 / metre, 1.0 / newton);
    let area = 0.12 * length * length;
    let mass = 3.0 * force / length;
    let stiffness = mass * (TAU * 1.5) * (TAU * 1.5);
    let scene = format!(
        r#"
title = "One degree of freedom"
units = {units}
geometry.plate = {{ lengths = [{a:?}, {b:?}], particles = [3, 3] }}
material.elastic = {{ young = {young:?}, poisson = 0.0, density = {density:?} }}
section.homogeneous = {{ thickness = {t:?} }}
rigid = [{{ on = "all" }}]
supports = [
    {{ on = "all", held = {{ displacement = [[0, 1, 0], [0, 0, 1]], director = [[1, 0, 0]] }} }},
    {{ on = "all", spring = {{ direction = [1, 0, 0], stiffness = {stiffness:?} }} }},
]
[analysis.explicit]
safety = 2e-3
[analysis.explicit.transient]
duration = 1.0
record_every = 0.01
damping = 1.2
base = {{ acceleration = [1, 0, 0], amplitude = {amplitude}, response = "{response}" }}
[[curve]]
name = "u"
of = "displacement"
on = "all"
direction = [1, 0, 0]
[[curve]]
name = "v"
of = "velocity"
on = "all"
direction = [1, 0, 0]
[files]
"a.at2" = """
{}"""
"#,
        at2(),
        a = 0.4 * length,
        b = 0.3 * length,
        t = 0.01 * length,
        young = 1e6 * force / (length * length),
        density = mass / (area * 0.01 * length),
    );
    let outcome = ran(Scene::parse(&scene, "one.toml"));
    assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
    outcome
}

/// Displacements and velocities of `ü + c u̇ + ω² u = −a` at equal times, by the recurrence of Nigam and Jennings [nigam1969], exact for straight lines between the
/// points of the record; zero after it.
fn recurrence(omega: f64, c: f64, every: f64, count: usize) -> Vec<[f64; 2]> {
    let zeta = 0.5 * c / omega;
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    let a = |t: f64| {
        let at = t / STEP;
        let i = (at + 1e-9) as usize;
        if i + 1 >= RECORD.len() {
            0.0
        } else {
            G * (RECORD[i] + (at - i as f64) * (RECORD[i + 1] - RECORD[i]))
        }
    };
    let [mut x, mut v] = [0.0; 2];
    let mut found = vec![[0.0; 2]];
    for i in 0..count {
        let t = i as f64 * every;
        let (a0, slope) = (-a(t), -(a(t + every) - a(t)) / every);
        let by_time = slope / (omega * omega);
        let by_one = (a0 - c * by_time) / (omega * omega);
        let (p, q) = (x - by_one, (v - by_time + zeta * omega * (x - by_one)) / damped);
        let decay = libm::exp(-zeta * omega * every);
        let (sin, cos) = (libm::sin(damped * every), libm::cos(damped * every));
        x = by_one + by_time * every + decay * (p * cos + q * sin);
        v = by_time + decay * (damped * (q * cos - p * sin) - zeta * omega * (p * cos + q * sin));
        found.push([x, v]);
    }
    found
}

const SI: &str = "{ length = \"m\", force = \"N\", time = \"s\" }";
const AT2: &str = "{ record = { file = \"a.at2\" } }";

/// A march that makes some 1500 steps a period: what they leave of the kinks of the record, a twelfth of (Δt/.04 s)², is 1e-5.
#[test]
fn one_degree_of_freedom_follows_the_exact_recurrence() {
    let exact = recurrence(TAU * 1.5, 1.2, 0.01, 100);
    let size = exact.iter().fold(0.0_f64, |most, [x, _]| most.max(x.abs()));
    let outcome = oscillator(SI, [1.0, 1.0], AT2, "relative");
    let found = column(&outcome, "u");
    let off = found.iter().zip(&exact).map(|(u, [x, _])| (u - x).abs()).fold(0.0, f64::max);
    assert_eq!(found.len(), exact.len());
    assert!(size > 0.01 && off < 3e-5 * size, "{} of {size}", off / size);
    // In space the plate has moved by what the base did beside it; velocities are those of half a step before, 2e-4 s at 5 m/s² at most.
    let space = oscillator(SI, [1.0, 1.0], AT2, "absolute");
    let points = RECORD.iter().enumerate().map(|(i, x)| [STEP * i as f64, G * x]).collect();
    let base = coque::scene::Amplitude::Table(points);
    let both = column(&space, "u").into_iter().zip(column(&space, "v")).zip(column(&space, "time"));
    for (((u, v), t), [x, rate]) in both.zip(&exact) {
        let [base_v, base_u] = base.integrals(t);
        assert!((u - x - base_u).abs() < 3e-5 * size, "{t}: {u}");
        assert!((v - rate - base_v).abs() < 3e-3, "{t}: {v} {}", rate + base_v);
    }
}

/// A record in g, the same in m/s² as CSV, and both in millimetres and kilonewtons.
#[test]
fn a_record_in_g_is_its_numbers_in_the_units_of_the_scene() {
    let table: Vec<String> =
        RECORD.iter().enumerate().map(|(i, x)| format!("[{:?}, {:?}]", STEP * i as f64, x * G)).collect();
    let table = format!("{{ table = [{}] }}", table.join(", "));
    let one = oscillator(SI, [1.0, 1.0], AT2, "absolute");
    assert_eq!(one.curve, oscillator(SI, [1.0, 1.0], &table, "absolute").curve);
    let small = oscillator("{ length = \"mm\", force = \"kN\", time = \"s\" }", [1e-3, 1e3], AT2, "absolute");
    let size = column(&one, "u").iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    for (m, mm) in column(&one, "u").into_iter().zip(column(&small, "u")) {
        assert!((1e-3 * mm - m).abs() < 1e-9 * size, "{m} m, {mm} mm");
    }
}

/// Nothing holds the body: in space it stays where it is, however the base moves, but for what steps of the march leave of the integral of its load.
#[test]
fn what_nothing_holds_stays_in_space() {
    let shell = "geometry.plate = { lengths = [0.4, 0.3], particles = [5, 4] }
        material.elastic = { young = 7e9, poisson = 0.3, density = 2700.0 }
        section.homogeneous = { thickness = 0.01 }
        masses = [{ on = \"u1\", mass = 2.0 }]";
    let solid = "bodies.block.solid.geometry.block = { lengths = [0.4, 0.2, 0.2], spacing = 0.1 }
        bodies.block.solid.material.elastic = { young = 7e7, poisson = 0.25, density = 2700.0 }
        bodies.block.solid.formulation.state-based = { horizon = 1.5 }";
    let rigid = "bodies.box.rigid.geometry.box = { min = [0, 0, 0], max = [0.4, 0.3, 0.2], spacing = 0.1 }
        bodies.box.rigid.density = 2700.0";
    for body in [shell, solid, rigid] {
        let scene = format!(
            "title = 'Free'
            units = {SI}
            {body}
            analysis.explicit.transient = {{ duration = 0.05, record_every = 0.01, base = {{ acceleration = [2, 1, -3], amplitude = {{ smooth = 0.04 }}, response = 'absolute' }} }}
            curve = [
                {{ name = 'u', of = 'displacement', on = 'all', direction = [1, 2, 3] }},
                {{ name = 'v', of = 'velocity', on = 'all', direction = [1, 2, 3] }},
                {{ name = 'far', of = 'displacement', on = 'all', direction = [1, 0, 0], take = 'max' }},
            ]"
        );
        let outcome = ran(Scene::parse(&scene, "free.toml"));
        assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
        // The base goes by some 3e-3 m at .1 m/s; velocities of solids are those of half a step before, which the base gains in that time.
        for (name, bound) in [("u", 1e-5), ("v", 5e-4), ("far", 1e-5)] {
            let most = column(&outcome, name).iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            assert!(most < bound, "{body}: {name} {most}");
        }
    }
}

/// Base mirrored: the answer mirrored.
#[test]
fn the_answer_goes_with_the_base() {
    let [one, mirrored] = ["[0, 0, 1]", "[0, 0, -1]"].map(shaken_deck);
    let size = one.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    assert!(size > 1.0 && one.iter().zip(&mirrored).all(|(a, b)| (a + b).abs() < 1e-9 * size));
}

/// Thrice as much of a base that hardly moves the deck: thrice its way. The squares of its way over the wall's length, 4e-7, are left out, and rounding adds up:
/// 1.6e-12 in all.
#[test]
fn where_ways_are_small_the_answer_grows_with_the_base() {
    let [one, three] = ["[0, 0, 1e-4]", "[0, 0, 3e-4]"].map(shaken_deck);
    let size = one.iter().fold(0.0_f64, |most, w| most.max(w.abs()));
    let off = one.iter().zip(&three).map(|(a, b)| (3.0 * a - b).abs()).fold(0.0, f64::max);
    assert!(size > 1e-3 && off < 5e-12 * size, "{}", off / size);
}

/// Ways of the deck over a second of the quake \[mm\].
fn shaken_deck(acceleration: &str) -> Vec<f64> {
    let short = ("analysis.explicit.transient.duration", "1.0");
    let base = ("analysis.explicit.transient.base.acceleration", acceleration);
    let scene = text("deck-in-quake.toml");
    column(&ran(overridden(&scene, "deck-in-quake.toml", &[short, base])), "w_deck")
}
