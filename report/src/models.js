// The models of the three geometries. Each is radial: a point at distance t from the centre is drawn at radius f(t).

const radial = {
  hyperbolic: {
    conformal: { name: "Poincaré (conformal)", to: (t) => Math.tanh(t / 2), from: (r) => 2 * Math.atanh(Math.min(r, 1 - 1e-12)) },
    gnomonic: { name: "Klein (straight)", to: (t) => Math.tanh(t), from: (r) => Math.atanh(Math.min(r, 1 - 1e-12)) },
  },
  spherical: {
    azimuthal: { name: "azimuthal (true distances)", to: (t) => t, from: (r) => r },
    stereographic: { name: "stereographic (conformal)", to: (t) => Math.tan(t / 2), from: (r) => 2 * Math.atan(r) },
    gnomonic: { name: "gnomonic (straight)", to: (t) => Math.tan(t), from: (r) => Math.atan(r), most: 1.45 },
  },
};

/** The models among which a reader may choose, [key, name]; none where there is but one. */
export function modelsOf(drawing) {
  const family = radial[drawing.geometry];
  if (!family?.[drawing.model]) return [];
  const { coordinates } = drawing;
  let most = 0;
  for (let at = 0; at < coordinates.length; at += 3)
    most = Math.max(most, family[drawing.model].from(Math.hypot(coordinates[at], coordinates[at + 1], coordinates[at + 2])));
  return Object.entries(family).filter(([, model]) => most <= (model.most ?? Infinity)).map(([key, model]) => [key, model.name]);
}

/** The same points, three coordinates each, in another model. */
export function inModel(drawing, points, model) {
  const family = radial[drawing.geometry], result = Float32Array.from(points);
  if (!family?.[model] || model === drawing.model) return result;
  for (let at = 0; at < result.length; at += 3) {
    const radius = Math.hypot(result[at], result[at + 1], result[at + 2]);
    if (radius === 0) continue;
    const factor = family[model].to(family[drawing.model].from(radius)) / radius;
    for (let axis = 0; axis < 3; ++axis) result[at + axis] *= factor;
  }
  return result;
}

/** What goes back where a step came from: "0 -1" of "0 1", "e1 g2^-1" of "g2 e1^-1"; words of charts the other way round. */
export function inverseStep(step) {
  if (/^-?\d+( -?\d+)*$/.test(step)) return step.split(" ").map((entry) => entry.startsWith("-") ? entry.slice(1) : entry === "0" ? entry : `-${entry}`).join(" ");
  if (step.includes(" -> ")) return step.split(" -> ").reverse().join(" -> ");
  return step.split(" ").reverse().map((letter) => {
    const [name, power = "1"] = letter.split("^");
    return power === "-1" ? name : power.startsWith("-") ? `${name}^${power.slice(1)}` : `${name}^-${power}`;
  }).join(" ");
}

/** The distance from the centre of the model within which this share of the points is. */
export function radiusOfShare(points, share) {
  const distances = [];
  for (let at = 0; at < points.length; at += 3) distances.push(Math.hypot(points[at], points[at + 1], points[at + 2]));
  distances.sort((a, b) => a - b);
  return distances[Math.floor(share * (distances.length - 1))] || 1;
}

/**
 * How far the picture reaches: {centre, radius} of a ball around all points, or of a square around those of a plane.
 */
export function extentOf(points, inPlane = false) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < points.length; ++at) {
    const value = points[at], axis = at % 3;
    if (value < low[axis]) low[axis] = value;
    if (value > high[axis]) high[axis] = value;
  }
  const centre = low.map((value, axis) => (value + high[axis]) / 2);
  if (inPlane) return { centre, radius: Math.max(...high.map((value, axis) => value - centre[axis])) * 1.04 || 1 };
  let square = 0;
  for (let at = 0; at < points.length; at += 3) {
    const own = (points[at] - centre[0]) ** 2 + (points[at + 1] - centre[1]) ** 2 + (points[at + 2] - centre[2]) ** 2;
    if (own > square) square = own;
  }
  return { centre, radius: Math.sqrt(square) || 1 };
}

/** The translations of a flat cell, as vectors of the drawing, from points that it shows twice; [] where there are none. */
export function periodsOf(drawing) {
  if (drawing.geometry !== "flat") return [];
  const vectors = drawing.lifts.map((text) => /^-?\d+( -?\d+)*$/.test(text) ? text.split(" ").map(Number) : null);
  const first = new Map(), periods = [];
  for (let vertex = 0; vertex < drawing.label.length; ++vertex) {
    const vector = vectors[drawing.lift[vertex]], label = drawing.label[vertex];
    if (!vector) return [];
    const other = first.get(label);
    if (other === undefined) {
      first.set(label, vertex);
      continue;
    }
    const step = vector.map((entry, axis) => entry - vectors[drawing.lift[other]][axis]);
    const moved = step.findIndex((entry) => entry !== 0);
    if (moved < 0 || periods[moved] || step.some((entry, axis) => axis !== moved && entry !== 0)) continue;
    periods[moved] = [0, 1, 2].map((axis) =>
      (drawing.coordinates[3 * vertex + axis] - drawing.coordinates[3 * other + axis]) / step[moved]);
  }
  return periods.length === drawing.corners - 1 && periods.every(Boolean) && !periods.includes(undefined) ? periods : [];
}
