//! All that the supports of one row ask of it: held directions, and a displacement along some of them.

use explicit_dynamics::{Amplitude, Instant, Step};
use sph_core::{HeldDirections, Vec3, rotated};

use crate::conditions::{Support, Supported};
use crate::error::SolidError;

/// A displacement along a held direction below this share of it is rounding.
const ROUNDING: f64 = 1e-9;

/// What holds one row: the position of a node, or a director.
#[derive(Clone, Debug)]
pub(crate) struct Constraint {
    pub held: HeldDirections,
    motions: Vec<Motion>,
    /// The row at rest \[L\].
    rest: Vec3,
}

/// A prescribed displacement.
#[derive(Clone, Debug)]
struct Motion {
    way: Way,
    amplitude: Amplitude,
}

/// Where a motion leads a row.
#[derive(Clone, Debug)]
enum Way {
    /// A displacement at level one and amplitude one \[L\].
    Straight(Vec3),
    /// `R(angle) arm − arm`: the arm from a point of the axis \[L\], the angle at level one and amplitude one as a vector \[rad\].
    Turn { arm: Vec3, angle: Vec3 },
}

impl Way {
    /// The way after a part of it \[L\].
    fn after(&self, part: f64) -> Vec3 {
        match self {
            Self::Straight(displacement) => displacement * part,
            Self::Turn { arm, angle } => rotated(arm, &(angle * part)) - arm,
        }
    }

    /// Its derivative with respect to that part \[L\].
    fn rate(&self, part: f64) -> Vec3 {
        match self {
            Self::Straight(displacement) => *displacement,
            Self::Turn { arm, angle } => angle.cross(&rotated(arm, &(angle * part))),
        }
    }
}

/// The constraint of each row, by numbers one up, zero for a free one.
#[derive(Clone, Debug)]
pub(crate) struct Constraints {
    pub of: Vec<u32>,
    pub list: Vec<Constraint>,
}

impl Constraints {
    /// Joins all supports. Rows are the nodes and behind them, of `directors`, their directors; `across` is held everywhere.
    ///
    /// # Errors
    /// [`SolidError::EmptySet`], [`SolidError::NoSuchNode`], [`SolidError::Contradiction`].
    pub fn new(
        rest: &[Vec3],
        nodes: usize,
        supports: &[Supported],
        across: Option<Vec3>,
    ) -> Result<Self, SolidError> {
        let mut asked: Vec<Vec<&Support>> = vec![Vec::new(); nodes];
        for Supported { nodes: set, support } in supports {
            if set.is_empty() {
                return Err(SolidError::EmptySet("a support"));
            }
            for &node in set {
                let list = asked.get_mut(node as usize);
                list.ok_or(SolidError::NoSuchNode { what: "a support", node, count: nodes })?.push(support);
            }
        }
        let mut out = Self { of: vec![0; rest.len()], list: Vec::new() };
        for (row, &at) in rest.iter().enumerate() {
            let supports = &asked[row % nodes];
            let constraint = match row < nodes {
                true => Constraint::of_position(row as u32, at, supports, across)?,
                false => Constraint::of_director((row - nodes) as u32, at, supports)?,
            };
            if !constraint.held.basis().is_empty() {
                out.list.push(constraint);
                out.of[row] = out.list.len() as u32;
            }
        }
        Ok(out)
    }

    /// That of a row, if it has one.
    #[inline]
    pub fn get(&self, row: usize) -> Option<&Constraint> {
        match self.of[row] {
            0 => None,
            number => Some(&self.list[number as usize - 1]),
        }
    }

    /// Rows with a prescribed displacement.
    pub fn moved(&self) -> impl Iterator<Item = (usize, &Constraint)> {
        (0..self.of.len()).filter_map(|row| Some((row, self.get(row).filter(|c| !c.motions.is_empty())?)))
    }

    /// Degrees of freedom that nothing holds.
    pub fn dof(&self) -> usize {
        3 * self.of.len() - self.list.iter().map(|constraint| constraint.held.basis().len()).sum::<usize>()
    }
}

impl Constraint {
    fn free(rest: Vec3) -> Self {
        Self { held: HeldDirections::default(), motions: Vec::new(), rest }
    }

    fn of_position(
        node: u32,
        rest: Vec3,
        supports: &[&Support],
        across: Option<Vec3>,
    ) -> Result<Self, SolidError> {
        let mut out = Self::free(rest);
        across.iter().for_each(|direction| out.held.hold(direction));
        for support in supports {
            if let Support::Held { displacement, .. } = support {
                displacement.iter().for_each(|direction| out.held.hold(&direction.normalize()));
            }
        }
        let fixed = out.held;
        // What other supports hold must not oppose the motion.
        let opposed = |way: Vec3, size: f64| {
            let along = fixed
                .basis()
                .iter()
                .map(|held| way.dot(held))
                .fold(0.0, |most, along| if f64::abs(along) > f64::abs(most) { along } else { most });
            match along.abs() > ROUNDING * size {
                true => Err(SolidError::Contradiction { node, wanted: along }),
                false => Ok(()),
            }
        };
        for support in supports {
            match support {
                Support::Held { .. } => {}
                Support::Moved { direction, by, amplitude } => {
                    let displacement = direction.normalize() * *by;
                    opposed(displacement, by.abs())?;
                    out.held.hold(&direction.normalize());
                    out.motions
                        .push(Motion { way: Way::Straight(displacement), amplitude: amplitude.clone() });
                }
                Support::Turned { axis, point, by, amplitude } => {
                    let (arm, angle) = (rest - point, axis.normalize() * *by);
                    let along = angle.cross(&arm);
                    for way in [along, axis.normalize().cross(&along)] {
                        opposed(way, along.norm())?;
                    }
                    out.turn(Way::Turn { arm, angle }, amplitude);
                }
            }
        }
        // What turns about two axes is no body that turns.
        let turns = supports.iter().filter(|support| matches!(support, Support::Turned { .. })).count();
        if turns > 1 { Err(SolidError::TwoTurns(node)) } else { Ok(out) }
    }

    /// Prescribes all of a row by a turn.
    fn turn(&mut self, way: Way, amplitude: &Amplitude) {
        [Vec3::x(), Vec3::y(), Vec3::z()].iter().for_each(|direction| self.held.hold(direction));
        self.motions.push(Motion { way, amplitude: amplitude.clone() });
    }

    fn of_director(node: u32, rest: Vec3, supports: &[&Support]) -> Result<Self, SolidError> {
        let mut out = Self::free(rest);
        let held = |support: &&Support| match support {
            Support::Held { director, .. } => director.clone(),
            _ => Vec::new(),
        };
        let held: Vec<Vec3> = supports.iter().flat_map(held).map(|along| along.normalize()).collect();
        for support in supports {
            match support {
                Support::Held { director, .. } => {
                    director.iter().for_each(|direction| out.held.hold(&direction.normalize()));
                }
                Support::Moved { .. } => {}
                Support::Turned { axis, by, amplitude, .. } => {
                    let angle = axis.normalize() * *by;
                    let along = angle.cross(&rest);
                    for way in [along, axis.normalize().cross(&along)] {
                        if let Some(wanted) =
                            held.iter().map(|held| way.dot(held)).find(|w| w.abs() > ROUNDING * by.abs())
                        {
                            return Err(SolidError::Contradiction { node, wanted });
                        }
                    }
                    out.turn(Way::Turn { arm: rest, angle }, amplitude);
                }
            }
        }
        Ok(out)
    }

    /// Whether it prescribes a displacement.
    pub fn moves(&self) -> bool {
        !self.motions.is_empty()
    }

    /// Prescribed displacement at an instant \[L\].
    pub fn displacement(&self, at: Instant) -> Vec3 {
        let one = |motion: &Motion| motion.way.after(at.level * motion.amplitude.value(at.time));
        self.motions.iter().map(one).sum()
    }

    /// Its derivative with respect to the level, without time \[L\].
    pub fn rate(&self, level: f64) -> Vec3 {
        let one = |motion: &Motion| {
            let course = motion.amplitude.value(0.0);
            motion.way.rate(level * course) * course
        };
        self.motions.iter().map(one).sum()
    }

    /// Mean velocity of the prescribed displacement over a step \[L/T\].
    pub fn velocity(&self, step: &Step) -> Vec3 {
        (self.displacement(step.to) - self.displacement(step.from)) / step.drift()
    }

    /// Puts the held components of a row where an instant has them.
    pub fn put(&self, at: Instant, row: &mut [f64; 4]) {
        self.held.put(&(self.rest + self.displacement(at)), row);
    }
}
