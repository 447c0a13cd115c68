//! Answers to response spectra and to noise from a scene: sums that must be whole, rules of combination, harmonic answers squared, other units, turned.

use std::f64::consts::PI;

use implicit_statics::{Combination, ModesTogether};

use super::harmonic::plate;
use crate::common::{Replaced, column, last};
use coque::Outcome;

/// Modes of the free particles of the plate: with all of them nothing is left out.
const ALL: &str = "80";
/// A spectrum without colour: as much at any period.
const FLAT: &str = "{ response-spectrum = { modes = 8, damping.ratio = 0.03, base = [\
    { acceleration = [0.0, 0.0, 2.0], by = \"period\", amplitude = { table = [[0.0, 1.0]] } },\
    { acceleration = [0.0, 3.0, 0.0], by = \"period\", amplitude = { table = [[0.0, 0.5]] } }] } }";
const NOISE: &str = "{ random-vibration = { modes = 8, damping.ratio = 0.02, frequencies = [15.0, 31.0, 60.0, 240.0], \
    base = [{ acceleration = [0.5, 0.0, 2.0], density = [[10.0, 0.02], [100.0, 0.05], [400.0, 0.01]] }] } }";
const ACCELERATED: (&str, &str) =
    ("curve[+]", "{ name = \"a\", of = \"acceleration\", on = \"there\", direction = [0.1, 0.3, 1.0] }");
const UNLOADED: (&str, &str) = ("loads", "[]");
const COLUMNS: [&str; 7] = ["w", "turn", "v", "R", "M", "m", "a"];
const MASS: f64 = 2700.0 * 0.4 * 0.3 * 0.004;

fn spectral(replaced: Replaced) -> Outcome {
    plate(&[&[("analysis", FLAT), UNLOADED, ACCELERATED], replaced].concat())
}

fn noisy(replaced: Replaced) -> Outcome {
    plate(&[&[("analysis", NOISE), UNLOADED, ACCELERATED], replaced].concat())
}

/// What the modes and the mass that they leave out make of a column of the first base, with their signs.
fn parts(outcome: &Outcome, column: usize) -> (Vec<f64>, f64) {
    let base = &outcome.summary.vibration.as_ref().unwrap().bases[0];
    (base.modes.iter().map(|mode| mode.columns[column]).collect(), base.missing_mass[column])
}

/// Under a flat spectrum all parts, with their signs, are the body held in a field of that acceleration: the supports bear all of its mass, every particle is accelerated
/// as the ground is, the deflection is that at rest. So whatever the number of modes.
#[test]
fn parts_under_a_flat_spectrum_make_the_whole() {
    let weight = ("loads", "[{ on = \"all\", gravity = { acceleration = [0.0, 0.0, -2.0] } }]");
    let read = ("curve[2]", "{ name = \"v\", of = \"displacement\", on = \"there\", direction = [0, 0, 1] }");
    let rest = plate(&[("analysis", "{ linear = {} }"), weight, read]);
    for modes in ["3", "20", ALL] {
        let outcome = spectral(&[("analysis.response-spectrum.modes", modes)]);
        let whole = |c: usize| {
            let (modes, rest) = parts(&outcome, c);
            modes.iter().sum::<f64>() + rest
        };
        for (c, name) in [(0, "w"), (1, "turn"), (3, "R"), (4, "M"), (5, "m")] {
            // Slopes of a linear answer are found over the same hundredth of the thickness.
            assert!((whole(c) / last(&rest, name) - 1.0).abs() < 1e-8, "{modes} {name}");
        }
        assert!((whole(3) / (2.0 * MASS) - 1.0).abs() < 1e-9, "{modes} {}", whole(3));
        assert!((whole(6) / (2.0 / 1.1_f64.sqrt()) - 1.0).abs() < 1e-9, "{modes} {}", whole(6));
        let base = &outcome.summary.vibration.as_ref().unwrap().bases[0];
        let all = modes == ALL;
        assert!(all == ((base.share - 1.0).abs() < 1e-9) && base.share < 1.0 + 1e-9, "{}", base.share);
        let sum: f64 = base.modes.iter().map(|mode| mode.effective_mass).sum();
        assert!((sum / base.mass / base.share - 1.0).abs() < 1e-12);
        // A quarter of the spacing of the plate is held: half of a cell of four.
        assert!((base.mass / MASS - 0.875).abs() < 1e-9, "{}", base.mass / MASS);
        // Of unlike lumps of a coarse plate: 4 % here.
        let first = &base.modes[0];
        assert!((first.effective_mass / first.participation.powi(2) - 1.0).abs() < 0.12);
    }
}

/// What stands in the curve is what the rules make of the parts in the summary.
#[test]
fn rows_are_the_parts_combined() {
    for (word, rule) in
        [("cqc", Combination::Cqc), ("srss", Combination::Srss), ("absolute", Combination::Absolute)]
    {
        let key = ("analysis.response-spectrum.combination", word);
        let outcome = spectral(&[key, ("analysis.response-spectrum.directions", "hundred-thirty")]);
        let summary = outcome.summary.vibration.as_ref().unwrap();
        let swings: Vec<[f64; 2]> =
            summary.modes.iter().map(|mode| [mode.frequency * 2.0 * PI, mode.damping]).collect();
        for (c, name) in COLUMNS.into_iter().enumerate() {
            let (modes, rest) = parts(&outcome, c);
            let rows = column(&outcome, name);
            let own = ModesTogether::new(rule, &swings).of(&modes, rest);
            assert!((rows[0] / own - 1.0).abs() < 1e-12, "{word} {name}");
            let most = rows[0].max(rows[1]) + 0.3 * rows[0].min(rows[1]);
            assert!((rows[2] / most - 1.0).abs() < 1e-12, "{word} {name}");
        }
        assert_eq!(column(&outcome, "base"), [1.0, 2.0, 0.0]);
    }
}

/// The ground steps to an acceleration: each mode goes to `1 + exp(−πζ/√(1 − ζ²))` of its way at rest.
#[test]
fn the_spectrum_of_a_course_is_found_for_each_mode() {
    let base = "[{ acceleration = [0.0, 0.0, 2.0], by = \"time\", amplitude = { table = [[0.0, 1.0], [0.02, 1.0], [0.5, 1.0], [50.0, 1.0], [60.0, 0.0]] } }]";
    let outcome = spectral(&[("analysis.response-spectrum.base", base)]);
    let over = 1.0 + libm::exp(-PI * 0.03 / (1.0_f64 - 0.03 * 0.03).sqrt());
    let base = &outcome.summary.vibration.as_ref().unwrap().bases[0];
    assert_eq!(base.ground, Some(2.0));
    for mode in &base.modes {
        let own = mode.acceleration.unwrap();
        assert!((own / (2.0 * over) - 1.0).abs() < 1e-9, "{own} {}", 2.0 * over);
    }
}

/// A ground so slow that all modes follow it: the supports bear its acceleration times all mass, however many modes are taken, and fewer do no harm.
#[test]
fn a_body_that_follows_the_ground_bears_its_acceleration() {
    let base = "[{ acceleration = [0.0, 0.0, 2.0], by = \"time\", amplitude = { table = [[0.0, 0.0], [5.0, 1.0], [10.0, 0.0]] } }]";
    for modes in ["1", "8", "40"] {
        let outcome = spectral(&[
            ("analysis.response-spectrum.base", base),
            ("analysis.response-spectrum.modes", modes),
        ]);
        // Modes from 21 Hz on swing by less than a thousandth about a course of ten seconds.
        let found = column(&outcome, "R")[0] / (2.0 * MASS);
        assert!((found - 1.0).abs() < 3e-3, "{modes}: {found}");
    }
}

/// The order of bases is their rows' alone; a base that shakes the other way shakes alike, and twice as much twice as much.
#[test]
fn bases_may_change_places_and_sides() {
    let swapped = "[{ acceleration = [0.0, -3.0, 0.0], by = \"period\", amplitude = { table = [[0.0, 0.5]] } },\
         { acceleration = [0.0, 0.0, 1.0], by = \"frequency\", amplitude = { table = [[1.0, 2.0], [9.0, 2.0]] } }]";
    let (one, other) = (spectral(&[]), spectral(&[("analysis.response-spectrum.base", swapped)]));
    for name in COLUMNS {
        let (a, b) = (column(&one, name), column(&other, name));
        for (i, j) in [(0, 1), (1, 0), (2, 2)] {
            assert!((a[i] / b[j] - 1.0).abs() < 1e-9, "{name} {a:?} {b:?}");
        }
    }
}

/// A density is that of the noise times the square of the harmonic answer, in the same modes.
#[test]
fn a_density_is_a_harmonic_answer_squared() {
    let density = |f: f64| -> f64 {
        let [[f0, g0], [f1, g1]] =
            if f < 100.0 { [[10.0, 0.02], [100.0, 0.05]] } else { [[100.0, 0.05], [400.0, 0.01]] };
        g0 * libm::pow(f / f0, libm::log(g1 / g0) / libm::log(f1 / f0))
    };
    let swings = "{ harmonic = { modes = 8, damping.ratio = 0.02, frequencies = [15.0, 31.0, 60.0, 240.0], base.acceleration = [0.5, 0.0, 2.0] } }";
    let noise = noisy(&[]);
    let relative = plate(&[("analysis", swings), UNLOADED, ACCELERATED]);
    let absolute = plate(&[
        ("analysis", swings),
        UNLOADED,
        ACCELERATED,
        ("analysis.harmonic.base.response", "absolute"),
    ]);
    let frequencies = column(&noise, "frequency");
    for name in COLUMNS {
        // Accelerations are those in space.
        let harmonic = column(if name == "a" { &absolute } else { &relative }, name);
        for ((&f, power), amplitude) in frequencies.iter().zip(column(&noise, name)).zip(harmonic) {
            let square = density(f) * amplitude * amplitude;
            assert!((power / square - 1.0).abs() < 1e-9, "{name} at {f}: {power} {square}");
        }
    }
    // Loads in step are as one.
    let loads = ("loads", "[{ on = \"here\", force = { total = [0.4, 0.2, 1.0] } }]");
    let source = "{ random-vibration = { modes = 8, damping.structural = 0.04, frequencies = [31.0], loads.density = [[10.0, 0.02], [100.0, 0.02]] } }";
    let driven = "{ harmonic = { modes = 8, damping.structural = 0.04, frequencies = [31.0] } }";
    let (noise, harmonic) = (plate(&[("analysis", source), loads]), plate(&[("analysis", driven), loads]));
    for name in &COLUMNS[..6] {
        let square = 0.02 * last(&harmonic, name).powi(2);
        assert!((last(&noise, name) / square - 1.0).abs() < 1e-9, "{name}");
    }
}

fn root_mean_square(outcome: &Outcome, name: &str) -> [f64; 2] {
    let noise = &outcome.summary.vibration.as_ref().unwrap().noise;
    let own = noise.iter().find(|own| own.column.name == name).unwrap();
    [own.root_mean_square, own.crossings.unwrap()]
}

/// The integral over all frequencies is that of the curve, whose 4001 points the trapezoidal rule adds: what it misses of a peak of 40 steps' width is a thousandth.
#[test]
fn root_mean_squares_are_integrals_of_densities() {
    let narrow = "[{ acceleration = [0.5, 0.0, 2.0], density = [[10.0, 0.02], [60.0, 0.05]] }]";
    let many = "{ from = 10.0, to = 60.0, points = 4001 }";
    let outcome =
        noisy(&[("analysis.random-vibration.base", narrow), ("analysis.random-vibration.frequencies", many)]);
    let (frequencies, omegas) = (column(&outcome, "frequency"), column(&outcome, "circular_frequency"));
    for name in COLUMNS {
        let density = column(&outcome, name);
        let integral = |of: &dyn Fn(usize) -> f64| -> f64 {
            (1..density.len())
                .map(|i| 0.5 * (frequencies[i] - frequencies[i - 1]) * (of(i) + of(i - 1)))
                .sum()
        };
        let square = integral(&|i| density[i]);
        let of_rate = integral(&|i| omegas[i] * omegas[i] * density[i]);
        let [root, crossings] = root_mean_square(&outcome, name);
        assert!((root / square.sqrt() - 1.0).abs() < 1e-5, "{name} {root} {}", square.sqrt());
        assert!((crossings * 2.0 * PI / (of_rate / square).sqrt() - 1.0).abs() < 1e-5, "{name}");
    }
}

/// Two bases that know nothing of each other add their powers; twice the noise in power is √2 in all roots of mean squares.
#[test]
fn powers_of_bases_add() {
    let of = |bases: &[&str]| {
        let list = format!("[{}]", bases.join(", "));
        noisy(&[("analysis.random-vibration.base", &list)])
    };
    let across = "{ acceleration = [0.0, 0.0, 2.0], density = [[10.0, 0.02], [400.0, 0.01]] }";
    let along = "{ acceleration = [0.0, 5.0, 0.0], density = [[20.0, 0.02], [90.0, 0.01]] }";
    let [one, other, both, twice] =
        [of(&[across]), of(&[along]), of(&[along, across]), of(&[across, across])];
    for name in COLUMNS {
        let [a, b, ab, aa] = [&one, &other, &both, &twice].map(|own| root_mean_square(own, name)[0]);
        assert!((ab / libm::hypot(a, b) - 1.0).abs() < 1e-9, "{name}");
        assert!((aa / a / 2.0_f64.sqrt() - 1.0).abs() < 1e-12, "{name}");
    }
}

/// Fields show what columns say: displacement and moments of the particles and points, none with a sign.
#[test]
fn shapes_are_as_far_as_columns_say() {
    let displaced = [
        ("curve", "[{ name = \"w\", of = \"displacement\", on = \"there\", direction = [0, 0, 1] }]"),
        ("loads", "[]"),
    ];
    let spectrum = plate(&[&[("analysis", FLAT)], &displaced[..]].concat());
    assert_eq!(spectrum.shapes.len(), 3);
    let noise = plate(&[&[("analysis", NOISE)], &displaced[..]].concat());
    assert_eq!(noise.shapes.len(), 1);
    for outcome in [&spectrum, &noise] {
        let last = outcome.shapes.last().unwrap();
        assert!(last.positions.iter().all(|place| place.z > -1e-12));
    }
}

/// The same plate in millimetres, kilonewtons and milliseconds.
#[test]
fn in_other_units_numbers_are_the_same() {
    let small = [
        ("units", "{ length = \"mm\", force = \"kN\", time = \"ms\" }"),
        ("geometry.plate.lengths", "[400.0, 300.0]"),
        ("material.elastic", "{ young = 70.0, poisson = 0.3, density = 2.7e-6 }"),
        ("section.homogeneous.thickness", "4.0"),
        ("sets.here.nearest", "[400.0, 0.0, 0.0]"),
        ("sets.there.nearest", "[300.0, 300.0, 0.0]"),
    ];
    let base = "[{ acceleration = [0.0, 0.0, 0.002], by = \"period\", amplitude = { table = [[10.0, 1.0], [100.0, 0.4]] } }]";
    let same = "[{ acceleration = [0.0, 0.0, 2.0], by = \"period\", amplitude = { table = [[0.01, 1.0], [0.1, 0.4]] } }]";
    let (ours, theirs) = (
        spectral(&[("analysis.response-spectrum.base", same)]),
        spectral(&[&small[..], &[("analysis.response-spectrum.base", base)]].concat()),
    );
    // Numbers of the new unit in one of the old.
    for (name, factor) in COLUMNS.into_iter().zip([1e3, 1.0, 1.0, 1e-3, 1.0, 1e-3, 1e-3]) {
        assert!((last(&theirs, name) / last(&ours, name) / factor - 1.0).abs() < 1e-8, "{name}");
    }
    let noise = "{ random-vibration = { modes = 8, damping.ratio = 0.02, frequencies = [0.031], \
        base = [{ acceleration = [0.0005, 0.0, 0.002], density = [[0.01, 20.0], [0.1, 50.0], [0.4, 10.0]] }] } }";
    let (ours, theirs) = (noisy(&[]), noisy(&[&small[..], &[("analysis", noise)]].concat()));
    for (name, factor) in COLUMNS.into_iter().zip([1e3, 1.0, 1.0, 1e-3, 1.0, 1e-3, 1e-3]) {
        let [a, b] = [&ours, &theirs].map(|own| root_mean_square(own, name));
        assert!((b[0] / a[0] / factor - 1.0).abs() < 1e-8, "{name} {a:?} {b:?}");
        assert!((b[1] / a[1] / 1e-3 - 1.0).abs() < 1e-8, "{name} {a:?} {b:?}");
    }
}

/// A plate drawn before it is shaken has the modes of the drawn plate.
#[test]
fn a_preload_is_held_while_the_ground_shakes() {
    let drawn = ("loads", "[{ on = \"u1\", force = { total = [20000.0, 0.0, 0.0] }, preload = true }]");
    let first = |outcome: &Outcome| outcome.summary.vibration.as_ref().unwrap().modes[0].frequency;
    let (free, held) = (spectral(&[]), spectral(&[drawn]));
    assert!(first(&held) > 1.2 * first(&free));
    let (modes, rest) = parts(&held, 3);
    assert!(((modes.iter().sum::<f64>() + rest) / (2.0 * MASS) - 1.0).abs() < 1e-3);
    assert!(last(&held, "w") < last(&free, "w"));
}

#[test]
fn solids_answer_as_well() {
    let text = r#"
title = "Block"
units = { length = "m", force = "N", time = "s" }
bodies.block.solid.geometry.block = { lengths = [0.4, 0.1, 0.1], spacing = 0.05 }
bodies.block.solid.material.elastic = { young = 1e9, poisson = 0.25, density = 1000.0 }
bodies.block.solid.formulation.galerkin = {}
supports = [{ on = "x0", clamped = {} }]
analysis.response-spectrum = { modes = 6, damping.ratio = 0.05, base = [{ acceleration = [0, 0, 3], by = "period", amplitude = { table = [[0, 1]] } }] }
curve = [{ name = "R", of = "reaction", on = "x0", direction = [0.0, 0.0, 1.0] }, { name = "a", of = "acceleration", on = "x1", direction = [0, 0, 1] }]
"#;
    let bonds = ("bodies.block.solid.formulation", "{ state-based = { horizon = 1.5 } }");
    for own in [vec![], vec![bonds]] {
        let outcome = crate::common::ran(crate::common::overridden(text, "block.toml", &own));
        assert_eq!(outcome.ended, coque::Ended::Done, "{}", outcome.summary.ended);
        let whole = |c: usize| {
            let (modes, rest) = parts(&outcome, c);
            modes.iter().sum::<f64>() + rest
        };
        assert!((whole(0) / (3.0 * 4.0) - 1.0).abs() < 1e-6, "{}", whole(0));
        assert!((whole(1) / 3.0 - 1.0).abs() < 1e-6, "{}", whole(1));
    }
}
