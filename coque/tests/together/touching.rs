//! Two shells that touch each other: a closed form, what each does to the other, the same bits whichever is named first and however the
//! run is cut, what is refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, last, overridden, ran, text};
use coque::Outcome;

/// A small plate thrown aslant on a larger one, both free.
const THROWN: &str = include_str!("../metamorphic/thrown.toml");

const SWAPPED: (&str, &str) = ("contact", "[{ between = [\"target\", \"thrown\"] }]");

fn thrown(replaced: &[(&str, &str)]) -> Outcome {
    ran(overridden(THROWN, "thrown.toml", replaced))
}

/// Each feels what the other does, and the energies add up: 8e-5 of the kinetic one measured over the impact.
#[test]
fn what_one_shell_feels_the_other_does_and_energy_is_kept() {
    let outcome = thrown(&[]);
    let [f, g] = ["F", "G"].map(|name| column(&outcome, name));
    let most = f.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
    assert!(most > 10.0, "{most}");
    assert!(f.iter().zip(&g).all(|(f, g)| (f + g).abs() < 1e-13 * most));
    let [kinetic, internal, external] =
        ["kinetic", "internal", "external"].map(|name| column(&outcome, name));
    for ((kinetic_now, internal), external) in kinetic.iter().zip(&internal).zip(&external) {
        assert!((kinetic_now + internal - kinetic[0]).abs() < 2.5e-4 * kinetic[0]);
        assert!(external.abs() < 1e-12 * kinetic[0]);
    }
}

#[test]
fn whichever_is_named_first_and_on_any_threads_the_bits_are_the_same() {
    let rows = thrown(&[]).curve.rows;
    assert_eq!(thrown(&[SWAPPED]).curve.rows, rows);
    let scene = overridden(THROWN, "thrown.toml", &[]).unwrap();
    for threads in [2, 3, 7] {
        assert_eq!(scene.build(threads).unwrap().run(&mut coque::Silent).curve.rows, rows, "{threads}");
    }
}

#[test]
fn runs_of_touching_shells_go_on_to_the_same_bits() {
    stopped_again_and_again("thrown", THROWN, &[], 4);
    let coarse = [
        ("bodies.upper.shell.geometry.plate.particles", "[26, 3]"),
        ("bodies.lower.shell.geometry.plate.particles", "[29, 4]"),
    ];
    stopped_again_and_again("cantilevers", &text("two-cantilevers.toml"), &coarse, 3);
}

/// Without a contact between them bodies pass, with one they do not; the force is that of beams to 1e-4 ([`the case`] has the figures).
#[test]
fn one_cantilever_bears_on_the_other() {
    let coarse = [
        ("bodies.upper.shell.geometry.plate.particles", "[26, 3]"),
        ("bodies.lower.shell.geometry.plate.particles", "[29, 4]"),
        ("analysis.static.levels", "3"),
    ];
    let run =
        |replaced: &[(&str, &str)]| ran(overridden(&text("two-cantilevers.toml"), "two.toml", replaced));
    let borne = run(&coarse);
    // 5.3203 B g/L³ of the 12 at the tip.
    assert!((last(&borne, "F") / (5.3203125 * 0.175) - 1.0).abs() < 1e-3, "{}", last(&borne, "F"));
    let [upper, lower] = ["w_upper", "w_lower"].map(|name| last(&borne, name));
    assert!((upper / (0.2 * 2.7515) - 1.0).abs() < 2e-3 && (lower / (0.2 * 0.908) - 1.0).abs() < 2e-3);
    let curve = "[{ name = 'w_upper', of = 'displacement', on = 'upper.u1', direction = [0, 0, -1] }, \
                  { name = 'w_lower', of = 'displacement', on = 'lower.u1', direction = [0, 0, -1] }]";
    let without = run(&[&coarse[..], &[("contact", "[]"), ("curve", curve), ("output", "{}")]].concat());
    assert!(last(&without, "w_upper") > 0.7 && last(&without, "w_lower") == 0.0);
}

#[test]
fn pairs_that_make_no_sense_are_refused() {
    let refused = |replaced: &[(&str, &str)]| {
        let scene = overridden(THROWN, "thrown.toml", replaced);
        scene.and_then(|scene| scene.build(1).map(drop)).unwrap_err().to_string()
    };
    for (contact, says) in [
        ("[{ between = [\"thrown\", \"wall\"] }]", "a shell, a solid or a rigid body of the scene"),
        (
            "[{ between = [\"thrown\", \"thrown\"] }, { between = [\"thrown\", \"thrown\"] }]",
            "named once: contact[0]",
        ),
        (
            "[{ between = [\"thrown\", \"target\"] }, { between = [\"target\", \"thrown\"] }]",
            "named once: contact[0]",
        ),
        ("[{}]", "two bodies of the scene"),
    ] {
        let error = refused(&[("contact", contact)]);
        assert!(error.contains(says), "{error}");
    }
    let error = refused(&[("bodies.thrown.shell.placed.origin", "[0.21, 0.32, 0.005]")]);
    assert!(error.contains("apart") && error.contains("contact[0]"), "{error}");
    let linear = [("analysis", "{ linear = {} }"), ("bodies.thrown.shell.velocity", "{}")];
    assert!(refused(&linear).contains("none in a linear analysis"));
}
