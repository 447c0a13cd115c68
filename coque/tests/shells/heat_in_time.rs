//! Heat that a shell conducts in time, in scenes: closed forms, halves and wholes, courses, where it ends, what fields show, what is refused.

use std::f64::consts::PI;

use crate::common::refused::refused;
use crate::common::{column, done, last, overridden, text};
use coque::{Event, Outcome, Simulation};

const PLATE: &str = "plate-quenched.toml";

/// The middle of the plate: a series for each of two directions, and what leaves through the faces.
fn middle(time: f64) -> f64 {
    let (diffusivity, by_volume) = (45.0 / (7850.0 * 480.0), 7850.0 * 480.0);
    let term = |n: usize| {
        let k = (2 * n + 1) as f64 * PI;
        4.0 / k * libm::sin(0.5 * k) * libm::exp(-k * k * diffusivity * time / 0.01)
    };
    let series: f64 = (0..200).map(term).sum();
    20.0 + 480.0 * series * series * libm::exp(-2.0 * 100.0 / (by_volume * 0.002) * time)
}

/// What entered in all, less what is stored, over that.
fn open(found: &Outcome) -> f64 {
    let came = ["supplied_heat", "held_heat", "film_heat", "radiated_heat"];
    let came: f64 = came.iter().map(|name| last(found, name)).sum();
    (came / last(found, "stored_heat") - 1.0).abs()
}

#[test]
fn a_quenched_plate_is_as_its_closed_form_says() {
    let errors = ["[11, 11]", "[21, 21]", "[41, 41]"].map(|particles| {
        let found = done(
            PLATE,
            &[("geometry.plate.particles", particles), ("analysis.heat.transient.tolerance", "0.005")],
        );
        assert!(open(&found) < 1e-11, "{}", open(&found));
        let (times, middles) = (column(&found, "time"), column(&found, "middle"));
        assert_eq!((times.len(), middles[0]), (31, 500.0));
        let worst = times.iter().zip(&middles).skip(1).map(|(time, found)| (found - middle(*time)).abs());
        let worst = worst.fold(0.0, f64::max);
        println!(
            "{particles}: {worst:e}, estimate {}, {} steps",
            last(&found, "step_error"),
            found.summary.record.steps
        );
        worst
    });
    // 4.9, 1.3, .33 K of 480, in the first seconds: temperatures linear along a cell, heat stored at its corners.
    let order = |k: usize| libm::log2(errors[k] / errors[k + 1]);
    assert!((order(0) - 2.0).abs() < 0.2 && (order(1) - 2.0).abs() < 0.2, "{errors:?}");
}

/// Edges of which nothing is said are insulated, which is what a plane of symmetry is: a quarter is a quarter of the whole.
#[test]
fn a_quarter_is_a_quarter_of_the_whole() {
    let whole = done(PLATE, &[("geometry.plate.particles", "[13, 13]")]);
    let quarter = [
        ("geometry.plate", "{ lengths = [0.05, 0.05], particles = [7, 7] }"),
        ("heat[0].on", "[\"u0\", \"v0\"]"),
    ];
    let quarter = done(PLATE, &quarter);
    for (name, part) in [("middle", 1.0), ("held_heat", 0.25), ("film_heat", 0.25), ("stored_heat", 0.25)] {
        for (a, b) in column(&quarter, name).into_iter().zip(column(&whole, name)) {
            assert!((a - part * b).abs() < 1e-9 * (1.0 + part * b.abs()), "{name}: {a} {b}");
        }
    }
}

/// From the balance at the start nothing changes; from elsewhere the same balance is where it ends.
#[test]
fn a_course_ends_in_the_balance_that_it_may_start_from() {
    let heat = ("heat[+]", "{ on = \"u0\", flow = 30.0 }");
    let held = ("heat[0].on", "[\"u1\", \"v0\", \"v1\"]");
    let coarse = ("geometry.plate.particles", "[11, 11]");
    let transient =
        "{ heat = { transient = { duration = 2000.0, record_every = 100.0, tolerance = 0.01 } } }";
    let standing = done(PLATE, &[heat, held, coarse, ("analysis", transient)]);
    let middles = column(&standing, "middle");
    assert!(middles.iter().all(|t| (t / middles[0] - 1.0).abs() < 1e-9), "{middles:?}");
    assert!(last(&standing, "step_error") < 1e-7);
    let coming = transient.replace("{ duration", "{ start = 500.0, duration");
    let coming = done(PLATE, &[heat, held, coarse, ("analysis", &coming)]);
    let steady = done(PLATE, &[heat, held, coarse, ("analysis", "{ heat = {} }"), ("output", "{}")]);
    for found in [&standing, &coming] {
        assert!((last(found, "middle") - last(&steady, "middle")).abs() < 1e-3);
    }
}

/// Heat that goes by a table enters as its trapezoids say; an ambient that goes up alone warms the plate as the exponential of its films has it.
#[test]
fn what_is_given_goes_by_its_course() {
    let transient =
        "{ heat = { transient = { start = 0.0, duration = 60.0, record_every = 5.0, tolerance = 0.01 } } }";
    let coarse = ("geometry.plate.particles", "[6, 6]");
    let table =
        "{ on = \"all\", flow = 40.0, amplitude = { table = [[0, 0], [10, 1], [30, 0.5], [40, 0]] } }";
    let found = done(PLATE, &[coarse, ("heat", &format!("[{table}]")), ("analysis", transient)]);
    let exact = 40.0 * (5.0 + 15.0 + 2.5);
    assert!((last(&found, "supplied_heat") / exact - 1.0).abs() < 1e-12);
    let capacity = 7850.0 * 480.0 * 0.002 * 0.01;
    assert!((last(&found, "middle") - exact / capacity).abs() < 1e-9);
    let rising =
        "{ on = \"all\", film = { coefficient = 100.0, ambient = 60.0 }, amplitude = { ramp = 60.0 } }";
    let found = done(PLATE, &[coarse, ("heat", &format!("[{rising}]")), ("analysis", transient)]);
    let rate = 200.0 / (7850.0 * 480.0 * 0.002);
    let exact = 60.0 - (1.0 - libm::exp(-rate * 60.0)) / rate;
    let error = (last(&found, "middle") - exact).abs();
    println!("{error:e} {}", last(&found, "step_error"));
    assert!(error < last(&found, "step_error") && error < 0.02, "{error}");
}

/// Two plies store the sum of what each does.
#[test]
fn plies_store_the_sum_of_theirs() {
    let ply = |heat: &str| {
        format!(
            "{{ orthotropic = {{ young_along = 140e9, young_across = 10e9, poisson = 0.3, shear = 5e9, density = 1600.0, conductivity = [6.0, 0.8], specific_heat = {heat} }} }}"
        )
    };
    let section = format!(
        "{{ layered = {{ axis = [1.0, 0.0, 0.0], plies = [{{ thickness = 0.001, angle = 0.0 }}, {{ thickness = 0.002, angle = 90.0, material = {} }}] }} }}",
        ply("700.0")
    );
    let transient =
        "{ heat = { transient = { start = 0.0, duration = 10.0, record_every = 10.0, tolerance = 0.01 } } }";
    let replaced = [
        ("geometry.plate.particles", "[6, 6]"),
        ("material", &ply("900.0")),
        ("section", section.as_str()),
        ("heat", "[{ on = \"all\", flow = 40.0 }]"),
        ("analysis", transient),
    ];
    let found = done(PLATE, &replaced);
    let exact = 400.0 / (0.01 * 1600.0 * (0.001 * 900.0 + 0.002 * 700.0));
    assert!((last(&found, "middle") / exact - 1.0).abs() < 1e-10, "{}", last(&found, "middle"));
}

#[test]
fn fields_show_temperatures_as_they_are() {
    let scene = overridden(&text(PLATE), PLATE, &[("geometry.plate.particles", "[11, 11]")]).unwrap();
    let mut simulation = Simulation::new(scene.build(1).unwrap());
    for _ in 0..11 {
        assert_eq!(simulation.advance().unwrap(), Event::Record);
    }
    assert_eq!(simulation.stands_at().time, 20.0);
    let sheet = simulation.sheet(false).unwrap();
    let temperatures = &sheet.point_data["temperature"].numbers;
    assert_eq!(temperatures[60], simulation.curve().column("middle").unwrap()[10]);
    // Put elsewhere between two rows, it goes on from there.
    let cold = vec![20.0; 121];
    simulation.set_state(&[coque::StateArray::new("temperatures", &cold)]).unwrap();
    assert_eq!(simulation.advance().unwrap(), Event::Record);
    assert!((simulation.curve().column("middle").unwrap()[11] - 20.0).abs() < 1e-9);
    assert_eq!(simulation.stands_at().time, 22.0);
}

#[test]
fn what_heat_in_time_does_not_go_with_is_refused() {
    let cases = [
        ("nothing stored", "specific_heat = 480.0", "#"),
        ("rows that are none", "record_every = 2.0", "record_every = 90.0"),
        ("a tolerance that is none", "tolerance = 0.05", "tolerance = 0.0"),
        (
            "a course without time",
            "[analysis.heat.transient]\nstart = 500.0\nduration = 60.0\nrecord_every = 2.0\ntolerance = 0.05",
            "amplitude = { ramp = 1.0 }\n[analysis.heat]",
        ),
        (
            "a course out of order",
            "[analysis.heat",
            "amplitude = { table = [[1, 0], [0, 1]] }\n[analysis.heat",
        ),
        (
            "surroundings that go below absolute zero",
            "[analysis.heat",
            "[[heat]]\non = \"all\"\nradiation = { emissivity = 0.8, constant = 5.67e-8, surroundings = 300.0, zero = 0.0 }\namplitude = { sine = { period = 9.0 } }\n[analysis.heat",
        ),
        ("stresses where nothing is strained", "[output]", "[output]\nfields = { recovered = true }"),
        ("checkpoints", "[output]", "[output]\ncheckpoint_every = 10.0"),
        ("a body that sets out", "[analysis.heat", "[velocity]\nlinear = [0, 0, 1]\n[analysis.heat"),
        ("no start that anything tells", "start = 500.0", "#"),
    ];
    let scene = text(PLATE);
    let cases = cases.map(|(name, from, to)| match name {
        "no start that anything tells" => (name, "held = 20.0             # degrees Celsius, as all temperatures here\n\n[[heat]]\non = \"all\"\nfilm = { coefficient = 100.0, ambient = 20.0 }\n\n[analysis.heat.transient]\nstart = 500.0", "flow = 20.0\n[analysis.heat.transient]"),
        _ => (name, from, to),
    });
    insta::assert_snapshot!(refused(&scene, &cases));
}

/// A pulse that begins and ends between two rows enters in full, and a ramp that ends between them: a step ends at each corner of a course, so that no row and no tolerance
/// tells what came.
#[test]
fn a_pulse_between_two_rows_enters_in_full() {
    let coarse = ("geometry.plate.particles", "[6, 6]");
    let capacity = 7850.0 * 480.0 * 0.002 * 0.01;
    for (course, exact) in [
        ("{ table = [[7.0, 0.0], [7.5, 1.0], [8.0, 0.0]] }", 40.0 * 0.5),
        ("{ table = [[7.0, 0.0], [7.001, 1.0]] }", 40.0 * (20.0 - 7.0005)),
        ("{ ramp = 7.0 }", 40.0 * (20.0 - 3.5)),
    ] {
        for every in ["20.0", "2.5"] {
            let heat = format!("[{{ on = \"all\", flow = 40.0, amplitude = {course} }}]");
            let analysis = format!(
                "{{ heat = {{ transient = {{ start = 0.0, duration = 20.0, record_every = {every}, tolerance = 10.0 }} }} }}"
            );
            let found = done(PLATE, &[coarse, ("heat", &heat), ("analysis", &analysis)]);
            // Between corners the flow is a straight line, of which the rule is exact: measured 1e-15, some sums of rounding.
            assert!((last(&found, "supplied_heat") / exact - 1.0).abs() < 1e-13, "{course}, {every}");
            assert!((last(&found, "middle") * capacity / exact - 1.0).abs() < 1e-12, "{course}, {every}");
        }
    }
}
