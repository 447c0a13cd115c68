//! i-beams: two flanges on a web, bent, twisted with and without warping \[vlasov1961\], and buckled aside, against beams in closed form.

use std::ops::ControlFlow;

use implicit_statics::{
    BucklingOptions, Control, PathOptions, Prebuckling, Start, follow, linear_buckling, unwatched,
};
use sph_core::{Cloud, Vec3};
use sph_shell::{Clamped, Held, Load, StaticShell, Supported};

use super::junctions::welded;
use crate::judge::{Case, Headline, Measured, Run, Variant};
use crate::methods::STATIC;
use crate::metric_names::ERROR;
use crate::support::meshes::particles;
use crate::support::sheets::{Answer, MaterialSection, force, linear, shell_of, supported};
use crate::support::studies::{finding, off, or_failed};
use crate::{JudgeError, Metric, Outcome};

/// The problems, their references, and how far the two may differ.
pub fn case() -> Case {
    Case {
        name: "i-beams",
        title: "I-beams of plates that share nodes",
        about: "Two flanges on a web: a cantilever under an end force, one under a torque whose root cannot warp, one that warps freely, and a \
                beam on forks that buckles aside under equal end moments.",
        citation: "Euler and Timoshenko with the shear flow of thin walls; St Venant; Vlasov 1961; Timoshenko and Gere 1961, lateral buckling; \
                   Vacharajittiphan, Woolcock and Trahair 1974, the beam bent before",
        variants: variants(),
        each,
        headline: Some(Headline::new(ERROR, 0.02)),
        ..Case::default()
    }
}

/// What is done to a beam.
#[derive(Clone, Copy, PartialEq)]
enum Problem {
    Bent,
    Twisted,
    TwistedAtRoot,
    Buckled,
    /// From the equilibrium of the bent beam at this level.
    BuckledBent,
}

/// Where the bent beam is asked for the way that is left.
const BENT: f64 = 0.9;

fn variants() -> Vec<Variant> {
    let study = |grid: &str, problem: Problem, n: usize| {
        Variant::study(STATIC, grid, move || Ok(or_failed(run(problem, n))))
    };
    vec![
        study("bending, 4 a plate", Problem::Bent, 4).quick(),
        study("bending, 12 a plate", Problem::Bent, 12),
        study("torsion of St Venant, 8 a plate", Problem::Twisted, 8).quick(),
        study("torsion of St Venant, 12 a plate", Problem::Twisted, 12),
        study("torsion, root held, 8 a plate", Problem::TwistedAtRoot, 8).quick(),
        study("torsion, root held, 12 a plate", Problem::TwistedAtRoot, 12),
        study("torsion, root held, 16 a plate", Problem::TwistedAtRoot, 16),
        // Flanges of few cells bend in their planes too easily, which a warning tells.
        study("lateral buckling, 4 a plate", Problem::Buckled, 4).quick(),
        study("lateral buckling, 8 a plate", Problem::Buckled, 8),
        study("lateral buckling, 12 a plate", Problem::Buckled, 12).quick(),
        study("lateral buckling, bent, 12 a plate", Problem::BuckledBent, 12),
    ]
}

/// Errors of the displacement along the loads, of the level of buckling \[%\].
#[rustfmt::skip] // a paragraph a method
const MEASURED: Measured = Measured(&[
    (STATIC, &[
        ("bending, 4 a plate", 1.17), ("bending, 12 a plate", 0.051),
        ("torsion of St Venant, 8 a plate", 0.459), ("torsion of St Venant, 12 a plate", 0.685),
        ("torsion, root held, 8 a plate", 1.36), ("torsion, root held, 12 a plate", 1.07),
        ("torsion, root held, 16 a plate", 0.953),
        ("lateral buckling, 4 a plate", 8.07), ("lateral buckling, 8 a plate", 2.36),
        ("lateral buckling, 12 a plate", 1.29), ("lateral buckling, bent, 12 a plate", 1.47),
    ]),
]);

fn each(run: &Run) -> Result<Vec<Metric>, JudgeError> {
    let reason = "one point a cell bends in its plane 1/n² too softly; edges of plates bear no twisting moment, .7 % of J";
    let error = off(run.last("ratio")?).map(f64::abs);
    Ok(vec![Metric::error(ERROR, error, "%").near(MEASURED.of(run)?, reason)])
}

const X: Vec3 = Vec3::new(1.0, 0.0, 0.0);
const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);
const Z: Vec3 = Vec3::new(0.0, 0.0, 1.0);

/// Steel, all plates alike \[m, Pa\].
const BODY: MaterialSection =
    MaterialSection { young: 2e11, poisson: 0.3, thickness: 0.002, density: 7850.0 };
/// Distance of the flanges' mid-surfaces, their width, the length \[m\].
const H: f64 = 0.15;
const B: f64 = 0.1;
const LONG: f64 = 4.0;

/// Moments of the section: I about the strong axis and about the weak one, J of three plates with two free edges each, I_ω; \[m⁴, m⁶\].
fn section() -> [f64; 4] {
    let t = BODY.thickness;
    let flange = t * B.powi(3) / 12.0;
    let strong = t * H.powi(3) / 12.0 + 2.0 * (B * t * H * H / 4.0 + B * t.powi(3) / 12.0);
    let weak = 2.0 * flange + H * t.powi(3) / 12.0;
    let torsion = (2.0 * (B - 0.63 * t) + H - 0.63 * t) * t.powi(3) / 3.0;
    [strong, weak, torsion, flange * H * H / 2.0]
}

/// Flexibility of shear by length, `∫q²/(Gt) ds` for the flow q of a unit force.
fn shear_flexibility() -> f64 {
    let t = BODY.thickness;
    let [strong, ..] = section();
    let shear = BODY.young / (2.0 * (1.0 + BODY.poisson));
    // Four halves of flanges, q = (t H/2I) s; the web, q = (t/2I)(B H + H²/4 − y²).
    let flanges = 4.0 * (t * H / (2.0 * strong)).powi(2) * (B / 2.0).powi(3) / 3.0;
    let a = B * H + H * H / 4.0;
    let web = (t / (2.0 * strong)).powi(2) * (a * a * H - 2.0 * a * H.powi(3) / 12.0 + H.powi(5) / 80.0);
    (flanges + web) / (shear * t)
}

/// The beam along x, its web upright: n cells a plate across.
fn beam(n: usize) -> Result<Cloud, String> {
    let along = 20 * n;
    let web = (-Z * (H / 2.0), [X * LONG, Z * H], [along, n]);
    let flange = |up: f64| (Z * (up * H / 2.0) - Y * (B / 2.0), [X * LONG, Y * B], [along, n]);
    welded(&[web, flange(1.0), flange(-1.0)])
}

/// Particles of a cross-section with their shares of its area; a place at which three plates meet is once in each.
fn shares(cloud: &Cloud, n: usize, at: f64) -> Vec<(u32, f64)> {
    let own = particles(cloud, |x| (x.x - at).abs() < 1e-9);
    let share = |a: u32| {
        let (x, normal) = (cloud.positions[a as usize], cloud.frames[a as usize].n);
        let (size, end) = if normal.z.abs() > 0.5 {
            (B, x.y.abs() > B / 2.0 - 1e-9)
        } else {
            (H, x.z.abs() > H / 2.0 - 1e-9)
        };
        size / n as f64 * if end { 0.5 } else { 1.0 }
    };
    own.into_iter().map(|a| (a, share(a))).collect()
}

/// Work of loads given by shares and forces on them.
fn work(answer: &Answer, loads: &[(Vec<(u32, f64)>, Vec3)]) -> f64 {
    let of = |(shares, total): &(Vec<(u32, f64)>, Vec3)| {
        let whole: f64 = shares.iter().map(|share| share.1).sum();
        shares.iter().map(|&(a, share)| share / whole * answer.motion[a as usize].dot(total)).sum::<f64>()
    };
    loads.iter().map(of).sum()
}

fn run(problem: Problem, n: usize) -> Result<Outcome, String> {
    let cloud = beam(n)?;
    let [strong, _, torsion, warping] = section();
    let (young, shear) = (BODY.young, BODY.young / (2.0 * (1.0 + BODY.poisson)));
    let flange = |part: (u32, f64)| cloud.frames[part.0 as usize].n.z.abs() > 0.5;
    let place = |part: &(u32, f64)| cloud.positions[part.0 as usize];
    let end = shares(&cloud, n, LONG);
    let on = |up: f64| -> Vec<(u32, f64)> {
        end.iter().copied().filter(|part| flange(*part) && place(part).z * up > 0.0).collect()
    };
    let torque = || vec![(on(1.0), Y / H), (on(-1.0), -Y / H)];
    let held = |displacement| Held { displacement, director: None };
    let section_at = |at: f64| particles(&cloud, |x| (x.x - at).abs() < 1e-9);
    let root = || section_at(0.0);
    let k = (shear * torsion / (young * warping)).sqrt();
    if matches!(problem, Problem::Buckled | Problem::BuckledBent) {
        return buckled(&cloud, n, problem == Problem::BuckledBent);
    }
    let (supports, loads, exact) = match problem {
        Problem::Bent => {
            let web = end.iter().copied().filter(|part| !flange(*part)).collect();
            let exact = LONG.powi(3) / (3.0 * young * strong) + LONG * shear_flexibility();
            (vec![supported(root(), Clamped)], vec![(web, Z)], exact)
        }
        Problem::Twisted => {
            let middle = particles(&cloud, |x| x.x < 1e-9 && x.y.abs() < 1e-9 && x.z.abs() < 1e-9);
            let far = particles(&cloud, |x| x.x > LONG - 1e-9 && x.y.abs() < 1e-9 && x.z.abs() < 1e-9);
            let supports = vec![
                supported(root(), held(vec![Y, Z])),
                supported(middle, held(vec![X])),
                supported(far, held(vec![Y, Z])),
            ];
            (supports, torque(), LONG / (shear * torsion))
        }
        _ => {
            let exact = (LONG - libm::tanh(k * LONG) / k) / (shear * torsion);
            (vec![supported(root(), Clamped)], torque(), exact)
        }
    };
    let applied: Vec<Box<dyn Load>> =
        loads.iter().map(|(shares, total): &(Vec<(u32, f64)>, Vec3)| force(shares.clone(), *total)).collect();
    let answer = linear(shell_of(BODY, cloud.clone(), STATIC, supports, applied)?)?;
    let ratio = work(&answer, &loads) / exact;
    Ok(Outcome { warnings: answer.warnings, ..finding(cloud.len(), cloud.spacing(), &[("ratio", ratio)]) })
}

/// Level of lateral buckling under equal end moments, over `(π/L) √(E I_y (G J + π² E I_ω/L²))`; of the bent beam, over that by
/// `√(1 − I_y/I_x)`: twist of a curved beam bends it aside.
fn buckled(cloud: &Cloud, n: usize, bent: bool) -> Result<Outcome, String> {
    let [strong, weak, torsion, warping] = section();
    let (young, shear) = (BODY.young, BODY.young / (2.0 * (1.0 + BODY.poisson)));
    let wave = std::f64::consts::PI / LONG;
    let moment = wave * (young * weak * (shear * torsion + wave * wave * young * warping)).sqrt();
    let held = |displacement| Held { displacement, director: None };
    let ends = particles(cloud, |x| x.x < 1e-9 || x.x > LONG - 1e-9);
    let middle =
        particles(cloud, |x| (x.x - LONG / 2.0).abs() < 1e-9 && x.y.abs() < 1e-9 && x.z.abs() < 1e-9);
    let supports: Vec<Supported> = vec![supported(ends, held(vec![Y, Z])), supported(middle, held(vec![X]))];
    // Stresses M z/I at both ends, as forces of the upper and of the lower half.
    let mut loads: Vec<Box<dyn Load>> = Vec::new();
    for (at, sign) in [(0.0, 1.0), (LONG, -1.0)] {
        for up in [1.0, -1.0] {
            let z = |a: u32| cloud.positions[a as usize].z;
            let half: Vec<(u32, f64)> = (shares(cloud, n, at).into_iter())
                .filter(|part| z(part.0) * up > 1e-9)
                .map(|(a, share)| (a, share * z(a).abs()))
                .collect();
            let sum: f64 = half.iter().map(|part| part.1).sum();
            loads.push(force(half, X * (sign * up * sum * BODY.thickness * moment / strong)));
        }
    }
    let shell = shell_of(BODY, cloud.clone(), STATIC, supports, loads)?;
    let warnings = coque::warnings(&shell);
    let mut system = StaticShell::new(shell);
    // The classical formula leaves the bend out, and so do stresses alone.
    let mut options = BucklingOptions { prebuckling: Prebuckling::Stress, ..BucklingOptions::new(1) };
    let mut from = 0.0;
    if bent {
        (options.prebuckling, from) = (Prebuckling::Rotations, BENT);
        let path = PathOptions::new(Control::Load { step: BENT / 4.0, until: BENT });
        let path = follow(&mut system, &Start::default(), &path, |_, _| ControlFlow::Continue(()));
        path.end.map_err(|error| error.to_string())?;
    }
    let factor = if bent { (1.0 - weak / strong).sqrt() } else { 1.0 };
    let found = linear_buckling(&mut system, from, &options, &mut unwatched);
    let found = found.map_err(|error| error.to_string())?;
    let ratio = found.modes.first().map_or(f64::NAN, |mode| factor * mode.level.abs());
    Ok(Outcome { warnings, ..finding(cloud.len(), cloud.spacing(), &[("ratio", ratio)]) })
}
