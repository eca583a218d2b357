// How long a reader waits for the picture of a report: node bench/first_frame.mjs FILE.html [TURNS]
//
// Opens the page in Chromium, without a network and with pictures drawn by the processor, as ./test does, each time in a new
// tab. Prints the milliseconds from the request of the page to the frame in which the first picture is drawn, and those of one more frame
// of the same picture, turned. The folder of Node.js modules is that of the tests (ctest --preset release -R report.packages makes it).
import { resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { Browser } from "../tests/report/browser.mjs";

const root = resolve(fileURLToPath(import.meta.url), "../..");
const [file, turns = "5"] = process.argv.slice(2);
if (!file || !(Number(turns) >= 1)) {
  console.error("usage: node bench/first_frame.mjs FILE.html [TURNS]");
  process.exit(64);
}

const median = (figures) => [...figures].sort((a, b) => a - b)[Math.floor(figures.length / 2)];
const rounded = (figures) => figures.map((figure) => figure.toFixed(figure < 10 ? 1 : 0)).join(", ");

const browser = await Browser.start(resolve(root, "build/release/tests/report/front"));
const first = [], further = [];
try {
  for (let turn = 0; turn < Number(turns); ++turn) {
    const start = performance.now();
    const { page } = await browser.open(resolve(file));
    // Reading a pixel waits until the picture is drawn.
    await page.evaluate(() => {
      const { scene } = window.delcertReport.pages.find(Boolean).picture ?? {};
      scene?.gl.readPixels(0, 0, 1, 1, scene.gl.RGBA, scene.gl.UNSIGNED_BYTE, new Uint8Array(4));
    });
    first.push(performance.now() - start);
    further.push(await page.evaluate(() => {
      const { scene } = window.delcertReport.pages.find(Boolean).picture ?? {};
      if (!scene) return 0;
      const begin = performance.now(), frames = 20;
      for (let frame = 0; frame < frames; ++frame) {
        scene.draw();
        scene.gl.readPixels(0, 0, 1, 1, scene.gl.RGBA, scene.gl.UNSIGNED_BYTE, new Uint8Array(4));
      }
      return (performance.now() - begin) / frames;
    }));
    await page.close();
  }
} finally {
  await browser.close();
}
console.log(`first frame ${median(first).toFixed(0)} ms (${rounded(first)}); a further frame ${median(further).toFixed(1)} ms (${rounded(further)})`);
