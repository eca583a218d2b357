// The gallery of docs/gallery.md, a picture of every built-in manifold.
//
//   manifold_gallery.mjs pictures DELCERT MODULES CERTIFICATES [NAME…]   makes the pictures, of the certificates NAME.json in
//                                      CERTIFICATES; those that are not there are certified into it first. Then the page.
//   manifold_gallery.mjs page DELCERT  writes the page
//   manifold_gallery.mjs check DELCERT fails unless the page is the one that would be written, and has its pictures and no more
//
// The options of `delcert certify` are those of tests/receivers/*.tsv, counts and homology those of docs/export.md, which other
// tests hold to the programs.
import { execFileSync, spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = resolve(dirname(fileURLToPath(import.meta.url)), "../..");
const images = join(root, "docs/images/gallery"), file = join(root, "docs/gallery.md");
const columns = 3, width = 400, height = 320;

/** A picture in one colour has 770 bytes. */
const leastBytes = 1500;

// Built in, and not drawn.
const undrawn = {
  "torus-4": "Pictures are of dimension 1 to 3.",
  "sphere-3-stereographic": "It takes minutes to certify, and looks like sphere-3.",
};

const kinds = {
  flat: ["Tori and balls", "ℝᵐ/Λ and balls in ℝᵐ: what is drawn is the unit cell, or the ball."],
  "space form": ["Space forms", "Quotients of spheres, Euclidean and hyperbolic spaces ([space-forms.md](space-forms.md)): a fundamental domain, hyperbolic ones in Poincaré's disk " +
    "or ball, those of 𝕊³ in stereographic or azimuthal coordinates."],
  "metric field": ["Metric fields", "Riemannian metrics by formulas on a torus ([metric-fields.md](metric-fields.md)), in the coordinates of ℝᵐ/ℤᵐ."],
  submanifold: ["Zero sets", "Submanifolds of ℝᴺ by equations ([submanifolds.md](submanifolds.md)), in their first three coordinates."],
  atlas: ["Atlases by formulas", "Charts with transition functions by formulas ([atlases.md](atlases.md)): each simplex in a chart that shows it, charts side by side."],
};

/** What a built-in manifold is certified with: name → options. */
function optionsOf() {
  const lines = ["manifolds.tsv", "long_manifolds.tsv"].flatMap((name) => readFileSync(join(root, "tests/receivers", name), "utf8").trim().split("\n"));
  return new Map(lines.filter((line) => !line.startsWith("#")).map((line) => line.split("\t")));
}

/** Rows of the table of docs/export.md: name → columns. */
function measured() {
  const rows = readFileSync(join(root, "docs/export.md"), "utf8").split("\n").filter((line) => line.startsWith("| "));
  return new Map(rows.map((row) => row.slice(2, -2).split(" | ")).map(([name, ...rest]) => [name, rest]));
}

const list = (delcert) => JSON.parse(execFileSync(delcert, ["manifolds", "--json"], { encoding: "utf8" }));

function page(delcert) {
  const options = optionsOf(), rows = measured(), out = [
    "# Gallery", "",
    "A picture of every built-in manifold (`delcert manifolds`), of a certificate that `delcert certify --manifold NAME` makes with the options below it. The",
    "pictures of dimension 1 and 2 are those of [`delcert figure`](papers.md#figures), of dimension 3 those of [`delcert report`](report.md), where they can be",
    "turned and cut. All are of one copy of each simplex. Counts, Euler characteristic χ and first homology are those of the [table of exports](export.md#what-reads-them).", "",
    "After a change: `node tests/report/manifold_gallery.mjs pictures build/release/apps/delcert build/release/tests/report/front build/gallery`.", ""];
  for (const [kind, [title, about]] of Object.entries(kinds)) {
    const own = list(delcert).filter((one) => one.kind === kind);
    out.push(`## ${title}`, "", about, "", `|${" |".repeat(columns)}`, `|${"---|".repeat(columns)}`);
    for (let at = 0; at < own.length; at += columns) {
      const some = own.slice(at, at + columns), blank = Array(columns - some.length).fill("");
      const cells = (content) => out.push(`| ${[...some.map(content), ...blank].join(" | ")} |`);
      cells(({ name, about: text }) => existsSync(join(images, `${name}.webp`)) ? `![${text.replaceAll("|", "")}](images/gallery/${name}.webp)` : "");
      cells(({ name, dimension, about: text }) => {
        const [counts, , euler, homology] = rows.get(name) ?? [], [points, simplices] = counts?.split("/") ?? [];
        const words = ["", "edges", "triangles", "tetrahedra", "4-simplices"][dimension];
        const result = counts ? ` ${points} points, ${simplices} ${words}, χ = ${euler.replace("-", "−")}${homology === "–" ? "" : `, H₁ = ${homology}`}.` : "";
        const shown = options.get(name)?.replace(/^--manifold \S+ /, "");
        const reason = undrawn[name] ? ` (${undrawn[name]})` : "";
        return `**${name}**: ${text.replaceAll("|", "\\|")}.${result}${reason}${shown && !reason ? ` \`${shown}\`` : ""}`;
      });
    }
    out.push("");
  }
  return out.join("\n").trimEnd() + "\n";
}

async function pictures(delcert, modules, certificates, names) {
  const { Browser } = await import("./browser.mjs"), { webp } = await import("./webp.mjs");
  const options = optionsOf(), browser = await Browser.start(modules), wanted = list(delcert).filter(({ name }) => !undrawn[name] && (!names.length || names.includes(name)));
  for (const folder of [images, certificates]) mkdirSync(folder, { recursive: true });
  const run = (...words) => {
    const { status, stderr } = spawnSync(delcert, words, { encoding: "utf8", cwd: root });
    if (status !== 0) throw new Error(`delcert ${words.join(" ")}: exit status ${status}\n${stderr}`);
  };
  for (const { name, dimension } of wanted) {
    const certificate = resolve(certificates, `${name}.json`), at = (ending) => resolve(certificates, `${name}.${ending}`);
    if (!options.has(name)) throw new Error(`${name} is in neither list of tests/receivers`);
    if (!existsSync(certificate)) run("certify", ...options.get(name).split(" "), "--output", certificate);
    let page, png;
    if (dimension === 3) {
      run("report", certificate, "--no-check", "--output", at("html"));
      ({ page } = await browser.open(at("html")));
      await page.locator(".picture canvas[tabindex]").evaluate((canvas) => {
        Object.assign(canvas.style, { position: "fixed", left: 0, top: 0, width: "800px", height: "640px", border: 0, zIndex: 1, background: "#fff" });
      });
      await browser.drawn(page);
      png = await page.screenshot({ clip: { x: 0, y: 0, width: 800, height: 640 } });
    } else {
      run("figure", certificate, "--plain", "--output", at("svg"));
      page = await browser.context.newPage();
      await page.setViewportSize({ width: 800, height: 640 });
      const image = `data:image/svg+xml;base64,${readFileSync(at("svg")).toString("base64")}`;
      await page.setContent(`<style>body { margin: 0 } img { width: 100vw; height: 100vh; object-fit: contain }</style><img alt="" src="${image}">`);
      png = await page.screenshot({ timeout: 300000 });
    }
    writeFileSync(join(images, `${name}.webp`), await webp(browser, png, width, height));
    await page.close();
    console.log(name);
  }
  await browser.close();
}

function check(delcert) {
  const wrong = [], known = list(delcert).filter(({ name }) => !undrawn[name]).map(({ name }) => `${name}.webp`), found = readdirSync(images);
  for (const name of known) {
    if (!found.includes(name)) wrong.push(`docs/images/gallery has no ${name}`);
    else if (statSync(join(images, name)).size < leastBytes) wrong.push(`docs/images/gallery/${name} shows nothing`);
  }
  for (const name of found) if (!known.includes(name)) wrong.push(`docs/images/gallery/${name} is of no built-in manifold`);
  if (readFileSync(file, "utf8") !== page(delcert)) wrong.push("docs/gallery.md is not what manifold_gallery.mjs writes");
  for (const sentence of wrong) console.error(sentence);
  process.exitCode = wrong.length ? 1 : 0;
  if (!wrong.length) console.log(`the gallery has ${known.length} pictures`);
}

const [command, delcert, modules, certificates, ...names] = process.argv.slice(2);
if (command === "pictures") await pictures(resolve(delcert), modules, certificates, names);
if (command === "check") check(resolve(delcert));
else writeFileSync(file, page(resolve(delcert)));
