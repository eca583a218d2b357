// The page of a witness: an instance on which a claim is refuted, with a drawing of its simplices and points.
import { copied, decimal, drawn, element, table } from "./elements.js";
import { foot, hullBasis, inHull, shapeOf } from "./plane.js";
import { TurnableDrawing } from "./turnable.js";

const inks = ["#1f4e79", "#b5371f", "#2d7d46", "#7a4fa3"];

/** The drawing of sets of points of one dimension, in their own hull where it has at most three dimensions. */
export class WitnessDrawing extends TurnableDrawing {
  constructor(sets) {
    super();
    this.sets = sets;
    const all = sets.flatMap((set) => set.points), basis = hullBasis(all);
    this.ambient = all[0].length;
    this.dimension = Math.min(basis.length, 3);
    const flat = inHull(all, basis).map((point) => [0, 1, 2].map((axis) => point[axis] ?? 0));
    this.projected = basis.length > 3;
    this.isFlat = sets.some((set) => set.kind === "simplex" && set.points.length - 1 > basis.length);
    let at = 0;
    this.places = sets.map((set) => set.points.map(() => flat[at++]));
    this.begin(flat, this.dimension, this.words());
  }

  words() {
    const parts = this.sets.map((set) => set.kind === "simplex" ? `the simplex ${set.name} with ${set.points.length} vertices` : `${set.points.length} points of ${set.name}`);
    return `A drawing of ${parts.join(", ")}, with circumscribed balls and least altitudes.${this.dimension === 3 ? " Arrow keys turn it." : ""}`;
  }

  draw() {
    const parts = [], { scale } = this;
    this.sets.forEach((set, at) => {
      const places = this.places[at], ink = inks[at % inks.length], pages = places.map((place) => this.onPage(place));
      if (set.kind === "simplex") {
        const { sphere } = shapeOf(places);
        if (sphere && places.length > 2) {
          const [x, y] = this.onPage(sphere.centre);
          parts.push(drawn("circle", { class: "ball", cx: x, cy: y, r: sphere.radius * scale, stroke: ink }), drawn("path", { class: "centre", d: `M${x - 4} ${y}h8M${x} ${y - 4}v8`, stroke: ink }));
        }
        if (places.length === 3) parts.push(drawn("path", { d: `M${pages.map((page) => page.join(" ")).join("L")}Z`, fill: ink, "fill-opacity": 0.12 }));
        for (let a = 0; a < pages.length; ++a)
          for (let b = a + 1; b < pages.length; ++b) parts.push(drawn("line", { class: "edge", x1: pages[a][0], y1: pages[a][1], x2: pages[b][0], y2: pages[b][1], stroke: ink }));
        if (places.length > 2) {
          const { altitudes } = shapeOf(places), least = altitudes.indexOf(Math.min(...altitudes));
          const [x, y] = this.onPage(foot(places, least));
          parts.push(drawn("line", { class: "altitude", x1: pages[least][0], y1: pages[least][1], x2: x, y2: y, stroke: ink }));
        }
      }
      const taken = [];
      pages.forEach(([x, y], vertex) => {
        parts.push(drawn("circle", { class: "vertex", cx: x, cy: y, r: 4, fill: ink }, drawn("title", {}, `${set.name} ${vertex}`)));
        if (set.points.length > 40) return;
        const crowd = taken.filter(([a, b]) => Math.hypot(a - x, b - y) < 14).length;
        taken.push([x, y]);
        parts.push(drawn("text", { class: "name", x: x + 7 + 14 * crowd, y: y - 7, fill: ink }, set.kind === "point" ? set.name : String(vertex)));
      });
    });
    this.svg.replaceChildren(...parts);
  }
}

function replayBanner(item) {
  const { replay } = item;
  if (!replay) return element("p", { class: "banner claimed" }, element("strong", {}, "Not decided anew."), " The claim stands as the file names it.");
  const refuted = replay.verdict === "refuted";
  return element("p", { class: `banner ${refuted ? "refutes" : replay.verdict === "proved" ? "verified" : "undecided"}` },
    element("strong", {}, refuted ? "It refutes the claim." : `On it the claim is ${replay.verdict}.`),
    ` Decided anew when this page was made, exactly: the hypotheses are ${replay.hypotheses}, the conclusion is ${replay.verdict}${replay.ratio ? `, ratio ${replay.ratio}` : ""}.`);
}

const hasText = (value) => typeof value === "string" ? value : JSON.stringify(value);

export function witnessPage(item) {
  const sets = item.sets ?? [];
  const byDimension = Map.groupBy ? Map.groupBy(sets, (set) => set.points[0].length) : sets.reduce((map, set) => map.set(set.points[0].length, [...map.get(set.points[0].length) ?? [], set]), new Map());
  const drawings = [...byDimension].sort(([a], [b]) => a - b).map(([, own]) => new WitnessDrawing(own));
  const rows = sets.filter((set) => set.kind === "simplex").map((set) => {
    const shape = shapeOf(set.points);
    return [set.name, `${set.points.length - 1} in ℝ${[...String(set.points[0].length)].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join("")}`, decimal(shape.longest, 6), decimal(shape.shortest, 6), decimal(Math.min(...shape.altitudes), 6),
      decimal(shape.thickness, 6), shape.sphere ? decimal(shape.sphere.radius, 6) : "none in doubles"];
  });
  const figures = drawings.length > 0 && element("div", { class: "drawings" }, drawings.map((own) => element("figure", {}, own.svg,
    element("figcaption", {}, own.projected ? `A projection from dimension ${own.ambient}: the three directions in which it is longest. ` : own.isFlat ? "True to scale, up to a rigid motion; to double precision a simplex of it is flat. " : "True to scale, up to a rigid motion. ",
      "Circles are circumscribed balls of simplices, a dashed line is the least altitude. ", own.dimension === 3 ? "Drag to turn. " : "", "Drawn in doubles, without error bounds."))));
  const numbers = element("div", { class: "numbers" },
    !figures && element("p", { class: "note" }, "There is nothing to draw in this witness: it is numbers."),
    rows.length > 0 && element("section", {}, element("h3", {}, "Its simplices"),
      table("Measured in doubles, without error bounds", ["Simplex", "Dimension", "Longest edge", "Shortest edge", "Least altitude", "Thickness", "Circumradius"], rows)),
    element("section", {}, element("h3", {}, "The instance, exactly"),
      element("dl", { class: "facts bindings" }, Object.entries(item.bindings).map(([name, value]) => [element("dt", {}, name),
        element("dd", {}, Object.entries(value).map(([kind, content]) => element("div", {}, `${kind} `, element("code", { class: "exact" }, hasText(content)))))]))));
  const root = element("article", { class: "witness" }, element("header", {},
    element("h2", {}, "Witness against ", element("bdi", { class: "name" }, item.title || item.claim)),
    element("dl", { class: "facts" }, [["claim", item.claim], ["conclusion", item.conclusion], ["twin", item.twin], ["class", item.instance], ["file", item.file], ["sha256", item.file_sha256]]
      .filter(([, text]) => text).map(([name, text]) => [element("dt", {}, name), element("dd", {}, element("bdi", {}, text))])),
    item.replay?.text && element("p", { class: "formula" }, element("code", {}, item.replay.text)),
    item.twin && element("p", { class: "note" }, "This is a twin: a claim that is false on purpose, to see that the attack would notice."),
    replayBanner(item),
    element("p", {}, copied(`delcert attack --replay ${item.file}`, "the command that decides it again"))),
  element("div", { class: figures ? "views" : null }, figures, numbers));
  return { root, drawings };
}
