//! The catalogue: every reference with its source, its units and how far it can be trusted.

mod flows;
mod materials;

use crate::curve::Curve;
use crate::error::ReferenceError;
use serde::Deserialize;
use serde_json::Value;

/// One line of the catalogue; [`Entry::load`] reads the table behind it.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// The name under which [`reference()`] finds it; also the name of its data file.
    pub name: &'static str,
    /// What is tabulated against what.
    pub quantity: &'static str,
    /// How far the values can be trusted, and against what that was checked.
    pub uncertainty: &'static str,
    json: &'static str,
}

/// A data file, embedded so that the crate stands alone.
macro_rules! data {
    ($name:literal) => {
        include_str!(concat!("../data/", $name, ".json"))
    };
}

#[rustfmt::skip]
const CATALOGUE: &[Entry] = &[
    Entry { name: "elastica_end_moment", quantity: "tip displacement against end rotation",
        uncertainty: "exact; rounding of the printed digits, 5e-10", json: data!("elastica_end_moment") },
    Entry { name: "elastica_end_load", quantity: "tip displacement and rotation against dead end load",
        uncertainty: "exact; rounding of the printed digits, 5e-10; shear-flexible or extensible shells differ by EI/(κGA L²) and EI/(EA L²)",
        json: data!("elastica_end_load") },
    Entry { name: "contact_ring_between_plates", quantity: "force on a ring between rigid plates against their distance",
        uncertainty: "exact for the inextensible elastica; rounding of the printed digits, 1e-8; a ring that stretches is 1 % softer at t/R = .05",
        json: data!("contact_ring_between_plates") },
    Entry { name: "contact_friction_closed_forms", quantity: "acceleration on an incline, ratio of tensions over a drum, by Coulomb's friction",
        uncertainty: "exact; rounding of the printed digits, 1e-8; a belt that resists bending lifts off a drum earlier, of the order of B/(T R²)",
        json: data!("contact_friction_closed_forms") },
    Entry { name: "contact_ring_under_pressure", quantity: "opening of a ring, and force between its walls, against external pressure",
        uncertainty: "exact for the inextensible elastica, by shooting to 1e-8; rounding of the printed digits, 1e-9",
        json: data!("contact_ring_under_pressure") },
    Entry { name: "contact_two_cantilevers", quantity: "force between two cantilevers, and their tips, against the force on the upper one",
        uncertainty: "exact for beams of small deflection; rounding of the printed digits, 5e-4 of the gap",
        json: data!("contact_two_cantilevers") },
    Entry { name: "contact_strip_on_cylinder", quantity: "tip of a strip bent over a rigid cylinder against the length that lies on it",
        uncertainty: "exact for the inextensible elastica, by shooting to 1e-11; rounding of the printed digits, 1e-8",
        json: data!("contact_strip_on_cylinder") },
    Entry { name: "contact_fold_between_plates", quantity: "force on a strip folded between rigid plates against their distance",
        uncertainty: "exact for the inextensible elastica; rounding of the printed digits, 1e-8; stretch and shear are of the order of (t/h)²",
        json: data!("contact_fold_between_plates") },
    Entry { name: "contact_cantilever_on_flat", quantity: "force of a rigid flat on a cantilever under pressure, and its free span",
        uncertainty: "exact for beams of small deflection, of the order of (c/L)²; rounding of the printed digits, 1e-8",
        json: data!("contact_cantilever_on_flat") },
    Entry { name: "contact_strip_lifted", quantity: "force on the lifted end of a heavy strip, and the length that hangs",
        uncertainty: "exact for beams of small slope; rounding of the printed digits, 1e-8",
        json: data!("contact_strip_lifted") },
    Entry { name: "contact_hemisphere_on_flat", quantity: "force on a hemisphere against the approach of a rigid flat",
        uncertainty: "two meshes of CalculiX within .3 % from .6 t on, 1 % up to 1.5 t; a shell on its mid-surface lacks a squeeze of .005 t",
        json: data!("contact_hemisphere_on_flat") },
    Entry { name: "sze_cantilever_end_moment", quantity: "tip displacement against end moment",
        uncertainty: "exact columns: rounding of the printed digits, 5e-4; S4R columns: within 0.014 (0.12 % of L) of the exact ones",
        json: data!("sze_cantilever_end_moment") },
    Entry { name: "sze_cantilever_end_shear", quantity: "tip displacement against end shear force",
        uncertainty: "0.02 % of the largest displacement against OpenSees; at most 0.004 (U) and 0.003 (W) from the inextensible elastica of length 10, at full load 0.1 % (U) and 0.03 % (W)",
        json: data!("sze_cantilever_end_shear") },
    Entry { name: "seed_ring_bending", quantity: "tip displacement and rotation against end moment",
        uncertainty: "exact for the inextensible elastica; rounding of the printed digits, 5e-7 cm; a Green–Lagrange shell is up to 6.6 % softer at this t/L = 0.1 (see rolled_strip)",
        json: data!("seed_ring_bending") },
    Entry { name: "seed_panel_limit_points", quantity: "limit point and post-limit minimum of the hinged panel, per source",
        uncertainty: "spread of independent sources at t = 12.7: limit load 1.1 %, its deflection 0.9 %, post-limit minimum load 2.6 %; the seed paper's 10.5 mm is 3.4 % below the others",
        json: data!("seed_panel_limit_points") },
    Entry { name: "sze_hinged_roof_t12p7_isotropic", quantity: "central load against central deflection",
        uncertainty: "1.5 % of the limit load against CalculiX 8x8 (1.1 % at 16x16), 0.7 % against OpenSees",
        json: data!("sze_hinged_roof_t12p7_isotropic") },
    Entry { name: "fe_hinged_roof_t12p7_isotropic", quantity: "central load and edge deflection against central deflection",
        uncertainty: "limit load changes by 0.14 % from 8x8 to 16x16 bricks; within 1.1 % of the limit load of the table of Sze et al.",
        json: data!("fe_hinged_roof_t12p7_isotropic") },
    Entry { name: "sze_hinged_roof_t12p7_0_90_0", quantity: "central load against central deflection, plies 0/90/0",
        uncertainty: "0.75 % of 3000 N against CalculiX 8x8x3, 1.3 % at the limit load; one state between P/Pmax 0.1749 and 0.0999 is missing",
        json: data!("sze_hinged_roof_t12p7_0_90_0") },
    Entry { name: "sze_hinged_roof_t12p7_90_0_90", quantity: "central load against central deflection, plies 90/0/90",
        uncertainty: "within 2.5 % of the limit load against CalculiX 8x8x3",
        json: data!("sze_hinged_roof_t12p7_90_0_90") },
    Entry { name: "sze_hinged_roof_t6p35_isotropic", quantity: "central load against central deflection along the snapping path",
        uncertainty: "0.8 % in path distance (W/17 mm, P/586 N) against CalculiX",
        json: data!("sze_hinged_roof_t6p35_isotropic") },
    Entry { name: "fe_hinged_roof_t6p35_isotropic", quantity: "central load and edge deflection along the snapping path",
        uncertainty: "converged to about 1 %; within 0.8 % in path distance of the table of Sze et al.",
        json: data!("fe_hinged_roof_t6p35_isotropic") },
    Entry { name: "sze_hemisphere_hole", quantity: "displacements under the forces against load",
        uncertainty: "0.1 % (outward) and 0.45 % (inward) of the largest displacement against CalculiX 24x24",
        json: data!("sze_hemisphere_hole") },
    Entry { name: "sze_open_cylinder_pullout", quantity: "displacements of three points against load",
        uncertainty: "0.6 to 0.9 % of the largest displacement against CalculiX 16x24; snap near P/Pmax 0.5 to 0.525",
        json: data!("sze_open_cylinder_pullout") },
    Entry { name: "sze_pinched_cylinder_diaphragm", quantity: "displacements of two points against load",
        uncertainty: "1.1 % of the load up to P/Pmax 0.15; beyond, confirmed in shape only",
        json: data!("sze_pinched_cylinder_diaphragm") },
    Entry { name: "linear_obstacle_course", quantity: "displacement under the load of linear shell benchmarks, one a row",
        uncertainty: "Scordelis-Lo 0.4 %, hemisphere 0.4 %, twisted beam 0.3 % between the published and the computed column; pinched cylinder a series of Kirchhoff's theory, some 2 % below shear-flexible answers that grow with refinement",
        json: data!("linear_obstacle_course") },
    Entry { name: "plate_static_square", quantity: "central deflection of square plates against thickness",
        uncertainty: "2e-5 between two orders of the Ritz series; the thin limits are Timoshenko's to three digits",
        json: data!("plate_static_square") },
    Entry { name: "plate_vibration_square", quantity: "six lowest bending frequencies of square plates against thickness",
        uncertainty: "last column: change between two orders of the Ritz series, 7e-4 at most; NAFEMS FV12 and FV52 within 0.14 %",
        json: data!("plate_vibration_square") },
    Entry { name: "plate_stability", quantity: "tension, compression and buckling loads of a plate 300 x 200 x 2 mm, one a row",
        uncertainty: "closed forms: rounding of the printed digits, 5e-4 kN; published figures: boundary conditions differ from row to row",
        json: data!("plate_stability") },
    Entry { name: "pd_lattice_moduli", quantity: "apparent moduli of peridynamic solids on infinite lattices, one a row",
        uncertainty: "exact sums; rounding of the printed digits, 5e-5", json: data!("pd_lattice_moduli") },
    Entry { name: "pd_strip_bending", quantity: "apparent membrane and bending stiffness of strips of PMB bonds, one a row",
        uncertainty: "exact sums; rounding of the printed digits, 5e-4", json: data!("pd_strip_bending") },
    Entry { name: "kalthoff_winkler", quantity: "angle of the cracks from the notches of a plate struck between them",
        uncertainty: "quoted from memory of the literature; a band, not a value", json: data!("kalthoff_winkler") },
    Entry { name: "holden_cantilever", quantity: "tip of a cantilever against a uniform load, elastica and beam with shear",
        uncertainty: "below 1e-6 of the length between two tolerances of the integrator; a solid as thick as a tenth differs from the beam by what bending theory leaves out",
        json: data!("holden_cantilever") },
    Entry { name: "pysph_dam_break", quantity: "front of a falling column at five times by spacing, with times over those of this project",
        uncertainty: "fronts as computed, to half a spacing; times within a sixth, the machine was shared",
        json: data!("pysph_dam_break") },
    Entry { name: "calculix_linear_shells", quantity: "displacements of linear shells by mesh of S8R and S4, with times over those of this project",
        uncertainty: "discretisation as it is; times within a quarter, the machine was shared",
        json: data!("calculix_linear_shells") },
    Entry { name: "peers_panel", quantity: "limit load of the hinged panel by program and mesh, with times over those of this project",
        uncertainty: "limit loads as their meshes have them; times within a quarter, the machine was shared", json: data!("peers_panel") },
    Entry { name: "peers_strips", quantity: "tips of strips in large rotations by program and mesh, with times over those of this project",
        uncertainty: "tips as their meshes have them; times within a quarter, the machine was shared", json: data!("peers_strips") },
    Entry { name: "calculix_cantilever", quantity: "tip of the solid cantilever at four loads, by mesh of bricks, with processor times",
        uncertainty: "0.06 % between the two finest meshes; times of a shared machine, a fifth",
        json: data!("calculix_cantilever") },
    Entry { name: "finer_lattices", quantity: "answers of bonds, Galerkin solids, a fluid, and water beside a shell on three finer lattices each",
        uncertainty: "of the model alone; their limit is known to a tenth of the difference of the last two where they show an order",
        json: data!("finer_lattices") },
    Entry { name: "calculix_bracket", quantity: "displacement, reaction and five frequencies of a bent sheet with a hole and a flange, by mesh of S8R",
        uncertainty: "0.014 % between extrapolations from two sets of three meshes", json: data!("calculix_bracket") },
    Entry { name: "calculix_tubes", quantity: "work of unit forces on the rims of a branch on a tube and of a pipe on a plate, by mesh of S8R",
        uncertainty: "0.1 % (branch), 0.4 % (pipe) between extrapolations from two sets of three meshes", json: data!("calculix_tubes") },
    Entry { name: "levy_plate", quantity: "central deflection of a thin isotropic plate against pressure, by in-plane edge condition",
        uncertainty: "3e-5 between two orders of the Ritz series; Levy's own table within 0.7 % of straight movable edges",
        json: data!("levy_plate") },
    Entry { name: "zaghloul_orthotropic_plate", quantity: "central deflection of an orthotropic plate against pressure, by in-plane edge condition",
        uncertainty: "1e-5 between two orders of the Ritz series; recalled finite elements within 1 %",
        json: data!("zaghloul_orthotropic_plate") },
    Entry { name: "sr_galerkin_prototype", quantity: "deflections of a prototype of the Galerkin solid, one a row",
        uncertainty: "regression values: half of the fifth digit", json: data!("sr_galerkin_prototype") },
];

/// Every reference there is: shells and solids, then fluids, then structures in fluids.
pub fn catalogue() -> impl Iterator<Item = &'static Entry> {
    CATALOGUE.iter().chain(materials::SHELLS).chain(flows::FLUIDS).chain(flows::STRUCTURES)
}

/// Look a reference up by its name; an unknown name lists the known ones.
pub fn reference(name: &str) -> Result<Reference, ReferenceError> {
    match catalogue().find(|entry| entry.name == name) {
        Some(entry) => entry.load(),
        None => Err(ReferenceError::UnknownReference {
            name: name.to_owned(),
            known: list(catalogue().map(|entry| entry.name)),
        }),
    }
}

/// A column of a reference table.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Column {
    /// The quantity, such as `minus_W_C`.
    pub name: String,
    /// Its unit; "-" without dimension, "length" where the source leaves the units open.
    pub unit: String,
}

/// A table of reference values together with everything needed to judge and to repeat it.
#[derive(Debug, Clone, PartialEq)]
pub struct Reference {
    /// Its name in the catalogue.
    pub name: String,
    /// The problem in one line.
    pub case: String,
    /// What is tabulated against what.
    pub quantity: String,
    /// Where the values were published; "none" for computed ones.
    pub citation: String,
    /// How the values came into the table.
    pub how_obtained: String,
    /// How solid they are held to be, in words.
    pub status: String,
    /// The kind of source: closed form, published table, computed.
    pub provenance: String,
    /// How far the values can be trusted, and against what that was checked.
    pub uncertainty: String,
    /// Dimensions, with their unit where the source states one.
    pub geometry: Value,
    /// Elastic constants, with their unit where the source states one.
    pub material: Value,
    /// Supports, in words.
    pub boundary_conditions: String,
    /// Kind and largest value of the load.
    pub load: Value,
    /// Single numbers or formulas worth quoting; null where there are none.
    pub key_values: Value,
    /// Comparisons with independent codes; null where there are none.
    pub cross_check: Value,
    /// Remarks, one per item.
    pub notes: Vec<String>,
    /// Names and units of the columns.
    pub columns: Vec<Column>,
    /// The table: each cell a number, a text, or null where the source has no value.
    pub rows: Vec<Vec<Value>>,
}

impl Entry {
    /// Read the table from the embedded data.
    pub fn load(&self) -> Result<Reference, ReferenceError> {
        let bad = |reason: String| ReferenceError::BadData { name: self.name.to_owned(), reason };
        let file: DataFile = serde_json::from_str(self.json).map_err(|error| bad(error.to_string()))?;
        let width = file.columns.len();
        if let Some(row) = file.rows.iter().position(|row| row.len() != width) {
            return Err(bad(format!("row {row} has {} cells for {width} columns", file.rows[row].len())));
        }
        Ok(Reference {
            name: self.name.to_owned(),
            case: file.case,
            quantity: self.quantity.to_owned(),
            citation: file.source.citation,
            how_obtained: file.source.how_obtained,
            status: file.status,
            provenance: file.provenance,
            uncertainty: self.uncertainty.to_owned(),
            geometry: file.geometry,
            material: file.material,
            boundary_conditions: file.boundary_conditions,
            load: file.load,
            key_values: file.key_values,
            cross_check: file.cross_check,
            notes: match file.notes {
                Value::String(note) => vec![note],
                Value::Array(notes) => {
                    notes.iter().map(|note| note.as_str().unwrap_or("").to_owned()).collect()
                }
                _ => Vec::new(),
            },
            columns: file.columns,
            rows: file.rows,
        })
    }
}

impl Reference {
    /// One cell as a number, in the unit of its column.
    pub fn number(&self, row: usize, column: &str) -> Result<f64, ReferenceError> {
        let cell = self.cell(row, column)?;
        cell.as_f64().ok_or_else(|| ReferenceError::NotANumber {
            reference: self.name.clone(),
            column: column.to_owned(),
            row,
            found: cell.to_string(),
        })
    }

    /// One cell as a text; a number as the file writes it.
    pub fn text(&self, row: usize, column: &str) -> Result<String, ReferenceError> {
        let cell = self.cell(row, column)?;
        Ok(cell.as_str().map_or_else(|| cell.to_string(), String::from))
    }

    fn cell(&self, row: usize, column: &str) -> Result<&Value, ReferenceError> {
        let index = self.column_index(column)?;
        let cells = self.rows.get(row).ok_or_else(|| ReferenceError::UnknownRow {
            reference: self.name.clone(),
            row,
            last: self.rows.len().saturating_sub(1),
        })?;
        Ok(&cells[index])
    }

    /// A whole column of numbers, in its unit; a text or a missing value is an error that names the row.
    pub fn column(&self, column: &str) -> Result<Vec<f64>, ReferenceError> {
        (0..self.rows.len()).map(|row| self.number(row, column)).collect()
    }

    /// Two columns as a curve y(x); x has to grow from row to row.
    pub fn curve(&self, x: &str, y: &str) -> Result<Curve, ReferenceError> {
        Curve::new(self.column(x)?, self.column(y)?)
    }

    fn column_index(&self, column: &str) -> Result<usize, ReferenceError> {
        self.columns.iter().position(|candidate| candidate.name == column).ok_or_else(|| {
            ReferenceError::UnknownColumn {
                reference: self.name.clone(),
                column: column.to_owned(),
                known: list(self.columns.iter().map(|column| column.name.as_str())),
            }
        })
    }
}

/// The shape of a data file; an unknown key is an error, so that nothing is dropped in silence.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DataFile {
    case: String,
    status: String,
    provenance: String,
    source: Source,
    geometry: Value,
    material: Value,
    boundary_conditions: String,
    load: Value,
    columns: Vec<Column>,
    #[serde(default)]
    key_values: Value,
    #[serde(default)]
    cross_check: Value,
    #[serde(default)]
    notes: Value,
    rows: Vec<Vec<Value>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Source {
    citation: String,
    how_obtained: String,
}

fn list<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAGGED: &str = r#"{"case": "c", "status": "s", "provenance": "p",
        "source": {"citation": "c", "how_obtained": "h"}, "geometry": {}, "material": {},
        "boundary_conditions": "b", "load": {}, "columns": [{"name": "x", "unit": "-"}], "rows": [[1.0], [1.0, 2.0]]}"#;

    fn made_up(json: &'static str) -> Entry {
        Entry { name: "made_up", quantity: "q", uncertainty: "u", json }
    }

    #[test]
    fn a_ragged_table_is_refused_with_its_row() {
        let error = made_up(RAGGED).load().unwrap_err();
        assert!(error.to_string().contains("row 1 has 2 cells for 1 columns"), "{error}");
    }

    #[test]
    fn a_misspelt_key_is_refused() {
        let error = made_up(r#"{"kase": "c"}"#).load().unwrap_err();
        assert!(error.to_string().contains("kase"), "{error}");
    }

    #[test]
    fn an_unknown_name_lists_the_known_ones() {
        let error = reference("sze_roof").unwrap_err().to_string();
        for entry in catalogue() {
            assert!(error.contains(entry.name), "{error} does not list {}", entry.name);
        }
    }

    #[test]
    fn an_unknown_column_or_row_lists_what_there_is() {
        let table = reference("elastica_end_moment").unwrap();
        let error = table.column("w").unwrap_err().to_string();
        assert!(error.contains("theta, u/L, w/L"), "{error}");
        let error = table.number(24, "w/L").unwrap_err().to_string();
        assert!(error.contains("0 to 23"), "{error}");
    }

    #[test]
    fn text_and_missing_values_are_named() {
        let table = reference("seed_panel_limit_points").unwrap();
        let error = table.column("limit_P").unwrap_err().to_string();
        assert!(error.contains("\"limit_P\", row 5 holds null"), "{error}");
        let error = table.number(0, "source").unwrap_err().to_string();
        assert!(error.contains("Sze et al. 2004"), "{error}");
        assert_eq!(table.number(5, "limit_W").unwrap(), 10.5);
    }
}
