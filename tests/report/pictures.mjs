// pictures.mjs MODULES PAGES IMAGES: the pictures of docs/images, from pages that pages_test.mjs left in PAGES.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { Browser } from "./browser.mjs";
import { webp } from "./webp.mjs";

const [modules, pages, images] = process.argv.slice(2), browser = await Browser.start(modules);
const width = 1000;
/** How much of a page to show, in its pixels: the view with its legend, and no line of text beside it that is cut. */
const wholeLines = (page) => page.evaluate(() => {
  const lines = [], texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), range = document.createRange();
  while (texts.nextNode()) {
    range.selectNodeContents(texts.currentNode);
    lines.push(...range.getClientRects());
  }
  lines.push(...[...document.querySelectorAll("button, input, select, tr, .star-chart")].map((element) => element.getBoundingClientRect()));
  let height = document.querySelector(".legend, footer").getBoundingClientRect().bottom + 6;
  for (const { top, bottom, width } of lines.sort((a, b) => a.top - b.top)) if (width > 0 && top < height - 1 && bottom > height) height = bottom;
  return Math.ceil(height) + 1;
});
const worst = async (page) => {
  await page.locator("button.worst").click();
  await page.getByRole("button", { name: "Reset" }).click();
};
// All of the surface from where the star is seen.
const worstInSpace = async (page) => {
  await page.locator("button.worst").click();
  await page.locator(".picture canvas[tabindex]").focus();
  for (let step = 0; step < 6; ++step) await page.keyboard.press("-");
  await page.evaluate(() => document.activeElement.blur());
};
const views = {
  "torus-2": worst,
  "sphere-2": worstInSpace,
  "bolza-surface": worst,
  "klein-bottle": worst,
  "torus-3": async (page) => {
    await page.getByLabel("Cut").selectOption("0");
    await page.getByLabel("Size of simplices").fill("80");
  },
  "sphere-3": worst,
  "poincare-sphere": async () => {},
  // Its protection is negative: this complex is no Delaunay complex, and does not claim to be one.
  "seifert-weber": async (page) => void await page.getByLabel("Colour").selectOption("thickness"),
  // The third of several: a witness.
  "several": async () => {},
};
for (const [name, arrange] of Object.entries(views)) {
  const { page } = await browser.open(join(pages, `${name}.html`), name === "several" ? "#3" : "");
  await arrange(page);
  await page.evaluate(() => scrollTo(0, 0));
  await browser.drawn(page);
  const clip = { x: 0, y: 0, width: page.viewportSize().width, height: await wholeLines(page) };
  const png = await page.screenshot({ clip, fullPage: true }), height = Math.round(clip.height * width / clip.width);
  writeFileSync(join(images, `report-${name === "several" ? "witness" : name}.webp`), await webp(browser, png, width, height));
  await page.close();
}
await browser.close();
