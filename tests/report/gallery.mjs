// What is looked at: cheap certificates of every kind of picture. `models`: among how many models a reader may choose;
// `inSpace`: a surface that is drawn in space.
export const gallery = [
  { name: "torus-2", certify: ["--manifold", "torus-2", "--radius", "1/24"] },
  { name: "sphere-2", certify: ["--manifold", "sphere-2", "--radius", "1/8"], inSpace: true },
  { name: "bolza-surface", certify: ["--manifold", "bolza-surface", "--radius", "1/8"], models: 2 },
  { name: "klein-bottle", certify: ["--manifold", "klein-bottle", "--radius", "1/24"] },
  { name: "torus-3", certify: ["--manifold", "torus-3", "--radius", "1/24"] },
  { name: "sphere-3", certify: ["--manifold", "sphere-3", "--radius", "11/50"], models: 2 },
  { name: "poincare-sphere", certify: ["--manifold", "poincare-sphere", "--radius", "1/32"], models: 3 },
  { name: "seifert-weber", certify: ["--complex", "EXAMPLES/complexes/seifert-weber.toml"], models: 2 },
  { name: "ellipsoid", certify: ["--manifold", "ellipsoid", "--radius", "1/10"], inSpace: true },
  { name: "disk", certify: ["--manifold", "disk", "--radius", "1/12"] },
];

/** Where there is no picture, and the rest of the page is as ever. */
export const withoutPicture = [
  { name: "circle", certify: ["--manifold", "circle", "--radius", "1/30"] },
];
