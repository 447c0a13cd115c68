// Words and choices beside the shape. All that comes from a scene goes in as text.

/** An element with words in it. */
function element(name, words, into) {
  const made = document.createElement(name);
  made.textContent = words;
  into?.append(made);
  return made;
}

/** What needs no card: title, warnings, scene. */
function writeWords() {
  byId("title").textContent = head.title;
  byId("facts").textContent = head.facts.join(" · ");
  for (const warning of head.warnings) element("p", `Warning: ${warning}`, byId("warnings"));
  byId("scene").textContent = head.scene;
  byId("scene-box").hidden = !head.scene;
  const said = head.left_out.map(what => `The page holds ${what}: it would be too large.`);
  if (head.reload) said.push("The run is under way: the page loads itself again.");
  byId("foot").textContent = said.join(" ");
  byId("curve-box").hidden = !head.rows.length;
}

/** The colours with their numbers. */
function writeLegend(choice, map, { low, high }) {
  byId("legend").hidden = !choice;
  if (!choice) return;
  byId("legend-name").textContent = choice.name + unitOf(choice.unit);
  const bar = byId("legend-bar"), pen = bar.getContext("2d"), colours = ramp(map), picture = pen.createImageData(16, 256);
  for (let i = 0; i < 256; i++) {
    for (let k = 0; k < 16; k++) picture.data.set(colours.subarray(4 * (255 - i), 4 * (255 - i) + 4), 4 * (16 * i + k));
  }
  pen.putImageData(picture, 0, 0);
  const ticks = byId("legend-ticks");
  ticks.replaceChildren();
  if (!(high > low)) element("span", shown(low), ticks);
  else for (let k = 4; k >= 0; k--) {
    // Beyond the ends the colours stay those of the ends.
    const beyond = k === 4 && choice.range.high > high ? "≥ " : k === 0 && choice.range.low < low ? "≤ " : "";
    element("span", beyond + shown(low + k / 4 * (high - low)), ticks);
  }
}

/** Bodies that can be hidden; of one alone there is nothing to choose. */
function writeBodies(shapes, changed) {
  if (shapes.length < 2) return;
  const box = byId("bodies");
  element("h2", "Bodies", box);
  for (const shape of shapes) {
    const label = element("label", "", box), tick = element("input", "", label);
    tick.type = "checkbox";
    tick.checked = !shape.hidden;
    element("span", `${shape.head.name} (${shape.rows})`, label);
    tick.addEventListener("change", () => { shape.hidden = !tick.checked; changed(); });
  }
}

/** Sets whose particles can be marked; `marked` with the body and the numbers of its particles, or with nothing. */
function writeSets(shapes, marked) {
  const box = byId("sets");
  if (!shapes.some(shape => shape.head.sets.length)) return;
  element("h2", "Sets", box);
  for (const shape of shapes) {
    for (const [name, blob] of shape.head.sets) {
      const button = element("button", shapes.length > 1 ? `${shape.head.name}.${name}` : name, box);
      button.addEventListener("click", async () => {
        const on = !button.classList.contains("on");
        box.querySelectorAll("button.on").forEach(other => other.classList.remove("on"));
        button.classList.toggle("on", on);
        marked(on ? { shape, points: await whole(blob) } : null);
      });
    }
  }
}

/** What is known of a particle in a frame. */
async function writeProbe(shape, row, frame) {
  const box = byId("probe"), lines = [];
  const at = Array.from(shape.places.subarray(3 * row, 3 * row + 3), (x, k) => shown(x + head.origin[k]));
  const rest = Array.from(shape.rest.subarray(3 * row, 3 * row + 3), (x, k) => shown(x + head.origin[k]));
  lines.push(["at rest", rest.join(", ")], ["drawn at", at.join(", ")]);
  for (const track of shape.tracks) {
    const shares = await track.frame(frame), { name, unit, width, components, lengths } = track.head;
    const numbers = Array.from({ length: width }, (_, k) => track.value(shares, row, k));
    const words = components.length ? numbers.map((x, k) => `${components[k]}: ${shown(x)}`) : numbers.map(shown);
    if (lengths) words.push(`length ${shown(Math.hypot(...numbers))}`);
    lines.push([name + unitOf(unit), words.join(", ")]);
  }
  box.replaceChildren();
  element("h2", `${head.bodies.length > 1 ? shape.head.name + ", p" : "P"}article ${row}`, box);
  const table = element("table", "", box);
  for (const [name, words] of lines) {
    const line = element("tr", "", table);
    element("td", name, line);
    element("td", words, line);
  }
}

/** Saves the shape as a picture, with its title, the place of the frame and the colours. */
function savePicture(shape, choice, instant) {
  const canvas = document.createElement("canvas"), pen = canvas.getContext("2d"), ratio = window.devicePixelRatio || 1;
  [canvas.width, canvas.height] = [shape.width, shape.height];
  pen.drawImage(shape, 0, 0);
  pen.scale(ratio, ratio);
  pen.fillStyle = "#1d2530";
  pen.font = "15px system-ui, sans-serif";
  pen.fillText(`${head.title}: ${instant}`, 14, 24);
  if (choice) {
    const left = shape.width / ratio - 150, bar = byId("legend-bar"), ticks = [...byId("legend-ticks").children];
    pen.font = "12px system-ui, sans-serif";
    pen.fillText(choice.name + unitOf(choice.unit), left, 48, 140);
    pen.drawImage(bar, left, 58, 16, 200);
    ticks.forEach((tick, k) => pen.fillText(tick.textContent, left + 24, 62 + 200 * k / Math.max(1, ticks.length - 1)));
  }
  canvas.toBlob(blob => {
    const link = element("a", "");
    link.href = URL.createObjectURL(blob);
    link.download = `${head.title.replace(/[^\p{L}\p{N}]+/gu, "-").replace(/^-|-$/g, "") || "shape"}.png`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  }, "image/png");
}
