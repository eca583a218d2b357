// Writes page.js and page.css, which `delcert report` puts into every page: `npm ci --ignore-scripts && npm run build`.
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";
import { buildSync } from "esbuild";

const folder = dirname(fileURLToPath(import.meta.url));
for (const [source, bundle] of [["src/main.js", "page.js"], ["src/page.css", "page.css"]]) {
  buildSync({
    absWorkingDir: folder,
    entryPoints: [source],
    outfile: bundle,
    bundle: true,
    minify: true,
    format: "iife",
    // As old as what the page needs of browsers: DecompressionStream.
    target: ["chrome103", "firefox113", "safari16.4"],
    charset: "utf8",
    legalComments: "none",
    banner: source.endsWith(".js")
      ? { js: "// The page of delcert's reports. GPL-3.0-or-later; its sources are report/src. It contains no other program's code." }
      : {},
  });
}
