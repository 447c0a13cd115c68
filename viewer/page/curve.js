// The curve beside the shape: any column over any other, a field at the probed particle too, with a mark at the frame.

class Curve {
  constructor(canvas, across, upward, chosen) {
    Object.assign(this, { canvas, across, upward, mark: null, row: null, extra: null });
    const names = head.columns.map(column => column.name);
    const [x, y] = head.plot ?? [];
    this.fill(across, names, names.includes(x) ? x : names[0]);
    const usual = names[0] === "mode" ? names.find(name => name === "frequency" || name === "level") : names[names.length - 1];
    this.fill(upward, names, names.includes(y) ? y : usual);
    for (const select of [across, upward]) select.addEventListener("change", () => { this.draw(); chosen(); });
  }

  fill(select, names, wanted) {
    for (const name of names) select.append(new Option(name, name));
    select.value = wanted ?? "";
  }

  /** Values at a particle over the frames, as a further choice: rows of the curve do not have them. */
  probe(extra) {
    this.extra = extra;
    this.upward.querySelectorAll("option[data-probe]").forEach(option => option.remove());
    if (extra) {
      const option = new Option(extra.name, "@probe");
      option.dataset.probe = "1";
      this.upward.append(option);
    }
    if (!this.upward.value && head.columns.length) this.upward.value = head.columns[head.columns.length - 1].name;
    this.draw();
  }

  /** Points of what is chosen, each with the number of its frame or row. */
  points() {
    const column = name => head.columns.findIndex(column => column.name === name);
    const x = column(this.across.value), y = column(this.upward.value);
    if (this.upward.value === "@probe" && this.extra) {
      const along = frame => frame.row === null || x < 0 ? frame.along : head.rows[frame.row][x];
      return head.frames.map((frame, number) => ({ x: along(frame), y: this.extra.values[number], row: frame.row }));
    }
    if (x < 0 || y < 0) return [];
    return head.rows.map((row, number) => ({ x: row[x], y: row[y], row: number }));
  }

  at(row) {
    this.row = row;
    this.draw();
  }

  draw() {
    const { canvas } = this, ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return;
    canvas.width = width * ratio;
    canvas.height = height * ratio;
    const pen = canvas.getContext("2d");
    pen.scale(ratio, ratio);
    const points = this.points(), known = points.filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y) && x !== null && y !== null);
    if (!known.length) return;
    const ends = key => {
      const all = known.map(point => point[key]);
      const low = all.reduce((a, b) => Math.min(a, b)), high = all.reduce((a, b) => Math.max(a, b));
      const room = high > low ? 0.04 * (high - low) : Math.abs(low) || 1;
      return [low - room, high + room];
    };
    const [x0, x1] = ends("x"), [y0, y1] = ends("y"), top = 8, right = width - 10, bottom = height - 36;
    pen.font = "11px system-ui, sans-serif";
    const ticks = round(y0, y1, 5), left = 26 + Math.max(...ticks.map(y => pen.measureText(shown(y)).width));
    const px = x => left + (x - x0) / (x1 - x0) * (right - left), py = y => bottom - (y - y0) / (y1 - y0) * (bottom - top);
    Object.assign(this, { px, py });
    pen.lineWidth = 1;
    pen.fillStyle = "#5b6675";
    pen.textAlign = "center";
    for (const x of round(x0, x1, Math.max(2, width / 90))) {
      pen.strokeStyle = "#e7ebf0";
      line(pen, px(x), top, px(x), bottom);
      pen.fillText(shown(x), px(x), bottom + 13);
    }
    pen.textAlign = "right";
    pen.textBaseline = "middle";
    for (const y of ticks) {
      line(pen, left, py(y), right, py(y));
      pen.fillText(shown(y), left - 5, py(y));
    }
    pen.textBaseline = "alphabetic";
    const title = name => name === "@probe" ? this.extra.name + unitOf(this.extra.unit)
      : name + unitOf(head.columns.find(column => column.name === name)?.unit);
    pen.textAlign = "center";
    pen.fillText(title(this.across.value), (left + right) / 2, height - 6);
    pen.save();
    pen.translate(10, (top + bottom) / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(title(this.upward.value), 0, 0);
    pen.restore();
    pen.strokeStyle = "#1d4f91";
    pen.fillStyle = "#1d4f91";
    pen.lineWidth = 1.5;
    pen.beginPath();
    known.forEach(({ x, y }, i) => i ? pen.lineTo(px(x), py(y)) : pen.moveTo(px(x), py(y)));
    pen.stroke();
    if (known.length <= 80) for (const { x, y } of known) disc(pen, px(x), py(y), 2.2);
    this.mark = points.find(({ row }) => row !== null && row === this.row) ?? null;
    if (this.mark && known.includes(this.mark)) {
      pen.fillStyle = "#c2410c";
      disc(pen, px(this.mark.x), py(this.mark.y), 5);
    }
  }

  /** The row whose point lies nearest to a place on the canvas. */
  nearest(x, y) {
    let best = null, least = Infinity;
    for (const point of this.points()) {
      const away = Math.hypot(this.px(point.x) - x, this.py(point.y) - y);
      if (away < least) [best, least] = [point.row, away];
    }
    return best;
  }
}

function line(pen, x0, y0, x1, y1) {
  pen.beginPath();
  pen.moveTo(x0, y0);
  pen.lineTo(x1, y1);
  pen.stroke();
}

function disc(pen, x, y, radius) {
  pen.beginPath();
  pen.arc(x, y, radius, 0, 2 * Math.PI);
  pen.fill();
}

/** Round numbers between two, about so many. */
function round(low, high, wanted) {
  const raw = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(factor => factor * power).find(step => step >= raw) ?? raw;
  const out = [];
  for (let k = Math.ceil(low / step); k * step <= high && out.length < 50; k++) out.push(k * step);
  return out;
}
