// The commands that write the complex for other programs.
import { copied, element, shellWord } from "./elements.js";

// Of each format the dimensions that it holds, and who reads it.
const formats = [["vtu", 1, 3, "ParaView, VTK, meshio"], ["off", 2, 2, "CGAL, MeshLab"], ["regina", 2, 4, "Regina"], ["simplex-tree", 1, 4, "GUDHI"]];

export function exportsSection({ header, file }) {
  const stem = file.replace(/([.]json)?([.]zst)?$/, "");
  return element("section", { class: "exports" }, element("h3", {}, "For other programs"),
    element("dl", { class: "facts sums" }, formats.filter(([, least, most]) => least <= header.dimension && header.dimension <= most).map(([format, , , readers]) =>
      [element("dt", {}, readers), element("dd", {}, copied(`delcert export ${shellWord(file)} --format ${format} --output ${shellWord(`${stem}.${format}`)}`, `the command that exports for ${readers}`))])));
}
