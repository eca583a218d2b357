// The levels table, homology, and how all of it was checked.
import { copied, count, decimal, element, shellWord, table } from "./elements.js";
import { approximate } from "./exact.js";
import { claimedLevels, levels, order } from "./statements.js";
import { findingsOf, levelVerdict, secondsOf, verdictOf, verdicts } from "./verdict.js";

/** "Z^4 + Z/2" as it is written on paper. */
function groupText(group) {
  return group.replaceAll("Z", "ℤ").replace(/\^(\d+)/g, (_, digits) => [...digits].map((digit) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[digit]).join("")).replaceAll(" + ", " ⊕ ");
}

const words = (key) => key.replaceAll("_", " ");

/** A margin as the certificate has it, with its decimal value where it is a number that is not a whole one. */
function margin(key, text) {
  const pieces = text.split(", "), numbers = pieces.map(approximate);
  const inexact = numbers.length > 0 && numbers.every((number) => !Number.isNaN(number)) && pieces.some((piece) => !/^-?\d{1,15}$/.test(piece));
  return element("div", { class: "margin", "data-margin": key }, element("span", { class: "name" }, words(key)), " ", element("code", { class: "exact" }, text),
    inexact && element("span", { class: "decimal" }, ` ≈ ${numbers.map((number) => decimal(number, 6)).join(", ")}`));
}

export function levelsTable(item) {
  const { header, check } = item;
  const rows = claimedLevels(header).map(([level, margins]) => {
    const known = levels[level] ?? { says: "A level that this page does not know.", rules: [], page: "" };
    const found = check?.result.levels.find((own) => own.level === level), verdict = levelVerdict(check, level);
    return element("tr", { class: verdict, "data-level": level }, element("th", { scope: "row" }, level),
      element("td", {}, element("span", { class: `mark ${verdict}` }, verdicts[verdict].mark), ` ${verdicts[verdict].word}`),
      element("td", {}, known.says, known.page && element("div", { class: "note" }, known.page)),
      element("td", {}, Object.entries(margins).map(([key, text]) => margin(key, text))),
      element("td", {}, found && element("div", {}, found.summary || found.findings.map((finding) => `${finding.rule}: ${finding.what}`).join("; ")),
        found && element("div", { class: "note" }, found.seconds < 0.001 ? "less than 0.001 s" : `${decimal(found.seconds, 3)} s`),
        element("details", {}, element("summary", {}, "rules"), element("span", { class: "rules" }, known.rules.join(", ")))));
  });
  return element("section", { class: "levels" }, element("h3", {}, "Levels"),
    table("Every level that the certificate claims, with its margins as they stand there", ["Level", "Verdict", "It says", "Margins", "What the checker computed"], rows));
}

export function homologySection(item) {
  const { header, check } = item, two = header.levels_claimed["2"], manifold = check?.result.manifold;
  if (!two) return null;
  const facts = [];
  if (two.homology) two.homology.split(", ").forEach((group, at) => facts.push([`H${"₀₁₂₃₄"[at] ?? at}`, groupText(group)]));
  facts.push(["Euler characteristic", two.euler_characteristic.replace("-", "\u2212")]);
  if (two.closed) facts.push(["closed", two.closed === "true" ? "yes" : "no"]);
  const checked = levelVerdict(check, "2");
  const derived = [["orientability", manifold?.orientability], ["first homology of the group", manifold?.first_homology && groupText(manifold.first_homology)], ["size", manifold?.size]].filter(([, text]) => text);
  return element("section", { class: "topology" }, element("h3", {}, "Topology"),
    element("p", {}, checked === "verified" ? "Stated by the certificate, and verified with level 2:" : "As the certificate states it; not verified here:"),
    element("dl", { class: "facts homology" }, facts.map(([name, text]) => [element("dt", {}, name), element("dd", {}, text)])),
    derived.length > 0 && element("p", {}, "Found by the checker itself:"),
    derived.length > 0 && element("dl", { class: "facts" }, derived.map(([name, text]) => [element("dt", {}, name), element("dd", {}, text)])));
}

export function howChecked(item) {
  const { header, check, file } = item, parts = [];
  if (check) {
    const { decisions, unchecked } = check.result;
    parts.push(element("p", {}, `${check.checker} read the file ${file} on ${check.date} and ended with “${check.result.status}” (exit status ${check.result.exit}) after ${decimal(secondsOf(check), 3)} s. ` +
      `It decided ${count(decisions.intervals)} comparisons by intervals of doubles, ${count(decisions.rationals)} by rationals and ${count(decisions.balls)} by balls.`));
    if (unchecked.length) parts.push(element("p", {}, `Claimed but not looked at: levels ${unchecked.join(", ")}.`));
  } else {
    parts.push(element("p", {}, "The checker was not run when this page was made. Everything here is as the certificate claims it."));
  }
  const missing = order.filter((level) => !(level in header.levels_claimed));
  return element("section", { class: "checked" }, element("h3", {}, "How this was checked"), parts,
    element("p", {}, "delcert-check shares no code with the program that made the certificate. Trust rests on it, on the compiler, on the processor's directed rounding, and on GMP and FLINT (with Arb). The proofs that its rules suffice are read by people."),
    element("h4", {}, "Check it again"),
    element("p", {}, copied(`sha256sum ${shellWord(file)}`, "the command for the checksum"), check && element("span", {}, ` must print ${header.file_sha256}`)),
    element("p", {}, copied(`delcert-check ${shellWord(file)}`, "the command that checks the certificate")),
    element("h4", {}, "What is not claimed"),
    element("ul", {},
      missing.length > 0 && element("li", {}, `Levels ${missing.join(", ")}: `, element("details", {}, element("summary", {}, "what they would say"),
        element("dl", { class: "facts" }, missing.map((level) => [element("dt", {}, level), element("dd", {}, levels[level].says)])))),
      element("li", {}, "The name of the manifold, the seed, the kind of candidates and the software versions are words of the certificate that nothing verifies."),
      element("li", {}, "The picture, its coordinates, and all measures in histograms and star tables are computed in doubles, without error bounds. Only margins of verified levels are proved.")),
    check && element("details", { class: "raw" }, element("summary", {}, "The checker's answer, as JSON"), element("pre", { tabindex: "0" }, preformatted(check.result))));
}

function preformatted(value) {
  return JSON.stringify(value, null, 1).split("\n").map((line, at) => [at ? document.createTextNode("\n") : null, line]);
}

/** What the whole page says first of a certificate: a red, amber, green or grey line. */
export function banner(item) {
  const { check, seal_fits: sealFits } = item, verdict = verdictOf(check);
  if (!check && !sealFits) return element("p", { class: "banner malformed", role: "alert" }, element("strong", {}, `${verdicts.malformed.mark} The seal does not fit:`), " the file was changed after it was written. Nothing else was checked.");
  if (verdict === "verified") return element("p", { class: "banner verified" }, element("strong", {}, `${verdicts.verified.mark} Verified`), ` by ${check.checker} in ${decimal(secondsOf(check), 3)} s, on ${check.date}.`);
  if (verdict === "claimed") return element("p", { class: "banner claimed" }, element("strong", {}, "Not checked."), " Everything on this page is as the certificate claims it.");
  const says = { rejected: "REJECTED: the checker found this certificate to be wrong.", malformed: "MALFORMED: the checker cannot read this certificate.", undecided: "UNDECIDED: the checker could not decide all that is claimed." }[verdict];
  return element("div", { class: `banner ${verdict}`, role: "alert" }, element("strong", {}, `${verdicts[verdict].mark} ${says}`),
    element("ul", {}, findingsOf(check).map((finding) => element("li", {}, element("code", {}, finding.rule), `: ${finding.what}`))));
}
