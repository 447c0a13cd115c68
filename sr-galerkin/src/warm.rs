//! A body that is warmed: by how much, at which level, and what that exerts.

use crate::body::Galerkin;
use crate::heat::Heat;

/// Free strain of the half step by which the derivative by the level is found: its square, 1e-10, is left of it.
const STEP: f64 = 1e-5;

impl Galerkin {
    /// Warms the body: the strain that each point of the quadrature would have were it free, at level one \[–\]; it goes with the level.
    pub fn warm(&mut self, strains: Vec<f64>) {
        let pull =
            self.material.moduli.stress(&[1.0, 1.0, 1.0, 0.0, 0.0, 0.0])[..3].iter().sum::<f64>() / 3.0;
        let mut sums = vec![0.0; self.space.integrals.len()];
        for (cell, own) in self.space.cells.iter().zip(strains.chunks(self.space.points)) {
            for (point, (volume, strain)) in cell.volumes.iter().zip(own).enumerate() {
                for (at, &node) in cell.nodes.iter().enumerate() {
                    let square: f64 = (0..3).map(|k| cell.gradient(point, k)[at].powi(2)).sum();
                    sums[node as usize] += volume * pull * strain.abs() * square.sqrt();
                }
            }
        }
        let exerts = sums.iter().map(|own| own * own).sum::<f64>().sqrt();
        self.heat = Some(Heat { stretch: vec![1.0; strains.len()], strains, exerts });
        self.evaluated = false;
    }

    /// The greatest strain that a point would have were it free, at level one \[–\]; zero of a body that is not warmed.
    pub fn greatest_free_strain(&self) -> f64 {
        let strains = self.heat.as_ref().map_or(&[][..], |heat| &heat.strains);
        strains.iter().fold(0.0, |most, strain| most.max(strain.abs()))
    }

    /// Norm of what stresses of heat exert at a level \[F\].
    pub(crate) fn heat_exerts(&self, level: f64) -> f64 {
        self.heat.as_ref().map_or(0.0, |heat| heat.exerts * level.abs())
    }

    /// Stretches the points as a level has it.
    pub(crate) fn stretch(&mut self, level: f64) {
        if let Some(heat) = &mut self.heat {
            heat.stretch.iter_mut().zip(&heat.strains).for_each(|(s, strain)| *s = 1.0 + level * strain);
        }
    }

    /// Takes off forces on parameters by what heat adds to the internal ones by the level, the parameters staying \[F\]: a central difference.
    pub(crate) fn take_heat_rate(&mut self, level: f64) {
        let Some(heat) = &self.heat else { return };
        let most = heat.strains.iter().fold(0.0_f64, |most, strain| most.max(strain.abs()));
        if most == 0.0 {
            return;
        }
        let step = STEP / most;
        for (at, sign) in [(level + step, -0.5), (level - step, 0.5)] {
            self.stretch(at);
            self.sweep();
            let internal = &self.internal;
            self.external.iter_mut().zip(internal).for_each(|(out, force)| *out += sign / step * force);
        }
        self.stretch(level);
        self.evaluated = false;
    }

    /// Stretches of the points of a cell; none of a body that is not warmed.
    pub(crate) fn stretches(&self, cell: usize) -> Option<&[f64]> {
        let points = cell * self.space.points..(cell + 1) * self.space.points;
        self.heat.as_ref().map(|heat| &heat.stretch[points])
    }
}
