//! What is seen of contact: warnings with a scene on either side of each, columns, fields, the summary.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, last, overridden, ran, text};
use coque::{Event, Outcome, RunOptions, Silent, Simulation, WarningKind};

const CANTILEVERS: &[(&str, &str)] = &[
    ("bodies.upper.shell.geometry.plate.particles", "[26, 3]"),
    ("bodies.lower.shell.geometry.plate.particles", "[29, 4]"),
    ("analysis.static.levels", "3"),
];
/// What measures no contact.
const DEFLECTION: (&str, &str) =
    ("curve", "[{ name = 'w_upper', of = 'displacement', on = 'upper.u1', direction = [0, 0, -1] }]");
const PLAIN: &[(&str, &str)] = &[("contact", "[]"), DEFLECTION, ("output", "{}")];

fn outcome(text: &str, replaced: &[Replaced]) -> Outcome {
    ran(overridden(text, "scene.toml", &replaced.concat()))
}

/// The message of a warning, if a run gives it.
fn reported(outcome: &Outcome, kind: WarningKind) -> Option<&str> {
    let mut own = outcome.summary.record.warnings.iter().filter(|warning| warning.kind == kind);
    let message = own.next().map(|warning| warning.message.as_str());
    assert!(own.next().is_none(), "reported twice");
    message
}

#[test]
fn two_shells_in_each_other_are_reported_with_places_and_level_and_two_that_touch_are_not() {
    let scene = text("two-cantilevers.toml");
    let reported = |replaced: &[Replaced]| {
        let outcome = outcome(&scene, replaced);
        reported(&outcome, WarningKind::TouchingUnseen).map(str::to_string)
    };
    assert_eq!(reported(&[CANTILEVERS]), None);
    let said = reported(&[CANTILEVERS, PLAIN]).unwrap();
    let begins = "`lower` and `upper` are in each other at level 0.333";
    assert!(said.starts_with(begins) || said.contains("between = [\"lower\", \"upper\"]"), "{said}");
    assert!(said.contains("where faces touch at 1.0000e1"), "{said}");
    // A load of which the gap is left open.
    let light = ("loads[0].force.total", "[0.0, 0.0, -0.4]");
    assert_eq!(reported(&[CANTILEVERS, PLAIN, &[light]]), None);
}

#[test]
fn a_shell_in_itself_is_reported_and_one_that_touches_itself_is_not() {
    let coarse: Replaced = &[
        ("geometry.cylinder.particles", "[41, 3]"),
        (
            "analysis.static.levels",
            "[0.2, 0.28, 0.295, 0.3, 0.305, 0.31, 0.32, 0.33, 0.35, 0.375, 0.4, 0.45, 0.5, 0.55, 0.6]",
        ),
    ];
    let scene = text("ring-in-itself.toml");
    let touching = outcome(&scene, &[coarse]);
    assert_eq!(reported(&touching, WarningKind::TouchingUnseen), None);
    let curve = ("curve", "[{ name = 'b', of = 'position', on = 'u0', direction = [0, 0, 1] }]");
    let through = outcome(&scene, &[coarse, &[("contact", "[]"), curve]]);
    let said = reported(&through, WarningKind::TouchingUnseen).unwrap();
    assert!(said.starts_with("the shell is in itself at level 0.5"), "{said}");
    assert!(said.contains("add [[contact]]"), "{said}");
}

const THROWN: &str = include_str!("../metamorphic/thrown.toml");

/// A march is looked at once in a thousand steps and where it ends: the plate is in the other then.
#[test]
fn a_march_tells_what_is_in_each_other_where_it_ends() {
    let curve = ("curve", "[{ name = 'v', of = 'velocity', on = 'thrown.all', direction = [0, 0, 1] }]");
    let end = ("analysis.explicit.transient.duration", "0.04");
    let through = outcome(THROWN, &[&[("contact", "[]"), curve, end]]);
    let said = reported(&through, WarningKind::TouchingUnseen).unwrap();
    assert!(said.contains("at time 0.04"), "{said}");
    assert_eq!(reported(&outcome(THROWN, &[&[end]]), WarningKind::TouchingUnseen), None);
    let short = ("analysis.explicit.transient.duration", "0.01");
    assert_eq!(
        reported(&outcome(THROWN, &[&[("contact", "[]"), curve, short]]), WarningKind::TouchingUnseen),
        None
    );
}

/// A plate on a plane, pressed on it evenly, on springs that bear nothing to speak of; it touches it at the start, by a hundredth of a micrometre.
const LYING: &str = r#"
title = "A plate pressed on a plane"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 2.0], particles = [6, 11] }
material.elastic = { young = 1e7, poisson = 0.3, density = 1000.0 }
section.homogeneous.thickness = 0.05
tools = [{ name = "floor", plane = { point = [0, 0, -0.02499999], normal = [0, 0, 1] } }]
supports = [{ on = "all", held = { displacement = [[1, 0, 0], [0, 1, 0]] } },
            { on = "all", spring = { stiffness = 1.0, direction = [0, 0, 1] } }]
loads = [{ on = "all", gravity = { acceleration = [0, 0, -3.0] } }]
analysis.static = { levels = 2 }
output.fields.contact = true
curve = [{ name = "depth", of = "greatest-depth", on = "all" },
         { name = "area", of = "touching-area", on = "all" },
         { name = "edge", of = "touching-area", on = "u0" },
         { name = "gap", of = "contact-gap", on = "all" }]
"#;

/// All of it is as deep as its weight over its area and the stiffness makes it: what columns, fields and summary say of it agree.
#[test]
fn columns_fields_and_summary_say_how_deep_a_plate_lies_in_a_plane() {
    let scene = overridden(LYING, "lying.toml", &[]).unwrap();
    let model = scene.build(1).unwrap();
    let mut silent = Silent;
    let options = RunOptions { progress: &mut silent, checkpoints: None, fields: None, from: None };
    let mut simulation = Simulation::with_options(model, options).unwrap();
    while simulation.advance().unwrap() != Event::End {}
    let sheet = simulation.sheet(false).unwrap();
    let outcome = simulation.finish();
    let summary = &outcome.summary.record.contacts[0];
    assert_eq!(
        (summary.between.as_str(), summary.set_by.as_deref()),
        ("the shell with the tool `floor`", Some("step"))
    );
    // κ = .4 E t/h² of cells .2 by .2, of the stiffness of a sheet whose width is held; depth u = p/κ.
    let (stiffness, pressure) = (0.4 * (1e7 / 0.91) * 0.05 / 0.04, 150.0);
    assert!((summary.stiffness / stiffness - 1.0).abs() < 1e-12);
    let depth = pressure / stiffness;
    let near = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 1e-6, "{found} for {exact}");
    near(last(&outcome, "depth"), depth / 0.025);
    near(summary.greatest_depth, depth / 0.025);
    near(last(&outcome, "gap"), -depth);
    near(last(&outcome, "area"), 2.0);
    near(summary.greatest_area, 2.0);
    // A row of cells hands a third of its area to the particles at one of its sides, half of the middles' third.
    near(last(&outcome, "edge"), 0.2);
    let field = |name: &str| sheet.point_data[name].numbers.clone();
    field("contact_pressure").iter().for_each(|own| near(*own, pressure));
    field("contact_gap").iter().for_each(|own| near(*own, -depth));
    assert!(field("contact_grip").iter().all(|own| *own == 2.0));
    assert!(field("contact_shear").iter().all(|own| *own == 0.0));
}

/// What pulls along a rough plane by less than friction bears sticks, by more it slips: shear is then μ times the pressure.
#[test]
fn fields_tell_what_sticks_from_what_slips() {
    let pulled = |along: f64| {
        let rough = ("tools[0].friction", "0.3");
        let load = format!("[{{ on = 'all', gravity = {{ acceleration = [{along}, 0, -3.0] }} }}]");
        let rope = "[{ on = 'all', spring = { stiffness = 1e3, direction = [1, 0, 0] } }, \
                    { on = 'all', spring = { stiffness = 1.0, direction = [0, 0, 1] } }, \
                    { on = 'all', held = { displacement = [[0, 1, 0]] } }]";
        let replaced = [rough, ("loads", load.as_str()), ("supports", rope), ("analysis.static.levels", "4")];
        let model = overridden(LYING, "lying.toml", &replaced).unwrap().build(1).unwrap();
        let mut silent = Silent;
        let options = RunOptions { progress: &mut silent, checkpoints: None, fields: None, from: None };
        let mut simulation = Simulation::with_options(model, options).unwrap();
        while simulation.advance().unwrap() != Event::End {}
        let sheet = simulation.sheet(false).unwrap();
        let shear = sheet.point_data["contact_shear"].numbers.chunks(3).map(|own| own[0]).collect::<Vec<_>>();
        (sheet.point_data["contact_grip"].numbers.clone(), shear)
    };
    let (grip, shear) = pulled(0.45);
    assert!(grip.iter().all(|own| *own == 1.0), "{grip:?}");
    assert!(shear.iter().all(|own| *own < 0.0 && *own > -0.3 * 150.0), "{shear:?}");
    let (grip, shear) = pulled(1.2);
    assert!(grip.iter().all(|own| *own == 2.0), "{grip:?}");
    assert!(shear.iter().all(|own| (own / -45.0 - 1.0).abs() < 1e-6), "{shear:?}");
}

/// The gap of a ring that collapses, at the ends of its middle line, is straight across: twice how far they are from the middle, less
/// the thickness; beyond half of that it is not looked for.
#[test]
fn the_gap_of_a_shell_to_itself_is_straight_across() {
    let curve = "[{ name = 'b', of = 'position', on = 'u0', direction = [0, 0, 1] }, \
                  { name = 'gap', of = 'contact-gap', on = 'u0' }, { name = 'depth', of = 'greatest-depth', on = 'u0' }, \
                  { name = 'area', of = 'touching-area', on = 'all' }]";
    let coarse = ("geometry.cylinder.particles", "[41, 3]");
    let levels = "[0.2, 0.28, 0.295, 0.3, 0.305, 0.31, 0.32, 0.33, 0.35, 0.375, 0.4, 0.45, 0.5, 0.55, 0.6]";
    let replaced = [coarse, ("curve", curve), ("analysis.static.levels", levels), ("output", "{}")];
    let outcome = outcome(&text("ring-in-itself.toml"), &[&replaced]);
    let [b, gap, depth, area] = ["b", "gap", "depth", "area"].map(|name| column(&outcome, name));
    for i in 0..b.len() {
        let exact = (2.0 * b[i].abs() - 0.05).min(0.025);
        assert!((gap[i] - exact).abs() < 1e-6, "{} for {exact}", gap[i]);
        // Middles of the cells beside may be deeper than the particles.
        assert!(depth[i] >= -gap[i] / 0.05 - 1e-12 && (depth[i] == 0.0 || area[i] > 0.0));
    }
    assert!((gap[0] - 0.025).abs() < 1e-12 && *gap.last().unwrap() < 0.0 && *area.last().unwrap() > 0.0);
    let contact = &outcome.summary.record.contacts[0];
    assert_eq!(contact.between, "the shell with itself");
    assert!(
        (contact.greatest_depth - depth.iter().copied().fold(0.0, f64::max)).abs() < 1e-12
            || contact.greatest_depth > 0.0
    );
}

/// A plate thrown fast at another: deep, in short steps, with the moment of what either does to the other the same although every step is
/// recorded; energy is off by .3 %.
#[test]
fn a_plate_thrown_fast_is_deep_and_shortens_steps_and_a_slow_one_does_not() {
    let curve = "[{ name = 'depth', of = 'greatest-depth', on = 'target.all' }, \
                  { name = 'other', of = 'greatest-depth', on = 'thrown.all' }, \
                  { name = 'area', of = 'touching-area', on = 'target.all' }, \
                  { name = 'gap', of = 'contact-gap', on = 'thrown.all' }, \
                  { name = 'M', of = 'contact-moment', on = 'target.all', direction = [1, 2, 3], about = [0.3, -1.0, 2.0] }, \
                  { name = 'W', of = 'contact-moment', on = 'thrown.all', direction = [1, 2, 3], about = [0.3, -1.0, 2.0] }]";
    let fast = [
        ("curve", curve),
        ("bodies.thrown.shell.velocity.linear", "[2.8, 1.4, -14.0]"),
        ("analysis.explicit.transient", "{ duration = 0.0057, record_every = 2e-4 }"),
    ];
    let flew = outcome(THROWN, &[&fast]);
    let record = &flew.summary.record;
    let contact = &record.contacts[0];
    let deepest = |name: &str| column(&flew, name).into_iter().fold(0.0, f64::max);
    assert_eq!(contact.greatest_depth, deepest("depth").max(deepest("other")));
    let said = reported(&flew, WarningKind::DeepContact).unwrap();
    assert!(said.starts_with("`target` with `thrown`: faces are"), "{said}");
    let short = record.shortened.unwrap();
    let said = reported(&flew, WarningKind::ShortenedStep).unwrap();
    assert!(
        short.least < 0.5
            && said.contains(&format!("contact made {} of {} steps", short.steps, record.steps)),
        "{said}"
    );
    let balance = record.balance.unwrap();
    assert!(balance.share().abs() < 1e-2, "{balance:?}");
    let [m, w, area, gap] = ["M", "W", "area", "gap"].map(|name| column(&flew, name));
    let most = m.iter().fold(0.0_f64, |most, m| most.max(m.abs()));
    assert!(most > 1.0 && m.iter().zip(&w).all(|(m, w)| (m + w).abs() < 1e-12 * most));
    assert!(area.iter().zip(&gap).any(|(area, gap)| *area > 0.0 && *gap < 0.0));
    let slow = outcome(THROWN, &[&[("analysis.explicit.transient.duration", "0.04")]]);
    assert_eq!(reported(&slow, WarningKind::DeepContact), None);
    assert_eq!(reported(&slow, WarningKind::ShortenedStep), None);
    // What was noted so far stands in the checkpoint.
    stopped_again_and_again("thrown-fast", THROWN, &fast, 4);
}

/// Ends that butt are no harm: a strip that is rolled to a ring in balance, where they meet to rounding.
#[test]
fn a_ring_that_closes_is_not_in_itself() {
    let still = [("analysis", "{ static = { levels = 8 } }"), ("geometry.plate.particles", "[49, 5]")];
    let ring =
        overridden(&text("ring.toml"), "ring.toml", &still).unwrap().build(1).unwrap().run(&mut Silent);
    assert_eq!(reported(&ring, WarningKind::TouchingUnseen), None);
}

#[test]
fn cells_that_sag_towards_a_round_tool_are_reported_before_the_run() {
    let sags = |particles: &str| {
        let replaced = [("geometry.plate.particles", particles)];
        let model =
            overridden(&text("strip-over-drum.toml"), "strip.toml", &replaced).unwrap().build(1).unwrap();
        let own = model.warnings().iter().find(|warning| warning.kind == WarningKind::CoarseContact);
        own.map(|warning| warning.message.clone())
    };
    // 10 mm long: h²/8R = .126 mm of the half thickness of .5. Along the axis of the drum they may be as long as they like.
    let said = sags("[11, 3]").unwrap();
    assert!(
        said.contains("cells 10.0000 long") && said.contains("`drum`") && said.contains("cells of 6.3"),
        "{said}"
    );
    assert_eq!(sags("[18, 2]"), None);
    assert_eq!(sags("[51, 3]"), None);
}

#[test]
fn fields_of_contact_are_refused_where_nothing_may_touch() {
    let scene = overridden(&text("plate.toml"), "plate.toml", &[("output.fields", "{ contact = true }")]);
    let said = scene.map(|_| ()).unwrap_err().to_string();
    assert!(said.contains("output.fields.contact"), "{said}");
}
