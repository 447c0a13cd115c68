// What can be shown in colour: each field of any body, its components, lengths of vectors, and what has a value at either face.

const AXES = ["x", "y", "z"];

/** Joins two ranges. */
function united(a, b) {
  if (!a) return { ...b };
  return { low: Math.min(a.low, b.low), high: Math.max(a.high, b.high), lower: Math.min(a.lower, b.lower), upper: Math.max(a.upper, b.upper) };
}

/** All choices by name, from the tracks of all bodies: `parts` has the track and component of each body. */
function choicesOf(bodies) {
  const choices = new Map();
  const add = (name, unit, range, body, part) => {
    const choice = choices.get(name) ?? { name, unit, parts: new Map() };
    choice.range = united(choice.range, range);
    choice.parts.set(body, part);
    choices.set(name, choice);
  };
  bodies.forEach((body, number) => body.tracks.forEach(track => {
    const { name, unit, components, width, ranges, lengths } = track.head;
    if (lengths) add(name, unit, lengths, number, { track, component: -1 });
    for (let component = 0; component < width; component++) {
      const of = width === 1 ? name : `${name}.${components[component] ?? AXES[component] ?? component + 1}`;
      add(of, unit, ranges[component], number, { track, component });
    }
  }));
  for (const [name, top] of [...choices]) {
    const bottom = choices.get(name.replace("_top", "_bottom"));
    if (!name.includes("_top") || !bottom) continue;
    const both = name.replace("_top", "") + " (both faces)";
    for (const [body, part] of top.parts) {
      const below = bottom.parts.get(body);
      if (below && bodies[body].head.shell) add(both, top.unit, united(top.range, bottom.range), body, { ...part, below });
    }
  }
  return choices;
}

/** The range that suits a choice: numbers of particles have outliers that would leave all others one colour. */
function suitedRange(choice, bodies) {
  const { low, high, lower, upper } = choice.range, particles = [...choice.parts.keys()].every(body => !bodies[body].solid);
  return particles && high - low > 2 * (upper - lower) ? "percentiles" : "all";
}

/** The choice that is shown first: the first one wanted that is not the same everywhere; on both faces where it has two. */
function firstChoice(choices) {
  const varies = name => choices.has(name) && choices.get(name).range.high > choices.get(name).range.low;
  for (const name of head.wanted) {
    const both = name.replace("_top", "") + " (both faces)";
    if (name.includes("_top") && varies(both)) return both;
    if (varies(name)) return name;
  }
  return varies("displacement") ? "displacement" : [...choices.keys()].find(varies) ?? [...choices.keys()][0];
}
