//! Random bodies that are marched together.

use explicit_dynamics::Amplitude;
use peers::Peers;
use peridynamics::{
    AppliedLoad, Contact, Correction, Crack, Criterion, Elastic, Formulation, Fracture, Law, Mirror, Parts,
    Plastic, Solid, Space, Support, Supported, Volumes,
};
use sph_core::Vec3;

use crate::DX;
use crate::lattices::{ALL, Random, formulation, lattice, parts, poisson};

/// A body, what mirrors it, and how it moves at first.
#[derive(Clone)]
pub struct Body {
    pub parts: Parts,
    pub mirrors: Vec<Mirror>,
    pub rates: Vec<Vec3>,
}

impl Body {
    pub fn build(&self) -> Solid {
        let mut solid = Solid::mirrored(self.parts.clone(), &self.mirrors).unwrap();
        for (node, &rate) in self.rates.iter().enumerate() {
            solid.set_velocity(node, rate);
        }
        solid
    }

    /// With others, if there are any.
    pub fn shared(&self, peers: Option<Box<dyn Peers>>) -> Solid {
        let mut solid = self.build();
        if let Some(peers) = peers {
            solid.share(peers).unwrap();
        }
        solid
    }
}

/// A whole number below a bound.
fn below(random: &mut Random, bound: usize) -> usize {
    ((0.5 * random.next() + 0.5) * bound as f64) as usize
}

/// A block of one to six chunks in space or a plane, pairwise or state-based; held at one end, pulled at the other, loaded and
/// torn, notched, breaking by stretch or by work, yielding, between planes of symmetry.
pub fn body(number: usize, random: &mut Random) -> Body {
    let (space, law) = ALL[number % ALL.len()];
    let three = space == Space::Solid;
    let mut counts = match three {
        true => [14 + below(random, 16), 6 + below(random, 5), 6 + below(random, 5)],
        false => [30 + below(random, 60), 16 + below(random, 24), 1],
    };
    if below(random, 3) == 0 {
        counts.swap(0, 1);
    }
    let block = lattice(if three { 3 } else { 2 }, counts, [DX; 3]);
    let yields = three && law == Law::StateBased && below(random, 4) > 0;
    let volumes = if below(random, 2) == 0 { Volumes::Whole } else { Volumes::Partial };
    let correction = if yields || below(random, 2) == 0 { Correction::Even } else { Correction::None };
    let horizon = if three { 2.015 } else { 3.015 };
    let formulation = Formulation { horizon, volumes, correction, ..formulation(space, law) };
    let criterion = match below(random, 4) {
        0 => None,
        1 => Some(Criterion::EnergyByWork(2e-3)),
        _ => Some(Criterion::Stretch { tension: 0.01, compression: Some(-0.02) }),
    };
    let (middle, far) = (0.5 * DX * counts[1] as f64, DX * counts[1] as f64);
    let notch = match three {
        true => Crack::Polygon(
            [[-1.0, -1.0], [0.5, -1.0], [0.5, 9.0], [-1.0, 9.0]]
                .map(|[x, z]| Vec3::new(x, middle, z))
                .to_vec(),
        ),
        false => Crack::Segment([Vec3::new(-1.0, middle, 0.0), Vec3::new(0.5, middle, 0.0)]),
    };
    let (count, layer) = (block.len() as u32, (block.len() / counts[0]) as u32);
    let ramp = Amplitude::Ramp(0.1);
    let held = Support::Held { displacement: vec![Vec3::x(), Vec3::y()], director: Vec::new() };
    let moved = Support::Moved { direction: Vec3::x(), by: 0.02, amplitude: ramp.clone() };
    let supports = vec![
        Supported { nodes: (0..layer).collect(), support: held },
        Supported { nodes: (count - layer..count).collect(), support: moved },
    ];
    let load = |_| (below(random, count as usize) as u32, Vec3::new(0.01, 0.02, 0.0));
    let loads = vec![AppliedLoad { forces: (0..40).map(load).collect(), amplitude: ramp }];
    let rate = below(random, 3) as f64 * 0.1;
    let rates = block.positions.iter().map(|x| {
        Vec3::y() * (rate * (x.y - middle)) + random.vector(if three { 3 } else { 2 }) * (0.05 * rate)
    });
    let rates = rates.collect();
    let supported = below(random, 4) > 0;
    let loaded = below(random, 3) > 0;
    let notched = below(random, 2) == 0;
    let touches = criterion.is_some() && below(random, 2) == 0;
    // A plane before the nodes, or through the last of them.
    let mirrors = match below(random, 4) {
        0 => vec![Mirror { axis: 1, at: 0.0 }],
        1 if !yields => vec![Mirror { axis: 1, at: far - 0.5 * DX }],
        _ => Vec::new(),
    };
    // A floor under the nodes, and their neighbours, which they touch as bonds break.
    let floor = [Vec3::new(0.0, -0.3 * DX, 0.0), Vec3::y()];
    let contact = (touches && mirrors.is_empty()).then(|| Contact { distance: 0.95, walls: vec![floor] });
    let material = Elastic { young: 100.0, poisson: poisson(space, law), density: 1.0 };
    let parts = Parts {
        plastic: yields.then_some(Plastic { yield_stress: 0.2, hardening: 1.0 }),
        fracture: criterion.map(|criterion| Fracture { criterion, unbreakable: (0..layer).collect() }),
        cracks: if notched { vec![notch] } else { Vec::new() },
        supports: if supported { supports } else { Vec::new() },
        loads: if loaded { loads } else { Vec::new() },
        contact,
        threads: 1 + number % 2,
        ..parts(block, material, formulation)
    };
    Body { parts, mirrors, rates }
}
