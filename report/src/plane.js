// A few steps of linear algebra for drawings of witnesses, in doubles.

const dot = (a, b) => a.reduce((sum, value, at) => sum + value * b[at], 0);
const minus = (a, b) => a.map((value, at) => value - b[at]);
export const length = (a) => Math.sqrt(dot(a, a));

/** An orthonormal basis of the hull of points, its directions taken the longest first. */
export function hullBasis(points) {
  const rest = points.slice(1).map((point) => minus(point, points[0])), basis = [];
  const size = Math.max(...rest.map(length), 0);
  for (;;) {
    rest.sort((a, b) => length(b) - length(a));
    const [longest] = rest;
    // Flat to double precision.
    if (!longest || length(longest) <= 1e-13 * size) return basis;
    const unit = longest.map((value) => value / length(longest));
    basis.push(unit);
    rest.forEach((vector, at) => { rest[at] = minus(vector, unit.map((value) => value * dot(vector, unit))); });
  }
}

/** Coordinates in the hull of the points. */
export function inHull(points, basis) {
  return points.map((point) => basis.map((unit) => dot(minus(point, points[0]), unit)));
}

/** The centre and radius of the sphere through affinely independent points in their own hull; null for none in doubles. */
export function circumscribed(points) {
  const rows = points.slice(1).map((point) => minus(point, points[0]));
  const system = rows.map((row) => [...rows.map((other) => dot(row, other)), dot(row, row) / 2]);
  const size = rows.length;
  for (let pivot = 0; pivot < size; ++pivot) {
    let best = pivot;
    for (let row = pivot + 1; row < size; ++row) if (Math.abs(system[row][pivot]) > Math.abs(system[best][pivot])) best = row;
    if (!(Math.abs(system[best][pivot]) > 0)) return null;
    [system[pivot], system[best]] = [system[best], system[pivot]];
    for (let row = 0; row < size; ++row) {
      if (row === pivot) continue;
      const factor = system[row][pivot] / system[pivot][pivot];
      for (let column = pivot; column <= size; ++column) system[row][column] -= factor * system[pivot][column];
    }
  }
  const shares = system.map((row, at) => row[size] / row[at]);
  const centre = points[0].map((value, axis) => value + rows.reduce((sum, row, at) => sum + shares[at] * row[axis], 0));
  const radius = length(minus(centre, points[0]));
  return Number.isFinite(radius) ? { centre, radius } : null;
}

/** The foot of the altitude of a vertex on the hull of the others. */
export function foot(points, vertex) {
  const others = points.filter((_, at) => at !== vertex), basis = hullBasis(others);
  const way = minus(points[vertex], others[0]);
  return others[0].map((value, axis) => value + basis.reduce((sum, unit) => sum + dot(way, unit) * unit[axis], 0));
}

export function shapeOf(points) {
  const edges = [];
  for (let a = 0; a < points.length; ++a) for (let b = a + 1; b < points.length; ++b) edges.push(length(minus(points[a], points[b])));
  const altitudes = points.length > 1 ? points.map((point, at) => length(minus(point, foot(points, at)))) : [];
  const longest = Math.max(...edges, 0);
  return {
    edges, altitudes, longest, shortest: edges.length ? Math.min(...edges) : 0,
    thickness: points.length > 1 && longest > 0 ? Math.min(...altitudes) / ((points.length - 1) * longest) : 1,
    sphere: points.length > 1 ? circumscribed(points) : null,
  };
}
