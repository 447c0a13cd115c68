//! Links between sets and to the ground: from the scene's words to what acts between systems.

use std::collections::BTreeSet;

use contact::{Bears, Dashpot, Dashpots, Far, ForceCurve, Link, Links, Reach, Span};
use explicit_dynamics::Instant;
use sph_core::Vec3;

use super::joints::{SetsOfBodies, paired, places, refuse_moved};
use super::layout::Layout;
use crate::scene::Side;
use crate::scene::error::SceneError;
use crate::scene::linked::{LinkInScene, links};
use crate::scene::{Analysis, BodyScene, Scene};

/// Part of a line across the plane of a plane body beyond which it leads out of it.
const OUT_OF_PLANE: f64 = 1e-9;
const LINK: &str = "a link";
/// Part of the greatest force over the length of a link that is no force: rounding of lengths.
const TAUT: f64 = 1e-9;
/// Part of the greatest coordinate below which two ends are on one place.
const NO_LINE: f64 = 1e-12;

/// Springs, cables and gaps of a scene.
#[derive(Clone)]
pub(in crate::bodies) struct LinkedBodies {
    /// Particles at their ends, by body.
    particles: Vec<Vec<u32>>,
    links: Links,
}

/// Dashpots of a scene.
pub(in crate::bodies) struct DampedBodies {
    particles: Vec<Vec<u32>>,
    dashpots: Dashpots,
}

/// All links of a scene.
#[derive(Default)]
pub(in crate::bodies) struct AllLinks {
    springs: Option<LinkedBodies>,
    dashpots: Option<DampedBodies>,
    /// How many there are of both.
    counts: [usize; 2],
}

impl explicit_dynamics::Interaction for LinkedBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.links.evaluate(places, forces)
    }

    fn resist(&self, places: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        self.links.resist(places, motion, forces);
    }

    fn fastest(&self, masses: &[f64]) -> f64 {
        self.links.fastest(masses)
    }
}

impl implicit_statics::Interaction for LinkedBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn pairs(&self) -> Vec<[usize; 2]> {
        self.links.pairs()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.links.evaluate(places, forces)
    }

    fn stiffness(&self, places: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        self.links.stiffness(places, blocks);
    }
}

impl explicit_dynamics::Interaction for DampedBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn damps(&self) -> bool {
        true
    }

    fn see(&mut self, at: Instant, velocities: &[[f64; 3]]) {
        self.dashpots.see(at.time, velocities);
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.dashpots.evaluate(places, forces);
        0.0
    }

    fn resist(&self, _places: &[[f64; 3]], _motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
    }

    fn fastest(&self, _masses: &[f64]) -> f64 {
        0.0
    }

    fn damping(&self, masses: &[f64]) -> f64 {
        self.dashpots.fastest(masses)
    }

    fn commit(&mut self) {
        self.dashpots.step();
    }

    fn kept(&self) -> Vec<f64> {
        self.dashpots.kept()
    }

    fn take_up(&mut self, kept: &[f64], _masses: &[f64]) -> bool {
        self.dashpots.take_up(kept)
    }
}

/// What a link is made of, with its ends by particles of all.
enum Made {
    Spring { ends: Vec<Ends>, curve: ForceCurve },
    Dashpot { ends: Vec<Ends>, damping: f64 },
}

/// The near end by a particle of all, the far one, and what draws the link.
struct Ends {
    near: u32,
    far: FarEnd,
    span: Span,
}

enum FarEnd {
    Particle(u32),
    Ground(Vec3),
}

impl AllLinks {
    /// Lines for the summary.
    pub fn lines(&self) -> Vec<String> {
        let words = ["springs, cables and gaps by links", "dashpots"];
        let line = |(word, count): (&str, usize)| (count > 0).then(|| format!("{word}: {count}"));
        words.into_iter().zip(self.counts).filter_map(line).collect()
    }

    /// How many interactions they are.
    pub fn len(&self) -> usize {
        usize::from(self.springs.is_some()) + usize::from(self.dashpots.is_some())
    }

    /// Those in time.
    pub fn marched(self) -> Vec<Box<dyn explicit_dynamics::Interaction>> {
        let springs = self.springs.map(|own| Box::new(own) as Box<dyn explicit_dynamics::Interaction>);
        springs.into_iter().chain(self.dashpots.map(|own| Box::new(own) as _)).collect()
    }

    /// Those at rest, where no scene has a dashpot.
    pub fn balanced(self) -> Vec<Box<dyn implicit_statics::Interaction>> {
        self.springs.map(|own| Box::new(own) as Box<dyn implicit_statics::Interaction>).into_iter().collect()
    }

    /// The links of a scene.
    ///
    /// # Errors
    /// [`SceneError::Set`] for sets that do not pair, ends without a line between them or with one out of the plane of a plane body, and for an end
    /// whose motion is prescribed where no time passes.
    pub fn find(scene: &Scene, layout: &Layout, sets: &SetsOfBodies) -> Result<Self, SceneError> {
        let found: Vec<LinkInScene<'_>> = links(scene)?;
        let made = found.iter().map(|link| made(scene, link, layout, sets)).collect::<Result<Vec<_>, _>>()?;
        let mut all = Self::default();
        let (springs, dashpots): (Vec<Made>, Vec<Made>) =
            made.into_iter().partition(|made| matches!(made, Made::Spring { .. }));
        all.counts = [&springs, &dashpots].map(|own| own.iter().map(|made| made.ends().len()).sum());
        if !springs.is_empty() {
            let (numbers, particles) = touched(&springs, layout);
            let mut links = Vec::new();
            let mut curves = Vec::new();
            for made in springs {
                let Made::Spring { ends, curve } = made else { continue };
                let share = 1.0 / ends.len() as f64;
                let number = curves.len();
                links.extend(ends.iter().map(|ends| Link {
                    reach: ends.reach(&numbers),
                    curve: number,
                    share,
                }));
                curves.push(curve);
            }
            let links = Links::new(links, curves, rest(&numbers, layout));
            all.springs = Some(LinkedBodies { particles, links });
        }
        if !dashpots.is_empty() {
            let (numbers, particles) = touched(&dashpots, layout);
            let mut own = Vec::new();
            for made in dashpots {
                let Made::Dashpot { ends, damping } = made else { continue };
                let damping = damping / ends.len() as f64;
                own.extend(ends.iter().map(|ends| Dashpot { reach: ends.reach(&numbers), damping }));
            }
            let dashpots = Dashpots::new(own, rest(&numbers, layout));
            all.dashpots = Some(DampedBodies { particles, dashpots });
        }
        Ok(all)
    }
}

impl Made {
    fn ends(&self) -> &[Ends] {
        match self {
            Self::Spring { ends, .. } | Self::Dashpot { ends, .. } => ends,
        }
    }
}

impl Ends {
    /// The same by the numbers of places.
    fn reach(&self, numbers: &[u32]) -> Reach {
        let number = |particle: u32| numbers.partition_point(|&other| other < particle);
        let far = match self.far {
            FarEnd::Particle(particle) => Far::Place(number(particle)),
            FarEnd::Ground(point) => Far::Ground(point),
        };
        Reach { near: number(self.near), far, span: self.span }
    }
}

/// Particles of all at ends, ascending, and those of each body by its own numbers.
fn touched(all: &[Made], layout: &Layout) -> (Vec<u32>, Vec<Vec<u32>>) {
    let ends = all.iter().flat_map(|made| made.ends());
    let particles = ends.flat_map(|ends| match ends.far {
        FarEnd::Particle(far) => vec![ends.near, far],
        FarEnd::Ground(_) => vec![ends.near],
    });
    let touched = Vec::from_iter(particles.collect::<BTreeSet<u32>>());
    let own = layout.of_each(&touched);
    (touched, own)
}

fn rest(numbers: &[u32], layout: &Layout) -> Vec<Vec3> {
    numbers.iter().map(|&particle| layout.rest[particle as usize]).collect()
}

/// A link with its ends and what it is made of.
fn made(
    scene: &Scene,
    link: &LinkInScene<'_>,
    layout: &Layout,
    sets: &SetsOfBodies,
) -> Result<Made, SceneError> {
    let LinkInScene { path, on, to, own } = link;
    let near = places(scene, &format!("{path}.on"), *on, layout, sets)?;
    let pairs = match to {
        Some(to) => {
            let other = places(scene, &format!("{path}.to"), *to, layout, sets)?;
            refuse_moved(scene, LINK, [&near, &other], layout, sets)?;
            let pairs = paired(scene, &format!("{path}.to"), *to, [&near, &other], layout)?;
            Vec::from_iter(pairs.into_iter().map(|[a, b]| (a, Some(b))))
        }
        None => {
            refuse_moved(scene, LINK, [&near, &[]], layout, sets)?;
            Vec::from_iter(near.into_iter().map(|a| (a, None)))
        }
    };
    let plane = [Some(*on), *to].into_iter().flatten().any(|(body, _)| is_plane(scene, body));
    let extent = layout.rest.iter().map(|x| x.amax()).fold(0.0, f64::max);
    let mut ends = Vec::with_capacity(pairs.len());
    for (a, b) in pairs {
        let here = layout.rest[a as usize];
        let far = match b {
            Some(b) => FarEnd::Particle(b),
            None => FarEnd::Ground(own.point.map_or(here, Vec3::from)),
        };
        let there = match far {
            FarEnd::Particle(b) => layout.rest[b as usize],
            FarEnd::Ground(point) => point,
        };
        let span = match own.direction {
            // The ground stands still: what draws the link is the motion of the set.
            Some(n) => Span::Along(Vec3::from(n).normalize() * if b.is_some() { 1.0 } else { -1.0 }),
            None => Span::Length(of_length(scene, link, &(there - here), extent, [plane, b == Some(a)])?),
        };
        ends.push(Ends { near: a, far, span });
    }
    if let Some(damping) = own.damping {
        return Ok(Made::Dashpot { ends, damping: damping.get() });
    }
    let bears = match own.bears {
        Some(Side::Tension) => Bears::Tension,
        Some(Side::Compression) => Bears::Compression,
        None => Bears::Both,
    };
    // The checks leave a table that is a curve, or a stiffness.
    let curve = own.table.as_ref().and_then(|table| ForceCurve::through(table));
    let stiffness = own.stiffness.map_or(0.0, |stiffness| stiffness.get());
    let gap = own.gap.map_or(0.0, |gap| gap.get());
    let curve = curve.unwrap_or_else(|| ForceCurve::spring(stiffness, bears, gap));
    refuse_at_rest(scene, link, layout, &ends, &curve)?;
    Ok(Made::Spring { ends, curve })
}

/// Refuses a link that pulls or pushes at rest where nothing finds what that makes of the body first, and one whose ends stand on each other while it bears.
fn refuse_at_rest(
    scene: &Scene,
    link: &LinkInScene<'_>,
    layout: &Layout,
    ends: &[Ends],
    curve: &ForceCurve,
) -> Result<(), SceneError> {
    let finds_rest = matches!(
        scene.analysis,
        Analysis::Static(_) | Analysis::ArcLength(_) | Analysis::Relaxation(_) | Analysis::Explicit(_)
    );
    for end in ends {
        let Span::Length(length) = end.span else { continue };
        let here = layout.rest[end.near as usize];
        let there = match end.far {
            FarEnd::Particle(b) => layout.rest[b as usize],
            FarEnd::Ground(point) => point,
        };
        let distance = (there - here).norm();
        let at = curve.at(distance - length);
        let key = format!("{}.length", link.path);
        if distance == 0.0 && (at.force != 0.0 || at.slope != 0.0) {
            let bound = "but slack where its ends stand on each other: there no line between them draws it";
            let fault = scene.source.fault(
                &key,
                &length.to_string(),
                bound,
                "give a `direction`, or a `length` at which it is slack",
            );
            return Err(SceneError::Set(fault));
        }
        if !finds_rest && at.force.abs() > TAUT * curve.steepest() * length.max(distance) {
            let bound = format!(
                "but without a force at rest in {}, which starts from the body as it is given: the ends are {distance:.6} apart",
                scene.analysis.kind().name
            );
            let repair = "leave `length` out, or find the balance by [analysis.static], [analysis.arc-length] or a march";
            return Err(SceneError::Set(scene.source.fault(&key, &length.to_string(), &bound, repair)));
        }
    }
    Ok(())
}

/// The length without a force of a link whose ends are so far apart at rest \[L\].
fn of_length(
    scene: &Scene,
    link: &LinkInScene<'_>,
    apart: &Vec3,
    extent: f64,
    [plane, alike]: [bool; 2],
) -> Result<f64, SceneError> {
    let LinkInScene { path, to, own, .. } = link;
    let key = format!("{path}.{}", if to.is_some() { "to" } else { "point" });
    let refuse = |value: &str, bound: &str, repair: &str| {
        Err(SceneError::Set(scene.source.fault(&key, value, bound, repair)))
    };
    let distance = apart.norm();
    if plane && apart.z.abs() > OUT_OF_PLANE * distance {
        let value = format!("an end {:.4e} across the plane from the other", apart.z.abs());
        let repair = "let both ends have the same z: a plane body stays in its plane";
        return refuse(&value, "but the line between them stays in the plane of x and y", repair);
    }
    if alike || distance <= NO_LINE * extent && own.length.is_none() {
        let bound = "but a line between two places draws the link";
        return refuse("both ends on one place", bound, "give a `direction`, or name another set");
    }
    Ok(own.length.map_or(distance, |length| length.get()))
}

/// Whether a body stays in a plane.
fn is_plane(scene: &Scene, body: &str) -> bool {
    let in_plane_fluid = scene.fluid().is_some_and(|(_, fluid)| fluid.dimensions() == 2);
    match scene.bodies.get(body) {
        Some(BodyScene::Solid(solid)) => solid.is_plane(),
        Some(BodyScene::Rigid(_)) => in_plane_fluid,
        _ => false,
    }
}
