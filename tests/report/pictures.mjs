// pictures.mjs MODULES PAGES IMAGES: the pictures of docs/images, from pages that pages_test.mjs left in PAGES.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { Browser } from "./browser.mjs";

const [modules, pages, images] = process.argv.slice(2), browser = await Browser.start(modules);
const width = 1000, height = 735;
const views = {
  "seifert-weber": async () => {},
  "bolza-surface": async (page) => {
    await page.locator("button.worst").click();
    await page.getByRole("button", { name: "Reset" }).click();
  },
  "torus-3": async (page) => {
    await page.getByLabel("Cut").selectOption("0");
    await page.getByLabel("Size of simplices").fill("80");
  },
};
for (const [name, arrange] of Object.entries(views)) {
  const { page } = await browser.open(join(pages, `${name}.html`));
  await arrange(page);
  await browser.drawn(page);
  const screenshot = (await page.screenshot()).toString("base64");
  const picture = await browser.blank.evaluate(async ([text, width, height]) => {
    const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes]), { resizeWidth: width, resizeHeight: height, resizeQuality: "high" });
    const canvas = new OffscreenCanvas(width, height);
    canvas.getContext("2d").drawImage(image, 0, 0);
    const blob = await canvas.convertToBlob({ type: "image/webp", quality: 0.82 });
    return String.fromCharCode(...new Uint8Array(await blob.arrayBuffer()));
  }, [screenshot, width, height]);
  writeFileSync(join(images, `report-${name}.webp`), Buffer.from(picture, "latin1"));
  await page.close();
}
await browser.close();
