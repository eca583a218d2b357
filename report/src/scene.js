// The picture of a complex, drawn by WebGL 2.
import { colourTable } from "./colours.js";
import { foldsOf, neighboursOf, visibleFacets } from "./facets.js";
import { applied } from "./matrices.js";
import { lineProgram, triangleProgram } from "./programs.js";

export const states = { hidden: 0, usual: 1, chosen: 2, faint: 3 };

const lineFloats = 11;

/** How many layers of simplices are drawn where they are shrunk so much: deeper ones are hidden by those in front. */
const layersOf = (shrink) => shrink >= 0.995 ? 0 : shrink >= 0.8 ? 3 : shrink >= 0.6 ? 6 : 255;

export class Scene {
  /** Throws an Error where WebGL 2 is not to be had. */
  constructor(canvas, drawing, camera) {
    Object.assign(this, { canvas, drawing, camera, shrink: 1, cut: null, offsets: [[0, 0, 0]], lit: true, pending: 0, isStale: true });
    const gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    this.size = drawing.simplices.length / drawing.corners;
    this.neighbours = drawing.corners === 4 ? neighboursOf(drawing.simplices) : null;
    this.shades = new Float32Array(this.size).fill(-1);
    this.look = new Uint8Array(this.size).fill(states.usual);
    this.triangles = { ...triangleProgram(gl), array: gl.createVertexArray(), points: gl.createBuffer(), shade: gl.createBuffer(), number: gl.createBuffer(), size: 0 };
    this.lines = { ...lineProgram(gl), array: gl.createVertexArray(), buffer: gl.createBuffer(), size: 0 };
    this.describeBuffers();
    this.tones = this.texture();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, colourTable());
    new ResizeObserver(() => this.redraw()).observe(canvas);
  }

  texture() {
    const { gl } = this, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
    return texture;
  }

  describeBuffers() {
    const { gl, triangles, lines } = this;
    const floats = (attributes, name, parts, stride, offset) => {
      gl.enableVertexAttribArray(attributes[name]);
      gl.vertexAttribPointer(attributes[name], parts, gl.FLOAT, false, 4 * stride, 4 * offset);
    };
    gl.bindVertexArray(triangles.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, triangles.points);
    floats(triangles.attributes, "point", 3, 6, 0);
    floats(triangles.attributes, "middle", 3, 6, 3);
    gl.bindBuffer(gl.ARRAY_BUFFER, triangles.shade);
    floats(triangles.attributes, "shade", 1, 1, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, triangles.number);
    gl.enableVertexAttribArray(triangles.attributes.number);
    gl.vertexAttribIPointer(triangles.attributes.number, 2, gl.UNSIGNED_INT, 0, 0);
    gl.bindVertexArray(lines.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.buffer);
    floats(lines.attributes, "from", 3, lineFloats, 0);
    floats(lines.attributes, "to", 3, lineFloats, 3);
    floats(lines.attributes, "tint", 4, lineFloats, 6);
    floats(lines.attributes, "width", 1, lineFloats, 10);
    gl.bindVertexArray(null);
  }

  /**
   * Where the vertices are, three coordinates each. Simplices with an edge that is longer than `longest` are not drawn:
   * such are those around the point at infinity of a model.
   */
  setPlaces(coordinates, longest) {
    const { corners, simplices } = this.drawing;
    this.coordinates = coordinates;
    this.middles = new Float32Array(3 * this.size);
    this.far = new Uint8Array(this.size);
    for (let simplex = 0; simplex < this.size; ++simplex) {
      let size = 0;
      for (let axis = 0; axis < 3; ++axis) {
        let sum = 0, low = Infinity, high = -Infinity;
        for (let corner = 0; corner < corners; ++corner) {
          const value = coordinates[3 * simplices[corners * simplex + corner] + axis];
          sum += value;
          low = Math.min(low, value);
          high = Math.max(high, value);
        }
        this.middles[3 * simplex + axis] = sum / corners;
        size = Math.max(size, high - low);
      }
      this.far[simplex] = size > longest ? 1 : 0;
    }
    this.folds = this.neighbours && this.drawing.geometry === "space" ? foldsOf(simplices, this.neighbours, coordinates) : null;
    this.stale();
  }

  /** Of each simplex its place on the scale of colours, 0 to 1, or below 0 for grey; and one of `states`. */
  setLook(shades, look) {
    Object.assign(this, { shades, look });
    this.stale();
  }

  /** Nothing is drawn beyond the plane: [x, y, z, w] with x·a + y·b + z·c ≤ w kept, in the drawing's coordinates; or null. */
  setCut(cut) {
    this.cut = cut;
    this.stale();
  }

  setShrink(shrink) {
    const deeper = layersOf(shrink) !== layersOf(this.shrink);
    this.shrink = shrink;
    if (deeper) this.stale();
    this.redraw();
  }

  stale() {
    this.isStale = true;
    this.redraw();
  }

  hiddenSimplices() {
    const { cut, middles } = this, hidden = Uint8Array.from(this.far);
    for (let simplex = 0; simplex < this.size; ++simplex) {
      if (this.look[simplex] === states.hidden) hidden[simplex] = 1;
      else if (cut && cut[0] * middles[3 * simplex] + cut[1] * middles[3 * simplex + 1] + cut[2] * middles[3 * simplex + 2] > cut[3]) hidden[simplex] = 1;
    }
    return hidden;
  }

  /** The triangles that are to be drawn, as numbers 4 · simplex + the corner opposite; of a triangle that corner is 3. */
  drawnTriangles() {
    const hidden = this.hiddenSimplices();
    if (this.neighbours) return visibleFacets(this.neighbours, hidden, layersOf(this.shrink), this.folds);
    const result = [];
    for (let simplex = 0; simplex < this.size; ++simplex) if (!hidden[simplex]) result.push(4 * simplex + 3);
    return result;
  }

  fill() {
    const { gl, triangles, drawing: { corners, simplices }, coordinates, middles } = this, drawn = this.drawnTriangles();
    const points = new Float32Array(18 * drawn.length), shade = new Float32Array(3 * drawn.length), number = new Uint32Array(6 * drawn.length);
    let at = 0;
    for (const facet of drawn) {
      const simplex = facet >> 2, opposite = facet & 3;
      for (let corner = 0; corner < corners; ++corner) {
        if (corner === opposite) continue;
        const vertex = simplices[corners * simplex + corner];
        for (let axis = 0; axis < 3; ++axis) {
          points[6 * at + axis] = coordinates[3 * vertex + axis];
          points[6 * at + 3 + axis] = middles[3 * simplex + axis];
        }
        shade[at] = this.shades[simplex];
        number[2 * at] = simplex;
        number[2 * at + 1] = this.look[simplex];
        ++at;
      }
    }
    for (const [buffer, data] of [[triangles.points, points], [triangles.shade, shade], [triangles.number, number]]) {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    }
    triangles.size = at;
    this.isStale = false;
  }

  /** Segments, [{segments: [x, y, z, x, y, z, …], tint: [r, g, b, a], width}], `width` in pixels to each side. */
  setLines(groups) {
    const { gl, lines } = this;
    const data = new Float32Array(lineFloats * groups.reduce((sum, { segments }) => sum + segments.length, 0));
    let at = 0;
    for (const { segments, tint, width } of groups) {
      for (let segment = 0; segment < segments.length; segment += 6) {
        for (let corner = 0; corner < 6; ++corner) {
          for (let part = 0; part < 6; ++part) data[at + part] = segments[segment + part];
          data.set(tint, at + 6);
          data[at + 10] = width;
          at += lineFloats;
        }
      }
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, lines.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    lines.size = at / lineFloats;
    this.redraw();
  }

  redraw() {
    this.pending ||= requestAnimationFrame(() => this.draw());
  }

  draw() {
    const { gl, canvas } = this;
    cancelAnimationFrame(this.pending);
    this.pending = 0;
    const scale = Math.min(window.devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(canvas.clientWidth * scale)), height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    if (this.isStale) this.fill();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.clearColor(1, 1, 1, 1);
    this.renderTriangles(false);
    this.renderLines();
  }

  /** Begins to draw with a program. */
  use({ program, uniforms, array }) {
    const { gl, canvas, camera } = this;
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniforms.place, false, camera.place());
    gl.uniformMatrix4fv(uniforms.projection, false, camera.projection(canvas.width / canvas.height));
    gl.bindVertexArray(array);
  }

  renderTriangles(picking) {
    const { gl, canvas, triangles, triangles: { uniforms } } = this;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    this.use(triangles);
    gl.bindTexture(gl.TEXTURE_2D, this.tones);
    gl.uniform1i(uniforms.tones, 0);
    gl.uniform1f(uniforms.shrink, this.shrink);
    gl.uniform1i(uniforms.picking, picking ? 1 : 0);
    gl.uniform1i(uniforms.lit, this.lit ? 1 : 0);
    for (const offset of this.offsets) {
      gl.uniform3fv(uniforms.offset, offset);
      gl.drawArrays(gl.TRIANGLES, 0, triangles.size);
    }
    gl.bindVertexArray(null);
  }

  renderLines() {
    const { gl, canvas, lines } = this;
    this.use(lines);
    gl.uniform2f(lines.uniforms.size, canvas.width / Math.min(window.devicePixelRatio || 1, 2), canvas.height / Math.min(window.devicePixelRatio || 1, 2));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    gl.drawArrays(gl.TRIANGLES, 0, lines.size);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  }

  /** The simplex that is drawn at a place of the canvas (CSS pixels from its upper left corner); -1 for none. */
  simplexAt(x, y) {
    const { gl, canvas } = this, scale = canvas.width / canvas.clientWidth;
    if (this.isStale) this.draw();
    const texture = this.texture(), depth = gl.createRenderbuffer(), frame = gl.createFramebuffer();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, canvas.width, canvas.height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
    gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, canvas.width, canvas.height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    gl.clearColor(0, 0, 0, 0);
    this.renderTriangles(true);
    const bytes = new Uint8Array(4);
    gl.readPixels(Math.floor(x * scale), canvas.height - 1 - Math.floor(y * scale), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(frame);
    gl.deleteRenderbuffer(depth);
    gl.deleteTexture(texture);
    return (bytes[0] | bytes[1] << 8 | bytes[2] << 16 | bytes[3] << 24) - 1;
  }

  /** Where a point of the drawing is on the canvas, in CSS pixels, and its depth. */
  onCanvas(point) {
    const { canvas, camera } = this;
    const [x, y, z] = applied(camera.projection(canvas.clientWidth / canvas.clientHeight), applied(camera.place(), point).slice(0, 3));
    return [(x + 1) / 2 * canvas.clientWidth, (1 - y) / 2 * canvas.clientHeight, z];
  }

  point(vertex) {
    return [...this.coordinates.subarray(3 * vertex, 3 * vertex + 3)];
  }
}
