//! Numbers that a scene names: `[parameters]`, and the texts that stand for numbers, `"2 * ${t}"`, in their place.
//!
//! A text is an expression, or an amount with a unit, where the schema has a number. Values go into the document before it becomes a scene, each where its text stood.

use std::collections::BTreeMap;
use std::ops::Range;

use serde::Deserialize;
use serde_json::Value;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::amount::{self, Dimension};
use super::error::{SceneError, Verdict};
use super::expression::{Flaw, Misread, value};
use super::reference::dimension;
use super::source::{Source, suggest};
use super::tables::{Said, admits, walk};
use super::units::{Length, Units};

/// Table of the parameters.
pub(super) const PARAMETERS: &str = "parameters";

/// Whole numbers that decimals hold exactly lie below this.
const WHOLE: f64 = 9_007_199_254_740_992.0;

/// Values of expressions as TOML, by where their text begins.
pub(super) type Values = BTreeMap<usize, String>;

/// Refuses values replaced in parameters that the scene does not have: they would change nothing.
pub(super) fn refuse_unknown(
    document: &DeTable<'_>,
    replaced: &[(String, String)],
    source: &Source,
) -> Verdict {
    let known: Vec<&str> = match document.get(PARAMETERS).map(Spanned::get_ref) {
        Some(DeValue::Table(table)) => table.keys().map(|key| &**key.get_ref()).collect(),
        _ => Vec::new(),
    };
    for (path, _) in replaced {
        let name = path.strip_prefix(PARAMETERS).and_then(|rest| rest.strip_prefix('.'));
        if let Some(name) = name.filter(|name| !known.contains(&name.trim())) {
            let repair = match known.is_empty() {
                true => "the scene has no [parameters]: give the path of the value itself".into(),
                false => suggest(name, &known),
            };
            let value = format!("there is no parameter `{name}`");
            return Err(SceneError::Override(source.fault(
                path,
                &value,
                "a parameter of the scene",
                &repair,
            )));
        }
    }
    Ok(())
}

/// The value of every expression in a document.
///
/// # Errors
/// [`SceneError::Type`] for a text that is no expression, [`SceneError::Value`] for a parameter that is made of itself.
pub(super) fn values(document: &DeTable<'_>, source: &Source) -> Result<Values, SceneError> {
    let table = match document.get(PARAMETERS).map(Spanned::get_ref) {
        Some(DeValue::Table(table)) => Some(table),
        _ => None,
    };
    let units = units(document);
    let mut known = Known { table, units, source, found: BTreeMap::new(), open: Vec::new() };
    let mut values = Values::new();
    walk(document, &mut |path, value, said| {
        let DeValue::String(text) = value.get_ref() else { return Ok(()) };
        if let Some(whole) = expected(said.of, text) {
            let number = known.evaluate(path, value.span(), text, dimension_of(path, said))?;
            values.insert(value.span().start, written(path, number, whole, source)?);
        }
        Ok(())
    })?;
    Ok(values)
}

/// The units of a document, if it has sound ones.
pub(super) fn units(document: &DeTable<'_>) -> Option<Units> {
    let given = document.get("units")?;
    let DeValue::Table(table) = given.get_ref() else { return None };
    let table = Spanned::new(given.span(), table.clone());
    Units::deserialize(toml::de::Deserializer::from(table)).ok()
}

/// What an amount at a path has to measure.
#[derive(Clone, Copy)]
enum Wanted {
    /// Whatever it does: a parameter has no dimension of its own.
    Any,
    /// This.
    Dimension(Dimension),
    /// It is not known.
    Unknown,
}

fn dimension_of(path: &str, said: Said<'_>) -> Wanted {
    if path.strip_prefix(PARAMETERS).is_some_and(|rest| rest.starts_with('.')) {
        return Wanted::Any;
    }
    let descriptions = said.key.iter().filter_map(|schema| schema["description"].as_str());
    let found = descriptions.filter_map(dimension).next().and_then(Dimension::described);
    found.map_or(Wanted::Unknown, Wanted::Dimension)
}

/// Whether a text stands for a number, and whether that is a whole one. A plain word is left to what reads the scene.
fn expected(of: &[&'static Value], text: &str) -> Option<bool> {
    let any = |kind: &str| of.iter().any(|schema| admits(schema, kind));
    let named = any("string") || of.iter().any(|schema| schema.get("enum").or(schema.get("const")).is_some());
    let plain = |c: char| c.is_alphanumeric() || "-_".contains(c);
    let word = text != "pi" && text.starts_with(char::is_alphabetic) && text.chars().all(plain);
    let number = any("number");
    let expression = (number || any("integer")) && !word && (!named || text.contains("${"));
    expression.then_some(!number)
}

/// A number as TOML writes it.
fn written(path: &str, number: f64, whole: bool, source: &Source) -> Result<String, SceneError> {
    if !whole {
        return Ok(format!("{number:?}"));
    }
    if number == libm::trunc(number) && number.abs() < WHOLE {
        return Ok((number as i64).to_string());
    }
    let repair = "round it, as in \"round(${width} / ${spacing})\"";
    Err(SceneError::Type(source.fault(path, &format!("{number:?}"), "a whole number", repair)))
}

/// Parameters, and those whose values are known.
struct Known<'a, 'i> {
    table: Option<&'a DeTable<'i>>,
    units: Option<Units>,
    source: &'a Source,
    found: BTreeMap<String, f64>,
    /// Those that wait for each other.
    open: Vec<String>,
}

impl Known<'_, '_> {
    /// The value of a text at a path, of the dimension that is wanted there if it has a unit.
    fn evaluate(
        &mut self,
        path: &str,
        span: Range<usize>,
        text: &str,
        wanted: Wanted,
    ) -> Result<f64, SceneError> {
        if let Some((number, unit)) = amount::split(text) {
            return self.amount(path, number, unit, wanted);
        }
        let source = self.source;
        match value(text, &mut |name| self.parameter(name)) {
            Ok(number) => Ok(number),
            Err(Flaw::Parameter(error)) => Err(*error),
            Err(Flaw::Text(Misread { at, said, repair })) => {
                let shown = format!("the text \"{text}\"");
                let bound = format!("a number or an expression: {said}");
                let mut fault = source.fault(path, &shown, &bound, &repair);
                fault.place = source.at(Some(source.within(&span, text, &at)));
                Err(SceneError::Type(fault))
            }
        }
    }

    /// A number with a unit, in the units of the scene.
    fn amount(&self, path: &str, number: f64, unit: &str, wanted: Wanted) -> Result<f64, SceneError> {
        let value = format!("the text \"{number} {unit}\"");
        let refuse =
            |bound: &str, repair: &str| Err(SceneError::Type(self.source.fault(path, &value, bound, repair)));
        let bare = "write the number without a unit";
        let Some(units) = self.units.filter(|units| units.consistent() && units.length != Length::None)
        else {
            return refuse("a number without a unit: the scene has no units", bare);
        };
        let Some((found, dimension)) = amount::in_units_of(number, unit, &units) else {
            let bound = format!("a number, or one with a unit that is known: `{unit}` is none");
            let repair = "units are products of m, cm, mm, in, ft, N, kN, MN, lbf, s, ms, us, kg, g, t, Pa, kPa, MPa, GPa, J, kJ, mJ, Hz, \
                          kHz, min, h with powers, as in \"7850 kg/m^3\"; deg, rad";
            return refuse(&bound, repair);
        };
        match (wanted, dimension) {
            (Wanted::Any, _) => Ok(found),
            (Wanted::Dimension(wanted), dimension) if wanted == dimension => Ok(found),
            (Wanted::Dimension(Dimension::Angle { degrees }), Dimension::Angle { .. }) => {
                Ok(if degrees { found.to_degrees() } else { found.to_radians() })
            }
            (Wanted::Dimension(Dimension::Of([0, 0, 0])), _) => refuse("a number without a unit", bare),
            (Wanted::Dimension(wanted), _) => {
                let bound = wanted.word(&units);
                refuse(&bound, "write it in a unit of that dimension, or the number without a unit")
            }
            (Wanted::Unknown, _) => {
                refuse("a number without a unit: the dimension of this key is not known", bare)
            }
        }
    }

    /// The value of a parameter, if there is one of the name.
    fn parameter(&mut self, name: &str) -> Result<Option<f64>, Flaw> {
        if let Some(&known) = self.found.get(name) {
            return Ok(Some(known));
        }
        let Some(given) = self.table.and_then(|table| table.get(name)) else { return Ok(None) };
        let path = format!("{PARAMETERS}.{name}");
        let refuse = |error| Err(Flaw::Parameter(Box::new(error)));
        if self.open.iter().any(|open| open == name) {
            let way = [&self.open[..], &[name.to_string()]].concat().join(" → ");
            let bound = format!("made of others: {way}");
            let repair = "give one of them a number";
            return refuse(self.source.value(&path, "made of itself", &bound, repair));
        }
        if self.open.len() >= DEEPEST {
            let bound = format!("made of parameters that lie at most {DEEPEST} deep in each other");
            return refuse(self.source.value(&path, "deeper", &bound, "give one of them a number"));
        }
        let number = match given.get_ref() {
            DeValue::Float(x) => x.as_str().replace('_', "").parse().ok(),
            DeValue::Integer(n) => {
                i64::from_str_radix(&n.as_str().replace('_', ""), n.radix()).ok().map(|n| n as f64)
            }
            DeValue::String(text) => {
                self.open.push(name.into());
                let found = self.evaluate(&path, given.span(), text, Wanted::Any);
                self.open.pop();
                match found {
                    Ok(number) => Some(number),
                    Err(error) => return refuse(error),
                }
            }
            _ => None,
        };
        let Some(number) = number else {
            let (bound, repair) = ("a number, or an expression of other parameters", "write a number here");
            return refuse(SceneError::Type(self.source.fault(&path, "no number", bound, repair)));
        };
        self.found.insert(name.into(), number);
        Ok(Some(number))
    }
}

/// Parameters made of each other beyond which a scene is taken for a mistake; bounds the recursion.
const DEEPEST: usize = 64;

/// Puts the values where their texts stand.
pub(super) fn put<'i>(document: &mut DeTable<'i>, values: &'i Values) {
    document.iter_mut().for_each(|(_, value)| put_value(value, values));
}

fn put_value<'i>(value: &mut Spanned<DeValue<'i>>, values: &'i Values) {
    let start = value.span().start;
    match value.get_mut() {
        DeValue::Table(table) => put(table, values),
        DeValue::Array(items) => items.iter_mut().for_each(|item| put_value(item, values)),
        text @ DeValue::String(_) => {
            if let Some(Ok(number)) = values.get(&start).map(|number| DeValue::parse(number)) {
                *text = number.into_inner();
            }
        }
        _ => {}
    }
}
