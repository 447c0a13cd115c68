//! Paths that go over to the branch that leaves a bifurcation, held against closed forms.

mod common;

use std::ops::ControlFlow;

use common::{Arch, Flat, Hencky, Potential, RigidColumn};
use implicit_statics::{
    Branches, Control, CriticalKind, CriticalOptions, End, EquilibriumError, NewtonOptions, OutOfBounds,
    Path, PathOptions, Start, follow,
};

const BOTH: [(Branches, f64); 2] = [(Branches::Stable, 1.0), (Branches::StableReversed, -1.0)];

fn options(control: Control, branches: Branches) -> PathOptions {
    PathOptions {
        newton: NewtonOptions { tolerance: 1e-12, ..Default::default() },
        critical: Some(CriticalOptions { branches, ..Default::default() }),
        ..PathOptions::new(control)
    }
}

fn arc(first: f64, range: (f64, f64), branches: Branches) -> PathOptions {
    options(Control::ArcLength { first, range }, branches)
}

/// The path from rest, with the state of each of its points.
fn run<P: Potential>(potential: P, options: &PathOptions) -> (Path, Vec<Vec<f64>>) {
    let mut states = Vec::new();
    let path = follow(&mut Flat::new(potential), &Start::default(), options, |_, system| {
        states.push(system.q.clone());
        ControlFlow::Continue(())
    });
    (path, states)
}

/// P = θ/sin θ from P = 1 on, to either side, up to a bound that is met exactly.
#[test]
fn the_rigid_column_buckles_to_the_side_asked_for() {
    for (branches, side) in BOTH {
        let options = PathOptions { largest: 1.0, ..arc(0.05, (0.0, 2.0), branches) };
        let (path, states) = run(RigidColumn, &options);
        assert_eq!((&path.end, path.points.last().unwrap().level()), (&Ok(End::Reached), 2.0));
        let [point] = &path.critical[..] else { panic!("{:?}", path.critical) };
        assert!(point.left && (point.level - 1.0).abs() < 1e-12, "{point:?}");
        assert!(path.points.iter().all(|point| point.inertia().negative == 0), "the branch is stable");
        assert!(path.passages.is_empty(), "{:?}", path.passages);
        let bent: Vec<_> = path.points.iter().zip(&states).filter(|(_, q)| q[0] != 0.0).collect();
        assert!(bent.len() > 5);
        for (point, q) in bent {
            assert!(q[0] * side > 0.0 && (point.level() - q[0] / libm::sin(q[0])).abs() < 1e-10, "{q:?}");
        }
    }
}

/// The branch of a steep arch falls: P = 2 b² z/ℓ³ at x² = h² − 2b² − z², x the way aside.
#[test]
fn a_branch_that_falls_is_followed_down() {
    let (half, height) = (1.0, 2.0);
    for (branches, side) in BOTH {
        let arch = Arch { half, height, sideways: true };
        let cube = arch.bar().powi(3);
        let options = PathOptions { steps: 40, ..arc(0.05, (-0.1, 1.0), branches) };
        let (path, states) = run(arch, &options);
        assert_eq!(path.end, Ok(End::Reached));
        assert!(path.critical[0].left && path.critical[1..].iter().all(|point| !point.left));
        let aside: Vec<_> = path.points.iter().zip(&states).filter(|(_, q)| q[1].abs() > 1e-9).collect();
        assert!(aside.iter().any(|(_, q)| q[1] * side > 1.0), "well aside");
        for (point, q) in aside {
            let z = height - q[0];
            assert!((point.level() - 2.0 * half * half * z / cube).abs() < 1e-10);
            assert!((q[1] * q[1] - (height * height - 2.0 * half * half - z * z)).abs() < 1e-9);
        }
    }
}

/// Critical load `4c/a sin²(π/2n)`; the other side is the mirror image, to the last bit.
#[test]
fn a_chain_bends_in_its_first_mode_and_its_mirror() {
    let exact = Hencky { links: 12 }.critical(1);
    let first = 0.02 * exact;
    let [(path, ahead), (mirrored, behind)] =
        BOTH.map(|(branches, _)| run(Hencky { links: 12 }, &arc(first, (0.0, 1.1 * exact), branches)));
    assert_eq!((&path.end, &mirrored.end), (&Ok(End::Reached), &Ok(End::Reached)));
    assert_eq!(path.critical.len(), 1);
    assert!((path.critical[0].level - exact).abs() < 1e-10 * exact);
    let levels = |path: &Path| path.points.iter().map(|point| point.level()).collect::<Vec<f64>>();
    assert_eq!(levels(&path), levels(&mirrored));
    let other: Vec<Vec<f64>> = behind.iter().map(|q| q.iter().map(|q| -q).collect()).collect();
    assert_eq!(ahead, other);
    let middle = ahead.last().unwrap()[5];
    assert!(middle > 0.2, "{middle}");
}

/// Limit points are passed as on any path, and a path without a bifurcation is the same to the last bit.
#[test]
fn what_is_no_bifurcation_is_left_alone() {
    let arch = || Arch { half: 10.0, height: 1.0, sideways: false };
    let limit = arch().limit();
    let [(path, states), (left, others)] = [Branches::Primary, Branches::Stable]
        .map(|branches| run(arch(), &arc(0.1 * limit, (-2.0 * limit, 1.5 * limit), branches)));
    assert_eq!(states, others);
    assert_eq!((left.critical.len(), &path.critical), (2, &left.critical));
    assert!(left.critical.iter().all(|point| point.kind == CriticalKind::Limit && !point.left));
}

/// Load and displacement go where they are prescribed.
#[test]
fn steps_of_load_stay_on_their_path() {
    let chain = || Hencky { links: 12 };
    let until = 1.1 * chain().critical(3);
    let (path, states) = run(chain(), &options(Control::Load { step: 7.0, until }, Branches::Stable));
    assert_eq!((&path.end, path.critical.len()), (&Ok(End::Reached), 3));
    assert!(path.critical.iter().all(|point| !point.left));
    assert!(states.iter().flatten().all(|&q| q == 0.0));
}

/// Two columns side by side, that know nothing of each other.
struct Twins;

impl Potential for Twins {
    fn unknowns(&self) -> usize {
        2
    }
    fn energy(&self, q: &[f64]) -> f64 {
        (0..2).map(|i| RigidColumn.energy(&q[i..=i])).sum()
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        (0..2).for_each(|i| RigidColumn.gradient(&q[i..=i], &mut out[i..=i]));
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        (0..2).for_each(|i| RigidColumn.hessian(&q[i..=i], &mut |_, _, k| add(i, i, k)));
    }
    fn load(&self, q: &[f64], out: &mut [f64]) {
        (0..2).for_each(|i| RigidColumn.load(&q[i..=i], &mut out[i..=i]));
    }
    fn load_tangent(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        (0..2).for_each(|i| RigidColumn.load_tangent(&q[i..=i], &mut |_, _, k| add(i, i, k)));
    }
}

/// Two modes at one level span a plane of branches: none is chosen.
#[test]
fn a_double_bifurcation_is_not_left() {
    let (path, states) = run(Twins, &arc(0.13, (0.0, 1.5), Branches::Stable));
    assert_eq!(path.end, Ok(End::Reached));
    assert!(path.critical.iter().all(|point| !point.left));
    assert_eq!(path.points.last().unwrap().inertia().negative, 2);
    assert!(states.iter().flatten().all(|&q| q == 0.0));
}

/// A column that must not lean.
struct Guided;

impl Potential for Guided {
    fn unknowns(&self) -> usize {
        1
    }
    fn energy(&self, q: &[f64]) -> f64 {
        RigidColumn.energy(q)
    }
    fn gradient(&self, q: &[f64], out: &mut [f64]) {
        RigidColumn.gradient(q, out);
    }
    fn hessian(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        RigidColumn.hessian(q, add);
    }
    fn load(&self, q: &[f64], out: &mut [f64]) {
        RigidColumn.load(q, out);
    }
    fn load_tangent(&self, q: &[f64], add: &mut dyn FnMut(usize, usize, f64)) {
        RigidColumn.load_tangent(q, add);
    }
    fn within_bounds(&self, q: &[f64]) -> Result<(), OutOfBounds> {
        let place = "the column".into();
        if q[0] == 0.0 { Ok(()) } else { Err(OutOfBounds { place, what: "lean", value: q[0], bound: "0" }) }
    }
}

/// Where no branch is found the path says so, and stands at its last point.
#[test]
fn a_branch_that_is_not_found_ends_the_path() {
    let (path, _) = run(Guided, &arc(0.13, (0.0, 1.5), Branches::Stable));
    let Err(EquilibriumError::NoBranch { level, cause, .. }) = &path.end else { panic!("{:?}", path.end) };
    assert!((level - 1.0).abs() < 1e-12);
    assert!(matches!(cause.as_deref(), Some(EquilibriumError::OutOfBounds { .. })), "{cause:?}");
    assert!(path.restart.level < 1.0 && !path.critical[0].left);
}
