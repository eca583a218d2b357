// Expectations that are counted: all of them are looked at, whatever failed before.
let passed = 0;
const failures = [];

export function expect(holds, what) {
  if (holds) ++passed;
  else {
    failures.push(what);
    console.log(`FAILED: ${what}`);
  }
}

export function expectEqual(found, expected, what) {
  const [a, b] = [JSON.stringify(found), JSON.stringify(expected)];
  expect(a === b, `${what}: ${a?.slice(0, 300)} instead of ${b?.slice(0, 300)}`);
}

/** Runs the expectations of a part, none of which may hold: what the test is there for must be noticed. */
export async function expectNoticed(part, what) {
  const before = [passed, failures.length];
  const log = console.log;
  console.log = () => {};
  try {
    await part();
  } finally {
    console.log = log;
  }
  const noticed = failures.length > before[1];
  failures.length = before[1];
  passed = before[0];
  expect(noticed, `what must fail passes: ${what}`);
}

/** Ends the program with the status that the expectations deserve. */
export function finish() {
  console.log(`${passed} expectations met, ${failures.length} not`);
  process.exit(failures.length > 0 || passed === 0 ? 1 : 0);
}
