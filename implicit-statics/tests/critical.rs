//! Critical points located and distinguished, and the branches that leave them.

mod common;

use std::ops::ControlFlow;

use common::{Arch, Flat, Hencky, RigidColumn};
use implicit_statics::{
    Control, CriticalKind, CriticalOptions, End, Equilibrium, NewtonOptions, Passed, Path, PathOptions,
    Start, follow, switch_branch,
};

fn newton() -> NewtonOptions {
    NewtonOptions { tolerance: 1e-12, ..Default::default() }
}

fn arc(first: f64, range: (f64, f64)) -> PathOptions {
    PathOptions {
        newton: newton(),
        critical: Some(CriticalOptions::default()),
        ..PathOptions::new(Control::ArcLength { first, range })
    }
}

fn run<E: Equilibrium>(system: &mut E, start: &Start, options: &PathOptions) -> Path {
    follow(system, start, options, |_, _| ControlFlow::Continue(()))
}

#[test]
fn limit_points_of_the_arch() {
    let mut system = Flat::new(Arch { half: 10.0, height: 1.0, sideways: false });
    let limit = system.potential.limit();
    let path = run(&mut system, &Start::default(), &arc(0.1 * limit, (-2.0 * limit, 1.5 * limit)));
    assert_eq!(path.critical.len(), 2);
    for (point, (sign, negative)) in path.critical.iter().zip([(1.0, (0, 1)), (-1.0, (1, 0))]) {
        assert_eq!((point.kind, point.negative), (CriticalKind::Limit, negative));
        assert!((point.level - sign * limit).abs() < 1e-9 * limit, "{} {limit}", point.level);
        assert!((point.participation - 1.0).abs() < 1e-12);
        assert!(((1.0 - point.state[0]) - sign / 3.0_f64.sqrt()).abs() < 1e-5);
    }
}

/// A steep arch leans aside before its limit load: at z² = h² − 2b², and then P = 2 b² z/ℓ³ with
/// x² = h² − 2b² − z².
#[test]
fn a_steep_arch_leans_aside() {
    let (half, height) = (1.0, 2.0);
    let mut system = Flat::new(Arch { half, height, sideways: true });
    let cube = system.potential.bar().powi(3);
    let exact = 2.0 * half * half * 2.0_f64.sqrt() / cube;
    let path = run(&mut system, &Start::default(), &arc(0.05, (-1.0, 1.0)));
    assert_eq!(path.end, Ok(End::Reached));
    let counts: Vec<_> = path.critical.iter().map(|p| (p.kind, p.negative)).collect();
    use CriticalKind::{Bifurcation, Limit};
    let expected = [(Bifurcation, (0, 1)), (Limit, (1, 2)), (Limit, (2, 1)), (Bifurcation, (1, 0))];
    assert_eq!(counts, expected);
    let point = &path.critical[0];
    assert!((point.level - exact).abs() < 1e-9 * exact, "{} {exact}", point.level);
    assert!(point.participation < 1e-9);
    assert!((point.mode[1] - 1.0).abs() < 1e-12 && point.mode[0].abs() < 1e-6, "{:?}", point.mode);

    for side in [1.0, -1.0] {
        let start = switch_branch(&mut system, point, side * 1e-3, &newton()).unwrap();
        assert!((system.q[1] - side * 1e-3).abs() < 1e-9);
        let mut seen = 0;
        let options = PathOptions { steps: 60, ..arc(-0.01, (-1.0, 1.0)) };
        let path = follow(&mut system, &start, &options, |branch, system| {
            let (z, aside) = (height - system.q[0], system.q[1]);
            assert!((branch.level() - 2.0 * half * half * z / cube).abs() < 1e-10);
            assert!((aside * aside - (height * height - 2.0 * half * half - z * z)).abs() < 1e-9);
            seen += usize::from(aside * side > 0.5);
            if z < 0.5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!(path.end, Ok(End::Stopped));
        assert!(seen > 3, "the branch is followed well aside");
    }
}

#[test]
fn the_rigid_column_buckles_and_its_branch_rises() {
    let mut system = Flat::new(RigidColumn);
    let path = run(&mut system, &Start::default(), &arc(0.13, (0.0, 1.5)));
    let point = &path.critical[0];
    assert_eq!((path.critical.len(), point.kind), (1, CriticalKind::Bifurcation));
    assert!((point.level - 1.0).abs() < 1e-12, "{}", point.level);

    let start = switch_branch(&mut system, point, 1e-2, &newton()).unwrap();
    let options = PathOptions { load_share: 0.0, ..arc(0.1, (0.0, 2.0)) };
    let path = follow(&mut system, &start, &options, |branch, system| {
        let angle: f64 = system.q[0];
        assert!((branch.level() - angle / libm::sin(angle)).abs() < 1e-10);
        assert_eq!(branch.inertia().negative, 0, "the branch is stable");
        ControlFlow::Continue(())
    });
    assert_eq!((path.end, path.points.last().unwrap().level()), (Ok(End::Reached), 2.0));
}

#[test]
fn a_chain_buckles_in_its_first_three_modes_and_carries_on() {
    let mut system = Flat::new(Hencky { links: 12 });
    let exact: Vec<f64> = (1..4).map(|m| system.potential.critical(m)).collect();
    let control = Control::Load { step: 7.0, until: 1.1 * exact[2] };
    let options = PathOptions { critical: Some(CriticalOptions::default()), ..PathOptions::new(control) };
    let path = run(&mut system, &Start::default(), &options);
    assert_eq!(path.end, Ok(End::Reached));
    assert_eq!(path.points.last().unwrap().inertia().negative, 3);
    assert_eq!(path.critical.len(), 3);
    for (point, exact) in path.critical.iter().zip(&exact) {
        assert_eq!(point.kind, CriticalKind::Bifurcation);
        assert!((point.level - exact).abs() < 1e-10 * exact, "{} {exact}", point.level);
    }
    // the mode is half a sine
    let first = &path.critical[0].mode;
    for (i, y) in first.iter().enumerate() {
        let sine = libm::sin(std::f64::consts::PI * (i + 1) as f64 / 12.0);
        assert!((y - sine).abs() < 1e-6, "{y} {sine}");
    }
}

#[test]
fn what_cannot_be_located_is_bracketed() {
    for control in
        [Control::Load { step: 0.3, until: 1.5 }, Control::ArcLength { first: 0.3, range: (0.0, 1.5) }]
    {
        let options = PathOptions {
            newton: newton(),
            critical: Some(CriticalOptions::default()),
            ..PathOptions::new(control)
        };
        let mut gap = Flat::new(RigidColumn);
        gap.forceless = Some(0.99..1.01);
        let path = run(&mut gap, &Start::default(), &options);
        assert_eq!(path.end, Ok(End::Reached));
        assert!(path.critical.is_empty());
        let [passage] = &path.passages[..] else { panic!("{:?}", path.passages) };
        assert_eq!((passage.what, passage.negative), (Passed::Pivots, (0, 1)));
        let (low, high) = passage.levels;
        // Brackets are cut until every trial between falls into the gap.
        assert!((0.9..0.99).contains(&low) && (1.01..1.1).contains(&high), "{low} {high}");
    }
}
