//! Fluids with one kind of structure in them, and strips of shell that stand for plates in plane problems.

use std::error::Error;

use explicit_dynamics::{Amplitude, BoundaryState, March, Record, Transient, TwoClocks, Wetted};
use fluid_sph::{Fluid, Formulation, Parts, Structure, Wall};
use shell_kinematics::{Isotropic, IsotropicSection, StretchCorrected};
use sph_core::{Cell, Cloud, Vec3};
use sph_shell::{
    AppliedLoad, Gravity, Reach, Shell, ShellBuilder, Support, Supported, SymmetryPlane, WetFaces, Wetting,
};

use super::fluids;
pub use super::fluids::{DENSITY as WATER, GRAVITY};

/// A fluid and structures of one kind.
pub type Coupled<S> = TwoClocks<Fluid, S>;

/// Stiffness in bending of a strip of bonds over that of a plate, by layers: even weights, a horizon of
/// 3.015 spacings (case strip-bending). Moduli of solids are raised by it.
const BENDING: [(usize, f64); 6] = [(3, 0.639), (4, 0.721), (5, 0.790), (8, 0.894), (10, 0.926), (20, 0.976)];

/// Rows of particles behind a wall and below a wet face: those that a kernel of 1.55 spacings reaches from a face, half a spacing before the first.
pub const ROWS: usize = 3;

/// A strip of shell across the plane z = 0, two particles wide between planes of symmetry: a plate in plane
/// strain.
///
/// Station i holds the particles 2i and 2i + 1; directors point to the right of who goes along the line.
pub struct Strip {
    /// Stations of the middle line, in order \[L\].
    pub line: Vec<[f64; 2]>,
    /// Whether the last station is joined to the first.
    pub closed: bool,
    pub young: f64,
    pub poisson: f64,
    pub thickness: f64,
    pub density: f64,
    /// Gravity along −y \[L/T²\].
    pub gravity: f64,
    /// Supports beside the planes of symmetry, by stations.
    pub held: Vec<(Vec<usize>, Box<dyn Support>)>,
}

impl Strip {
    /// Width of the strip \[L\]: the distance of its first stations.
    pub fn width(&self) -> f64 {
        let [a, b] = [self.line[0], self.line[1]];
        libm::hypot(b[0] - a[0], b[1] - a[1])
    }

    /// The shell before it is built, dry.
    ///
    /// # Errors
    /// Of a line or a material that make no sense.
    pub fn builder(self) -> Result<ShellBuilder, Box<dyn Error>> {
        let (count, half) = (self.line.len(), 0.5 * self.width());
        let place = |[x, y]: [f64; 2]| [-half, half].map(|z| Vec3::new(x, y, z));
        let positions: Vec<Vec3> = self.line.iter().flat_map(|&station| place(station)).collect();
        let cell = |i: usize| {
            let (a, b) = (2 * i as u32, 2 * ((i + 1) % count) as u32);
            Cell::quadrangle([a, b, b + 1, a + 1])
        };
        let cells = (0..count - usize::from(!self.closed)).map(cell).collect();
        let cloud = Cloud::from_cells(positions, None, cells)?;
        let particles =
            |stations: &[usize]| stations.iter().flat_map(|&i| [2 * i as u32, 2 * i as u32 + 1]).collect();
        let all: Vec<usize> = (0..count).collect();
        let plane =
            Supported { particles: particles(&all), support: Box::new(SymmetryPlane { normal: Vec3::z() }) };
        let mut supports = vec![plane];
        supports.extend(
            self.held.into_iter().map(|(at, support)| Supported { particles: particles(&at), support }),
        );
        let weight = AppliedLoad {
            load: Box::new(Gravity { acceleration: -Vec3::y() * self.gravity }),
            amplitude: Amplitude::Constant,
        };
        Ok(Shell::builder(sph_shell::Parts {
            cloud,
            section: Box::new(IsotropicSection::new(
                Isotropic::new(self.young, self.poisson)?,
                self.thickness,
            )?),
            strain: &StretchCorrected,
            material_axis: None,
            density: self.density,
            formulation: sph_shell::Formulation::StressPoint(Reach::Cell),
            supports,
            loads: if self.gravity == 0.0 { Vec::new() } else { vec![weight] },
            threads: 1,
        }))
    }
}

/// Young's modulus with which a strip of so many layers of bonds bends like a plate of the given one; the
/// same for numbers of layers that were not measured.
pub fn raised(young: f64, layers: usize) -> f64 {
    young / BENDING.iter().find(|known| known.0 == layers).map_or(1.0, |known| known.1)
}

/// Stations at even distances from one place to another.
pub fn stations(from: [f64; 2], to: [f64; 2], cells: usize) -> Vec<[f64; 2]> {
    let at = |part: f64| [0, 1].map(|k| from[k] + part * (to[k] - from[k]));
    (0..=cells).map(|i| at(i as f64 / cells as f64)).collect()
}

/// A strip in a fluid of some spacing, with free ends at some stations.
pub fn wetting(spacing: f64, faces: WetFaces, free: &[usize]) -> Wetting {
    let free_edges = free.iter().flat_map(|&i| [2 * i as u32, 2 * i as u32 + 1]).collect();
    Wetting { spacing, rows: ROWS, faces, plane: true, free_edges }
}

/// Particles in the middles of square cells between two corners, in whole numbers of cells.
pub fn fill(min: [f64; 2], max: [f64; 2], spacing: f64) -> Vec<Vec3> {
    fluids::filled([min[0], min[1], 0.0], [max[0], max[1], 0.0], 2, spacing)
}

/// Water at rest under gravity in a plane, the default method; no structure yet.
pub fn water(spacing: f64, positions: Vec<Vec3>, sound_speed: f64, walls: Vec<Vec<Vec3>>) -> Parts {
    let walls = walls.into_iter().map(|points| Wall { points, motion: None }).collect();
    Parts { walls, ..fluids::water(2, spacing, positions, sound_speed, Formulation::default()) }
}

/// What a fluid knows of a structure.
pub fn structure(body: &(impl Wetted + ?Sized)) -> Structure {
    let mut state = BoundaryState::default();
    body.boundary(&mut state);
    Structure { layout: body.boundary_layout().clone(), state }
}

/// Structures in a fluid.
///
/// # Errors
/// Of an invalid fluid.
pub fn coupled<S: Wetted>(parts: Parts, bodies: Vec<S>) -> Result<Coupled<S>, Box<dyn Error>> {
    let structures = bodies.iter().map(|body| structure(body)).collect();
    let fluid = Fluid::new(Parts { structures, ..parts })?;
    Ok(TwoClocks::new(fluid, bodies.into_iter().map(Box::new).collect()))
}

/// Marches at 0.9 of the stable step of the structures, the whole one of the fluid, and shows the system at
/// equal intervals; damping \[1/T\] acts on structures alone. Returns the steps of the fluid.
///
/// # Errors
/// A motion that diverges.
pub fn march<S: explicit_dynamics::Dynamics>(
    system: &mut S,
    [duration, record_every]: [f64; 2],
    damping: f64,
    mut show: impl FnMut(&mut S, &Record),
) -> Result<u64, Box<dyn Error>> {
    let run = Transient { duration, record_every, damping, safety: 0.9 };
    let mut march = March::start(run, system)?;
    while let Some(record) = march.next_record(system)? {
        show(system, &record);
    }
    Ok(march.clock().steps)
}
