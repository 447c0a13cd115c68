//! Numbers of a material that go with the temperature, in scenes: bars of two temperatures and of one that runs, plates that buckle and vibrate, what is refused.

use crate::common::refused::refused;
use crate::common::{done, last, text};

const PLATE: &str = "heated-plate.toml";
const TABLES: &str = "{ reference = 20.0, young = [[0, 1.1], [20, 1.0], [220, 0.6]], expansion = [[0, 1.0], [20, 1.0], [220, 1.4]] }";

/// A bar along x, one long, .1 wide in one cell, .01 thick, that is pulled by 1000 and free aside, under loads.
fn bar(particles: &str, heat: &str, loads: &str) -> f64 {
    let pulled = format!("[{{ on = \"u1\", force = {{ total = [1000, 0, 0] }} }}, {loads}]");
    let supports = "[{ on = \"u0\", held = { displacement = [[1, 0, 0], [0, 0, 1]], director = [[1, 0, 0]] } }, { on = \"u0v0\", held = { displacement = [[0, 1, 0]] } }]";
    let geometry = format!("{{ plate = {{ lengths = [1.0, 0.1], particles = {particles} }} }}");
    let material = format!(
        "{{ elastic = {{ young = 70e9, poisson = 0.0, density = 2700.0, expansion = 23e-6, conductivity = 200.0, by_temperature = {TABLES} }} }}"
    );
    let replaced = [
        ("geometry", geometry.as_str()),
        ("material", material.as_str()),
        ("section.homogeneous.thickness", "0.01"),
        (
            "sets",
            "{ cold = { box = { min = [0, 0, 0], max = [0.5, 0.1, 0] } }, hot = { box = { min = [0.5, 0, 0], max = [1.0, 0.1, 0] } } }",
        ),
        ("heat", heat),
        ("loads", pulled.as_str()),
        ("supports", supports),
        ("analysis", "{ linear = {} }"),
        ("curve", "[{ name = \"u\", of = \"displacement\", on = \"u1\", direction = [1, 0, 0] }]"),
    ];
    last(&done(PLATE, &replaced), "u")
}

/// Halves at 60 and at 120: each with its modulus and with its mean expansion from 20 on.
#[test]
fn a_bar_of_two_temperatures_is_two_bars() {
    let loads = "{ on = \"cold\", temperature = { change = 40.0 } }, { on = \"hot\", temperature = { change = 100.0 } }";
    let found = bar("[9, 2]", "[]", loads);
    let half = |change: f64| {
        let part = change / 200.0;
        let (young, expansion) = (70e9 * (1.0 - 0.4 * part), 23e-6 * (1.0 + 0.4 * part));
        0.5 * (1000.0 / (young * 0.1 * 0.01) + expansion * change)
    };
    let exact = half(40.0) + half(100.0);
    assert!((found / exact - 1.0).abs() < 1e-11, "{found} {exact}");
}

/// Heat that runs from 20 to 220: `∫ (F/(A E) + α (T − 20)) dx`, cells by their middles, of second order.
#[test]
fn a_bar_along_which_heat_runs_is_its_integral() {
    let heat = "[{ on = \"u0\", held = 20.0 }, { on = \"u1\", held = 220.0 }]";
    let loads = "{ on = \"all\", temperature = { conducted = { over = 20.0 } } }";
    let pulled = 1000.0 / (70e9 * 0.1 * 0.01) * libm::log(1.0 / 0.6) / 0.4;
    let exact = pulled + 23e-6 * 200.0 * (0.5 + 0.4 / 3.0);
    let errors = ["[6, 2]", "[11, 2]", "[21, 2]"].map(|particles| bar(particles, heat, loads) / exact - 1.0);
    println!("{errors:?}");
    for pair in errors.windows(2) {
        assert!((libm::log2(pair[0] / pair[1]) - 2.0).abs() < 0.05, "{errors:?}");
    }
    // 1.3e-4 of it with 20 cells: middles of cells for means of what is no straight line.
    assert!(errors[2].abs() < 4e-4, "{errors:?}");
}

/// What is held in its plane buckles at a change that no modulus changes, and that the mean expansion divides.
#[test]
fn a_held_plate_buckles_whatever_its_modulus() {
    let coarse = ("geometry.plate.particles", "[13, 13]");
    let level = |table: &str| {
        let material = format!("{{ reference = 20.0, {table} }}");
        last(&done(PLATE, &[coarse, ("material.elastic.by_temperature", &material)]), "level")
    };
    let cold = last(&done(PLATE, &[coarse]), "level");
    let soft = level("young = [[20, 0.5], [30, 0.5]]");
    let swelling = level("expansion = [[20, 1.25], [30, 1.25]]");
    assert!((soft / cold - 1.0).abs() < 1e-8, "{soft} {cold}");
    assert!((1.25 * swelling / cold - 1.0).abs() < 1e-8, "{swelling} {cold}");
}

/// Hot and free in its plane a plate buckles under a force at the share of its modulus, and ω² has that share: as large as the plate is that stays stiff.
#[test]
fn a_free_plate_is_as_soft_as_it_is_hot() {
    let of = |analysis: &str, hot: f64| {
        let loads = "[{ on = \"all\", temperature = { change = 100.0 }, preload = true }, { on = \"u1\", force = { total = [-1000, 0, 0] } }]";
        let supports = "[{ on = \"u0\", held = { displacement = [[1, 0, 0], [0, 0, 1]] } }, { on = [\"u1\", \"v0\", \"v1\"], held = { displacement = [[0, 0, 1]] } }, { on = \"u0v0\", held = { displacement = [[0, 1, 0]] } }]";
        let young = format!("{{ reference = 20.0, young = [[20, 1.0], [220, {hot}]] }}");
        let replaced = [
            ("geometry.plate.particles", "[13, 13]"),
            ("material.elastic.by_temperature", young.as_str()),
            ("supports", supports),
            ("loads", loads),
            ("analysis", analysis),
        ];
        let found = done(PLATE, &replaced);
        match analysis.contains("modal") {
            true => found.curve.column("circular_frequency").unwrap()[0].powi(2),
            false => last(&found, "level"),
        }
    };
    for analysis in ["{ buckling = { modes = 1 } }", "{ modal = { modes = 1 } }"] {
        let ratio = of(analysis, 0.6) / of(analysis, 1.0);
        assert!((ratio / 0.8 - 1.0).abs() < 1e-8, "{analysis}: {ratio}");
    }
}

/// A conductivity that grows threefold from 0 to 100: `T + T²/100` is linear along the fin (Kirchhoff).
#[test]
fn heat_runs_by_kirchhoffs_transform() {
    let table = "{ reference = 20.0, conductivity = [[0, 1.0], [100, 3.0]] }";
    let replaced = [
        ("heat", "[{ on = \"u0\", held = 100.0 }, { on = \"u1\", held = 0.0 }]"),
        ("material.elastic.by_temperature", table),
        ("sets", "{ inner = { nearest = [0.025, 0.0, 0.0] } }"),
        ("curve[+]", "{ name = \"inner\", of = \"temperature\", on = \"inner\" }"),
    ];
    let found = done("cooled-fin.toml", &replaced);
    assert!((last(&found, "root") / (200.0 * 0.003 * 0.05 * 200.0 / 0.1) - 1.0).abs() < 1e-9);
    assert!((last(&found, "inner") / (50.0 * (7.0_f64.sqrt() - 1.0)) - 1.0).abs() < 1e-9);
}

#[test]
fn what_does_not_go_with_the_temperature_is_refused() {
    let given = "expansion = 23e-6   # by kelvin";
    let with = |table: &str| format!("expansion = 23e-6\nby_temperature = {{ {table} }}");
    let young = "reference = 20.0, young = [[20, 1.0], [220, 0.6]]";
    let tables = [
        ("no table", with("reference = 20.0")),
        ("a table out of order", with("reference = 20.0, young = [[200, 1.0], [20, 0.6]]")),
        ("a factor of nothing", with("reference = 20.0, young = [[20, 1.0], [220, 0.0]]")),
        ("a factor beyond Poisson's bound", with("reference = 20.0, poisson = [[20, 1.0], [220, 1.8]]")),
        ("a temperature beyond a table", with("reference = 20.0, young = [[20, 1.0], [20.5, 0.9]]")),
        (
            "factors of what is not given",
            format!("by_temperature = {{ {} }}", "reference = 20.0, expansion = [[20, 1.0], [220, 1.2]]"),
        ),
    ];
    let mut cases: Vec<(&str, &str, &str)> =
        tables.iter().map(|(name, table)| (*name, given, table.as_str())).collect();
    let scene = text(PLATE).replace(given, &with(young));
    let more = [
        ("a difference", "{ change = 1.0 }", "{ change = 1.0, difference = 2.0 }"),
        (
            "plies",
            "[section.homogeneous]\nthickness = 0.004",
            "[section.layered]\naxis = [1.0, 0.0, 0.0]\nplies = [{ thickness = 0.004, angle = 0.0 }]",
        ),
        ("a load case", "[analysis.buckling]\nmodes = 1", "case = \"hot\"\n[analysis.linear]"),
        ("another start", "{ change = 1.0 }", "{ conducted = { over = 0.0 } }"),
    ];
    let first = refused(&text(PLATE), &cases);
    cases = more.to_vec();
    cases[2] = ("a load case", "{ change = 1.0 }\n", "{ change = 1.0 }\ncase = \"hot\"\n");
    let second = refused(&scene.replace("[analysis.buckling]\nmodes = 1", "[analysis.linear]"), &cases);
    insta::assert_snapshot!(first + &second);
}

/// Factors are those of the temperature of the full load: a level beyond one, and a vibration without it, are refused; with levels up to one, or as a preload, it goes.
#[test]
fn factors_are_those_of_the_full_load() {
    let coarse = ("geometry.plate.particles", "[9, 9]");
    let tables = ("material.elastic.by_temperature", "{ reference = 20.0, young = [[20, 1.0], [220, 0.6]] }");
    let said = |analysis: &str| {
        let measured = "[{ name = \"u\", of = \"displacement\", on = \"all\", direction = [0, 0, 1] }]";
        crate::common::refusal(PLATE, &[coarse, tables, ("analysis", analysis), ("curve", measured)], 400)
    };
    for analysis in ["{ static = { levels = [0.5, 1.5] } }", "{ relaxation = { levels = [0.5, 1.5] } }"] {
        let said = said(analysis);
        assert!(said.contains("levels up to one") && said.contains("`preload = true`"), "{said}");
    }
    let spectrum = "{ response-spectrum = { modes = 2, damping.ratio = 0.05, base = [{ acceleration = [0, 0, 1], by = \"period\", amplitude = { table = [[0, 1.0]] } }] } }";
    for analysis in [
        "{ modal = { modes = 1 } }",
        "{ harmonic = { frequencies = [20.0], damping.structural = 0.05 } }",
        spectrum,
    ] {
        let said = said(analysis);
        assert!(said.contains("`loads[0].temperature`") && said.contains("`preload = true`"), "{said}");
    }
    done(PLATE, &[coarse, tables, ("analysis", "{ static = { levels = [0.5, 1.0] } }")]);
    done(PLATE, &[coarse, tables, ("loads[0].preload", "true"), ("analysis", "{ modal = { modes = 1 } }")]);
}

/// Changes count from one reference: parts with another one are refused.
#[test]
fn parts_have_one_reference() {
    let of = |reference: &str| {
        let tables = "reference = 20.0, young = [[20, 1.0], [220, 0.6]]";
        let own = tables.replace("reference = 20.0", &format!("reference = {reference}"));
        [
            ("geometry.plate.particles", "[9, 9]".to_string()),
            ("material.elastic.by_temperature", format!("{{ {tables} }}")),
            ("sets.half", "{ box = { min = [0, 0, 0], max = [0.25, 0.5, 0] } }".to_string()),
            (
                "parts",
                format!(
                    "[{{ on = \"half\", material.elastic = {{ young = 70e9, poisson = 0.3, density = 2700.0, expansion = 23e-6, by_temperature = {{ {own} }} }} }}]"
                ),
            ),
        ]
    };
    let [other, same] = [of("30.0"), of("20.0")];
    let said =
        crate::common::refusal(PLATE, &other.each_ref().map(|(path, value)| (*path, value.as_str())), 400);
    assert!(said.contains("by_temperature.reference` is 30; it must be 20 everywhere"), "{said}");
    // The part is the plate: two tables that say the same are one.
    let whole = [
        ("geometry.plate.particles", "[9, 9]"),
        ("material.elastic.by_temperature", "{ reference = 20.0, young = [[20, 1.0], [220, 0.6]] }"),
    ];
    let parts = done(PLATE, &same.each_ref().map(|(path, value)| (*path, value.as_str())));
    // Rounding of a factor of 81 particles.
    assert!((last(&parts, "level") / last(&done(PLATE, &whole), "level") - 1.0).abs() < 1e-11);
}

/// A table of one entry has one temperature: moduli at it go, moduli and conductivities elsewhere are refused with its ends.
#[test]
fn a_table_of_one_entry_has_one_temperature() {
    let coarse = ("geometry.plate.particles", "[9, 9]");
    let of = |entry: &str| format!("{{ reference = 20.0, young = [[{entry}, 0.5]] }}");
    let (here, away) = (of("21.0"), of("20.0"));
    // Held in its plane it buckles whatever its modulus (above): measured 9e-13, what modes are found to.
    let [found, plain] =
        [done(PLATE, &[coarse, ("material.elastic.by_temperature", &here)]), done(PLATE, &[coarse])];
    assert!((last(&found, "level") / last(&plain, "level") - 1.0).abs() < 3e-12);
    let said = crate::common::refusal(PLATE, &[coarse, ("material.elastic.by_temperature", &away)], 400);
    assert!(said.contains("no factor at 21.0"), "{said}");
    let fin = ("material.elastic.by_temperature", "{ reference = 20.0, conductivity = [[20, 1.0]] }");
    let ended = crate::common::run("cooled-fin.toml", &[fin]).summary.ended;
    assert!(ended.contains("goes from 20 to 20"), "{ended}");
}
