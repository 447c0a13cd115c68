// What a test asks of the page, where the address ends in #selftest: answers stand in an element of that name.

const faults = [];
addEventListener("error", event => faults.push(String(event.message)));
addEventListener("unhandledrejection", event => faults.push(String(event.reason?.stack ?? event.reason)));

/** Share of the canvas that is not its background, and a sum that differs for different pictures. */
function seen() {
  const gl = view.card.gl, { width, height } = gl.canvas, pixels = new Uint8Array(4 * width * height);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const ground = BACKGROUND.map(part => Math.round(255 * part));
  let drawn = 0, sum = 0;
  for (let i = 0; i < pixels.length; i += 4) {
    const other = [0, 1, 2].some(k => Math.abs(pixels[i + k] - ground[k]) > 3);
    drawn += other ? 1 : 0;
    sum = (sum * 31 + pixels[i] + 7 * pixels[i + 1] + 13 * pixels[i + 2]) % 4294967291;
  }
  return { share: drawn / (width * height), sum };
}

async function answers() {
  if (!view.fitted) return { shapes: false, words: byId("missing").textContent };
  const last = head.frames.length - 1, found = { shapes: true, frames: head.frames.length, first: view.first, field: state.field, plane: head.plane };
  const at = async frame => { go(frame); while (view.busy) await new Promise(done => setTimeout(done, 5)); };
  await at(0);
  const before = seen(), markBefore = view.curve.mark?.row ?? null;
  await at(last);
  const after = seen();
  Object.assign(found, { share: after.share, moved: before.sum !== after.sum, marks: [markBefore, view.curve.mark?.row ?? null] });
  // A particle is asked for where it is drawn.
  const shape = view.shapes.find(shape => !shape.isWall()) ?? view.shapes[0], row = Math.floor(shape.rows / 2);
  const [x, y] = view.camera.project(...shape.places.subarray(3 * row, 3 * row + 3));
  await probe(x, y);
  found.probe = byId("probe").querySelectorAll("tr").length;
  found.fields = view.probed?.shape.tracks.length ?? -1;
  const set = byId("sets").querySelector("button");
  set?.click();
  found.sets = byId("sets").querySelectorAll("button").length;
  const drawnAs = async spheres => { state.spheres = spheres; await refresh(); return seen().sum; };
  found.spheres = view.shapes.some(shape => !shape.solid) ? await drawnAs(false) !== await drawnAs(true) : null;
  state.only = true;
  Object.assign(state, { range: "hand", low: view.ends.high + 1, high: view.ends.high + 2 });
  await refresh();
  found.hidden = seen().share < after.share;
  return found;
}

async function selftest() {
  const found = await begin().then(answers).catch(error => ({ failed: String(error.stack ?? error) }));
  const box = element("pre", JSON.stringify({ ...found, faults }), document.body);
  box.id = "selftest";
}

if (location.hash === "#selftest") {
  history.replaceState(null, "", "#");
  selftest();
} else begin().catch(error => say(`The page failed: ${error.message ?? error}`));
