// A star in a chart of its label. On space forms in conformal coordinates with the label at the origin, in which geodesic
// balls are round; on flat manifolds as it is; of surfaces in space the projection along the mean normal. In doubles.

const dot = (a, b) => a.reduce((sum, value, at) => sum + value * b[at], 0);
const scaled = (factor, a) => a.map((value) => factor * value);
const plus = (a, b) => a.map((value, at) => value + b[at]);
const minus = (a, b) => a.map((value, at) => value - b[at]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (a) => scaled(1 / Math.sqrt(dot(a, a)), a);

const curvatures = { flat: 0, metric: 0, spherical: 1, hyperbolic: -1 };

/** The isometry that takes the origin to a, of the space of this curvature in conformal coordinates, along a line. */
export function moved(a, x, curvature) {
  const along = 2 * curvature * dot(a, x), square = dot(x, x), own = dot(a, a);
  const sum = plus(scaled(1 - along - curvature * square, a), scaled(1 + curvature * own, x));
  return scaled(1 / (1 - along + curvature * curvature * own * square), sum);
}

/** An orthonormal frame whose first vectors span these, and one vector orthogonal to them. */
function frame(vectors) {
  const result = [];
  for (const vector of vectors) result.push(unit(result.reduce((rest, own) => minus(rest, scaled(dot(own, vector), own)), vector)));
  const [a, b] = result;
  return [...result, b ? cross(a, b) : [-a[1], a[0]]];
}

/** Where `apex` lies beyond the placed facet, seen from `inside`, if it lies so off the facet in coordinates of its own. */
function beyond(facet, apex, placed, inside, curvature) {
  const local = (origin) => (x) => moved(scaled(-1, origin), x, curvature);
  const own = frame(facet.slice(1).map(local(facet[0]))), chart = frame(placed.slice(1).map(local(placed[0])));
  const shares = own.map((axis) => dot(axis, local(facet[0])(apex))), last = shares.length - 1;
  shares[last] = Math.abs(shares[last]) * (dot(chart[last], local(placed[0])(inside)) > 0 ? -1 : 1);
  return moved(placed[0], shares.reduce((sum, share, at) => plus(sum, scaled(share, chart[at])), placed[0].map(() => 0)), curvature);
}

/** Vertices of a simplex in conformal coordinates. Those on the unit sphere are turned first, so that none is far out. */
function conformal(drawing, vertices) {
  const points = vertices.map((vertex) => [...drawing.coordinates.subarray(3 * vertex, 3 * vertex + 3)]);
  if (drawing.geometry !== "spherical" || drawing.model !== "unit") return points.map((point) => point.slice(0, drawing.corners - 1));
  const mirror = minus(points[0], [0, 0, 1]), square = dot(mirror, mirror);
  const turned = square > 1e-20 ? points.map((point) => minus(point, scaled(2 * dot(mirror, point) / square, mirror))) : points;
  return turned.map(([x, y, z]) => [x / (1 + z), y / (1 + z)]);
}

/** The simplex beyond the facet of `simplex` opposite to `label`: {simplex, label}; null at a boundary. */
function across(complex, simplex, label) {
  const facet = complex.labels(simplex).filter((own) => own !== label);
  const other = complex.star(facet[0]).find((own) => own !== simplex && facet.every((one) => complex.labels(own).includes(one)));
  return other === undefined ? null : { simplex: other, label: complex.labels(other).find((own) => !facet.includes(own)) };
}

function developed(complex, label, curvature) {
  const { drawing } = complex, star = complex.star(label), points = new Map();
  const coordinates = (simplex) => {
    const places = conformal(drawing, [...complex.vertices(simplex)]);
    return new Map(complex.labels(simplex).map((own, at) => [own, places[at]]));
  };
  const origin = coordinates(star[0]);
  for (const [own, place] of origin) points.set(own, moved(scaled(-1, origin.get(label)), place, curvature));
  const put = (simplex, facet, apex, inside) => {
    const own = coordinates(simplex);
    return beyond(facet.map((one) => own.get(one)), own.get(apex), facet.map((one) => points.get(one)), inside, curvature);
  };
  const waiting = [star[0]], seen = new Set(waiting), outer = new Map();
  while (waiting.length) {
    const simplex = waiting.shift(), labels = complex.labels(simplex);
    for (const left of labels) {
      const next = across(complex, simplex, left), facet = [label, ...labels.filter((own) => own !== left && own !== label)];
      if (!next) continue;
      if (left === label) outer.set(simplex, { label: next.label, point: put(next.simplex, facet.slice(1), next.label, points.get(label)) });
      else if (!seen.has(next.simplex)) {
        seen.add(next.simplex);
        waiting.push(next.simplex);
        if (!points.has(next.label)) points.set(next.label, put(next.simplex, facet, next.label, points.get(left)));
      }
    }
  }
  return { points, outer };
}

function projected(complex, label) {
  const { drawing } = complex, at = (vertex) => [...drawing.coordinates.subarray(3 * vertex, 3 * vertex + 3)];
  const star = complex.star(label), centre = at(complex.vertexOf(star[0], label)), places = new Map(), normals = [];
  const note = (simplex) => complex.vertices(simplex).forEach((vertex) => places.set(drawing.label[vertex], minus(at(vertex), centre)));
  for (const simplex of star) {
    note(simplex);
    const [b, c] = complex.labels(simplex).filter((own) => own !== label).map((own) => places.get(own)), normal = cross(b, c);
    normals.push(normals.length && dot(normals[0], normal) < 0 ? scaled(-1, normal) : normal);
  }
  const upward = unit(normals.reduce(plus)), axis = unit(cross(upward, Math.abs(upward[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0])), other = cross(upward, axis);
  const flat = (place) => [dot(axis, place), dot(other, place)];
  const outer = new Map();
  for (const simplex of star) {
    const next = across(complex, simplex, label);
    if (!next) continue;
    const beyond = complex.vertexOf(next.simplex, next.label);
    if (!places.has(next.label)) places.set(next.label, minus(at(beyond), centre));
    outer.set(simplex, { label: next.label, point: flat(places.get(next.label)) });
  }
  const inStar = new Set(star.flatMap((simplex) => complex.labels(simplex)));
  return { points: new Map([...places].filter(([own]) => inStar.has(own)).map(([own, place]) => [own, flat(place)])), outer };
}

/** The star of a label: {points, outer, round}: where the labels of the star are; of each simplex the label and the place of
 * the vertex beyond its facet opposite to `label`; and whether spheres of the chart are those of the claims. Null where the
 * drawing does not tell: on atlases by formulas, and where coordinates are left out. */
export function starChart(complex, label) {
  const { drawing } = complex, m = complex.corners - 1, curvature = curvatures[drawing.geometry];
  if (m < 2 || !complex.star(label).length || drawing.projection) return null;
  if (drawing.geometry === "space") return m === 2 && drawing.ambient_dimension === 3 ? { ...projected(complex, label), round: true } : null;
  if (curvature === undefined || !["unit", "conformal", "stereographic"].includes(drawing.model)) return null;
  if (drawing.geometry === "spherical" && drawing.model === "unit" && m > 2) return null;
  return { ...developed(complex, label, curvature), round: drawing.geometry !== "metric" };
}
