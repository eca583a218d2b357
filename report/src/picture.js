// The picture with its controls.
import { Camera } from "./camera.js";
import { colourAt } from "./colours.js";
import { button, choice, count, element, identifier, labelled, slider } from "./elements.js";
import { measures } from "./measures.js";
import { extentOf, inModel, inverseStep, modelsOf, periodsOf, radiusOfShare } from "./models.js";
import { Scene, states } from "./scene.js";

const wire = [0.25, 0.3, 0.38, 0.9];
const sideTints = [[0.84, 0.15, 0.16], [0.12, 0.47, 0.71], [0.89, 0.47, 0.05], [0.17, 0.6, 0.17], [0.58, 0.4, 0.74], [0.55, 0.34, 0.29],
  [0.89, 0.29, 0.66], [0.1, 0.65, 0.68]];

/** The unit circle of the plane. */
function circle(steps = 180) {
  const result = [], at = (step) => [Math.cos(2 * Math.PI * step / steps), Math.sin(2 * Math.PI * step / steps), 0];
  for (let step = 0; step < steps; ++step) result.push(...at(step), ...at(step + 1));
  return result;
}

/** Pairs of sides with what takes the one to the other or back, each with a tint: [{step, tint, faces}]. */
function sidesOf(drawing) {
  const sides = new Map();
  for (const [first, second, step] of drawing.matching_faces) {
    const key = [step, inverseStep(step)].sort()[0];
    if (!sides.has(key)) sides.set(key, { step, tint: sideTints[sides.size % sideTints.length], faces: [] });
    sides.get(key).faces.push(first, second);
  }
  return [...sides.values()];
}

function describe(header, complex, model) {
  const kind = complex.corners === 4 ? "tetrahedra" : "triangles";
  return `A picture of ${count(complex.size)} ${kind} of ${header.manifold}, drawn ${model ? `in the ${model} model` : "in one cell"}. ` +
    "The same data are in the tables below. Arrow keys turn it, plus and minus zoom, Home resets.";
}

export class Picture {
  constructor(header, complex) {
    Object.assign(this, { header, complex });
    const { drawing } = complex;
    this.solid = complex.corners === 4;
    this.flat = !this.solid && drawing.ambient_dimension === 2;
    this.models = modelsOf(drawing);
    this.periods = periodsOf(drawing);
    this.model = drawing.geometry === "spherical" && this.models.some(([key]) => key === "azimuthal") && this.reaches() ? "azimuthal" : drawing.model;
    this.canvas = element("canvas", { tabindex: "0", role: "img", "aria-label": describe(header, complex, this.models.find(([key]) => key === this.model)?.[1]) });
    this.status = element("p", { class: "state", role: "status" });
    this.legend = element("div", { class: "legend" });
    this.sides = drawing.matching_faces?.length ? sidesOf(drawing) : null;
    this.root = element("section", { class: "picture", "aria-label": "Picture" }, this.canvas, this.legend, this.status, this.controls());
  }

  /** Whether the drawing comes near the point at infinity of its model. */
  reaches() {
    return this.complex.drawing.coordinates.some((value) => Math.abs(value) > 3);
  }

  /** Draws for the first time: after the page has the canvas. */
  start() {
    const { complex, canvas } = this;
    this.camera = new Camera({ centre: [0, 0, 0], radius: 1 }, { turns: !this.flat, perspective: this.solid });
    try {
      this.scene = new Scene(canvas, complex.drawing, this.camera);
    } catch (reason) {
      this.status.textContent = `No picture: ${reason.message}. Tables and histograms need none.`;
      canvas.hidden = true;
      return;
    }
    this.scene.lit = !this.flat;
    // A complex without a boundary would show its outermost simplices alone.
    if (this.solid && !this.sides && complex.drawing.geometry === "spherical") this.cutAxis.control.value = "eye";
    this.setModel(this.model);
    this.listen();
    complex.addEventListener("look", () => this.look());
    this.look();
  }

  controls() {
    const { complex, solid } = this, names = Object.keys(complex.scales);
    const parts = [];
    if (names.length) {
      this.measureChoice = choice("Colour", names.map((name) => [name, measures[name].name]), (name) => complex.setMeasure(name));
      parts.push(this.measureChoice.labelled);
    }
    if (this.models.length > 1) {
      const models = choice("Model", this.models, (model) => this.setModel(model));
      models.control.value = this.model;
      parts.push(models.labelled);
    }
    if (this.periods.length) {
      parts.push(choice("Cells", [["1", "1"], ["2", "2 each way"], ["3", "3 each way"]], (text) => this.repeat(Number(text))).labelled);
    }
    this.shrink = slider("Size of simplices", { min: 30, max: 100, value: solid && complex.size <= 15000 ? 85 : 100 }, (value) => this.scene.setShrink(value / 100));
    parts.push(this.shrink.labelled);
    if (!this.flat) {
      this.cutAxis = choice("Cut", [["", "none"], ["eye", "facing you"], ["0", "across x"], ["1", "across y"], ["2", "across z"]], () => this.cut());
      this.cutDepth = slider("Depth", { min: 0, max: 100, value: 50 }, () => this.cut());
      parts.push(this.cutAxis.labelled, this.cutDepth.labelled);
    }
    if (this.sides) {
      this.showSides = element("input", { type: "checkbox", checked: !solid, onchange: () => this.drawLines() });
      parts.push(labelled("Glued sides", this.showSides));
    }
    parts.push(button("Reset", () => this.reset()));
    return element("div", { class: "controls" }, parts);
  }

  setModel(model) {
    this.model = model;
    const { drawing } = this.complex;
    this.coordinates = inModel(drawing, drawing.coordinates, model);
    const hyperbolic = drawing.geometry === "hyperbolic";
    const infinite = model !== "azimuthal" && drawing.geometry === "spherical" && this.solid && this.reaches();
    const extent = this.extent = infinite ? { centre: [0, 0, 0], radius: 1.4 * radiusOfShare(this.coordinates, 0.8) } : extentOf(this.coordinates, this.flat);
    // A picture of a hyperbolic surface shows the whole disk, unless the cell is small in it.
    this.camera.extend(hyperbolic && this.flat && extent.radius > 0.6 ? { centre: [0, 0, 0], radius: 1.02 } : extent);
    this.scene.shrink = Number(this.shrink.control.value) / 100;
    // On a whole sphere the simplices around the point opposite to the middle go all around the picture.
    this.scene.setPlaces(this.coordinates, drawing.geometry === "spherical" && this.solid ? extent.radius * (infinite ? 1 : 0.5) : Infinity);
    this.cut();
    this.drawLines();
  }

  repeat(times) {
    const { scene, camera, periods } = this, offsets = [];
    const steps = (axis) => axis < periods.length ? [...Array(times).keys()].map((step) => step - (times - 1) / 2) : [0];
    for (const a of steps(0)) for (const b of steps(1)) for (const c of steps(2))
      offsets.push([0, 1, 2].map((axis) => a * periods[0][axis] + b * periods[1][axis] + c * (periods[2]?.[axis] ?? 0)));
    scene.offsets = offsets;
    camera.extend({ ...this.extent, radius: this.extent.radius * times });
    scene.redraw();
  }

  reset() {
    this.camera.reset();
    this.scene.redraw();
  }

  /** The plane of the cut: through the ball around the drawing, as deep as the slider says. */
  cut() {
    if (!this.cutAxis) return;
    const { camera, scene } = this, axis = this.cutAxis.control.value;
    if (axis === "") return scene.setCut(null);
    const { turned, centre, radius } = camera, normal = axis === "eye" ? [turned[2], turned[6], turned[10]] : [0, 1, 2].map((own) => own === Number(axis) ? 1 : 0);
    const middle = normal.reduce((sum, value, own) => sum + value * centre[own], 0);
    scene.setCut([...normal, middle + radius * (1 - Number(this.cutDepth.control.value) / 50)]);
  }

  /** Wires of the domain, glued sides, the rim of the model, the chosen simplex and label. */
  drawLines() {
    const { complex, scene } = this, { drawing } = complex, groups = [];
    const moved = (segments) => Array.from(inModel(drawing, segments, this.model));
    if (drawing.domain?.length) groups.push({ segments: moved(drawing.domain), tint: wire, width: 1 });
    if (drawing.geometry === "hyperbolic" && this.flat) groups.push({ segments: circle(), tint: [0.45, 0.5, 0.56, 1], width: 1 });
    const edgesOnce = (faces) => {
      const known = new Set(), segments = [];
      for (const vertices of faces) {
        for (let a = 0; a < vertices.length; ++a) {
          for (let b = a + 1; b < vertices.length; ++b) {
            const key = Math.min(vertices[a], vertices[b]) * 2 ** 26 + Math.max(vertices[a], vertices[b]);
            if (known.has(key)) continue;
            known.add(key);
            segments.push(...scene.point(vertices[a]), ...scene.point(vertices[b]));
          }
        }
      }
      return segments;
    };
    const edges = (vertices) => {
      const segments = [];
      for (let a = 0; a < vertices.length; ++a)
        for (let b = a + 1; b < vertices.length; ++b) segments.push(...scene.point(vertices[a]), ...scene.point(vertices[b]));
      return segments;
    };
    if (this.sides && this.showSides.checked) {
      for (const { faces, tint } of this.sides) groups.push({ segments: edgesOnce(faces), tint: [...tint, this.solid ? 0.6 : 1], width: this.solid ? 0.6 : 1.8 });
    }
    if (complex.simplex !== null) {
      const vertices = [...complex.vertices(complex.simplex)];
      groups.push({ segments: edges(vertices), tint: [0.8, 0.02, 0.1, 1], width: 2.2 });
      for (const face of drawing.matching_faces ?? []) {
        if (!face.slice(0, 2).some((own) => own.every((vertex) => vertices.includes(vertex)))) continue;
        groups.push({ segments: edges(face[0]), tint: [0.95, 0.5, 0, 1], width: 3.2 }, { segments: edges(face[1]), tint: [0.95, 0.5, 0, 1], width: 3.2 });
      }
    }
    scene.setLines(groups);
  }

  look() {
    const { complex, scene } = this, { drawing, measure } = complex;
    const scale = measure ? complex.scales[measure] : null, values = measure ? drawing.measures[measure] : null;
    const shades = new Float32Array(complex.size), look = new Uint8Array(complex.size);
    const star = complex.label === null ? null : new Set(complex.star(complex.label));
    for (let simplex = 0; simplex < complex.size; ++simplex) {
      shades[simplex] = values && !Number.isNaN(values[simplex]) ? scale.place(values[simplex]) : -1;
      look[simplex] = !complex.kept[simplex] ? states.hidden : !star ? states.usual
        : star.has(simplex) ? states.chosen : complex.onlyStar ? states.faint : states.usual;
    }
    if (complex.onlyStar && star && this.solid)
      for (let simplex = 0; simplex < complex.size; ++simplex) if (look[simplex] === states.faint) look[simplex] = states.hidden;
    scene.setLook(shades, look);
    this.drawLines();
    const kept = complex.keptCount();
    this.status.textContent = kept === complex.size ? `all ${count(kept)} simplices` : `${count(kept)} of ${count(complex.size)} simplices`;
    this.drawLegend(scale);
  }

  drawLegend(scale) {
    if (!scale) return;
    const strip = element("canvas", { width: 256, height: 1, role: "presentation" }), context = strip.getContext("2d");
    for (let at = 0; at < 256; ++at) {
      context.fillStyle = `rgb(${colourAt(at / 255).join(" ")})`;
      context.fillRect(at, 0, 1, 1);
    }
    this.legend.replaceChildren(element("span", {}, measures[this.complex.measure].name), element("span", {}, scale.text(0)), strip, element("span", {}, scale.text(1)));
  }

  /** Puts the chosen star into the middle, large. */
  focus() {
    const { complex, camera, scene } = this;
    if (complex.label === null || !scene) return;
    const [simplex] = complex.star(complex.label);
    if (simplex === undefined) return;
    const point = scene.point(complex.vertexOf(simplex, complex.label));
    camera.zoom = Math.max(camera.zoom, Math.min(12, Math.max(1.5, Math.sqrt(complex.size) / 12)));
    if (!this.flat && !this.solid) this.turnTo(complex.simplex ?? simplex, point);
    camera.aim(point);
    scene.redraw();
  }

  /** Turns a surface in space so that this simplex is seen, from the outside if it is seen there; the point is in the middle. */
  turnTo(simplex, point) {
    const { complex, camera, scene, canvas } = this, [a, b, c] = [...complex.vertices(simplex)].map((vertex) => scene.point(vertex));
    const [u, v] = [b, c].map((corner) => corner.map((value, axis) => value - a[axis]));
    const across = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]], length = Math.hypot(...across);
    if (!(length > 0)) return;
    const outside = across.reduce((sum, value, axis) => sum + value * (a[axis] - camera.centre[axis]), 0) < 0 ? -1 : 1;
    const star = complex.star(complex.label);
    for (const side of [outside, -outside, outside]) {
      camera.face(across.map((value) => side * value / length));
      camera.aim(point);
      if (star.includes(scene.simplexAt(canvas.clientWidth / 2, canvas.clientHeight / 2))) return;
    }
  }

  /** Chooses what is drawn at a place of the canvas: the simplex, and the vertex of it that is nearest there. */
  pick(x, y) {
    const { complex, scene } = this, simplex = scene.simplexAt(x, y);
    if (simplex < 0) return complex.choose(null);
    let best = null, least = Infinity;
    for (const vertex of complex.vertices(simplex)) {
      const [across, down] = scene.onCanvas(scene.point(vertex)), distance = Math.hypot(across - x, down - y);
      if (distance < least) [best, least] = [vertex, distance];
    }
    complex.choose(complex.drawing.label[best], simplex);
  }

  listen() {
    const { canvas, camera, scene } = this, pointers = new Map();
    let moved = 0;
    const within = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, within(event));
      canvas.setPointerCapture(event.pointerId);
      moved = 0;
    });
    canvas.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const now = within(event), right = now[0] - before[0], down = now[1] - before[1];
      pointers.set(event.pointerId, now);
      moved += Math.abs(right) + Math.abs(down);
      if (pointers.size === 2) {
        const other = [...pointers].find(([pointer]) => pointer !== event.pointerId)[1];
        const length = (point) => Math.hypot(point[0] - other[0], point[1] - other[1]);
        camera.scale(length(now) / Math.max(length(before), 1));
      } else {
        camera.drag(right / canvas.clientHeight, -down / canvas.clientHeight, event.shiftKey || this.flat);
      }
      if (this.cutAxis?.control.value === "eye") this.cut();
      scene.redraw();
    });
    const ended = (event) => {
      if (!pointers.delete(event.pointerId) || moved > 4 || event.type !== "pointerup") return;
      this.pick(...within(event));
    };
    canvas.addEventListener("pointerup", ended);
    canvas.addEventListener("pointercancel", ended);
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      camera.scale(Math.exp(-event.deltaY / 600));
      scene.redraw();
    }, { passive: false });
    const keys = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, 0.05], ArrowDown: [0, -0.05] };
    canvas.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) return;
      if (keys[event.key]) camera.drag(...keys[event.key], event.shiftKey || this.flat);
      else if (event.key === "+" || event.key === "=") camera.scale(1.2);
      else if (event.key === "-") camera.scale(1 / 1.2);
      else if (event.key === "Home") camera.reset();
      else return;
      event.preventDefault();
      if (this.cutAxis?.control.value === "eye") this.cut();
      scene.redraw();
    });
  }
}
