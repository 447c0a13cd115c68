//! Answers through ties: frames, boxes, halves of a plate, large rotation, marches, supports and refusals.

#![allow(clippy::unwrap_used)] // a test may stop where it stands

mod common;

use common::{Sheets, X, Y, Z, at, line, parts, supported};
use explicit_dynamics::{Amplitude, Clock};
use implicit_statics::{BucklingOptions, Equilibrium, Newton, NewtonOptions, linear_buckling, linear_response, unwatched};
use shell_kinematics::{Isotropic, IsotropicSection};
use sph_core::{Cloud, Vec3};
use sph_shell::{
    AppliedLoad, Clamped, Force, Formulation, Held, Load, Parts, Reach, Shell, ShellError, StaticShell, Support,
    Supported, SymmetryPlane, Tie,
};

const CELL: Formulation = Formulation::StressPoint(Reach::Cell);

fn elastic(young: f64, poisson: f64, thickness: f64) -> Box<IsotropicSection> {
    Box::new(IsotropicSection::new(Isotropic::new(young, poisson).unwrap(), thickness).unwrap())
}

fn body(
    cloud: Cloud,
    section: Box<IsotropicSection>,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
    ties: &[Tie],
) -> Shell {
    let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let loads = loads.into_iter().map(applied).collect();
    let mut body = Shell::new(Parts { section, supports, loads, ..parts(cloud, CELL, 0.1) }).unwrap();
    body.tie(ties).unwrap();
    body
}

/// Work of the load on the linear answer.
fn work(body: Shell) -> f64 {
    let mut system = StaticShell::new(body);
    let mut load = vec![0.0; system.unknowns()];
    system.load_rate(0.0, &mut load);
    let u = linear_response(&mut system, 0.0).unwrap();
    load.iter().zip(&u).map(|(f, u)| f * u).sum()
}

/// A bar of length two and a stem of length one up from its middle, between its lines, with other cells across.
fn tee(n: usize, bar: usize, wide: f64, across: [usize; 2]) -> (Cloud, Vec<Tie>) {
    let cloud = Sheets::default()
        .add(-X, [X * 2.0, Y * wide], [bar, across[0]])
        .add(Vec3::zeros(), [Z, Y * wide], [n, across[1]])
        .cloud();
    let edge = at(&cloud, |x| x.x.abs() < 1e-9 && x.z < 1e-9);
    let host = (0..(bar * across[0]) as u32).collect();
    (cloud, vec![Tie { edge, host }])
}

#[test]
fn a_stem_between_the_lines_of_a_bar_sways_as_beams_say() {
    let (young, thickness, wide) = (1200.0, 0.01_f64, 0.3);
    let ei = young * thickness.powi(3) * wide / 12.0;
    let (ea, ga) = (young * thickness * wide, 5.0 / 12.0 * young * thickness * wide);
    let couple = 0.5;
    let hold = couple * 0.5 / ei / (1.0 / (3.0 * ei) + 1.0 / ga);
    let turn = couple / ei - hold * 0.5 / ei;
    let exact = 1.0 / (3.0 * ei) + 1.0 / ga + turn + 0.5 / ea;
    for (n, bar) in [(5, 10), (10, 20), (20, 40), (40, 80), (5, 11), (10, 21), (20, 41), (40, 81)] {
        let (cloud, ties) = tee(n, bar, wide, [2, 3]);
        let tip = at(&cloud, |x| x.z > 1.0 - 1e-9);
        let force = Force { shares: line(&cloud, &tip), total: X };
        let clamp = supported(at(&cloud, |x| x.x.abs() > 1.0 - 1e-9), Clamped);
        let error = work(body(cloud, elastic(young, 0.0, thickness), vec![clamp], vec![Box::new(force)], &ties)) / exact - 1.0;
        println!("{n} cells a leg, {bar}: {:.4} %", 100.0 * error);
    }
}

/// A box of one by one, five long, of walls whose cells do not match; a torque at its end by all walls, over that of St Venant.
fn boxed(n: usize, m: usize, along: [usize; 2]) -> f64 {
    let corner = -(X + Z) * 0.5;
    let sheets = Sheets::default()
        .add(corner, [X, Y * 5.0], [n, along[0]])
        .add(corner + Z, [X, Y * 5.0], [n, along[0]])
        .add(corner, [Z, Y * 5.0], [m, along[1]])
        .add(corner + X, [Z, Y * 5.0], [m, along[1]]);
    let cloud = sheets.cloud();
    let flat = 2 * (n * along[0]) as u32;
    let host: Vec<u32> = (0..flat).collect();
    let edge = at(&cloud, |x| x.z.abs() > 0.5 - 1e-9);
    let sides = [(X, -Z), (-X, Z), (Z, X), (-Z, -X)];
    let on_corner = |x: &Vec3| x.x.abs() > 0.5 - 1e-9 && x.z.abs() > 0.5 - 1e-9;
    let mut loads: Vec<Box<dyn Load>> = Vec::new();
    for (out, direction) in sides {
        let own = at(&cloud, |x| x.y > 5.0 - 1e-9 && x.dot(&out) > 0.5 - 1e-9);
        let share = |a: u32| if on_corner(&cloud.positions[a as usize]) { 0.25 } else { 1.0 };
        let shares = own.into_iter().map(|a| (a, share(a))).collect();
        loads.push(Box::new(Force { shares, total: direction * 0.5 }));
    }
    let foot = at(&cloud, |x| x.y < 1e-9);
    let held = |displacement| Held { displacement, director: None };
    let three = at(&cloud, |x| x.y < 1e-9 && on_corner(x) && x.x + x.z < 0.5);
    let supports = vec![supported(foot, held(vec![X, Z])), supported(three, held(vec![Y]))];
    let t = 0.05_f64;
    let exact = 5.0 * 2.6 / (1e6 * (t + 4.0 * t.powi(3) / 3.0));
    work(body(cloud, elastic(1e6, 0.3, t), supports, loads, &[Tie { edge, host }])) / exact
}

#[test]
fn a_box_of_walls_that_do_not_match_twists_as_st_venant_says() {
    for (n, m, along) in [(4, 5, [20, 23]), (4, 6, [20, 37]), (8, 7, [40, 33]), (8, 11, [40, 57]), (16, 21, [80, 111])] {
        println!("{n}×{} and {m}×{}: {:.3} %", along[0], along[1], 100.0 * (boxed(n, m, along) - 1.0));
    }
}

/// Halves of a strip of two by one, cut across, of other cells: [pulled, bent by an end force, twisted] over the whole.
fn halves(n: usize, m: usize, finer_hangs: bool) -> [f64; 3] {
    let answers = |m: usize| {
        let whole = m == 0;
        let m = if whole { n } else { m };
        let cloud = Sheets::default()
            .add(Vec3::zeros(), [X, Y], [n, n])
            .add(X * if whole { 1.0 } else { 1.0 }, [X, Y], [m, m])
            .cloud();
        (cloud, m)
    };
    let mut out = [0.0; 3];
    for (k, pull) in [X, Z, Z].into_iter().enumerate() {
        let of = |tied: bool| {
            let (cloud, own) = answers(m);
            let (cloud, ties) = if tied {
                let joint = |first: bool| -> Vec<u32> {
                    let cut = ((n + 1) * (n + 1)) as u32;
                    at(&cloud, |x| (x.x - 1.0).abs() < 1e-9).into_iter().filter(|&a| (a < cut) == first).collect()
                };
                let (near, far) = ((0..(n * n) as u32).collect(), ((n * n) as u32..(n * n + own * own) as u32).collect());
                let tie = if finer_hangs == (m > n) { Tie { edge: joint(false), host: near } } else { Tie { edge: joint(true), host: far } };
                (Cloud { joined: Vec::new(), ..cloud.clone() }, vec![tie])
            } else {
                (Sheets::default().add(Vec3::zeros(), [X * 2.0, Y], [2 * n, n]).cloud(), Vec::new())
            };
            let end = at(&cloud, |x| x.x > 2.0 - 1e-9);
            let sign = |a: u32| if k == 2 { cloud.positions[a as usize].y - 0.5 } else { 1.0 };
            let mut shares = line(&cloud, &end);
            let y = |a: u32| cloud.positions[a as usize].y;
            for share in &mut shares {
                share.1 *= sign(share.0);
            }
            let whole: f64 = shares.iter().map(|share| share.1).sum();
            let total = if k == 2 { 1.0 } else { whole };
            let loads: Vec<Box<dyn Load>> = if k == 2 {
                // A torque of one: up on one side, down on the other.
                let arm: f64 = shares.iter().map(|&(a, s)| s * (y(a) - 0.5)).sum();
                let half = |up: bool| {
                    let own: Vec<(u32, f64)> = shares.iter().copied().filter(|s| (s.1 > 0.0) == up && s.1 != 0.0).collect();
                    let sum: f64 = own.iter().map(|s| s.1).sum();
                    Box::new(Force { shares: own, total: pull * (sum / arm) }) as Box<dyn Load>
                };
                vec![half(true), half(false)]
            } else {
                vec![Box::new(Force { shares, total: pull * (total / whole) })]
            };
            let clamp = supported(at(&cloud, |x| x.x < 1e-9), Clamped);
            work(body(cloud, elastic(1200.0, 0.3, 0.02), vec![clamp], loads, &ties))
        };
        out[k] = of(true) / of(false);
    }
    out
}

#[test]
fn halves_of_a_plate_that_do_not_match_answer_nearly_as_the_whole() {
    for (n, m) in [(8, 11), (8, 13), (16, 23), (32, 45)] {
        for finer in [true, false] {
            let off = halves(n, m, finer).map(|ratio| 100.0 * (ratio - 1.0));
            println!("{n} and {m}, the {} hangs: pulled {:.3}, bent {:.3}, twisted {:.3} %", if finer { "finer" } else { "coarser" }, off[0], off[1], off[2]);
        }
    }
}
