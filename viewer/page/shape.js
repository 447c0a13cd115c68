// A body as it is drawn: faces of a sheet with both sides and its thickness, outer faces of a solid, particles as discs
// or spheres.

/** Faces beyond which their edges are not drawn at first: they would hide the colours. */
const MOST_EDGED = 5000;
/** Stands for no number on the card. */
const NO_NUMBER = 3e38;

class Shape {
  constructor(head, number) {
    this.head = head;
    this.number = number;
    this.rows = head.count;
    this.motion = new Track(head.motion, this.rows);
    this.fields = head.fields.map(field => new Track(field, this.rows));
    this.tracks = head.displaced ? [this.motion, ...this.fields] : this.fields;
    this.hidden = false;
  }

  async load(card, thick) {
    const [rest, faces, border, sizes] = await Promise.all([single(this.head.rest), whole(this.head.faces),
      whole(this.head.border), this.head.sizes ? single(this.head.sizes) : null]);
    Object.assign(this, { card, rest, faces, border, sizes, places: new Float32Array(rest) });
    this.solid = faces.length > 0;
    this.still = this.head.motion.ranges.every(({ low, high }) => low === 0 && high === 0);
    this.buffers = Object.fromEntries(["place", "normal", "value", "size", "triangles", "edges", "outline", "rest", "ghost"].map(name => [name, card.buffer()]));
    card.put(this.buffers.rest, rest);
    if (this.solid) {
      const ghost = border.length ? border : this.edgeCorners(1);
      this.ghostCount = ghost.length;
      card.put(this.buffers.ghost, ghost, true);
      this.setThick(thick);
    } else {
      this.values = new Float32Array(this.rows);
      card.put(this.buffers.size, this.particleSizes());
    }
  }

  particleSizes() {
    if (this.sizes) return this.sizes;
    const size = 1.5 * Math.hypot(...head.half) / Math.sqrt(this.rows || 1);
    return new Float32Array(this.rows).fill(size);
  }

  /** Both ends of every edge of every face, of so many layers. */
  edgeCorners(layers) {
    const { faces, rows } = this, out = new Uint32Array(2 * layers * faces.length);
    let end = 0;
    for (let from = 0; from < layers * rows; from += rows) {
      for (let i = 0; i < faces.length; i++) {
        const next = i % 4 === 3 ? i - 3 : i + 1;
        if (faces[i] === faces[next]) continue;
        out[end++] = from + faces[i];
        out[end++] = from + faces[next];
      }
    }
    return out.subarray(0, end);
  }

  /** Lays out corners: of one layer, or of two with walls along the border between them. */
  setThick(thick) {
    this.thick = thick && this.head.shell;
    const { rows, faces, border } = this, layers = this.thick ? 2 : 1;
    const walls = this.thick ? border.length / 2 : 0, count = layers * rows + 4 * walls;
    const triangles = new Uint32Array(layers * faces.length / 4 * 6 + 6 * walls), outline = new Uint32Array(4 * walls);
    let end = 0;
    for (let from = 0; from < layers * rows; from += rows || 1) {
      for (let i = 0; i < faces.length; i += 4) {
        const a = from + faces[i], c = from + faces[i + 2];
        triangles[end++] = a; triangles[end++] = from + faces[i + 1]; triangles[end++] = c;
        if (faces[i + 2] === faces[i + 3]) continue;
        triangles[end++] = a; triangles[end++] = c; triangles[end++] = from + faces[i + 3];
      }
    }
    for (let w = 0; w < walls; w++) {
      const a = layers * rows + 4 * w;
      triangles.set([a, a + 1, a + 2, a, a + 2, a + 3], end);
      outline.set([a, a + 1, a + 2, a + 3], 4 * w);
      end += 6;
    }
    this.counts = { triangles: end, edges: 0, outline: this.thick ? outline.length : border.length };
    this.card.put(this.buffers.triangles, triangles, true);
    this.card.put(this.buffers.outline, this.thick ? outline : border, true);
    this.layout = { place: new Float32Array(3 * count), normal: new Float32Array(3 * count), value: new Float32Array(count) };
    this.values = new Float32Array(rows);
    this.below = new Float32Array(rows);
  }

  /** Edges of all faces, of both layers; laid out when they are first drawn. */
  drawEdges(camera) {
    if (!this.counts.edges) {
      const edges = this.edgeCorners(this.thick ? 2 : 1);
      this.counts.edges = edges.length;
      this.card.put(this.buffers.edges, edges, true);
    }
    this.lines(camera, this.buffers.place, this.buffers.edges, this.counts.edges, [0.1, 0.13, 0.18, 0.35]);
  }

  /** Takes up a frame: places at a scale of the motion, and numbers of a choice. */
  async update(frame, scale, choice) {
    const shares = await this.motion.frame(frame), { places, rest, rows, motion } = this;
    for (let k = 0; k < 3; k++) {
      const { low, high } = motion.head.ranges[k], step = (high - low) / STEPS, from = k * rows;
      for (let i = 0; i < rows; i++) {
        const share = shares[from + i];
        places[3 * i + k] = rest[3 * i + k] + (share === NONE ? NaN : scale * (low + share * step));
      }
    }
    this.part = choice?.parts.get(this.number);
    if (this.part) {
      const { track, component, below } = this.part;
      track.fill(await track.frame(frame), component, this.values, NO_NUMBER);
      if (below) below.track.fill(await below.track.frame(frame), below.component, this.below, NO_NUMBER);
    }
    if (this.solid) this.fillFaces();
    else {
      this.card.put(this.buffers.place, places);
      this.card.put(this.buffers.value, this.values);
    }
  }

  fillFaces() {
    const { rows, places, layout, values, card, buffers } = this;
    // Cells of a solid have edges of their own: each face is shaded as it lies.
    const smooth = this.head.shell, normals = this.normals(smooth || this.thick);
    if (!this.thick) {
      layout.place.set(places);
      if (smooth) layout.normal.set(normals);
      layout.value.set(values);
    } else {
      const lower = this.part?.below ? this.below : values;
      for (let i = 0; i < rows; i++) {
        const half = 0.5 * this.sizes[i];
        for (let k = 0; k < 3; k++) {
          const at = 3 * i + k, up = half * normals[at];
          layout.place[at] = places[at] + up;
          layout.place[3 * rows + at] = places[at] - up;
          layout.normal[at] = layout.normal[3 * rows + at] = normals[at];
        }
        layout.value[i] = values[i];
        layout.value[rows + i] = lower[i];
      }
      const border = this.border;
      for (let w = 0; 2 * w < border.length; w++) {
        // Down, along, up: corners of a wall between the layers.
        [border[2 * w], border[2 * w] + rows, border[2 * w + 1] + rows, border[2 * w + 1]].forEach((from, corner) => {
          const to = 2 * rows + 4 * w + corner;
          for (let k = 0; k < 3; k++) layout.place[3 * to + k] = layout.place[3 * from + k];
          layout.value[to] = layout.value[from];
        });
      }
    }
    card.put(buffers.place, layout.place);
    card.put(buffers.normal, layout.normal);
    card.put(buffers.value, layout.value);
  }

  /** Means of the normals of the faces round each point, by their areas. */
  normals(wanted) {
    if (!wanted) return null;
    const out = this.normal ??= new Float32Array(3 * this.rows), { faces, places } = this;
    out.fill(0);
    for (let i = 0; i < faces.length; i += 4) {
      const a = 3 * faces[i], b = 3 * faces[i + 1], c = 3 * faces[i + 2], d = 3 * faces[i + 3];
      // Half the cross product of the diagonals, of a triangle of two sides: the last corner twice.
      const [p, q] = c === d ? [a, b] : [b, d];
      const ux = places[c] - places[a], uy = places[c + 1] - places[a + 1], uz = places[c + 2] - places[a + 2];
      const vx = places[q] - places[p], vy = places[q + 1] - places[p + 1], vz = places[q + 2] - places[p + 2];
      const sign = c === d ? -1 : 1;
      const x = sign * (uy * vz - uz * vy), y = sign * (uz * vx - ux * vz), z = sign * (ux * vy - uy * vx);
      for (let k = 0; k < (c === d ? 3 : 4); k++) {
        const to = 3 * faces[i + k];
        out[to] += x; out[to + 1] += y; out[to + 2] += z;
      }
    }
    for (let i = 0; i < out.length; i += 3) {
      const size = Math.hypot(out[i], out[i + 1], out[i + 2]) || 1;
      out[i] /= size; out[i + 1] /= size; out[i + 2] /= size;
    }
    return out;
  }

  plain() {
    return this.part ? [0, 0, 0, 0] : [...(this.isWall() ? WALLS : this.solid ? SHEETS : PARTICLES), 1];
  }

  isWall() {
    return !this.solid && this.still;
  }

  /** Draws itself as the camera sees it. */
  draw(camera, look) {
    if (this.hidden || !this.rows) return;
    const { card, buffers } = this, gl = card.gl;
    const uniforms = card.use(this.solid ? "faces" : look.spheres ? "spheres" : "discs");
    gl.uniformMatrix4fv(uniforms.see, false, camera.matrix());
    if (uniforms.turn) gl.uniformMatrix3fv(uniforms.turn, false, camera.turnMatrix());
    gl.uniform2f(uniforms.range, look.low, look.high);
    gl.uniform4fv(uniforms.plain, this.plain());
    gl.uniform1i(uniforms.only, look.only ? 1 : 0);
    gl.uniform1i(uniforms.flatly, camera.plane !== null && camera.straight() ? 1 : 0);
    card.attribute("place", buffers.place, 3);
    card.attribute("value", buffers.value, 1);
    if (!this.solid) {
      gl.uniform1f(uniforms.pixels, camera.pixels());
      if (uniforms.deep) gl.uniform1f(uniforms.deep, camera.depths());
      // Walls round a body in space would hide it.
      gl.uniform1f(uniforms.grown, this.isWall() && camera.plane === null ? 0.25 : 1.1);
      card.attribute("size", buffers.size, 1);
      gl.drawArrays(gl.POINTS, 0, this.rows);
      return;
    }
    card.attribute("normal", buffers.normal, 3);
    // Tools are seen through: they hide nothing that is drawn before or behind them.
    gl.uniform1f(uniforms.veil, this.head.glass ? 0.3 : 1);
    if (this.head.glass) this.veil(true);
    gl.enable(gl.POLYGON_OFFSET_FILL);
    gl.polygonOffset(1, 1);
    card.corners(buffers.triangles, gl.TRIANGLES, this.counts.triangles);
    gl.disable(gl.POLYGON_OFFSET_FILL);
    if (this.head.glass) return this.veil(false);
    if (look.edges) this.drawEdges(camera);
    if (!look.only) this.lines(camera, buffers.place, buffers.outline, this.counts.outline, [0.1, 0.13, 0.18, 0.8]);
  }

  /** Lets through what is behind, or not any more. */
  veil(begins) {
    const { gl } = this.card;
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl[begins ? "enable" : "disable"](gl.BLEND);
    gl.depthMask(!begins);
  }

  drawGhost(camera) {
    if (this.hidden || !this.solid || this.still || this.head.glass) return;
    this.lines(camera, this.buffers.rest, this.buffers.ghost, this.ghostCount, [0.45, 0.5, 0.57, 0.7]);
  }

  lines(camera, places, corners, count, ink) {
    const { card } = this, gl = card.gl, uniforms = card.use("lines");
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.uniformMatrix4fv(uniforms.see, false, camera.matrix());
    gl.uniform4fv(uniforms.ink, ink);
    gl.uniform1f(uniforms.nearer, 0);
    card.attribute("place", places, 3);
    card.corners(corners, gl.LINES, count);
    gl.disable(gl.BLEND);
  }
}
