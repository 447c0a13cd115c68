//! Several bodies without a fluid: each beside others as it is alone, joined by springs as it should, kept and resumed, refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::fluids::SHELL_GATE;
use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, last, overridden, ran, run, text};
use coque::{Outcome, Scene};

const JOINED: &str = "joined-cantilevers.toml";
const NO_SPRING: (&str, &str) =
    ("supports", "[{ on = \"lower.u0\", clamped = {} }, { on = \"upper.u0\", clamped = {} }]");
const MARCH: (&str, &str) =
    ("analysis", "{ explicit = { transient = { duration = 0.02, record_every = 0.004 } } }");
const COARSE: [(&str, &str); 2] = [
    ("bodies.lower.shell.geometry.plate.particles", "[9, 3]"),
    ("bodies.upper.shell.geometry.plate.particles", "[9, 3]"),
];
/// Tip stiffness of one cantilever, `3EI/L³`, and the force.
const K: f64 = 0.3;
const F: f64 = -0.01;

/// The upper cantilever alone.
fn alone() -> String {
    let whole = text(JOINED);
    let start = whole.find("[bodies.upper.shell]").unwrap();
    let end = whole.find("[[supports]]").unwrap();
    let from = whole.find("[[loads]]").unwrap();
    let to = whole.find("[[curve]]\nname = \"w_lower\"").unwrap();
    let head = &whole[..whole.find("[bodies.lower.shell]").unwrap()];
    let supports = "[[supports]]\non = \"upper.u0\"\nclamped = {}\n\n";
    format!("{head}{}{supports}{}", &whole[start..end], &whole[from..to])
}

fn bits(outcome: &Outcome, name: &str) -> Vec<u64> {
    column(outcome, name).into_iter().map(f64::to_bits).collect()
}

/// Force and spring: `w = 2F/3k` above, `F/3k` below, and ½Fw of energy with that of the spring in it. 41 particles leave 8e-5 and 1.3e-4 of them.
#[test]
fn two_cantilevers_share_a_force_through_their_spring() {
    let found = run(JOINED, &[]);
    let exact = [2.0 * F / (3.0 * K), F / (3.0 * K)];
    let internal = 0.5 * F * exact[0];
    for (name, exact) in [("w_upper", exact[0]), ("w_lower", exact[1]), ("internal", internal)] {
        let error = last(&found, name) / exact - 1.0;
        assert!(error.abs() < 4e-4, "{name}: {error:e}");
    }
    // Newton's method finds it at a hundredth of the load, and beams ten times as thick what relaxation finds.
    let small = [("loads[0].force.total", "[0.0, 0.0, -1e-4]"), ("analysis", "{ static = { levels = 1 } }")];
    let error = 100.0 * last(&run(JOINED, &small), "w_lower") / exact[1] - 1.0;
    assert!(error.abs() < 4e-4, "{error:e}");
    let [lower, upper] = COARSE;
    let thick = [
        lower,
        upper,
        ("bodies.lower.shell.section.homogeneous.thickness", "0.1"),
        ("bodies.upper.shell.section.homogeneous.thickness", "0.1"),
        ("supports[2].spring.stiffness", "300.0"),
        ("loads[0].force.total", "[0.0, 0.0, -10.0]"),
    ];
    let [newton, relaxed] = ["static", "relaxation"].map(|analysis| {
        let levels = format!("{{ {analysis} = {{ levels = 1, tolerance = 1e-7 }} }}");
        let mut replaced = thick.to_vec();
        replaced.push(("analysis", &levels));
        let found = run(JOINED, &replaced);
        ["w_upper", "w_lower"].map(|name| last(&found, name))
    });
    for (newton, relaxed) in newton.into_iter().zip(relaxed) {
        assert!((relaxed / newton - 1.0).abs() < 1e-4, "{newton} {relaxed}");
    }
}

/// Two equal beams swing together as each alone, and against each other as one with 2k of spring at its tip: the frequency equation of a
/// cantilever with a spring s at its end, `(βL)³ (1 + cos cosh) + (sL³/EI) (sin cosh − cos sinh) = 0`.
#[test]
fn modes_of_joined_cantilevers_are_those_of_one_and_of_one_on_a_spring() {
    let modal = ("analysis", "{ modal = { modes = 4 } }");
    let joined = run(JOINED, &[modal, ("curve", "[]"), ("loads", "[]")]);
    let found = column(&joined, "circular_frequency");
    // EI = .1 N m², ρA = 1 kg/m; s L³/EI = .6/.1.
    let root = |s: f64, from: f64, to: f64| {
        let f = |b: f64| {
            let (sin, cos) = libm::sincos(b);
            let (sinh, cosh) = (libm::sinh(b), libm::cosh(b));
            b.powi(3) * (1.0 + cos * cosh) + s * (sin * cosh - cos * sinh)
        };
        let (mut low, mut high) = (from, to);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            if f(low) * f(middle) <= 0.0 { high = middle } else { low = middle }
        }
        low * low * 0.1_f64.sqrt()
    };
    let exact = [root(0.0, 1.0, 3.0), root(6.0, 1.0, 3.9)];
    for (found, exact) in found.iter().zip(exact) {
        // 5.5e-5 and 4.9e-5 of the lattice.
        assert!((found / exact - 1.0).abs() < 1.7e-4, "{found} {exact}");
    }
    // Unjoined, every mode is there twice.
    let apart = run(JOINED, &[modal, NO_SPRING, ("curve", "[]"), ("loads", "[]")]);
    let twice = column(&apart, "circular_frequency");
    let single = ran(overridden(&alone(), "alone.toml", &[modal, ("curve", "[]"), ("loads", "[]")]));
    let single = column(&single, "circular_frequency");
    for (number, omega) in twice.iter().enumerate() {
        assert!((omega / single[number / 2] - 1.0).abs() < 1e-8, "{number}: {omega} {single:?}");
    }
}

/// A twin has the same stable step: beside it the body marches to the bits that it has alone. So it does whatever the bodies are called.
#[test]
fn beside_its_twin_a_body_marches_to_its_own_bits() {
    let [lower, upper] = COARSE;
    let both = run(JOINED, &[lower, upper, NO_SPRING, MARCH]);
    let single = ran(overridden(&alone(), "alone.toml", &[upper, MARCH]));
    assert_eq!(bits(&both, "w_upper"), bits(&single, "w_upper"));
    assert!(last(&both, "w_upper") != 0.0 && last(&both, "w_lower") == 0.0);
    // Bodies go by their names: renamed the lower comes last.
    let renamed = text(JOINED).replace("lower.", "z.").replace("\"lower\"", "\"z\"");
    for replaced in [vec![NO_SPRING, MARCH], vec![MARCH]] {
        let with = |first: (&'static str, &'static str)| {
            let mut all = vec![first, upper];
            all.extend(&replaced);
            all
        };
        let first = ran(overridden(&text(JOINED), "a.toml", &with(lower)));
        let of_z = ("bodies.z.shell.geometry.plate.particles", "[9, 3]");
        let swapped: Vec<_> =
            with(of_z).into_iter().map(|(key, value)| (key, value.replace("lower.", "z."))).collect();
        let swapped: Vec<_> = swapped.iter().map(|(key, value)| (*key, value.as_str())).collect();
        let second = ran(overridden(&renamed, "b.toml", &swapped));
        for name in ["w_upper", "w_lower", "kinetic", "internal"] {
            assert_eq!(bits(&first, name), bits(&second, name), "{name}");
        }
    }
}

/// A shell beside a block of bonds, and beside a Galerkin solid: at rest each answers as alone but for the criteria of convergence, which
/// count all of them.
#[test]
fn unlike_bodies_answer_as_each_alone() {
    for formulation in ["state-based = { horizon = 1.5 }", "galerkin = {}"] {
        let block = format!(
            "[bodies.block.solid]\ngeometry.block = {{ lengths = [1.0, 0.2, 0.2], spacing = 0.1, origin = [0.0, 0.0, 1.0] }}\n\
             material.elastic = {{ young = 1e4, poisson = 0.2, density = 1.0 }}\nformulation.{formulation}\n\
             [[supports]]\non = \"block.x0\"\nclamped = {{}}\n\
             [[loads]]\non = \"block.x1\"\ntraction = {{ value = [0.0, 0.0, 0.1] }}\n\
             [[curve]]\nname = \"w_block\"\nof = \"displacement\"\non = \"block.x1\"\ndirection = [0.0, 0.0, 1.0]\n"
        );
        let head = "title = \"A block\"\nunits = { length = \"m\", force = \"N\", time = \"s\" }\n";
        let analysis = ("analysis", "{ linear = {} }");
        let (beam, upper) = (alone(), COARSE[1]);
        let own = ran(overridden(&format!("{head}analysis.linear = {{}}\n{block}"), "block.toml", &[]));
        let shell = ran(overridden(&beam, "alone.toml", &[upper, analysis]));
        let both = ran(overridden(&format!("{beam}\n{block}"), "both.toml", &[upper, analysis]));
        for (alone, name) in [(&shell, "w_upper"), (&own, "w_block")] {
            let [alone, beside] = [alone, &both].map(|outcome| last(outcome, name));
            assert!((beside / alone - 1.0).abs() < 1e-9, "{formulation} {name}: {beside} {alone}");
        }
    }
}

/// A spring between free bodies: momentum stays as it was, the balance of energies closes.
#[test]
fn a_spring_between_free_bodies_keeps_momentum_and_energy() {
    let free = [
        COARSE[0],
        COARSE[1],
        (
            "supports",
            "[{ on = \"lower.u1\", spring = { to = \"upper.u1\", direction = [0.0, 0.0, 1.0], stiffness = 3.0 } }]",
        ),
        ("loads", "[]"),
        ("bodies.upper.shell.velocity", "{ linear = [0.0, 0.0, 0.5] }"),
        ("analysis", "{ explicit = { transient = { duration = 0.4, record_every = 0.04 } } }"),
        (
            "curve",
            "[{ name = \"upper\", of = \"velocity\", on = \"upper.centre-row\", direction = [0.0, 0.0, 1.0] }]",
        ),
    ];
    let found = run(JOINED, &free);
    let energy = 0.5 * 1.0 * 0.25;
    let error = found.summary.record.energies;
    let [kinetic, internal] = ["kinetic", "internal"].map(|name| last(&found, name));
    assert!(internal > 1e-3 * energy, "{internal}");
    // The energy with the mean of the velocities differs by what comes and goes within a step.
    assert!(((kinetic + internal) / energy - 1.0).abs() < 2e-3, "{kinetic} {internal} {error:?}");
    let external = column(&found, "external").into_iter().fold(0.0_f64, |most, work| most.max(work.abs()));
    assert!(external < 1e-12 * energy, "{external:e}");
}

#[test]
fn joined_bodies_go_on_to_the_same_bits() {
    let [lower, upper] = COARSE;
    stopped_again_and_again("several-march", &text(JOINED), &[lower, upper, MARCH], 3);
    let levels = ("analysis", "{ static = { levels = 4 } }");
    stopped_again_and_again("several-static", &text(JOINED), &[lower, upper, levels], 2);
}

#[test]
fn what_several_bodies_cannot_have_is_refused() {
    let spring = "spring = { to = \"upper.u1\", direction = [0.0, 0.0, 1.0], stiffness = 0.3 }";
    let cases = [
        ("a set of no body", "on = \"lower.u0\"", "on = \"u0\""),
        ("a body that is none", "to = \"upper.u1\"", "to = \"middle.u1\""),
        ("a set that the other body has not", "to = \"upper.u1\"", "to = \"upper.u7\""),
        ("unlike numbers of places", "to = \"upper.u1\"", "to = \"upper.u1v0\""),
        (
            "a spring about an axis",
            spring,
            "spring = { to = \"upper.u1\", axis = [0, 1, 0], stiffness = 0.3 }",
        ),
        ("a spring with a course", spring, &format!("{spring}\namplitude = {{ ramp = 1.0 }}")),
        ("nothing that drives", "[[loads]]\non = \"upper.u1\"\nforce = { total = [0.0, 0.0, -0.01] }\n", ""),
        (
            "a preload",
            "force = { total = [0.0, 0.0, -0.01] }",
            "force = { total = [0.0, 0.0, -0.01] }\npreload = true",
        ),
        (
            "walls without a fluid",
            "[bodies.lower.shell]",
            "[bodies.wall.walls]\ngeometry.basin = { min = [0, 0], max = [1, 1] }\n[bodies.lower.shell]",
        ),
        (
            "a spring on a moved set",
            "[[loads]]",
            "[[supports]]\non = \"upper.u1v0\"\nmoved = { direction = [0, 0, 1], by = 0.01 }\n[[loads]]",
        ),
        (
            "an analysis that one body cannot do",
            "[analysis.linear]",
            "[bodies.block.solid]\ngeometry.block = { lengths = [1, 1, 1], spacing = 0.5, origin = [0, 0, 9] }\nmaterial.elastic = { young = 1, poisson = 0, density = 1 }\nformulation.galerkin = {}\n[analysis.explicit.transient]\nduration = 1.0\nrecord_every = 0.1",
        ),
        ("one column twice", "name = \"w_lower\"", "name = \"w_upper\""),
    ];
    insta::assert_snapshot!(refused(&text(JOINED), &cases));
}

/// What one body lacks the other may show; what does not follow from what a body is, is refused beside others as alone.
#[test]
fn fields_of_stresses_that_do_not_follow_are_refused_beside_other_bodies() {
    let plain = "material.elastic = { young = 1.2e7, poisson = 0.0, density = 1000.0 }\nsection.homogeneous = { thickness = 0.01 }\n\n[[supports]]";
    let plied = "material.orthotropic = { young_along = 1.2e7, young_across = 1e6, poisson = 0.3, shear = 1e6, density = 1000.0, strength = { \
        along_tension = 1e4, along_compression = 1e4, across_tension = 1e3, across_compression = 2e3, shear = 1e3 } }\n\
        section.layered = { axis = [1, 0, 0], plies = [{ thickness = 0.01, angle = 0 }] }\n\n[[supports]]";
    let shown = text(JOINED).replace(plain, plied)
        + "[output]\nfields = { plies = true, reserve = \"tsai-wu\", principal = true }\n";
    Scene::parse(&shown, "scene.toml").unwrap().build(1).unwrap();
    let yields = "angle = 0 }, { thickness = 0.01, material.plastic = { young = 1.2e7, poisson = 0.3, density = 1000.0, \
        hardening.linear = { yield-stress = 1e4, slope = 1e5 } }, angle = 0";
    let level = shown.replace("[analysis.linear]", "[analysis.static]\nlevels = 1\n");
    let cases = [
        ("a ply that yields", "angle = 0", yields),
        ("von Mises with fibres", "reserve = \"tsai-wu\"", "reserve = \"von-mises\""),
    ];
    // In a fluid initial stresses are known as well.
    let gate = "material.elastic = { young = 1e6, poisson = 0.3, density = 1100.0, strength = 1e4 }\n\
        initial_stress = [{ on = \"all\", membrane = [1.0, 0.0, 0.0], axis = [0, 1, 0] }]";
    let plain = "material.elastic = { young = 1e6, poisson = 0.3, density = 1100.0 }";
    let wet = format!("output.fields.reserve = \"von-mises\"\n{SHELL_GATE}");
    Scene::parse(&wet, "scene.toml").unwrap();
    let reserve = level.replace("plies = true, ", "");
    let all = [
        refused(&level, &cases),
        refused(&reserve, &cases[..1]),
        refused(&wet, &[("a gate under stress before", plain, gate)]),
    ];
    insta::assert_snapshot!(all.concat());
}
