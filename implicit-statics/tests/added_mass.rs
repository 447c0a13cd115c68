//! Modes with the mass of a medium beside a system, against the same mass as numbers of its unknowns.

mod common;

use common::{Flat, Potential};
use implicit_statics::{
    AddedMass, Counted, EquilibriumError, Mode, Spectrum, lowest_modes, natural_modes_with, unwatched,
};

const MASSES: usize = 12;

/// Masses in a row joined by springs, the first to the ground where it is held.
struct Chain {
    held: bool,
}

impl Chain {
    fn entries(&self) -> Vec<((usize, usize), f64)> {
        let springs = |i: usize| {
            let before = i > 0 || self.held;
            100.0 * (f64::from(u8::from(before)) + f64::from(u8::from(i + 1 < MASSES)))
        };
        let diagonal = (0..MASSES).map(|i| ((i, i), springs(i)));
        diagonal.chain((1..MASSES).map(|i| ((i, i - 1), -100.0))).collect()
    }
}

impl Potential for Chain {
    fn unknowns(&self) -> usize {
        MASSES
    }

    fn energy(&self, q: &[f64]) -> f64 {
        let mut force = vec![0.0; MASSES];
        self.gradient(q, &mut force);
        0.5 * q.iter().zip(&force).map(|(q, f)| q * f).sum::<f64>()
    }

    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for ((i, j), value) in self.entries() {
            out[i] += value * q[j];
            if i != j {
                out[j] += value * q[i];
            }
        }
    }

    fn hessian(&self, _q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        self.entries().into_iter().for_each(|((i, j), value)| add(i, j, value));
    }

    fn load(&self, _q: &[f64], out: &mut [f64]) {
        out.fill(0.0);
    }
}

/// What each mass has beside its one.
fn more(i: usize) -> f64 {
    0.3 + (i % 4) as f64
}

fn with_medium(
    held: bool,
    scale: f64,
    (count, shift): (usize, f64),
) -> Result<Spectrum<Mode>, EquilibriumError> {
    // Of each mass a node of its own, p = b a/l: b²/l is its share; half of b twice is b.
    let l = |i: usize| scale * scale * (1.0 + 0.5 * i as f64);
    let half = |i: usize| 0.5 * (more(i) * l(i)).sqrt();
    let flux = (0..MASSES).flat_map(|i| [(i, i, half(i)), (i, i, half(i))]).collect();
    let pattern = (0..MASSES).map(|i| (i, i)).collect();
    let mut added = AddedMass::new(MASSES, pattern, (0..MASSES).map(l).collect(), flux)?;
    let mut ones = vec![0.0; MASSES];
    added.add_product(&[1.0; MASSES], &mut ones)?;
    ones.iter().enumerate().for_each(|(i, own)| assert!((own / more(i) - 1.0).abs() < 1e-14));
    natural_modes_with(&mut Flat::new(Chain { held }), 0.0, &mut added, (count, shift), &mut unwatched)
}

#[test]
fn a_medium_counts_as_the_mass_that_it_is() {
    for (held, shift) in [(true, 0.0), (false, -3.0), (true, 40.0)] {
        for scale in [1.0, 64.0] {
            let chain = Chain { held };
            let (pattern, values): (Vec<_>, Vec<_>) = chain.entries().into_iter().unzip();
            let masses: Vec<f64> = (0..MASSES).map(|i| 1.0 + more(i)).collect();
            let own = lowest_modes(&pattern, &values, &masses, 5, shift, &mut unwatched).unwrap();
            let found = with_medium(held, scale, (5, shift)).unwrap();
            for (one, other) in own.modes.iter().zip(&found.modes) {
                assert!((one.eigenvalue - other.eigenvalue).abs() < 1e-9 * (shift.abs() + one.eigenvalue));
                assert!(other.residual < 1e-7, "{}", other.residual);
                let mass: f64 = other.shape.iter().zip(&masses).map(|(x, m)| m * x * x).sum();
                assert!((mass - 1.0).abs() < 1e-9, "{mass}");
            }
            let Counted { number, .. } = found.counted;
            assert_eq!((number, found.modes.len()), (5, 5), "{held} {shift}");
        }
    }
}

#[test]
fn a_medium_that_is_shut_in_is_refused() {
    let shut = AddedMass::new(2, vec![(0, 0), (1, 0), (1, 1)], vec![1.0, -1.0, 1.0], vec![(0, 0, 1.0)]);
    assert!(matches!(shut, Err(EquilibriumError::Option { .. })));
    let beyond = AddedMass::new(1, vec![(0, 0)], vec![1.0], vec![(1, 0, 1.0)]);
    assert!(matches!(beyond, Err(EquilibriumError::Option { .. })));
    let mut added = AddedMass::new(1, vec![(0, 0)], vec![1.0], vec![(0, MASSES, 1.0)]).unwrap();
    let system = &mut Flat::new(Chain { held: true });
    let refused = natural_modes_with(system, 0.0, &mut added, (1, 0.0), &mut unwatched);
    assert!(matches!(refused, Err(EquilibriumError::Option { .. })));
}
