//! Checks of the nodes of a solid.

use crate::scene::error::{SceneError, Verdict};
use crate::scene::per_axis::PerAxis;
use crate::scene::scope::Scope;
use crate::scene::solid::SolidScene;
use crate::scene::solid::geometry::{Block, CutOut};

/// Bounds what a scene may allocate: ten million nodes in space take some fifty gigabytes.
const MOST_NODES: f64 = 1e7;

impl SolidScene {
    pub(super) fn check_geometry(&self, s: &Scope<'_>) -> Verdict {
        let mut given = Vec::new();
        given.extend(self.geometry.block.as_ref().map(|_| "block"));
        given.extend(self.geometry.arc.map(|_| "arc"));
        given.extend(self.geometry.filled.as_ref().map(|_| "filled"));
        s.exactly_one("geometry", "shape", &given, &["block", "arc", "filled"])?;
        self.check_filled(s)?;
        self.check_arc(s)?;
        self.geometry.block.as_ref().map_or(Ok(()), |block| self.check_block(block, s))?;
        self.check_layers(s)?;
        let cut_outs = self.geometry.cut_outs.iter().enumerate();
        cut_outs
            .map(|(i, cut_out)| (format!("geometry.cut_outs[{i}].{}", cut_out.word()), cut_out))
            .try_for_each(|(at, cut_out)| check_cut_out(&at, cut_out, self.dimensions(), s))
    }

    fn check_block(&self, block: &Block, s: &Scope<'_>) -> Verdict {
        let at = |key: &str| format!("geometry.block.{key}");
        let dimensions = block.lengths.len();
        if !(2..=3).contains(&dimensions) {
            let value = format!("a list of {dimensions} numbers");
            let repair = "two lengths make a plane block, three one in space";
            return Err(s.value(&at("lengths"), value, "a list of 2 or 3", repair));
        }
        check_spacing(block, s)?;
        if let Some(origin) = &block.origin {
            s.coordinates(&at("origin"), origin, dimensions)?;
        }
        self.check_thickness(block, s)?;
        let grading = block.grading.iter().flatten().map(|ratio| ratio.get());
        match block.grading {
            None => Ok(()),
            Some(_) => s.coordinates(&at("grading"), &Vec::from_iter(grading), dimensions),
        }
    }

    /// Part of a thick cylinder, whose inner face has a radius too.
    fn check_arc(&self, s: &Scope<'_>) -> Verdict {
        let Some(arc) = &self.geometry.arc else { return Ok(()) };
        let at = |key: &str| format!("geometry.arc.{key}");
        if self.galerkin().is_none() {
            let repair = "use a block, or [bodies.NAME.solid.formulation.galerkin]";
            let bound = "a block where bonds carry the solid";
            return Err(SceneError::Choice(s.fault("geometry.arc", "an arc", bound, repair)));
        }
        s.range(&at("angles"), arc.angles, 360.0)?;
        for (i, &cells) in arc.cells.iter().enumerate() {
            let repair =
                "two across and as many along as make them about as long as the arc is thick are a start";
            s.within(&at(&format!("cells[{i}]")), cells as f64, [1.0, 1000.0], repair)?;
        }
        if *arc.thickness >= 2.0 * *arc.radius {
            let bound = "less than twice the radius: the inner face has one too";
            return Err(s.value(&at("thickness"), arc.thickness, bound, "use a thinner arc, or a block"));
        }
        Ok(())
    }

    /// Nodes that fill a surface are in space, and the surface has its own holes.
    fn check_filled(&self, s: &Scope<'_>) -> Verdict {
        let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
            Err(SceneError::Choice(s.fault(key, value, bound, repair)))
        };
        if self.geometry.filled.is_none() {
            return Ok(());
        }
        if self.has_directors() {
            let bound = "a plane block of two sheets";
            let repair = "give a block of two lengths and a thickness, or use [bodies.NAME.solid.formulation.state-based]";
            return refuse("geometry.filled", "a surface that nodes fill", bound, repair);
        }
        if !self.geometry.cut_outs.is_empty() {
            let repair = "cut the hole where the surface is made, so that its volumes are exact";
            return refuse(
                "geometry.cut_outs",
                "a cut-out",
                "none beside `filled`: the surface has its own holes",
                repair,
            );
        }
        Ok(())
    }

    fn check_thickness(&self, block: &Block, s: &Scope<'_>) -> Verdict {
        let path = "geometry.block.thickness";
        match block.thickness {
            Some(_) if block.lengths.len() == 2 => Ok(()),
            Some(_) => {
                let repair = "remove it, or give two lengths for a plane block";
                let bound = "none beside three lengths";
                Err(SceneError::Choice(s.fault(path, "a thickness", bound, repair)))
            }
            None if self.has_directors() && block.lengths.len() == 2 => {
                let repair = "add `thickness = …` in `geometry.block`";
                let bound = "given: it has no default for two sheets";
                Err(SceneError::Missing(s.fault(path, "nothing", bound, repair)))
            }
            None => Ok(()),
        }
    }

    /// Bonds must leave every line and plane.
    fn check_layers(&self, s: &Scope<'_>) -> Verdict {
        if self.geometry.filled.is_some() {
            return Ok(()); // what it is thick its file says
        }
        let lattice = self.lattice();
        // Lengths and spacings were checked before.
        let Ok(cells) = lattice.cells() else { return Ok(()) };
        let rows = |axis: usize| cells[axis] + usize::from(lattice.nodes == sph_core::NodePlaces::Edges);
        let Some(axis) = (0..lattice.dimensions).find(|&axis| rows(axis) < 2) else { return Ok(()) };
        let name = ["x", "y", "z"][axis];
        let repair = match lattice.dimensions {
            3 => "use a narrower spacing, or two lengths and a thickness for a plane block",
            _ => "use a narrower spacing",
        };
        let value = format!("one that gives one layer of nodes along {name}");
        let bound = "narrow enough for two: a layer alone bears nothing across it";
        Err(s.value("geometry.block.spacing", value, bound, repair))
    }
}

fn check_spacing(block: &Block, s: &Scope<'_>) -> Verdict {
    let path = "geometry.block.spacing";
    match &block.spacing {
        PerAxis::Same(spacing) => s.positive(path, *spacing)?,
        PerAxis::Each(list) => {
            s.coordinates(path, list, block.lengths.len())?;
            for (i, &spacing) in list.iter().enumerate() {
                s.positive(&format!("{path}[{i}]"), spacing)?;
            }
        }
    }
    let nodes: f64 =
        block.lengths.iter().enumerate().map(|(i, l)| (l.get() / block.spacing.along(i)).max(1.0)).product();
    if nodes <= MOST_NODES {
        return Ok(());
    }
    let bound = format!("wide enough for at most {MOST_NODES:e} nodes");
    Err(s.value(path, format!("one that asks for {nodes:.3e} nodes"), &bound, "use a wider spacing"))
}

fn check_cut_out(at: &str, cut_out: &CutOut, dimensions: usize, s: &Scope<'_>) -> Verdict {
    let at = |key: &str| format!("{at}.{key}");
    match cut_out {
        CutOut::Ball(ball) => s.coordinates(&at("centre"), &ball.centre, dimensions),
        CutOut::Cylinder(cylinder) => {
            s.sized_all(&at("point"), &cylinder.point)?;
            s.direction(&at("axis"), cylinder.axis)
        }
        CutOut::Box(cuboid) => {
            s.coordinates(&at("min"), &cuboid.min, dimensions)?;
            s.coordinates(&at("max"), &cuboid.max, dimensions)?;
            if cuboid.min.iter().zip(&cuboid.max).all(|(min, max)| min <= max) {
                return Ok(());
            }
            let value = format!("{:?} to {:?}", cuboid.min, cuboid.max);
            let repair = "swap the coordinates";
            Err(s.value(&at("min"), value, "min ≤ max in every coordinate", repair))
        }
        CutOut::Polygon(polygon) => {
            for (i, corner) in polygon.corners.iter().enumerate() {
                s.sized_all(&at(&format!("corners[{i}]")), corner)?;
            }
            if polygon.corners.len() >= 3 {
                return Ok(());
            }
            let value = format!("a list of {}", polygon.corners.len());
            Err(s.value(&at("corners"), value, "at least three corners", "add corners, in order"))
        }
    }
}
