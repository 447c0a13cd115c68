//! What a row of the curve is made of: columns measured on sets of particles.

use sph_core::Vec3;
use sph_shell::Shell;

use crate::bodies::shell::build::Model;
use crate::results::curve::Column;
use crate::scene::units::{Quantity, Units};
use crate::scene::{Analysis, Measured, Scene, Take};

/// The columns that every curve of the analysis has, with their units, and those of the scene's own gauges.
///
/// `level` is a force where a prescribed motion drives an analysis that finds the load, and the share of that motion
/// where the level is given.
pub(crate) fn columns(model: &Model) -> Vec<Column> {
    let Scene { analysis, units, .. } = &model.scene;
    let force = model.driven.is_some() && !matches!(analysis, Analysis::Static(_) | Analysis::Linear(_));
    let quantity = |name: &str| match name {
        "time" => Quantity::Time,
        "level" if force => Quantity::Force,
        "level" | "iterations" | "negative_pivots" | "mode" | "residual" => Quantity::Ratio,
        "circular_frequency" | "frequency" => Quantity::Rate,
        _ => Quantity::Energy,
    };
    let unit = |name: &str| units.symbol(quantity(name));
    let kind = analysis.kind();
    let always = kind.columns.iter().map(|&name| Column { name: name.into(), unit: unit(name) });
    let own = model.gauges.iter().filter(|_| !kind.gives_modes).map(|gauge| gauge.column(units));
    always.chain(own).collect()
}

/// One column, measured.
#[derive(Clone, Debug)]
pub(crate) struct Gauge {
    pub(crate) name: String,
    pub(crate) of: Measured,
    pub(crate) particles: Vec<u32>,
    /// Unit vector in the turned frame.
    pub(crate) direction: Vec3,
    /// What is taken of the values of the particles.
    pub(crate) take: Take,
    pub(crate) factor: f64,
    /// For a rotation: last director and accumulated angle \[rad\] of each particle.
    pub(crate) turned: Vec<(Vec3, f64)>,
}

impl Gauge {
    pub(crate) fn column(&self, units: &Units) -> Column {
        let quantity = match self.of {
            Measured::Displacement | Measured::Position => Quantity::Length,
            Measured::Reaction => Quantity::Force,
            Measured::Rotation => Quantity::Angle,
            Measured::Director => Quantity::Ratio,
        };
        Column { name: self.name.clone(), unit: units.symbol(quantity) }
    }

    /// The value now.
    ///
    /// A rotation must be read at least twice a turn, since it is counted on from the last reading.
    pub(crate) fn read(&mut self, shell: &Shell) -> f64 {
        let values = self.values(shell);
        self.taken(&values)
    }

    /// Numbers that go linearly with a small motion: the value now, or, of a largest or least, the values of all particles.
    pub(crate) fn parts(&mut self, shell: &Shell) -> Vec<f64> {
        match self.take {
            Take::Mean | Take::Sum => vec![self.read(shell)],
            Take::Max | Take::Min => self.values(shell),
        }
    }

    /// Number of [`Gauge::parts`].
    pub(crate) fn part_count(&self) -> usize {
        match self.take {
            Take::Mean | Take::Sum => 1,
            Take::Max | Take::Min => self.particles.len(),
        }
    }

    /// The value of which these are the [`Gauge::parts`].
    pub(crate) fn of_parts(&self, parts: &[f64]) -> f64 {
        match self.take {
            Take::Mean | Take::Sum => parts.iter().sum(),
            Take::Max | Take::Min => self.taken(parts),
        }
    }

    /// What is taken of the values of the particles.
    fn taken(&self, values: &[f64]) -> f64 {
        match self.take {
            Take::Mean => self.factor * values.iter().sum::<f64>() / values.len() as f64,
            Take::Sum => self.factor * values.iter().sum::<f64>(),
            Take::Max => self.factor * values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            Take::Min => self.factor * values.iter().copied().fold(f64::INFINITY, f64::min),
        }
    }

    /// The value of each particle now.
    fn values(&mut self, shell: &Shell) -> Vec<f64> {
        if self.of == Measured::Rotation {
            self.count_on(shell);
        }
        let one = |i: usize| {
            let a = self.particles[i] as usize;
            match self.of {
                Measured::Displacement => shell.displacement(a).dot(&self.direction),
                Measured::Position => shell.position(a).dot(&self.direction),
                Measured::Reaction => shell.reaction(a).dot(&self.direction),
                Measured::Director => shell.director(a).dot(&self.direction),
                Measured::Rotation => self.turned[i].1,
            }
        };
        (0..self.particles.len()).map(one).collect()
    }

    fn count_on(&mut self, shell: &Shell) {
        let directors = self.particles.iter().map(|&a| shell.director(a as usize));
        if self.turned.is_empty() {
            self.turned = directors.map(|d| (d, 0.0)).collect();
            return;
        }
        for ((last, angle), now) in self.turned.iter_mut().zip(directors) {
            *angle += turn(last, &now, &self.direction);
            *last = now;
        }
    }
}

/// Angle from `a` to `b` about `axis`, from −π to π \[rad\].
fn turn(a: &Vec3, b: &Vec3, axis: &Vec3) -> f64 {
    let across = |v: &Vec3| v - axis * axis.dot(v);
    let (a, b) = (across(a), across(b));
    libm::atan2(axis.dot(&a.cross(&b)), a.dot(&b))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turn_has_the_sign_of_the_axis() {
        let (x, y, z) = (Vec3::x(), Vec3::y(), Vec3::z());
        assert!((turn(&x, &y, &z) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        assert!((turn(&x, &y, &-z) + std::f64::consts::FRAC_PI_2).abs() < 1e-15);
        // The part along the axis does not count.
        assert!((turn(&(x + z), &(y - z), &z) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
