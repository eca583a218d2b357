// Colours of measures: viridis, which the colour-blind and grey printers tell apart as well (CC0, by S. van der Walt and N. Smith).
const stops = [[68, 1, 84], [71, 44, 122], [59, 81, 139], [44, 113, 142], [33, 144, 141], [39, 173, 129], [92, 200, 99], [170, 220, 50], [253, 231, 37]];

/** The colour at `place` in [0, 1], as three numbers up to 255. */
export function colourAt(place) {
  const at = Math.min(Math.max(place, 0), 1) * (stops.length - 1), below = Math.min(Math.floor(at), stops.length - 2);
  return stops[below].map((value, part) => Math.round(value + (stops[below + 1][part] - value) * (at - below)));
}

/** 256 colours, four bytes each. */
export function colourTable() {
  const result = new Uint8Array(4 * 256);
  for (let at = 0; at < 256; ++at) result.set([...colourAt(at / 255), 255], 4 * at);
  return result;
}
