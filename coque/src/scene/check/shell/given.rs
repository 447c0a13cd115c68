//! Checks of a section whose stiffness is given.

use shell_kinematics::{GivenSection, MaterialError};

use crate::scene::error::Verdict;
use crate::scene::scope::Scope;
use crate::scene::shell::section::GivenStiffness;

impl GivenStiffness {
    pub(super) fn check(&self, s: &Scope<'_>) -> Verdict {
        let at = |key: &str| format!("section.stiffness.{key}");
        s.direction(&at("axis"), self.axis)?;
        let coupling = self.coupling.unwrap_or_default();
        for (key, matrix) in
            [("membrane", &self.membrane), ("coupling", &coupling), ("bending", &self.bending)]
        {
            s.sized_all(&at(key), matrix.as_flattened())?;
        }
        s.sized_all(&at("shear"), self.shear.as_flattened())?;
        match GivenSection::new(self.matrices(), self.thickness.get()) {
            Err(MaterialError::Stiffness { what, bound }) => {
                let found = match what {
                    "shear" => format!("{:?}", self.shear),
                    "coupling" => format!("{coupling:?}"),
                    "bending" => format!("{:?}", self.bending),
                    _ => format!("{:?}", self.membrane),
                };
                let repair = match what {
                    "coupling" => {
                        "mind the units, [F] beside [F/L] of `membrane` and [F L] of `bending`, and that all three are about the same surface"
                    }
                    _ => {
                        "write rows in the order 11, 22, 12, the same numbers below the diagonal as above it"
                    }
                };
                Err(s.value(&at(what), found, bound, repair))
            }
            // The thickness keeps its bound as it is read.
            _ => Ok(()),
        }
    }
}
