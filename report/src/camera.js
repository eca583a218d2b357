// Where the picture is looked at from: turned about the centre of the drawing in space, shifted in the plane.
import { applied, product, rotation } from "./matrices.js";

const angle = 30 * Math.PI / 180;

export class Camera {
  constructor({ centre, radius }, { turns, perspective }) {
    Object.assign(this, { centre, radius, turns, perspective, turned: null, zoom: 1, shift: [0, 0] });
    this.reset();
  }

  reset() {
    this.turned = this.turns ? product(rotation([1, 0, 0], 0.45), rotation([0, 1, 0], -0.55)) : rotation([1, 0, 0], 0);
    this.zoom = 1;
    this.shift = [0, 0];
  }

  extend({ centre, radius }) {
    this.centre = centre;
    this.radius = radius;
  }

  /** Turns or shifts by a step on the screen, in shares of its height. */
  drag(right, up, shifts = !this.turns) {
    if (shifts) this.shift = [this.shift[0] + 2 * right / this.zoom, this.shift[1] + 2 * up / this.zoom];
    else this.turned = product(product(rotation([1, 0, 0], -3 * up), rotation([0, 1, 0], 3 * right)), this.turned);
  }

  /** Turns a direction of the drawing, of length 1, towards the eye, by the shortest way. */
  face(direction) {
    const [x, y, z] = applied(this.turned, direction), across = Math.hypot(x, y);
    const axis = across > 1e-6 ? [y / across, -x / across, 0] : [0, 1, 0];
    this.turned = product(rotation(axis, Math.atan2(across, z)), this.turned);
  }

  scale(factor) {
    this.zoom = Math.min(Math.max(this.zoom * factor, 0.4), 200);
  }

  /** Puts a point of the drawing into the middle. */
  aim(point) {
    const unit = applied(this.place(), point);
    this.shift = [-unit[0], -unit[1]];
  }

  /** From the drawing to a unit ball about the origin, turned. */
  place() {
    const size = 1 / this.radius, [x, y, z] = this.centre;
    return product(this.turned, Float32Array.of(size, 0, 0, 0, 0, size, 0, 0, 0, 0, size, 0, -x * size, -y * size, -z * size, 1));
  }

  /** From the unit ball to the screen, `aspect` = width / height. */
  projection(aspect) {
    const narrow = Math.min(aspect, 1), shifted = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, this.shift[0], this.shift[1], 0, 1);
    if (!this.perspective) {
      const scale = 0.94 * this.zoom * narrow;
      return product(Float32Array.of(scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, -0.1, 0, 0, 0, 0, 1), shifted);
    }
    const distance = 1.06 / Math.sin(angle / 2), near = Math.max(distance - 4, 0.5), far = distance + 6;
    const focal = this.zoom * narrow / Math.tan(angle / 2);
    const lens = Float32Array.of(focal / aspect, 0, 0, 0, 0, focal, 0, 0, 0, 0, (near + far) / (near - far), -1, 0, 0,
      2 * near * far / (near - far), 0);
    return product(product(lens, Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -distance, 1)), shifted);
  }
}
