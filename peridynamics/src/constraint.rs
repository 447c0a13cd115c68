//! All that the supports of one row ask of it: held directions, and a displacement along some of them.

use explicit_dynamics::{Amplitude, Instant, Step};
use sph_core::Vec3;

use crate::conditions::{Support, Supported};
use crate::error::SolidError;

/// Directions closer than this to the span of others add nothing but rounding.
const SPANNED: f64 = 1e-9;

/// What holds one row: the position of a node, or a director.
#[derive(Clone, Debug)]
pub(crate) struct Constraint {
    /// Orthonormal held directions, three slots, `count` in use.
    held: [Vec3; 3],
    count: usize,
    motions: Vec<Motion>,
    /// The row at rest \[L\].
    rest: Vec3,
}

/// A prescribed displacement.
#[derive(Clone, Debug)]
struct Motion {
    /// At level one and amplitude one \[L\].
    displacement: Vec3,
    amplitude: Amplitude,
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
                false => Constraint::of_director(at, supports),
            };
            if constraint.count > 0 {
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
        3 * self.of.len() - self.list.iter().map(|constraint| constraint.count).sum::<usize>()
    }
}

impl Constraint {
    fn free(rest: Vec3) -> Self {
        Self { held: [Vec3::zeros(); 3], count: 0, motions: Vec::new(), rest }
    }

    fn of_position(
        node: u32,
        rest: Vec3,
        supports: &[&Support],
        across: Option<Vec3>,
    ) -> Result<Self, SolidError> {
        let mut out = Self::free(rest);
        across.iter().for_each(|direction| out.hold(direction));
        for support in supports {
            if let Support::Held { displacement, .. } = support {
                displacement.iter().for_each(|direction| out.hold(&direction.normalize()));
            }
        }
        let fixed = out.count;
        for support in supports {
            let Support::Moved { direction, by, amplitude } = support else { continue };
            let displacement = direction.normalize() * *by;
            // What other supports hold must not oppose the motion.
            let along = out.held[..fixed]
                .iter()
                .map(|held| displacement.dot(held))
                .fold(0.0, |most, along| if f64::abs(along) > f64::abs(most) { along } else { most });
            if along.abs() > SPANNED * by.abs() {
                return Err(SolidError::Contradiction { node, wanted: along });
            }
            out.hold(&direction.normalize());
            out.motions.push(Motion { displacement, amplitude: amplitude.clone() });
        }
        Ok(out)
    }

    fn of_director(rest: Vec3, supports: &[&Support]) -> Self {
        let mut out = Self::free(rest);
        for support in supports {
            if let Support::Held { director, .. } = support {
                director.iter().for_each(|direction| out.hold(&direction.normalize()));
            }
        }
        out
    }

    fn hold(&mut self, direction: &Vec3) {
        let held = &self.held[..self.count];
        let rest = held.iter().fold(*direction, |rest, known| rest - known * known.dot(&rest));
        if self.count < 3 && rest.norm() > SPANNED {
            self.held[self.count] = rest.normalize();
            self.count += 1;
        }
    }

    /// Orthonormal held directions.
    pub fn held(&self) -> &[Vec3] {
        &self.held[..self.count]
    }

    /// Takes the held part out of a vector.
    #[inline]
    pub fn free_part(&self, v: [f64; 3]) -> [f64; 3] {
        let mut v = v;
        for n in self.held() {
            let along = v[0] * n.x + v[1] * n.y + v[2] * n.z;
            for k in 0..3 {
                v[k] -= along * n[k];
            }
        }
        v
    }

    /// Orthonormal directions that are free.
    pub fn free_directions(&self) -> Vec<Vec3> {
        let mut basis = self.held().to_vec();
        for axis in [Vec3::x(), Vec3::y(), Vec3::z()] {
            let rest = basis.iter().fold(axis, |rest, known| rest - known * known.dot(&rest));
            // At least one axis of three is this far from the span of one or two directions.
            if rest.norm() > 0.5 && basis.len() < 3 {
                basis.push(rest.normalize());
            }
        }
        basis.split_off(self.count)
    }

    /// Whether it prescribes a displacement.
    pub fn moves(&self) -> bool {
        !self.motions.is_empty()
    }

    /// Prescribed displacement at an instant \[L\].
    pub fn displacement(&self, at: Instant) -> Vec3 {
        let one = |motion: &Motion| motion.displacement * (at.level * motion.amplitude.value(at.time));
        self.motions.iter().map(one).sum()
    }

    /// Mean velocity of the prescribed displacement over a step \[L/T\].
    pub fn velocity(&self, step: &Step) -> Vec3 {
        (self.displacement(step.to) - self.displacement(step.from)) / step.drift()
    }

    /// Puts the held components of a row where an instant has them.
    pub fn put(&self, at: Instant, row: &mut [f64; 4]) {
        let target = self.rest + self.displacement(at);
        for n in self.held() {
            let missing = n.dot(&(target - Vec3::new(row[0], row[1], row[2])));
            (0..3).for_each(|k| row[k] += missing * n[k]);
        }
    }
}
