//! What a run was and what it cost, for people and programs (`summary.json`).

use serde::{Deserialize, Serialize};

use crate::Warning;
use crate::analyses::criticality::place;
use crate::analyses::stability;
use crate::bodies::shell::build::Model;
use crate::scene::{Analysis, Axis, Damping, Layered, LoadKind, Ply, Section};

/// What a model holds and what it leaves out.
#[derive(Clone, Debug, Serialize)]
pub struct Modelled {
    /// What is modelled, one line each.
    pub modelled: Vec<String>,
    /// What is not, one line each.
    pub left_out: Vec<String>,
    /// Particles.
    pub particles: usize,
    /// Points at which strains are sampled.
    pub points: usize,
    /// DofMap that no support holds.
    pub freedoms: usize,
    /// Memory that the step touches, per particle \[bytes\].
    pub bytes_per_particle: f64,
}

/// Energies at the last record \[F L\].
#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
pub struct Energies {
    /// Kinetic.
    pub kinetic: f64,
    /// Internal.
    pub internal: f64,
    /// Work of loads and prescribed motions.
    pub external: f64,
    /// Taken by damping.
    pub dissipated: f64,
    /// What is missing from the balance.
    pub balance_error: f64,
}

/// How a load level ended.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct LevelSummary {
    /// Load level.
    pub level: f64,
    /// Whether the motion died within the hold.
    pub settled: bool,
    /// Kinetic over internal energy at the end of the hold.
    pub kinetic_over_internal: f64,
    /// Force out of balance over load at the end of the hold; zero without time.
    pub out_of_balance: f64,
    /// Way left to the equilibrium over displacement at the end of the hold; zero without time.
    pub way_left: f64,
    /// Negative pivots of the tangent: the directions in which the state is unstable; absent where it was not looked at.
    pub negative_pivots: Option<usize>,
    /// Steps spent on the level.
    pub steps: u64,
}

/// A singular tangent met on a path of equilibria.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CriticalSummary {
    /// "limit point" or "bifurcation"; "turning point", "change of branch", "critical points, not located" or "doubtful
    /// step" where a warning says more.
    pub kind: String,
    /// Load level; with a `moved` support the force along the motion.
    pub level: f64,
    /// Unit of the level where it is a force.
    pub unit: Option<String>,
    /// Levels between which it lies, where it was not located.
    pub between: Option<[f64; 2]>,
}

impl CriticalSummary {
    /// Where it lies: `load level 0.5`, or `a force of 127.4 N`.
    pub fn place(&self) -> String {
        place(self.level, self.unit.as_deref())
    }
}

/// How many modes there are, counted by the signs of pivots (Sylvester's law): as many as were found, none missing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CountSummary {
    /// Lower end of the interval: a level, or a circular frequency squared \[1/T²\]; none where nothing lies below.
    pub from: Option<f64>,
    /// Its upper end.
    pub to: f64,
    /// Modes between the two; those wanted are the nearest to zero of them.
    pub number: usize,
    /// Factorisations that the modes took.
    pub factorisations: usize,
    /// Solves that they took.
    pub solves: usize,
}

/// What a run was and what it cost.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// Title of the scene.
    pub title: String,
    /// Values of the scene that the command line replaced, as `path=value`.
    pub replaced: Vec<String>,
    /// Analysis, as the scene calls it.
    pub analysis: String,
    /// Formulation with its options.
    pub method: String,
    /// Particles.
    pub particles: usize,
    /// Points at which strains are sampled.
    pub points: usize,
    /// DofMap that no support holds.
    pub dof: usize,
    /// Mean spacing of the particles \[L\].
    pub spacing: f64,
    /// Steps done; without time the points found.
    pub steps: u64,
    /// Newton iterations of all points found; zero in time.
    pub newton_iterations: u64,
    /// Critical points found on a path without time.
    pub critical: Vec<CriticalSummary>,
    /// Threads used.
    pub threads: usize,
    /// Greatest stable step of the reference configuration \[T\]; zero if none was found, or without time.
    pub stable_step: f64,
    /// Fraction of the stable step that was used; zero without time.
    pub safety: f64,
    /// Time the run took, over all its sittings \[s\].
    pub wall_seconds: f64,
    /// Particles times steps per second of the march \[1/s\]; zero without time.
    pub particle_steps_per_second: f64,
    /// Energies at the last record.
    pub energies: Energies,
    /// How each load level ended; empty without levels.
    pub levels: Vec<LevelSummary>,
    /// What may be wrong with the numbers above, and why.
    pub warnings: Vec<Warning>,
    /// The count of modes; none for other analyses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub counted: Option<CountSummary>,
    /// Frames of fields written; zero without `output.fields`.
    pub frames: u64,
    /// What is modelled.
    pub modelled: Vec<String>,
    /// What is not.
    pub left_out: Vec<String>,
    /// "done", or why the run ended early.
    pub ended: String,
}

impl Summary {
    /// Load levels that were left before the motion had died.
    pub fn not_settled(&self) -> Vec<f64> {
        self.levels.iter().filter(|level| !level.settled).map(|level| level.level).collect()
    }
}

impl Model {
    /// What the model holds and what it leaves out.
    pub fn describe(&self) -> Modelled {
        let (modelled, left_out) = self.lists();
        Modelled {
            modelled,
            left_out,
            particles: self.shell.len(),
            points: self.shell.reference().operator.points.len(),
            freedoms: self.shell.freedoms(),
            bytes_per_particle: self.shell.bytes_per_particle(),
        }
    }

    fn lists(&self) -> (Vec<String>, Vec<String>) {
        let scene = &self.scene;
        let mut modelled = vec![
            format!("one director a particle, finite rotations, {}", scene.shell().formulation.describe()),
            format!(
                "strains: Green-Lagrange membrane, {} curvature, shear",
                scene.shell().formulation.curvature()
            ),
        ];
        modelled.extend(self.surface.as_ref().map(|surface| surface.line.clone()));
        let mut left_out: Vec<String> =
            ["plasticity", "contact", "fracture", "change of thickness"].map(String::from).into();
        match &scene.shell().section {
            Section::Homogeneous(section) => modelled.push(match section.gauss_points {
                None => "isotropic elasticity, integrated through the thickness in closed form".into(),
                Some(points) => format!("isotropic elasticity, {points} Gauss points through the thickness"),
            }),
            Section::Layered(section) => {
                modelled.push(describe_plies(section));
                let missing = ["delamination", "change of transverse shear strain from ply to ply"];
                left_out.extend(missing.map(String::from));
            }
        }
        for support in &scene.supports {
            modelled.extend(support.kinds().iter().map(|(word, _)| format!("{word} on {}", support.on)));
        }
        for load in &scene.loads {
            modelled.extend(
                load.kinds()
                    .iter()
                    .map(|(word, kind)| format!("{} on {}", describe_load(word, kind), load.on)),
            );
        }
        modelled.extend(scene.shell().velocity.map(|_| "velocity at the start".into()));
        if scene.loads.is_empty() {
            left_out.push("loads".into());
        }
        if scene.output.fields.is_some_and(|fields| fields.stresses) {
            if scene.analysis.kind().gives_modes {
                left_out.push("stresses of modes, which have a shape but no size".into());
            } else if !scene.shell().section.homogeneous() {
                left_out.push("stresses of the plies: the fields hold resultants".into());
            }
        }
        let Analysis::Explicit(explicit) = &scene.analysis else {
            let damping = ["damping".to_string()];
            let inertia = (!matches!(scene.analysis, Analysis::Modal(_))).then(|| "inertia".to_string());
            left_out.extend(inertia.into_iter().chain(damping));
            if matches!(scene.analysis, Analysis::Linear(_)) {
                left_out.push("large displacements".into());
            }
            return (modelled, left_out);
        };
        let damping = match (&explicit.quasi_static, &explicit.transient) {
            (Some(path), _) => match path.damping {
                Damping::Ratio(ratio) => Some(format!("mass-proportional damping, ratio {ratio}")),
                Damping::Kinetic => Some("kinetic damping".into()),
            },
            (None, Some(run)) if run.damping > 0.0 => {
                Some(format!("mass-proportional damping, {} per unit of time", run.damping))
            }
            _ => None,
        };
        left_out.extend(stability::left_out(scene, &[]));
        match damping {
            Some(damping) => modelled.push(damping),
            None => left_out.push("damping".into()),
        }
        (modelled, left_out)
    }
}

/// Angles from the lowest ply to the highest, and the thickness of each where they differ.
fn describe_plies(section: &Layered) -> String {
    let list = |of: fn(&Ply) -> f64| section.plies.iter().map(|p| of(p).to_string()).collect::<Vec<_>>();
    let angles = list(|ply| ply.angle).join("/");
    let mut thicknesses = list(|ply| ply.thickness);
    thicknesses.dedup();
    let [x, y, z] = section.axis;
    format!(
        "orthotropic elasticity, plies at {angles} degrees from [{x}, {y}, {z}], thickness {}: classical lamination, \
         transverse shear as 5/6 of the sum over the plies",
        thicknesses.join("/")
    )
}

fn describe_load(word: &str, kind: &LoadKind) -> String {
    match kind {
        LoadKind::Couple(couple) if couple.axis == Axis::Edge => "couple about the moving edge".into(),
        LoadKind::Pressure(pressure) if pressure.follower => "follower pressure".into(),
        _ => word.into(),
    }
}
