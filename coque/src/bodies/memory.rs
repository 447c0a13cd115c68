//! Memory: what a scene will need, held against what the machine has, before anything large is made.

use crate::scene::body_in_scene::BodyInScene;
use crate::scene::error::SceneError;
use crate::scene::{
    Analysis, BodyScene, Formulation, Geometry, Harmonic, Linear, LinearSolver, Reach, ShellScene, SolidScene,
};

/// Memory for the program itself, its stacks and its results \[bytes\].
const PROGRAM: f64 = 5e7;
/// Greatest memory a particle while a model is built and marched \[bytes\]: 1300 and 1480 on lattices of 10⁴ and 3·10⁴
/// particles, rounded up.
const CELLS: f64 = 1800.0;
/// The same beside it for kernels: 24 000 on 9·10³ particles of equal spacings, for reaches of 1.4 and of 3.
const KERNEL: f64 = 23_000.0;
/// The same for what clouds off lattices keep beside it: 100 on those two.
const DISORDER: f64 = 200.0;
/// A tangent, its factor and what ordering them takes, a particle and a doubling of their number \[bytes\]: 920 and 980 on
/// 3·10³ and 9·10³ particles; and where kernels couple them: 9100 on 3·10³.
const FACTOR: f64 = 1000.0;
const KERNEL_FACTOR: f64 = 9100.0;

/// Entries of a factor of both parts of each unknown over those of one.
const BOTH_PARTS: f64 = 4.0;

/// A tangent and the levels of multigrid on it, a particle \[bytes\]: see docs/performance.md; and where kernels couple them.
const MULTIGRID: f64 = 9000.0;
const KERNEL_MULTIGRID: f64 = 80_000.0;

/// Greatest memory a node of a solid while it is built and marched, without and for each bond \[bytes\]: 1900 with 35 bonds, on
/// 16 000 nodes of a plane.
const NODE: f64 = 400.0;
const BOND: f64 = 40.0;
/// The same for each block of a tangent and what its factor takes beside it, a doubling of the number of nodes \[bytes\]: 25 on
/// 2700 nodes in space, two spacings of horizon.
const BLOCK: f64 = 30.0;

/// Greatest memory of a quadrature point of a Galerkin solid, and of each node that it sees \[bytes\].
const GAUSS: f64 = 1500.0;
const SHAPE: f64 = 50.0;

/// Greatest memory of a particle of a fluid or a wall while it is built and marched \[bytes\].
const FLUID: f64 = 600.0;

/// The bound of every scene.
const MOST_PARTICLES: f64 = 1e7;

/// Memory of a run \[bytes\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Memory {
    /// What it will need, within a factor of two.
    pub needed: f64,
    /// What there is: free in the machine, and within the limits of the process and its group; none where the system
    /// does not tell.
    pub available: Option<f64>,
}

impl Memory {
    /// Words for whoever should know before the run, if it needs more than half of what there is.
    pub fn warning(&self) -> Option<String> {
        let available = self.available?;
        (self.needed > 0.5 * available).then(|| {
            let [needed, available] = [self.needed, available].map(amount);
            format!("the run needs about {needed} of memory, and {available} are free")
        })
    }
}

/// Memory for so many particles, refused if the machine has less.
///
/// # Errors
/// [`SceneError::Value`] at what sets the number of particles.
pub(crate) fn check_memory(scene: &BodyInScene<'_>, particles: f64) -> Result<Memory, SceneError> {
    let mut memory = Memory { needed: memory(scene.analysis, scene.body, particles), available: available() };
    if scene.scene.is_load_set {
        memory.available = None;
    }
    let Some(available) = memory.available.filter(|&available| memory.needed > available) else {
        return Ok(memory);
    };
    let key = match scene.body {
        BodyScene::Solid(solid) => match solid.geometry.word() {
            "arc" => "arc.cells".into(),
            word => format!("{word}.spacing"),
        },
        BodyScene::Fluid(fluid) => format!("{}.spacing", fluid.geometry.word()),
        BodyScene::Walls(walls) => walls.geometry.word().into(),
        BodyScene::Rigid(rigid) => rigid.geometry.word().into(),
        BodyScene::Shell(ShellScene { geometry, .. }) => {
            let key = match geometry {
                Geometry::Mesh(_) => "file",
                _ if geometry.placing().scattered.is_some() => "scattered.spacing",
                _ => "particles",
            };
            format!("{}.{key}", geometry.word())
        }
    };
    let value = format!("{particles:.0} particles, which need about {}", amount(memory.needed));
    let bound = format!("few enough for the {} of memory that are free", amount(available));
    let repair = match (scene.analysis, scene.body) {
        (Analysis::Linear(Linear { solver: LinearSolver::Direct, .. }), BodyScene::Shell(_)) => {
            "take fewer particles, analysis.linear.solver = \"conjugate-gradients\", or raise the limit of the process (ulimit -v, memory.max)"
        }
        _ => "take fewer particles, or raise the limit of the process (ulimit -v, memory.max)",
    };
    Err(scene.body_scope().value(&format!("geometry.{key}"), value, &bound, repair))
}

/// Particles that the geometry asks for; none before a mesh is read.
pub(crate) fn particles_asked(geometry: &Geometry) -> Option<f64> {
    if let Some([n1, n2]) = geometry.particles() {
        return Some(n1 as f64 * n2 as f64);
    }
    let spacing = geometry.placing().scattered?.spacing;
    let area = match geometry {
        Geometry::Plate(plate) => plate.lengths[0].get() * plate.lengths[1].get(),
        Geometry::Cylinder(c) => c.radius.get() * (c.angles[1] - c.angles[0]).to_radians() * c.length.get(),
        Geometry::Sphere(s) => {
            let [top, bottom] = s.polar.map(|angle| libm::cos(angle.to_radians()));
            s.radius.get() * s.radius.get() * (top - bottom) * (s.azimuth[1] - s.azimuth[0]).to_radians()
        }
        Geometry::Twisted(s) => s.length.get() * s.width.get(),
        Geometry::Mesh(_) => return None,
    };
    // More than any scene may have is refused where particles are placed, in the same words everywhere.
    Some((area / (spacing.get() * spacing.get())).abs()).filter(|&particles| particles <= MOST_PARTICLES)
}

/// Greatest memory of such a run \[bytes\].
pub(crate) fn memory(analysis: &Analysis, body: &BodyScene, particles: f64) -> f64 {
    let Shares { each, factor, multigrid } = match body {
        BodyScene::Shell(shell) => shares_of_shell(shell),
        BodyScene::Solid(solid) => shares_of_solid(solid),
        // A vertex has no more than a particle of a fluid.
        BodyScene::Fluid(_) | BodyScene::Walls(_) | BodyScene::Rigid(_) => {
            Shares { each: FLUID, ..Shares::default() }
        }
    };
    let solver = match analysis {
        Analysis::Explicit(_) => 0.0,
        Analysis::Linear(Linear { solver: LinearSolver::ConjugateGradients, .. }) => multigrid,
        Analysis::Harmonic(Harmonic { modes: None, damping: Some(_), .. }) => {
            BOTH_PARTS * factor * libm::log2(particles.max(2.0))
        }
        _ => factor * libm::log2(particles.max(2.0)),
    };
    PROGRAM + particles * (each + solver)
}

/// Greatest memory of a particle \[bytes\]: of itself, of its share of a factor, and of its share of multigrid, which shells alone have.
#[derive(Default)]
struct Shares {
    each: f64,
    factor: f64,
    multigrid: f64,
}

fn shares_of_shell(shell: &ShellScene) -> Shares {
    let (each, factor, multigrid) = match &shell.formulation {
        Formulation::StressPoint(f) if f.support == Reach::Cell => (CELLS, FACTOR, MULTIGRID),
        _ => (CELLS + KERNEL, KERNEL_FACTOR, KERNEL_MULTIGRID),
    };
    let placing = shell.geometry.placing();
    let lattice = placing.particles.is_some() && placing.disorder.is_none();
    Shares { each: if lattice { each } else { each + DISORDER }, factor, multigrid }
}

fn shares_of_solid(solid: &SolidScene) -> Shares {
    if let Some(galerkin) = solid.galerkin() {
        let near = galerkin.neighbours();
        let points = (galerkin.gauss.get() as f64).powi(3);
        let each = points * (GAUSS + SHAPE * near);
        return Shares { each, factor: BLOCK * 8.0 * near, ..Shares::default() };
    }
    let reach = solid.formulation.horizon() + 0.5;
    let within = |reach: f64| match solid.dimensions() {
        2 => std::f64::consts::PI * reach.powi(2),
        _ => 4.0 / 3.0 * std::f64::consts::PI * reach.powi(3),
    };
    // A node feels the families of its neighbours: blocks of the tangent go twice as far.
    let each = NODE + BOND * within(reach);
    Shares { each, factor: BLOCK * within(2.0 * reach), ..Shares::default() }
}

/// An amount of memory for people.
fn amount(bytes: f64) -> String {
    if bytes < 1e9 { format!("{:.0} MB", 1e-6 * bytes) } else { format!("{:.1} GB", 1e-9 * bytes) }
}

/// Memory that this process can still have \[bytes\].
#[cfg(target_os = "linux")]
fn available() -> Option<f64> {
    let limits = limits();
    let machine = std::fs::read_to_string("/proc/meminfo").ok().and_then(|text| free(&text));
    limits.into_iter().chain(group()).chain(machine).reduce(f64::min)
}

#[cfg(not(target_os = "linux"))]
fn available() -> Option<f64> {
    None
}

/// What the limits of the process leave.
#[cfg(target_os = "linux")]
fn limits() -> Vec<f64> {
    use rustix::process::{Resource, getrlimit};
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let of = |resource, used| {
        let most = getrlimit(resource).current?;
        Some((most as f64 - kilobytes(&status, used)?).max(0.0))
    };
    [of(Resource::As, "VmSize"), of(Resource::Data, "VmData")].into_iter().flatten().collect()
}

/// What a control group (version 2) leaves, and those above it.
#[cfg(target_os = "linux")]
fn group() -> Option<f64> {
    let own = std::fs::read_to_string("/proc/self/cgroup").ok()?;
    let own = own.lines().find_map(|line| line.strip_prefix("0::/"))?;
    let root = std::path::Path::new("/sys/fs/cgroup");
    let own = root.join(own);
    let left = own.ancestors().take_while(|folder| folder.starts_with(root)).filter_map(|folder| {
        let read = |name: &str| std::fs::read_to_string(folder.join(name)).ok();
        let number = |text: String| text.trim().parse::<f64>().ok();
        // "max" where there is no bound.
        let most = read("memory.max").and_then(number)?;
        let used = read("memory.current").and_then(number)?;
        // Files that are kept at hand give way.
        let files = read("memory.stat").unwrap_or_default();
        let files = files.lines().find_map(|line| line.strip_prefix("inactive_file ")?.parse::<f64>().ok());
        Some((most - used + files.unwrap_or(0.0)).max(0.0))
    });
    left.reduce(f64::min)
}

/// Free memory and swap, from the text of `/proc/meminfo`.
#[cfg(any(target_os = "linux", test))]
fn free(text: &str) -> Option<f64> {
    Some(kilobytes(text, "MemAvailable")? + kilobytes(text, "SwapFree").unwrap_or(0.0))
}

/// A line such as `VmSize:  1234 kB` in bytes.
#[cfg(any(target_os = "linux", test))]
fn kilobytes(text: &str, name: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'))?;
    line.trim().strip_suffix("kB")?.trim().parse::<f64>().ok().map(|kilobytes| 1024.0 * kilobytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_free_is_read_from_the_system() {
        let text = "MemTotal:  100 kB\nMemAvailable:   64 kB\nSwapFree:  36 kB\n";
        assert_eq!(free(text), Some(102_400.0));
        assert_eq!(free("MemTotal: 100 kB"), None);
    }

    #[test]
    fn more_than_half_is_reported_with_both_numbers() {
        let memory = |needed| Memory { needed, available: Some(8e9) };
        assert_eq!(memory(3e9).warning(), None);
        let reported = memory(5e9).warning().unwrap();
        assert!(reported.contains("5.0 GB") && reported.contains("8.0 GB"), "{reported}");
    }
}
