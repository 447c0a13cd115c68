// Where the viewer stands: a parallel projection, turned by azimuth and height, moved, enlarged.

const DEGREES = Math.PI / 180;
/** From where plane scenes are seen, by the axis of their normal; then bodies in space. */
const STRAIGHT = [[0, 0], [-90, 0], [-90, 90]], ASIDE = [-60, 30];

class Camera {
  constructor(canvas, plane) {
    this.canvas = canvas;
    this.plane = plane;
    this.radius = 1;
    this.home();
  }

  home() {
    [this.azimuth, this.height] = this.plane === null ? ASIDE : STRAIGHT[this.plane];
    this.centre = [0, 0, 0];
  }

  along(axis) {
    [this.azimuth, this.height] = STRAIGHT[axis];
  }

  straight() {
    const [azimuth, height] = STRAIGHT[this.plane];
    return this.azimuth === azimuth && this.height === height;
  }

  /** Unit vectors to the right, up, and towards the viewer. */
  axes() {
    const [a, h] = [this.azimuth * DEGREES, this.height * DEGREES];
    const [sa, ca, sh, ch] = [Math.sin(a), Math.cos(a), Math.sin(h), Math.cos(h)];
    return [[-sa, ca, 0], [-sh * ca, -sh * sa, ch], [ch * ca, ch * sa, sh]];
  }

  /** Lengths to pixels. */
  pixels() {
    return this.zoom;
  }

  /** Lengths towards the viewer to parts of the depth that the card keeps. */
  depths() {
    return 0.5 / this.radius;
  }

  turnMatrix() {
    const [r, u, v] = this.axes();
    return new Float32Array([r[0], u[0], v[0], r[1], u[1], v[1], r[2], u[2], v[2]]);
  }

  matrix() {
    const { width, height } = this.canvas, [r, u, v] = this.axes(), c = this.centre;
    const scales = [2 * this.zoom / width, 2 * this.zoom / height, -1 / this.radius], rows = [r, u, v];
    const out = new Float32Array(16);
    rows.forEach((row, k) => {
      for (let i = 0; i < 3; i++) out[4 * i + k] = scales[k] * row[i];
      out[12 + k] = -scales[k] * dot(row, c);
    });
    out[15] = 1;
    return out;
  }

  /** A place on the canvas in pixels from its upper left corner, and its nearness. */
  project(x, y, z) {
    const [r, u, v] = this.axes(), p = [x - this.centre[0], y - this.centre[1], z - this.centre[2]];
    return [this.canvas.width / 2 + this.zoom * dot(r, p), this.canvas.height / 2 - this.zoom * dot(u, p), dot(v, p)];
  }

  /** Sees a box, given by its ends, as large as it fits beside a strip at the right of the canvas. */
  fit([low, high], strip) {
    const [r, u] = this.axes(), { width, height } = this.canvas, free = Math.max(width - strip, width / 2);
    this.centre = low.map((x, k) => (x + high[k]) / 2);
    const half = low.map((x, k) => (high[k] - x) / 2);
    const reach = axis => axis.reduce((sum, x, k) => sum + Math.abs(x) * half[k], 0) || 1e-30;
    this.zoom = 0.88 * Math.min(free / 2 / reach(r), height / 2 / reach(u));
    this.move((free - width) / 2, 0);
    // Far enough for whatever is drawn larger later on.
    this.radius = 6 * (Math.hypot(...half) || 1);
  }

  turn(dx, dy) {
    this.azimuth = (this.azimuth - 0.4 * dx) % 360;
    this.height = Math.max(-90, Math.min(90, this.height + 0.4 * dy));
  }

  move(dx, dy) {
    const [r, u] = this.axes();
    this.centre = this.centre.map((x, k) => x + (u[k] * dy - r[k] * dx) / this.zoom);
  }

  /** Enlarges about a place on the canvas. */
  enlarge(factor, x, y) {
    const dx = x - this.canvas.width / 2, dy = y - this.canvas.height / 2;
    this.move(-dx, -dy);
    this.zoom *= factor;
    this.move(dx, dy);
  }
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Hands drags, wheel and clicks to the camera; `changed` after each move, `clicked` with a place on the canvas. */
function steer(canvas, camera, changed, clicked) {
  const fingers = new Map();
  let moved = 0;
  const ratio = () => canvas.width / canvas.clientWidth;
  const place = event => {
    const box = canvas.getBoundingClientRect();
    return [(event.clientX - box.left) * ratio(), (event.clientY - box.top) * ratio()];
  };
  const middle = () => {
    const all = [...fingers.values()], [a, b] = [all[0], all[all.length - 1]];
    return { x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, apart: Math.hypot(a[0] - b[0], a[1] - b[1]) };
  };
  canvas.addEventListener("pointerdown", event => {
    canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    moved = 0;
  });
  canvas.addEventListener("pointermove", event => {
    if (!fingers.has(event.pointerId)) return;
    const before = middle(), two = fingers.size > 1;
    fingers.set(event.pointerId, place(event));
    const after = middle(), [dx, dy] = [after.x - before.x, after.y - before.y];
    moved += Math.abs(dx) + Math.abs(dy) + Math.abs(after.apart - before.apart);
    const aside = event.shiftKey || event.buttons !== 1;
    if (two) {
      camera.move(dx, dy);
      camera.enlarge(after.apart / (before.apart || 1), after.x, after.y);
    } else if (aside !== (camera.plane !== null)) camera.move(dx, dy);
    else camera.turn(dx / ratio(), dy / ratio());
    changed();
  });
  const lift = event => {
    if (fingers.delete(event.pointerId) && moved < 4 && event.type === "pointerup") clicked(...place(event));
  };
  canvas.addEventListener("pointerup", lift);
  canvas.addEventListener("pointercancel", lift);
  canvas.addEventListener("contextmenu", event => event.preventDefault());
  canvas.addEventListener("wheel", event => {
    event.preventDefault();
    camera.enlarge(Math.exp(-0.0015 * event.deltaY), ...place(event));
    changed();
  }, { passive: false });
}

/** Draws the three directions in the corner. */
function drawAxes(canvas, camera) {
  const pen = canvas.getContext("2d"), size = canvas.width, [r, u, v] = camera.axes();
  pen.clearRect(0, 0, size, size);
  pen.font = `${size / 9}px sans-serif`;
  pen.textAlign = "center";
  pen.textBaseline = "middle";
  pen.lineWidth = size / 60;
  [0, 1, 2].sort((a, b) => v[a] - v[b]).forEach(k => {
    const [x, y] = [r[k], -u[k]].map(part => size / 2 + 0.32 * size * part);
    pen.strokeStyle = pen.fillStyle = ["#b91c1c", "#15803d", "#1d4ed8"][k];
    pen.beginPath();
    pen.moveTo(size / 2, size / 2);
    pen.lineTo(x, y);
    pen.stroke();
    if (Math.hypot(r[k], u[k]) > 0.2) pen.fillText("xyz"[k], size / 2 + 0.43 * size * r[k], size / 2 - 0.43 * size * u[k]);
  });
}
