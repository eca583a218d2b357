// The data of the page, as proofs/report/payload.hpp packs them: JSON for what is short, and for each certificate one
// compressed block of streams, each with its place in the block, its encoding and what the encoding needs.

async function inflated(text) {
  const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** Byte k of every number, then byte k + 1 of every number, …: as little-endian numbers again. */
function fromPlanes(bytes, width) {
  const size = bytes.length / width, result = new Uint8Array(bytes.length);
  for (let plane = 0; plane < width; ++plane)
    for (let at = 0; at < size; ++at) result[at * width + plane] = bytes[plane * size + at];
  return result.buffer;
}

/** Unsigned numbers, seven bits a byte, the lowest first. */
function fromVarints(bytes) {
  const result = [];
  let number = 0, factor = 1;
  for (const byte of bytes) {
    number += (byte & 127) * factor;
    factor *= 128;
    if (byte < 128) {
      result.push(number);
      number = 0;
      factor = 1;
    }
  }
  return Uint32Array.from(result);
}

/** Doubles from their codes: 0 is "not measured", the others run from `low` to `high` in equal steps or equal ratios. */
function fromCodes(codes, most, { low, high, scale }) {
  const steps = most - 1, ratio = Math.log(high / low);
  return Float64Array.from(codes, (code) => code === 0 ? NaN
    : scale === "ratios" ? low * Math.exp(ratio * (code - 1) / steps) : low + (high - low) * (code - 1) / steps);
}

const decoders = {
  floats: (bytes) => new Float32Array(fromPlanes(bytes, 4)),
  varints: fromVarints,
  codes16: (bytes, stream) => fromCodes(new Uint16Array(fromPlanes(bytes, 2)), 65535, stream),
  codes8: (bytes, stream) => fromCodes(bytes, 255, stream),
  lines: (bytes) => new TextDecoder().decode(bytes).split("\n"),
};

/**
 * Columns of increasing rows, of which each number is written as its difference to the one above it where the row
 * begins like the one above, and else to the one on its left: as rows again, one after the other.
 */
function rowsOf(columns) {
  const width = columns.length, height = columns[0].length, result = new Uint32Array(width * height);
  for (let row = 0; row < height; ++row) {
    let same = row > 0;
    for (let column = 0; column < width; ++column) {
      const at = row * width + column;
      const before = same ? result[at - width] : column > 0 ? result[at - 1] : 0;
      result[at] = before + columns[column][row];
      same &&= columns[column][row] === 0;
    }
  }
  return result;
}

/** Points of so many coordinates as points of three. */
function inSpace(numbers, ambient) {
  const result = new Float32Array(numbers.length / ambient * 3);
  numbers.forEach((number, at) => { result[3 * Math.floor(at / ambient) + at % ambient] = number; });
  return result;
}

/** [[vertices], [their copies], what takes the first to the second]. */
function matchingFaces({ vertices, steps, texts }, stream, width) {
  const numbers = stream(vertices);
  return Array.from(stream(steps), (step, at) => {
    const face = [...numbers.subarray(2 * width * at, 2 * width * (at + 1))];
    return [face.slice(0, width), face.slice(width), texts[step]];
  });
}

/**
 * What is to be drawn of a certificate: {dimension, coordinates (three a vertex), label, lift, simplices, measures, …},
 * `simplices` with `corners` = dimension + 1 vertices each; of `measures` those that the certificate has.
 */
export async function unpackedDrawing(packed, block) {
  const bytes = await inflated(block);
  const stream = (entry) => decoders[entry.encoding](bytes.subarray(entry.offset, entry.offset + entry.bytes), entry);
  const axes = packed.coordinates.map(stream);
  const size = axes[0].length, coordinates = new Float32Array(3 * size);
  axes.forEach((axis, at) => axis.forEach((value, vertex) => { coordinates[3 * vertex + at] = value; }));
  const measures = {};
  for (const [name, entry] of Object.entries(packed.measures)) if (entry) measures[name] = stream(entry);
  return {
    ...packed,
    // On spheres these are two names of one model.
    model: packed.geometry === "spherical" && packed.model === "conformal" ? "stereographic" : packed.model,
    domain: packed.domain ? inSpace(stream(packed.domain), packed.ambient_dimension) : null,
    matching_faces: packed.matching ? matchingFaces(packed.matching, stream, packed.dimension) : [],
    corners: packed.simplices.length,
    coordinates,
    label: stream(packed.label),
    lift: stream(packed.lift),
    simplices: rowsOf(packed.simplices.map(stream)),
    measures,
    exact: packed.exact ? stream(packed.exact).map((line) => line.split(" ")) : null,
  };
}
