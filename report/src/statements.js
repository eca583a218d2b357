// The levels of a certificate: what each says, the rules that the checker tests, the page that has statement and proof.
// Rules stand in docs/certificate-format.md; those of which a family knows nothing are not tested on it.

/** The levels in the order of the format: objects do not keep it, where keys look like numbers. */
export const order = ["0", "1", "1f", "2", "2s", "3", "4", "5", "5i", "6"];

/** The levels of a certificate in their order, unknown ones last: [level, its margins]. */
export function claimedLevels(header) {
  const place = (level) => order.includes(level) ? order.indexOf(level) : order.length;
  return Object.entries(header.levels_claimed).sort(([a], [b]) => place(a) - place(b));
}

export const levels = {
  "0": { says: "The input is a net with the separation and density that it claims, and its points were moved no farther than allowed.",
    rules: ["0.ball", "0.cycle", "0.degree", "0.density", "0.distortion", "0.hypotheses-2", "0.metric-distortion", "0.patch", "0.perturbation", "0.radii", "0.separation"],
    page: "docs/levels/0-input.md" },
  "1": { says: "Each star is the star in the Delaunay complex of the points that its chart sees, protected and thick with these bounds.",
    rules: ["1.facets", "1.patch", "1.perturbation", "1.protection", "1.radius", "1.thickness", "1.vertices"], page: "docs/levels/1-stars.md" },
  "1f": { says: "Each star is full: its simplices fill a neighbourhood of their common vertex. They need not be Delaunay.",
    rules: ["1f.facets", "1f.ray", "1f.sides"], page: "docs/levels/submanifolds.md" },
  "2": { says: "The stars agree and make up a manifold.", rules: ["2.count", "2.homology", "core.facets", "core.stars", "core.connected"], page: "docs/levels/2-manifold.md" },
  "2s": { says: "The stars are the same in all charts concerned.", rules: ["2s.patch", "2s.protection", "2s.reach"], page: "docs/levels/2s-stable-stars.md" },
  "3": { says: "There is no forbidden configuration.", rules: ["3.configuration", "3.flake-parameter"], page: "docs/levels/3-forbidden-configurations.md" },
  "4": { says: "The complex is the Delaunay complex of the points in the manifold.",
    rules: ["4.ball", "4.clear", "4.cover", "4.density", "4.edge", "4.empty", "4.patch", "4.stability"], page: "docs/levels/4-delaunay.md" },
  "5": { says: "The complex triangulates the manifold.",
    rules: ["5.blend", "5.clear", "5.components", "5.contract", "5.fibre", "5.radius", "5.thickness"], page: "docs/levels/5-triangulation.md" },
  "5i": { says: "The straight simplices are embedded, and ambient isotopic to the manifold.", rules: ["5i.apart", "5i.normal", "5i.star"], page: "docs/levels/submanifolds.md" },
  "6": { says: "The piecewise flat metric of the complex is near that of the manifold, with these bounds; on surfaces, where claimed, it is Delaunay itself.",
    rules: ["6.bilipschitz", "6.normal", "6.self-delaunay", "core.hinges"], page: "docs/levels/6-metric.md" },
};
