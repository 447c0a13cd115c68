//! Sides of the box of a fluid that are one.

use fluid_sph::Periods;
use schemars::JsonSchema;
use serde::Deserialize;
use sph_core::Vec3;

/// Periodic sides of a fluid, along one axis or several: what leaves by one side comes in by the opposite one, and both see each other.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PeriodicSides {
    /// The two sides across x, a whole number of spacings apart \[L\].
    pub x: Option<[f64; 2]>,
    /// Those across y \[L\].
    pub y: Option<[f64; 2]>,
    /// Those across z, of a fluid in space \[L\].
    pub z: Option<[f64; 2]>,
}

impl PeriodicSides {
    /// By axis: its sides.
    pub(crate) fn sides(&self) -> [Option<[f64; 2]>; 3] {
        [self.x, self.y, self.z]
    }

    /// As a fluid takes them.
    pub(crate) fn periods(&self) -> Periods {
        let of =
            |side: &dyn Fn([f64; 2]) -> f64| Vec3::from(self.sides().map(|sides| sides.map_or(0.0, side)));
        Periods { low: of(&|[low, _]| low), lengths: of(&|[low, high]| high - low) }
    }

    /// A vector without its components along periodic axes.
    pub(crate) fn across(&self, v: &Vec3) -> Vec3 {
        let sides = self.sides();
        Vec3::from([0, 1, 2].map(|axis| if sides[axis].is_none() { v[axis] } else { 0.0 }))
    }
}
