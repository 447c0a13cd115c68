//! Galerkin solids from scenes to results: a bar in closed form, forces in balance, fields, resumed runs, warnings.

#![allow(clippy::unwrap_used)] // a failed test may stop here

use crate::common::galerkin::{ARC, BAR};
use crate::common::{self, column, last};
use coque::{
    Checked, FieldError, FieldSink, Frame, Part, Ready, RunOptions, Scene, Sheet, Silent, StateArray,
    Warning, WarningKind,
};

fn scene(text: &str, replaced: &[(&str, &str)]) -> Checked {
    let pairs: Vec<_> = replaced.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    Scene::with_overrides(text, "galerkin.toml", &pairs).unwrap()
}

/// A bar between mirror planes, pulled by so little that it stays linear: σ = p, ε = p/E, the sides come in by ν ε.
#[test]
fn a_pulled_bar_is_stretched_as_hooke_has_it() {
    let planes = "[{ on = 'x0', symmetry = { normal = [1, 0, 0] } }, { on = 'y0', symmetry = { normal = [0, 1, 0] } }, \
                  { on = 'z0', symmetry = { normal = [0, 0, 1] } }]";
    let columns = "[{ name = 'u', of = 'displacement', on = 'x1', direction = [1, 0, 0] }, \
                   { name = 'v', of = 'displacement', on = 'y1', direction = [0, -1, 0] }, \
                   { name = 'R', of = 'reaction', on = 'x0', direction = [1, 0, 0] }]";
    let found = scene(BAR, &[("supports", planes), ("curve", columns), ("analysis", "{ linear = {} }")]);
    let outcome = found.build(1).unwrap().run(&mut Silent);
    let [u, v, r] = ["u", "v", "R"].map(|name| last(&outcome, name));
    // An affine field is in the space of displacements, but Gauss's rule does not integrate its shape functions exactly: .18 and .32 %
    // were measured.
    assert!((u / 2e-3 - 1.0).abs() < 6e-3 && (v / 3e-4 - 1.0).abs() < 1e-2, "{u} {v}");
    assert!((r + 1e-3).abs() < 1e-9, "{r}");
}

/// Supports bear what loads bring, each set its part, where a pressure follows the deformed face.
#[test]
fn supports_bear_the_loads() {
    let columns = "[{ name = 'R', of = 'reaction', on = 'x0', direction = [0, 0, 1] }, \
                   { name = 'all', of = 'reaction', on = 'all', direction = [0, 0, 1] }, \
                   { name = 'w', of = 'displacement', on = 'x1', direction = [0, 0, 1] }]";
    let loads = "[{ on = 'z0', traction = { value = [0, 0, 1e-3] } }, { on = 'all', gravity = { acceleration = [0, 0, -4e-4] } }, \
                 { on = 'x1', force = { total = [0, 0, 1e-4] } }]";
    let outcome = scene(BAR, &[("loads", loads), ("curve", columns)]).build(1).unwrap().run(&mut Silent);
    let (borne, applied) = (last(&outcome, "R"), 2e-3 - 8e-4 + 1e-4);
    assert!((borne + applied).abs() < 1e-8 * applied, "{borne}");
    assert_eq!(borne, last(&outcome, "all"));
    // The half of a face that is named presses half as much.
    let half = "{ box = { min = [0, 0, 1], max = [1, 1, 1] } }";
    let pressed = |on: &str| {
        let load = format!("[{{ on = '{on}', pressure = {{ value = 1e-6, follower = true }} }}]");
        let found = scene(BAR, &[("sets.half", half), ("loads", &load), ("curve", columns)]);
        last(&found.build(1).unwrap().run(&mut Silent), "R")
    };
    let ratio = pressed("half") / pressed("z1");
    assert!((ratio - 0.5).abs() < 1e-4 && pressed("z1") > 0.0, "{ratio}");
}

/// The force that a motion of one node takes is the reaction of the node, and the level.
#[test]
fn the_force_that_is_sought_is_the_reaction() {
    let supports =
        "[{ on = 'x0', clamped = {} }, { on = 'tip', moved = { direction = [0, 0, -1], by = 0.3 } }]";
    let columns = "[{ name = 'P', of = 'reaction', on = 'tip', direction = [0, 0, -1] }, \
                   { name = 'R', of = 'reaction', on = 'x0', direction = [0, 0, 1] }, \
                   { name = 'w', of = 'displacement', on = 'tip', direction = [0, 0, -1] }]";
    let set = [
        ("sets.tip", "{ nearest = [2, 0.5, 0.5] }"),
        ("supports", supports),
        ("loads", "[]"),
        ("curve", columns),
        ("analysis.static.levels", "[0.5, 1.0]"),
    ];
    let outcome = scene(BAR, &set).build(1).unwrap().run(&mut Silent);
    let [p, r, w] = ["P", "R", "w"].map(|name| last(&outcome, name));
    assert!((w - 0.3).abs() < 1e-12 && p > 0.0 && (p / r - 1.0).abs() < 1e-7, "{p} {r} {w}");
}

/// Keeps every frame in memory, nodes and quadrature points.
#[derive(Default)]
struct Kept(Vec<[Sheet; 2]>);

impl FieldSink for Kept {
    fn frame(&mut self, frame: &Frame<'_>) -> Result<(), FieldError> {
        let fields = frame.evaluate(true);
        let mut sheets = <[Sheet; 2]>::default();
        for (part, sheet) in [Part::Surface, Part::Points].into_iter().zip(&mut sheets) {
            fields
                .write(part, sheet)
                .map_err(|error| FieldError { path: "memory".into(), reason: error.to_string() })?;
        }
        self.0.push(sheets);
        Ok(())
    }
}

/// Fields at nodes and at quadrature points; stress in uniform tension is the traction everywhere.
#[test]
fn fields_show_stress_strain_and_angle() {
    let planes = "[{ on = 'x0', symmetry = { normal = [1, 0, 0] } }, { on = 'y0', symmetry = { normal = [0, 1, 0] } }, \
                  { on = 'z0', symmetry = { normal = [0, 0, 1] } }]";
    for analysis in ["{ linear = {} }", "{ static = { levels = 1 } }"] {
        let set = [
            ("supports", planes),
            ("analysis", analysis),
            ("output.fields", "{ points = true, stresses = true }"),
        ];
        let mut kept = Kept::default();
        let run =
            RunOptions { progress: &mut Silent, checkpoints: None, fields: Some(&mut kept), from: None };
        scene(BAR, &set).build(1).unwrap().run_with(run).unwrap();
        let [nodes, points] = kept.0.last().unwrap();
        assert_eq!((nodes.cells.len(), nodes.points.len(), nodes.cells[0].len()), (16, 45, 8));
        assert_eq!((points.cells.len(), points.points.len()), (16 * 27, 16 * 27));
        let stress = &nodes.point_data["stress"];
        let off = |row: &[f64]| f64::max((row[0] - 1e-3).abs(), row[1].abs()) / 1e-3;
        let (worst, mean) = stress
            .numbers
            .chunks_exact(6)
            .map(off)
            .fold((0.0, 0.0), |(worst, sum): (f64, f64), off| (worst.max(off), sum + off / 45.0));
        // what the quadrature leaves, on so few cells drawn out to corners
        assert!(worst < 0.2 && mean < 0.1, "{worst} {mean}");
        assert!(nodes.point_data.contains_key("reaction") && nodes.point_data.contains_key("von_mises"));
        assert_eq!(points.point_data["displacement"].numbers.len(), 3 * points.points.len());
        assert_eq!(nodes.point_data["rotation_angle"].numbers.len(), 45);
        assert_eq!(points.point_data.contains_key("stress"), analysis.contains("static"));
    }
}

/// An arc of orthotropic axes builds, bears its load, and is as wide as it says.
#[test]
fn an_arc_lies_where_its_angles_say() {
    let set = [("curve", "[{ name = 'u', of = 'displacement', on = 'x1', direction = [1, 0, 0] }]")];
    let model = scene(ARC, &set).build(1).unwrap();
    let rest = model.body.body().configuration().rest.to_vec();
    let outer = rest.iter().map(|x| (x.x * x.x + x.z * x.z).sqrt()).fold(0.0, f64::max);
    let inner = rest.iter().map(|x| (x.x * x.x + x.z * x.z).sqrt()).fold(9.0, f64::min);
    assert!((outer - 2.5).abs() < 1e-12 && (inner - 1.5).abs() < 1e-12);
    assert!(last(&model.run(&mut Silent), "u") > 0.0);
}

/// A body takes up the state of another, history included, and goes on to the same bits.
#[test]
fn states_are_taken_up_with_their_history() {
    let build = || {
        let model = scene(
            BAR,
            &[("analysis.static.levels", "[1.0, 2.0]"), ("loads.0.traction.value", "[0, 0, 1e-3]")],
        );
        model.build(1).unwrap()
    };
    let outcome = build().run(&mut Silent);
    assert_eq!(column(&outcome, "u").len(), 3);
    let (mut one, mut other) = (build(), build());
    let owned: Vec<StateArray<'static>> = one
        .body
        .body()
        .state()
        .iter()
        .map(|array| {
            let numbers = array
                .numbers
                .iter()
                .enumerate()
                .map(|(i, x)| if (60..70).contains(&i) { x + 1e-3 } else { *x });
            StateArray { name: array.name.to_string().into(), numbers: numbers.collect::<Vec<_>>().into() }
        })
        .collect();
    other.body.body_mut().set_state(&owned).unwrap();
    assert!(other.body.body().state() == owned);
    assert!(one.body.body_mut().set_state(&[]).is_err());
    let Ready::Static(body) = &mut other.body else { panic!("a static body") };
    assert!(body.refresh(0.0) > 0.0);
}

/// What is doubtful is reported: supports that leak, bases that lock, strains beyond the law.
#[test]
fn warned_are_reported() {
    let warned = |set: &[(&str, &str)]| {
        let outcome = scene(BAR, set).build(1).unwrap().run(&mut Silent);
        outcome.summary.record.warnings.iter().map(|warning| warning.kind).collect::<Vec<_>>()
    };
    let formulation = "bodies.bar.solid.formulation.galerkin";
    assert_eq!(warned(&[]), []);
    assert_eq!(warned(&[(&format!("{formulation}.essential"), "'direct'")]), [WarningKind::LeakySupport]);
    let thin =
        ("bodies.bar.solid.geometry.block", "{ lengths = [2.0, 1.0, 0.02], spacing = [0.5, 0.5, 0.01] }");
    assert_eq!(warned(&[thin]), [WarningKind::ShearLocking]);
    let plate = (formulation, "{ basis = 'plate17' }");
    assert_eq!(
        warned(&[
            plate,
            (
                "bodies.bar.solid.geometry.block",
                "{ lengths = [2.0, 1.0, 0.02], spacing = [0.25, 0.25, 0.01] }"
            )
        ]),
        []
    );
    let pulled = [("loads.0.traction.value", "[0.3, 0, 0]"), ("analysis.static.levels", "4")];
    assert_eq!(warned(&pulled), [WarningKind::LargeStrain]);
    // Four cells along a bar that is pulled are as good as any; bent, it is 5 % stiff.
    let bent = ("loads.0.traction.value", "[0, 0, 1e-6]");
    assert_eq!(warned(&[bent]), [WarningKind::FewParticles]);
    assert_eq!(warned(&[bent, ("bodies.bar.solid.geometry.block.spacing", "0.25")]), []);
}

/// Levels of these bodies are linearised in fixed directions: a bar that bends by a fifth of its width "buckles" aside, and a slender
/// one that is pushed buckles as Euler's.
#[test]
fn a_level_far_along_the_bend_is_doubtful() {
    let found = |length: &str, load: &str| {
        let load = format!("[{{ on = 'x1', traction = {{ value = {load} }} }}]");
        let buckling = "{ buckling = { modes = 1, sign = 'either' } }";
        let lengths = ("bodies.bar.solid.geometry.block.lengths", length);
        let found = scene(BAR, &[lengths, ("loads", &load), ("analysis", buckling), ("curve", "[]")]);
        let outcome = found.build(1).unwrap().run(&mut Silent);
        let warned_of = |warning: &Warning| warning.kind == WarningKind::ChangedShape;
        (last(&outcome, "level"), outcome.summary.record.warnings.iter().any(warned_of))
    };
    assert!(found("[2, 1, 1]", "[0, 0, -0.001]").1);
    let (level, warned_of) = found("[8, 1, 1]", "[-0.001, 0, 0]");
    let euler = std::f64::consts::PI.powi(2) / 12.0 / 256.0 / 1e-3;
    assert!(!warned_of && (level / euler - 1.0).abs() < 0.1, "{level} of {euler}");
}

/// One solve a step on the source's cantilever: its figures with the source's basis, 20 and 100 steps to K = 10; every level tells how far
/// off it is, and short steps tell the truth.
#[test]
fn one_solve_a_step_tells_how_far_off_it_is() {
    let cantilever = common::text("cantilever-solid.toml");
    let run = |levels: &str, more: &[(&str, &str)]| {
        let source = ("bodies.beam.solid.formulation.galerkin", "{ basis = 'linear', support.sphere = 2.5 }");
        let set = [&[source, ("analysis.static.levels", levels)], more].concat();
        scene(&cantilever, &set).build(1).unwrap().run(&mut Silent)
    };
    let one = [("analysis.static.one_solve", "true")];
    let exact = last(&run("[1.0]", &[]), "w");
    let steps = |count: usize| {
        let levels: Vec<f64> = (1..=count).map(|step| step as f64 / count as f64).collect();
        run(&format!("{levels:?}"), &one)
    };
    let (coarse, fine) = (steps(2), steps(10));
    // Figures of the prototype, of four digits.
    assert!((last(&coarse, "w") - 0.0779).abs() < 1e-4 && (last(&fine, "w") - 0.1233).abs() < 1e-4);
    for (outcome, bound) in [(&coarse, 0.25), (&fine, 0.02)] {
        let (w, reported) = (last(outcome, "w"), last(outcome, "remaining_displacement"));
        let ratio = reported / (exact / w - 1.0).abs();
        assert!((ratio - 1.0).abs() < bound, "{reported} reported of {w} for {exact}");
        let worst = column(outcome, "remaining_displacement").into_iter().fold(0.0, f64::max);
        let levels = &outcome.summary.record.levels;
        assert_eq!(levels.iter().map(|level| level.remaining_displacement).fold(0.0, f64::max), worst);
        assert!(levels.iter().all(|level| level.settled == (level.remaining_displacement <= 0.01)));
        let warned: Vec<_> = outcome.summary.record.warnings.iter().map(|warning| warning.kind).collect();
        assert_eq!(warned, [WarningKind::NotSettled], "{worst}");
        assert!(outcome.summary.record.falls_short().is_some());
    }
    assert_eq!(coarse.summary.record.factorisations, 3);
    // Under a load that hardly bends the beam one solve is the answer.
    let straight = run("[1e-6]", &one);
    assert!(straight.summary.record.warnings.is_empty() && last(&straight, "remaining_displacement") < 1e-3);
}

/// What breaks does so in states of balance.
#[test]
fn one_solve_a_step_is_refused_where_bonds_break() {
    let bonds = [
        ("bodies.bar.solid.formulation", "{ bond-based = { horizon = 2.015 } }"),
        ("bodies.bar.solid.geometry.block.spacing", "0.25"),
        ("bodies.bar.solid.material.elastic.poisson", "0.25"),
        ("bodies.bar.solid.fracture", "{ energy = 1.0 }"),
        ("analysis.static.one_solve", "true"),
    ];
    let pairs: Vec<_> = bonds.iter().map(|(path, value)| (path.to_string(), value.to_string())).collect();
    let refused = Scene::with_overrides(BAR, "galerkin.toml", &pairs).err().unwrap().to_string();
    assert!(refused.contains("analysis.static.one_solve") && refused.contains("fracture"), "{refused}");
}
