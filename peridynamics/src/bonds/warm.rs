//! A network that is warmed ([`super::heat`]).

use super::heat::BondHeat;
use super::network::Network;
use super::patterns::Number;

impl Network {
    /// Warms bonds by what each node would be strained by were it free, at level one \[–\]; lengths stay those of level zero. Returns the norm over
    /// nodes of what their bonds would pull with were they held, pull by pull \[F\].
    pub fn warm(&mut self, strains: &[f64]) -> f64 {
        let cold = self.take_apart().to_vec();
        let mut growth = cold.clone();
        let mut sum = 0.0;
        for (node, own) in strains.iter().enumerate() {
            let (first, family) = (self.packs_of(node).start, self.family(node));
            let mut exerts = 0.0;
            for (k, grown) in growth[first..first + family.len()].iter_mut().enumerate() {
                for (lane, other) in family.others(k).into_iter().enumerate() {
                    grown[lane] *= 0.5 * (own + strains[self.source(other as usize)]);
                    exerts += family.value(Number::Stiffness, k, lane) * grown[lane].abs();
                }
            }
            sum += exerts * exerts;
        }
        self.heat = Some(Box::new(BondHeat { cold, growth }));
        sum.sqrt()
    }

    /// Lengths as a level of heat has them, to the bit those at rest at level zero.
    pub fn expand(&mut self, level: f64) {
        let Some(heat) = &self.heat else { return };
        for (length, (cold, growth)) in
            self.patterns.lengths_mut().iter_mut().zip(heat.cold.iter().zip(&heat.growth))
        {
            *length = std::array::from_fn(|lane| cold[lane] + level * growth[lane]);
        }
    }
}
