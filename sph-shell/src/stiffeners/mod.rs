//! Bars along lines of a shell: they go with the positions and directors of its particles and have no unknowns of their own.
//!
//! Between neighbouring particles a and b of a line, at rest l apart, lies a piece with one point, the [`Bar`] of `shell-kinematics`:
//!
//! ```text
//! x′ = (x_b − x_a)/l     d = ½(d_a + d_b)     d′ = (d_b − d_a)/l
//! U = Σ l ψ(x′, d, d′)   f = −∂U/∂x,  τ = −∂U/∂d, with those of the cells
//! ```
//!
//! Where a bar bends in the surface too, the turn of its line at each particle between two others stores energy (bends.rs).
//!
//! Two ends and a point between do not lock: slopes of chords and means of directors agree in pure bending, as in cells. Masses are lumped at both ends,
//! `½ ρA l√P` each, where gravity finds them. In marches the director has the inertia of a bar as thick as a piece is long, `½ ρ l√P (A e² +
//! max(A l²/12, I_p))`, as it has that of a cell; in modes its own (turning.rs). As with sections over their particles, what the height couples of velocities
//! and rates of directors, `ρ A e ẋ·ḋ`, is left out, so that masses stay diagonal.

mod bends;
mod line;
mod turning;

use std::ops::Range;

use implicit_statics::BlockPattern;
use shell_kinematics::{Bar, BarPlacement, BarSection};
use sph_core::Vec3;

use crate::Shell;
use crate::conditions::body::Block;
use crate::conditions::loads::check_set;
use crate::error::{ShellError, StiffenerError};
use crate::packs::Row;
use crate::reference::Reference;
use crate::time::share::Share;
use bends::Turn;
use turning::Turning;

pub use bends::InSurface;

/// A bar along a line of particles.
#[derive(Clone, Debug)]
pub struct Stiffener {
    /// Particles of the line, in any order; neighbours are those that share an edge of a cell.
    pub particles: Vec<u32>,
    /// Stiffness of its cross-section.
    pub section: BarSection,
    /// Height of its centroid over the particles, along their directors \[L\].
    pub height: f64,
    /// Mass by length of its centroid line \[M/L\].
    pub mass: f64,
    /// Bending in the surface; none where the surface bears it alone.
    pub in_surface: Option<InSurface>,
}

/// A piece of a bar between two particles.
#[derive(Clone, Copy, Debug)]
struct Piece {
    ends: [u32; 2],
    /// Distance of the particles at rest \[L\].
    length: f64,
    bar: Bar,
    /// Number of its stiffener.
    number: usize,
}

/// All stiffeners of a shell; empty where there are none.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stiffeners {
    pieces: Vec<Piece>,
    /// Of bars that bend in the surface.
    turns: Vec<Turn>,
    /// By particle, ascending.
    turning: Vec<Turning>,
}

/// What a piece of a stiffener bears, in its own axes.
#[derive(Clone, Copy, Debug)]
pub struct BarForce {
    /// Number of the stiffener.
    pub stiffener: usize,
    /// Particles at its ends.
    pub ends: [u32; 2],
    /// Axial force \[F\].
    pub axial: f64,
    /// Bending moment about the centroid \[F L\], positive where it stretches the side to which directors point.
    pub bending: f64,
    /// Transverse shear force \[F\].
    pub shear: f64,
    /// Torque \[F L\].
    pub torque: f64,
}

fn vectors(row: &Row) -> [Vec3; 2] {
    [Vec3::new(row[0], row[1], row[2]), Vec3::new(row[3], row[4], row[5])]
}

impl Piece {
    fn placement(&self, state: &[Row]) -> BarPlacement {
        let [a, b] = self.ends.map(|end| vectors(&state[end as usize]));
        BarPlacement {
            x1: (b[0] - a[0]) / self.length,
            d: (a[1] + b[1]) * 0.5,
            d1: (b[1] - a[1]) / self.length,
        }
    }

    /// How `x′`, `d` and `d′` go with each end.
    fn shares(&self) -> [[f64; 3]; 2] {
        let by = 1.0 / self.length;
        [[-by, 0.5, -by], [by, 0.5, by]]
    }

    fn bears(&self, state: &[Row]) -> BarForce {
        let strains = self.bar.strains(&self.placement(state));
        let [axial, bending, shear, torque] = self.bar.resultants(&strains);
        BarForce { stiffener: self.number, ends: self.ends, axial, bending, shear, torque }
    }

    /// Whether it has an end among some particles.
    fn touches(&self, own: &Range<usize>) -> bool {
        self.ends.iter().any(|&end| own.contains(&(end as usize)))
    }
}

impl Stiffeners {
    /// Finds the lines on a shell, adds masses and rotary inertias of marches to those of its particles.
    ///
    /// # Errors
    /// [`StiffenerError`] for sets that are no lines, bars beyond the centre of curvature of their line, numbers without sense.
    pub fn new(
        stiffeners: &[Stiffener],
        reference: &mut Reference,
        thickness: f64,
    ) -> Result<Self, ShellError> {
        let rest = reference.rest();
        let (mut pieces, mut turns) = (Vec::new(), Vec::new());
        let mut masses = Vec::new();
        let mut leaning: Vec<Vec<(Vec3, [f64; 2])>> =
            vec![Vec::new(); rest.len() * usize::from(!stiffeners.is_empty())];
        for (number, stiffener) in stiffeners.iter().enumerate() {
            let Stiffener { particles, section, height, mass, in_surface } = stiffener;
            stiffener.check(number)?;
            check_set("a stiffener", particles.iter().copied(), reference)?;
            let edges = line::edges(&reference.cloud, particles, number)?;
            if let Some(lateral) = in_surface {
                turns.extend(bends::turns(&reference.cloud, &rest, &edges, (number, *height), lateral)?);
            }
            for ends in edges {
                let [a, b] = ends.map(|end| vectors(&rest[end as usize]));
                let length = (b[0] - a[0]).norm();
                let at_rest = BarPlacement {
                    x1: (b[0] - a[0]) / length,
                    d: (a[1] + b[1]) * 0.5,
                    d1: (b[1] - a[1]) / length,
                };
                let beyond = || StiffenerError::BeyondCentre { number, ends, height: *height };
                let bar = Bar::new(*section, *height, &at_rest).ok_or_else(beyond)?;
                let (own, half) = (length * bar.length(), 0.5 * mass * length * bar.length());
                let aside = section.gyration + height * height;
                for end in ends {
                    masses.push((end, half));
                    let as_thick = section.gyration.max(own * own / 12.0);
                    reference.inertias[end as usize] += half * (height * height + as_thick);
                    let inertias = [half * section.bending / section.axial, half * aside];
                    leaning[end as usize].push((at_rest.x1, inertias));
                }
                pieces.push(Piece { ends, length, bar, number });
            }
        }
        reference.lump(&masses, thickness)?;
        let at = |(a, bars): (usize, &Vec<(Vec3, [f64; 2])>)| {
            (!bars.is_empty()).then(|| Turning::new(a as u32, &reference.cloud.frames[a], bars))
        };
        let turning = leaning.iter().enumerate().filter_map(at).collect();
        Ok(Self { pieces, turns, turning })
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.pieces.is_empty()
    }

    /// Adds `[∂U/∂x, ∂U/∂d]` in a state to the rows of a range of particles.
    fn add_forces(&self, state: &[Row], own: &Range<usize>, rows: &mut [Row]) {
        for piece in self.pieces.iter().filter(|piece| piece.touches(own)) {
            let forces = piece.bar.forces(&piece.placement(state));
            for (end, [x1, d, d1]) in piece.ends.into_iter().zip(piece.shares()) {
                if !own.contains(&(end as usize)) {
                    continue;
                }
                let row = &mut rows[end as usize];
                for k in 0..3 {
                    row[k] += piece.length * x1 * forces[k];
                    row[3 + k] += piece.length * (d * forces[3 + k] + d1 * forces[6 + k]);
                }
            }
        }
        self.turns.iter().for_each(|turn| turn.add_forces(state, own, rows));
    }

    /// Adds the same to the rows of the particles of one who marches the shell; the energy of all pieces over all who do, if it is wanted \[F L\].
    pub fn add(&self, state: &[Row], share: &Share, rows: &mut [Row], energy: bool) -> f64 {
        if self.is_empty() {
            return 0.0;
        }
        let own = share.own();
        self.add_forces(state, &own, rows);
        if !energy {
            return 0.0;
        }
        let pieces = self.pieces.iter().filter(|piece| own.contains(&(piece.ends[0] as usize)));
        let energies = pieces.map(|piece| [piece.length * piece.bar.energy(&piece.placement(state))]);
        let turns = self.turns.iter().filter(|turn| turn.is_of(&own)).map(|turn| [turn.energy(state)]);
        let [sum] = share.sum(energies.chain(turns));
        sum
    }

    /// Particles that share a block of the tangent.
    pub fn pairs(&self) -> impl Iterator<Item = [u32; 2]> {
        let of_turn = |turn: &Turn| {
            let own: Vec<u32> = turn.particles().collect();
            let all = own.iter().flat_map(|&a| own.iter().map(move |&b| [a, b]));
            all.filter(|[a, b]| a < b).collect::<Vec<_>>()
        };
        self.pieces.iter().map(|piece| piece.ends).chain(self.turns.iter().flat_map(of_turn))
    }

    /// Particles that those of a range feel.
    pub fn reads(&self, own: &Range<usize>) -> impl Iterator<Item = u32> {
        let pieces = self.pieces.iter().filter(|piece| piece.touches(own)).flat_map(|piece| piece.ends);
        pieces.chain(self.turns.iter().filter(|turn| turn.touches(own)).flat_map(Turn::particles))
    }

    /// Adds the second derivatives of the energy in a state to blocks, with the stresses of another if one is given.
    pub fn add_blocks(
        &self,
        state: &[Row],
        stressed: Option<&[Row]>,
        pattern: &BlockPattern,
        blocks: &mut [Block],
    ) {
        self.turns.iter().for_each(|turn| turn.add_blocks(state, stressed, pattern, blocks));
        for piece in &self.pieces {
            let there = stressed.map(|state| piece.placement(state));
            let tangent = piece.bar.tangent(&piece.placement(state), there.as_ref()) * piece.length;
            let shares = piece.shares();
            for (i, j) in [(0, 0), (1, 0), (1, 1)] {
                let ends = [piece.ends[i], piece.ends[j]];
                // The lesser end comes first: blocks are those of the greater with it.
                let Some(number) = pattern.find(ends[0], ends[1]) else { continue };
                let block = &mut blocks[number];
                let parts = |[x1, d, d1]: [f64; 3]| [(0, 0, x1), (3, 3, d), (3, 6, d1)];
                for (row, from, one) in parts(shares[i]) {
                    for (column, beside, two) in parts(shares[j]) {
                        for k in 0..3 {
                            for l in 0..3 {
                                block[row + k][column + l] += one * two * tangent[(from + k, beside + l)];
                            }
                        }
                    }
                }
            }
        }
    }

    fn at(&self, particle: usize) -> Option<&Turning> {
        let place = self.turning.binary_search_by_key(&(particle as u32), |turning| turning.particle);
        place.ok().map(|place| &self.turning[place])
    }

    /// Axes across the director of a particle along which its turns have masses that are diagonal, where bars ask for some.
    pub fn axes(&self, particle: usize, d: &Vec3) -> Option<[Vec3; 2]> {
        if self.turning.is_empty() { None } else { self.at(particle)?.axes(d) }
    }

    /// Rotary inertia of modes that bars add to a director which turns along a direction \[M L²\].
    pub fn turning(&self, particle: usize, d: &Vec3, direction: impl Fn() -> Vec3) -> f64 {
        if self.turning.is_empty() {
            return 0.0;
        }
        self.at(particle).map_or(0.0, |turning| turning.along(d, &direction()))
    }

    /// Axial force and bending moment at a particle in a state, the mean of the pieces that end there; zero where none does.
    pub fn at_end(&self, state: &[Row], particle: usize) -> [f64; 2] {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for piece in self.pieces.iter().filter(|piece| piece.ends.contains(&(particle as u32))) {
            let force = piece.bears(state);
            sum = [sum[0] + force.axial, sum[1] + force.bending];
            count += 1.0;
        }
        sum.map(|sum| if count > 0.0 { sum / count } else { 0.0 })
    }

    /// The moment by which a direction in the surface is held at a particle \[F L\]; none where no bar is held, which adds no zero to any.
    pub fn held_at(&self, state: &[Row], particle: usize) -> Vec3 {
        let all = self.turns.iter().filter(|turn| turn.particles().next() == Some(particle as u32));
        all.filter_map(|turn| turn.held(state)).fold(-Vec3::zeros(), |sum, moment| sum + moment)
    }

    /// What each piece bears in a state.
    pub fn forces(&self, state: &[Row]) -> impl Iterator<Item = BarForce> {
        self.pieces.iter().map(move |piece| piece.bears(state))
    }
}

impl Shell {
    /// Axial force \[F\] and bending moment \[F L\] of stiffeners at a particle in the present state, the mean of the pieces that end there.
    pub fn bar_at(&self, particle: usize) -> [f64; 2] {
        self.stiffeners.at_end(&self.motion.state, particle)
    }

    /// What each piece of its stiffeners bears in the present state.
    pub fn bar_forces(&self) -> impl Iterator<Item = BarForce> {
        self.stiffeners.forces(&self.motion.state)
    }
}

impl Stiffener {
    fn check(&self, number: usize) -> Result<(), StiffenerError> {
        let BarSection { axial, bending, shear, torsion, gyration } = self.section;
        let lateral = self.in_surface.as_ref().map_or(1.0, |lateral| lateral.bending);
        let numbers = [
            ("the bending stiffness in the surface", lateral),
            ("the axial stiffness", axial),
            ("the bending stiffness", bending),
            ("the shear stiffness", shear),
            ("the torsional stiffness", torsion),
            ("the square of the radius of gyration", gyration),
            ("the mass by length", self.mass),
            (
                "the size of its height, where it has any,",
                if self.height == 0.0 { 1.0 } else { self.height.abs() },
            ),
        ];
        match numbers.into_iter().find(|(_, value)| !(*value > 0.0 && value.is_finite())) {
            Some((what, value)) => Err(StiffenerError::Number { number, what, value }),
            None => Ok(()),
        }
    }
}
