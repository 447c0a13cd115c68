//! Shells for tests: every formulation on small clouds, and states far from rest.
#![allow(dead_code)] // each test binary uses its own part
#![allow(clippy::unwrap_used)] // a test may stop where it stands

use explicit_dynamics::{Amplitude, March, MarchError, Plan, Record, Transient};
use implicit_statics::{Equilibrium, force_error, linear_response, stiffness_error};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use shell_kinematics::{
    Isotropic, IsotropicSection, LayeredSection, Orthotropic, Ply, StrainMeasure, StretchCorrected,
};
use sph_core::{
    Cell, CellList, Cloud, CubicSpline, Cylinder, EndWeights, Plate, Vec3, jittered_lattice, lattice,
    poisson_cloud,
};
use sph_shell::{AppliedLoad, Formulation, Load, Parts, Reach, Shell, StaticShell, Support, Supported};

pub const YOUNG: f64 = 1200.0;
pub const POISSON: f64 = 0.3;
pub const THICKNESS: f64 = 0.2;
pub const DENSITY: f64 = 1.5;

/// Every formulation that derives from an energy, with a name for messages.
pub fn energy_formulations() -> Vec<(&'static str, Formulation)> {
    let nodal = |order, smoothing, consistent| Formulation::Nodal {
        order,
        smoothing,
        consistent,
        kernel: &CubicSpline,
    };
    vec![
        ("stress-point cell", Formulation::StressPoint(Reach::Cell)),
        ("stress-point 1.4", Formulation::StressPoint(Reach::Kernel(&CubicSpline, 1.4))),
        ("stress-point 3", Formulation::StressPoint(Reach::Kernel(&CubicSpline, 3.0))),
        ("nodal 1", nodal(1, 1.2, true)),
        ("nodal 2", nodal(2, 1.3, true)),
        ("nodal 3", nodal(3, 1.5, true)),
    ]
}

pub fn flat(counts: [usize; 2], lengths: [f64; 2]) -> Cloud {
    lattice(&Plate { lengths }, counts, EndWeights::Trapezoid).unwrap()
}

pub fn curved(counts: [usize; 2]) -> Cloud {
    lattice(&Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 }, counts, EndWeights::Trapezoid)
        .unwrap()
}

pub fn disordered_curved(counts: [usize; 2]) -> Cloud {
    jittered_lattice(&Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 }, counts, 0.25, 7).unwrap()
}

pub fn disordered_flat(counts: [usize; 2], lengths: [f64; 2]) -> Cloud {
    jittered_lattice(&Plate { lengths }, counts, 0.25, 3).unwrap()
}

/// Particles without a lattice behind them, about `spacing` apart; a tenth or so of the cells are triangles.
pub fn scattered_flat(spacing: f64, lengths: [f64; 2]) -> Cloud {
    poisson_cloud(&Plate { lengths }, spacing, 2).unwrap()
}

pub fn scattered_curved(spacing: f64) -> Cloud {
    poisson_cloud(&Cylinder { radius: 3.0, angles: [-0.5, 0.4], length: 2.5 }, spacing, 3).unwrap()
}

pub fn free_shell(cloud: Cloud, formulation: Formulation, thickness: f64) -> Shell {
    shell(cloud, formulation, thickness, &StretchCorrected, Vec::new(), Vec::new())
}

pub fn shell(
    cloud: Cloud,
    formulation: Formulation,
    thickness: f64,
    strain: &'static dyn StrainMeasure,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> Shell {
    let parts = shell_parts(cloud, formulation, thickness, strain, supports, loads);
    Shell::builder(parts).build().unwrap()
}

/// The same before it is built.
pub fn shell_parts(
    cloud: Cloud,
    formulation: Formulation,
    thickness: f64,
    strain: &'static dyn StrainMeasure,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> Parts {
    let loads = loads.into_iter().map(|load| AppliedLoad { load, amplitude: Amplitude::Constant }).collect();
    Parts { strain, supports, loads, ..parts(cloud, formulation, thickness) }
}

/// A free isotropic shell before it is built.
pub fn parts(cloud: Cloud, formulation: Formulation, thickness: f64) -> Parts {
    let section = IsotropicSection::new(Isotropic::new(YOUNG, POISSON).unwrap(), thickness).unwrap();
    Parts {
        cloud,
        section: Box::new(section),
        strain: &StretchCorrected,
        material_axis: None,
        density: DENSITY,
        formulation,
        supports: Vec::new(),
        loads: Vec::new(),
        threads: 1,
    }
}

/// An axis with a projection on every cloud of the tests.
pub const AXIS: Vec3 = Vec3::new(0.4, 1.0, 0.1);

/// Three unlike plies without any symmetry, 0.2 thick, all rotated by `turn`.
pub fn unsymmetric(turn: f64) -> LayeredSection {
    let fibre = Orthotropic::new(3300.0, 600.0, 0.25, 660.0, 400.0).unwrap();
    let ply = |thickness, angle| Ply { material: fibre, thickness, angle: angle + turn };
    LayeredSection::new(&[ply(0.05, 0.0), ply(0.08, 1.1), ply(0.07, -0.6)]).unwrap()
}

/// A free shell with that section.
pub fn laminated(cloud: Cloud, formulation: Formulation, axis: Vec3) -> Shell {
    let section = Box::new(unsymmetric(0.0));
    Shell::builder(Parts { section, material_axis: Some(axis), ..parts(cloud, formulation, 0.2) })
        .build()
        .unwrap()
}

/// Numbers in (−1, 1), the same on every machine.
pub struct RandomNumbers(pub u64);

impl RandomNumbers {
    pub fn roll(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((self.0 >> 11) as f64 / (1_u64 << 53) as f64) * 2.0 - 1.0
    }

    pub fn vector(&mut self) -> Vec3 {
        Vec3::new(self.roll(), self.roll(), self.roll())
    }
}

/// Moves every particle by up to `size` spacings and turns every director by about `size` radians.
pub fn shake(shell: &mut Shell, size: f64, seed: u64) {
    let mut dice = RandomNumbers(seed);
    let spacing = shell.reference().cloud.spacing();
    for a in 0..shell.len() {
        let position = shell.position(a) + dice.vector() * (size * spacing);
        let director = shell.director(a) + dice.vector() * size;
        shell.set_state(a, position, director);
    }
}

/// Moves a body along its unknowns, so that directors that supports hold in a plane stay there.
pub fn shake_unknowns(system: &mut StaticShell, size: f64, seed: u64) {
    let mut dice = RandomNumbers(seed);
    let increment: Vec<f64> = (0..system.unknowns()).map(|_| size * dice.roll()).collect();
    system.update(&increment);
}

pub fn energy(shell: &mut Shell) -> f64 {
    shell.evaluate_internal(true);
    shell.stored_energy()
}

/// Flat sheets of rectangular cells that meet along lines of common places.
#[derive(Default)]
pub struct Sheets {
    positions: Vec<Vec3>,
    normals: Vec<Vec3>,
    cells: Vec<Cell>,
}

impl Sheets {
    /// Adds the sheet `origin + s u + t v`, s and t in [0, 1], of so many cells along u and v; its normal is along u × v.
    pub fn add(mut self, origin: Vec3, [u, v]: [Vec3; 2], [nu, nv]: [usize; 2]) -> Self {
        let first = self.positions.len() as u32;
        let at = |i: usize, j: usize| first + (i * (nv + 1) + j) as u32;
        for i in 0..=nu {
            for j in 0..=nv {
                let place = origin + u * (i as f64 / nu as f64) + v * (j as f64 / nv as f64);
                self.positions.push(place);
                self.normals.push(u.cross(&v).normalize());
            }
        }
        for i in 0..nu {
            for j in 0..nv {
                self.cells.push(Cell::quadrangle([at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]));
            }
        }
        self
    }

    /// The six faces of a box between the origin and a corner, so many cells along each axis; normals point out of it.
    pub fn boxed(corner: Vec3, [nx, ny, nz]: [usize; 3]) -> Self {
        let [x, y, z] = [X * corner.x, Y * corner.y, Z * corner.z];
        Self::default()
            .add(Vec3::zeros(), [y, x], [ny, nx])
            .add(z, [x, y], [nx, ny])
            .add(Vec3::zeros(), [z, y], [nz, ny])
            .add(x, [y, z], [ny, nz])
            .add(Vec3::zeros(), [x, z], [nx, nz])
            .add(y, [z, x], [nz, nx])
    }

    /// The cloud, sheets side by side without a joint.
    pub fn apart(self) -> Cloud {
        Cloud::from_sheets(self.positions, Some(self.normals), self.cells, Vec::new()).unwrap()
    }

    /// The cloud, particles on one place joined.
    pub fn cloud(self) -> Cloud {
        let Self { positions, normals, cells } = self;
        let list = CellList::new(&positions, 0.1);
        let (mut near, mut joined) = (Vec::new(), Vec::new());
        for (a, x) in positions.iter().enumerate() {
            list.within(x, 1e-9, &mut near);
            near.sort_unstable();
            if near.len() > 1 && near[0] as usize == a {
                joined.push(near.clone());
            }
        }
        Cloud::from_sheets(positions, Some(normals), cells, joined).unwrap()
    }
}

impl Sheets {
    /// The cloud, particles on one place made one; the normals are those of the cells.
    pub fn welded(self) -> Cloud {
        let Self { positions, cells, .. } = self;
        let list = CellList::new(&positions, 0.1);
        let mut near = Vec::new();
        let mut first = |a: u32| {
            list.within(&positions[a as usize], 1e-9, &mut near);
            near.iter().copied().min().unwrap_or(a)
        };
        let firsts: Vec<u32> = (0..positions.len() as u32).map(&mut first).collect();
        let mut kept: Vec<u32> = firsts.clone();
        kept.sort_unstable();
        kept.dedup();
        let new = |a: u32| kept.binary_search(&firsts[a as usize]).unwrap() as u32;
        let cells = cells.iter().map(|cell| Cell { corners: cell.corners.map(new), ..*cell }).collect();
        Cloud::from_cells(kept.iter().map(|&a| positions[a as usize]).collect(), None, cells).unwrap()
    }
}

/// Particles of a cloud at which `on` holds.
pub fn at(cloud: &Cloud, on: impl Fn(&Vec3) -> bool) -> Vec<u32> {
    (0..cloud.len() as u32).filter(|&a| on(&cloud.positions[a as usize])).collect()
}

pub const X: Vec3 = Vec3::new(1.0, 0.0, 0.0);
pub const Y: Vec3 = Vec3::new(0.0, 1.0, 0.0);
pub const Z: Vec3 = Vec3::new(0.0, 0.0, 1.0);

/// Two legs of length one that meet at an angle between their normals [rad], so many cells each; wide along y.
pub fn folded(fold: f64, n: usize, wide: f64, across: usize) -> Cloud {
    let (sin, cos) = libm::sincos(fold);
    Sheets::default()
        .add(Vec3::zeros(), [X, Y * wide], [n, across])
        .add(X, [X * cos + Z * sin, Y * wide], [n, across])
        .cloud()
}

/// A bar of length two with a stem of length one up from its middle.
pub fn tee(n: usize, wide: f64, across: usize) -> Cloud {
    Sheets::default()
        .add(-X, [X * 2.0, Y * wide], [2 * n, across])
        .add(Vec3::zeros(), [Z, Y * wide], [n, across])
        .cloud()
}

/// Shares of particles by their boundary length along y.
pub fn line(cloud: &Cloud, particles: &[u32]) -> Vec<(u32, f64)> {
    let y = |a: &u32| cloud.positions[*a as usize].y;
    let most = particles.iter().map(y).fold(0.0, f64::max);
    particles.iter().map(|a| (*a, if y(a) < 1e-9 || y(a) > most - 1e-9 { 0.5 } else { 1.0 })).collect()
}

/// A support on particles.
pub fn supported(particles: Vec<u32>, support: impl Support + 'static) -> Supported {
    Supported { particles, support: Box::new(support) }
}

/// Eigenvalues of the tangent over the masses of modes, ascending by size.
pub fn spectrum(body: Shell) -> Vec<f64> {
    let mut system = StaticShell::new(body);
    let pattern = system.pattern();
    let mut values = vec![0.0; pattern.len()];
    system.tangent(0.0, &mut values);
    let scale: Vec<f64> = system.masses().iter().map(|m| 1.0 / m.sqrt()).collect();
    let beside = system.beside_pattern(0.0);
    let mut matrix = DMatrix::zeros(scale.len(), scale.len());
    for (&(i, j), &value) in pattern.iter().zip(&values) {
        matrix[(i, j)] = value * scale[i] * scale[j];
        matrix[(j, i)] = matrix[(i, j)];
    }
    for term in &beside {
        let g = DVector::from_iterator(scale.len(), term.along.iter().zip(&scale).map(|(g, s)| g * s));
        matrix += &g * g.transpose() * term.factor;
    }
    let mut values: Vec<f64> = SymmetricEigen::new(matrix).eigenvalues.iter().copied().collect();
    values.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
    values
}

/// Holds forces and tangent of the present state against differences along a random direction.
pub fn derivatives_agree(system: &mut StaticShell, level: f64, what: &str) {
    let mut dice = RandomNumbers(3);
    let way: Vec<f64> = (0..system.unknowns()).map(|_| dice.roll()).collect();
    derivatives_along(system, level, &way, 5e-5, [1e-8, 1e-8], what);
}

/// The same along a direction, by a step h of differences, with bounds of the two: truncation h⁴, and the round-off of energy and
/// forces over h.
pub fn derivatives_along(
    system: &mut StaticShell,
    level: f64,
    way: &[f64],
    step: f64,
    bounds: [f64; 2],
    what: &str,
) {
    let errors = [force_error(system, level, way, step), stiffness_error(system, level, way, step)];
    println!("{what}: force {:.1e}, tangent {:.1e}", errors[0], errors[1]);
    assert!(errors[0] < bounds[0] && errors[1] < bounds[1], "{what}: {errors:?}");
}

/// One unknown by itself.
pub fn alone(i: usize, unknowns: usize) -> Vec<f64> {
    (0..unknowns).map(|j| f64::from(u8::from(i == j))).collect()
}

/// Energy `½ f·u` of the linear answer.
pub fn linear_energy(body: Shell) -> f64 {
    let mut system = StaticShell::new(body);
    let mut load = vec![0.0; system.unknowns()];
    system.load_rate(0.0, &mut load);
    let u = linear_response(&mut system, 0.0).unwrap();
    0.5 * load.iter().zip(&u).map(|(f, u)| f * u).sum::<f64>()
}

/// A section without Poisson's ratio, so that strips are beams.
pub fn beam_parts(
    cloud: Cloud,
    thickness: f64,
    supports: Vec<Supported>,
    loads: Vec<Box<dyn Load>>,
) -> Parts {
    let section = IsotropicSection::new(Isotropic::new(YOUNG, 0.0).unwrap(), thickness).unwrap();
    let applied = |load| AppliedLoad { load, amplitude: Amplitude::Constant };
    let loads = loads.into_iter().map(applied).collect();
    Parts {
        section: Box::new(section),
        supports,
        loads,
        ..parts(cloud, Formulation::StressPoint(Reach::Cell), thickness)
    }
}

/// All records of a march.
pub fn records(plan: impl Into<Plan>, body: &mut Shell) -> Result<Vec<Record>, MarchError> {
    let (mut records, mut march) = (Vec::new(), March::start(plan, body)?);
    while let Some(record) = march.next_record(body)? {
        records.push(record);
    }
    Ok(records)
}

/// Energy missing or made in three seconds of free flight at a part of the stable step, over that at the start.
pub fn energy_error(mut body: Shell, safety: f64) -> f64 {
    let run = Transient { duration: 3.0, record_every: 0.02, damping: 0.0, safety };
    let records = records(run, &mut body).unwrap();
    let start = records[0].energy;
    let worst = records.iter().fold(0.0, |worst: f64, r| worst.max(r.balance_error.abs()));
    worst / (start.kinetic + start.internal)
}

/// Momentum and moment of momentum of a shell, and the sums of the sizes that they are made of.
pub fn momenta(shell: &Shell) -> ([Vec3; 2], [f64; 2]) {
    let reference = shell.reference();
    let (mut sums, mut sizes) = ([Vec3::zeros(); 2], [0.0; 2]);
    for (a, m) in reference.masses.iter().enumerate() {
        let (x, v) = (shell.position(a), shell.velocity(a) * *m);
        // Of the director's motion too.
        let turning = shell.director(a).cross(&shell.director_rate(a)) * reference.inertias[a];
        sums = [sums[0] + v, sums[1] + x.cross(&v) + turning];
        sizes = [sizes[0] + v.norm(), sizes[1] + x.cross(&v).norm()];
    }
    (sums, sizes)
}
