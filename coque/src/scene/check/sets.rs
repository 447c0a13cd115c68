//! Checks of named sets, and of names of sets.

use crate::scene::error::SceneError;
use crate::scene::problem::Scene;
use crate::scene::sets::{BUILT_IN, Region};
use crate::scene::source::suggest;

type Checked = Result<(), SceneError>;

impl Scene {
    pub(super) fn check_sets(&self) -> Checked {
        let s = &self.scope();
        for (name, Region { of, nearest, inside, plane }) in &self.sets {
            let at = format!("sets.{name}");
            if let Some(of) = of {
                s.word(&format!("{at}.of"), of, &Vec::from_iter(self.bodies.keys().map(String::as_str)))?;
            }
            if BUILT_IN.contains(&name.as_str()) {
                let fault = s.fault(
                    &at,
                    "declared",
                    "but there is a built-in set of that name",
                    "choose another name",
                );
                return Err(SceneError::Set(fault));
            }
            let mut given = Vec::new();
            given.extend(nearest.map(|_| "nearest"));
            given.extend(inside.map(|_| "box"));
            given.extend(plane.map(|_| "plane"));
            s.exactly_one(&at, "region", &given, &["nearest", "box", "plane"])?;
            if let Some(point) = nearest {
                s.sized_all(&format!("{at}.nearest"), point)?;
            }
            if let Some(plane) = plane {
                s.sized_all(&format!("{at}.plane.point"), &plane.point)?;
                s.direction(&format!("{at}.plane.normal"), plane.normal)?;
                s.positive(&format!("{at}.plane.within"), plane.within.unwrap_or(1.0))?;
            }
            if let Some(region) = inside {
                s.sized_all(&format!("{at}.box.min"), &region.min)?;
                s.sized_all(&format!("{at}.box.max"), &region.max)?;
                if (0..3).any(|i| region.min[i] > region.max[i]) {
                    let value = format!("min {:?}, max {:?}", region.min, region.max);
                    let bound = "min ≤ max in every coordinate";
                    return Err(s.value(&format!("{at}.box"), value, bound, "swap the coordinates"));
                }
            }
        }
        Ok(())
    }

    /// Refuses a name that is no set; those of a mesh are known when its file has been read.
    pub(super) fn check_set_name(&self, path: &str, name: &str) -> Checked {
        if self.shell().geometry.mesh().is_some() {
            return Ok(());
        }
        let known: Vec<&str> = BUILT_IN.into_iter().chain(self.sets.keys().map(String::as_str)).collect();
        if known.contains(&name) {
            return Ok(());
        }
        let repair = suggest(name, &known);
        Err(SceneError::Set(self.scope().fault(path, &format!("\"{name}\""), "which is no set", &repair)))
    }
}
