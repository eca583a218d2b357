// Elements of the page. Text always enters as text: nothing that stands in a certificate is ever read as HTML.

// What moves the cursor, turns the direction of writing around or cannot be seen stands there as \u and its number.
const unseen = /[\p{Cc}\p{Cf}\p{Zl}\p{Zp}\p{Co}\p{Cs}\u{115F}\u{1160}\u{3164}\u{FFA0}]/gu;

/** A text out of a file as it may be shown: one line, everything in it visible. */
export function visible(text) {
  return String(text).replace(unseen, (sign) => "\\u" + sign.codePointAt(0).toString(16).toUpperCase().padStart(4, "0"));
}

function filled(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === undefined || value === false) continue;
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  for (const child of children.flat(3)) {
    if (child !== null && child !== undefined && child !== false) element.append(child instanceof Node ? child : visible(child));
  }
  return element;
}

/** An HTML element: `on…` attributes are listeners, children are elements or texts. */
export function element(tag, attributes = {}, ...children) {
  return filled(document.createElement(tag), attributes, children);
}

/** An element of a drawing (SVG). */
export function drawn(tag, attributes = {}, ...children) {
  return filled(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

let identifiers = 0;
/** An identifier that nothing else on the page has. */
export function identifier(stem) {
  return `${stem}-${++identifiers}`;
}

/** A control with its visible label before it. */
export function labelled(text, control) {
  control.id ||= identifier("control");
  return element("span", { class: "labelled" }, element("label", { for: control.id }, text), control);
}

export function choice(text, options, onchange) {
  const control = element("select", { onchange: () => onchange(control.value) },
    options.map(([value, name]) => element("option", { value }, name)));
  return { control, labelled: labelled(text, control) };
}

export function slider(text, attributes, oninput) {
  const control = element("input", { type: "range", ...attributes, oninput: () => oninput(Number(control.value)) });
  return { control, labelled: labelled(text, control) };
}

export function button(text, onclick, attributes = {}) {
  return element("button", { type: "button", onclick, ...attributes }, text);
}

/** A button that copies a text and says that it has; without a clipboard it marks the text for copying by hand. */
export function copied(text, what) {
  const code = element("code", { class: "copied" }, text);
  const result = element("span", { class: "state", role: "status" });
  const copy = button("Copy", async () => {
    try {
      await navigator.clipboard.writeText(text);
      result.textContent = "copied";
    } catch {
      getSelection().selectAllChildren(code);
      result.textContent = "marked: press Ctrl+C";
    }
  }, { "aria-label": `Copy ${what}` });
  return element("span", { class: "copy" }, code, copy, result);
}

/** A file name as one word for a shell. */
export function shellWord(text) {
  return /^[\w@%+=:,./][\w@%+=:,./-]*$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`;
}

export function table(caption, heads, rows) {
  return element("div", { class: "scrolled", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {}, element("caption", {}, caption),
      element("thead", {}, element("tr", {}, heads.map((head) => element("th", { scope: "col" }, head)))),
      element("tbody", {}, rows.map((cells) => cells instanceof Node ? cells
        : element("tr", {}, cells.map((cell, at) => element(at === 0 ? "th" : "td", at === 0 ? { scope: "row" } : {}, cell)))))));
}

/** 12345 as 12 345, with a thin space. */
export function count(number) {
  return String(number).replace(/\B(?=(\d{3})+(?!\d))/g, "\u2009");
}

/** A count with its noun: 1 simplex, 2 simplices. */
export function counted(number, one, many) {
  return `${count(number)}\u00a0${number === 1 ? one : many}`;
}

/** A double with `digits` significant digits. */
export function decimal(number, digits = 4) {
  if (number === null || number === undefined || Number.isNaN(number)) return "–";
  const text = Number(number).toPrecision(digits);
  const [mantissa, exponent] = text.split("e");
  const short = mantissa.includes(".") ? mantissa.replace(/\.?0+$/, "") : mantissa;
  return (exponent === undefined ? short : `${short}e${exponent}`).replace("-", "\u2212");
}
