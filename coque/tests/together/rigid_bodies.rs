//! Rigid bodies of a scene: alone, on springs, beside shells, in contact with them, kept and resumed, refused.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::refused::refused;
use crate::common::sittings::stopped_again_and_again;
use crate::common::{column, last, overridden, ran, run, text};
use coque::Outcome;

const HEAD: &str = "title = \"A rigid body\"\nunits = { length = \"m\", force = \"N\", time = \"s\" }\n";
const BALL: &str = "ball-on-plate.toml";

fn of(body: &str, replaced: &[(&str, &str)]) -> Outcome {
    ran(overridden(&format!("{HEAD}{body}"), "rigid.toml", replaced))
}

/// A block of mass 12, 1 by 2 by 3, on springs at the four corners of its lower face.
const MACHINE: &str = "
    [bodies.machine.rigid]
    geometry.box = { min = [-0.5, -1.0, -1.5], max = [0.5, 1.0, 1.5], spacing = 9.0 }
    mass = 12.0
    [sets]
    feet = { plane = { point = [0, 0, -1.5], normal = [0, 0, 1] } }
    [[supports]]
    on = \"feet\"
    spring = { direction = [1, 0, 0], stiffness = 300 }
    [[supports]]
    on = \"feet\"
    spring = { direction = [0, 1, 0], stiffness = 500 }
    [[supports]]
    on = \"feet\"
    spring = { direction = [0, 0, 1], stiffness = 1000 }
    [analysis.modal]
    modes = 6
";

/// Heave, turning about the vertical, and sway with rocking in both planes: roots of `det(K − ω²M) = 0` of two unknowns each.
#[test]
fn a_machine_on_springs_has_the_frequencies_of_its_closed_form() {
    let mut found: Vec<f64> = column(&of(MACHINE, &[]), "circular_frequency").iter().map(|w| w * w).collect();
    let (m, [kx, ky, kz], h) = (12.0, [300.0, 500.0, 1000.0], 1.5);
    let inertia = |a: f64, b: f64| m / 12.0 * (a * a + b * b);
    let pair = |k: f64, rocking: f64, j: f64| {
        // u + θ h at the feet: k(u − hθ)² + rocking θ².
        let (a, b, c) = (k / m, (k * h * h + rocking) / j, k * h / (m * j).sqrt());
        let (mean, half) = (0.5 * (a + b), (0.25 * (a - b) * (a - b) + c * c).sqrt());
        [mean - half, mean + half]
    };
    let mut exact = vec![kz / m, (kx * 1.0 + ky * 0.25) / inertia(1.0, 2.0)];
    exact.extend(pair(kx, kz * 0.25, inertia(1.0, 3.0)));
    exact.extend(pair(ky, kz * 1.0, inertia(2.0, 3.0)));
    found.sort_by(f64::total_cmp);
    exact.sort_by(f64::total_cmp);
    for (found, exact) in found.iter().zip(&exact) {
        assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
    }
    // Under its weight it sinks by mg/k, linear and by Newton's method, and in time about that.
    for analysis in ["{ linear = {} }", "{ static = { levels = 2 } }"] {
        let weight = ("loads", "[{ on = \"all\", gravity = { acceleration = [0, 0, -9.81] } }]");
        let columns =
            ("curve", "[{ name = \"w\", of = \"displacement\", on = \"all\", direction = [0, 0, 1] }]");
        let sunk = last(&of(MACHINE, &[("analysis", analysis), weight, columns]), "w");
        assert!((sunk / (-12.0 * 9.81 / kz) - 1.0).abs() < 1e-9, "{analysis}: {sunk}");
    }
}

/// A body alone in its scene: the tumbling block keeps its energy and its way, and turns as its moment of momentum says on the whole.
#[test]
fn a_block_that_tumbles_keeps_energy_and_momentum() {
    let columns = "[{ name = \"x\", of = \"displacement\", on = \"all\", direction = [1, 0, 0] }, \
                    { name = \"y\", of = \"displacement\", on = \"all\", direction = [0, 1, 0] }, \
                    { name = \"turn\", of = \"rotation\", on = \"all\", direction = [0, 1, 0] }]";
    let found = run("spinning-block.toml", &[("curve", columns), ("output", "{}")]);
    let energy = column(&found, "kinetic");
    for kinetic in &energy {
        assert!((kinetic / energy[0] - 1.0).abs() < 3e-5, "{kinetic} {}", energy[0]);
    }
    let (times, x, y) = (column(&found, "time"), column(&found, "x"), column(&found, "y"));
    for (time, (x, y)) in times.iter().zip(x.iter().zip(&y)) {
        assert!((x - 0.1 * time).abs() < 1e-12 && *y == 0.0, "{time}: {x} {y}");
    }
    // T = ½ ω·L with L along y but for a hundredth: the turn about it goes on at 2T/L on the mean.
    assert!((last(&found, "turn") / 60.0 - 1.0).abs() < 0.05, "{}", last(&found, "turn"));
}

/// A free strip and a block, joined by a spring: the momentum of both stays what it was.
#[test]
fn a_spring_between_a_block_and_a_shell_keeps_momentum_and_energy() {
    let joined = "
        [bodies.block.rigid]
        geometry.box = { min = [1.0, 0.0, 0.1], max = [1.1, 0.1, 0.2], spacing = 0.1 }
        mass = 2.0
        velocity = { linear = [0.0, 0.0, 0.5] }
        [bodies.strip.shell]
        geometry.plate = { lengths = [1.0, 0.1], particles = [21, 3] }
        material.elastic = { young = 1.2e7, poisson = 0.0, density = 1000.0 }
        section.homogeneous = { thickness = 0.01 }
        [sets]
        corner = { of = \"block\", nearest = [1.0, 0.05, 0.1] }
        tip = { of = \"strip\", nearest = [1.0, 0.05, 0.0] }
        [[supports]]
        on = \"corner\"
        spring = { to = \"tip\", direction = [0, 0, 1], stiffness = 5.0 }
        [analysis.explicit.transient]
        duration = 0.5
        record_every = 0.05
        [[curve]]
        name = \"block\"
        of = \"velocity\"
        on = \"block.all\"
        direction = [0, 0, 1]
        [[curve]]
        name = \"turn\"
        of = \"rotation\"
        on = \"block.all\"
        direction = [1, 0, 0]
    ";
    let found = of(joined, &[]);
    assert!(last(&found, "block") < 0.499 && last(&found, "turn").abs() > 1e-3);
    let work = column(&found, "external").into_iter().fold(0.0_f64, |most, work| most.max(work.abs()));
    let [kinetic, internal] = ["kinetic", "internal"].map(|name| last(&found, name));
    assert!(
        work < 1e-12 && ((kinetic + internal) / 0.25 - 1.0).abs() < 2e-3,
        "{work:e} {kinetic} {internal}"
    );
}

/// The closed form `F = Z v₀ exp(−Z t/M)` with the point impedance of a plate: forces as means over ten records, by the momentum that they took, from
/// 2.5 ms, when waves are long beside cells, to 21 ms, when those from the edges are back: over a factor of 35. They differ by 4.2 % at most.
#[test]
fn a_mass_on_a_wide_plate_feels_its_point_impedance() {
    let found = run(BALL, &[]);
    let (t, speed) = (column(&found, "time"), column(&found, "velocity"));
    let (bending, area) = (2e11 * 8e-9 / 12.0 / 0.91, 7850.0 * 0.002);
    // A quarter of plate and mass.
    let rate = 2.0 * f64::sqrt(bending * area) / 0.5;
    let course = |t: f64| 0.02 * libm::exp(-rate * t);
    let windows = (0..t.len() - 10).filter(|&i| t[i] > 2.5e-3 && t[i + 10] < 2.1e-2);
    let lost = |i: usize| (speed[i + 10] - speed[i]) / (course(t[i]) - course(t[i + 10]));
    let errors: Vec<f64> = windows.map(|i| (lost(i) - 1.0).abs()).collect();
    let worst = errors.iter().copied().fold(0.0, f64::max);
    assert!(errors.len() > 75 && worst < 0.05, "{worst}");
}

/// A ball against a free plate: what one loses of momentum the other gets, and the balance of energies closes, to 2e-5 with the mean of
/// velocities.
#[test]
fn a_ball_that_bounces_keeps_momentum_and_energy() {
    let free = [
        ("bodies.plate.shell.geometry.plate", "{ lengths = [0.4, 0.5], particles = [17, 21] }"),
        ("bodies.plate.shell.placed", "{ origin = [-0.2, -0.22, 0.0], u = [1, 0, 0], v = [0, 1, 0] }"),
        ("supports", "[]"),
        ("output", "{}"),
        ("contact[0].stiffness", "1.0"),
        ("contact[0].rounding", "0.05"),
        (
            "bodies.ball.rigid.velocity",
            "{ linear = [0.0, 0.0, -1.0], spin = { axis = [1, 0, 0], rate = 3.0 } }",
        ),
        ("bodies.ball.rigid.mass", "0.2"),
        ("analysis", "{ explicit = { transient = { duration = 0.002, record_every = 1e-4 } } }"),
        (
            "curve",
            "[{ name = \"ball\", of = \"velocity\", on = \"ball.all\", direction = [0, 0, 1] }, \
              { name = \"force\", of = \"contact-force\", on = \"ball.all\", direction = [0, 0, 1] }, \
              { name = \"on_plate\", of = \"contact-force\", on = \"plate.all\", direction = [0, 0, 1] }]",
        ),
    ];
    let found = run(BALL, &free);
    let (force, on_plate) = (column(&found, "force"), column(&found, "on_plate"));
    let most = force.iter().copied().fold(0.0, f64::max);
    assert!(most > 10.0, "{most}");
    for (force, on_plate) in force.iter().zip(&on_plate) {
        assert!((force + on_plate).abs() < 1e-12 * most, "{force} {on_plate}");
    }
    assert!(last(&found, "ball") > -0.9);
    let whole = column(&found, "kinetic")[0];
    let [kinetic, internal, external] = ["kinetic", "internal", "external"].map(|name| last(&found, name));
    assert!(external.abs() < 1e-12, "{external:e}");
    assert!(((kinetic + internal) / whole - 1.0).abs() < 6e-5, "{kinetic} {internal} {whole}");
    // Two threads and three: the same bits.
    let scene = overridden(&text(BALL), "ball.toml", &free).unwrap();
    for threads in [2, 3] {
        let other = scene.build(threads).unwrap().run(&mut coque::Silent);
        assert_eq!(found.curve.rows, other.curve.rows, "{threads}");
    }
}

/// A ball dropped straight on a plate that is held across, so that contact alone gives way: what it stores it gives back, at four hundredths of a per cent
/// to half a per cent of the speed of sound.
#[test]
fn a_ball_leaves_a_plate_that_is_held_as_fast_as_it_came() {
    let anvil = "
    [bodies.ball.rigid]
    geometry.ball = { centre = [0.0, 0.0, 0.0112], radius = 0.01, spacing = 0.005 }
    mass = 0.02
    velocity = { linear = [0.0, 0.0, -2.0] }
    [bodies.anvil.shell]
    geometry.plate = { lengths = [0.04, 0.04], particles = [9, 9] }
    placed = { origin = [-0.02, -0.02, 0.0], u = [1, 0, 0], v = [0, 1, 0] }
    material.elastic = { young = 2.0e11, poisson = 0.3, density = 7850.0 }
    section.homogeneous = { thickness = 0.002 }
    [[supports]]
    on = \"anvil.all\"
    held = { displacement = [[0.0, 0.0, 1.0]] }
    [[contact]]
    between = [\"ball\", \"anvil\"]
    [analysis.explicit.transient]
    duration = 3e-4
    record_every = 1e-5
    [[curve]]
    name = \"v\"
    of = \"velocity\"
    on = \"ball.all\"
    direction = [0.0, 0.0, 1.0]
    [[curve]]
    name = \"F\"
    of = \"contact-force\"
    on = \"ball.all\"
    direction = [0.0, 0.0, 1.0]
    [[curve]]
    name = \"G\"
    of = \"contact-force\"
    on = \"anvil.all\"
    direction = [0.0, 0.0, 1.0]
    ";
    for (speed, mass, duration) in [(2.0, "0.02", "3e-4"), (25.0, "2e-4", "5e-5")] {
        let velocity = format!("{{ linear = [0.0, 0.0, -{speed:?}] }}");
        let thrown = [
            ("bodies.ball.rigid.velocity", velocity.as_str()),
            ("bodies.ball.rigid.mass", mass),
            ("analysis.explicit.transient.duration", duration),
            ("analysis.explicit.transient.record_every", "5e-7"),
        ];
        let found = of(anvil, &thrown);
        let [velocity, force, other] = ["v", "F", "G"].map(|name| column(&found, name));
        let most = force.iter().copied().fold(0.0, f64::max);
        assert!(most > 0.0 && force.last() == Some(&0.0), "{force:?}");
        let restitution = velocity.last().unwrap() / speed;
        println!("{speed} m/s: restitution {restitution:.7}, force {most:.1}");
        assert!((restitution - 1.0).abs() < 0.005, "{restitution}");
        // One force on both.
        assert!(force.iter().zip(&other).all(|(force, other)| (force + other).abs() < 1e-12 * most));
    }
}

/// A block that a support presses on a strip, at rest: the support bears what the strip feels.
#[test]
fn a_block_pressed_on_a_strip_bears_what_the_strip_does() {
    let pressed = "
        [bodies.block.rigid]
        geometry.box = { min = [0.9, -0.02, 0.0055], max = [1.0, 0.12, 0.1], spacing = 0.05 }
        density = 1000.0
        [bodies.strip.shell]
        geometry.plate = { lengths = [1.0, 0.1], particles = [41, 5] }
        material.elastic = { young = 1.2e7, poisson = 0.0, density = 1000.0 }
        section.homogeneous = { thickness = 0.01 }
        [[supports]]
        on = \"strip.u0\"
        clamped = {}
        [[supports]]
        on = \"block.all\"
        moved = { direction = [0, 0, 1], by = -0.02 }
        [[supports]]
        on = \"block.all\"
        held = { displacement = [[1, 0, 0], [0, 1, 0]], director = [[0, 1, 0]] }
        [[supports]]
        on = \"block.all\"
        held = { director = [[1, 0, 0]] }
        [[contact]]
        between = [\"strip\", \"block\"]
        [analysis.static]
        levels = [0.1]
        [[curve]]
        name = \"support\"
        of = \"reaction\"
        on = \"block.all\"
        direction = [0, 0, 1]
        [[curve]]
        name = \"strip\"
        of = \"reaction\"
        on = \"strip.u0\"
        direction = [0, 0, 1]
        [[curve]]
        name = \"touch\"
        of = \"contact-force\"
        on = \"block.all\"
        direction = [0, 0, 1]
    ";
    let found = of(pressed, &[]);
    let [support, strip, touch] = ["support", "strip", "touch"].map(|name| last(&found, name));
    assert!(touch > 1e-4 && (support + touch).abs() < 1e-6 * touch && (strip - touch).abs() < 1e-6 * touch);
}

#[test]
fn rigid_bodies_go_on_to_the_same_bits() {
    let short = ("analysis", "{ explicit = { transient = { duration = 0.001, record_every = 2e-4 } } }");
    let coarse = ("bodies.plate.shell.geometry.plate.particles", "[13, 13]");
    let free = ("supports", "[]");
    let spin =
        ("bodies.ball.rigid.velocity", "{ linear = [0, 0, -1], spin = { axis = [1, 2, 3], rate = 50 } }");
    stopped_again_and_again("rigid-ball", &text(BALL), &[short, coarse, free, spin], 3);
    let short = ("analysis", "{ explicit = { transient = { duration = 2.0, record_every = 0.2 } } }");
    stopped_again_and_again("rigid-block", &text("spinning-block.toml"), &[short], 3);
}

#[test]
fn what_rigid_bodies_cannot_have_is_refused() {
    let cases = [
        ("density and mass", "mass = 12.0", "mass = 12.0\ndensity = 1.0"),
        ("neither", "mass = 12.0", ""),
        ("no body has such moments", "mass = 12.0", "mass = 12.0\ninertia = [1.0, 1.0, 3.0]"),
        ("products without moments", "mass = 12.0", "mass = 12.0\nproducts = [0.1, 0, 0]"),
        ("a box inside out", "min = [-0.5", "min = [0.5"),
        ("a spacing that nothing holds", "spacing = 9.0", "spacing = 1e-6"),
        ("no such set", "on = \"feet\"", "on = \"heads\""),
        ("a clamp on a corner", "spring = { direction = [1, 0, 0], stiffness = 300 }", "clamped = {}"),
        (
            "a mirror",
            "spring = { direction = [1, 0, 0], stiffness = 300 }",
            "symmetry = { normal = [1, 0, 0] }",
        ),
        ("a spring against turning", "spring = { direction = [1, 0, 0]", "spring = { axis = [1, 0, 0]"),
        ("a spring to itself", "stiffness = 300 }", "stiffness = 300, to = \"all\" }"),
        (
            "a pressure",
            "[analysis.modal]",
            "[[loads]]\non = \"all\"\npressure = { value = 1.0 }\n[analysis.modal]",
        ),
        (
            "a column that it has not",
            "[analysis.modal]",
            "[[curve]]\nname = \"d\"\nof = \"director\"\non = \"all\"\ndirection = [0, 0, 1]\n[analysis.modal]",
        ),
        ("a path by arc length", "[analysis.modal]\n    modes = 6", "[analysis.arc-length]\n    until = 1.0"),
        (
            "an open surface",
            "geometry.box = { min = [-0.5, -1.0, -1.5], max = [0.5, 1.0, 1.5], spacing = 9.0 }",
            "geometry.mesh = { file = \"../scenes/meshes/roof.msh\" }",
        ),
    ];
    insta::assert_snapshot!(refused(&format!("{HEAD}{MACHINE}"), &cases));
}
