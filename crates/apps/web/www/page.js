// Small tools for elements. Texts are never markup.
export const $ = (id) => document.getElementById(id);

export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key === "data") Object.assign(made.dataset, value);
    else if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

// The fields with text that was typed and not yet taken: an answer must not overwrite them.
export const typing = new WeakSet();
addEventListener("input", ({ target }) => typing.add(target), true);
for (const done of ["change", "focusout"]) addEventListener(done, ({ target }) => typing.delete(target), true);

// Gives a field its value, unless somebody types there.
export function put(field, value) {
  if (!typing.has(field) && field.value !== value) field.value = value;
}

// A picture of the desk, with a text that says what it shows. Values that come with it are shown
// under the pointer by `readings`.
export function picture(figure, svg, label) {
  const made = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  made.setAttribute("role", "img");
  made.setAttribute("aria-label", label);
  for (const reading of made.querySelectorAll(".reading")) {
    const title = reading.querySelector("title");
    reading.dataset.reading = title.textContent;
    title.remove();
  }
  figure.tabIndex = 0;
  figure.setAttribute("aria-label", label);
  figure.replaceChildren(document.adoptNode(made));
  figure.dataset.svg = svg;
}

// A picture that is no longer that of the scene goes, and its place says why.
export function noPicture(figure, why = "") {
  figure.removeAttribute("tabindex");
  delete figure.dataset.svg;
  figure.replaceChildren(...(why ? [element("p", { className: "none" }, why)] : []));
}

export function readings(figure, output) {
  figure.addEventListener("pointerover", ({ target }) => {
    const reading = target.closest?.(".reading")?.dataset.reading;
    if (reading) output.replaceChildren(...reading.split("\n").map((line) => element("span", {}, line)));
  });
  figure.addEventListener("pointerleave", () => output.replaceChildren());
}

// A text in parts, with w_c as people read it.
export const lowered = (text) => text.split(/(?<![\p{L}\w])(\p{L}_\w+)/u).map((part, k) =>
  (k % 2 === 1 ? element("span", {}, part[0], element("sub", {}, part.slice(2))) : part));

// A cell with a number as shown, and with all digits.
export function cell(value, model) {
  if (value.digits === undefined) return element("td", { className: "none", title: value.shown }, "–");
  const { lower, upper } = value;
  const title = lower === undefined ? value.digits : `${value.digits}, from ${lower} to ${upper}`;
  return element("td", { data: numbers(value, model), title }, value.shown);
}

// A value with all digits, its bound and its interval, as attributes.
export function numbers({ quantity, digits, bound, lower, upper }, model) {
  const all = { model, quantity, value: digits, bound, lower, upper };
  return Object.fromEntries(Object.entries(all).filter(([, value]) => value !== undefined));
}

export const heading = (name, definition = "") => element("th", { scope: "col", title: definition }, name);

export function options(select, list, chosen = select.value) {
  select.replaceChildren(...list.map(([value, text]) => element("option", { value }, text)));
  if (list.some(([value]) => value === chosen)) select.value = chosen;
}

export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// The smallest module with arithmetic on two numbers at once.
const PAIRS = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11];

// What this browser lacks to calculate, with what to do; empty for one that lacks nothing.
export function lacking() {
  const instead = "or use the program asperity, which needs no browser";
  if (typeof WebAssembly !== "object") return `This page calculates by WebAssembly, which this browser does not have or has switched off, as some security settings do: allow it for this page, use another browser, ${instead}.`;
  return WebAssembly.validate(new Uint8Array(PAIRS)) ? "" : `This browser is too old for the calculations of this page: use Chrome or Edge from version 91, Firefox from 89 or Safari from 16.4, ${instead}.`;
}

// A message above the page, until something else is shown or it is closed.
export function tell(text) {
  const box = $("message");
  const close = element("button", { type: "button", className: "close", onclick: () => tell("") });
  close.setAttribute("aria-label", "close the message");
  box.hidden = !text;
  box.replaceChildren(text ?? "", ...(text ? [close] : []));
}
