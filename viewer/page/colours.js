// Colour maps as a few colours, straight lines between them: viridis (CC0, by Smith and van der Walt), cool to warm
// (Moreland 2009), and two of one hue.

const MAPS = {
  viridis: "440154 482878 3e4a89 31688e 26828e 1f9e89 35b779 6ece58 b5de2b fde725",
  "cool–warm": "3b4cc0 5977e3 7b9ff9 9ebeff c0d4f5 dddcdc f2cbb7 f7ac8e ee8468 d65244 b40426",
  heat: "eceff1 fdd9a6 fdae61 f46d43 d73027 8c0d25 4a0018",
  grey: "202020 f4f4f4",
};

/** 256 colours of a map, four bytes each. */
function ramp(name) {
  const stops = MAPS[name].split(" ").map(hex => [0, 2, 4].map(at => parseInt(hex.slice(at, at + 2), 16)));
  const out = new Uint8Array(4 * 256);
  for (let i = 0; i < 256; i++) {
    const place = i / 255 * (stops.length - 1), from = Math.min(Math.floor(place), stops.length - 2), share = place - from;
    for (let k = 0; k < 3; k++) out[4 * i + k] = Math.round(stops[from][k] + share * (stops[from + 1][k] - stops[from][k]));
    out[4 * i + 3] = 255;
  }
  return out;
}

/** The map that suits a field within a range: what breaks glows, what changes its sign has a middle. */
function suited(choice, { low, high }) {
  if (choice.name === "damage") return "heat";
  return low < 0 && high > 0 && Math.min(-low, high) > 0.05 * Math.max(-low, high) ? "cool–warm" : "viridis";
}

/** Colours of bodies without the field that is shown. */
const SHEETS = [0.78, 0.7, 0.6], PARTICLES = [0.5, 0.66, 0.85], WALLS = [0.72, 0.74, 0.77];
