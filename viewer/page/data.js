// The numbers of the page: inflated as they are asked for, frame after frame.

const byId = id => document.getElementById(id);
const head = JSON.parse(byId("head").textContent);
const text = byId("data").textContent;

/** Bytes of a run of numbers. */
async function inflated([at, length]) {
  const characters = atob(text.slice(at, at + length));
  const bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; i++) bytes[i] = characters.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Words of 32 bits from four planes of bytes. */
async function words(blob) {
  const bytes = await inflated(blob), count = bytes.length / 4;
  const out = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    out[i] = bytes[i] | bytes[count + i] << 8 | bytes[2 * count + i] << 16 | bytes[3 * count + i] << 24;
  }
  return out;
}

/** Whole numbers from their differences. */
async function whole(blob) {
  const out = await words(blob);
  for (let i = 1; i < out.length; i++) out[i] = out[i] + out[i - 1];
  return out;
}

/** Numbers in single precision. */
async function single(blob) {
  return new Float32Array((await words(blob)).buffer);
}

/** The share that stands for no number, and the steps of a range. */
const NONE = 65535, STEPS = 65534;

/** A field over all frames: shares of its ranges, component after component. */
class Track {
  constructor(head, rows) {
    this.head = head;
    this.rows = rows;
    this.frames = [];
    this.tail = Promise.resolve();
  }

  /** Shares of a frame; those before it are inflated on the way, one request after the other. */
  frame(number) {
    if (this.frames[number]) return Promise.resolve(this.frames[number]);
    this.tail = this.tail.then(() => this.reach(number));
    return this.tail;
  }

  async reach(number) {
    for (let k = this.frames.length; k <= number; k++) {
      const bytes = await inflated(this.head.frames[k]), count = bytes.length / 2;
      const shares = new Uint16Array(count), before = this.frames[k - 1];
      for (let i = 0; i < count; i++) shares[i] = (before ? before[i] : 0) + (bytes[i] | bytes[count + i] << 8);
      this.frames[k] = shares;
    }
    return this.frames[number];
  }

  /** A number of a row. */
  value(shares, row, component) {
    const share = shares[component * this.rows + row], { low, high } = this.head.ranges[component];
    return share === NONE ? NaN : low + share * (high - low) / STEPS;
  }

  /** One component of all rows into `out`, or the lengths of vectors for the component -1; `none` where there is no number. */
  fill(shares, component, out, none) {
    const rows = this.rows, ranges = this.head.ranges;
    if (component >= 0) {
      const { low, high } = ranges[component], step = (high - low) / STEPS, from = component * rows;
      for (let i = 0; i < rows; i++) out[i] = shares[from + i] === NONE ? none : low + shares[from + i] * step;
      return;
    }
    const [x, y, z] = ranges, steps = ranges.map(({ low, high }) => (high - low) / STEPS);
    for (let i = 0; i < rows; i++) {
      const a = shares[i], b = shares[rows + i], c = shares[2 * rows + i];
      out[i] = a === NONE || b === NONE || c === NONE ? none
        : Math.hypot(x.low + a * steps[0], y.low + b * steps[1], z.low + c * steps[2]);
    }
  }
}

/** A number as it is read: four digits. */
function shown(x) {
  if (x === null || Number.isNaN(x)) return "–";
  const size = Math.abs(x);
  if (size !== 0 && (size < 1e-3 || size >= 1e5)) return Number(x.toPrecision(4)).toExponential().replace("e+", "e");
  return String(Number(x.toPrecision(4)));
}

const unitOf = unit => unit && unit !== "-" ? ` [${unit}]` : "";
