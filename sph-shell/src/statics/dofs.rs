//! The free degrees of freedom of a shell as unknowns: translations that no support holds, turns of directors.
//!
//! A turn counts as the length of its arc at a fixed radius, a power of two near the spacing: all unknowns are lengths and
//! all their forces are forces, so that no norm and no pivot depends on the units of a scene.

use shell_kinematics::parallel_transport;
use sph_core::{Frame, Vec3};

use crate::Shell;
use crate::conditions::supports::DirectorHold;
use crate::packs::Row;

/// Where the unknowns of each particle start, and how many are translations.
#[derive(Clone, Debug)]
pub(crate) struct DofMap {
    /// First unknown of each particle, and the end.
    pub offsets: Vec<u32>,
    /// Arc of a turn by one radian \[L\].
    pub arc: f64,
    translations: Vec<u8>,
}

/// The directions of one particle's unknowns in `[x, d]`, up to three translations and two turns; three of a group.
pub(crate) struct Basis {
    /// Unit vectors; those from number `translations` on turn the director, or are axes about which a group turns.
    pub directions: [Vec3; 6],
    /// What a unit of each unknown moves along its direction: 1 for translations, `1/arc` for turns.
    pub rates: [f64; 6],
    pub translations: usize,
    pub count: usize,
}

impl DofMap {
    pub fn new(shell: &Shell) -> Self {
        let mut offsets = vec![0];
        let mut translations = Vec::with_capacity(shell.len());
        for a in 0..shell.len() {
            let basis = shell.basis(a, 1.0);
            translations.push(basis.translations as u8);
            offsets.push(offsets[a] + basis.count as u32);
        }
        // A power of two: scaling by it leaves every digit.
        let arc = libm::exp2(libm::round(libm::log2(shell.reference.cloud.spacing())));
        Self { offsets, arc, translations }
    }

    pub fn count(&self) -> usize {
        self.offsets[self.translations.len()] as usize
    }

    /// Unknowns of a particle.
    pub fn of(&self, particle: usize) -> std::ops::Range<usize> {
        self.offsets[particle] as usize..self.offsets[particle + 1] as usize
    }

    /// Particle of an unknown, its place among the particle's unknowns, and whether it is a translation.
    pub fn find(&self, unknown: usize) -> (usize, usize, bool) {
        let particle = self.offsets.partition_point(|&first| first as usize <= unknown) - 1;
        let place = unknown - self.offsets[particle] as usize;
        (particle, place, place < self.translations[particle] as usize)
    }
}

impl Basis {
    /// None yet, turns counted as arcs of a radius.
    pub fn empty(arc: f64) -> Self {
        Self { directions: [Vec3::zeros(); 6], rates: [1.0 / arc; 6], translations: 0, count: 0 }
    }

    pub fn push(&mut self, direction: Vec3) {
        self.directions[self.count] = direction;
        self.count += 1;
    }

    /// The first unknowns are translations.
    pub fn move_first(&mut self, translations: usize) {
        self.translations = translations;
        self.rates[..translations].fill(1.0);
    }

    /// Components of a row `[x, d]` along the unknowns.
    pub fn project(&self, row: &Row, out: &mut [f64]) {
        for (i, value) in out.iter_mut().enumerate() {
            let part = if i < self.translations { &row[..3] } else { &row[3..] };
            *value = self.directions[i].dot(&Vec3::new(part[0], part[1], part[2])) * self.rates[i];
        }
    }

    /// Components of a turn of the director, put behind those of the translations.
    pub fn turns(&self, turn: &Vec3, components: &mut [f64]) {
        for (i, component) in components.iter_mut().enumerate().skip(self.translations) {
            *component = self.directions[i].dot(turn) / self.rates[i];
        }
    }

    /// Displacement and turn of the director, or rotation of a group, for components along the unknowns.
    pub fn expand(&self, components: &[f64]) -> (Vec3, Vec3) {
        let (mut u, mut v) = (Vec3::zeros(), Vec3::zeros());
        for (i, &c) in components.iter().enumerate() {
            *(if i < self.translations { &mut u } else { &mut v }) +=
                self.directions[i] * (c * self.rates[i]);
        }
        (u, v)
    }
}

impl Shell {
    /// Directions of a particle's unknowns at the present state, turns counted as arcs of a radius.
    pub(crate) fn basis(&self, particle: usize, arc: f64) -> Basis {
        if let Some(group) = self.dependents.junctions.of(particle) {
            return group.basis(&self.motion.state, self.constraint(particle), particle, arc);
        }
        let d = self.director(particle);
        let [t1, t2] = self.stiffeners.axes(particle, &d).unwrap_or_else(|| {
            let frame = Frame::from_normal(d);
            [frame.t1, frame.t2]
        });
        let mut basis = Basis::empty(arc);
        let Some(constraint) = self.constraint(particle) else {
            for direction in [Vec3::x(), Vec3::y(), Vec3::z(), t1, t2] {
                basis.push(direction);
            }
            basis.move_first(3);
            return basis;
        };
        for direction in constraint.held.free() {
            basis.push(direction);
        }
        let translations = 3 - constraint.held.basis().len();
        match constraint.director {
            DirectorHold::Free => {
                basis.push(t1);
                basis.push(t2);
            }
            // The director turns within the plane of its normal.
            DirectorHold::InPlane(normal) => basis.push(normal.cross(&d).normalize()),
            DirectorHold::Fixed => {}
        }
        basis.move_first(translations);
        basis
    }

    /// Displaces a particle and turns its director; gives the turn, carried along.
    pub(crate) fn move_particle(&mut self, a: usize, u: Vec3, v: Vec3) -> Vec3 {
        let (junctions, state) = (&self.dependents.junctions, &mut self.motion.state);
        if junctions.of(a).is_some() {
            junctions.move_first(state, a, &u, &v);
            return v; // a rotation leaves its own axis
        }
        let row = &mut state[a];
        let (d, w) = parallel_transport([row[3], row[4], row[5]], v.into(), 1.0);
        *row = [row[0] + u.x, row[1] + u.y, row[2] + u.z, d[0], d[1], d[2]];
        w.into()
    }
}

/// The turn of a director along the great circle to another.
pub(crate) fn great_circle(here: &Row, there: &Row) -> Vec3 {
    let along: f64 = (3..6).map(|k| here[k] * there[k]).sum();
    let across = Vec3::from_fn(|k, _| there[3 + k] - along * here[3 + k]);
    let sine = across.norm();
    if sine > 0.0 { across * (libm::atan2(sine, along) / sine) } else { Vec3::zeros() }
}
