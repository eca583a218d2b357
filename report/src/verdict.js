// What delcert-check said of a certificate, in the words of this page.

export const verdicts = {
  verified: { mark: "✓", word: "verified" },
  rejected: { mark: "✗", word: "rejected" },
  undecided: { mark: "?", word: "undecided" },
  malformed: { mark: "✗", word: "malformed" },
  claimed: { mark: "·", word: "as claimed, not checked" },
};

/** The key of `verdicts` for the whole certificate. */
export function verdictOf(check) {
  return check ? (check.result.status in verdicts ? check.result.status : "undecided") : "claimed";
}

/** And for a level: "claimed" where the checker has not looked at it, or what it rests on failed. */
export function levelVerdict(check, level) {
  const found = check?.result.levels.find((own) => own.level === level);
  if (!found) return "claimed";
  return { verified: "verified", passed: "verified", REJECTED: "rejected" }[found.state] ?? "undecided";
}

/** What the checker found wrong, [{rule, what}]. */
export function findingsOf(check) {
  if (!check) return [];
  const { malformed, levels } = check.result;
  return [...(malformed ? [malformed] : []), ...levels.flatMap((level) =>
    level.findings.length || level.state !== "undecided" ? level.findings : [{ rule: `level ${level.level}`, what: level.summary }])];
}

export function secondsOf(check) {
  return check.result.levels.reduce((sum, level) => sum + level.seconds, 0);
}
