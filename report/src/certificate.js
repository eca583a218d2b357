// The page of one certificate.
import { Complex } from "./complex.js";
import { copied, count, decimal, element } from "./elements.js";
import { approximate } from "./exact.js";
import { exportsSection } from "./exports.js";
import { histogram } from "./histogram.js";
import { Inspector } from "./inspector.js";
import { ledgerSection } from "./ledger.js";
import { banner, homologySection, howChecked, levelsTable } from "./levels.js";
import { unpackedDrawing } from "./payload.js";
import { Picture } from "./picture.js";
import { claimedLevels } from "./statements.js";
import { levelVerdict, verdicts } from "./verdict.js";

function head(item) {
  const { header, check, simplices, file } = item;
  const { parameters } = header, radius = parameters.sampling_radius;
  const facts = [
    ["family", `${header.family}, dimension ${header.dimension}`],
    ["ε", [element("code", { class: "exact" }, radius), approximate(radius) ? element("span", { class: "decimal" }, ` ≈ ${decimal(approximate(radius), 6)}`) : null]],
    ["points", count(header.points)], ["simplices", count(simplices)], ["seed", parameters.seed],
    ["made by", `delcert ${header.software.delcert ?? ""}`],
  ];
  const claimed = claimedLevels(header).map(([level]) => level);
  return element("header", {}, element("h2", {}, element("bdi", { class: "name" }, header.manifold)),
    element("dl", { class: "facts" }, facts.map(([name, text]) => [element("dt", {}, name), element("dd", {}, text)])),
    banner(item),
    element("ul", { class: "chips", "aria-label": "Levels" }, claimed.map((level) => {
      const verdict = levelVerdict(check, level);
      return element("li", { class: `chip ${verdict}` }, `level ${level} `, element("span", { "aria-hidden": "true" }, verdicts[verdict].mark), element("span", { class: "spoken" }, verdicts[verdict].word));
    })),
    element("dl", { class: "facts sums" },
      element("dt", {}, "sha256 of the file"), element("dd", {}, copied(header.file_sha256, "the SHA-256 of the file")),
      element("dt", {}, "seal in the file"), element("dd", {}, copied(header.sha256, "the seal")),
      element("dt", {}, "file"), element("dd", {}, element("bdi", {}, file)),
      header.software.command ? [element("dt", {}, "made by the command"), element("dd", {}, copied(header.software.command, "the command that made it"))] : null),
    element("details", {}, element("summary", {}, "Parameters and software"),
      element("dl", { class: "facts" }, [...Object.entries(parameters), ...Object.entries(header.software)].map(([key, text]) => [element("dt", {}, key.replaceAll("_", " ")), element("dd", {}, element("code", { class: "exact" }, text))]))));
}

/** The page's element, with what tests ask for in `parts`. The picture is drawn once `parts.picture.start()` is called. */
export async function certificatePage(item, block) {
  const root = element("article", { class: "certificate" }, head(item)), parts = { root };
  if (item.drawing) {
    const drawing = await unpackedDrawing(item.drawing, block), complex = new Complex(drawing, item.simplices);
    parts.complex = complex;
    if (item.drawing.dimension === 2 || item.drawing.dimension === 3) parts.picture = new Picture(item.header, complex);
    parts.inspector = new Inspector(item.header, complex, parts.picture);
    const names = Object.keys(complex.scales);
    root.append(element("div", { class: "views" }, parts.picture?.root ?? element("p", { class: "note" }, `There is no picture in dimension ${item.drawing.dimension}.`), parts.inspector.root));
    for (const note of item.notes) root.append(element("p", { class: "note" }, note));
    if (complex.scales.protection?.low < 0) {
      root.append(element("p", { class: "note" }, "Where the protection is below 0 another point is in the circumscribed ball of the simplex: there the complex is not Delaunay."));
    }
    if (names.length) {
      const all = complex.size === item.simplices;
      root.append(element("section", {}, element("h3", {}, all ? "All simplices" : `The ${count(complex.size)} simplices of ${count(item.simplices)} that this page has`),
        element("p", { class: "note hint" }, "Drag over a histogram, or move its two sliders: the picture shows the simplices in between."),
        element("div", { class: "histograms" }, names.map((name) => histogram(complex, name)))));
    }
  } else {
    for (const note of item.notes) root.append(element("p", { class: "note" }, note));
  }
  root.append(levelsTable(item), ledgerSection(item) ?? "", homologySection(item) ?? "", howChecked(item), exportsSection(item));
  return parts;
}
