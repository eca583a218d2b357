// Exact numbers of certificates: integers, fractions, hexadecimal floats.

const form = /^(-?)(?:0x([0-9a-f]+)(?:\.([0-9a-f]+))?(?:p(-?[0-9]+))?|([0-9]+)(?:\/([0-9]+))?)$/;

/** A big quotient as a double, without overflow on the way. */
function quotient(numerator, denominator) {
  const excess = (number) => Math.max(0, number.toString(2).length - 1000);
  const up = excess(numerator), down = excess(denominator);
  return Number(numerator >> BigInt(up)) / Number(denominator >> BigInt(down)) * 2 ** (up - down);
}

/** The exact number as a double, approximately; NaN for any other text. */
export function approximate(text) {
  const parts = form.exec(text);
  if (!parts) return NaN;
  const [, sign, whole, after = "", exponent = "0", numerator, denominator = "1"] = parts;
  if (numerator !== undefined) {
    if (BigInt(denominator) === 0n) return NaN;
    return (sign ? -1 : 1) * quotient(BigInt(numerator), BigInt(denominator));
  }
  const shift = Number(exponent) - 4 * after.length;
  const mantissa = BigInt("0x" + whole + after);
  const length = mantissa.toString(2).length, cut = Math.max(0, length - 60);
  return (sign ? -1 : 1) * Number(mantissa >> BigInt(cut)) * 2 ** (shift + cut);
}
