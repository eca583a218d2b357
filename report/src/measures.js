// What is measured of every simplex, and the scale on which it is shown.
import { decimal } from "./elements.js";

export const measures = {
  protection: { name: "Protection / ε", worst: "least", what: "protection", bound: "at least" },
  thickness: { name: "Thickness", worst: "least", what: "thickness", bound: "at least" },
  circumradius: { name: "Circumradius / ε", worst: "greatest", what: "circumradius", bound: "at most" },
  hinge: { name: "Hinge", worst: "least", what: "hinge", bound: "at least" },
};

/** The places of values on a scale of ratios, or of differences where there are values up to 0; and back. */
export class Scale {
  constructor(values, bound) {
    let low = Infinity, high = -Infinity;
    const include = (value) => {
      if (Number.isNaN(value)) return;
      low = Math.min(low, value);
      high = Math.max(high, value);
    };
    values.forEach(include);
    if (bound !== null && bound !== undefined) include(bound);
    if (!(low <= high)) low = high = 1;
    this.byRatios = low > 0 && high / low > 2;
    this.low = low;
    this.high = high > low ? high : low + Math.abs(low || 1) * 1e-9;
  }

  /** Where a value is, from 0 to 1. */
  place(value) {
    const place = this.byRatios ? Math.log(value / this.low) / Math.log(this.high / this.low)
      : (value - this.low) / (this.high - this.low);
    return Math.min(Math.max(place, 0), 1);
  }

  value(place) {
    return this.byRatios ? this.low * (this.high / this.low) ** place : this.low + (this.high - this.low) * place;
  }

  text(place) {
    return decimal(this.value(place), 3);
  }
}
