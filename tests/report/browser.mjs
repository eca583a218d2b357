// Pages in Chromium, offline, with a record of what they ask for and complain about.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

/** Opens pages; `modules` is the folder with node_modules. */
export class Browser {
  static async start(modules) {
    const require = createRequire(resolve(modules, "package.json"));
    const result = new Browser();
    result.axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
    result.browser = await require("playwright-core").chromium.launch({
      executablePath: process.env.DELCERT_CHROMIUM ?? "/usr/bin/chromium",
      // Pictures are drawn by the processor: there need not be any other. It puts pages together quicker without playing the
      // graphics card for that, too.
      args: ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-gpu-compositing", "--no-sandbox"],
    });
    result.context = await result.browser.newContext({ viewport: { width: 1360, height: 1000 }, offline: true });
    result.blank = await result.context.newPage();
    return result;
  }

  async close() {
    await this.browser.close();
  }

  /** A page from a file, once it is drawn: {page, requests, complaints}, the latter two growing lists. */
  async open(file, hash = "") {
    const page = await this.context.newPage(), requests = [], complaints = [];
    page.setDefaultTimeout(60000);
    const own = pathToFileURL(file).href;
    page.on("request", (request) => { if (request.url().split("#")[0] !== own) requests.push(request.url()); });
    page.on("console", (message) => { if (message.type() === "error") complaints.push(message.text()); });
    page.on("pageerror", (error) => complaints.push(String(error)));
    await page.goto(own + hash);
    await page.evaluate(() => window.delcertReport?.ready.catch(() => {}));
    await this.drawn(page);
    return { page, requests, complaints };
  }

  /** After what is pending has been drawn. */
  drawn(page) {
    return page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done()))));
  }

  /** How many colours a screenshot has, in steps of 16 of each of red, green and blue; at least 20 pixels of each. */
  async colours(target) {
    const picture = (await target.screenshot()).toString("base64");
    return this.blank.evaluate(async (text) => {
      const bytes = Uint8Array.from(atob(text), (sign) => sign.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const context = new OffscreenCanvas(image.width, image.height).getContext("2d");
      context.drawImage(image, 0, 0);
      const { data } = context.getImageData(0, 0, image.width, image.height), found = new Map();
      for (let at = 0; at < data.length; at += 4) {
        const key = (data[at] >> 4) << 8 | (data[at + 1] >> 4) << 4 | data[at + 2] >> 4;
        found.set(key, (found.get(key) ?? 0) + 1);
      }
      return [...found.values()].filter((pixels) => pixels >= 20).length;
    }, picture);
  }

  /** What axe-core finds that is serious or worse: rules and the elements. */
  async obstacles(page) {
    await page.evaluate(this.axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    return violations.filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(" | ")}`);
  }
}
