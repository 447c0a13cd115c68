//! Shells that touch themselves, in scenes: what is refused, the same bits after a stop, the force with and without time.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::sittings::stopped_again_and_again;
use crate::common::{Replaced, column, overridden, ran, refusal, run, text};
use coque::Ended;
use toml::{Table, Value};

const RING: &str = "ring-in-itself.toml";
const COARSE: (&str, &str) = ("geometry.cylinder.particles", "[21, 3]");

#[test]
fn broken_contacts_say_where_and_why() {
    let tube =
        ("geometry.cylinder", "{ radius = 1.0, angles = [0.0, 359.0], length = 0.1, particles = [360, 3] }");
    let still = ("analysis", "{ explicit = { transient = { duration = 1.0, record_every = 0.1 } } }");
    let thin = ("parts", "[{ on = 'upper', section = { homogeneous = { thickness = 0.04 } } }]");
    let cases: [(&str, Replaced, &str); 7] = [
        (
            "two bodies",
            &[("contact", "[{ between = ['a', 'b'] }]")],
            "a shell, a solid or a rigid body of the scene",
        ),
        ("twice", &[("contact", "[{}, {}]")], "another contact"),
        ("a linear analysis", &[("analysis", "{ linear = {} }")], "nothing opens or closes"),
        ("a stiffness of zero", &[("contact", "[{ stiffness = 0.0 }]")], "contact[0].stiffness"),
        ("rounded into the barrier", &[("contact", "[{ rounding = 0.2 }]")], "contact[0].rounding"),
        ("ends that stand in each other", &[tube, still, ("supports", "[]"), ("loads", "[]")], "apart"),
        ("two thicknesses", &[thin], "has one thickness"),
    ];
    for (name, replaced, words) in cases {
        let said = refusal(RING, replaced, 400);
        assert!(said.contains(words), "{name}: {said}");
    }
}

/// The upper half thrown down: it meets the lower one at .6, seen at one record.
const THROWN: [(&str, &str); 4] = [
    COARSE,
    ("analysis", "{ explicit = { transient = { duration = 1.6, record_every = 0.05 } } }"),
    ("velocity", "{ on = 'upper', linear = [0.0, 0.0, -3.5] }"),
    ("loads", "[]"),
];

/// Stopped again and again, before walls have touched and after.
#[test]
fn contact_goes_on_to_the_same_bits() {
    stopped_again_and_again("thrown", &text(RING), &THROWN, 2);
}

/// A thing of the scene of one shell on a set of one of two shells.
fn of_body(item: &Value, body: &str) -> Value {
    let mut item = item.clone();
    let on = item["on"].as_str().unwrap().to_string();
    item["on"] = if on.starts_with(['u', 'v']) && on.len() == 2 {
        format!("{body}.{on}").into()
    } else {
        format!("{on}-{body}").into()
    };
    if let Some(name) = item.get("name").and_then(Value::as_str).map(|name| format!("{name}_{body}")) {
        item["name"] = name.into();
    }
    item
}

/// Two shells in one scene, each of which touches itself, move as one that is alone.
#[test]
fn twins_that_touch_themselves_move_as_one_alone() {
    let alone = run(RING, &THROWN);
    let mut scene: Table = text(RING).parse().unwrap();
    let own = ["geometry", "material", "section"].map(|key| (key.to_string(), scene.remove(key).unwrap()));
    let velocity = |body: &str| -> Value {
        Table::from_iter([
            ("on".to_string(), format!("upper-{body}").into()),
            ("linear".to_string(), Value::from(vec![0.0, 0.0, -3.5])),
        ])
        .into()
    };
    let (mut bodies, mut sets, mut contact) = (Table::new(), Table::new(), Vec::new());
    let [mut supports, mut curve] = [Vec::new(), Vec::new()];
    for body in ["a", "b"] {
        let mut shell = Table::from_iter(own.clone());
        shell.insert("velocity".into(), velocity(body));
        bodies.insert(body.into(), Table::from_iter([("shell".to_string(), shell.into())]).into());
        for (name, region) in scene["sets"].as_table().unwrap() {
            let mut region = region.clone();
            region.as_table_mut().unwrap().insert("of".into(), body.into());
            sets.insert(format!("{name}-{body}"), region);
        }
        let items = |key: &str| scene[key].as_array().unwrap().iter().map(|item| of_body(item, body));
        supports.extend(items("supports"));
        curve.extend(items("curve"));
        let between = Value::from(vec![body, body]);
        contact.push(Value::from(Table::from_iter([("between".to_string(), between)])));
    }
    scene.remove("loads");
    scene.remove("output");
    for (key, value) in [
        ("bodies", Value::from(bodies)),
        ("sets", sets.into()),
        ("supports", supports.into()),
        ("curve", curve.into()),
        ("contact", contact.into()),
    ] {
        scene.insert(key.into(), value);
    }
    let coarse = ["a", "b"].map(|body| format!("bodies.{body}.shell.geometry.cylinder.particles"));
    let replaced = [(&coarse[0][..], COARSE.1), (&coarse[1][..], COARSE.1), THROWN[1]];
    let twins = ran(overridden(&toml::to_string(&scene).unwrap(), "twins.toml", &replaced));
    for name in ["F", "b"] {
        let one = column(&alone, name);
        assert!(name == "b" || one.iter().any(|force| *force != 0.0));
        for body in ["a", "b"] {
            assert_eq!(column(&twins, &format!("{name}_{body}")), one, "{name} of {body}");
        }
    }
}

/// Walls that press on each other do so as hard in a march that comes to rest.
#[test]
fn marches_and_statics_press_alike() {
    let force = |analysis: &str| {
        let outcome = run(RING, &[COARSE, ("analysis", analysis)]);
        assert_eq!(outcome.ended, Ended::Done, "{}", outcome.summary.ended);
        column(&outcome, "F").last().copied().unwrap()
    };
    let still = force("{ static = { levels = [0.28, 0.31, 0.35, 0.45, 0.6] } }");
    let marched = force("{ explicit = { quasi-static = { levels = [0.28, 0.35, 0.45, 0.6] } } }");
    println!("{still:.5} {marched:.5}");
    assert!(still > 0.5 && (marched / still - 1.0).abs() < 0.02, "{still} {marched}");
}
