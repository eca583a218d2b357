// Puts the page together from the data in it. Nothing is asked of any other place.
import { certificatePage } from "./certificate.js";
import { button, element, visible } from "./elements.js";
import { verdictOf, verdicts } from "./verdict.js";
import { witnessPage } from "./witness.js";

const data = JSON.parse(document.getElementById("delcert-data").textContent);
const main = document.querySelector("main");
const made = new Map();

/** What tests look at: `pages` are filled as they are opened, `ready` once the first is drawn. */
window.delcertReport = { pages: [], ready: null };

function titleOf(item) {
  return item.kind === "witness" ? `${item.claim}: ${item.conclusion}` : item.header.manifold;
}

async function open(at) {
  const item = data.items[at];
  if (!made.has(at)) {
    const block = document.getElementById(`delcert-block-${at}`)?.textContent.trim();
    made.set(at, item.kind === "witness" ? witnessPage(item) : await certificatePage(item, block));
  }
  const parts = made.get(at);
  main.replaceChildren(parts.root);
  document.title = `${visible(titleOf(item)).slice(0, 80)} – delcert report`;
  window.delcertReport.pages[at] = parts;
  if (parts.picture && !parts.picture.camera) parts.picture.start();
  parts.picture?.scene?.draw();
  document.querySelectorAll("nav button").forEach((tab, own) => own === at ? tab.setAttribute("aria-current", "page") : tab.removeAttribute("aria-current"));
  if (data.items.length > 1) history.replaceState(null, "", `#${at + 1}`);
}

function contents() {
  return element("nav", { "aria-label": "Contents" }, element("ol", {}, data.items.map((item, at) => {
    const verdict = item.kind === "witness" ? null : verdictOf(item.check);
    return element("li", {}, button(titleOf(item), () => open(at), { class: verdict ?? "witness" }),
      verdict && element("span", { class: `mark ${verdict}`, title: verdicts[verdict].word }, verdicts[verdict].mark, element("span", { class: "spoken" }, verdicts[verdict].word)));
  })));
}

async function start() {
  document.querySelector("footer").append(`Written by delcert ${data.version}. This page asks nothing of any network.`);
  if (data.items.length > 1) main.before(contents());
  const asked = Number(location.hash.slice(1)) - 1;
  await open(Number.isInteger(asked) && data.items[asked] ? asked : 0);
}

window.delcertReport.ready = start().catch((reason) => {
  main.replaceChildren(element("p", { class: "banner rejected", role: "alert" }, `This page could not be shown: ${reason.message}`));
  throw reason;
});
