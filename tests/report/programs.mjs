// The programs under test, and certificates made and altered with them.
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";

export class Programs {
  constructor(delcert, folder) {
    Object.assign(this, { delcert, folder });
  }

  /** Runs delcert in the folder: {status, output, errors}. */
  run(...words) {
    const { status, stdout, stderr } = spawnSync(this.delcert, words, { cwd: this.folder, encoding: "utf8", maxBuffer: 1 << 30 });
    return { status, output: stdout, errors: stderr };
  }

  /** The same; a status other than 0 is an error. */
  must(...words) {
    return execFileSync(this.delcert, words, { cwd: this.folder, encoding: "utf8", maxBuffer: 1 << 30 });
  }
}

/** Writes an altered copy of a plain certificate, with a seal that fits. */
export function forge(from, to, altered) {
  const text = readFileSync(from, "utf8"), body = altered(text.slice(0, text.lastIndexOf(',"sha256":"')));
  writeFileSync(to, `${body},"sha256":"${createHash("sha256").update(body).digest("hex")}"}\n`);
}

/** An exact number of a certificate as a double. Another way than the page's: by parts, in big integers throughout. */
export function value(text) {
  const sign = text.startsWith("-") ? -1 : 1, digits = text.replace(/^-/, "");
  if (digits.startsWith("0x")) {
    const [mantissa, exponent = "0"] = digits.slice(2).split("p");
    const [whole, after = ""] = mantissa.split(".");
    return sign * Number(BigInt(`0x${whole}${after}`)) * 2 ** (Number(exponent) - 4 * after.length);
  }
  const [numerator, denominator = "1"] = digits.split("/");
  return sign * Number((BigInt(numerator) << 200n) / BigInt(denominator)) / 2 ** 200;
}
