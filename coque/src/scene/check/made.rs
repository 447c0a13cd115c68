//! Checks of sets that are made of other sets: that they are not made of themselves, and whose they are.

use std::collections::BTreeMap;

use crate::scene::error::{SceneError, Verdict};
use crate::scene::owner::Owner;
use crate::scene::problem::Scene;
use crate::scene::sets::Region;

/// Sets beyond which what one is made of is taken for a mistake: each is found anew wherever it is named.
const MOST: usize = 10_000;

/// Refuses sets that are made of themselves, and those made of more sets than anyone writes down.
pub(super) fn check_circles(scene: &Scene) -> Verdict {
    let mut counted = BTreeMap::new();
    scene.sets.keys().try_for_each(|name| count(scene, name, &mut Vec::new(), &mut counted).map(drop))
}

/// Of how many sets one is made, itself counted; `above` are those that are made of it.
fn count<'a>(
    scene: &'a Scene,
    name: &'a str,
    above: &mut Vec<&'a str>,
    counted: &mut BTreeMap<&'a str, usize>,
) -> Result<usize, SceneError> {
    if let Some(&known) = counted.get(name) {
        return Ok(known);
    }
    let mut sum = 1_usize;
    if let Some((made, names)) = scene.sets.get(name).and_then(Region::made) {
        above.push(name);
        for (i, other) in names.iter().enumerate() {
            let at = || format!("sets.{name}.{}[{i}]", made.word());
            let Some(other) = declared(scene, other) else { continue };
            if let Some(first) = above.iter().position(|known| *known == other) {
                let way = [&above[first..], &[other][..]].concat().join(" → ");
                let bound = format!("but no set is made of itself: {way}");
                let repair = "take one of these names out";
                let fault = scene.source.fault(&at(), &format!("\"{other}\""), &bound, repair);
                return Err(SceneError::Set(fault));
            }
            sum = sum.saturating_add(count(scene, other, above, counted)?);
            if sum > MOST {
                let bound = format!(
                    "but the set is made of more than {MOST} sets by then, each counted as often as it is named"
                );
                let fault = scene.source.fault(&at(), &format!("\"{other}\""), &bound, "name fewer");
                return Err(SceneError::Set(fault));
            }
        }
        above.pop();
    }
    counted.insert(name, sum);
    Ok(sum)
}

/// The declared set that a name means, with or without the body before it.
fn declared<'a>(scene: &'a Scene, name: &str) -> Option<&'a str> {
    let own =
        || name.split_once('.').filter(|(body, _)| scene.bodies.contains_key(*body)).map(|(_, set)| set);
    let known = |name: &str| scene.sets.get_key_value(name).map(|(name, _)| name.as_str());
    known(name).or_else(|| known(own()?))
}

/// In a scene of several bodies: what a set is made of are sets of the one body that has it.
pub(super) fn check_owners_of_made(scene: &Scene) -> Verdict {
    for (name, region) in &scene.sets {
        let Some((made, names)) = region.made() else { continue };
        for (i, other) in names.iter().enumerate() {
            let path = format!("sets.{name}.{}[{i}]", made.word());
            let own = scene.owner_of(region);
            // Without the name of a body it is a set of the one that the set says to be of.
            if region.of.is_some() && !other.contains('.') && !scene.sets.contains_key(other) {
                continue;
            }
            let bound = match Owner::of(scene, &path, other)? {
                Owner::Of(of, _) if Some(of) == own => continue,
                Owner::Of(of, _) => {
                    format!(
                        "a set of `{of}` in one of `{}`: a set belongs to one body",
                        own.unwrap_or_default()
                    )
                }
                Owner::Every => "but a set belongs to one body".into(),
            };
            let repair = "name sets of one body, as in \"gate.all\"";
            let fault = scene.source.fault(&path, &format!("\"{other}\""), &bound, repair);
            return Err(SceneError::Set(fault));
        }
    }
    Ok(())
}
