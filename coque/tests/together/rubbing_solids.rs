//! Solids of bonds and rigid bodies that rub on tools and on other bodies: inclines on which they slide, stick and roll, what turns with a tool, momentum,
//! the same bits from checkpoints and on any threads, mirror, units, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, done, last, overridden, ran, text};
use coque::Outcome;

const BLOCK: &str = "block-on-incline.toml";
const BALL: &str = "ball-on-incline.toml";
const SLOPE: &str = "loads[0].gravity.acceleration";

/// A weight on a slope.
fn weight(degrees: f64) -> String {
    let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
    format!("[{}, 0.0, {}]", 10.0 * sin, -10.0 * cos)
}

/// What Coulomb says of what slides: g (sin φ − μ cos φ).
fn slides(degrees: f64, friction: f64) -> f64 {
    10.0 * (libm::sin(degrees.to_radians()) - friction * libm::cos(degrees.to_radians()))
}

/// Mean acceleration since a moment after the ramp of the weight.
fn pace(outcome: &Outcome, column_of: &str) -> f64 {
    let (time, v) = (column(outcome, "time"), column(outcome, column_of));
    let start = time.iter().position(|time| *time >= 0.249).unwrap();
    let end = time.len() - 1;
    (v[end] - v[start]) / (time[end] - time[start])
}

/// What energies and the loss leave of the work of what drives, over that work.
fn open(outcome: &Outcome) -> f64 {
    let [kinetic, internal, dissipated, external] =
        ["kinetic", "internal", "dissipated", "external"].map(|name| last(outcome, name));
    (kinetic + internal + dissipated) / external - 1.0
}

fn bits(outcome: &Outcome) -> Vec<u64> {
    outcome.curve.rows.iter().flatten().map(|x| x.to_bits()).collect()
}

/// Slopes of 30 and 20 degrees: measured .12 and .21 % too fast as the block swings on its contact; all of T is μ N; the energies close, and the work of what
/// drives is that of the weight alone, taken from the rows, to .1 %. On 15 degrees it creeps by 6.4e-4 of a spacing in .6 s.
#[test]
fn a_block_of_bonds_on_an_incline_slides_and_stays_as_coulomb_says() {
    for (degrees, within) in [(30.0, 3.7e-3), (20.0, 6.3e-3)] {
        let outcome = done(BLOCK, &[(SLOPE, &weight(degrees))]);
        let off = pace(&outcome, "v") / slides(degrees, 0.3) - 1.0;
        let [time, v, t, n] = ["time", "v", "T", "N"].map(|name| column(&outcome, name));
        let ratios: Vec<f64> = (25..t.len()).map(|row| t[row] / n[row]).collect();
        let ratio = ratios.iter().sum::<f64>() / ratios.len() as f64 / 0.3 - 1.0;
        let smooth = |t: f64| {
            let s = (t / 0.2).min(1.0);
            s * s * s * (10.0 - 15.0 * s + 6.0 * s * s)
        };
        let pull = |row: usize| 90.0 * libm::sin(degrees.to_radians()) * smooth(time[row]) * v[row];
        let work: f64 =
            (1..time.len()).map(|i| 0.5 * (pull(i) + pull(i - 1)) * (time[i] - time[i - 1])).sum();
        let driven = last(&outcome, "external") / work - 1.0;
        let lost = last(&outcome, "lost") / last(&outcome, "dissipated") - 1.0;
        let open = open(&outcome);
        println!(
            "{degrees}: {off:.1e}, T/N {ratio:.1e}, open {open:.1e}, driven {driven:.1e}, lost {lost:.1e}"
        );
        assert!(off.abs() < within && ratio.abs() < 1e-5, "{off:e} {ratio:e}");
        assert!(
            open.abs() < 1e-6 && driven.abs() < 3e-3 && lost.abs() < 3e-3,
            "{open:e} {driven:e} {lost:e}"
        );
    }
    let outcome = done(BLOCK, &[(SLOPE, &weight(15.0))]);
    let way = column(&outcome, "u").into_iter().fold(0.0_f64, |most, u| most.max(u.abs())) / 0.05;
    println!("15: {way:.1e} of a spacing");
    assert!(way < 1.9e-3, "{way:e}");
}

/// The block of the incline as a rigid one in a coat.
fn rigid_block(degrees: f64) -> Outcome {
    let scene = text(BLOCK);
    let start = scene.find("[bodies.block.solid]").unwrap();
    let end = scene.find("# The face of the block").unwrap();
    let body = "[bodies.block.rigid]\ngeometry.box = { min = [0, 0, 0], max = [0.3, 0.2, 0.15], spacing = 0.05 }\n\
                density = 1000.0\ncoat = { young = 1e6, thickness = 0.01 }\n";
    let scene = format!("{}{body}{}", &scene[..start], &scene[end..]).replace("block.solid", "block.rigid");
    let replaced =
        [(SLOPE, &weight(degrees)[..]), ("bodies.block.rigid.tools[0].rounding", "0.0"), AMPLITUDE];
    ran(overridden(&scene, "block.toml", &replaced))
}

/// A weight that comes up so that nothing swings.
const AMPLITUDE: (&str, &str) = ("loads[0].amplitude", "{ ramp = 0.2 }");

/// Measured 3e-5, 1.3e-4; 4.7e-6 m on 15 degrees.
#[test]
fn a_rigid_block_on_an_incline_slides_and_stays_as_coulomb_says() {
    for (degrees, within) in [(30.0, 1e-4), (20.0, 4e-4)] {
        let outcome = rigid_block(degrees);
        let (off, open) = (pace(&outcome, "v") / slides(degrees, 0.3) - 1.0, open(&outcome));
        println!("{degrees}: {off:.1e}, open {open:.1e}");
        assert!(off.abs() < within && open.abs() < 5e-7, "{off:e} {open:e}");
    }
    let way = column(&rigid_block(15.0), "u").into_iter().fold(0.0_f64, |most, u| most.max(u.abs()));
    println!("15: {way:.1e}");
    assert!(way < 1.5e-5, "{way:e}");
}

/// A solid ball rolls with 5/7 g sin φ up to tan φ = 7/2 μ, beyond it slides and turns with 5/2 μ g cos φ/R. Rolling, the centre is .5 to 1.3 % faster than R times
/// the spin, since the coat gives way by a hundredth of R: measured accelerations are off by
/// 4.8e-3, spins by 1 % at most.
#[test]
fn a_ball_rolls_or_slides_down_an_incline() {
    for (degrees, friction) in [(10.0, 0.3), (30.0, 0.3), (40.0, 0.3), (30.0, 0.1), (40.0, 0.2)] {
        let (weight, mu) = (weight(degrees), format!("{friction}"));
        let outcome = done(BALL, &[(SLOPE, &weight), ("bodies.ball.rigid.tools[0].friction", &mu)]);
        let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
        let rolls = sin / cos < 3.5 * friction;
        let exact = if rolls { 50.0 / 7.0 * sin } else { slides(degrees, friction) };
        let spinning = if rolls { exact / 0.05 } else { 25.0 * friction * cos / 0.05 };
        let (time, turned) = (column(&outcome, "time"), column(&outcome, "turned"));
        let n = time.len() - 1;
        let m = n - 16;
        let found = (turned[n] - 2.0 * turned[m] + turned[2 * m - n]) / (time[n] - time[m]).powi(2);
        let (off, spin, open) = (pace(&outcome, "v") / exact - 1.0, found / spinning - 1.0, open(&outcome));
        println!("{degrees} {friction}: {off:.1e} {spin:.1e}, open {open:.1e}");
        assert!(off.abs() < 1.5e-2 && spin.abs() < 0.03 && open.abs() < 1.2e-6, "{off} {spin} {open}");
    }
}

/// A plane that turns about its normal takes what lies on it along, to 1.1e-4 of the way, and does the work of that, to 1.5e-3.
#[test]
fn what_lies_on_a_tool_turns_with_it() {
    let replaced = [
        (SLOPE, "[0.0, 0.0, -10.0]"),
        ("loads[0].amplitude", "{ smooth = 0.1 }"),
        ("bodies.block.solid.tools[0].turn", "0.3"),
        ("bodies.block.solid.tools[0].amplitude", "{ smooth = 1.0 }"),
        ("analysis.explicit.transient.duration", "1.0"),
        ("curve[+]", "{ name = 'w', of = 'displacement', on = 'block.all', direction = [0, 1, 0] }"),
    ];
    let outcome = done(BLOCK, &replaced);
    let (sin, cos) = (libm::sin(0.3), libm::cos(0.3));
    let exact = [0.15 * cos - 0.1 * sin - 0.15, 0.15 * sin + 0.1 * cos - 0.1];
    let found = ["u", "w"].map(|name| last(&outcome, name));
    let off = libm::hypot(found[0] - exact[0], found[1] - exact[1]) / libm::hypot(exact[0], exact[1]);
    let most = column(&outcome, "external").into_iter().fold(0.0, f64::max);
    let [kinetic, lost] = ["kinetic", "lost"].map(|name| column(&outcome, name));
    let moving = kinetic.iter().copied().fold(0.0, f64::max);
    println!("{off:.1e}, work {most:.3e} for {moving:.3e}, lost {:.1e}", lost.last().unwrap());
    assert!(off < 4e-4, "{off:e}");
    assert!((most / moving - 1.0).abs() < 5e-3, "{most} {moving}");
}

/// A block of bonds or a rigid one on a shell whose particles are held or on a rigid body.
fn pair(block: &str, base: &str, degrees: f64, rounding: &str) -> Outcome {
    let block = match block {
        "bonds" => {
            "solid]\ngeometry.block = { lengths = [0.3, 0.2, 0.15], spacing = 0.05, origin = [0.0, 0.13, 0.05] }\n\
             material.elastic = { young = 1e7, poisson = 0.25, density = 1000.0 }\nformulation.bond-based = { horizon = 2.015 }"
        }
        _ => {
            "rigid]\ngeometry.box = { min = [0.0, 0.13, 0.05], max = [0.3, 0.33, 0.2], spacing = 0.05 }\ndensity = 1000.0"
        }
    };
    let (base, held) = match base {
        "shell" => (
            "shell]\ngeometry.plate = { lengths = [2.5, 1.4], particles = [23, 13] }\n\
             placed = { origin = [-0.3, -0.2, 0.0], u = [1.0, 0.0, 0.0], v = [0.0, 1.0, 0.0] }\n\
             material.elastic = { young = 1e7, poisson = 0.3, density = 1000.0 }\nsection.homogeneous = { thickness = 0.1 }",
            "hinged",
        ),
        _ => (
            "rigid]\ngeometry.box = { min = [-0.3, -0.2, -0.2], max = [2.2, 1.2, 0.05], spacing = 0.1 }\ndensity = 1000.0",
            "clamped",
        ),
    };
    let column = |name: &str, of: &str, direction: &str| {
        format!("[[curve]]\nname = \"{name}\"\nof = \"{of}\"\non = \"block.all\"\ndirection = {direction}\n")
    };
    let scene = format!(
        "title = \"Pair\"\nunits = {{ length = \"m\", force = \"N\", time = \"s\" }}\n\
         analysis.explicit.transient = {{ duration = 0.5, record_every = 0.01 }}\n\
         contact = [{{ between = [\"block\", \"base\"], friction = 0.3, rounding = {rounding} }}]\n\
         [bodies.block.{block}\n[bodies.base.{base}\n[[supports]]\non = \"base.all\"\n{held} = {{}}\n\
         [[loads]]\non = \"block.all\"\ngravity = {{ acceleration = {} }}\namplitude = {{ smooth = 0.2 }}\n{}{}{}{}",
        weight(degrees),
        column("v", "velocity", "[1, 0, 0]"),
        column("u", "displacement", "[1, 0, 0]"),
        column("N", "contact-force", "[0, 0, 1]"),
        "[[curve]]\nname = \"lost\"\nof = \"friction-loss\"\non = \"block.all\"\n"
    );
    ran(overridden(&scene, "pair.toml", &[]))
}

/// Measured 4.8, .6 and 6.1 ‰ too fast, energies open by 3.7e-4 at most; on 15 degrees ways of 1.7e-4, 8.9e-6 and 1.7e-5 m.
#[test]
fn bonds_and_rigid_bodies_rub_on_shells_and_on_each_other() {
    let cases = [
        ("bonds", "shell", "0.005", 5.2e-4),
        ("bonds", "rigid", "0.005", 2.7e-5),
        ("box", "shell", "0.0", 5.2e-5),
    ];
    for (block, base, rounding, most) in cases {
        let outcome = pair(block, base, 30.0, rounding);
        let (off, open) = (pace(&outcome, "v") / slides(30.0, 0.3) - 1.0, open(&outcome));
        let half = last(&outcome, "lost") / last(&outcome, "dissipated");
        println!("{block} {base}: {off:.1e}, open {open:.1e}, {half:.4}");
        assert!(off.abs() < 1.8e-2 && open.abs() < 1.2e-3, "{off:e} {open:e}");
        // One half of the loss on either side.
        assert!((half - 0.5).abs() < 2e-3, "{half}");
        let stays = pair(block, base, 15.0, rounding);
        let way = column(&stays, "u").into_iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        println!("stays: {way:.1e}");
        assert!(way < most, "{way:e}");
    }
}

/// Of a block thrown aslant on a plate, both free: forces and moments on both cancel, and what friction lost is dissipated: energies close to 2.1e-3, while 12 % are
/// lost.
#[test]
fn friction_between_bonds_and_a_shell_keeps_momentum_and_books_its_loss() {
    let outcome = ran(overridden(RUBBED, "rubbed.toml", &[]));
    let of = |name: &str| column(&outcome, name);
    let [plate, cube, about_plate, about_cube] = ["F", "G", "M", "L"].map(of);
    let greatest = |all: &[f64]| all.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let sum = |a: &[f64], b: &[f64]| greatest(&a.iter().zip(b).map(|(a, b)| a + b).collect::<Vec<_>>());
    let [force, moment] =
        [sum(&plate, &cube) / greatest(&plate), sum(&about_plate, &about_cube) / greatest(&about_plate)];
    let [kinetic, internal, dissipated] = ["kinetic", "internal", "dissipated"].map(of);
    let open: Vec<f64> =
        (0..kinetic.len()).map(|i| (kinetic[i] + internal[i] + dissipated[i]) / kinetic[0] - 1.0).collect();
    let lost = last(&outcome, "lost");
    println!("{force:.1e} {moment:.1e}, open {:.1e}, lost {:.3}", greatest(&open), lost / kinetic[0]);
    assert!(force < 1e-12 && moment < 1e-12, "{force:e} {moment:e}");
    assert!(greatest(&open) < 6e-3 && lost > 0.02 * kinetic[0], "{open:?} {lost}");
}

const RUBBED: &str = include_str!("solids_on_tools/rubbed.toml");

/// A quarter of the run.
const SHORT: (&str, &str) = ("analysis.explicit.transient.duration", "0.3");

#[test]
fn on_any_threads_and_stopped_the_bits_are_the_same() {
    for (text, replaced) in
        [(text(BLOCK), &[SHORT][..]), (text(BALL), &[SHORT, COARSE]), (RUBBED.to_string(), &[])]
    {
        let scene = overridden(&text, "scene.toml", replaced).unwrap();
        let rows = |threads| bits(&scene.build(threads).unwrap().run(&mut coque::Silent));
        assert_eq!(rows(1), rows(3));
    }
    stopped_again_and_again("block-on-incline", &text(BLOCK), &[SHORT], 3);
    stopped_again_and_again("ball-on-incline", &text(BALL), &[SHORT, COARSE], 3);
    stopped_again_and_again("rubbed", RUBBED, &[], 3);
}

const COARSE: (&str, &str) = ("bodies.ball.rigid.geometry.ball.spacing", "0.01");

/// Turned round the axes, in a mirror, and ten times as large: x, y, z become y, z, x.
#[test]
fn turned_mirrored_and_larger_it_slides_alike() {
    let whole = done(BLOCK, &[SHORT]);
    let scene = text(BLOCK);
    let round = scene
        .replace("[0.3, 0.2, 0.15]", "[0.15, 0.3, 0.2]")
        .replace("[5.0, 0.0, -8.660254038]", "[-8.660254038, 5.0, 0.0]")
        .replace("[0.0, 0.0, 1.0]", "[1.0, 0.0, 0.0]'")
        .replace("[1.0, 0.0, 0.0]\n", "[0.0, 1.0, 0.0]\n")
        .replace("[-1.0, 0.0, 0.0]", "[0.0, -1.0, 0.0]")
        .replace("]'", "]");
    let turned = ran(overridden(&round, "turned.toml", &[SHORT]));
    let mirrored = done(BLOCK, &[SHORT, (SLOPE, "[-5.0, 0.0, -8.660254038]")]);
    let large = [
        SHORT,
        ("bodies.block.solid.geometry.block", "{ lengths = [3.0, 2.0, 1.5], spacing = 0.5 }"),
        ("bodies.block.solid.material.elastic.young", "1e9"),
        (SLOPE, "[50.0, 0.0, -86.60254038]"),
    ];
    let large = done(BLOCK, &large);
    for (name, other, sign, scale) in
        [("turned", turned, 1.0, 1.0), ("mirrored", mirrored, -1.0, 1.0), ("large", large, 1.0, 10.0)]
    {
        let (own, other) = (column(&whole, "u"), column(&other, "u"));
        let most = own.iter().zip(&other).map(|(a, b)| (sign * b / scale - a).abs()).fold(0.0, f64::max);
        let off = most / own.last().unwrap();
        println!("{name}: {off:.1e}");
        assert!(off < 1e-9, "{name}: {off:e}");
    }
}

#[test]
fn friction_that_was_not_measured_is_refused() {
    let refused = |text: &str, replaced: &[(&str, &str)]| {
        let scene = overridden(text, "scene.toml", replaced);
        scene.and_then(|scene| scene.build(1).map(drop)).unwrap_err().to_string()
    };
    let sharp = refused(&text(BLOCK), &[("bodies.block.solid.tools[0].rounding", "0.0")]);
    assert!(sharp.contains("rounding") && sharp.contains("0.005 or more"), "{sharp}");
    let sharp = refused(RUBBED, &[("contact[0].rounding", "0.001")]);
    assert!(sharp.contains("contact[0].rounding") && sharp.contains("flutter"), "{sharp}");
    let bonds = RUBBED.replace("bodies.plate.shell", "bodies.plate.solid").replace(
        "geometry.plate = { lengths = [1.0, 1.0], particles = [14, 13] }",
        "geometry.block = { lengths = [1.0, 1.0, 0.2], spacing = 0.1, origin = [0.0, 0.0, -0.3] }",
    );
    let bonds = bonds.replace(
        "section.homogeneous = { thickness = 0.02 }",
        "formulation.bond-based = { horizon = 2.015 }",
    );
    let bonds = refused(&bonds.replace("poisson = 0.3", "poisson = 0.25"), &[]);
    assert!(bonds.contains("contact[0].friction") && bonds.contains("balls"), "{bonds}");
    let bare = text(BALL).replace("coat = {", "velocity = { linear = [0, 0, 0] } #");
    let bare = refused(&bare, &[]);
    assert!(bare.contains("coat") && bare.contains("no stiffness"), "{bare}");
    let idle = refused(&text(BALL), &[("bodies.ball.rigid.tools", "[]"), ("curve", "[]"), ("output", "{}")]);
    assert!(idle.contains("coat") && idle.contains("none without"), "{idle}");
    let deep = refused(&text(BALL), &[("bodies.ball.rigid.geometry.ball.centre", "[0, 0, 0.049]")]);
    assert!(deep.contains("deep in the rigid body"), "{deep}");
    let resting = text(BALL).replace(
        "[analysis.explicit.transient]\nduration = 0.6\nrecord_every = 0.01",
        "[analysis.static]\nlevels = 2",
    );
    let resting = refused(&resting.replace("amplitude = { smooth = 0.2 }", ""), &[]);
    assert!(resting.contains("none at rest"), "{resting}");
}
