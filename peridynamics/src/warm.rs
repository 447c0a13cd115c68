//! A body that is warmed: by how much, and at which level.

use crate::Solid;
use crate::error::SolidError;
use crate::heat::Heat;
use crate::material::Across;

impl Solid {
    /// Warms the body: the strain αΔT that each node would have were it free of all, at level one \[–\]. Bonds have those of level zero until
    /// [`Solid::expand`]; in statics they go with the level.
    ///
    /// # Errors
    /// [`SolidError::Heat`] for plates of two sheets, bonds that yield, other than one strain a node, and those that leave nothing of a bond.
    pub fn warm(&mut self, strains: Vec<f64>) -> Result<(), SolidError> {
        if self.mechanics.yields() {
            return Err(SolidError::Heat("bonds that yield do not expand; take an elastic material"));
        }
        if strains.len() != self.len() || !strains.iter().all(|strain| strain.is_finite() && *strain > -1.0) {
            return Err(SolidError::Heat("each node has one free strain, a number above -1"));
        }
        let along = match self.across {
            // What is held across a plane pushes along it.
            Some(Across { poisson, .. }) => 1.0 + poisson,
            None => 1.0,
        };
        let scaled: Vec<f64> = strains.iter().map(|strain| along * strain).collect();
        let exerts = self.mechanics.warm(&scaled).ok_or(SolidError::Heat(
            "a plate of two sheets does not expand; take a block of bonds, or a shell",
        ))?;
        self.heat = Some(Box::new(Heat { strains, level: 0.0, exerts }));
        Ok(())
    }

    /// Gives bonds the lengths of a level of heat; nothing without heat.
    pub fn expand(&mut self, level: f64) {
        let Some(heat) = self.heat.as_mut().filter(|heat| heat.level != level) else { return };
        heat.level = level;
        self.mechanics.expand(level);
    }

    /// The greatest strain that a node would have were it free, at level one \[–\]; zero of a body that is not warmed.
    pub fn greatest_free_strain(&self) -> f64 {
        let strains = self.heat.as_ref().map_or(&[][..], |heat| &heat.strains);
        strains.iter().fold(0.0, |most, strain| most.max(strain.abs()))
    }

    /// Norm of what bonds would pull with at a level of heat were all nodes held, pull by pull \[F\].
    pub(crate) fn heat_exerts(&self, level: f64) -> f64 {
        self.heat.as_ref().map_or(0.0, |heat| heat.exerts * level.abs())
    }

    /// αΔT of a node at its present level \[–\].
    pub(crate) fn free_strain(&self, node: usize) -> f64 {
        self.heat.as_ref().map_or(0.0, |heat| heat.level * heat.strains[node])
    }
}
