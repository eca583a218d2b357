// A drawing in the plane, or in space, where pointer and arrow keys turn it.
import { drawn } from "./elements.js";
import { product, rotation } from "./matrices.js";

const size = 460, margin = 46;

/** What derives from it has `draw()`, which fills `svg`. */
export class TurnableDrawing {
  /** The frame of these points (three coordinates each), then a first drawing; `words` say what it shows. */
  begin(points, dimension, words) {
    this.turned = dimension === 3 ? product(rotation([1, 0, 0], 0.5), rotation([0, 1, 0], 0.4)) : rotation([1, 0, 0], 0);
    const low = [0, 1, 2].map((axis) => Math.min(...points.map((point) => point[axis]))), high = [0, 1, 2].map((axis) => Math.max(...points.map((point) => point[axis])));
    this.centre = low.map((value, axis) => (value + high[axis]) / 2);
    this.radius = Math.max(...points.map((point) => Math.hypot(...point.map((value, axis) => value - this.centre[axis]))), 1e-300);
    this.svg = drawn("svg", { viewBox: `0 0 ${size} ${size}`, role: "img", tabindex: dimension === 3 ? "0" : null, "aria-label": words });
    this.draw();
    if (dimension === 3) this.listen();
  }

  /** Pixels to a unit of length. */
  get scale() {
    return (size / 2 - margin) / this.radius;
  }

  onPage([x, y, z]) {
    const point = [x - this.centre[0], y - this.centre[1], z - this.centre[2]];
    const at = (row) => this.turned[row] * point[0] + this.turned[4 + row] * point[1] + this.turned[8 + row] * point[2];
    return [size / 2 + this.scale * at(0), size / 2 - this.scale * at(1)];
  }

  turn(right, up) {
    this.turned = product(product(rotation([1, 0, 0], -3 * up), rotation([0, 1, 0], 3 * right)), this.turned);
    this.draw();
  }

  listen() {
    let before = null;
    this.svg.addEventListener("pointerdown", (event) => {
      before = [event.clientX, event.clientY];
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (!before) return;
      this.turn((event.clientX - before[0]) / size, (before[1] - event.clientY) / size);
      before = [event.clientX, event.clientY];
    });
    this.svg.addEventListener("pointerup", () => { before = null; });
    const keys = { ArrowLeft: [-0.05, 0], ArrowRight: [0.05, 0], ArrowUp: [0, 0.05], ArrowDown: [0, -0.05] };
    this.svg.addEventListener("keydown", (event) => {
      if (!keys[event.key]) return;
      event.preventDefault();
      this.turn(...keys[event.key]);
    });
  }
}
