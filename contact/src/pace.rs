//! How surfaces that may touch pace a march: which steps nothing can come near, and how long the others may be.

use sph_core::Vec3;

use crate::surfaces::{Node, SurfaceContact, SurfaceTouch};

/// Depth beyond which pairs bound the step by the time in which they would meet.
const DEEP: f64 = 0.4;
/// Part of that time that a step may take.
const OF_MEETING: f64 = 0.2;
/// Part of the contact distance by which two parts may come nearer to each other in a step.
const OF_DISTANCE: f64 = 0.5;
/// Least step over the stable one; below it parts are pressed through each other.
const FLOOR: f64 = 0.01;
/// Steps for which surfaces of which nothing can touch are not looked at again, at most.
const PATIENCE: f64 = 16.0;
/// By how much speeds may grow meanwhile.
const MARGIN: f64 = 2.0;
/// Part of the contact distance by which two parts that are at rest may come nearer to each other in a step meanwhile.
const STARTS: f64 = 1.0 / 64.0;

/// Masses and velocities of nodes, as whoever marches them has them.
pub trait Moving {
    /// Mass of a node \[M\].
    fn mass(&self, node: Node) -> f64;

    /// Velocity of a node \[L/T\].
    fn velocity(&self, node: Node) -> Vec3;

    /// Greatest speed of any node, the mean velocity taken out \[L/T\].
    fn greatest_speed(&self) -> f64;
}

/// The pace of surfaces that may touch.
#[derive(Clone, Debug)]
pub struct Pace {
    /// Stiffness that contact adds at each node, body by body \[F/L\].
    rows: Vec<Vec<f64>>,
    room: f64,
    wait: f64,
    pressed: Option<f64>,
}

impl Pace {
    /// That of surfaces whose nodes have these masses \[M\].
    pub fn new(contact: &SurfaceContact, mass: impl Fn(Node) -> f64) -> Self {
        let mut rows = Vec::new();
        for (body, mesh) in contact.meshes().iter().enumerate() {
            let vertices = mesh.surface().vertices();
            let count =
                vertices.iter().flat_map(|vertex| vertex.nodes()).max().map_or(0, |&a| a as usize + 1);
            let mut own = vec![0.0; count];
            for (number, vertex) in vertices.iter().enumerate() {
                let bound = contact.bound(body, number) * vertex.share();
                vertex.nodes().iter().for_each(|&a| own[a as usize] += bound);
            }
            rows.push(own);
        }
        let mut pace = Self { rows, room: 0.0, wait: 0.0, pressed: None };
        pace.room = pace.greatest_row(mass);
        pace
    }

    /// What the stable step has to have room for: the square of the highest frequency of nodes that are touched on both faces while depths
    /// stay out of the barrier \[1/T²\].
    pub fn room(&self) -> f64 {
        self.room
    }

    /// Whether nothing can come near in the step to come; asked once a step.
    pub fn rests(&mut self) -> bool {
        let rests = self.wait > 0.0;
        if rests {
            self.wait -= 1.0;
        }
        rests
    }

    /// The longest step that contact allows, for the state last looked at, where the bodies alone have a stable step with a safety.
    ///
    /// `Δt ≤ safety·2/√(ω² + row)` with `row = max_a (2/m_a) Σ k φ″ |w_a|` of all that touches (Gershgorin), less what the stable step
    /// has room for; a fifth of the time in which deep pairs would meet; and half of the contact distance at the greatest speed.
    pub fn shortened(
        &mut self,
        (contact, touch): (&SurfaceContact, &SurfaceTouch),
        stable: f64,
        safety: f64,
        moving: &impl Moving,
    ) -> f64 {
        let speed = moving.greatest_speed();
        let bound = OF_DISTANCE * contact.touching().distance / (2.0 * speed);
        if let Some(left) = contact.left_alone()
            && (contact.nothing_is_listed() || MARGIN * stable <= bound)
        {
            let way = 2.0 * MARGIN * speed * stable + STARTS * contact.touching().distance;
            self.wait = (left / way).min(PATIENCE).floor();
            return stable;
        }
        let mut step = stable;
        if touch.area > 0.0 || contact.greatest_crossing() > 0.0 {
            self.rows.iter_mut().for_each(|own| own.fill(0.0));
            contact.rows(|(body, a), row| self.rows[body][a as usize] += row);
            let beyond = self.greatest_row(|node| moving.mass(node)) - self.room;
            if beyond > 0.0 {
                let own = 2.0 * safety / stable;
                step = step.min(2.0 * safety / (own * own + beyond).sqrt());
            }
            step = step.min(OF_MEETING * contact.meeting(DEEP, |node| moving.velocity(node)));
        }
        step = step.min(bound);
        if step < FLOOR * stable {
            self.pressed = Some(step / stable);
            step = FLOOR * stable;
        }
        step
    }

    /// The step over the stable one at which parts were pressed through each other.
    pub fn pressed(&self) -> Option<f64> {
        self.pressed
    }

    /// Steps for which nothing can come near.
    pub fn waits(&self) -> f64 {
        self.wait
    }

    /// Lets so many steps pass for which nothing can come near.
    pub fn wait(&mut self, steps: f64) {
        self.wait = steps;
    }

    /// Greatest row over the mass of its node \[1/T²\].
    fn greatest_row(&self, mass: impl Fn(Node) -> f64) -> f64 {
        let rows = self
            .rows
            .iter()
            .enumerate()
            .flat_map(|(body, own)| own.iter().enumerate().map(move |(a, row)| ((body, a as u32), *row)));
        rows.filter(|(_, row)| *row > 0.0).fold(0.0, |most, (node, row)| (row / mass(node)).max(most))
    }
}
