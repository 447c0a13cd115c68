//! Cantilever: a scene, that is a problem as text, solved without time and held against the exact elastica.
//!
//! A thin strip is clamped at one end and lifted by a dead force P at the other, so far that its tip stands nearly
//! upright. With the slope θ and the curvature κ along the arc s, both scaled by the length L, the exact strip obeys
//!
//! ```text
//! θ' = κ,   κ' = −α cos θ,   x' = cos θ,   z' = sin θ,     α = P L²/EI
//! θ(0) = 0,   κ(1) = 0                                     (clamped; no couple at the tip)     [mattiasson1981]
//! ```
//!
//! [`Scene`] → [`coque::Model`] → [`coque::Outcome`] is all that most problems need: the command `coque run` does no
//! more. The scene says `[analysis.static]`; with `[analysis.explicit.quasi-static]` the same particles would be
//! marched in time.
//!
//! `cargo run --release -p coque --example 2_cantilever`; before: `1_patch_test`, next: `3_roll_up`.

use std::error::Error;

use coque::{Ended, Scene, Silent};

const SCENE: &str = r#"
title = "Cantilever under an end force, P L²/EI = 4"
units = { length = "m", force = "N", time = "s" }

[geometry.plate]
lengths = [10.0, 1.0]
particles = [41, 3]

[material.elastic]
young = 1.2e6
poisson = 0.0       # the elastica knows no cross-section that warps
density = 1.0

[section.homogeneous]
thickness = 0.1     # EI = 100 N m²

[[supports]]
on = "u0"           # the edge x = 0; u1 is the edge x = 10
clamped = {}

[[loads]]
on = "u1"
force = { total = [0.0, 0.0, 4.0] }

[analysis.static]
levels = 8

[[curve]]
name = "u"
of = "displacement"
on = "u1"
direction = [-1.0, 0.0, 0.0]

[[curve]]
name = "w"
of = "displacement"
on = "u1"
direction = [0.0, 0.0, 1.0]
"#;

/// Length of the strip \[m\] and P L²/EI at level one.
const LENGTH: f64 = 10.0;
const FULL_LOAD: f64 = 4.0;
/// Distance of the tip from the elastica over L. Shear and stretch, which the elastica leaves out, are 1e-4 at t/L = 1/100.
const TOLERANCE: f64 = 2e-4;

fn main() -> Result<(), Box<dyn Error>> {
    let outcome = Scene::parse(SCENE, "2_cantilever")?.build(1)?.run(&mut Silent);
    if outcome.ended != Ended::Done {
        return Err(outcome.ended.to_string().into());
    }
    let column = |name: &str| outcome.curve.column(name).ok_or(format!("the curve has no column {name}"));
    let (levels, u, w) = (column("level")?, column("u")?, column("w")?);
    println!("{:>6} {:>9} {:>9} {:>9} {:>9} {:>9}", "level", "u/L", "exact", "w/L", "exact", "off");
    let mut worst = 0.0_f64;
    for (i, level) in levels.iter().enumerate().skip(1) {
        let (u, w) = (u[i] / LENGTH, w[i] / LENGTH);
        let exact = elastica(FULL_LOAD * level);
        let off = libm::hypot(u - exact[0], w - exact[1]);
        println!("{level:>6} {u:>9.5} {:>9.5} {w:>9.5} {:>9.5} {off:>9.1e}", exact[0], exact[1]);
        worst = worst.max(off);
    }
    if worst > TOLERANCE {
        return Err(format!("the tip is off by {worst:.1e} of L, at most {TOLERANCE:.0e} is allowed").into());
    }
    Ok(())
}

/// Displacements `[u, w]` of the tip over L: shoots for the curvature at the clamp, κ(0) = α x(1), by bisection.
fn elastica(alpha: f64) -> [f64; 2] {
    let [mut low, mut high] = [0.0, alpha];
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if shoot(alpha, middle)[1] > 0.0 { high = middle } else { low = middle }
    }
    let [_, _, x, z] = shoot(alpha, high);
    [1.0 - x, z]
}

/// `[θ, κ, x, z]` at the tip from the curvature at the clamp: four-stage Runge–Kutta, error 1e-9 in 200 steps.
fn shoot(alpha: f64, curvature: f64) -> [f64; 4] {
    let rate = |q: [f64; 4]| [q[1], -alpha * libm::cos(q[0]), libm::cos(q[0]), libm::sin(q[0])];
    let go = |q: [f64; 4], k: [f64; 4], h: f64| std::array::from_fn(|i| q[i] + h * k[i]);
    let (mut q, h) = ([0.0, curvature, 0.0, 0.0], 1.0 / 200.0);
    for _ in 0..200 {
        let a = rate(q);
        let b = rate(go(q, a, 0.5 * h));
        let c = rate(go(q, b, 0.5 * h));
        let d = rate(go(q, c, h));
        q = std::array::from_fn(|i| q[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
    }
    q
}
