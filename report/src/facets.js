// Which facets of a three-dimensional complex can be seen: drawing the others takes most of the time and shows nothing.

/** For each facet of each simplex (the one opposite to corner k of simplex s is 4s + k) its other simplex; −1 for none. */
export function neighboursOf(simplices) {
  const size = simplices.length / 4, result = new Int32Array(simplices.length).fill(-1);
  let slots = 1;
  while (slots < 4 * simplices.length) slots *= 2;
  const table = new Int32Array(slots).fill(-1);
  // The vertices of a facet in increasing order, as those of a simplex are.
  const vertex = (facet, at) => {
    const corner = facet % 4;
    return simplices[facet - corner + (at < corner ? at : at + 1)];
  };
  for (let facet = 0; facet < 4 * size; ++facet) {
    const a = vertex(facet, 0), b = vertex(facet, 1), c = vertex(facet, 2);
    let slot = (Math.imul(a, 73856093) ^ Math.imul(b, 19349663) ^ Math.imul(c, 83492791)) & (slots - 1);
    for (;; slot = (slot + 1) & (slots - 1)) {
      const other = table[slot];
      if (other < 0) {
        table[slot] = facet;
        break;
      }
      if (vertex(other, 0) === a && vertex(other, 1) === b && vertex(other, 2) === c) {
        result[facet] = other >> 2;
        result[other] = facet >> 2;
        break;
      }
    }
  }
  return result;
}

/**
 * Whether both simplices of a facet are on the same side of it, facet by facet, in three coordinates of each vertex: so
 * the outline of a closed manifold in a space of more dimensions is seen, which has no facet without a neighbour.
 */
export function foldsOf(simplices, neighbours, coordinates) {
  const result = new Uint8Array(neighbours.length);
  const corners = [0, 0, 0];
  // Whether the vertex is above the plane of the corners.
  const side = (vertex) => {
    const place = (other, axis) => coordinates[3 * other + axis] - coordinates[3 * corners[0] + axis];
    const [, b, c] = corners;
    return Math.sign(place(b, 0) * (place(c, 1) * place(vertex, 2) - place(c, 2) * place(vertex, 1)) -
      place(b, 1) * (place(c, 0) * place(vertex, 2) - place(c, 2) * place(vertex, 0)) +
      place(b, 2) * (place(c, 0) * place(vertex, 1) - place(c, 1) * place(vertex, 0)));
  };
  for (let facet = 0; facet < neighbours.length; ++facet) {
    const simplex = facet >> 2, other = neighbours[facet];
    if (other < simplex) {
      // Seen from the other simplex already, or without a neighbour.
      continue;
    }
    let at = 0, opposite = 0;
    for (let corner = 0; corner < 4; ++corner) {
      opposite += simplices[4 * other + corner];
      if (corner !== facet % 4) opposite -= corners[at++] = simplices[4 * simplex + corner];
    }
    if (side(simplices[facet]) * side(opposite) < 0) continue;
    result[facet] = 1;
    for (let corner = 0; corner < 4; ++corner) if (simplices[4 * other + corner] === opposite) result[4 * other + corner] = 1;
  }
  return result;
}

/**
 * The facets to draw, as 4s + k, where `hidden` says which simplices are not there. Simplices of full size show the
 * facets without a neighbour and the `folds` alone; between smaller ones one sees into the complex, `layers` deep.
 */
export function visibleFacets(neighbours, hidden, layers, folds = null) {
  const result = [];
  const open = (facet) => neighbours[facet] < 0 || hidden[neighbours[facet]] !== 0 || (folds !== null && folds[facet] !== 0);
  if (layers === 0) {
    for (let facet = 0; facet < neighbours.length; ++facet) if (!hidden[facet >> 2] && open(facet)) result.push(facet);
    return result;
  }
  const depth = new Uint8Array(hidden.length);
  let front = [];
  for (let facet = 0; facet < neighbours.length; ++facet) {
    const simplex = facet >> 2;
    if (hidden[simplex] || depth[simplex] || !open(facet)) continue;
    depth[simplex] = 1;
    front.push(simplex);
  }
  for (let layer = 1; layer < layers && front.length; ++layer) {
    const next = [];
    for (const simplex of front) {
      for (let facet = 4 * simplex; facet < 4 * simplex + 4; ++facet) {
        const other = neighbours[facet];
        if (other < 0 || hidden[other] || depth[other]) continue;
        depth[other] = 1;
        next.push(other);
      }
    }
    front = next;
  }
  for (let facet = 0; facet < neighbours.length; ++facet) if (depth[facet >> 2]) result.push(facet);
  return result;
}
