// The graphics card: programs, buffers, colours.

class Card {
  constructor(canvas) {
    this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true, alpha: false });
    if (!this.gl) return;
    const gl = this.gl;
    this.begun = {};
    this.programs = {};
    this.colours = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.LINEAR);
    for (const side of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, side, gl.CLAMP_TO_EDGE);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  /** Begins to make a program. The card works on it while the page goes on, for as long as nobody asks how it went. */
  begin(name) {
    const gl = this.gl, made = gl.createProgram(), file = name === "spheres" ? "discs" : name;
    const first = "#version 300 es\nprecision highp float;\nprecision highp int;\n" + (name === "spheres" ? "#define SPHERES\n" : "");
    const shaders = [[gl.VERTEX_SHADER, "vert"], [gl.FRAGMENT_SHADER, "frag"]].map(([kind, end]) => {
      const shader = gl.createShader(kind);
      const colour = file !== "lines" && end === "frag" ? byId("colour.glsl").textContent : "";
      gl.shaderSource(shader, first + colour + byId(`${file}.${end}`).textContent);
      gl.compileShader(shader);
      gl.attachShader(made, shader);
      return shader;
    });
    gl.linkProgram(made);
    this.begun[name] = { made, shaders };
  }

  /** A program with the places of what it is given; made where it was not begun. */
  program(name) {
    if (!this.begun[name]) this.begin(name);
    const gl = this.gl, { made, shaders } = this.begun[name];
    if (!gl.getProgramParameter(made, gl.LINK_STATUS)) {
      throw new Error(`${name}: ${[...shaders.map(shader => gl.getShaderInfoLog(shader)), gl.getProgramInfoLog(made)].join(" ")}`);
    }
    const places = { made, uniforms: {}, attributes: {} };
    for (let i = 0; i < gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); i++) {
      const { name } = gl.getActiveUniform(made, i);
      places.uniforms[name] = gl.getUniformLocation(made, name);
    }
    for (let i = 0; i < gl.getProgramParameter(made, gl.ACTIVE_ATTRIBUTES); i++) {
      const { name } = gl.getActiveAttrib(made, i);
      places.attributes[name] = gl.getAttribLocation(made, name);
    }
    return places;
  }

  setColours(map) {
    const gl = this.gl;
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, ramp(map));
  }

  /** Begins to draw with a program; gives the places of its uniforms. */
  use(name) {
    this.now = this.programs[name] ??= this.program(name);
    this.gl.useProgram(this.now.made);
    return this.now.uniforms;
  }

  /** Hands over an attribute from a buffer. */
  attribute(name, buffer, width) {
    const gl = this.gl, at = this.now.attributes[name];
    if (at === undefined) return;
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.enableVertexAttribArray(at);
    gl.vertexAttribPointer(at, width, gl.FLOAT, false, 0, 0);
  }

  buffer() {
    return this.gl.createBuffer();
  }

  /** Fills a buffer with numbers that change, or with corners that stay. */
  put(buffer, numbers, corners = false) {
    const gl = this.gl, kind = corners ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
    gl.bindBuffer(kind, buffer);
    gl.bufferData(kind, numbers, corners ? gl.STATIC_DRAW : gl.DYNAMIC_DRAW);
  }

  corners(buffer, kind, count) {
    this.gl.bindBuffer(this.gl.ELEMENT_ARRAY_BUFFER, buffer);
    this.gl.drawElements(kind, count, this.gl.UNSIGNED_INT, 0);
  }

  clear(width, height) {
    const gl = this.gl;
    gl.viewport(0, 0, width, height);
    gl.clearColor(...BACKGROUND, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }
}

const BACKGROUND = [0.961, 0.969, 0.976];
