// pages_test.mjs DELCERT EXAMPLES MODULES FOLDER [NAME…]: pages of `delcert report` in Chromium, as their readers use them.
// MODULES has node_modules, FOLDER is where certificates and pages go. With names, those certificates of the gallery alone.
import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { Browser } from "./browser.mjs";
import { expect, expectEqual, expectNoticed, finish } from "./check.mjs";
import { gallery, withoutPicture } from "./gallery.mjs";
import { forge, Programs, value } from "./programs.mjs";

const [delcert, examples, modules, folder, ...names] = process.argv.slice(2);
rmSync(folder, { recursive: true, force: true });
mkdirSync(folder, { recursive: true });
const programs = new Programs(delcert, folder), browser = await Browser.start(modules);
const file = (name) => join(folder, name);

function certified({ name, certify }, ending = "json.zst") {
  // A certificate states the command by which it is made: a file of its own folder, so that no path is in it.
  const words = certify.map((word) => word.startsWith("EXAMPLES/") ? basename(word) : word);
  for (const word of certify) if (word.startsWith("EXAMPLES/")) copyFileSync(join(examples, word.slice("EXAMPLES/".length)), file(basename(word)));
  programs.must("certify", ...words, ...words[0] === "--manifold" ? ["--seed", "1"] : [], "--output", `${name}.${ending}`);
}

function expectQuiet({ requests, complaints }, name) {
  expectEqual(requests, [], `${name} asks for something`);
  expectEqual(complaints, [], `${name} complains`);
}

const text = (page, selector) => page.locator(selector).first().innerText();

/** The same four digits as the page shows of a number. */
const four = (number) => String(Number(number.toPrecision(4)));
const digits = (shown) => String(Number(shown.replace("\u2212", "-")));

/** Clicks into a simplex that is in front, clearly nearest to one of its vertices; returns the label of that one. */
async function clickAtALabel(page) {
  const { place, label } = await page.evaluate(() => {
    const { picture, complex } = window.delcertReport.pages[0], { scene, canvas } = picture;
    for (let trial = 0; ; ++trial) {
      const place = [Math.round(canvas.clientWidth / 2) + 7 * (trial % 6) - 20, Math.round(canvas.clientHeight / 2) + 7 * Math.floor(trial / 6) - 20];
      const simplex = scene.simplexAt(...place), steady = simplex >= 0 && [[2, 0], [-2, 0], [0, 2], [0, -2]].every(([x, y]) => scene.simplexAt(place[0] + x, place[1] + y) === simplex);
      if (!steady && trial < 36) continue;
      const distances = [...complex.vertices(simplex)].map((vertex) => {
        const [x, y] = scene.onCanvas(scene.point(vertex));
        return [Math.hypot(x - place[0], y - place[1]), complex.drawing.label[vertex]];
      }).sort((a, b) => a[0] - b[0]);
      if (distances[1][0] - distances[0][0] > 4 || trial >= 36) return { place, label: distances[0][1] };
    }
  });
  await page.locator(".picture canvas[tabindex]").click({ position: { x: place[0], y: place[1] } });
  await browser.drawn(page);
  return label;
}

/** Whether the second of them begins where the first ends, at the same height. */
async function isBeside(left, right) {
  const first = await left.boundingBox(), second = await right.boundingBox();
  return second.x >= first.x + first.width && second.y < first.y + first.height && first.y < second.y + second.height;
}

/** A label is picked in the picture, and searched: its star and the margins of `delcert info` are shown. */
async function expectPicking(page, name, info) {
  const label = await clickAtALabel(page), shown = await text(page, ".label-data h4");
  expectEqual(shown.replace(/\D/g, ""), String(label), `${name}: the label that was clicked at`);
  const neighbours = Number(/with\s+(\d+)/.exec(await text(page, ".label-data p"))[1]), chart = page.locator(".star-chart");
  expectEqual([await chart.locator(".vertex").count(), await chart.locator(".ball").count(), await chart.locator(".gap").count()], [neighbours, 1, 1], `${name}: the star in a chart, and the ball of the simplex`);
  expect(await isBeside(chart.locator("svg"), chart.locator("figcaption")), `${name}: what the star shows stands beside it`);
  expect(await page.locator(".inspector .scrolled").first().evaluate((box) => box.scrollWidth <= box.clientWidth), `${name}: all columns of the star are seen`);
  const star = page.locator(".star tbody tr");
  expect(await star.count() > 3, `${name}: the star of label ${label} is listed`);
  await page.locator(".inspector input[type=number]").fill(String(label));
  await page.locator(".inspector form button").click();
  expectEqual((await text(page, ".label-data h4")).replace(/\D/g, ""), String(label), `${name}: the label that was searched`);
  const one = info.levels_claimed["1"];
  if (!one) return;
  const heads = await page.locator(".star thead th").allInnerTexts(), bounds = await star.nth(1).locator("td").allInnerTexts();
  const epsilon = value(info.parameters.sampling_radius);
  for (const [head, margin] of [["Protection / ε", value(one.protection) / epsilon], ["Thickness", value(one.thickness)], ["Circumradius / ε", value(one.circumradius) / epsilon]]) {
    const bound = bounds[heads.indexOf(head) - 1];
    expectEqual(digits(bound.replace(/^at (least|most) /, "")), four(margin), `${name}: the margin of ${head} is that of info`);
  }
}

/** All margins of the levels table are those of `delcert info --json`, letter for letter. */
async function expectMargins(page, name, info) {
  for (const [level, margins] of Object.entries(info.levels_claimed)) {
    const shown = await page.locator(`tr[data-level="${level}"] .margin code`).allInnerTexts();
    expectEqual(shown, Object.values(margins), `${name}: margins of level ${level}`);
  }
}

/** The paper's constants are those that `delcert constants` prints; none where the paper has none. */
async function expectLedger(page, name, info) {
  const { separation, perturbation, radius_variation: variation, distortion } = info.parameters;
  const printed = programs.run("constants", "--dim", String(info.dimension), "--separation", separation, "--perturbation", perturbation,
    "--radius-variation", variation, "--distortion", distortion, "--json");
  const shown = await page.locator(".ledger tbody tr td:nth-of-type(2)").allTextContents();
  const constants = printed.status === 0 ? Object.values(JSON.parse(printed.output).constants) : [];
  expectEqual(shown, constants.map(({ exact }) => exact ?? ""), `${name}: the constants of the paper`);
}

/** The button for the worst star lands on the least protection, as `delcert export` measures it. */
async function expectWorst(page, name) {
  const drawing = JSON.parse(readFileSync(file(`${name}.drawing.json`), "utf8"));
  const corners = drawing.certificate.dimension + 1, { protection } = drawing.measures;
  const measured = protection.map((own, at) => [own, at]).filter(([own]) => own !== null);
  const [least] = measured.reduce((best, own) => own[0] < best[0] ? own : best);
  const labels = new Set(measured.filter(([own]) => own === least)
    .map(([, at]) => drawing.simplices.slice(corners * at, corners * (at + 1)).map((vertex) => drawing.vertices.label[vertex]).sort((a, b) => a - b).join(" ")));
  await page.locator("button.worst").click();
  await browser.drawn(page);
  const state = await text(page, ".inspector > .state");
  expectEqual(digits(state.split(" ").at(-1)), String(Number(least.toPrecision(6))), `${name}: the least protection`);
  const chosen = (await text(page, "tr.chosen th")).split(" ").map(Number).sort((a, b) => a - b).join(" ");
  expect(labels.has(chosen), `${name}: the worst star is at ${chosen}, not at ${[...labels].slice(0, 3)}`);
}

/** A surface in space is turned so that the star that is gone to is in the middle, with nothing in front of it. */
async function expectFacing(page, name) {
  const look = (turn) => page.evaluate((turn) => {
    const { picture, complex } = window.delcertReport.pages[0], { scene, canvas, camera } = picture;
    if (turn) camera.drag(turn, 0);
    return complex.star(complex.label).includes(scene.simplexAt(canvas.clientWidth / 2, canvas.clientHeight / 2));
  }, turn);
  expect(await look(0), `${name}: the worst star is seen in the middle`);
  await expectNoticed(async () => expect(await look(Math.PI / 3), "the star is seen"), `${name}: the star from behind`);
}

/** Each histogram counts every simplex, and a part of it that is marked filters the picture. */
async function expectHistograms(page, name, simplices) {
  const totals = await page.evaluate(() => [...document.querySelectorAll(".histogram")].map((figure) =>
    [...figure.querySelectorAll(".bar")].reduce((sum, bar) => sum + Number(bar.dataset.count), Number(figure.dataset.missing))));
  expect(totals.length >= 3, `${name}: there are histograms`);
  expectEqual(totals, totals.map(() => simplices), `${name}: every simplex is in each histogram, or not measured`);
  const slider = page.locator(".histogram input").first();
  await slider.fill("120");
  await browser.drawn(page);
  const kept = Number((await text(page, ".picture > .state")).split(" of ")[0].replace(/\D/g, ""));
  expect(kept > 0 && kept < simplices, `${name}: the filter keeps ${kept} of ${simplices} simplices`);
  await slider.fill("0");
}

/** Every colour and every model is a picture. */
async function expectPictures(page, name, models = 0) {
  const canvas = page.locator(".picture canvas[tabindex]"), controls = page.locator(".picture .controls");
  for (const measure of await controls.getByLabel("Colour").locator("option").all()) {
    await controls.getByLabel("Colour").selectOption(await measure.getAttribute("value"));
    await browser.drawn(page);
    const colours = await browser.colours(canvas), coloured = await measure.innerText();
    expect(colours >= 3, `${name}, ${coloured}: ${colours} colours`);
    expect((await text(page, ".inspector details summary")).endsWith(`worst: ${coloured.split(" ")[0].toLowerCase()}`), `${name}, ${coloured}: the worst of it are listed`);
  }
  const choice = controls.getByLabel("Model");
  expectEqual(await choice.count() ? await choice.locator("option").count() : 0, models, `${name}: models to choose among`);
  for (const model of models ? await choice.locator("option").all() : []) {
    await choice.selectOption(await model.getAttribute("value"));
    await browser.drawn(page);
    const colours = await browser.colours(canvas);
    expect(colours >= 3, `${name}, ${await model.innerText()}: ${colours} colours`);
  }
}

/** How many sheets a page takes in print. */
async function sheets(page) {
  const printed = await page.pdf({ preferCSSPageSize: true, printBackground: true });
  return (printed.toString("latin1").match(/\/Type\s*\/Page\b/g) ?? []).length;
}

async function expectKeyboard(page, name) {
  const canvas = page.locator(".picture canvas[tabindex]"), before = await canvas.screenshot();
  await canvas.focus();
  for (const key of ["ArrowRight", "ArrowUp", "+"]) await page.keyboard.press(key);
  await browser.drawn(page);
  expect(!before.equals(await canvas.screenshot()), `${name}: arrow keys turn or shift the picture`);
}

/** The commands that the page has for other programs work. */
async function expectExports(page, name) {
  const commands = await page.locator(".exports code").allInnerTexts();
  expect(commands.length >= 3, `${name}: exports`);
  for (const command of commands) {
    const [program, ...words] = command.split(" "), output = file(words[words.length - 1]);
    rmSync(output, { force: true });
    expectEqual([program, programs.run(...words).status, existsSync(output)], ["delcert", 0, true], `${name}: ${command}`);
  }
}

async function lookAt(own) {
  const { name } = own;
  certified(own);
  programs.must("export", `${name}.json.zst`, "--format", "json", "--output", `${name}.drawing.json`);
  programs.must("report", `${name}.json.zst`, "--output", `${name}.html`);
  const info = JSON.parse(programs.must("info", `${name}.json.zst`, "--json")), simplices = Number(info.levels_claimed["2"].simplices);
  const size = readFileSync(file(`${name}.html`)).length;
  expect(size <= 700000 + 9 * simplices, `${name}: ${size} bytes for ${simplices} simplices`);
  const opened = await browser.open(file(`${name}.html`)), { page } = opened;
  expect((await text(page, ".banner")).includes("Verified by delcert-check"), `${name}: verified`);
  await expectMargins(page, name, info);
  await expectExports(page, name);
  await expectLedger(page, name, info);
  await expectPicking(page, name, info);
  await expectWorst(page, name);
  if (own.inSpace) await expectFacing(page, name);
  expectEqual(await browser.obstacles(page), [], `${name}: axe-core`);
  await expectHistograms(page, name, simplices);
  await expectPictures(page, name, own.models);
  await expectKeyboard(page, name);
  expectEqual(await sheets(page), 1, `${name}: sheets of A4 in print`);
  expectQuiet(opened, name);
  console.log(`${name}: ${simplices} simplices, ${size} bytes`);
  await page.close();
}

async function lookWithoutPicture(own) {
  const { name } = own;
  certified(own);
  programs.must("report", `${name}.json.zst`, "--output", `${name}.html`);
  const opened = await browser.open(file(`${name}.html`));
  expect((await text(opened.page, ".banner")).includes("Verified"), `${name}: verified`);
  expect((await text(opened.page, "main")).includes("There is no picture in dimension 1."), `${name}: says that there is no picture`);
  expectQuiet(opened, name);
  await opened.page.close();
}

/** A certificate that claims more than is true is red, one that was not checked is grey. */
async function lookAtForgeries() {
  certified(gallery[0], "json");
  forge(file("torus-2.json"), file("forged.json"), (body) => body.replace(/"thickness":"[^"]*"/, '"thickness":"1/4"'));
  expectEqual(programs.run("report", "forged.json", "--output", "forged.html").status, 1, "a forged certificate: status");
  const red = await browser.open(file("forged.html"));
  expect((await text(red.page, ".banner.rejected")).includes("1.thickness"), "a forged certificate: the rule in the red banner");
  expectEqual(await red.page.locator(".chip.rejected").allTextContents(), ["level 1 ✗rejected"], "a forged certificate: one red level");
  expectEqual(await red.page.locator(".banner.verified").count(), 0, "a forged certificate: nothing green above");
  expectEqual(await browser.obstacles(red.page), [], "a forged certificate: axe-core");
  expectQuiet(red, "a forged certificate");
  await red.page.close();

  programs.must("report", "--no-check", "forged.json", "--output", "unchecked.html");
  const grey = await browser.open(file("unchecked.html"));
  expectEqual(await grey.page.locator(".banner.rejected, .banner.verified, .chip.verified").count(), 0, "not checked: neither red nor green");
  expect((await text(grey.page, ".banner.claimed")).includes("Not checked"), "not checked: said so");
  await grey.page.close();

  writeFileSync(file("broken-seal.json"), readFileSync(file("torus-2.json"), "utf8").replace('"seed":"1"', '"seed":"2"'));
  const status = programs.run("report", "broken-seal.json", "--output", "broken-seal.html").status;
  expect(status === 3 || status === 1, `a broken seal: status ${status}`);
  programs.must("report", "--no-check", "broken-seal.json", "--output", "broken-unchecked.html");
  const noticed = await browser.open(file("broken-unchecked.html"));
  expect((await text(noticed.page, ".banner.malformed")).includes("seal"), "a broken seal that is not checked: red banner");
  await noticed.page.close();
  const broken = await browser.open(file("broken-seal.html"));
  expectEqual(await broken.page.locator(".banner.rejected, .banner.malformed").count(), 1, "a broken seal: red banner");
  await broken.page.close();
}

async function lookAtHostileNames() {
  const hostile = '</script><script>document.title="owned"</script><img src=x onerror=alert(1)>\u202Egnp.exe\u0007 ' + "x".repeat(10000);
  forge(file("torus-2.json"), file("hostile.json"), (body) => body.replace('"name":"torus-2"', () => `"name":${JSON.stringify(hostile)}`));
  programs.run("report", "hostile.json", "--output", "hostile.html");
  const opened = await browser.open(file("hostile.html")), { page } = opened;
  const shown = await page.locator("h2").evaluate((head) => head.textContent);
  expect(shown.includes('</script><script>document.title="owned"</script><img src=x onerror=alert(1)>\\u202Egnp.exe\\u0007'), `a hostile name is text: ${shown.slice(0, 120)}`);
  expect(shown.length > 10000, "a long name is whole");
  expect(!(await page.title()).includes("owned</") && (await page.title()).length < 120, "a hostile name does not get into the title as more than text");
  expectEqual(await page.locator("img").count(), 0, "a hostile name is no element");
  const [wide, window] = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.clientWidth]);
  expect(wide <= window, `a long name fits: ${wide} of ${window} pixels`);
  expectQuiet(opened, "a hostile name");
  await page.close();
}

/** Several files, one of them a witness, with a table of contents. */
async function lookAtWitnesses() {
  const witness = join(examples, "../proofs/claims/witnesses/faces-of-thick-simplices.sharper-twin.json");
  programs.must("report", "torus-2.json.zst", "bolza-surface.json.zst", witness, "--output", "several.html");
  const opened = await browser.open(file("several.html")), { page } = opened;
  expectEqual(await page.locator("nav li").count(), 3, "several: contents");
  await page.locator("nav button").nth(1).click();
  await browser.drawn(page);
  expectEqual(await text(page, "h2"), "bolza-surface", "several: the second page");
  expect(await browser.colours(page.locator(".picture canvas[tabindex]")) >= 3, "several: its picture");
  await page.locator("nav button").nth(2).click();
  expect((await text(page, ".banner")).includes("It refutes the claim"), "a witness: refuted anew");
  const drawing = page.locator(".drawings svg").first();
  expectEqual([await drawing.locator(".edge").count(), await drawing.locator(".vertex").count(), await drawing.locator(".ball").count()], [6, 4, 1], "a witness: a tetrahedron with its ball");
  expect(await browser.colours(drawing) >= 3, "a witness: drawn");
  expect(await isBeside(page.locator(".drawings"), page.locator(".numbers")), "a witness: its numbers stand beside its drawing");
  const cells = await page.locator("article table tbody td").allInnerTexts();
  // The points (0,0,0), (−1/2,1/2,1/2), (1/2,1/2,1/2), (0,0,1): edges √3/2 and 1.
  expectEqual(cells.slice(1, 3), ["1", "0.866025"], "a witness: longest and shortest edge");
  expect((await text(page, ".bindings")).includes("-1/2"), "a witness: exact coordinates");
  expectEqual(await browser.obstacles(page), [], "a witness: axe-core");
  expectQuiet(opened, "several");
  await page.close();
  const direct = await browser.open(file("several.html"), "#2");
  expectEqual(await text(direct.page, "h2"), "bolza-surface", "several: a link to the second page");
  await direct.page.close();
}

/** What an attack printed: a page for each refutation. */
async function lookAtAttacks() {
  const attack = programs.run("attack", join(examples, "claims/circumradius-below-edge.toml"), "--samples", "200", "--shape", "2,2", "--seed", "1", "--json");
  expectEqual(attack.status, 1, "an attack that refutes");
  writeFileSync(file("attack.json"), attack.output);
  programs.must("report", "attack.json", "--output", "attack.html");
  const opened = await browser.open(file("attack.html")), { page } = opened;
  expectEqual([await page.locator(".drawings .edge").count(), await page.locator(".drawings .altitude").count()], [3, 1], "an attack: a triangle with its least altitude");
  const exact = JSON.parse(attack.output).refutations[0].witness.bindings.s.simplex.points.flat();
  const shown = await text(page, ".bindings");
  for (const number of exact) expect(shown.includes(`"${number}"`), `an attack: the exact coordinate ${number}`);
  expectQuiet(opened, "an attack");
  await page.close();
}

/** What these tests must notice. */
async function lookAtTwins() {
  const page = readFileSync(file("torus-2.html"), "utf8");
  const open = /<meta http-equiv="Content-Security-Policy"[^>]*>/;
  writeFileSync(file("asking.html"), page.replace(open, "").replace("<main>", '<img src="http://127.0.0.1:9/x.png" alt=""><main>'));
  await expectNoticed(async () => expectQuiet(await browser.open(file("asking.html")), "asking"), "a page that asks a server");
  writeFileSync(file("injected.html"), page.replace("<main>", '<script>window.injected = 1;</script><main>'));
  const injected = await browser.open(file("injected.html"));
  expectEqual(await injected.page.evaluate(() => window.injected ?? null), null, "the policy of the page stops a script that is not its own");
  await expectNoticed(() => expectQuiet(injected, "injected"), "a script that was stopped");
  const blank = await browser.open(file("torus-2.html"));
  await blank.page.evaluate(() => { const { scene } = window.delcertReport.pages[0].picture; scene.triangles.size = scene.lines.size = 0; scene.fill = () => {}; scene.draw(); });
  await expectNoticed(async () => expect(await browser.colours(blank.page.locator(".picture canvas[tabindex]")) >= 3, "colours"), "a blank picture");
  await blank.page.evaluate(() => document.querySelector(".bar").remove());
  await expectNoticed(() => expectHistograms(blank.page, "torus-2", 798), "a histogram without one of its classes");
  await blank.page.evaluate(() => { for (const label of document.querySelectorAll("label")) label.remove(); });
  await expectNoticed(async () => expectEqual(await browser.obstacles(blank.page), [], "axe"), "controls without labels");
  // Another 40 lines do not fit on the sheet.
  await blank.page.evaluate(() => { for (let line = 0; line < 40; ++line) document.querySelector(".checked").append(document.createElement("p"), "more"); });
  await expectNoticed(async () => expectEqual(await sheets(blank.page), 1, "sheets"), "a page that prints on two sheets");
  await expectNoticed(() => expectMargins(blank.page, "torus-2", { levels_claimed: { 1: { protection: "1/2" } } }), "another margin");
}

for (const own of gallery) if (!names.length || names.includes(own.name)) await lookAt(own);
if (names.length && !names.includes("rest")) {
  await browser.close();
  finish();
}
for (const own of withoutPicture) await lookWithoutPicture(own);
await lookAtForgeries();
await lookAtHostileNames();
await lookAtWitnesses();
await lookAtAttacks();
await lookAtTwins();
await browser.close();
finish();
