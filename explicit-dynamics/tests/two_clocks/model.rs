//! A column of gas between springs: a fluid that knows nothing of particles, and structures of one mass.

use explicit_dynamics::{
    BoundaryDriven, BoundaryLayout, BoundaryLoad, BoundaryState, Bounds, Dynamics, Instant, MarchError,
    OutOfBounds, StableStep, Step, Wetted, Work,
};

pub const DENSITY: f64 = 1.0;
pub const SOUND: f64 = 10.0;
pub const LENGTH: f64 = 1.0;

/// Gas in cells of a length, staggered like a kick–drift–kick scheme of particles: momentum from the pressures of
/// cells, strains of cells from velocities. Both ends are boundaries; one without a structure stays where it is.
pub struct Column {
    cell: f64,
    pub dt: f64,
    pub advance: f64,
    /// By which its step wavers, one factor after the other; none of a steady one.
    pub wavers: Vec<f64>,
    steps: usize,
    pub strains: Vec<f64>,
    pub velocities: Vec<f64>,
    ends: [f64; 2],
    forces: [Vec<[f64; 3]>; 2],
    /// Work of the ends since the last kick, and the last step.
    owed: f64,
    last: f64,
    pub time: f64,
}

impl Column {
    pub fn new(cells: usize, courant: f64) -> Self {
        let cell = LENGTH / cells as f64;
        Self {
            cell,
            dt: courant * cell / SOUND,
            advance: f64::INFINITY,
            wavers: Vec::new(),
            steps: 0,
            strains: vec![0.0; cells],
            velocities: vec![0.0; cells - 1],
            ends: [0.0; 2],
            forces: [(); 2].map(|()| vec![[0.0; 3]]),
            owed: 0.0,
            last: 0.0,
            time: 0.0,
        }
    }

    pub fn state(&self) -> Vec<f64> {
        let rest = [self.ends[0], self.ends[1], self.owed, self.last, self.time];
        self.strains.iter().chain(&self.velocities).copied().chain(rest).collect()
    }

    pub fn set_state(&mut self, numbers: &[f64]) {
        let cells = self.strains.len();
        self.strains.copy_from_slice(&numbers[..cells]);
        self.velocities.copy_from_slice(&numbers[cells..2 * cells - 1]);
        let rest = &numbers[2 * cells - 1..];
        self.ends = [rest[0], rest[1]];
        [self.owed, self.last, self.time] = [rest[2], rest[3], rest[4]];
    }

    fn pressure(&self, cell: usize) -> f64 {
        -DENSITY * SOUND * SOUND * self.strains[cell]
    }

    /// Work of the ends on the gas over half a step with the forces last found.
    fn work_of_ends(&self, half: f64) -> f64 {
        -half * (0..2).map(|end| self.forces[end][0][0] * self.ends[end]).sum::<f64>()
    }
}

impl Dynamics for Column {
    fn evaluate(&mut self, _: Instant) -> f64 {
        self.forces[0][0][0] = -self.pressure(0);
        self.forces[1][0][0] = self.pressure(self.strains.len() - 1);
        let stored = |strain: &f64| 0.5 * DENSITY * SOUND * SOUND * strain * strain * self.cell;
        self.strains.iter().map(stored).sum()
    }
    fn kick(&mut self, step: &Step) -> Work {
        let mut work = Work::default();
        for i in 0..self.velocities.len() {
            let push = self.pressure(i) - self.pressure(i + 1);
            let old = self.velocities[i];
            self.velocities[i] += step.kick * push / (DENSITY * self.cell);
            let mean = 0.5 * (old + self.velocities[i]);
            work.kinetic += 0.5 * DENSITY * self.cell * mean * mean;
        }
        if step.kick > 0.0 {
            work.external = self.owed + self.work_of_ends(0.5 * self.last);
            self.owed = 0.0;
        }
        work
    }
    fn drift(&mut self, step: &Step) {
        let (cells, dt) = (self.strains.len(), step.drift());
        for i in 0..cells {
            let left = if i == 0 { self.ends[0] } else { self.velocities[i - 1] };
            let right = if i + 1 == cells { self.ends[1] } else { self.velocities[i] };
            self.strains[i] += dt * (right - left) / self.cell;
        }
        self.owed += self.work_of_ends(0.5 * dt);
        (self.last, self.time) = (dt, step.to.time);
        self.steps += 1;
    }
    fn stable_step(&mut self, _: f64) -> Result<StableStep, MarchError> {
        let factor = self.wavers.get(self.steps % self.wavers.len().max(1)).copied().unwrap_or(1.0);
        Ok(StableStep { dt: self.dt * factor, holds: 1 })
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let fast = self.velocities.iter().position(|v| v.is_nan() || v.abs() >= SOUND);
        let error = |particle: usize| OutOfBounds::Speed {
            particle,
            speed: self.velocities[particle].abs(),
            bound: SOUND,
        };
        fast.map_or(Ok(()), |particle| Err(error(particle)))
    }
    fn stop(&mut self) {
        self.velocities.fill(0.0);
    }
}

impl BoundaryDriven for Column {
    fn set_boundary(&mut self, structure: usize, _: &BoundaryState, velocities: &[[f64; 3]]) {
        self.ends[structure] = velocities[0][0];
    }
    fn boundary_forces(&self, structure: usize) -> &[[f64; 3]] {
        &self.forces[structure]
    }
    fn apply_reactions(&mut self, structure: usize, impulses: &[[f64; 3]]) {
        let nearest = if structure == 0 { 0 } else { self.velocities.len() - 1 };
        let mass = DENSITY * self.cell;
        let (old, gain) = (self.velocities[nearest], -impulses[0][0] / mass);
        self.velocities[nearest] += gain;
        self.owed += mass * gain * (old + 0.5 * gain);
    }
    fn impedance(&self) -> f64 {
        DENSITY * SOUND
    }
    fn greatest_displacement(&self) -> f64 {
        self.advance
    }
    fn particles(&self) -> usize {
        self.velocities.len()
    }
}

/// A mass on a spring, of unit face.
pub struct Spring {
    pub mass: f64,
    pub stiffness: f64,
    pub dt: f64,
    pub x: f64,
    pub v: f64,
    /// Force and seen velocity of the last load, and its impedance.
    load: [f64; 3],
    /// Force that others exert.
    pub exerted: f64,
    external: f64,
    force: f64,
    pub time: f64,
    pub fastest: f64,
    layout: BoundaryLayout,
}

impl Spring {
    pub fn new(mass: f64, stiffness: f64, dt: f64) -> Self {
        Self {
            mass,
            stiffness,
            dt,
            x: 0.0,
            v: 0.0,
            load: [0.0; 3],
            exerted: 0.0,
            external: 0.0,
            force: 0.0,
            time: 0.0,
            fastest: 1e3,
            layout: BoundaryLayout { points: 1, areas: vec![1.0], thin: None },
        }
    }

    pub fn at(self, x: f64) -> Self {
        Self { x, ..self }
    }
}

impl Dynamics for Spring {
    fn evaluate(&mut self, _: Instant) -> f64 {
        let [force, seen, impedance] = self.load;
        self.external = force - impedance * (self.v - seen) + self.exerted;
        self.force = self.external - self.stiffness * self.x;
        0.5 * self.stiffness * self.x * self.x
    }
    fn kick(&mut self, step: &Step) -> Work {
        let half = 0.5 * step.damping * step.kick;
        let old = self.v;
        self.v = (old * (1.0 - half) + step.kick * self.force / self.mass) / (1.0 + half);
        let mean = 0.5 * (old + self.v);
        Work {
            kinetic: 0.5 * self.mass * mean * mean,
            external: step.kick * self.external * mean,
            dissipated: step.kick * step.damping * self.mass * mean * mean,
            ..Work::default()
        }
    }
    fn drift(&mut self, step: &Step) {
        self.x += step.drift() * self.v;
        self.time = step.to.time;
    }
    fn stable_step(&mut self, _: f64) -> Result<StableStep, MarchError> {
        Ok(StableStep { dt: self.dt, holds: 5000 })
    }
    fn within_bounds(&self, _: Bounds) -> Result<(), OutOfBounds> {
        let (speed, bound) = (self.v.abs(), self.fastest);
        if speed <= bound { Ok(()) } else { Err(OutOfBounds::Speed { particle: 0, speed, bound }) }
    }
    fn stop(&mut self) {
        self.v = 0.0;
    }
}

impl Wetted for Spring {
    fn boundary_layout(&self) -> &BoundaryLayout {
        &self.layout
    }
    fn boundary(&self, out: &mut BoundaryState) {
        out.points.clear();
        out.points.push([self.x, 0.0, 0.0]);
    }
    fn apply_load(&mut self, load: &BoundaryLoad<'_>) {
        self.load = [load.forces[0][0], load.seen[0][0], load.impedance];
    }
    fn impedance_impulses(&self, span: f64, impulses: &mut [[f64; 3]]) {
        let [_, seen, impedance] = self.load;
        impulses[0][0] -= span * impedance * (self.v - seen);
    }
    fn boundary_velocities(&self, out: &mut Vec<[f64; 3]>) {
        out.clear();
        out.push([self.v, 0.0, 0.0]);
    }
}
