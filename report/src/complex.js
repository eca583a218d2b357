// The complex of a certificate with what the reader has chosen of it: a measure, a filter, a label, a simplex.
import { measures, Scale } from "./measures.js";

export class Complex extends EventTarget {
  /** `whole`: how many simplices the certificate has; the page has no more of them. */
  constructor(drawing, whole = 0) {
    super();
    this.drawing = drawing;
    this.whole = whole;
    this.corners = drawing.corners;
    this.size = drawing.simplices.length / drawing.corners;
    this.scales = {};
    for (const name of Object.keys(measures))
      if (drawing.measures[name]) this.scales[name] = new Scale(drawing.measures[name], drawing.bounds[name]);
    this.measure = Object.keys(this.scales)[0] ?? null;
    this.ranges = {};
    this.kept = new Uint8Array(this.size).fill(1);
    this.label = null;
    this.simplex = null;
    this.onlyStar = false;
    this.indexStars();
  }

  /** Of each label the simplices that have it, one after the other. */
  indexStars() {
    const { label, simplices } = this.drawing;
    const labels = label.reduce((most, own) => Math.max(most, own), -1) + 1;
    this.starts = new Uint32Array(labels + 1);
    for (const vertex of simplices) ++this.starts[label[vertex] + 1];
    for (let at = 0; at < labels; ++at) this.starts[at + 1] += this.starts[at];
    const filled = this.starts.slice(0, labels);
    this.incident = new Uint32Array(simplices.length);
    simplices.forEach((vertex, at) => { this.incident[filled[label[vertex]]++] = Math.floor(at / this.corners); });
  }

  vertices(simplex) {
    return this.drawing.simplices.subarray(this.corners * simplex, this.corners * (simplex + 1));
  }

  labels(simplex) {
    return [...this.vertices(simplex)].map((vertex) => this.drawing.label[vertex]);
  }

  /** The simplices of star(label), each once. */
  star(label) {
    if (!Number.isInteger(label) || label < 0 || label + 1 >= this.starts.length) return [];
    return [...new Set(this.incident.subarray(this.starts[label], this.starts[label + 1]))];
  }

  /** The vertex of a simplex that has this label. */
  vertexOf(simplex, label) {
    return this.vertices(simplex).find((vertex) => this.drawing.label[vertex] === label);
  }

  value(name, simplex) {
    return this.drawing.measures[name]?.[simplex] ?? NaN;
  }

  announce(what) {
    this.dispatchEvent(new Event(what));
  }

  setMeasure(name) {
    this.measure = name;
    this.announce("look");
  }

  /** Keeps the simplices whose measure is in [low, high]; null keeps all. Simplices without it are kept by null only. */
  setRange(name, range) {
    if (range) this.ranges[name] = range;
    else delete this.ranges[name];
    this.kept.fill(1);
    for (const [filtered, [low, high]] of Object.entries(this.ranges)) {
      const values = this.drawing.measures[filtered];
      for (let simplex = 0; simplex < this.size; ++simplex) {
        if (!(values[simplex] >= low && values[simplex] <= high)) this.kept[simplex] = 0;
      }
    }
    this.announce("look");
  }

  keptCount() {
    return this.kept.reduce((sum, own) => sum + own, 0);
  }

  /** Chooses a label, and a simplex of its star or none. */
  choose(label, simplex = null) {
    this.label = label;
    this.simplex = simplex;
    this.announce("choice");
    this.announce("look");
  }

  setOnlyStar(only) {
    this.onlyStar = only;
    this.announce("look");
  }
}
