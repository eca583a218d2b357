// How often a measure takes which value, with the certified bound as a line. A part of it that is marked filters the picture.
import { colourAt } from "./colours.js";
import { button, count, decimal, drawn, element, slider } from "./elements.js";
import { measures } from "./measures.js";

const width = 420, height = 132, floor = 104, left = 8, right = 412, classes = 48;

export function histogram(complex, name) {
  const scale = complex.scales[name], values = complex.drawing.measures[name], bound = complex.drawing.bounds[name];
  const counts = new Array(classes).fill(0);
  let missing = 0;
  for (const value of values) {
    if (Number.isNaN(value)) ++missing;
    else ++counts[Math.min(classes - 1, Math.floor(scale.place(value) * classes))];
  }
  const most = Math.max(1, ...counts), x = (place) => left + (right - left) * place;
  const bars = counts.map((number, at) => drawn("rect", {
    class: "bar", "data-count": number, x: x(at / classes) + 0.4, width: (right - left) / classes - 0.8,
    y: floor - 92 * number / most, height: 92 * number / most, fill: `rgb(${colourAt((at + 0.5) / classes).join(" ")})`,
  }, drawn("title", {}, `${count(number)} from ${scale.text(at / classes)} to ${scale.text((at + 1) / classes)}`)));
  const mark = drawn("rect", { class: "mark", y: 4, height: floor - 4, x: left, width: 0 });
  const { what } = measures[name];
  const certified = bound === null || bound === undefined ? "" : `; certified ${measures[name].bound} ${decimal(bound, 4)}`;
  const total = values.length - missing;
  const line = certified && drawn("g", { class: "bound" },
    drawn("line", { x1: x(scale.place(bound)), x2: x(scale.place(bound)), y1: 2, y2: floor + 5 }),
    drawn("text", { x: x(scale.place(bound)), y: floor + 26, "text-anchor": scale.place(bound) > 0.5 ? "end" : "start" }, `certified ${decimal(bound, 4)}`));
  const drawing = drawn("svg", { viewBox: `0 0 ${width} ${height}`, role: "img",
    "aria-label": `Histogram of ${what}: ${count(total)} simplices from ${scale.text(0)} to ${scale.text(1)}${certified}` },
  drawn("line", { class: "axis", x1: left, x2: right, y1: floor, y2: floor }),
  bars, mark, line,
  [0, 0.5, 1].map((place) => drawn("text", { class: "tick", x: x(place), y: floor + 13, "text-anchor": place === 0 ? "start" : place === 1 ? "end" : "middle" }, scale.text(place))));

  const steps = 200, state = element("span", { class: "state", role: "status" });
  const set = (first, last) => {
    from.control.value = Math.min(first, last);
    to.control.value = Math.max(first, last);
    const [low, high] = [Number(from.control.value), Number(to.control.value)], whole = low <= 0 && high >= steps;
    mark.setAttribute("x", x(low / steps));
    mark.setAttribute("width", whole ? 0 : Math.max(1, (right - left) * (high - low) / steps));
    state.textContent = whole ? "" : `${scale.text(low / steps)} to ${scale.text(high / steps)}`;
    complex.setRange(name, whole ? null : [low <= 0 ? -Infinity : scale.value(low / steps), high >= steps ? Infinity : scale.value(high / steps)]);
  };
  const moved = () => set(Number(from.control.value), Number(to.control.value));
  const from = slider("from", { min: 0, max: steps, value: 0, "aria-label": `Least ${what} shown` }, moved);
  const to = slider("to", { min: 0, max: steps, value: steps, "aria-label": `Greatest ${what} shown` }, moved);

  let begun = null;
  const at = (event) => {
    const box = drawing.getBoundingClientRect();
    const place = ((event.clientX - box.left) / box.width * width - left) / (right - left);
    return Math.round(Math.min(Math.max(place, 0), 1) * steps);
  };
  drawing.addEventListener("pointerdown", (event) => {
    drawing.setPointerCapture(event.pointerId);
    begun = at(event);
  });
  drawing.addEventListener("pointermove", (event) => { if (begun !== null) set(begun, at(event)); });
  drawing.addEventListener("pointerup", (event) => {
    if (begun !== null && Math.abs(at(event) - begun) < 2) set(0, steps);
    begun = null;
  });
  return element("figure", { class: "histogram", "data-measure": name, "data-missing": missing },
    element("figcaption", {}, element("strong", {}, measures[name].name),
      ` of ${count(total)} simplices${missing ? `, ${count(missing)} not measured` : ""}${scale.byRatios ? ", logarithmic" : ""}`),
    drawing,
    element("div", { class: "controls" }, from.labelled, to.labelled, button("All", () => set(0, steps), { "aria-label": `Show all ${what}` }), state));
}
