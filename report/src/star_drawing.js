// A star in a chart of its label, with the ball of the chosen simplex and the vertex that comes nearest to it.
import { count, decimal, drawn, element } from "./elements.js";
import { circumscribed } from "./plane.js";
import { starChart } from "./star_chart.js";
import { TurnableDrawing } from "./turnable.js";

const inSpace = (point) => [0, 1, 2].map((axis) => point[axis] ?? 0);

/** The ball of a simplex of the chart, and of all other vertices that are drawn the nearest: {centre, radius, nearest, gap}. */
export function ballOf({ points, outer }, labels) {
  const sphere = circumscribed(labels.map((label) => points.get(label)));
  if (!sphere) return null;
  let nearest = null, gap = Infinity;
  const others = [...points, ...[...outer.values()].map(({ label, point }) => [label, point])];
  for (const [label, point] of others) {
    const own = Math.hypot(...point.map((value, axis) => value - sphere.centre[axis])) - sphere.radius;
    if (!labels.includes(label) && own < gap) [nearest, gap] = [{ label, point }, own];
  }
  return { ...sphere, nearest, gap };
}

class StarDrawing extends TurnableDrawing {
  constructor(complex, chart, label, chosen) {
    super();
    Object.assign(this, { complex, chart, label, chosen });
    this.ball = chart.round && chosen !== null ? ballOf(chart, complex.labels(chosen)) : null;
    const outer = [...chart.outer.values()].map(({ point }) => inSpace(point)), own = [...chart.points.values()].map(inSpace);
    const words = `The star of label ${label} in a chart of it${this.ball ? `, with the circumscribed ball of the simplex ${complex.labels(chosen).join(" ")}` : ""}.`;
    this.begin([...own, ...outer], complex.corners - 1, words + (complex.corners === 4 ? " Arrow keys turn it." : ""));
  }

  draw() {
    const { complex, chart, label, chosen, ball } = this, parts = [];
    const page = (point) => this.onPage(inSpace(point)), line = (name, a, b) => parts.push(drawn("line", { class: name, x1: a[0], y1: a[1], x2: b[0], y2: b[1] }));
    const places = new Map([...chart.points].map(([own, point]) => [own, page(point)]));
    const drawnEdges = new Set(), chosenLabels = chosen === null ? [] : complex.labels(chosen);
    if (chosenLabels.length === 3) parts.push(drawn("path", { class: "chosen-face", d: `M${chosenLabels.map((own) => places.get(own).join(" ")).join("L")}Z` }));
    for (const simplex of complex.star(label)) {
      const labels = complex.labels(simplex).sort((a, b) => a - b);
      labels.forEach((a, at) => labels.slice(at + 1).forEach((b) => {
        if (drawnEdges.has(`${a} ${b}`)) return;
        drawnEdges.add(`${a} ${b}`);
        line(chosenLabels.includes(a) && chosenLabels.includes(b) ? "edge chosen-edge" : a === label || b === label ? "edge" : "edge rim", places.get(a), places.get(b));
      }));
    }
    for (const { label: own, point } of chart.outer.values()) {
      const [x, y] = page(point);
      parts.push(drawn("circle", { class: "outer", cx: x, cy: y, r: 2.5 }, drawn("title", {}, `label ${own}`)));
    }
    if (ball) {
      const [x, y] = page(ball.centre);
      parts.push(drawn("circle", { class: "ball", cx: x, cy: y, r: ball.radius * this.scale }));
      if (ball.nearest) {
        const { centre, radius, nearest } = ball, away = nearest.point.map((value, axis) => value - centre[axis]), length = Math.hypot(...away);
        line("gap", page(away.map((value, axis) => centre[axis] + value * radius / length)), page(nearest.point));
        const [a, b] = page(nearest.point);
        parts.push(drawn("circle", { class: "nearest", cx: a, cy: b, r: 4.5 }, drawn("title", {}, `label ${nearest.label}`)));
      }
    }
    for (const [own, [x, y]] of places)
      parts.push(drawn("circle", { class: own === label ? "centre-vertex" : "vertex", cx: x, cy: y, r: own === label ? 5 : 3 }, drawn("title", {}, `label ${own}`)));
    for (const [own, [x, y]] of places) {
      if (complex.corners === 3 || chosenLabels.includes(own)) parts.push(drawn("text", { class: "name", x: x + 6, y: y - 6 }, String(own)));
    }
    this.svg.replaceChildren(...parts);
  }
}

/** A figure of the star, with what it shows; null where there is no chart to draw it in. */
export function starFigure(complex, label, chosen) {
  const chart = starChart(complex, label);
  if (!chart) return null;
  const drawing = new StarDrawing(complex, chart, label, chosen), { ball } = drawing;
  const protection = chosen === null ? NaN : complex.value("protection", chosen);
  const said = ball ? [`The circle is the circumscribed ball of the chosen simplex`, ball.nearest ? `; label ${count(ball.nearest.label)} comes nearest to it` : "",
    Number.isNaN(protection) ? "" : `, protection ${decimal(protection, 4)} ε`, ". "] : chart.round && chosen === null ? ["Choose a simplex to see its circumscribed ball. "] : [];
  return element("figure", { class: "star-chart" }, drawing.svg, element("figcaption", {}, "The star in a chart of its label, with the vertices beyond it. ", said, complex.corners === 4 ? "Drag to turn. " : "", "Drawn in doubles."));
}
