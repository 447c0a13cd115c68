//! What bonds that yield are not for, and the sentence that says so.

use implicit_statics::Equilibrium;
use peridynamics::{
    Correction, Formulation, Idealisation, Law, Parts, Plastic, Sheets, Solid, SolidError, Space, StaticSolid,
};

use crate::blocks::{DX, STEEL, perfect, usual, yielding};
use crate::lattices::{formulation, lattice, parts, plane};

fn refusal(parts: Parts) -> String {
    Solid::new(parts).map(|_| ()).unwrap_err().to_string()
}

#[test]
fn what_cannot_yield_is_refused_with_the_way_out() {
    let cube = || lattice(3, [5; 3], [DX; 3]);
    let with = |plastic, formulation: Formulation| {
        let block = if formulation.space == Space::Solid { cube() } else { plane([9, 9], DX) };
        let poisson =
            if formulation.law == Law::BondBased { formulation.space.pairwise_poisson() } else { 0.3 };
        let material = peridynamics::Elastic { poisson, ..STEEL };
        Parts { plastic: Some(plastic), ..parts(block, material, formulation) }
    };
    let steel = perfect(250e6);
    for yield_stress in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let said = refusal(with(Plastic { yield_stress, ..steel }, usual()));
        assert!(said.contains("the yield stress is") && said.contains("positive"), "{said}");
    }
    let said = refusal(with(Plastic { hardening: -1e9, ..steel }, usual()));
    assert!(said.contains("the hardening modulus is -1000000000"), "{said}");
    let said = refusal(with(steel, formulation(Space::Solid, Law::BondBased)));
    assert!(said.contains("take the state-based formulation"), "{said}");
    for space in [Space::PlaneStress, Space::PlaneStrain] {
        let said = refusal(with(steel, formulation(space, Law::StateBased)));
        assert!(said.contains("take a block of several layers"), "{said}");
    }
    for correction in [Correction::None, Correction::EnergyFactor] {
        let said = refusal(with(steel, Formulation { correction, ..usual() }));
        assert!(said.contains("take the correction `even` or `balanced`"), "{said}");
    }
    let sheets = Sheets { thickness: DX, formulation: formulation(Space::PlaneStress, Law::StateBased) };
    let plate = with(steel, sheets.formulation);
    let said = refusal(Parts { formulation: Idealisation::Sheets(sheets), ..plate });
    assert!(said.contains("two sheets"), "{said}");
}

#[test]
fn statics_of_what_yields_is_refused() {
    let body = yielding(lattice(3, [5; 3], [DX; 3]), usual(), perfect(250e6));
    let said = body.check_statics().unwrap_err();
    assert!(matches!(said, SolidError::Yielding(_)) && said.to_string().contains("quasi-static march"));
    let found = StaticSolid::new(body).within_bounds().unwrap_err();
    assert!(found.bound.contains("quasi-static march"));
    let elastic = Solid::new(parts(lattice(3, [5; 3], [DX; 3]), STEEL, usual())).unwrap();
    assert_eq!(elastic.check_statics(), Ok(()));
}
