//! Shells that several march together and that touch tools or themselves, enclose a gas, or bear a load that says nothing of shares: the same bits as
//! one marches them.

use crate::common::{DENSITY, Sheets, YOUNG, flat, parts, supported};
use crate::shared::{marched, plans, shared};
use contact::{Law, ToolShape, stiffness};
use explicit_dynamics::{Amplitude, Plan, Transient};
use peers::{CHUNK, together};
use shell_kinematics::StretchCorrected;
use sph_core::{Cloud, Cylinder, EndWeights, Side, Vec3, lattice};
use sph_shell::{
    AppliedLoad, Block, Body, Clamped, Content, Enclosed, Formulation, Load, LoadCase, OwnContact, Parts,
    Reach, Reference, Shell, ShellError, Tool,
};

const CELLS: Formulation = Formulation::StressPoint(Reach::Cell);
const THICKNESS: f64 = 0.05;

/// A tube, open along its length, of several chunks.
fn tube() -> Cloud {
    let shape = Cylinder { radius: 1.0, angles: [0.2, 6.1], length: 1.0 };
    lattice(&shape, [81, 14], EndWeights::Trapezoid).unwrap()
}

/// Its walls are thrown at each other, and rub; one of them at a tool that goes round.
fn thrown(threads: usize) -> Shell {
    let cloud = tube();
    let rest = cloud.positions.clone();
    let stiffness = 0.5 * stiffness(YOUNG, THICKNESS, cloud.spacing());
    let law = Law::new(0.05).unwrap();
    let own = OwnContact { law, stiffness, edges: true, friction: 0.3 };
    let tool = Tool {
        shape: ToolShape::Sphere { centre: Vec3::new(0.2, 0.5, 1.36), radius: 0.3 },
        moved: Vec3::new(0.3, 0.1, -0.5),
        turn: 0.0,
        friction: 0.2,
        amplitude: Amplitude::Ramp(0.8),
        case: LoadCase::Loading,
        law,
        stiffness,
    };
    let parts = Parts { threads, ..parts(cloud, CELLS, THICKNESS) };
    let mut shell = Shell::builder(parts).touching_itself(own).tools(vec![tool]).build().unwrap();
    let speed = 0.05 * (YOUNG / DENSITY).sqrt();
    for (a, x) in rest.iter().enumerate() {
        let wave = 1.0 + 0.3 * libm::sin(5.0 * x.y + 3.0 * x.x);
        shell.set_rate(a, Vec3::new(0.1 * x.x, 0.1 * x.z, -x.z * wave) * speed, Vec3::zeros());
    }
    shell
}

/// A weight that says nothing of shares.
struct Unsaid;

impl Load for Unsaid {
    fn add(&self, scale: f64, body: &Body<'_>, forces: &mut [[f64; 6]]) {
        let middle = body.state.iter().map(|row| row[0]).sum::<f64>() / body.state.len() as f64;
        forces.iter_mut().for_each(|force| force[2] += 1e-4 * scale * middle);
    }

    fn stiffness(&self, _: f64, _: &Body<'_>, _: &mut dyn FnMut(u32, u32, &Block)) {}

    fn check(&self, _: &Reference) -> Result<(), ShellError> {
        Ok(())
    }
}

/// A strip under a load that depends on where all of it is.
fn loaded(threads: usize) -> Shell {
    let cloud = flat([121, 11], [3.0, 0.25]);
    let held = cloud.sides.as_ref().unwrap().edge(Side::U0).to_vec();
    let loads = vec![AppliedLoad { load: Box::new(Unsaid), amplitude: Amplitude::Constant }];
    let supports = vec![supported(held, Clamped)];
    let parts =
        Parts { supports, loads, threads, strain: &StretchCorrected, ..parts(cloud, CELLS, THICKNESS) };
    Shell::builder(parts).build().unwrap()
}

/// A box that a gas blows up.
fn boxed(threads: usize) -> Shell {
    let cloud = Sheets::boxed(Vec3::new(2.0, 3.0, 1.5), [12, 15, 10]).cloud();
    let content = Content::Gas { pressure: 0.4, ambient: 0.1, exponent: 1.4 };
    let load = Box::new(Enclosed::new((0..cloud.cells.len() as u32).collect(), content, 0.0));
    let loads = vec![AppliedLoad { load, amplitude: Amplitude::Ramp(0.3) }];
    // It does not move away.
    let corner = vec![supported(vec![0, 1, 2, 20, 21, 40], Clamped)];
    let parts = Parts { loads, supports: corner, threads, ..parts(cloud, CELLS, 0.1) };
    Shell::builder(parts).build().unwrap()
}

/// What is found beside records and motion: forces of contact, gaps, losses, what is enclosed.
fn touched(plan: &Plan, mut shell: Shell) -> (Vec<String>, Vec<u64>) {
    let (records, mut read) = marched(plan, &mut shell);
    let gaps = shell.contact_gaps(&(0..shell.len() as u32).collect::<Vec<u32>>());
    let of = |a: usize| {
        let force = shell.contact_force(a);
        let [pressure, volume] = shell.enclosed_at(a);
        [force.x, force.y, force.z, gaps[a], shell.friction_loss(a), pressure, volume]
    };
    read.extend((0..shell.len()).flat_map(of).chain(shell.contact_state()).map(f64::to_bits));
    (records, read)
}

#[test]
fn what_sees_the_whole_shell_tells_the_same_whoever_marches_it() {
    let bodies: [fn(usize) -> Shell; 3] = [thrown, boxed, loaded];
    for (name, body) in ["thrown", "boxed", "loaded"].into_iter().zip(bodies) {
        assert!(body(1).len() > 2 * CHUNK);
        for (number, mut plan) in plans().into_iter().enumerate() {
            if let (Plan::Transient(transient), "thrown") = (&mut plan, name) {
                (transient.duration, transient.record_every) = (1.1, 0.1);
            }
            if let (Plan::QuasiStatic(_), "thrown") = (&plan, name) {
                continue; // It does not come to rest: it is not held.
            }
            let alone = touched(&plan, body(1));
            assert!(alone.0.len() > 2, "{name}: {:?}", alone.0);
            for count in [2, 7] {
                let threads = 1 + (count + number) % 2;
                let all = together(count, |peers| touched(&plan, shared(body(threads), peers))).unwrap();
                for (rank, found) in all.into_iter().enumerate() {
                    assert!(found == alone, "{name}: {count} peers, rank {rank}, {threads} threads");
                }
            }
            if name == "thrown" {
                let mut shell = body(1);
                marched(&plan, &mut shell);
                let (own, tool) = (shell.own_touch().unwrap().area, shell.touches()[0].area);
                let lost: f64 = (0..shell.len()).map(|a| shell.friction_loss(a)).sum();
                println!("{own:.3} {tool:.3} {lost:.2e}");
                assert!(lost > 0.0 && (own > 0.0 || tool > 0.0));
            }
        }
    }
}

/// Three march a tube until its walls rub, others go on from what they kept: to the bits of one.
#[test]
fn a_march_in_contact_goes_on_with_other_peers() {
    let first = Transient { duration: 1.06, record_every: 0.2, damping: 0.0, safety: 0.8 };
    let second = Plan::from(Transient { duration: 0.1, ..first });
    let kept = together(3, |peers| {
        let mut shell = shared(thrown(1), peers);
        marched(&first.into(), &mut shell);
        let [state, rates] = shell.motion().map(<[[f64; 6]]>::to_vec);
        let lost: f64 = (0..shell.len()).map(|a| shell.friction_loss(a)).sum();
        (state, rates, shell.history(), shell.contact_state(), lost)
    });
    let (state, rates, history, contact, lost) = &kept.unwrap()[1];
    assert!(!contact.is_empty() && *lost > 0.0, "nothing rubs");
    let go_on = |mut shell: Shell| {
        assert!(shell.take_up([state, rates]) && shell.take_up_history(history));
        assert!(shell.take_up_contact(contact));
        touched(&second, shell)
    };
    let alone = go_on(thrown(1));
    for count in [2, 4] {
        let all = together(count, |peers| go_on(shared(thrown(2), peers))).unwrap();
        assert!(all.iter().all(|found| *found == alone), "{count} peers");
    }
}
