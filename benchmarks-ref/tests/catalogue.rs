//! Every entry of the catalogue is complete, and its key digits agree with the closed forms.

use approx::assert_abs_diff_eq;
use benchmarks_ref::{Curve, catalogue, elastica, reference};
use std::collections::BTreeSet;
use std::f64::consts::PI;

#[test]
fn every_entry_is_complete() {
    assert!(catalogue().next().is_some());
    for entry in catalogue() {
        let table = entry.load().unwrap_or_else(|error| panic!("{}: {error}", entry.name));
        let name = &table.name;
        for (field, text) in [
            ("case", &table.case),
            ("quantity", &table.quantity),
            ("citation", &table.citation),
            ("how_obtained", &table.how_obtained),
            ("status", &table.status),
            ("provenance", &table.provenance),
            ("uncertainty", &table.uncertainty),
            ("boundary_conditions", &table.boundary_conditions),
        ] {
            assert!(!text.trim().is_empty(), "{name}: {field} is empty");
        }
        for (field, value) in
            [("geometry", &table.geometry), ("material", &table.material), ("load", &table.load)]
        {
            assert!(!value.is_null(), "{name}: {field} is missing");
        }
        assert!(table.columns.len() >= 2 && table.rows.len() >= 2, "{name}: no table");
        assert!(table.notes.iter().all(|note| !note.is_empty()), "{name}: a note is no text");
        for column in &table.columns {
            assert!(!column.unit.is_empty(), "{name}: column {} has no unit", column.name);
        }
        for row in &table.rows {
            assert!(
                row.iter().all(|cell| cell.is_number() || cell.is_string() || cell.is_null()),
                "{name}: {row:?}"
            );
            assert!(row.iter().any(serde_json::Value::is_number), "{name}: a row without a number");
        }
    }
}

#[test]
fn names_are_unique_and_columns_too() {
    let names: BTreeSet<_> = catalogue().map(|entry| entry.name).collect();
    assert_eq!(names.len(), catalogue().count());
    for entry in catalogue() {
        let table = entry.load().unwrap();
        let columns: BTreeSet<_> = table.columns.iter().map(|column| &column.name).collect();
        assert_eq!(columns.len(), table.columns.len(), "{}", table.name);
    }
}

/// The ring of the seed paper is the elastica of length 10: six decimals of a centimetre are printed, eight of a radian.
#[test]
fn the_seed_ring_is_the_elastica() {
    let table = reference("seed_ring_bending").unwrap();
    for row in 0..table.rows.len() {
        let tip = elastica::end_moment(2.0 * PI * table.number(row, "M/Mmax").unwrap());
        assert_abs_diff_eq!(10.0 * tip.u, table.number(row, "minus_U_tip").unwrap(), epsilon = 0.51e-6);
        assert_abs_diff_eq!(10.0 * tip.w, table.number(row, "W_tip").unwrap(), epsilon = 0.51e-6);
        assert_abs_diff_eq!(tip.theta, table.number(row, "theta_tip").unwrap(), epsilon = 0.51e-8);
    }
    // Mmax = 2π E I/L with E = 1200, I = 1/12, L = 10
    assert_abs_diff_eq!(table.load["Mmax"].as_f64().unwrap(), 2.0 * PI * 10.0, epsilon = 1e-13);
}

/// The exact columns of Sze et al., length 12, three decimals; the Abaqus columns as far off as the catalogue says.
#[test]
fn the_sze_ring_is_the_elastica() {
    let table = reference("sze_cantilever_end_moment").unwrap();
    for row in 0..table.rows.len() {
        let tip = elastica::end_moment(2.0 * PI * table.number(row, "M/Mmax").unwrap());
        assert_abs_diff_eq!(12.0 * tip.u, table.number(row, "minus_U_tip_exact").unwrap(), epsilon = 0.51e-3);
        assert_abs_diff_eq!(12.0 * tip.w, table.number(row, "W_tip_exact").unwrap(), epsilon = 0.51e-3);
        for quantity in ["minus_U_tip", "W_tip"] {
            let exact = table.number(row, &format!("{quantity}_exact")).unwrap();
            let abaqus = table.number(row, &format!("{quantity}_S4R")).unwrap();
            assert_abs_diff_eq!(abaqus, exact, epsilon = 0.0141);
        }
    }
}

/// Abaqus S4R under the end shear stays as close to the elastica with α = 4 P/Pmax as the catalogue says.
#[test]
fn the_sze_end_shear_is_close_to_the_elastica() {
    let table = reference("sze_cantilever_end_shear").unwrap();
    for row in 0..table.rows.len() {
        let tip = elastica::end_load(4.0 * table.number(row, "P/Pmax").unwrap());
        assert_abs_diff_eq!(10.0 * tip.u, table.number(row, "minus_U_tip").unwrap(), epsilon = 0.004);
        assert_abs_diff_eq!(10.0 * tip.w, table.number(row, "W_tip").unwrap(), epsilon = 0.003);
    }
}

/// Limit point and post-limit minimum by our parabola, against the fits stored with both panel tables.
#[test]
fn limit_points_of_the_panel() {
    let published = reference("sze_hinged_roof_t12p7_isotropic").unwrap();
    let load: Vec<f64> = published.column("P/Pmax").unwrap().iter().map(|ratio| 3000.0 * ratio).collect();
    let published_curve = Curve::new(published.column("minus_W_C").unwrap(), load).unwrap();
    let computed_curve =
        reference("fe_hinged_roof_t12p7_isotropic").unwrap().curve("minus_W_C", "P").unwrap();

    // expected values: key_values of the first file, notes of the second
    for (curve, limit, minimum) in [
        (&published_curve, (10.876, 2231.2), (19.542, 515.1)),
        (&computed_curve, (10.865, 2207.7), (19.492, 518.8)),
    ] {
        let top = curve.maximum(..15.0).unwrap();
        assert_abs_diff_eq!(top.x, limit.0, epsilon = 0.51e-3);
        assert_abs_diff_eq!(top.y, limit.1, epsilon = 0.051);
        let bottom = curve.minimum(15.0..).unwrap();
        assert_abs_diff_eq!(bottom.x, minimum.0, epsilon = 0.51e-3);
        assert_abs_diff_eq!(bottom.y, minimum.1, epsilon = 0.051);
    }

    // the stored cross-check: 24.4 N at most between the two, at the deflection 12.141 of the published table
    let worst = computed_curve.max_difference(&published_curve, ..).unwrap();
    assert_abs_diff_eq!(worst.y, 24.4, epsilon = 0.5);
    assert_abs_diff_eq!(worst.x, 12.141, epsilon = 1e-9);
}

/// The spreads that the catalogue states for t = 12.7, from the rows themselves (the seed's own row left out).
#[test]
fn spread_of_the_panel_sources() {
    let table = reference("seed_panel_limit_points").unwrap();
    for (column, percent) in [("limit_P", 1.1), ("limit_W", 0.9), ("post_limit_min_P", 2.6)] {
        let values: Vec<f64> = (0..5).map(|row| table.number(row, column).unwrap()).collect();
        let (low, high) = values.iter().fold((f64::MAX, f64::MIN), |(a, b), &v| (a.min(v), b.max(v)));
        assert_abs_diff_eq!(100.0 * (high - low) / low, percent, epsilon = 0.06);
    }
}

/// Buckling loads of thin-plate theory \[timoshenko1961\], against the digits stored: three decimals of a kilonewton.
#[test]
fn the_plate_buckles_by_its_closed_forms() {
    let table = reference("plate_stability").unwrap();
    let number = |value: &serde_json::Value, key: &str| value[key].as_f64().unwrap();
    let [a, b] = ["length_a", "width_b"].map(|key| number(&table.geometry, key));
    let (young, nu) = (number(&table.material, "E"), number(&table.material, "nu"));
    let bending = young * number(&table.geometry, "thickness").powi(3) / (12.0 * (1.0 - nu * nu));
    for row in 0..table.rows.len() {
        let quantity = table.rows[row][0].as_str().unwrap();
        let Some(edges) = quantity.strip_prefix("critical load, side edges ") else { continue };
        let waves: f64 = if edges.ends_with("m=1") { 1.0 } else { 2.0 };
        let ratio = waves * b / a;
        let k = match edges.starts_with("free") {
            true => (ratio + 1.0 / ratio).powi(2),
            false => (ratio * ratio + 1.0).powi(2) / (ratio * ratio + nu),
        };
        let load = 1e-3 * k * PI * PI * bending / b;
        assert_abs_diff_eq!(load, table.number(row, "value").unwrap(), epsilon = 0.51e-3);
    }
}

/// The thin plates are those of Timoshenko's tables \[timoshenko1959\]: 0.00406 and 0.00126, five decimals.
#[test]
fn thin_square_plates_are_those_of_the_tables() {
    let table = reference("plate_static_square").unwrap();
    for (bc, thin) in [("SSSS", 0.00406), ("CCCC", 0.00126)] {
        let row = (0..table.rows.len()).find(|&row| table.rows[row][0] == bc).unwrap();
        assert_eq!(table.number(row, "h/a").unwrap(), 0.001);
        assert_abs_diff_eq!(table.number(row, "w_c D/(q a^4)").unwrap(), thin, epsilon = 0.6e-5);
    }
}

/// A plate pressed equally along both axes by N = E t αθ/(1 − ν) buckles at 2π²D/a²; two metals bend as \[timoshenko1925\] has it for any thicknesses.
#[test]
fn heated_shells_are_their_closed_forms() {
    let table = reference("heated_shells").unwrap();
    let (side, thickness, young, poisson, expansion) = (0.5, 0.004_f64, 70e9, 0.3, 23e-6);
    let bending = young * thickness.powi(3) / (12.0 * (1.0 - poisson * poisson));
    let force = 2.0 * PI * PI * bending / (side * side);
    let change = force * (1.0 - poisson) / (young * thickness * expansion);
    assert_abs_diff_eq!(table.number(0, "value").unwrap(), change, epsilon = 0.51e-10);
    let ([m, n], height) = ([1.0, 2.0_f64], 0.001);
    let below = 3.0 * (1.0_f64 + m).powi(2) + (1.0 + m * n) * (m * m + 1.0 / (m * n));
    let curvature = 6.0 * 8e-6 * 100.0 * (1.0_f64 + m).powi(2) / (height * below);
    assert_abs_diff_eq!(table.number(1, "value").unwrap(), curvature, epsilon = 0.51e-10);
    // Two sines along x: what the uneven N₂ couples, −(1 − ν) 32/(9π²) N of the unit, lowers the root; ten sines more by 3e-6.
    let unit = (PI / side).powi(2);
    let stiffness = |i: f64| bending * unit * (i * i + 1.0).powi(2) / force;
    let (a, b, coupled) = (stiffness(1.0), stiffness(2.0), (1.0 - poisson) * 32.0 / (9.0 * PI * PI));
    let (sum, product) = (a * 5.0 + b * 2.0, 2.0 * 5.0 - coupled * coupled);
    let root = (sum - (sum * sum - 4.0 * product * a * b).sqrt()) / (2.0 * product);
    assert_abs_diff_eq!(table.number(2, "value").unwrap() / (change * root), 1.0, epsilon = 1e-5);
    let m = (2.0 * 50.0 / (200.0 * 0.003_f64)).sqrt();
    assert_abs_diff_eq!(table.number(3, "value").unwrap(), 80.0 / libm::cosh(0.1 * m), epsilon = 0.51e-10);
    let heat = 200.0 * 0.003 * 0.05 * m * 80.0 * libm::tanh(0.1 * m);
    assert_abs_diff_eq!(table.number(4, "value").unwrap(), heat, epsilon = 0.51e-10);
    for (row, time) in [(5, 20.0), (6, 60.0)] {
        let term = |k: f64| {
            let decay = (k * PI / 0.1).powi(2) * 45.0 / (7850.0 * 480.0);
            4.0 / (k * PI) * libm::sin(0.5 * k * PI) * libm::exp(-decay * time)
        };
        let series: f64 = (0..40).map(|n| term(f64::from(2 * n + 1))).sum();
        let exact = 480.0 * series * series * libm::exp(-200.0 / (7850.0 * 480.0 * 0.002) * time);
        assert_abs_diff_eq!(table.number(row, "value").unwrap(), exact, epsilon = 0.51e-10);
    }
}

/// A ply under σ at an angle: `A σ² + B σ = 1` with `A = F₁₁c⁴ + F₂₂s⁴ + (F₆₆ + 2F₁₂)s²c²`, `B = F₁c² + F₂s²` \[tsai1971\].
#[test]
fn plies_off_their_axis_are_their_closed_form() {
    let table = reference("ply_strength").unwrap();
    let (f11, f22, f66): (f64, f64, f64) =
        (1.0 / 1500.0_f64.powi(2), 1.0 / (40.0 * 246.0), 1.0 / 68.0_f64.powi(2));
    for (row, angle) in [(0, 15.0_f64), (1, 45.0), (2, 75.0)] {
        let (s, c) = libm::sincos(angle.to_radians());
        let [ss, cc] = [s * s, c * c];
        let f12 = -0.5 * (f11 * f22).sqrt();
        let a = f11 * cc * cc + f22 * ss * ss + (f66 + 2.0 * f12) * ss * cc;
        let b = (1.0 / 40.0 - 1.0 / 246.0) * ss;
        let strength = (-b + (b * b + 4.0 * a).sqrt()) / (2.0 * a);
        // 25 N/mm on half a millimetre.
        assert_abs_diff_eq!(table.number(row, "tsai-wu").unwrap(), strength / 50.0, epsilon = 0.51e-9);
    }
}
