//! Two bodies that may touch: from the scene's words to what acts between systems.

use contact::{Law, Mesh, Node, Pace, SurfaceContact, SurfaceTouch, Touching};
use explicit_dynamics::{OutOfBounds, OutOfRange, Places};
use nalgebra::Matrix3;
use sph_core::Vec3;

use super::moving::MovingPlaces;
use super::rows::Rows;
use super::skin::{Between, Skin};

/// How much farther than they touch parts are listed, over the lesser spacing.
const SKIN: f64 = 0.3;

/// A body as another touches it.
#[derive(Clone)]
pub(in crate::bodies) struct Side {
    /// Its name.
    pub name: String,
    /// Its number among the bodies.
    pub body: usize,
    /// Its surface.
    pub mesh: Mesh,
    /// Its thickness, of a solid twice the depth at which its surface lies below its faces \[L\].
    pub thickness: f64,
    /// Stiffness of contact with a rigid tool \[F/L³\].
    pub stiffness: f64,
    /// Mean distance of its particles \[L\].
    pub spacing: f64,
    /// Where the nodes of its surface are at rest \[L\].
    pub rest: Vec<Vec3>,
    /// Between which particles each node of its surface lies; none where nodes are particles.
    pub inside: Option<Vec<Between>>,
    /// How its contacts are counted in rows; none of what is no solid.
    pub rows: Option<Rows>,
}

/// How two bodies touch, as their scene says it.
#[derive(Clone, Copy)]
pub(super) struct Manner {
    /// The law.
    pub law: Law,
    /// Factor on the stiffness.
    pub factor: f64,
    /// Whether edges push each other apart: in marches.
    pub edges: bool,
    /// Coefficient of friction \[–\].
    pub friction: f64,
}

/// The contact of two bodies, places being the particles of the first that carry its surface and then those of the second.
#[derive(Clone)]
pub(in crate::bodies) struct TouchingBodies {
    names: [String; 2],
    /// Particles of each body, those of others empty.
    pub(super) particles: Vec<Vec<u32>>,
    /// How places carry both surfaces.
    pub(super) skin: Skin,
    /// Nodes of both surfaces at rest \[L\].
    rest: [Vec<Vec3>; 2],
    pub(super) contact: SurfaceContact,
    pub(super) touch: SurfaceTouch,
    /// How the contact is counted in rows on each side: of solids of bonds.
    pub(super) rows: [Option<Rows>; 2],
    pace: Option<Pace>,
    /// Whether the contact was looked at where it is evaluated next.
    looked: bool,
    /// Pairs of places that share a block, ascending; those of this list.
    pairs: Vec<[usize; 2]>,
    listed: u64,
}

impl TouchingBodies {
    /// The contact of two of so many bodies: the first of the two comes first, whichever the scene names first.
    pub(super) fn new(sides: [Side; 2], bodies: usize, manner: Manner) -> Self {
        let [a, b] = if sides[0].body < sides[1].body {
            sides
        } else {
            let [a, b] = sides;
            [b, a]
        };
        let own = |side: &Side| {
            let mut all: Vec<u32> = side
                .mesh
                .surface()
                .vertices()
                .iter()
                .flat_map(|vertex| vertex.nodes().iter().copied())
                .collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        let nodes = [own(&a), own(&b)];
        let (skin, [of_a, of_b]) =
            Skin::new([&nodes[0], &nodes[1]], [a.inside.as_deref(), b.inside.as_deref()]);
        let mut particles = vec![Vec::new(); bodies];
        (particles[a.body], particles[b.body]) = (of_a, of_b);
        // Two bodies that give way are springs in series; beside a rigid one there is one.
        let in_series = if a.stiffness.max(b.stiffness).is_finite() { 0.5 } else { 1.0 };
        let touching = Touching {
            distance: 0.5 * (a.thickness + b.thickness),
            law: manner.law,
            stiffness: in_series * a.stiffness.min(b.stiffness) * manner.factor,
            skin: SKIN * a.spacing.min(b.spacing),
            edges: manner.edges,
        };
        let contact = SurfaceContact::between([a.mesh, b.mesh], [&a.rest, &b.rest], touching)
            .with_friction(manner.friction);
        let names = [a.name, b.name];
        // A Galerkin solid that another body touches is warned of whatever it spans.
        let rows =
            [(a.rows, a.inside), (b.rows, b.inside)].map(|(rows, inside)| rows.filter(|_| inside.is_none()));
        let (touch, pairs) = (SurfaceTouch::default(), Vec::new());
        let rest = [a.rest, b.rest];
        Self {
            names,
            particles,
            skin,
            rest,
            contact,
            touch,
            rows,
            pace: None,
            looked: false,
            pairs,
            listed: 0,
        }
    }

    /// A line for the summary.
    pub fn line(&self) -> String {
        let [a, b] = &self.names;
        let Touching { stiffness, distance, .. } = *self.contact.touching();
        let friction = match self.contact.friction() {
            0.0 => String::new(),
            friction => format!(", friction {friction}"),
        };
        format!(
            "contact of {a} with {b}: stiffness {stiffness:.3e} by area, mid-surfaces {distance:.4e} apart{friction}"
        )
    }

    /// Depth of faces in each other at rest, over the distance of mid-surfaces, with the two nearest places.
    pub fn depth_at_rest(&mut self) -> Option<(f64, [Vec3; 2])> {
        let rest = &self.rest;
        let at = |(side, a): Node| rest[side][a as usize];
        self.contact.look(at);
        self.contact.deepest(at).map(|found| (found.depth, found.places))
    }

    /// Distance at which mid-surfaces touch \[L\].
    pub fn distance(&self) -> f64 {
        self.contact.touching().distance
    }

    /// Finds what touches at places.
    fn look(&mut self, places: &[[f64; 3]]) {
        let skin = &self.skin;
        self.touch = self.contact.look(|node| skin.place(places, node));
    }

    /// Reads the pairs that share a block from the lists.
    fn read_pairs(&mut self) {
        let Self { skin, contact, pairs, .. } = self;
        pairs.clear();
        contact.pattern(|a, b| {
            skin.each(a, |a, _| {
                skin.each(b, |b, _| {
                    if a <= b {
                        pairs.push([a, b]);
                    }
                });
            });
        });
        pairs.sort_unstable();
        pairs.dedup();
        self.listed = self.contact.lists();
    }

    fn evaluated(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        if !std::mem::take(&mut self.looked) {
            self.look(places);
        }
        forces.fill([0.0; 3]);
        let skin = &self.skin;
        self.contact.forces(|node, force| {
            skin.each(node, |a, weight| (0..3).for_each(|k| forces[a][k] += weight * force[k]));
        });
        self.touch.energy
    }

    /// Hands the second derivatives of the energy between places to `put`, at the places last evaluated.
    fn second(&self, places: &[[f64; 3]], mut put: impl FnMut(usize, usize, &Matrix3<f64>)) {
        let skin = &self.skin;
        self.contact.tangent(
            |node| skin.place(places, node),
            |a, b, change| {
                skin.each(a, |a, own| skin.each(b, |b, other| put(a, b, &(change * -(own * other)))));
            },
        );
    }
}

impl explicit_dynamics::Interaction for TouchingBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces)
    }

    fn resist(&self, at: &[[f64; 3]], motion: &[[f64; 3]], forces: &mut [[f64; 3]]) {
        forces.fill([0.0; 3]);
        self.second(at, |a, b, block| {
            let moved = block * Vec3::from(motion[b]);
            (0..3).for_each(|k| forces[a][k] += moved[k]);
        });
    }

    fn fastest(&self, masses: &[f64]) -> f64 {
        self.pace_of(masses).room()
    }

    fn rests(&mut self) -> bool {
        self.pace.as_mut().is_some_and(Pace::rests)
    }

    fn shortened(&mut self, stable: f64, safety: f64, now: &Places<'_>) -> f64 {
        self.look(now.at);
        self.looked = true;
        let mut pace = self.pace.take().unwrap_or_else(|| self.pace_of(now.masses));
        let moving = MovingPlaces { skin: &self.skin, now };
        let step = pace.shortened((&self.contact, &self.touch), stable, safety, &moving);
        self.pace = Some(pace);
        step
    }

    fn moved(&mut self) {
        self.looked = false;
    }

    fn within_bounds(&self) -> Result<(), OutOfBounds> {
        let Some(value) = self.pace.as_ref().and_then(Pace::pressed) else { return Ok(()) };
        let place = format!("{}, pressed through {}", self.names[0], self.names[1]);
        let (what, bound) = ("step over the stable one", "a hundredth at least");
        Err(OutOfRange { place, what, value, bound }.into())
    }

    fn lost(&self) -> f64 {
        self.contact.lost()
    }

    fn commit(&mut self) {
        self.contact.commit();
    }

    fn lost_at(&self, place: usize) -> f64 {
        self.lost_of(place)
    }

    fn kept(&self) -> Vec<f64> {
        let wait = self.pace.as_ref().map(|pace| pace.waits());
        self.contact.listed().first().and(wait).into_iter().chain(self.kept_lists()).collect()
    }

    fn take_up(&mut self, kept: &[f64], masses: &[f64]) -> bool {
        self.looked = false;
        let Some((wait, places)) = kept.split_first() else {
            self.pace = None;
            return true;
        };
        if !self.take_lists(places) {
            return false;
        }
        let mut pace = self.pace_of(masses);
        pace.wait(*wait);
        self.pace = Some(pace);
        true
    }
}

impl implicit_statics::Interaction for TouchingBodies {
    fn particles(&self) -> Vec<Vec<u32>> {
        self.particles.clone()
    }

    fn pairs(&self) -> Vec<[usize; 2]> {
        self.pairs.clone()
    }

    fn pairs_changed(&mut self, places: &[[f64; 3]]) -> bool {
        self.look(places);
        let changed = self.contact.lists() != self.listed;
        if changed {
            self.read_pairs();
        }
        changed
    }

    fn reach(&self, here: &[[f64; 3]], there: &[[f64; 3]]) -> f64 {
        let skin = &self.skin;
        self.contact.reach(|node| skin.place(here, node), |node| skin.place(there, node))
    }

    fn remembers(&self) -> bool {
        self.contact.remembers()
    }

    fn history(&self) -> Vec<f64> {
        self.contact.history()
    }

    fn recall(&mut self, history: &[f64]) {
        self.contact.take_up_history(history);
    }

    fn commit(&mut self, places: &[[f64; 3]]) {
        self.contact.commit();
        let skin = &self.skin;
        self.contact.hover(|node| skin.place(places, node));
    }

    fn lost_at(&self, place: usize) -> f64 {
        self.lost_of(place)
    }

    fn kept(&self) -> Vec<f64> {
        self.kept_lists().collect()
    }

    fn take_up(&mut self, kept: &[f64]) -> bool {
        // The next look at the pattern finds other lists than those of the pairs at hand.
        self.listed = u64::MAX;
        kept.is_empty() || self.take_lists(kept)
    }

    fn evaluate(&mut self, places: &[[f64; 3]], forces: &mut [[f64; 3]]) -> f64 {
        self.evaluated(places, forces)
    }

    fn stiffness(&self, at: &[[f64; 3]], blocks: &mut [[[f64; 3]; 3]]) {
        blocks.fill([[0.0; 3]; 3]);
        self.second(at, |a, b, change| {
            let Ok(block) = self.pairs.binary_search(&[a, b]) else { return };
            for i in 0..3 {
                (0..3).for_each(|j| blocks[block][i][j] += change[(i, j)]);
            }
        });
    }
}

impl TouchingBodies {
    /// Energy that friction lost at a place.
    fn lost_of(&self, place: usize) -> f64 {
        let borne = self.skin.borne(place).iter();
        borne.map(|&(node, weight)| weight * self.contact.lost_at(node)).sum()
    }

    /// Where particles were when lists were made, and the history of friction; nothing before the first list.
    fn kept_lists(&self) -> impl Iterator<Item = f64> {
        let listed = self.contact.listed();
        let history = listed.first().map(|_| self.contact.history());
        listed.iter().flatten().flat_map(|x| [x.x, x.y, x.z]).chain(history.into_iter().flatten())
    }

    /// Takes up that history, and makes the lists that were made where particles were.
    fn take_lists(&mut self, kept: &[f64]) -> bool {
        let count: usize = self.contact.meshes().iter().map(|mesh| 3 * mesh.nodes().count()).sum();
        let Some((places, history)) = kept.split_at_checked(count) else { return false };
        if !self.contact.take_up_history(history) {
            return false;
        }
        let (places, left) = places.as_chunks::<3>();
        let first = self.contact.meshes()[0].nodes().count();
        let sides = places.split_at_checked(first).filter(|_| left.is_empty());
        sides.is_some_and(|(a, b)| self.contact.take_up(&[a, b]))
    }

    fn pace_of(&self, masses: &[f64]) -> Pace {
        Pace::new(&self.contact, |node| self.skin.mass(masses, node))
    }
}
