//! A shell that may touch itself: forces, tangent, and how they shorten a step in time.

use contact::{Deepest, Law, Node, SurfaceContact, SurfaceTouch, Touching};
use sph_core::Vec3;

use crate::conditions::loads::{Block, place_block};
use crate::conditions::touched::touched_mesh;
use crate::error::ShellError;
use crate::packs::Row;
use crate::reference::Reference;

/// How much farther than they touch parts are listed, over the spacing.
const SKIN: f64 = 0.3;
/// Depth beyond which pairs bound the step by the time in which they would meet.
const DEEP: f64 = 0.4;
/// Part of that time that a step may take.
const OF_MEETING: f64 = 0.2;
/// Part of the contact distance by which two parts may come nearer to each other in a step.
const OF_DISTANCE: f64 = 0.5;
/// Least step over the stable one of the shell; below it parts are pressed through each other.
const FLOOR: f64 = 0.01;
/// Steps for which a shell with nothing near itself is not looked at again, at most.
const PATIENCE: f64 = 16.0;
/// By how much speeds may grow meanwhile.
const MARGIN: f64 = 2.0;

/// How a shell touches itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnContact {
    /// The law of contact.
    pub law: Law,
    /// Stiffness κ of a unit of area \[F/L³\]: half of [`contact::stiffness`] is what thickness and step bear.
    pub stiffness: f64,
    /// Whether edges that cross between particles push each other apart, for marches; they have no tangent.
    pub edges: bool,
}

/// The contact of a shell with itself.
#[derive(Clone, Debug)]
pub(crate) struct SelfContact {
    contact: SurfaceContact,
    touch: SurfaceTouch,
    /// Forces of contact on each particle.
    forces: Vec<Row>,
    /// Stiffness that contact adds at each particle.
    rows: Vec<f64>,
    /// Square of the frequency that the stable step of the shell has room for \[1/T²\].
    room: f64,
    /// Whether the forces above are those of the present state.
    looked: bool,
    /// Steps for which nothing can come near.
    wait: f64,
    /// The step over the stable one where parts were pressed through each other.
    pressed: Option<f64>,
}

impl SelfContact {
    /// The contact of a shell with half of its thickness at each particle \[L\], whose particles move with masses \[M\].
    ///
    /// # Errors
    /// [`ShellError`] for a stiffness that is not positive and where thicknesses differ.
    pub fn new(
        own: &OwnContact,
        reference: &Reference,
        half: &[f64],
        masses: &[f64],
    ) -> Result<Self, ShellError> {
        let OwnContact { law, stiffness, edges } = *own;
        if !(stiffness > 0.0 && stiffness.is_finite()) {
            return Err(ShellError::ContactStiffness(stiffness));
        }
        let cloud = &reference.cloud;
        let (mesh, thickness) = touched_mesh(cloud, half)?;
        let skin = SKIN * cloud.spacing();
        let touching = Touching { distance: thickness, law, stiffness, skin, edges };
        let mut own = Self {
            contact: SurfaceContact::itself(mesh, &cloud.positions, touching),
            touch: SurfaceTouch::default(),
            forces: vec![[0.0; 6]; cloud.len()],
            rows: vec![0.0; cloud.len()],
            room: 0.0,
            looked: false,
            wait: 0.0,
            pressed: None,
        };
        for (number, vertex) in own.contact.meshes()[0].surface().vertices().iter().enumerate() {
            let bound = own.contact.bound(0, number) * vertex.share();
            vertex.nodes().iter().for_each(|&a| own.rows[a as usize] += bound);
        }
        own.room = own.greatest_row(masses);
        Ok(own)
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
        for (sum, row) in forces.iter_mut().zip(&self.forces) {
            (0..3).for_each(|k| sum[k] += row[k]);
        }
    }

    /// Finds what touches in a state, unless that is known.
    fn look(&mut self, state: &[Row]) {
        if self.looked || self.wait > 0.0 {
            return;
        }
        self.touch = self.contact.look(place(state));
        let forces = &mut self.forces;
        forces.fill([0.0; 6]);
        self.contact.forces(|(_, a), force| push(forces, a, &force));
    }

    /// The longest step that contact allows in a state with its rates, where the shell alone has a stable step of a length times a safety.
    ///
    /// `Δt ≤ safety·2/√(ω² + row)` with `row = max_a (2/m_a) Σ k φ″ |w_a|` of all that touches (Gershgorin), less what the stable step
    /// has room for; a fifth of the time in which deep pairs would meet; and half of the contact distance at the greatest speed, the mean taken out.
    pub fn shortened(
        &mut self,
        stable: f64,
        safety: f64,
        [state, rates]: [&[Row]; 2],
        masses: &[f64],
    ) -> f64 {
        if self.wait > 0.0 {
            self.wait -= 1.0;
            return stable;
        }
        self.look(state);
        self.looked = true;
        let speed = greatest_speed(rates);
        if let Some(left) = self.contact.left_alone() {
            self.wait = (left / (2.0 * MARGIN * speed * stable)).min(PATIENCE).floor();
            return stable;
        }
        let mut step = stable;
        if self.touch.area > 0.0 || self.contact.greatest_crossing() > 0.0 {
            let rows = &mut self.rows;
            rows.fill(0.0);
            self.contact.rows(|(_, a), row| rows[a as usize] += row);
            let beyond = self.greatest_row(masses) - self.room;
            if beyond > 0.0 {
                let own = 2.0 * safety / stable;
                step = step.min(2.0 * safety / (own * own + beyond).sqrt());
            }
            step = step.min(OF_MEETING * self.contact.meeting(DEEP, |(_, a)| velocity(rates, a)));
        }
        step = step.min(OF_DISTANCE * self.contact.touching().distance / (2.0 * speed));
        if step < FLOOR * stable {
            self.pressed = Some(step / stable);
            step = FLOOR * stable;
        }
        step
    }

    /// Forgets what was found: the state is another.
    pub fn moved(&mut self) {
        self.looked = false;
    }

    /// Forgets how long nothing can come near: the state is another than a step makes.
    pub fn put(&mut self) {
        (self.looked, self.wait) = (false, 0.0);
    }

    /// The step over the stable one at which parts were pressed through each other.
    pub fn pressed(&self) -> Option<f64> {
        self.pressed
    }

    /// What the shell does to itself, for the forces last evaluated.
    pub fn touch(&self) -> &SurfaceTouch {
        &self.touch
    }

    /// The two parts that are deepest in each other, for the forces last evaluated.
    pub fn deepest(&self, state: &[Row]) -> Option<Deepest> {
        self.contact.deepest(place(state))
    }

    /// Force of contact on a particle, for the forces last evaluated.
    pub fn force(&self, particle: usize) -> Vec3 {
        let row = &self.forces[particle];
        Vec3::new(row[0], row[1], row[2])
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
        let wait = self.contact.listed().first().map(|_| self.wait);
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
        (self.looked, self.wait) = (false, *wait);
        true
    }

    /// Bytes that it holds.
    pub fn bytes(&self) -> usize {
        self.contact.bytes() + size_of_val(&self.forces[..]) + size_of_val(&self.rows[..])
    }

    /// Greatest row over the mass of its particle \[1/T²\].
    fn greatest_row(&self, masses: &[f64]) -> f64 {
        self.rows
            .iter()
            .zip(masses)
            .filter(|(row, _)| **row > 0.0)
            .fold(0.0, |most, (row, m)| (row / m).max(most))
    }
}

/// Greatest speed of a particle, the mean velocity taken out \[L/T\].
fn greatest_speed(rates: &[Row]) -> f64 {
    let mut mean = [0.0; 3];
    for row in rates {
        (0..3).for_each(|k| mean[k] += row[k]);
    }
    let mean = mean.map(|sum| sum / rates.len().max(1) as f64);
    let square = |row: &Row| (0..3).map(|k| (row[k] - mean[k]) * (row[k] - mean[k])).sum::<f64>();
    rates.iter().map(square).fold(0.0, f64::max).sqrt()
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
