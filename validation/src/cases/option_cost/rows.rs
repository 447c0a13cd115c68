//! What is measured: a bare scene, the same without a scene, and every option added to it alone.

/// Name of the row without a scene: the layers below, called directly.
pub const WITHOUT: &str = "no scene, the layers below coque";
/// Name of the row that every option is added to.
pub const BARE: &str = "bare scene";
/// Name of the row that measures the bare scene again.
pub const AGAIN: &str = "bare scene, once more";
/// Name of the row that quasi-static options are added to: they want every rigid motion held.
pub const CLAMPED: &str = "one edge clamped";

/// The bare scene; its plate and material are those of [`super::measurement::shell_without_scene`].
pub const SCENE: &str = r#"
title = "A free plate in motion"
units = { length = "m", force = "N", time = "s" }
geometry.plate = { lengths = [1.0, 1.0], particles = [50, 50] }
material.elastic = { young = 1e6, poisson = 0.3, density = 1.0 }
section.homogeneous = { thickness = 0.01 }
analysis.explicit.transient = { duration = 1.0, record_every = 1.0 }
"#;

/// Steps between two rows of the curve, where an option records them often.
const OFTEN: u64 = 20;

/// One scene of the table.
#[derive(Clone, Debug)]
pub struct Row {
    /// Name, unique.
    pub name: &'static str,
    /// What the scene says beyond the bare one, or what the row is.
    pub about: &'static str,
    /// Name of the row it is an increment of.
    pub over: &'static str,
    /// Values replaced in the bare scene.
    pub set: Vec<(String, String)>,
    /// Threads.
    pub threads: usize,
    /// Whether a step costs so much that a quarter of the steps and two rounds do.
    pub expensive: bool,
}

/// The lattice and the pace of all scenes.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    /// Particles along an edge.
    pub side: usize,
    /// Step of the bare scene \[s\].
    pub dt: f64,
    /// Steps between two frames of fields.
    pub frame: u64,
}

impl Pace {
    /// Names of rows do not depend on it.
    pub const ANY: Self = Self { side: 2, dt: 1.0, frame: 1 };
}

impl Row {
    fn new(name: &'static str, about: &'static str) -> Self {
        Self { name, about, over: BARE, set: Vec::new(), threads: 1, expensive: false }
    }

    fn set(mut self, path: &str, value: impl ToString) -> Self {
        self.set.push((path.into(), value.to_string()));
        self
    }

    fn over(mut self, name: &'static str) -> Self {
        self.over = name;
        self
    }

    /// Records after every `steps` steps, and half a step less, so that rounding adds none.
    fn recorded(self, steps: u64, dt: f64) -> Self {
        let every = (steps as f64 - 0.5) * dt;
        self.set("analysis.explicit.transient.record_every", format!("{every:e}"))
    }

    fn loaded(self, load: &str) -> Self {
        self.set("loads", format!("[{{ {load} }}]"))
    }

    fn supported(self, support: &str) -> Self {
        self.set("supports", format!("[{{ {support} }}]"))
    }

    /// In a hold of a quasi-static run, which is looked at every 200 steps and never comes to rest.
    fn holding(self, dt: f64, damping: &str) -> Self {
        let period = 4000.0 * dt;
        let path = format!(
            "{{ levels = [1.0], period = {period:e}, ramp = 1e-6, hold = 1e6, tolerance = 1e-300, damping = {damping} }}"
        );
        self.supported("on = \"u0\", clamped = {}")
            .set("analysis", format!("{{ explicit = {{ quasi-static = {path} }} }}"))
            .over(CLAMPED)
    }

    fn expensive(mut self) -> Self {
        self.expensive = true;
        self
    }
}

/// Every row, in the order of the table.
pub fn rows(pace: Pace) -> Vec<Row> {
    let Pace { side, dt, frame } = pace;
    let spacing = 1.0 / (side as f64 - 1.0);
    let mut rows = vec![
        Row::new(WITHOUT, "no code of coque, and so of its options, is reached"),
        Row::new(BARE, "a free elastic plate in motion"),
        Row::new(AGAIN, "what the machine adds by itself"),
    ];
    rows.extend(through_the_thickness());
    rows.extend(conditions());
    rows.extend(damping(dt));
    rows.extend(output(dt, frame));
    rows.extend(clouds(spacing));
    rows.push(Row { threads: 2, ..Row::new("a second thread", "processor time of both") });
    rows.extend(formulations());
    let lattice = ("geometry.plate.particles".to_owned(), format!("[{side}, {side}]"));
    for row in &mut rows {
        // The scattered cloud has no lattice.
        if !row.set.iter().any(|(path, _)| path == "geometry") {
            row.set.insert(0, lattice.clone());
        }
    }
    rows
}

#[rustfmt::skip] // one line a row, as far as it goes
fn through_the_thickness() -> Vec<Row> {
    let plies = "{ axis = [1.0, 0.0, 0.0], plies = [{ thickness = 0.0033, angle = 0.0 }, \
                 { thickness = 0.0034, angle = 90.0 }, { thickness = 0.0033, angle = 0.0 }] }";
    let orthotropic = "{ young_along = 1e6, young_across = 5e5, poisson = 0.3, shear = 3e5, density = 1.0 }";
    vec![
        Row::new("three Gauss points through the thickness", "in place of the closed form")
            .set("section.homogeneous.gauss_points", 3),
        Row::new("three plies", "an orthotropic section 0/90/0")
            .set("material", format!("{{ orthotropic = {orthotropic} }}"))
            .set("section", format!("{{ layered = {plies} }}")),
    ]
}

#[rustfmt::skip] // one line a row, as far as it goes
fn conditions() -> Vec<Row> {
    let pressure = |follower: bool| format!("on = \"all\", pressure = {{ value = 1.0, follower = {follower} }}");
    vec![
        Row::new("dead force", "on one edge").loaded("on = \"u1\", force = { total = [0.0, 0.0, 1.0] }"),
        Row::new("dead pressure", "on all particles").loaded(&pressure(false)),
        Row::new("follower pressure", "on all particles").loaded(&pressure(true)),
        Row::new("couple", "on one edge, about the moving edge").loaded("on = \"u1\", couple = { moment = 1e-3, axis = \"edge\" }"),
        Row::new(CLAMPED, "positions and directors held").supported("on = \"u0\", clamped = {}"),
        Row::new("one edge held", "one displacement, one turn of the director")
            .supported("on = \"u0\", held = { displacement = [[0.0, 0.0, 1.0]], director = [[0.0, 1.0, 0.0]] }"),
        Row::new("one edge moved", "a prescribed motion, sine in time")
            .supported("on = \"u0\", moved = { direction = [0.0, 0.0, 1.0], by = 1e-4 }, amplitude = { sine = { period = 0.1 } }"),
    ]
}

fn damping(dt: f64) -> Vec<Row> {
    vec![
        Row::new("mass damping", "in real time")
            .set("analysis.explicit.transient.damping", format!("{:e}", 1e-3 / dt)),
        Row::new("quasi-static, mass damping", "a hold, beside one edge clamped")
            .holding(dt, "{ ratio = 1.0 }"),
        Row::new("quasi-static, kinetic damping", "the same hold, beside one edge clamped")
            .holding(dt, "\"kinetic\""),
    ]
}

fn output(dt: f64, frame: u64) -> Vec<Row> {
    let fields = |what: &str| format!("{{ {what} }}");
    let probe = "[{ name = \"w\", of = \"displacement\", on = \"u1\", direction = [0.0, 0.0, 1.0] }]";
    vec![
        Row::new("row of the curve every 20 steps", "energy balance and a probe on one edge")
            .recorded(OFTEN, dt)
            .set("curve", probe),
        Row::new("energy balance at every step", "a row of the curve each step").recorded(1, dt),
        Row::new("fields: motion", "a frame every 200 steps, into files")
            .recorded(frame, dt)
            .set("output.fields", fields("every = 1")),
        Row::new("fields: with stresses", "the same with strains and resultants")
            .recorded(frame, dt)
            .set("output.fields", fields("stresses = true")),
        Row::new("fields: extruded as well", "the same with the extruded shell")
            .recorded(frame, dt)
            .set("output.fields", fields("stresses = true, extruded = true")),
        Row::new("checkpoints", "every minute; what a step costs is the question whether one is due")
            .set("output.checkpoint_every", 60.0),
    ]
}

#[rustfmt::skip] // one line a row, as far as it goes
fn clouds(spacing: f64) -> Vec<Row> {
    let scattered = format!("{{ plate = {{ lengths = [1.0, 1.0], scattered = {{ spacing = {spacing:e}, seed = 1 }} }} }}");
    vec![
        Row::new("lattice stretched", "spacings growing to three times")
            .set("geometry.plate.grading", "[3.0, 3.0]"),
        Row::new("lattice jittered", "by a quarter of the spacing")
            .set("geometry.plate.disorder", "{ fraction = 0.25, seed = 1 }"),
        Row::new("scattered cloud", "cells from triangles in pairs")
            .set("geometry", scattered),
    ]
}

#[rustfmt::skip] // one line a row
fn formulations() -> Vec<Row> {
    vec![
        Row::new("wide support", "stress points with a corrected kernel, support 1.4").set("formulation.stress-point.support", 1.4).expensive(),
        Row::new("nodal", "order 1").set("formulation.nodal.order", 1).expensive(),
        Row::new("strong form", "the paper's equations").set("formulation.strong-form.smoothing", 1.2).expensive(),
    ]
}
