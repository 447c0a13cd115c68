//! Structures of masses on springs, each with its points of the wet surface.

use explicit_dynamics::{
    BoundaryLayout, BoundaryLoad, BoundaryState, Bounds, Dynamics, Face, Instant, Joinable,
    LinearisedDynamics, MarchError, MassScaled, OutOfBounds, StableStep, Step, ThinLayout, Wetted, Work,
};
use fluid_sph::Structure;

use crate::common::lattice;

type Vectors = Vec<[f64; 3]>;

/// Masses that springs hold where they were, and each next to the one before.
#[derive(Clone)]
pub struct Body {
    layout: BoundaryLayout,
    /// By point: its mass, where it is from there, and whether it stands for the face.
    points: Vec<(usize, [f64; 3], bool)>,
    home: Vectors,
    /// Displacements and velocities.
    pub x: Vectors,
    pub v: Vectors,
    mass: f64,
    /// Of the springs to home and to the next.
    stiffness: [f64; 2],
    pub dt: f64,
    /// Along which faces look.
    axis: usize,
    load: Vectors,
    seen: Vectors,
    wet: Vec<bool>,
    impedance: f64,
    external: Vectors,
    force: Vectors,
}

impl Body {
    fn new(
        layout: BoundaryLayout,
        points: Vec<(usize, [f64; 3], bool)>,
        home: Vectors,
        axis: usize,
        mass: f64,
    ) -> Self {
        let (of_points, of_masses) = (vec![[0.0; 3]; points.len()], vec![[0.0; 3]; home.len()]);
        Self {
            layout,
            wet: vec![false; points.len()],
            points,
            home,
            x: of_masses.clone(),
            v: of_masses.clone(),
            mass,
            stiffness: [0.0; 2],
            dt: 1.0,
            axis,
            load: of_points.clone(),
            seen: of_points,
            impedance: 0.0,
            external: of_masses.clone(),
            force: of_masses,
        }
    }

    /// Springs that turn by such parts of one in a step of so long \[T\].
    pub fn with_step(mut self, dt: f64, turns: [f64; 2]) -> Self {
        self.stiffness = turns.map(|turn| self.mass * (turn / dt).powi(2));
        self.dt = dt;
        self
    }

    /// In motion.
    pub fn moving(mut self, velocity: [f64; 3]) -> Self {
        self.v.fill(velocity);
        self
    }

    /// A thin plate across an axis, of two spacings: masses in a lattice, three rows of points a face; a free edge along the last of them.
    pub fn plate(axis: usize, corner: [f64; 3], counts: [usize; 3], spacing: f64, density: f64) -> Self {
        let home: Vectors = lattice(corner, counts, spacing).into_iter().map(Into::into).collect();
        let (mut points, mut faces) = (Vec::new(), Vec::new());
        for mass in 0..home.len() {
            for row in 0..3 {
                for (face, sign) in [(Face::Front, 1.0), (Face::Back, -1.0)] {
                    let mut offset = [0.0; 3];
                    offset[axis] = sign * (0.5 - f64::from(row)) * spacing;
                    points.push((mass, offset, row == 0));
                    faces.push(face);
                }
            }
        }
        let plane = corner[2] == -0.5 * spacing;
        let area = if plane { spacing } else { spacing * spacing };
        let edges = (0..home.len()).map(|mass| mass + 1 == home.len()).collect();
        let thin = Some(ThinLayout { thickness: 2.0 * spacing, faces, edges });
        let layout = BoundaryLayout { points: points.len(), areas: vec![area; points.len()], thin };
        Self::new(layout, points, home, axis, density * 2.0 * spacing * area)
    }

    /// A block with one mass; its face is the first column.
    pub fn block(corner: [f64; 3], counts: [usize; 3], spacing: f64, density: f64) -> Self {
        let all = lattice(corner, counts, spacing);
        let face = corner[0] + 0.6 * spacing;
        let points: Vec<_> =
            all.iter()
                .map(|p| (0, (p - all[0]).into(), p.x < face))
                .collect::<Vec<(usize, [f64; 3], bool)>>();
        let dimensions = if counts[2] == 1 { 2 } else { 3 };
        let areas = vec![spacing.powi(dimensions - 1); points.len()];
        let mass = density * spacing.powi(dimensions) * points.len() as f64;
        let layout = BoundaryLayout { points: points.len(), areas, thin: None };
        Self::new(layout, points, vec![all[0].into()], 0, mass)
    }

    /// What a fluid is built with.
    pub fn structure(&self) -> Structure {
        let mut state = BoundaryState::default();
        self.boundary(&mut state);
        Structure { layout: self.layout.clone(), state }
    }

    fn resistance(&self, point: usize) -> f64 {
        let (mass, _, face) = self.points[point];
        let axis = self.axis;
        let resists = face && self.wet[point];
        let rate = self.v[mass][axis] - self.seen[point][axis];
        if resists { -self.impedance * self.layout.areas[point] * rate } else { 0.0 }
    }
}

impl Dynamics for Body {
    fn evaluate(&mut self, _: Instant) -> f64 {
        self.external.fill([0.0; 3]);
        for (point, load) in self.load.iter().enumerate() {
            let external = &mut self.external[self.points[point].0];
            (0..3).for_each(|k| external[k] += load[k]);
        }
        for point in 0..self.points.len() {
            self.external[self.points[point].0][self.axis] += self.resistance(point);
        }
        self.force.clone_from(&self.external);
        let ([home, next], mut stored) = (self.stiffness, 0.0);
        for a in 0..self.x.len() {
            for k in 0..3 {
                let x = self.x[a][k];
                self.force[a][k] -= home * x;
                stored += 0.5 * home * x * x;
                if a > 0 {
                    let stretch = x - self.x[a - 1][k];
                    self.force[a][k] -= next * stretch;
                    self.force[a - 1][k] += next * stretch;
                    stored += 0.5 * next * stretch * stretch;
                }
            }
        }
        stored
    }
    fn kick(&mut self, step: &Step) -> Work {
        let mut work = Work::default();
        for ((v, force), external) in self.v.iter_mut().zip(&self.force).zip(&self.external) {
            for k in 0..3 {
                let old = v[k];
                v[k] += step.kick * force[k] / self.mass;
                let mean = 0.5 * (old + v[k]);
                work.kinetic += 0.5 * self.mass * mean * mean;
                work.external += step.kick * external[k] * mean;
            }
        }
        work
    }
    fn drift(&mut self, step: &Step) {
        for (x, v) in self.x.iter_mut().flatten().zip(self.v.iter().flatten()) {
            *x += step.drift() * v;
        }
    }
    fn stable_step(&mut self, _: f64) -> Result<StableStep, MarchError> {
        Ok(StableStep { dt: self.dt, holds: 20 })
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        Ok(())
    }
    fn stop(&mut self) {
        self.v.fill([0.0; 3]);
    }
}

impl Wetted for Body {
    fn boundary_layout(&self) -> &BoundaryLayout {
        &self.layout
    }
    fn boundary(&self, out: &mut BoundaryState) {
        let place =
            |a: usize, offset: &[f64; 3]| std::array::from_fn(|k| self.home[a][k] + self.x[a][k] + offset[k]);
        out.points.clear();
        out.points.extend(self.points.iter().map(|(a, offset, _)| place(*a, offset)));
        out.middle.clear();
        out.normals.clear();
        if self.layout.thin.is_some() {
            out.middle.extend((0..self.home.len()).map(|a| place(a, &[0.0; 3])));
            let mut normal = [0.0; 3];
            normal[self.axis] = 1.0;
            out.normals.resize(self.home.len(), normal);
        }
    }
    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        self.load.copy_from_slice(load.forces);
        self.seen.copy_from_slice(load.seen);
        self.impedance = load.impedance;
        self.wet.iter_mut().zip(load.found).for_each(|(wet, found)| *wet = *found != [0.0; 3]);
    }
    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        for (point, impulse) in impulses.iter_mut().enumerate() {
            impulse[self.axis] += span * self.resistance(point);
        }
    }
    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        out.clear();
        out.extend(self.points.iter().map(|(a, ..)| self.v[*a]));
    }
}

// Nothing else acts on them here.
impl LinearisedDynamics for Body {
    fn unknowns(&self) -> usize {
        0
    }
    fn apply(&mut self, _: &[f64], _: &mut [f64]) {}
}

impl MassScaled for Body {
    fn out_of_balance(&self, _: &mut [f64]) {}
    fn rates(&self, _: &mut [f64]) {}
    fn displaced(&self) -> f64 {
        0.0
    }
}

impl Joinable for Body {
    fn particles(&self) -> usize {
        0
    }
    fn places(&self, _: &[u32], _: &mut [[f64; 3]]) {}
    fn velocities(&self, _: &[u32], _: &mut [[f64; 3]]) {}
    fn masses(&self, _: &[u32]) -> Vec<f64> {
        Vec::new()
    }
    fn release(&mut self) {}
    fn exert(&mut self, _: &[u32], _: &[[f64; 3]]) {}
    fn unscaled(&self, _: &[u32], _: &[f64], _: &mut [[f64; 3]]) {}
    fn add_scaled(&self, _: &[u32], _: &[[f64; 3]], _: &mut [f64]) {}
}
