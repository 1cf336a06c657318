// The load, the table of values and the curves.
import { $, cell, element, options, picture } from "./page.js";

// Columns: quantities; rows: models. The first answer that comes decides the columns.
export function table(views, rows) {
  const [head, body] = [$("answers").tHead, $("answers").tBodies[0]];
  const row = element("tr", {}, element("th", { scope: "col" }, "model"));
  row.append(...views.map(({ label, definition }) => element("th", { scope: "col", title: definition }, label)));
  head.replaceChildren(row);
  body.replaceChildren(...rows.map(({ model, name, cells }) =>
    element("tr", {}, element("th", { scope: "row", title: name }, model), ...cells.map((value) => cell(value, model)))));
}

export function load(shown, typed) {
  const [field, error] = [$("load"), $("load-error")];
  if (field.value.trim() !== shown.text) field.value = shown.text;
  if (typed) $("slider").value = shown.position;
  $("slider").setAttribute("aria-valuetext", shown.text);
  $("load-other").textContent = shown.other;
  Object.assign(field.dataset, { newtons: shown.newtons, pascals: shown.pascals });
  error.textContent = "";
  field.removeAttribute("aria-invalid");
}

export function refuseLoad(message) {
  $("load-error").textContent = message;
  $("load").setAttribute("aria-invalid", "true");
}

// The list of models with what each lacks.
export function models(list, chosen, changed) {
  const box = $("models");
  box.replaceChildren(...list.map(({ id, name, source, reason }) => {
    const check = element("input", { type: "checkbox", value: id, checked: chosen.includes(id) && !reason, disabled: Boolean(reason) });
    check.addEventListener("change", () => changed([...box.querySelectorAll("input:checked")].map((one) => one.value)));
    const label = element("label", { title: reason ?? source }, check, ` ${id}`);
    if (name !== id.toUpperCase()) label.append(element("span", { className: "source" }, ` ${name}`));
    if (reason) label.setAttribute("aria-disabled", "true");
    return label;
  }));
  $("model-box").querySelector("summary").textContent = `Models: ${chosen.join(", ")}`;
}

export function views(list, chosen) {
  options($("view"), list.map(({ id, label }) => [id, label]), chosen);
}

export function curve(svg, ids, view) {
  picture($("curve"), svg, `${view} against the load by ${ids.join(", ")}`);
}

export function findings(list) {
  $("findings").hidden = list.length === 0;
  $("findings").querySelector("ul").replaceChildren(
    ...list.map(({ severity, message, code }) => element("li", { className: severity, data: { code } }, `${severity}: ${message}`)));
}

export function numbers(list) {
  $("numbers").replaceChildren(...list.map(({ name, digits, shown, meaning }) =>
    element("tr", {}, element("th", { scope: "row" }, name), element("td", { title: digits }, shown), element("td", {}, meaning))));
}
