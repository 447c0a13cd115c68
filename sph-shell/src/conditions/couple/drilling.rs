//! A couple about an axis with a part along the normals of the surface: what directors do not bear goes to positions.
//!
//! A director d takes any moment across itself and none along it. What is left turns the surface about its normal: it does work on the
//! derivatives `a_α = Σ_b g_αb (x_b − x_a)` of places around the particle (spin.rs). With the moment `m e` of a particle,
//!
//! ```text
//! f_b = s Σ_α g_αb v_α     f_a = −Σ_b f_b     Σ x_b × f_b = s N,  N = a₁ × v₁ + a₂ × v₂
//! surface   v₁ = ½ a₂, v₂ = −½ a₁             work s |N| × ½ curl u, the turn of the continuum
//! line      v₁ = d × a₁                       work s |N| × the turn of the line in the surface
//! s = m (e·d)/(N·d)        τ = (m e − s N) × d
//! ```
//!
//! `m e − s N` stands across d, so that the director takes all of it: forces add up to zero and moments to `m e`, to round-off, in any state. At rest the forces are the discrete
//! load of the functional `m ω` by the reproduced gradient, exact for linear displacements. Neither a membrane nor a director gets an unknown or a stiffness for it
//! \[hughes1989\]: a continuum without couple stresses has none at a point. Under a moment M at a point its displacements grow as
//! `M/4πGtr`, so that the surface turns at the particle by about `M/(4πGt a²)` with a the size of its cells, and elsewhere as it should. Spread over
//! an area, or along a line whose turn is meant, the answer converges: along a rim a steady moment c by length is a traction `c/R` along it, in a straight
//! line forces c across at its ends.

use std::ops::Range;

use nalgebra::{Matrix3, RowVector3};
use sph_core::{Cloud, Vec3};

use super::spin::{Spin, spins};
use crate::conditions::body::{Block, Body, place_block};
use crate::conditions::loads::{AddLoad, Load, LoadOnShare, check_set};
use crate::error::ShellError;
use crate::reference::Reference;

/// Cosine between the axis and a director up to which the director bears all of the couple, as of an [`super::EdgeCouple`].
const ACROSS: f64 = 1e-6;

/// A couple about an axis fixed in space on a set of particles, the part along their normals included.
///
/// Where the set is a line, that part turns the line in the surface, else the surface around each particle. A couple across all normals at rest is borne by
/// directors alone, as an [`super::EdgeCouple`], however they turn: a strip that is rolled up by it leans out of its plane by rounding, and forces that follow
/// the lean would drive it on. It has no potential beyond small turns about one axis.
#[derive(Clone, Debug)]
pub struct DrillingCouple {
    /// Particles and their parts of the whole, to any scale.
    shares: Vec<(u32, f64)>,
    /// Its axis (unit vector), and the whole couple \[F L\].
    axis: Vec3,
    moment: f64,
    /// Greatest cosine between the axis and a normal at rest.
    along: f64,
    /// How the surface turns at each particle.
    spins: Vec<Option<Spin>>,
}

/// What a couple on a particle does in a state.
struct Turned {
    director: Vec3,
    /// `a_α`, `v_α` \[–\].
    along: [Vec3; 2],
    arms: [Vec3; 2],
    /// N \[–\], s and `m e − s N` \[F L\].
    normal: Vec3,
    size: f64,
    rest: Vec3,
}

impl DrillingCouple {
    /// A couple \[F L\] about a unit vector on particles with their tributary lengths or other shares.
    pub fn new(cloud: &Cloud, shares: Vec<(u32, f64)>, axis: Vec3, moment: f64) -> Self {
        let particles: Vec<u32> = shares.iter().map(|share| share.0).collect();
        let spins = spins(cloud, &particles);
        let normal = |a: &u32| cloud.frames[*a as usize].n.dot(&axis).abs();
        let along = particles.iter().map(normal).fold(0.0, f64::max);
        Self { shares, axis, moment, along, spins }
    }

    /// Whether its set is a line, which it turns as a whole.
    pub fn turns_a_line(&self) -> bool {
        self.spins.iter().flatten().any(|spin| spin.of_line)
    }

    /// Places in the list, the particle, its part of a couple of this size, and how the surface turns there.
    fn each(&self, scale: f64) -> impl Iterator<Item = (usize, u32, f64, Option<&Spin>)> {
        let whole: f64 = self.shares.iter().map(|share| share.1).sum();
        let spins = self.shares.iter().zip(&self.spins).enumerate();
        spins.map(move |(i, (&(a, share), spin))| (i, a, scale * self.moment * share / whole, spin.as_ref()))
    }

    /// How the surface turns at a particle, where that is to bear a part of the couple in a state.
    fn turning<'a>(&self, particle: u32, spin: Option<&'a Spin>, state: &[[f64; 6]]) -> Option<&'a Spin> {
        let director = Vec3::from_row_slice(&state[particle as usize][3..]);
        spin.filter(|_| self.along > ACROSS && self.axis.dot(&director).abs() > ACROSS)
    }

    fn at(&self, particle: u32, size: f64, spin: &Spin, state: &[[f64; 6]]) -> Turned {
        let place = |a: u32| Vec3::from_row_slice(&state[a as usize][..3]);
        let director = Vec3::from_row_slice(&state[particle as usize][3..]);
        let here = place(particle);
        let mut along = [Vec3::zeros(); 2];
        for &(b, coefficients) in &spin.around {
            let arm = place(b) - here;
            along.iter_mut().zip(coefficients).for_each(|(sum, g)| *sum += arm * g);
        }
        let arms = match spin.of_line {
            true => [director.cross(&along[0]), Vec3::zeros()],
            false => [along[1] * 0.5, along[0] * -0.5],
        };
        let normal = along[0].cross(&arms[0]) + along[1].cross(&arms[1]);
        let moment = self.axis * size;
        let size = moment.dot(&director) / normal.dot(&director);
        Turned { director, along, arms, normal, size, rest: moment - normal * size }
    }

    /// Adds what some of its places exert.
    fn add_of(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]], wanted: impl Fn(usize) -> bool) {
        for (_, a, moment, spin) in self.each(scale).filter(|place| wanted(place.0)) {
            let mut put =
                |b: u32, row: usize, v: Vec3| (0..3).for_each(|k| forces[b as usize][row + k] += v[k]);
            let Some(spin) = self.turning(a, spin, body.state) else {
                let director = Vec3::from_row_slice(&body.state[a as usize][3..]);
                put(a, 3, self.axis.cross(&director) * moment);
                continue;
            };
            let turned = self.at(a, moment, spin, body.state);
            let mut sum = Vec3::zeros();
            for &(b, [g1, g2]) in &spin.around {
                let force = (turned.arms[0] * g1 + turned.arms[1] * g2) * turned.size;
                put(b, 0, force);
                sum += force;
            }
            put(a, 0, -sum);
            put(a, 3, turned.rest.cross(&turned.director));
        }
    }
}

impl Turned {
    /// Derivatives over `a₁`, `a₂`, d: of `s v_α`, and of the couple on the director.
    fn changes(&self, moment: &Vec3, of_line: bool) -> [[Matrix3<f64>; 3]; 3] {
        let Self { director: d, along: [a1, a2], arms: [v1, v2], normal, size, rest } = self;
        let (one, zero) = (Matrix3::identity(), Matrix3::zeros());
        let of_arms = match of_line {
            true => [[d.cross_matrix(), zero, -a1.cross_matrix()], [zero; 3]],
            false => [[zero, one * 0.5, zero], [one * -0.5, zero, zero]],
        };
        let over = 1.0 / normal.dot(d);
        let mut out = [[zero; 3]; 3];
        for p in 0..3 {
            let mut of_normal = a1.cross_matrix() * of_arms[0][p] + a2.cross_matrix() * of_arms[1][p];
            let mut of_size: RowVector3<f64> = RowVector3::zeros();
            match p {
                0 => of_normal -= v1.cross_matrix(),
                1 => of_normal -= v2.cross_matrix(),
                _ => of_size += (moment - normal * *size).transpose() * over,
            }
            of_size -= d.transpose() * of_normal * (size * over);
            for (alpha, arm) in [v1, v2].into_iter().enumerate() {
                out[alpha][p] = arm * of_size + of_arms[alpha][p] * *size;
            }
            // (m e − s N) × d
            out[2][p] = d.cross_matrix() * (normal * of_size + of_normal * *size);
            if p == 2 {
                out[2][p] += rest.cross_matrix();
            }
        }
        out
    }
}

impl Load for DrillingCouple {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        self.add_of(scale, body, forces, |_| true);
    }

    fn on_share(&self, own: &Range<usize>, _: &Reference) -> Option<LoadOnShare> {
        let ends = |a: u32, spin: Option<&Spin>| {
            let around = spin.into_iter().flat_map(|spin| &spin.around);
            around.map(|(b, _)| *b).chain([a]).collect::<Vec<u32>>()
        };
        let touches = |a: u32, spin| ends(a, spin).into_iter().any(|b| own.contains(&(b as usize)));
        let places: Vec<_> = self.each(1.0).filter(|(_, a, _, spin)| touches(*a, *spin)).collect();
        let reads = places.iter().flat_map(|(_, a, _, spin)| ends(*a, *spin)).collect();
        let mut wanted = vec![false; self.shares.len()];
        places.iter().for_each(|place| wanted[place.0] = true);
        let couple = self.clone();
        let add: AddLoad =
            Box::new(move |scale, body, forces| couple.add_of(scale, body, forces, |i| wanted[i]));
        Some(LoadOnShare { add, reads })
    }

    /// Derivatives of the formulas above.
    fn stiffness(&self, scale: f64, body: &Body<'_>, put: &mut dyn FnMut(u32, u32, &Block)) {
        for (_, a, moment, spin) in self.each(scale) {
            let Some(spin) = self.turning(a, spin, body.state) else {
                put(a, a, &place_block(3, 3, &(self.axis.cross_matrix() * moment)));
                continue;
            };
            let turned = self.at(a, moment, spin, body.state);
            let changes = turned.changes(&(self.axis * moment), spin.of_line);
            // The particle itself stands in every difference with the opposite of all coefficients.
            let own = spin.around.iter().fold([0.0; 2], |sum, (_, g)| [sum[0] - g[0], sum[1] - g[1]]);
            let all = || spin.around.iter().copied().chain([(a, own)]);
            for (c, h) in all() {
                let over_place = |changes: &[Matrix3<f64>; 3]| changes[0] * h[0] + changes[1] * h[1];
                let columns = changes.each_ref().map(over_place);
                for (b, g) in all() {
                    let mut block = [[0.0; 6]; 6];
                    let force = columns[0] * g[0] + columns[1] * g[1];
                    (0..3).for_each(|i| (0..3).for_each(|j| block[i][j] = force[(i, j)]));
                    if b == a {
                        (0..3).for_each(|i| (0..3).for_each(|j| block[3 + i][j] = columns[2][(i, j)]));
                    }
                    if c == a {
                        let force = changes[0][2] * g[0] + changes[1][2] * g[1];
                        (0..3).for_each(|i| (0..3).for_each(|j| block[i][3 + j] = force[(i, j)]));
                    }
                    if b == a && c == a {
                        let couple = changes[2][2];
                        (0..3).for_each(|i| (0..3).for_each(|j| block[3 + i][3 + j] = couple[(i, j)]));
                    }
                    put(b, c, &block);
                }
            }
        }
    }

    fn check(&self, reference: &Reference) -> Result<(), ShellError> {
        check_set("a couple", self.shares.iter().map(|share| share.0), reference)?;
        let alone = |(_, spin): &(_, &Option<Spin>)| self.along > ACROSS && spin.is_none();
        match self.shares.iter().zip(&self.spins).find(alone) {
            Some(((particle, _), _)) => Err(ShellError::DrillingAlone(*particle)),
            None => Ok(()),
        }
    }
}
