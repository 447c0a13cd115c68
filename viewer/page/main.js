// The page at work: one state, changed by what is clicked and kept behind the # of the address.

/** Seconds in which all frames are played, and how long one frame stays at least and at most. */
const FILM = 6000, LEAST = 40, MOST = 500;
/** Part of the size of a body by which shapes without a size are drawn. */
const SIZELESS = 0.15;
/** Particles beyond which they are discs at first, and milliseconds of a picture beyond which they become discs. */
const MOST_SPHERES = 200000, SLOW = 150;

const state = { frame: null, field: null, map: "", range: null, low: null, high: null, only: false, scale: 1,
  thick: true, edges: null, ghost: false, spheres: null, camera: null };
const view = { shapes: [], choices: new Map(), swing: 1, playing: null, marked: null, probed: null };

/** The state behind the #, where there is one that can be read. */
function remembered() {
  try {
    Object.assign(state, JSON.parse(decodeURIComponent(location.hash.slice(1))));
  } catch { /* An address without a state, or of another page: as at the start. */ }
}

function remember() {
  const { camera } = view;
  state.camera = [camera.azimuth, camera.height, camera.centre, camera.zoom / camera.canvas.width];
  try {
    history.replaceState(null, "", "#" + encodeURIComponent(JSON.stringify(state)));
  } catch { /* Within another page there is no address of its own. */ }
}

/** Draws what is loaded; nothing is inflated here. */
function paint() {
  const { card, camera, shapes } = view, canvas = card.gl.canvas;
  const ratio = window.devicePixelRatio || 1, width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
  if (canvas.width !== width || canvas.height !== height) {
    camera.zoom *= width / (canvas.width || width);
    [canvas.width, canvas.height] = [width, height];
  }
  card.clear(width, height);
  const look = { ...view.ends, only: state.only, edges: state.edges, spheres: state.spheres };
  if (state.ghost) for (const shape of shapes) shape.drawGhost(camera);
  for (const glass of [false, true]) shapes.filter(shape => shape.head.glass === glass).forEach(shape => shape.draw(camera, look));
  if (view.marked) mark(view.marked.shape, view.marked.points, 7 * ratio, [0.85, 0.1, 0.45, 1]);
  if (view.probed) mark(view.probed.shape, [view.probed.row], 11 * ratio, [0.76, 0.25, 0.05, 1]);
  drawAxes(byId("axes"), camera);
}

/** Draws once before the screen is shown again, however often it is asked for. */
function paintSoon() {
  if (view.asked) return;
  view.asked = requestAnimationFrame(() => { view.asked = null; paint(); });
  clearTimeout(view.later);
  view.later = setTimeout(remember, 300);
}

/** Marks particles, whatever lies before them. */
function mark(shape, points, size, colour) {
  const { card, camera } = view, gl = card.gl, uniforms = card.use("discs");
  const places = new Float32Array(3 * points.length);
  points.forEach((row, i) => places.set(shape.places.subarray(3 * row, 3 * row + 3), 3 * i));
  view.markPlaces ??= card.buffer();
  view.markSizes ??= card.buffer();
  card.put(view.markPlaces, places);
  card.put(view.markSizes, new Float32Array(points.length).fill(size));
  gl.uniformMatrix4fv(uniforms.see, false, camera.matrix());
  gl.uniform4fv(uniforms.plain, colour);
  gl.uniform1i(uniforms.only, 0);
  gl.uniform1i(uniforms.flatly, 1);
  gl.uniform1f(uniforms.pixels, 1);
  gl.uniform1f(uniforms.grown, 1);
  card.attribute("place", view.markPlaces, 3);
  card.attribute("size", view.markSizes, 1);
  gl.disable(gl.DEPTH_TEST);
  gl.drawArrays(gl.POINTS, 0, points.length);
  gl.enable(gl.DEPTH_TEST);
}

/** The ends of the colours, as the range that is chosen has them. */
function endsOf(choice) {
  if (!choice) {
    view.map = "viridis";
    return { low: 0, high: 0 };
  }
  let { low, high } = choice.range;
  if (state.range === "hand" && state.low !== null && state.high !== null) [low, high] = [state.low, state.high];
  if (state.range === "percentiles") ({ lower: low, upper: high } = choice.range);
  if (state.range === "frame") {
    [low, high] = [Infinity, -Infinity];
    for (const shape of view.shapes.filter(shape => shape.part && !shape.hidden)) {
      for (const values of shape.part.below ? [shape.values, shape.below] : [shape.values]) {
        for (const x of values) if (x < 1e37) [low, high] = [Math.min(low, x), Math.max(high, x)];
      }
    }
    if (low > high) [low, high] = [0, 0];
  }
  view.map = state.map || suited(choice, { low, high });
  // What changes its sign has its middle at zero.
  if (state.range !== "hand" && view.map === "cool–warm" && low < 0 && high > 0) {
    const most = Math.max(-low, high);
    [low, high] = [-most, most];
  }
  return { low, high };
}

/** Takes up the state: inflates what it needs, then draws. One at a time; what comes meanwhile comes after. */
async function refresh() {
  if (view.busy) {
    view.again = true;
    return;
  }
  view.busy = true;
  do {
    view.again = false;
    const choice = view.choices.get(state.field), frame = state.frame;
    for (const shape of view.shapes) await shape.update(frame, state.scale * view.swing, choice);
    if (choice) state.range ??= suitedRange(choice, view.shapes);
    view.ends = endsOf(choice);
    view.card.setColours(view.map);
    writeLegend(choice, view.map, view.ends);
    if (!view.fitted) firstFit();
    controls();
    paint();
    view.first ??= performance.now();
    if (view.probed) await writeProbe(view.probed.shape, view.probed.row, frame);
  } while (view.again);
  view.busy = false;
  remember();
}

/** Shows the state in its controls. */
function controls() {
  const at = head.frames[state.frame];
  byId("frame").value = state.frame;
  byId("instant").textContent = at ? `${at.label}  (${state.frame + 1} of ${head.frames.length})` : "";
  if (state.range !== "hand") {
    byId("low").value = Number(view.ends.low.toPrecision(4));
    byId("high").value = Number(view.ends.high.toPrecision(4));
  }
  byId("scale").value = Number(state.scale.toPrecision(4));
  byId("scale-slider").value = Math.log10(state.scale || 1e-2);
  for (const name of ["only", "thick", "edges", "ghost", "spheres"]) byId(name).checked = state[name];
  for (const name of ["field", "range", "map"]) byId(name).value = state[name];
  view.curve.at(at?.row ?? null);
}

/** The box round all that is drawn, and round it at rest. */
function drawnBox() {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (const shape of view.shapes) {
    for (const places of [shape.places, shape.rest]) {
      for (let i = 0; i < places.length; i++) {
        if (places[i] < low[i % 3]) low[i % 3] = places[i];
        if (places[i] > high[i % 3]) high[i % 3] = places[i];
      }
    }
  }
  return low[0] > high[0] ? [[-1, -1, -1], [1, 1, 1]] : [low, high];
}

function fit() {
  const whole = state.scale === 1 && !head.sizeless && head.half.some(x => x > 0);
  // The legend takes its part of the canvas.
  const legend = byId("legend").hidden ? 0 : (byId("legend").offsetWidth + 14) * (window.devicePixelRatio || 1);
  view.camera.fit(whole ? [head.half.map(x => -x), head.half] : drawnBox(), legend);
}

function firstFit() {
  view.fitted = true;
  const { camera } = view, canvas = camera.canvas, ratio = window.devicePixelRatio || 1;
  [canvas.width, canvas.height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
  fit();
  if (state.camera) {
    let zoom;
    [camera.azimuth, camera.height, camera.centre, zoom] = state.camera;
    camera.zoom = zoom * canvas.width;
  }
}

/** The particle that is seen at a place on the canvas: among the near ones the one in front. */
function pick(x, y) {
  let best = null, reach = 14 * (window.devicePixelRatio || 1);
  for (const shape of view.shapes.filter(shape => !shape.hidden && !shape.head.glass)) {
    const { places, rows } = shape;
    for (let row = 0; row < rows; row++) {
      const [px, py, near] = view.camera.project(places[3 * row], places[3 * row + 1], places[3 * row + 2]);
      const away = Math.hypot(px - x, py - y);
      // A pixel aside weighs as much as a hundredth of the depth.
      const cost = away / reach - near / view.camera.radius;
      if (away < reach && (!best || cost < best.cost)) best = { shape, row, cost };
    }
  }
  return best;
}

async function probe(x, y) {
  view.probed = pick(x, y);
  if (!view.probed) {
    byId("probe").replaceChildren();
    view.curve.probe(null);
    return paint();
  }
  const { shape, row } = view.probed;
  await writeProbe(shape, row, state.frame);
  const part = view.choices.get(state.field)?.parts.get(shape.number), values = [];
  if (part && !head.sizeless) {
    const one = new Float32Array(shape.rows);
    for (let k = 0; k < head.frames.length; k++) {
      part.track.fill(await part.track.frame(k), part.component, one, NaN);
      values.push(one[row]);
    }
    // Of a choice on both faces the upper one.
    const name = part.below ? part.track.head.name : state.field;
    view.curve.probe({ name: `${name} at ${row}`, unit: view.choices.get(state.field).unit, values });
  }
  paint();
}

function go(frame) {
  state.frame = Math.max(0, Math.min(head.frames.length - 1, frame));
  refresh();
}

/** Plays the film; shapes without a size swing. */
function play() {
  if (view.playing) {
    clearInterval(view.playing);
    view.playing = null;
    view.swing = 1;
  } else {
    const count = head.frames.length, pause = Math.max(LEAST, Math.min(MOST, FILM / count)), start = performance.now();
    if (!head.sizeless && state.frame === count - 1) state.frame = -1;
    view.playing = setInterval(() => {
      if (view.busy) return;
      if (head.sizeless) {
        view.swing = Math.cos((performance.now() - start) / 300);
        refresh();
      } else go((state.frame + 1) % count);
    }, head.sizeless ? LEAST : pause);
  }
  byId("play").textContent = view.playing ? "■" : "▶";
  refresh();
}

function listen() {
  const on = (id, event, act) => byId(id).addEventListener(event, () => { act(byId(id)); refresh(); });
  const number = box => box.value === "" ? null : Number(box.value);
  on("field", "change", box => { Object.assign(state, { field: box.value, range: null, low: null, high: null }); });
  on("map", "change", box => { state.map = box.value; });
  on("range", "change", box => { state.range = box.value; [state.low, state.high] = [view.ends.low, view.ends.high]; });
  for (const end of ["low", "high"]) {
    on(end, "change", () => { Object.assign(state, { range: "hand", low: number(byId("low")), high: number(byId("high")) }); });
  }
  for (const name of ["only", "edges", "ghost", "spheres"]) on(name, "change", box => { state[name] = box.checked; });
  on("thick", "change", box => { state.thick = box.checked; view.shapes.forEach(shape => shape.solid && shape.setThick(state.thick)); });
  on("scale", "change", box => { state.scale = number(box) ?? 1; });
  on("scale-slider", "input", box => { state.scale = 10 ** Number(box.value); });
  on("frame", "input", box => { state.frame = Number(box.value); });
  byId("play").addEventListener("click", play);
  byId("save").addEventListener("click", () => { paint(); savePicture(byId("shape"), view.choices.get(state.field), head.frames[state.frame].label); });
  for (const button of document.querySelectorAll("[data-view]")) button.addEventListener("click", () => look(button.dataset.view));
  byId("curve").addEventListener("click", event => {
    const row = view.curve.nearest(event.offsetX, event.offsetY);
    if (row === null) return;
    const away = frame => frame.row === null ? Infinity : Math.abs(frame.row - row);
    go(head.frames.reduce((best, frame, number) => away(frame) < away(head.frames[best]) ? number : best, 0));
  });
  document.addEventListener("keydown", event => {
    if (/INPUT|SELECT|BUTTON|SUMMARY/.test(event.target.tagName) && event.target.id !== "frame") return;
    const acts = { " ": play, ArrowLeft: () => go(state.frame - 1), ArrowRight: () => go(state.frame + 1),
      Home: () => look("home"), f: () => look("fit"), x: () => look("x"), y: () => look("y"), z: () => look("z") };
    if (!acts[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    acts[event.key]();
  });
  new ResizeObserver(() => { if (view.fitted) { paint(); view.curve.draw(); } }).observe(byId("stage"));
}

/** Stands where a button says. */
function look(where) {
  if (where === "home") view.camera.home();
  else if (where !== "fit") view.camera.along("xyz".indexOf(where));
  fit();
  paint();
  remember();
}

/** Says what a browser lacks; words, curve and warnings stand. */
function lacking() {
  if (typeof DecompressionStream === "undefined") return "This browser cannot inflate data (DecompressionStream): Chrome 103, Firefox 113, Safari 16.4 or later can.";
  if (!head.bodies.length || !head.frames.length) return "The run wrote no shapes: give its scene [output.fields], or run it with --view.";
  return null;
}

function say(words) {
  byId("missing").textContent = words;
  byId("missing").hidden = false;
  byId("legend").hidden = byId("film").hidden = byId("look").hidden = true;
}

async function begin() {
  writeWords();
  remembered();
  view.curve = new Curve(byId("curve"), byId("curve-x"), byId("curve-y"), () => {});
  view.curve.draw();
  const fault = lacking();
  if (fault) return say(fault);
  view.card = new Card(byId("shape"));
  if (!view.card.gl) return say("This browser draws no WebGL 2.");
  if (head.bodies.some(body => body.face_count > 0)) view.card.begin("faces");
  view.card.begin("lines");
  view.shapes = head.bodies.map((body, number) => new Shape(body, number));
  view.choices = choicesOf(view.shapes);
  const last = head.frames.length - 1;
  if (!view.choices.has(state.field)) state.field = firstChoice(view.choices) ?? null;
  const faces = head.bodies.reduce((sum, body) => sum + body.face_count, 0);
  state.edges ??= faces <= MOST_EDGED;
  for (const name of view.choices.keys()) byId("field").append(new Option(name, name));
  byId("map").append(new Option("map", ""), ...Object.keys(MAPS).map(name => new Option(name, name)));
  byId("frame").max = last;
  byId("film").hidden = last === 0 && !head.sizeless;
  byId("thick-box").hidden = !head.bodies.some(body => body.shell);
  for (const shape of view.shapes) await shape.load(view.card, state.thick);
  if (head.sizeless && !state.camera) state.scale = sizelessScale();
  view.camera = new Camera(byId("shape"), head.plane);
  steer(byId("shape"), view.camera, paintSoon, probe);
  writeBodies(view.shapes, refresh);
  writeSets(view.shapes, marked => { view.marked = marked; paint(); });
  listen();
  const particles = view.shapes.filter(shape => !shape.solid).reduce((sum, shape) => sum + shape.rows, 0);
  byId("spheres-box").hidden = particles === 0;
  const chosen = state.spheres !== null;
  // Seen straight, particles of a plane scene hide nothing of each other.
  state.spheres ??= head.plane === null && particles <= MOST_SPHERES;
  const wanted = state.frame ?? (head.sizeless ? 0 : last);
  // The first frame is there at once; those between are inflated on the way to the one that is wanted.
  state.frame = 0;
  await refresh();
  if (wanted !== 0) {
    state.frame = Math.min(wanted, last);
    await refresh();
  }
  if (!chosen && state.spheres && painted() > SLOW) {
    state.spheres = false;
    await refresh();
  }
  if (head.reload) setTimeout(() => { if (state.frame === last) state.frame = null; remember(); location.reload(); }, 1000 * head.reload);
}

/** Milliseconds in which the card draws the picture. */
function painted() {
  const gl = view.card.gl, start = performance.now();
  paint();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  return performance.now() - start;
}

/** The scale at which the greatest motion is a small part of the size of the bodies. */
function sizelessScale() {
  const most = Math.max(...head.bodies.map(body => body.motion.lengths?.high ?? 0));
  return most > 0 ? SIZELESS * 2 * Math.hypot(...head.half) / most : 1;
}
