// What there is to say about one label: its point, its star with all measures, and where it stands among the worst.
import { approximate } from "./exact.js";
import { button, count, counted, decimal, element, labelled } from "./elements.js";
import { measures } from "./measures.js";
import { inverseStep } from "./models.js";
import { starFigure } from "./star_drawing.js";

/** The labels of the simplices with the worst values of a measure, the worst first: of each simplex its first label. */
function worstOf(drawing, name) {
  return drawing.worst?.[name] ?? [];
}

export class Inspector {
  constructor(header, complex, picture) {
    Object.assign(this, { header, complex, picture, at: -1 });
    this.input = element("input", { type: "number", min: 0, max: Math.max(0, complex.starts.length - 2), step: 1 });
    const names = Object.keys(complex.scales);
    const form = element("form", { onsubmit: (event) => {
      event.preventDefault();
      this.show(Number(this.input.value));
    } }, labelled("Label", this.input), element("button", { type: "submit" }, "Find"));
    const worst = names.length ? [
      button("Worst star", () => this.toWorst(0), { class: "worst", title: "The simplex with the least protection, or with the worst value of what is coloured" }),
      button("Next worst", () => this.toWorst(this.at + 1), { class: "next-worst" })] : [];
    this.only = element("input", { type: "checkbox", onchange: () => complex.setOnlyStar(this.only.checked) });
    this.body = element("div", { class: "label-data" });
    this.state = element("p", { class: "state", role: "status" });
    this.root = element("section", { class: "inspector" }, element("h3", {}, "Stars"),
      element("div", { class: "controls" }, form, worst, labelled("only this star", this.only)), this.state, this.body);
    complex.addEventListener("choice", () => this.fill());
    complex.addEventListener("look", () => {
      if (complex.measure !== this.measure) this.at = -1;
      // The worst are listed by what is coloured.
      if (complex.measure !== this.listed) this.fill();
    });
    this.fill();
  }

  show(label, simplex = null) {
    if (!this.complex.star(label).length) {
      this.state.textContent = `There is no star of a label ${label}; labels are 0 to ${count(this.complex.starts.length - 2)}.`;
      return;
    }
    this.state.textContent = "";
    this.complex.choose(label, simplex);
    this.picture?.focus();
  }

  toWorst(at) {
    const { complex } = this, name = complex.measure, list = worstOf(complex.drawing, name);
    if (!list.length) return;
    this.measure = name;
    this.at = at % list.length;
    const [simplex, value] = list[this.at];
    this.show(complex.labels(simplex)[0], simplex);
    this.state.textContent = `${this.at + 1} of the ${list.length} worst: ${measures[name].name.toLowerCase()} ${decimal(value, 6)}`;
  }

  fill() {
    const { complex, body } = this, { label, drawing } = complex;
    this.listed = complex.measure;
    if (label === null) {
      body.replaceChildren(...[element("p", {}, "Click at a simplex, search a label, or go to the worst star."), this.worstList(true)].filter(Boolean));
      return;
    }
    this.input.value = label;
    const star = complex.star(label), chosen = complex.simplex;
    const lifts = [...new Set(star.map((simplex) => drawing.lifts[drawing.lift[complex.vertexOf(simplex, label)]]))].filter((text) => text !== "");
    const exact = drawing.exact?.[label];
    const names = Object.keys(complex.scales);
    const neighbours = new Set(star.flatMap((simplex) => complex.labels(simplex)));
    body.replaceChildren(...[
      element("h4", {}, `Label ${count(label)}`),
      element("p", {}, `In ${counted(star.length, "simplex", "simplices")}${complex.size < complex.whole ? " of those on this page" : ""}, with ${counted(neighbours.size - 1, "neighbour", "neighbours")}`,
        lifts.some((lift) => !/^(1|0( 0)*)$/.test(lift)) ? `; drawn at ${lifts.length > 1 ? "the lifts" : "the lift"} ${lifts.join(" and ")}` : "", "."),
      exact && element("dl", { class: "coordinates" }, exact.map((text, axis) =>
        [element("dt", {}, drawing.exact_names[axis]), element("dd", {}, element("code", { class: "exact" }, text), element("span", { class: "decimal" }, ` ≈ ${decimal(approximate(text), 8)}`))])),
      !exact && element("p", { class: "note" }, "Its exact coordinates are in the certificate."),
      starFigure(complex, label, chosen),
      names.length > 0 && this.starTable(star, names, chosen),
      this.matching(chosen),
      this.worstList(),
    ].flat().filter(Boolean));
  }

  starTable(star, names, chosen) {
    const { complex } = this, order = [...star].sort((a, b) => complex.value(names[0], a) - complex.value(names[0], b));
    const worst = names.map((name) => {
      const values = star.map((simplex) => complex.value(name, simplex)).filter((value) => !Number.isNaN(value));
      return values.length ? (measures[name].worst === "least" ? Math.min(...values) : Math.max(...values)) : NaN;
    });
    const line = (head, values, attributes = {}) => element("tr", attributes, element("th", { scope: "row" }, head), values.map((value) => element("td", {}, value)));
    return element("div", { class: "scrolled", tabindex: "0", role: "region", "aria-label": "The simplices of the star" }, element("table", { class: "star" },
      element("caption", {}, "Its simplices, without error bounds, and what the certificate claims of all"),
      element("thead", {}, element("tr", {}, element("th", { scope: "col" }, "Simplex"), names.map((name) => element("th", { scope: "col" }, measures[name].name)))),
      element("tbody", {},
        line("worst of the star", worst.map((value) => decimal(value, 4)), { class: "sum" }),
        line("certified", names.map((name) => complex.drawing.bounds[name] === null || complex.drawing.bounds[name] === undefined ? "–"
          : `${measures[name].bound} ${decimal(complex.drawing.bounds[name], 4)}`), { class: "sum" }),
        order.map((simplex) => element("tr", { class: simplex === chosen ? "chosen" : null, "aria-current": simplex === chosen ? "true" : null },
          element("th", { scope: "row" }, button(complex.labels(simplex).join(" "), () => complex.choose(complex.label, simplex), { class: "link", "aria-label": `Choose the simplex ${complex.labels(simplex).join(" ")}` })),
          names.map((name) => element("td", {}, decimal(complex.value(name, simplex), 4))))))));
  }

  /** Where a side of the chosen simplex is on the boundary of the cell: to which side it is glued. */
  matching(simplex) {
    const { drawing } = this.complex;
    if (simplex === null || !drawing.matching_faces?.length) return null;
    const vertices = [...this.complex.vertices(simplex)];
    const text = (face) => face.map((vertex) => drawing.label[vertex]).join(" ");
    const own = (face) => face.every((vertex) => vertices.includes(vertex));
    return drawing.matching_faces.filter(([first, second]) => own(first) || own(second)).map(([first, second, step]) =>
      element("p", { class: "note" }, `Its side ${text(first)} is on the boundary of the cell, glued to the other side that is marked, by ${own(first) ? step : inverseStep(step)}.`));
  }

  worstList(open = false) {
    const { complex } = this, name = complex.measure, list = worstOf(complex.drawing, name);
    if (!list.length) return null;
    return element("details", open ? { open: "" } : {}, element("summary", {}, `The ${list.length} worst: ${measures[name].what}`),
      element("ol", {}, list.map(([simplex, value]) => element("li", {},
        button(complex.labels(simplex).join(" "), () => this.show(complex.labels(simplex)[0], simplex), { class: "link" }), ` ${decimal(value, 6)}`))));
  }
}
