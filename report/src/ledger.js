// The paper's constants for the parameters of a certificate, beside what it certifies.
import { decimal, element, table } from "./elements.js";
import { approximate } from "./exact.js";
import { levelVerdict } from "./verdict.js";

const words = (key) => key.replaceAll("_", " ");

/** A positive number as a power of 2. */
const asPower = (number) => `2^${decimal(Math.log2(number), 4)}`;

/** Null if the paper does not treat these parameters. */
export function ledgerSection({ header, check, ledger }) {
  if (!ledger) return null;
  const { protection } = ledger, one = header.levels_claimed["1"];
  const certified = one ? approximate(one.protection) / approximate(header.parameters.sampling_radius) : NaN;
  const state = levelVerdict(check, "1") === "verified" ? "verified" : "claimed";
  return element("section", { class: "paper" }, element("h3", {}, "Beside the paper"),
    element("p", {}, `For these parameters, and where its hypotheses hold, the paper guarantees a protection of at least 2^${decimal(Number(protection.log2_lower), 5)} ε. `,
      one && certified > 0 ? `Of this complex ${asPower(certified)} ε is ${state}, that is ${decimal(certified, 4)} ε.` : "This certificate claims none."),
    element("details", { class: "ledger" }, element("summary", {}, "All constants of the paper for these parameters"),
      table("As delcert constants prints them", ["Constant", "", "Exactly", "About", "log₂ about", "Label in the paper"],
        Object.entries(ledger).map(([key, { symbol, exact, lower, log2_lower: power, source }]) =>
          [words(key), symbol, element("code", { class: "exact" }, exact), lower, power === undefined ? "" : decimal(Number(power), 6), source]))));
}
