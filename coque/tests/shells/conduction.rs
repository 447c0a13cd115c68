//! Heat that a shell conducts, in scenes: closed forms, what it does to a plate, halves and wholes, what fields show, what is refused.

use crate::common::refused::refused;
use crate::common::{done, last, overridden, text};
use coque::{Event, Simulation};

const FIN: &str = "cooled-fin.toml";
/// What holds the fin and cools it.
const GIVEN: &str = "on = \"u0\"\nheld = 100.0           # degrees Celsius, as all temperatures here\n\n[[heat]]\non = \"all\"\n\
                     film = { coefficient = 50.0, ambient = 20.0 }";
const PLATE: &str = "plate-heated-aside.toml";

#[test]
fn a_fin_is_as_its_closed_form_says() {
    let m = (2.0_f64 * 50.0 / (200.0 * 0.003)).sqrt();
    let (end, root) = (80.0 / libm::cosh(0.1 * m), 200.0 * 0.003 * 0.05 * m * 80.0 * libm::tanh(0.1 * m));
    let errors = ["[11, 5]", "[21, 5]", "[41, 5]"].map(|particles| {
        let found = done(FIN, &[("geometry.plate.particles", particles)]);
        let sum: f64 = ["supplied", "held", "film", "radiated"].iter().map(|name| last(&found, name)).sum();
        assert!(sum.abs() < 1e-10 * root, "{sum}");
        assert!((last(&found, "held") / last(&found, "root") - 1.0).abs() < 1e-12);
        [(last(&found, "end") - 20.0) / end - 1.0, last(&found, "root") / root - 1.0]
    });
    println!("{errors:?}");
    for k in 0..2 {
        let order = libm::log2((errors[1][k] / errors[2][k]).abs());
        assert!((order - 2.0).abs() < 0.1, "{errors:?}");
    }
    // 4.8e-5 and 1.13e-4 with 40 cells: temperatures linear along a cell, heat lumped at its ends.
    for (error, bound) in errors[2].into_iter().zip([1.5e-4, 3.4e-4]) {
        assert!(error.abs() < bound, "{errors:?}");
    }
}

/// What enters by `flow`, by `flux` and through an edge is the same heat where it is the same by area, and all of it leaves through the film.
#[test]
fn heat_is_given_in_several_ways() {
    let given = |how: &str, on: &str| {
        let heat = format!("{{ on = \"{on}\", {how} }}");
        done(FIN, &[("heat[0]", &heat)])
    };
    let (area, section) = (0.1 * 0.05, 0.05 * 0.003);
    let (flow, flux) = (given("flow = 12.0", "all"), given(&format!("flux = {}", 12.0 / area), "all"));
    let (edge, through) =
        (given("flow = 12.0", "u0"), given(&format!("edge_flux = {}", 12.0 / section), "u0"));
    for (a, b) in [(&flow, &flux), (&edge, &through)] {
        assert!((last(a, "end") / last(b, "end") - 1.0).abs() < 1e-12);
        assert!((last(a, "film") + 12.0).abs() < 1e-9 && (last(a, "supplied") - 12.0).abs() < 1e-9);
    }
    // Evenly warmed it is at one temperature.
    assert!((last(&flow, "end") - (20.0 + 12.0 / (2.0 * 50.0 * area))).abs() < 1e-9);
    // Of one face half as much.
    let one = [("heat[0]", "{ on = \"all\", flow = 12.0 }"), ("heat[1].film.faces", "\"front\"")];
    let one = done(FIN, &one);
    assert!((last(&one, "end") - (20.0 + 12.0 / (50.0 * area))).abs() < 1e-9);
}

/// A plate in empty space that is warmed, in degrees Celsius.
#[test]
fn a_plate_alone_radiates_what_it_is_given() {
    let radiation = "{ on = \"all\", radiation = { emissivity = 0.8, constant = 5.670374419e-8, surroundings = 20.0, zero = -273.15 } }";
    let found = done(FIN, &[("heat[0]", "{ on = \"all\", flux = 5000.0 }"), ("heat[1]", radiation)]);
    let exact = libm::pow(293.15_f64.powi(4) + 5000.0 / (1.6 * 5.670374419e-8), 0.25) - 273.15;
    assert!((last(&found, "end") / exact - 1.0).abs() < 1e-9, "{}", last(&found, "end"));
    assert!((last(&found, "radiated") + 5000.0 * 0.005).abs() < 1e-9);
}

/// Two plies side by side conduct the sum of what each does; at an angle by the turned tensor.
#[test]
fn plies_conduct_the_sum_of_theirs() {
    let fibre = "{ orthotropic = { young_along = 140e9, young_across = 10e9, poisson = 0.3, shear = 5e9, density = 1600.0, conductivity = [6.0, 0.8] } }";
    let heat = ["{ on = \"u0\", held = 100.0 }", "{ on = \"u1\", held = 20.0 }"];
    let through = |plies: &str| {
        let section = format!("{{ layered = {{ axis = [1.0, 0.0, 0.0], plies = {plies} }} }}");
        let replaced =
            [("material", fibre), ("section", section.as_str()), ("heat[0]", heat[0]), ("heat[1]", heat[1])];
        last(&done(FIN, &replaced), "root") / (0.05 * 80.0 / 0.1)
    };
    let crossed = through("[{ thickness = 0.001, angle = 0.0 }, { thickness = 0.002, angle = 90.0 }]");
    assert!((crossed / (0.001 * 6.0 + 0.002 * 0.8) - 1.0).abs() < 1e-10, "{crossed}");
    // ±45° hand nothing aside: the mean of both, by any balanced pair.
    let pair = through("[{ thickness = 0.001, angle = 45.0 }, { thickness = 0.001, angle = -45.0 }]");
    assert!((pair / (0.002 * 3.4) - 1.0).abs() < 1e-10, "{pair}");
}

/// Between walls the heat that runs across presses alike along its way, T̄ the mean, and across it by the temperature of the place.
#[test]
fn a_plate_heated_at_one_edge_bears_its_closed_form() {
    let curve = "[{ name = \"along\", of = \"membrane-force\", on = \"hot\", direction = [1, 0, 0] },
                  { name = \"across\", of = \"membrane-force\", on = \"hot\", direction = [0, 1, 0] }]";
    let replaced = [
        ("geometry.plate.particles", "[21, 11]"),
        ("sets", "{ hot = { box = { min = [0.0, 0.0, 0.0], max = [0.025, 0.5, 0.0] } } }"),
        ("curve", curve),
        ("analysis", "{ linear = {} }"),
    ];
    let found = done(PLATE, &replaced);
    let by_degree = 70e9 * 0.004 * 23e-6;
    // In the first cell T − T̄ is .95 K.
    let exact = [-by_degree / 0.7, -by_degree * (1.0 / 0.7 + 0.95)];
    for (name, exact) in ["along", "across"].into_iter().zip(exact) {
        assert!((last(&found, name) / exact - 1.0).abs() < 1e-9, "{name}: {} {exact}", last(&found, name));
    }
}

/// An insulated edge is a plane of symmetry for heat: half of a plate, or of a fin, is half of the whole.
#[test]
fn half_is_half_of_the_whole() {
    let whole = last(&done(PLATE, &[("geometry.plate.particles", "[21, 21]")]), "level");
    let half = [
        ("geometry.plate", "{ lengths = [0.5, 0.25], particles = [21, 11] }"),
        ("supports[1].on", "\"v0\""),
        ("supports[+]", "{ on = \"v1\", symmetry = { normal = [0, 1, 0] } }"),
    ];
    let half = last(&done(PLATE, &half), "level");
    assert!((half / whole - 1.0).abs() < 1e-9, "{half} {whole}");
    let whole = done(FIN, &[]);
    let half = done(FIN, &[("geometry.plate", "{ lengths = [0.1, 0.025], particles = [41, 3] }")]);
    assert!((last(&half, "root") / last(&whole, "root") - 0.5).abs() < 1e-12);
    assert!((last(&half, "end") / last(&whole, "end") - 1.0).abs() < 1e-12);
}

/// What is conducted is what the analysis of heat finds: given by numbers of its own the plate buckles alike.
#[test]
fn conducted_changes_are_those_of_the_analysis_of_heat() {
    let even = [("heat[0].held", "21.0"), ("heat[1].held", "21.0")];
    let conducted = last(&done(PLATE, &even), "level");
    let given = last(&done(PLATE, &[("heat", "[]"), ("loads[0].temperature", "{ change = 1.0 }")]), "level");
    assert!((conducted / given - 1.0).abs() < 1e-9, "{conducted} {given}");
}

#[test]
fn fields_show_temperatures_and_where_heat_runs() {
    let scene = overridden(&text(FIN), FIN, &[]).unwrap();
    let mut simulation = Simulation::new(scene.build(1).unwrap());
    while simulation.advance().unwrap() != Event::End {}
    let sheet = simulation.sheet(false).unwrap();
    let temperature = &sheet.point_data["temperature"];
    assert_eq!((temperature.numbers.len(), temperature.unit.as_deref()), (41 * 5, Some("Θ")));
    assert!(temperature.numbers.iter().all(|t| (60.0..=100.0).contains(t)));
    let flux = &sheet.cell_data["heat_flux"];
    assert_eq!((flux.numbers.len(), flux.unit.as_deref()), (3 * 40 * 4, Some("N/s")));
    assert!(flux.numbers.chunks(3).all(|flux| flux[0] > 0.0 && flux[1].abs() < 1e-9 * flux[0]));
}

#[test]
fn what_heat_does_not_go_with_is_refused() {
    let scene = text(FIN);
    let cases = [
        ("nothing tells the temperature", GIVEN, "on = \"u0\"\nflow = 1.0"),
        ("two kinds at once", "held = 100.0 ", "held = 100.0\nflow = 1.0 #"),
        ("no conductivity", "conductivity = 200.0", "#"),
        (
            "a load in it",
            "[analysis.heat]",
            "[[loads]]\non = \"u1\"\nforce = { total = [0, 0, 1] }\n[analysis.heat]",
        ),
        (
            "heat nobody asks for",
            "[analysis.heat]",
            "[[supports]]\non = \"u0\"\nclamped = {}\n[[loads]]\non = \"u1\"\nforce = { total = [0, 0, 1] }\n[analysis.linear]",
        ),
        (
            "what does not move has no displacement",
            "of = \"temperature\"",
            "of = \"displacement\"\ndirection = [0, 0, 1]",
        ),
        ("an edge that is none", "held = 100.0 ", "edge_flux = 1.0 #"),
        (
            "surroundings below absolute zero",
            "held = 100.0 ",
            "radiation = { emissivity = 0.5, constant = 5.67e-8, surroundings = -20.0, zero = 0.0 } #",
        ),
        (
            "an emissivity beyond one",
            "held = 100.0 ",
            "radiation = { emissivity = 1.5, constant = 5.67e-8, surroundings = 20.0, zero = 0.0 } #",
        ),
        ("a set that is none", "on = \"u0\"\nheld", "on = \"root\"\nheld"),
        (
            "stencils wider than a cell",
            "[analysis.heat]",
            "[formulation.stress-point]\nsupport = 1.6\n[analysis.heat]",
        ),
    ];
    let cases = cases.map(|(name, from, to)| match name {
        // Cells lie all over it, and no boundary does.
        "an edge that is none" => (name, "on = \"u0\"\nheld = 100.0 ", "on = \"all\"\nedge_flux = 1.0 #"),
        _ => (name, from, to),
    });
    insta::assert_snapshot!(refused(&scene, &cases));
    let cases = [
        ("a change beside it", "conducted = {", "change = 1.0, conducted = {"),
        ("two temperatures of a corner", "on = \"u1\"\nheld = 20.0", "on = \"v0\"\nheld = 20.0"),
        (
            "nothing to conduct",
            "[[heat]]\non = \"u0\"\nheld = 22.0            # degrees Celsius\n\n[[heat]]\non = \"u1\"\nheld = 20.0\n",
            "",
        ),
    ];
    insta::assert_snapshot!("conducted_refusals", refused(&text(PLATE), &cases));
}
