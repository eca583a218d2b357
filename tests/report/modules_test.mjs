// modules_test.mjs PROJECT: modules of the page that need no browser, each computed in two ways.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { expect, expectEqual, expectNoticed, finish } from "./check.mjs";
import { value } from "./programs.mjs";

const project = process.argv[2], load = (name) => import(pathToFileURL(join(project, "report/src", name)));
const { approximate } = await load("exact.js"), { foldsOf, neighboursOf, visibleFacets } = await load("facets.js");
const { inModel, inverseStep, periodsOf } = await load("models.js"), { Scale } = await load("measures.js");
const { circumscribed, foot, shapeOf } = await load("plane.js"), { levels, order, claimedLevels } = await load("statements.js");
const { Complex } = await load("complex.js"), { moved, starChart } = await load("star_chart.js"), { ballOf } = await load("star_drawing.js");
const { Camera } = await load("camera.js"), { applied } = await load("matrices.js");
const { visible } = await load("elements.js"), { colourAt } = await load("colours.js");

const near = (a, b, error = 1e-12) => Math.abs(a - b) <= error * Math.max(1, Math.abs(b));
let state = 1;
/** The same numbers in every run. */
const random = () => (state = state * 48271 % 2147483647) / 2147483647;

// Exact numbers.
for (const [text, number] of [["0", 0], ["-17", -17], ["1/3", 1 / 3], ["-22/7", -22 / 7], ["0x3p-6", 3 / 64], ["-0x521p-18", -1313 / 262144], ["0x1.8p1", 3],
  ["0x10000000000000000000000p-88", 1], [`1${"0".repeat(400)}/3${"0".repeat(400)}`, 1 / 3]]) {
  expect(near(approximate(text), number), `${text} is about ${number}, not ${approximate(text)}`);
  if (text.length < 100) expect(near(value(text), number), `${text} in the other way`);
}
for (const text of ["", "1.5", "0x", "1/0", "true", "Z, Z^2, Z", "1/2, 3"]) expect(Number.isNaN(approximate(text)), `${text} is no exact number`);

// What cannot be seen is shown.
expectEqual(visible("a\u202Eb\u0007\u200B\nü ℝ"), "a\\u202Eb\\u0007\\u200B\\u000Aü ℝ", "signs that cannot be seen");

// Facets: against a search over all pairs.
function grid(size) {
  const at = (x, y, z) => (x * size + y) * size + z, result = [];
  const orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
  for (let x = 0; x + 1 < size; ++x) for (let y = 0; y + 1 < size; ++y) for (let z = 0; z + 1 < size; ++z) for (const axes of orders) {
    const corner = [x, y, z], own = [at(...corner)];
    for (const axis of axes) {
      ++corner[axis];
      own.push(at(...corner));
    }
    result.push(...own.sort((a, b) => a - b));
  }
  return Uint32Array.from(result);
}
function slowNeighbours(simplices) {
  const sets = [];
  for (let at = 0; at < simplices.length; at += 4) sets.push([...simplices.subarray(at, at + 4)]);
  return sets.flatMap((own, at) => own.map((left) => sets.findIndex((other, place) => place !== at && own.every((vertex) => vertex === left || other.includes(vertex)))));
}
const simplices = grid(4), neighbours = neighboursOf(simplices), none = new Uint8Array(simplices.length / 4);
expectEqual([...neighbours], slowNeighbours(simplices), "neighbours");
expectEqual(visibleFacets(neighbours, none, 0).length, 6 * 9 * 2, "the surface of a cube of 27 cells");
const half = none.map((_, at) => at % 2);
expectEqual(visibleFacets(neighbours, half, 0), [...neighbours.keys()].filter((facet) => !half[facet >> 2] && (neighbours[facet] < 0 || half[neighbours[facet]])), "facets beside hidden simplices");
expectEqual(visibleFacets(neighbours, none, 255).length, simplices.length, "all layers");
const layers = [1, 2, 3].map((number) => visibleFacets(neighbours, none, number).length);
expect(layers[0] > visibleFacets(neighbours, none, 0).length && layers[0] < layers[1] && layers[1] <= layers[2], `layers grow: ${layers}`);
await expectNoticed(() => expectEqual([...neighboursOf(simplices.slice(4))], slowNeighbours(simplices), "neighbours"), "a simplex too few");

// Folds: none in a cube of cells; of the boundary of a 4-simplex with a vertex inside of the others, the four facets of those.
const places = (count, of) => Float32Array.from(Array.from({ length: count }, (_, vertex) => of(vertex)).flat());
expect(!foldsOf(simplices, neighbours, places(64, (vertex) => [vertex & 3, vertex >> 2 & 3, vertex >> 4])).some((fold) => fold), "an embedded complex has no fold");
const closed = Uint32Array.from([0, 1, 2, 3, 0, 1, 2, 4, 0, 1, 3, 4, 0, 2, 3, 4, 1, 2, 3, 4]), beside = neighboursOf(closed), five = new Uint8Array(5);
const inside = places(5, (vertex) => [[1, 1, 1], [0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]][vertex]), folds = foldsOf(closed, beside, inside);
expectEqual(visibleFacets(beside, five, 0).length, 0, "a closed complex has no facet without a neighbour");
expectEqual(visibleFacets(beside, five, 0, folds), [0, 4, 8, 12, 16, 17, 18, 19], "its outline");
await expectNoticed(() => expectEqual(foldsOf(closed, beside, inside.map((x, at) => at === 0 ? 9 : x)).join(), folds.join(), "folds"), "a vertex outside of the others");

// Cameras: a direction that is faced is in the middle, nearer to the eye than the centre, wherever it was.
for (const turns of [[0, 0], [0.3, 0.1], [-0.9, 0.4]]) {
  for (const direction of [[0, 0, 1], [0, 0, -1], [1, 0, 0], [-0.36, 0.48, -0.8]]) {
    const camera = new Camera({ centre: [1, 2, 3], radius: 2 }, { turns: true, perspective: false });
    camera.drag(...turns);
    camera.face(direction);
    const [x, y, z] = applied(camera.place(), direction.map((value, axis) => camera.centre[axis] + value));
    expect(Math.hypot(x, y, z - 0.5) < 1e-5, `${direction} is faced: ${[x, y, z]}`);
    expect(near(Math.hypot(...applied(camera.turned, [0.6, 0, 0.8]).slice(0, 3)), 1, 1e-5), "a camera that faces something keeps lengths");
    camera.drag(0.1, 0);
    await expectNoticed(() => expect(Math.hypot(...applied(camera.place(), camera.centre.map((value, axis) => value + direction[axis])).slice(0, 2)) < 1e-5, "faced"), "a camera that is turned away");
  }
}

// Models: conformal and straight disks against the hyperboloid, and the sphere.
for (let trial = 0; trial < 50; ++trial) {
  const distance = 3 * random(), angle = 7 * random(), direction = [Math.cos(angle), Math.sin(angle), 0];
  const disk = direction.map((own) => own * Math.sinh(distance) / (1 + Math.cosh(distance))), klein = direction.map((own) => own * Math.tanh(distance));
  const found = inModel({ geometry: "hyperbolic", model: "conformal" }, disk, "gnomonic");
  expect(klein.every((own, axis) => near(found[axis], own, 1e-6)), `Klein's disk at distance ${distance}`);
  const sphere = direction.map((own) => own * Math.sin(distance) / (1 + Math.cos(distance)));
  const azimuthal = inModel({ geometry: "spherical", model: "stereographic" }, sphere, "azimuthal");
  expect(direction.every((own, axis) => near(azimuthal[axis], own * distance, 1e-4)), `the azimuthal model at distance ${distance}`);
}

// Periods of a cell, of points that it shows twice.
const skewed = { geometry: "flat", corners: 3, lifts: ["0 0", "1 0", "0 -1", "2 1"], label: [5, 5, 5, 5], lift: [0, 1, 2, 3], coordinates: [0.1, 0.2, 0, 1.1, 0.2, 0, -0.2, -0.8, 0, 2.4, 1.2, 0] };
expect(periodsOf(skewed).flat().every((own, at) => near(own, [1, 0, 0, 0.3, 1, 0][at])), "periods of a skewed torus");
expectEqual(periodsOf({ ...skewed, lifts: ["", "", "", ""] }), [], "no periods without vectors");

// Steps back.
for (const [step, back] of [["0 1", "0 -1"], ["-3 0 2", "3 0 -2"], ["g2 e1^-1", "e1 g2^-1"], ["a^2 b", "b^-1 a^-2"], ["north -> south", "south -> north"]]) {
  expectEqual(inverseStep(step), back, `back from ${step}`);
  expectEqual(inverseStep(back), step, `back from ${back}`);
}

// Scales.
for (const [values, bound] of [[[0.01, 0.5, 3], 0.009], [[-1, 0, 4], null], [[2, 2], null]]) {
  const scale = new Scale(values, bound);
  for (const own of values) expect(near(scale.value(scale.place(own)), own, 1e-6), `${own} on the scale of ${values}`);
}

// Simplices: circumcentres are as far from all vertices, feet are orthogonal.
for (let trial = 0; trial < 50; ++trial) {
  const points = Array.from({ length: 2 + trial % 3 }, () => Array.from({ length: 3 + trial % 2 }, random));
  const { centre, radius } = circumscribed(points), distance = (a, b) => Math.hypot(...a.map((own, axis) => own - b[axis]));
  for (const point of points) expect(near(distance(point, centre), radius, 1e-7), "a circumcentre");
  const low = foot(points, 0), way = points[0].map((own, axis) => own - low[axis]);
  for (const point of points.slice(2)) expect(Math.abs(way.reduce((sum, own, axis) => sum + own * (point[axis] - points[1][axis]), 0)) < 1e-9, "a foot");
}
const regular = shapeOf([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]]);
expect(near(regular.thickness, Math.sqrt(2 / 3) / 3) && near(regular.sphere.radius, Math.sqrt(3)), "the regular tetrahedron");

// Stars in charts: every simplex somewhere else, moved by an isometry of its own, comes back to where it was.
const rotated = (x) => {
  const axes = x.map((_, at) => x.map((__, other) => (at === other ? 1 : 0)));
  for (let turn = 0; turn < 3; ++turn) {
    const mirror = x.map(() => random() - 0.5), square = mirror.reduce((sum, own) => sum + own * own, 0);
    axes.forEach((axis, at) => {
      const share = 2 * axis.reduce((sum, own, place) => sum + own * mirror[place], 0) / square;
      axes[at] = axis.map((own, place) => own - share * mirror[place]);
    });
  }
  return (point) => axes.map((axis) => axis.reduce((sum, own, at) => sum + own * point[at], 0));
};
/** Neighbours around 0, and a vertex beyond each of its simplices: {places, simplices} by labels. */
function trueStar(m) {
  const places = new Map([[0, Array(m).fill(0)]]), simplices = [];
  const put = (point) => places.set(places.size, point) && places.size - 1;
  const ring = m === 2 ? [0, 1, 2, 3, 4, 5].map((step) => put([Math.cos(step + random() / 3), Math.sin(step + random() / 3)].map((own) => own * (0.1 + 0.05 * random()))))
    : [0, 1, 2].flatMap((axis) => [1, -1].map((sign) => put([0, 1, 2].map((own) => (own === axis ? sign * (0.1 + 0.03 * random()) : 0.03 * random())))));
  const links = m === 2 ? ring.map((own, at) => [own, ring[(at + 1) % 6]]) : [0, 1].flatMap((x) => [2, 3].flatMap((y) => [4, 5].map((z) => [ring[x], ring[y], ring[z]])));
  for (const link of links) {
    const middle = link.map((own) => places.get(own)).reduce((sum, point) => sum.map((own, axis) => own + point[axis]));
    simplices.push([0, ...link], [...link, put(middle.map((own) => own * (m === 2 ? 0.9 : 0.7)))]);
  }
  return { places, simplices };
}
function drawnStar({ places, simplices }, geometry, model, m) {
  const curvature = { flat: 0, spherical: 1, hyperbolic: -1, space: 0 }[geometry], coordinates = [], label = [];
  for (const simplex of simplices) {
    const turn = geometry === "space" ? (point) => point : rotated(Array(m).fill(0)), shift = Array.from({ length: m }, () => (geometry === "space" ? 0 : random() - 0.5));
    for (const own of simplex) {
      const point = moved(shift, turn(places.get(own)), curvature), square = point.reduce((sum, value) => sum + value * value, 0);
      if (geometry === "space") coordinates.push(0.6 * point[0], point[1], 0.8 * point[0]);
      else if (model === "unit" && curvature === 1) coordinates.push(...point.map((value) => 2 * value / (1 + square)), (1 - square) / (1 + square));
      else coordinates.push(...point, ...m === 2 ? [0] : []);
      label.push(own);
    }
  }
  return new Complex({ geometry, model, corners: m + 1, ambient_dimension: 3, projection: "", coordinates: Float64Array.from(coordinates), label, simplices: Uint32Array.from(label.keys()), measures: {}, bounds: {} });
}
const apart = (a, b) => Math.hypot(...a.map((own, axis) => own - b[axis]));
function expectStar(truth, complex, what) {
  const chart = starChart(complex, 0), found = new Map([...chart.points, ...[...chart.outer.values()].map((own) => [own.label, own.point])]);
  expectEqual([...found.keys()].sort((a, b) => a - b), [...truth.places.keys()], `${what}: the labels of the star and around it`);
  for (const [a, place] of truth.places) for (const [b, other] of truth.places)
    expect(near(apart(found.get(a), found.get(b)), apart(place, other), 1e-9), `${what}: the distance of labels ${a} and ${b}`);
  return chart;
}
for (const [geometry, model, m] of [["flat", "unit", 2], ["flat", "unit", 3], ["spherical", "stereographic", 2], ["spherical", "stereographic", 3], ["spherical", "unit", 2],
  ["hyperbolic", "conformal", 2], ["hyperbolic", "conformal", 3], ["space", "space", 2]]) {
  const truth = trueStar(m), what = `a star, ${geometry}, ${model}, ${m}`, complex = drawnStar(truth, geometry, model, m);
  const chart = expectStar(truth, complex, what), ball = ballOf(chart, complex.labels(0));
  const others = [...truth.places].filter(([own]) => !truth.simplices[0].includes(own));
  const true_ball = circumscribed(truth.simplices[0].map((own) => truth.places.get(own)));
  const [nearest] = others.sort(([, a], [, b]) => apart(a, true_ball.centre) - apart(b, true_ball.centre))[0];
  expect(near(ball.radius, true_ball.radius, 1e-7) && ball.nearest.label === nearest, `${what}: the ball, and what is nearest to it`);
  complex.drawing.coordinates[3 * (2 * truth.simplices[0].length - 1)] += 0.01;
  await expectNoticed(() => expectStar(truth, complex, what), "a vertex that is elsewhere");
}
expectEqual(starChart(drawnStar(trueStar(2), "flat", "unit", 2), 99), null, "a star of no label");

// Rules and pages of levels are those of the documents, every rule of a level is told.
const forgeries = readFileSync(join(project, "docs/forgeries.md"), "utf8");
const rules = new Set([...forgeries.matchAll(/^\| ([\w.-]+) \|/gm)].map(([, rule]) => rule).filter((rule) => rule.includes(".")));
const told = new Set(Object.values(levels).flatMap((level) => level.rules));
for (const rule of told) expect(rules.has(rule), `${rule} is a rule`);
for (const rule of rules) {
  const [level] = rule.split(".");
  if (level in levels) expect(levels[level].rules.includes(rule), `the page tells of ${rule}`);
}
for (const { page } of Object.values(levels)) expect(readFileSync(join(project, page), "utf8").length > 100, `${page} is there`);
expectEqual([...order].sort(), Object.keys(levels).sort(), "the order has all levels");
expectEqual(claimedLevels({ levels_claimed: { 0: {}, 6: {}, "2s": {}, "5i": {} } }).map(([level]) => level), ["0", "2s", "5i", "6"], "levels in their order");
for (const [place, colour] of [[0, [68, 1, 84]], [1, [253, 231, 37]], [0.5, [33, 144, 141]]]) expectEqual(colourAt(place), colour, `the colour at ${place}`);
finish();
