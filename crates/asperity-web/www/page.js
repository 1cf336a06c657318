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

// A picture of the desk, with a text that says what it shows.
export function picture(figure, svg, label) {
  const made = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  made.setAttribute("role", "img");
  made.setAttribute("aria-label", label);
  figure.replaceChildren(document.importNode(made, true));
  figure.dataset.svg = svg;
}

// A cell with a number as shown, and with all digits.
export function cell({ quantity, digits, bound, shown }, model) {
  if (digits === undefined) return element("td", { className: "none", title: shown }, "–");
  const data = { model, quantity, value: digits };
  if (bound !== undefined) data.bound = bound;
  return element("td", { data, title: digits }, shown);
}

export function options(select, list, chosen = select.value) {
  select.replaceChildren(...list.map(([value, text]) => element("option", { value }, text)));
  if (list.some(([value]) => value === chosen)) select.value = chosen;
}

export function download(name, content, type) {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

// A message above the page, with an action if there is one.
export function tell(text, action, act) {
  const box = $("message");
  box.hidden = !text;
  box.replaceChildren(text ?? "");
  if (action) box.append(element("button", { type: "button", onclick: act }, action));
}
