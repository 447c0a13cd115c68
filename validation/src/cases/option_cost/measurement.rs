//! One measurement: a row of the table is built, marched, and timed between two of its steps.

use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use coque::{
    Checked, Checkpoints, FieldFiles, FieldSink, Model, Origin, Rendering, RunOptions, Scene, SceneError,
    render,
};
use explicit_dynamics::{Dynamics, Event, March, Transient};
use nalgebra::Rotation3;
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{EndWeights, Plate, Vec3, lattice};
use sph_shell::{Formulation, Parts, Reach, Shell};

use super::rows::{Row, SCENE, WITHOUT};
use crate::support::stopwatch::{Look, Stopwatch};

/// Steps before the first look at the clock: by then caches are filled, the first frame and checkpoint written.
const WARM: u64 = 20;
/// Fraction of the stable step, the default of scenes.
const SAFETY: f64 = 0.8;
/// Length of all transient runs \[s\], beyond whatever is marched.
const DURATION: f64 = 1.0;

/// What one measurement measured.
#[derive(Clone, Copy, Debug)]
pub struct Measurement {
    /// What was marched.
    pub body: Body,
    /// Steps timed.
    pub steps: u64,
    /// Processor time of the whole process over these steps.
    pub processor: Duration,
    /// Their wall time.
    pub wall: Duration,
    /// Memory the run holds between two steps, as the allocator counts it \[bytes\]; none where nobody counts.
    pub held: Option<f64>,
    /// Allocations over the steps timed; none where nobody counts.
    pub allocations: Option<usize>,
}

/// What a row marches.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    /// Particles.
    pub particles: usize,
    /// Mean spacing \[m\].
    pub spacing: f64,
    /// Degrees of freedom that no support holds.
    pub dof: usize,
    /// Memory that a step touches, as the shell counts it \[bytes a particle\].
    pub step_bytes: f64,
}

impl Body {
    fn of(shell: &Shell) -> Self {
        let spacing = shell.reference().cloud.spacing();
        let step_bytes = shell.bytes_per_particle();
        Self { particles: shell.len(), spacing, dof: shell.dof(), step_bytes }
    }
}

/// Marches a row on a lattice of `side × side` particles and times `steps` steps of it.
///
/// # Errors
/// Why it could not be run, in words.
pub fn measure_row(row: &Row, side: usize, steps: u64) -> Result<Measurement, String> {
    let before = Look::now();
    let mut watch = Stopwatch::new(WARM, steps);
    let body = if row.name == WITHOUT {
        let mut shell = shell_without_scene(side)?;
        stir(&mut shell);
        let run = Transient { duration: DURATION, record_every: DURATION, damping: 0.0, safety: SAFETY };
        let mut march = March::start(run, &mut shell).map_err(|error| error.to_string())?;
        loop {
            let event = march.advance(&mut shell).map_err(|error| error.to_string())?;
            if event == Event::End || watch.between(march.clock().steps).is_break() {
                break;
            }
        }
        Body::of(&shell)
    } else {
        let mut shell = shell(row)?;
        stir(&mut shell);
        let body = Body::of(&shell);
        let mut model = model(row)?;
        let moving = coque::Body::state(&shell);
        model.body.body_mut().set_state(&moving).map_err(|error| error.to_string())?;
        drop(shell);
        run(model, row, &mut watch)?;
        body
    };
    let Some([start, end]) = watch.looks() else {
        return Err(format!("\"{}\" ended before it had marched {} steps", row.name, WARM + steps));
    };
    Ok(Measurement {
        body,
        steps,
        processor: end.processor.saturating_sub(start.processor),
        wall: end.wall - start.wall,
        held: before.heap.zip(end.heap).map(|(before, end)| end.held - before.held),
        allocations: start.heap.zip(end.heap).map(|(start, end)| end.allocations - start.allocations),
    })
}

/// The bare scene's shell, built by the layers below alone.
///
/// # Errors
/// What they refuse, in words.
pub fn shell_without_scene(side: usize) -> Result<Shell, String> {
    fn words(error: impl ToString) -> String {
        error.to_string()
    }
    let plate = Plate { lengths: [1.0, 1.0] };
    // Moved by nothing, as coque does: the copy holds no room that the builder of lattices left over.
    let cloud = lattice(&plate, [side, side], EndWeights::Trapezoid)
        .map_err(words)?
        .transformed(&Rotation3::identity(), &Vec3::zeros());
    let material = Isotropic::new(1e6, 0.3).map_err(words)?;
    let section = IsotropicSection::new(material, 0.01).map_err(words)?;
    Shell::builder(Parts {
        cloud,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: 1.0,
        formulation: Formulation::StressPoint(Reach::Cell),
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    })
    .build()
    .map_err(words)
}

/// The step with which the bare scene is marched \[s\].
///
/// # Errors
/// What the layers below refuse, in words.
pub fn bare_step(side: usize) -> Result<f64, String> {
    let mut shell = shell_without_scene(side)?;
    shell.stable_step(SAFETY).map(|step| step.dt).map_err(|error| error.to_string())
}

/// The model of a row.
///
/// # Errors
/// The refusal of its scene.
pub fn model(row: &Row) -> Result<Model, String> {
    scene(row).and_then(|scene| scene.build(row.threads)).map_err(|error| shown(&error))
}

/// The shell of a row.
///
/// # Errors
/// The refusal of its scene.
pub fn shell(row: &Row) -> Result<Shell, String> {
    scene(row).and_then(|scene| scene.build_shell(row.threads)).map_err(|error| shown(&error))
}

fn scene(row: &Row) -> Result<Checked, SceneError> {
    Scene::with_overrides(SCENE, row.name, &row.set)
}

fn shown(error: &SceneError) -> String {
    render(error, Rendering { width: 110, colour: false })
}

/// Sets the plate in motion: a turn in its plane and a saddle, at up to a tenth per cent of the speed of sound.
pub fn stir(shell: &mut Shell) {
    for a in 0..shell.len() {
        let x = shell.position(a);
        shell.set_rate(a, Vec3::new(x.y, -x.x, x.x * x.y), Vec3::zeros());
    }
}

/// Runs a model with the files that its scene asks for, as the command does, until the watch ends it.
fn run(model: Model, row: &Row, watch: &mut Stopwatch) -> Result<(), String> {
    let folder = Scratch::new()?;
    let output = model.task.output.clone();
    let files = output.fields.map(|wanted| FieldFiles::create(&folder.0, FieldFiles::LONE, &wanted));
    let mut files = files.transpose().map_err(|error| error.to_string())?;
    let mut checkpoints = output.checkpoint_every.map(|every| {
        let origin = Origin::new(SCENE, row.name.into(), row.set.clone(), row.threads);
        Checkpoints::new(&folder.0, origin, every.get())
    });
    let options = RunOptions {
        progress: watch,
        checkpoints: checkpoints.as_mut(),
        fields: files.as_mut().map(|files| files as &mut dyn FieldSink),
        from: None,
    };
    model.run_with(options).map(|_| ()).map_err(|error| error.to_string())
}

/// A folder of a measurement's own, gone with it.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Result<Self, String> {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let folder = std::env::temp_dir().join(format!("coque-option-cost-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&folder)
            .map_err(|error| format!("cannot create {}: {error}", folder.display()))?;
        Ok(Self(folder))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // A folder that stays in the place for temporary files harms nobody.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
