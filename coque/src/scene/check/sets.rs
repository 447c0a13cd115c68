//! Checks of named sets, and of names of sets.

use crate::scene::error::SceneError;
use crate::scene::problem::{BodyScene, Scene};
use crate::scene::sets::{BUILT_IN, OF_FLUIDS, OF_SOLIDS, OF_WALLS, Region};
use crate::scene::source::suggest;
use crate::scene::walls::WallGeometry;

type Checked = Result<(), SceneError>;

impl Scene {
    pub(super) fn check_sets(&self) -> Checked {
        let s = &self.scope();
        let (built_in, solid) = (self.built_in(), self.as_solid().is_some());
        for (name, Region { of, nearest, inside, plane, layer }) in &self.sets {
            let at = format!("sets.{name}");
            if let Some(of) = of {
                s.word(&format!("{at}.of"), of, &Vec::from_iter(self.bodies.keys().map(String::as_str)))?;
            }
            if built_in.contains(&name.as_str()) {
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
            given.extend(layer.as_ref().map(|_| "layer"));
            let known = ["nearest", "box", "plane", "layer"];
            s.exactly_one(&at, "region", &given, if solid { &known } else { &known[..3] })?;
            if let Some(point) = nearest {
                s.sized_all(&format!("{at}.nearest"), point)?;
            }
            if let Some(plane) = plane {
                s.sized_all(&format!("{at}.plane.point"), &plane.point)?;
                s.direction(&format!("{at}.plane.normal"), plane.normal)?;
                s.positive(&format!("{at}.plane.within"), plane.within.unwrap_or(1.0))?;
            }
            if let Some(layer) = layer {
                let at = |key: &str| format!("{at}.layer.{key}");
                if !solid {
                    let found = "a layer under a face";
                    let bound = match self.body() {
                        BodyScene::Shell(_) => "`nearest`, `box` or `plane` on a shell",
                        _ => "`nearest`, `box` or `plane` here",
                    };
                    let fault = s.fault(&at("face"), found, bound, "use a box: only solids have layers");
                    return Err(SceneError::Choice(fault));
                }
                s.word(&at("face"), &layer.face, &built_in[1..])?;
                s.positive(&at("depth"), layer.depth)?;
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

    /// Sets that the body has of itself.
    pub(super) fn built_in(&self) -> &'static [&'static str] {
        match self.body() {
            BodyScene::Shell(_) => &BUILT_IN,
            // In a plane all nodes lie on z0 and z1: only two sheets have a use for that.
            BodyScene::Solid(solid) if solid.is_plane() => &OF_SOLIDS[..5],
            BodyScene::Solid(_) => &OF_SOLIDS,
            BodyScene::Fluid(_) => &OF_FLUIDS,
            BodyScene::Walls(walls) => match &walls.geometry {
                WallGeometry::Basin(basin) => &OF_WALLS[..=2 * basin.min.len()],
                _ => &OF_WALLS[..1],
            },
        }
    }

    /// Refuses a name that is no set; those of a mesh are known when its file has been read.
    pub(super) fn check_set_name(&self, path: &str, name: &str) -> Checked {
        if self.as_shell().is_some_and(|shell| shell.geometry.mesh().is_some()) {
            return Ok(());
        }
        let own = self.sets.keys().map(String::as_str);
        let known: Vec<&str> = self.built_in().iter().copied().chain(own).collect();
        if known.contains(&name) && !self.is_open_side(name) {
            return Ok(());
        }
        let known: Vec<&str> = known.into_iter().filter(|known| !self.is_open_side(known)).collect();
        let repair = suggest(name, &known);
        Err(SceneError::Set(self.scope().fault(path, &format!("\"{name}\""), "which is no set", &repair)))
    }

    /// Whether a name is that of a side of a basin without a wall.
    fn is_open_side(&self, name: &str) -> bool {
        match self.body() {
            BodyScene::Walls(walls) => match &walls.geometry {
                WallGeometry::Basin(basin) => basin.open.iter().any(|open| open == name),
                _ => false,
            },
            _ => false,
        }
    }
}
