//! Sets of bodies that are glued to the surfaces of others: from the scene's words to what acts between systems.

use std::collections::{BTreeMap, BTreeSet};

use contact::{Glue, Glued, Hold};
use sph_core::Vec3;

use super::directors::{Directors, Said, Unheld};
use super::faces::Faces;
use super::joints::{SetsOfBodies, distinct, members, moved_on};
use super::layout::Layout;
use super::near::Near;
use crate::bodies::GlueNow;
use crate::scene::error::SceneError;
use crate::scene::glued::{GlueInScene, glued};
use crate::scene::{Analysis, Scene};

/// Share of the square of the fastest motion of all bodies that glue may add in time: steps shorten by 1/√1.2, as by contact.
const IN_TIME: f64 = 0.2;

/// A set of one body glued to the surface of another.
#[derive(Clone)]
pub(in crate::bodies) struct GluedBodies {
    /// The set with its body, and the other body.
    names: [String; 2],
    /// Particles that take part, by body.
    particles: Vec<Vec<u32>>,
    /// Where they are at rest \[L\].
    rest: Vec<[f64; 3]>,
    glue: Glue,
    /// Number of particles that are glued.
    count: usize,
    /// Spacing of the bodies \[L\].
    spacing: f64,
    factor: f64,
    /// Places last evaluated, and their energy \[F L\].
    places: Vec<[f64; 3]>,
    energy: f64,
}

impl explicit_dynamics::Interaction for GluedBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces)
    }

    fn resist(&self, places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        self.glue.resist(places, motion, forces);
    }

    fn fastest(&self, masses: &[f64]) -> f64 {
        self.glue.fastest(&self.rest, masses)
    }
}

impl implicit_statics::Interaction for GluedBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn pairs(&self) -> Vec<[usize; 2]> {
        self.glue.pairs().to_vec()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces)
    }

    fn stiffness(&self, places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.glue.stiffness(places, blocks);
    }

    fn is_led(&self) -> bool {
        true
    }

    fn stressed(&self, here: &[[f64; 3]], there: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.glue.stressed(here, there, blocks);
    }
}

/// What glue of a scene is found from.
pub(super) struct Bodies<'a> {
    pub scene: &'a Scene,
    pub layout: &'a Layout,
    pub sets: &'a SetsOfBodies,
    /// Surfaces of those that are glued, by name.
    pub faces: &'a BTreeMap<String, Faces>,
}

impl Bodies<'_> {
    /// All glue of the scene, as stiff as it is at rest.
    ///
    /// # Errors
    /// [`SceneError::Set`] for a set without particles or too far from the other body, or that a support moves in an analysis
    /// that was not tried with it.
    pub fn glued(&self) -> Result<Vec<GluedBodies>, SceneError> {
        if self.scene.glue.is_empty() {
            return Ok(Vec::new());
        }
        glued(self.scene)?.iter().map(|own| self.one(own)).collect()
    }

    fn one(&self, glue: &GlueInScene<'_>) -> Result<GluedBodies, SceneError> {
        let (layout, (body, set)) = (self.layout, glue.on);
        let points = distinct(layout, members(layout, self.sets, body, set));
        let refuse = |key: &str, value: &str, bound: &str, repair: &str| {
            let fault = self.scene.source.fault(&format!("{}.{key}", glue.path), value, bound, repair);
            Err(SceneError::Set(fault))
        };
        let on = format!("\"{}\"", glue.own.on);
        let both = [self.faces.get(body), self.faces.get(&glue.own.to)];
        let numbers = [body, &glue.own.to].map(|name| layout.names.iter().position(|known| known == name));
        let ([Some(own), Some(other)], [Some(of), Some(to)]) = (both, numbers) else {
            return refuse("on", &on, "of a body with a surface", "name a shell or a solid");
        };
        if points.is_empty() {
            return refuse("on", &on, "which has no particle", "name another set of that body");
        }
        let first = layout.particles[to].start as u32;
        let cells: Vec<Vec<u32>> = other
            .cells
            .iter()
            .map(|cell| cell.corners[..usize::from(cell.count)].iter().map(|a| first + a).collect())
            .collect();
        if cells.is_empty() {
            let value = format!("\"{}\"", glue.own.to);
            return refuse(
                "to",
                &value,
                "which has no cells to glue to",
                "glue a set of it to the other body",
            );
        }
        let spacing = own.spacing.max(other.spacing);
        let bound = spacing + own.half + other.half;
        let at = |a: u32| layout.rest[a as usize];
        let near = Near::new(&cells, &layout.rest, bound, other.stiffness.is_finite());
        let rest = &layout.rest[layout.particles[of].clone()];
        let before = layout.particles[of].start as u32;
        let set: Vec<u32> = points.iter().map(|point| point - before).collect();
        let areas = own.areas(&set, rest);
        // Both sides give way, one after the other.
        let directors = other.directors.as_ref().filter(|_| glue.own.follow.is_some());
        let of_other = directors.map_or(other.stiffness, |directors| directors.stiffness);
        let stiffness = self.factor(glue) / (1.0 / own.stiffness + 1.0 / of_other);
        let raised = |directors: &Directors, x: &Vec3| {
            let raised = near.raised(x, |a| directors.at[(a - first) as usize]);
            raised.map(|own| own.numbered_from(first))
        };
        let mut means = match directors {
            Some(directors) => directors
                .means((&own.cells, &set), (rest, other.spacing), |x| raised(directors, x))
                .map_err(|(x, why)| self.unheld(glue, &x, &why))?,
            None => BTreeMap::new(),
        };
        let mut found = Vec::new();
        for (&point, area) in points.iter().zip(areas) {
            if area == 0.0 {
                let x = at(point);
                let value = format!("{on} with a particle at ({:.4}, {:.4}, {:.4})", x.x, x.y, x.z);
                let repair = "name a set on a face of the body, such as \"body.x0\" or a box round its skin";
                return refuse(
                    "on",
                    &value,
                    "which must lie on the surface of the body: what is inside has no area to glue",
                    repair,
                );
            }
            let held = match directors {
                Some(directors) => match means.remove(&(point - before)) {
                    Some(mean) => Some(mean),
                    None => {
                        let places = raised(directors, &at(point)).map(|own| directors.places(&own));
                        places.transpose().map_err(|why| self.unheld(glue, &at(point), &why))?
                    }
                },
                None => near.foot(&at(point)).map(|(nodes, foot)| {
                    (nodes.into_iter().map(|a| a - first).collect(), Hold::Surface(foot))
                }),
            };
            let Some((nodes, hold)) = held else {
                let (x, away) = (at(point), near.least(&at(point)));
                let value = format!("{on} with a particle at ({:.4}, {:.4}, {:.4})", x.x, x.y, x.z);
                let said = format!(
                    "which must lie within {bound:.4e} of a face of `{}`, a spacing and half of both thicknesses; it is {away:.4e} from it",
                    glue.own.to
                );
                let repair = "name a set that lies on the other body, or move the bodies together";
                return refuse("on", &value, &said, repair);
            };
            found.push((point, nodes, hold, stiffness * area));
        }
        // Places of the other body by its own numbers, with directors behind its particles.
        let count = layout.particles[to].len() as u32;
        let nodes =
            || found.iter().flat_map(|(_, nodes, ..): &(u32, Vec<u32>, Hold, f64)| nodes.iter().copied());
        let faces: Vec<u32> = nodes().map(|a| first + a % count).collect();
        self.refuse_moved([&points, &faces], to)?;
        let all = points.iter().map(|&point| (of, point - before)).chain(nodes().map(|a| (to, a)));
        let touched: Vec<(usize, u32)> = all.collect::<BTreeSet<_>>().into_iter().collect();
        let number = |place: (usize, u32)| touched.partition_point(|&other| other < place);
        let rest = |&(body, a): &(usize, u32)| -> [f64; 3] {
            let particles = layout.particles[body].clone();
            match (a as usize).checked_sub(particles.len()).zip(other.directors.as_ref()) {
                Some((a, directors)) => directors.at[a].into(),
                None => layout.rest[particles.start + a as usize].into(),
            }
        };
        let rest: Vec<[f64; 3]> = touched.iter().map(rest).collect();
        let of_body =
            |body: usize| touched.iter().filter(|place| place.0 == body).map(|place| place.1).collect();
        let particles = (0..layout.particles.len()).map(of_body).collect();
        let glued = found.into_iter().map(|(point, nodes, hold, stiffness)| Glued {
            point: number((of, point - before)),
            nodes: nodes.into_iter().map(|a| number((to, a))).collect(),
            hold,
            stiffness,
        });
        Ok(GluedBodies {
            names: [glue.own.on.clone(), glue.own.to.clone()],
            particles,
            glue: Glue::new(glued.collect(), &rest),
            places: rest.clone(),
            rest,
            count: points.len(),
            spacing,
            factor: self.factor(glue),
            energy: 0.0,
        })
    }

    /// Says why a particle cannot be held by directors.
    fn unheld(&self, glue: &GlueInScene<'_>, x: &Vec3, why: &Unheld) -> SceneError {
        let Said { key, value, bound, repair } = why.said([&glue.own.on, &glue.own.to], x);
        SceneError::Set(self.scene.source.fault(&format!("{}.{key}", glue.path), &value, &bound, repair))
    }

    fn factor(&self, glue: &GlueInScene<'_>) -> f64 {
        glue.own.stiffness.map_or(1.0, |factor| factor.get())
    }

    /// Along paths, in relaxations and buckling no support may move what is glued: none of them was tried.
    fn refuse_moved(&self, ends: [&[u32]; 2], to: usize) -> Result<(), SceneError> {
        if matches!(self.scene.analysis, Analysis::Static(_) | Analysis::Linear(_) | Analysis::Explicit(_)) {
            return Ok(());
        }
        let rigid = self.faces.get(&self.layout.names[to]).is_some_and(|faces| faces.spacing == 0.0);
        let whole = self.layout.particles[to].clone().map(|a| a as u32).collect::<Vec<_>>();
        let ends = if rigid { [ends[0], &whole[..]] } else { ends };
        let Some((path, on)) = moved_on(self.scene, ends, self.layout, self.sets)? else { return Ok(()) };
        let bound = format!(
            "whose particles are glued to another body, which {} has on particles that no support moves",
            self.scene.analysis.kind().name
        );
        let repair = "move another set, or use [analysis.static], linear or explicit";
        let fault = self.scene.source.fault(&path, &format!("\"{on}\""), &bound, repair);
        Err(SceneError::Set(fault))
    }
}

impl GluedBodies {
    /// A line for the summary.
    pub fn line(&self) -> String {
        let [on, to] = &self.names;
        let each = self.stiffness() / self.count as f64;
        format!("glue of {on} to {to}: {} particles, {each:.3e} each by distance", self.count)
    }

    /// Takes the present places of bodies for those at rest; `places` gives those of some particles of a body \[L\].
    pub fn settle(&mut self, mut places: impl FnMut(usize, &[u32], &mut [[f64; 3]])) {
        let mut first = 0;
        for (body, particles) in self.particles.iter().enumerate() {
            places(body, particles, &mut self.rest[first..first + particles.len()]);
            first += particles.len();
        }
        self.places.copy_from_slice(&self.rest);
        self.glue.settle(&self.rest);
    }

    /// Makes it as stiff as steps in time bear, beside bodies whose fastest motion has this square \[1/T²\]; `masses` gives those of some
    /// particles of a body \[M\].
    pub fn pace(&mut self, fastest: f64, masses: impl Fn(usize, &[u32]) -> Vec<f64>) {
        let each = self.particles.iter().enumerate();
        let masses: Vec<f64> = each.flat_map(|(body, particles)| masses(body, particles)).collect();
        let swinging = self.glue.swinging(&self.rest, &masses);
        self.glue.stiffen(|number, _| swinging[number]);
        let scale = IN_TIME * self.factor * fastest / self.glue.fastest(&self.rest, &masses);
        self.glue.stiffen(|_, own| own * scale);
    }

    /// Stiffnesses of all its particles, summed \[F/L\].
    fn stiffness(&self) -> f64 {
        self.glue.glued().iter().map(|own| own.stiffness).sum()
    }

    /// How far a particle of a body is from where it is held \[L\]; zero for one that is not glued.
    pub fn gap(&self, body: usize, particle: u32) -> Vec3 {
        let Some(at) = self.particles.get(body).and_then(|own| own.binary_search(&particle).ok()) else {
            return Vec3::zeros();
        };
        let place = self.particles[..body].iter().map(Vec::len).sum::<usize>() + at;
        let own = self.glue.glued().iter().position(|glued| glued.point == place);
        own.map_or_else(Vec3::zeros, |number| self.glue.gap(number, &self.places))
    }

    /// What it does now.
    pub fn now(&self) -> GlueNow {
        let gaps = (0..self.glue.glued().len()).map(|number| self.glue.gap(number, &self.places).norm());
        let [on, to] = &self.names;
        GlueNow {
            between: format!("`{on}` to `{to}`"),
            particles: self.count,
            stiffness: self.stiffness(),
            gap: gaps.fold(0.0, f64::max),
            spacing: self.spacing,
            energy: self.energy,
        }
    }

    fn evaluated(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.places.copy_from_slice(places);
        self.energy = self.glue.evaluate(places, forces);
        self.energy
    }
}
