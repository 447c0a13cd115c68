//! A shell that may touch itself: forces, tangent, and how they shorten a step in time.

use contact::{Deepest, Law, Moving, NodalContact, Node, Pace, SurfaceContact, SurfaceTouch, Touching};
use sph_core::Vec3;

use crate::conditions::body::{Block, place_block};
use crate::conditions::touched::touched_mesh;
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

/// How much farther than they touch parts are listed, over the spacing.
const SKIN: f64 = 0.3;
/// How a shell touches itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnContact {
    /// The law of contact.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\]: half of [`contact::stiffness`] is what thickness and step bear.
    pub stiffness: f64,
    /// Whether edges that cross between particles push each other apart, for marches; they have no tangent.
    pub edges: bool,
    /// Coefficient of friction μ \[–\]; zero of a smooth shell.
    pub friction: f64,
}

/// The contact of a shell with itself.
#[derive(Clone, Debug)]
pub(crate) struct SelfContact {
    contact: SurfaceContact,
    touch: SurfaceTouch,
    /// Forces of contact on each particle.
    forces: Vec<Row>,
    pace: Pace,
    /// Whether the forces above are those of the present state.
    looked: bool,
    /// Whether nothing can come near in this step.
    rests: bool,
}

impl SelfContact {
    /// The contact of a shell with half of its thickness at each particle \[L\], whose particles move with masses \[M\].
    ///
    /// # Errors
    /// [`ShellError`] for a stiffness that is not positive, a friction that is negative, and where thicknesses differ.
    pub fn new(
        own: &OwnContact,
        reference: &Reference,
        half: &[f64],
        masses: &[f64],
    ) -> Result<Self, ShellError> {
        let OwnContact { law, stiffness, edges, friction } = *own;
        if !(stiffness > 0.0 && stiffness.is_finite()) {
            return Err(ShellError::ContactStiffness(stiffness));
        }
        if !(friction >= 0.0 && friction.is_finite()) {
            return Err(ShellError::ToolFriction(friction));
        }
        let cloud = &reference.cloud;
        let (mesh, thickness) = touched_mesh(cloud, half)?;
        let skin = SKIN * cloud.spacing();
        let touching = Touching { distance: thickness, law, stiffness, skin, edges };
        let contact = SurfaceContact::itself(mesh, &cloud.positions, touching).with_friction(friction);
        let pace = Pace::new(&contact, |(_, a)| masses[a as usize]);
        let (touch, forces) = (SurfaceTouch::default(), vec![[0.0; 6]; cloud.len()]);
        Ok(Self { contact, touch, forces, pace, looked: false, rests: false })
    }

    /// Says of contact what is said of tools that find no face.
    pub fn refusal(error: ShellError) -> ShellError {
        match error {
            ShellError::ToolWithoutCells => ShellError::ContactWithoutCells,
            ShellError::ToolOnOffset { cell } => ShellError::ContactOnOffset { cell },
            error => error,
        }
    }

    /// Adds the forces of contact in a state.
    pub fn add(&mut self, state: &[Row], forces: &mut [Row]) {
        self.look(state);
        if self.rests {
            return;
        }
        for (sum, row) in forces.iter_mut().zip(&self.forces) {
            (0..3).for_each(|k| sum[k] += row[k]);
        }
    }

    /// Whether nothing can touch in this step, so that there are no forces.
    pub fn rests(&self) -> bool {
        self.rests
    }

    /// Whether nothing can come near in the step to come.
    pub fn waits(&self) -> bool {
        self.pace.waits() > 0.0
    }

    /// Finds what touches in a state, unless that is known.
    fn look(&mut self, state: &[Row]) {
        if self.looked || self.rests {
            return;
        }
        self.touch = self.contact.look(place(state));
        let forces = &mut self.forces;
        forces.fill([0.0; 6]);
        self.contact.forces(|(_, a), force| push(forces, a, &force));
    }

    /// The longest step that contact allows in a state with its rates, where the shell alone has a stable step of a length times a safety
    /// ([`Pace::shortened`]).
    pub fn shortened(
        &mut self,
        stable: f64,
        safety: f64,
        [state, rates]: [&[Row]; 2],
        masses: &[f64],
    ) -> f64 {
        self.rests = self.pace.rests();
        if self.rests {
            return stable;
        }
        self.look(state);
        self.looked = true;
        let Self { contact, touch, pace, .. } = self;
        pace.shortened((contact, touch), stable, safety, &Particles { rates, masses })
    }

    /// Forgets what was found: the state is another.
    pub fn moved(&mut self) {
        self.looked = false;
    }

    /// Forgets how long nothing can come near: the state is another than a step makes.
    pub fn put(&mut self) {
        (self.looked, self.rests) = (false, false);
        self.pace.wait(0.0);
    }

    /// The step over the stable one at which parts were pressed through each other.
    pub fn pressed(&self) -> Option<f64> {
        self.pace.pressed()
    }

    /// What the shell does to itself, for the forces last evaluated.
    pub fn touch(&self) -> &SurfaceTouch {
        &self.touch
    }

    /// The two parts that are deepest in each other, for the forces last evaluated.
    pub fn deepest(&self, state: &[Row]) -> Option<Deepest> {
        self.contact.deepest(place(state))
    }

    /// What each particle feels of it, for the forces last evaluated.
    pub fn nodal_contact(&self, nodal: &mut [NodalContact]) {
        let mut own = vec![NodalContact::default(); nodal.len()];
        self.contact.nodal_contact(0, &mut own);
        nodal.iter_mut().zip(&own).for_each(|(sum, own)| sum.join(own));
    }

    /// Gaps at some particles in a state ([`SurfaceContact::gaps`]).
    pub fn gaps(&self, particles: &[u32], state: &[Row]) -> Vec<f64> {
        self.contact.gaps(0, particles, place(state))
    }

    /// Force of contact on a particle, for the forces last evaluated.
    pub fn force(&self, particle: usize) -> Vec3 {
        let row = &self.forces[particle];
        Vec3::new(row[0], row[1], row[2])
    }

    /// What its friction is and keeps.
    pub fn friction(&self) -> &SurfaceContact {
        &self.contact
    }

    /// Makes the anchors of the forces last evaluated those that count.
    pub fn commit(&mut self) {
        self.contact.commit();
    }

    /// Lets what is near in a state, and touches nothing, rub from there when it comes to touch.
    pub fn hover(&mut self, state: &[Row]) {
        self.contact.hover(place(state));
    }

    /// Takes up the history of its friction; false, and nothing changed, if it is that of another shell.
    pub fn take_up_history(&mut self, history: &[f64]) -> bool {
        self.contact.take_up_history(history)
    }

    /// Stiffness of contact of a unit of area.
    pub fn stiffness(&self) -> f64 {
        self.contact.touching().stiffness
    }

    /// Adds the forces that a small motion meets at most, as if all of the shell were touched on both faces: `−4 κ A u` at each vertex.
    pub fn add_bounds(&self, state: &[Row], home: &[Row], forces: &mut [Row]) {
        for (number, vertex) in self.contact.meshes()[0].surface().vertices().iter().enumerate() {
            let at = |rows| {
                let place = place(rows);
                vertex.place(|a| place((0, a)))
            };
            let share = (at(state) - at(home)) * (-self.contact.bound(0, number) * vertex.share());
            vertex.nodes().iter().for_each(|&a| push(forces, a, &share));
        }
    }

    /// Hands the derivatives of the forces last evaluated to `put`, as loads do theirs.
    pub fn tangent(&self, state: &[Row], put: &mut dyn FnMut(u32, u32, &Block)) {
        self.contact.tangent(place(state), |(_, a), (_, b), change| put(a, b, &place_block(0, 0, change)));
    }

    /// Hands all pairs of particles that may share a block of the tangent to `pair`, until [`SelfContact::lists`] changes.
    pub fn pattern(&self, mut pair: impl FnMut(u32, u32)) {
        self.contact.pattern(|(_, a), (_, b)| pair(a, b));
    }

    /// How many lists of what is near were made, the present state among them.
    pub fn lists(&mut self, state: &[Row]) -> u64 {
        self.put();
        self.look(state);
        self.contact.lists()
    }

    /// The share of the way from one state to another after which nothing has come through.
    pub fn reach(&self, here: &[Row], there: &[Row]) -> f64 {
        self.contact.reach(place(here), place(there))
    }

    /// What a checkpoint keeps beside the motion: how long nothing can come near, and where particles were when lists were made; nothing
    /// before the first.
    pub fn kept(&self) -> Vec<f64> {
        let listed = self.contact.listed().iter().flatten().flat_map(|x| [x.x, x.y, x.z]);
        let wait = self.contact.listed().first().map(|_| self.pace.waits());
        wait.into_iter().chain(listed).collect()
    }

    /// Takes up what [`SelfContact::kept`] gave; false, and nothing changed, if it is that of another shell.
    pub fn take_up(&mut self, kept: &[f64]) -> bool {
        let Some((wait, places)) = kept.split_first() else {
            return true;
        };
        let (places, left) = places.as_chunks::<3>();
        if !left.is_empty() || !self.contact.take_up(&[places]) {
            return false;
        }
        (self.looked, self.rests) = (false, false);
        self.pace.wait(*wait);
        true
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        self.contact.bytes() + size_of_val(&self.forces[..])
    }
}

/// Particles of the shell that move.
struct Particles<'a> {
    rates: &'a [Row],
    masses: &'a [f64],
}

impl Moving for Particles<'_> {
    fn mass(&self, (_, a): Node) -> f64 {
        self.masses[a as usize]
    }

    fn velocity(&self, (_, a): Node) -> Vec3 {
        velocity(self.rates, a)
    }

    fn greatest_speed(&self) -> f64 {
        let mut mean = [0.0; 3];
        for row in self.rates {
            (0..3).for_each(|k| mean[k] += row[k]);
        }
        let mean = mean.map(|sum| sum / self.rates.len().max(1) as f64);
        let square = |row: &Row| (0..3).map(|k| (row[k] - mean[k]) * (row[k] - mean[k])).sum::<f64>();
        self.rates.iter().map(square).fold(0.0, f64::max).sqrt()
    }
}

fn place(state: &[Row]) -> impl Fn(Node) -> Vec3 {
    |(_, a)| velocity(state, a)
}

/// The first three numbers of a row: a place, or a velocity.
fn velocity(rows: &[Row], a: u32) -> Vec3 {
    let row = &rows[a as usize];
    Vec3::new(row[0], row[1], row[2])
}

fn push(forces: &mut [Row], a: u32, force: &Vec3) {
    (0..3).for_each(|k| forces[a as usize][k] += force[k]);
}
