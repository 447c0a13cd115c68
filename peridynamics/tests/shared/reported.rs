//! What a march tells, and what is read of its body.

use explicit_dynamics::{
    Bounds, Dynamics, Event, Instant, LinearisedDynamics, March, MarchState, MassScaled, Plan,
};
use peridynamics::Solid;

/// What a march tells up to its end, or up to a number of steps, with some of what is read at its records; and where it stands, if it
/// goes on from there.
pub fn reported(
    plan: &Plan,
    body: &mut Solid,
    steps: u64,
    from: Option<&MarchState>,
) -> (Vec<String>, Option<MarchState>) {
    let mut march = match from {
        Some(state) => March::resume(plan.clone(), state.clone()),
        None => March::start(plan.clone(), body).unwrap(),
    };
    let mut words = Vec::new();
    while march.state().is_none_or(|at| at.clock.steps < steps) {
        match march.advance(body) {
            Ok(Event::Step) => {}
            Ok(Event::End) => return (words, None),
            Ok(event) => {
                words.push(format!("{event:?}"));
                body.bring();
                for node in [0, body.len() / 2, body.len() - 1] {
                    let (stress, energy) = (body.stress(node), body.strain_energy(node));
                    words.push(format!(
                        "{stress:?} {energy} {:?} {}",
                        body.reaction(node),
                        body.damage(node)
                    ));
                }
            }
            Err(error) => {
                words.push(error.to_string());
                return (words, None);
            }
        }
    }
    (words, march.state().cloned())
}

/// The first of what two marches tell that differs.
pub fn differing<'a>(
    one: &'a [String],
    other: &'a [String],
) -> Option<(Option<&'a String>, Option<&'a String>)> {
    (0..one.len().max(other.len()))
        .map(|line| (one.get(line), other.get(line)))
        .find(|(one, other)| one != other)
}

/// All that can be read of a body, then what a look at its forces and its spectrum tells, as bits.
pub fn read(body: &mut Solid) -> Vec<u64> {
    body.bring();
    let mut all = Vec::new();
    all.extend(body.motion().into_iter().flatten().flatten());
    all.extend(body.broken().iter().flatten());
    all.extend(body.flowed().iter().flatten());
    for node in 0..body.len() {
        let forces = [body.internal_force(node), body.external_force(node), body.reaction(node)];
        all.extend(forces.iter().flat_map(|force| force.iter().copied()));
        all.extend(body.stress(node).iter());
        all.extend([body.damage(node), body.fracture_energy(node), body.strain_energy(node)]);
        all.extend(body.plastic_strain(node).into_iter().chain(body.plastic_work(node)));
    }
    all.extend(body.fragments().iter().map(|&nodes| nodes as f64));
    all.push(body.evaluate(Instant { time: 0.05, level: 1.0 }));
    let mut vectors = [vec![0.0; body.unknowns()], vec![0.0; body.unknowns()]];
    body.out_of_balance(&mut vectors[0]);
    MassScaled::rates(body, &mut vectors[1]);
    all.extend([body.dot(&vectors[0], &vectors[1]), body.dot(&vectors[0], &vectors[0]), body.displaced()]);
    all.extend(body.stable_step(0.9).map(|step| step.dt));
    all.push(f64::from(u8::from(body.within_bounds(Bounds::Motion).is_ok())));
    all.into_iter().map(|x: f64| x.to_bits()).collect()
}
