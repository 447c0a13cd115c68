//! What is enclosed: a gas or a liquid, its pressure over its volume.

/// A gas or a liquid, whose pressure is that over the surroundings \[F/L²\].
///
/// ```text
/// gas      p = (p_a + a p₀) (V₀/V)^κ − p_a          p₀ the pressure of the whole content in the volume at rest V₀
/// liquid   p = B (V₀ + a ΔV − V)/V                   filled to the brim at rest, ΔV pumped in
/// ```
///
/// a is the share of the whole content that is in: the load's factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Content {
    /// A gas that keeps `(p_a + p) V^κ`.
    Gas {
        /// p₀ \[F/L²\].
        pressure: f64,
        /// p_a, the pressure of the surroundings, from which p counts \[F/L²\]; a gas of that pressure fills it before any is added.
        ambient: f64,
        /// κ: one at a constant temperature, the ratio of specific heats without exchange of heat \[–\].
        exponent: f64,
    },
    /// A liquid that fills it.
    Liquid {
        /// ΔV, what is pumped in by volume without pressure \[L³\].
        added: f64,
        /// B, pressure over the relative change of volume \[F/L²\].
        bulk_modulus: f64,
    },
}

/// Volumes of what is enclosed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Volumes {
    /// The present one \[L³\].
    pub now: f64,
    /// The one at rest \[L³\].
    pub rest: f64,
}

impl Content {
    /// Pressure \[F/L²\], and its derivative by the volume, which is negative \[F/L⁵\].
    pub fn pressure(&self, share: f64, volumes: Volumes) -> [f64; 2] {
        let Volumes { now, rest } = volumes;
        match *self {
            Self::Gas { pressure, ambient, exponent } => {
                let absolute = (ambient + share * pressure) * libm::pow(rest / now, exponent);
                [absolute - ambient, -exponent * absolute / now]
            }
            Self::Liquid { added, bulk_modulus } => {
                let filling = rest + share * added;
                [bulk_modulus * (filling - now) / now, -bulk_modulus * filling / (now * now)]
            }
        }
    }

    /// What a unit of the share adds to the pressure at a constant volume \[F/L²\].
    pub fn rate(&self, volumes: Volumes) -> f64 {
        let Volumes { now, rest } = volumes;
        match *self {
            Self::Gas { pressure, exponent, .. } => pressure * libm::pow(rest / now, exponent),
            Self::Liquid { added, bulk_modulus } => bulk_modulus * added / now,
        }
    }

    /// The steepest that the pressure may fall with the volume, of any share between none and the whole \[F/L⁵\].
    pub fn stiffness(&self, volumes: Volumes) -> f64 {
        [0.0, 1.0].map(|share| -self.pressure(share, volumes)[1]).into_iter().fold(0.0, f64::max)
    }

    /// Energy that it takes to bring it from the volume at rest to the present one, share constant, against the pressure \[F L\]: `−∫ p dV`.
    pub fn energy(&self, share: f64, volumes: Volumes) -> f64 {
        let Volumes { now, rest } = volumes;
        match *self {
            Self::Gas { pressure, ambient, exponent } => {
                let whole = ambient + share * pressure;
                let work = if exponent == 1.0 {
                    rest * libm::log(now / rest)
                } else {
                    (rest - now * libm::pow(rest / now, exponent)) / (exponent - 1.0)
                };
                ambient * (now - rest) - whole * work
            }
            Self::Liquid { added, bulk_modulus } => {
                let filling = rest + share * added;
                bulk_modulus * (now - rest - filling * libm::log(now / rest))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pressure, its slope, what a share adds and the energy, each the derivative that it is.
    #[test]
    fn derivatives_are_those_of_the_pressure() {
        let contents = [
            Content::Gas { pressure: 0.4, ambient: 0.1, exponent: 1.4 },
            Content::Gas { pressure: 0.4, ambient: 0.0, exponent: 1.0 },
            Content::Liquid { added: 0.7, bulk_modulus: 50.0 },
        ];
        for content in contents {
            for now in [1.1, 2.0, 3.7] {
                let (share, step) = (0.6, 1e-4);
                let at = |now: f64| Volumes { now, rest: 2.0 };
                let slope = |of: &dyn Fn(f64) -> f64| {
                    (of(-2.0 * step) - 8.0 * of(-step) + 8.0 * of(step) - of(2.0 * step)) / (12.0 * step)
                };
                let [pressure, falls] = content.pressure(share, at(now));
                let by_volume = slope(&|by| content.pressure(share, at(now + by))[0]);
                let by_share = slope(&|by| content.pressure(share + by, at(now))[0]);
                let of_energy = slope(&|by| content.energy(share, at(now + by)));
                let misses = [
                    (by_volume - falls) / falls,
                    (by_share - content.rate(at(now))) / by_share,
                    (of_energy + pressure) / falls,
                ];
                assert!(misses.iter().all(|miss| miss.abs() < 1e-9), "{content:?} {misses:?}");
                assert!(content.stiffness(at(now)) >= -falls);
                assert_eq!(content.energy(share, at(2.0)), 0.0);
            }
        }
    }
}
