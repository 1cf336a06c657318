// The form: a view of the text of the scene. An edited field is a change of the text.
import { $, element, lowered, put, typing } from "./page.js";

// A labelled field of a path; choices, between bars, make a select. `of` tells it from that of the
// other body.
export function field(path, label, hint, edit, of = "") {
  const id = `field-${path.replace(/[^a-z0-9]+/gi, "-")}`;
  let input;
  if (hint.includes("|")) {
    input = element("select", { id, data: { path } });
    input.append(element("option", { value: "" }, "default"), ...hint.split("|").map((name) => element("option", {}, name)));
  } else {
    input = element("input", { id, type: "text", placeholder: hint && `e.g. ${hint}`, autocomplete: "off", data: { path } });
  }
  input.setAttribute("aria-describedby", `${id}-note`);
  if (of) input.setAttribute("aria-label", `${label} of the ${of}`);
  input.addEventListener("change", () => edit([{ path, value: input.value.trim() || null }]));
  const note = element("p", { id: `${id}-note`, className: "note", hidden: true });
  return element("div", { className: "row" }, element("label", { htmlFor: id }, ...lowered(label)), input, note);
}

// The fields of a body before those that are folded.
const MAIN = 3;
// A folded field that is filled or has a note is shown.
function unfold(input) {
  const folded = input.closest("details");
  if (folded) folded.open = true;
}

function body(k, edit, form) {
  const name = k === 1 ? "first body" : "second body";
  const box = element("fieldset", { className: "body" }, element("legend", {}, k === 1 ? "First body" : "Second body"));
  const path = `body[${k}].material`;
  const pick = element("select", { id: `material-${k}`, data: { path } });
  pick.append(element("option", { value: "" }, "own values"));
  pick.append(...form.materials.map(({ id, name }) => element("option", { value: id }, name)));
  pick.addEventListener("change", () => edit([{ path, value: pick.value }]));
  pick.setAttribute("aria-describedby", `${pick.id}-note`);
  pick.setAttribute("aria-label", `Material of the ${name}`);
  box.append(element("div", { className: "row wide" }, element("label", { htmlFor: pick.id }, "Material"), pick));
  box.append(element("p", { id: `${pick.id}-note`, className: "note", hidden: true }));
  box.append(element("p", { className: "source", id: `source-${k}`, hidden: true }));
  const fields = form.body.map(([key, label, hint]) => field(`body[${k}].${key}`, label, hint, edit, name));
  const [main, rare] = [fields.slice(0, MAIN), fields.slice(MAIN)];
  box.append(...main, element("details", { className: "rare" }, element("summary", {}, "More about this body"), ...rare));
  return box;
}

let built = "";

// Builds the fields that the scene needs, and fills them.
export function fill(shown, edit, form) {
  const { fields, way } = shown;
  const has = (start) => Object.keys(fields).some((path) => path.startsWith(start));
  const rigid = fields.rigid_counterface === "true";
  const kind = [has("interface."), rigid, way].join();
  if (kind !== built) {
    built = kind;
    // Another form keeps the place of the user, and what is being typed there.
    const { dataset: { path } = {}, value } = document.activeElement ?? {};
    const typed = typing.has(document.activeElement);
    const bodies = $("bodies");
    bodies.replaceChildren(element("legend", {}, "Bodies"));
    if (has("interface.")) {
      bodies.append(...form.interface.map(([key, label, hint]) => field(`interface.${key}`, label, hint, edit)));
    } else {
      bodies.append(body(1, edit, form));
      const check = element("input", { type: "checkbox", id: "rigid", checked: rigid });
      check.addEventListener("change", () => edit([{ path: "rigid_counterface", value: check.checked ? "true" : null }]));
      bodies.append(element("label", {}, check, " rigid counterface"));
      if (!rigid) bodies.append(body(2, edit, form));
    }
    bodies.append(field(...form.area, edit));
    const ofSurface = ([key, label, hint]) => field(`surface.${key}`, label, hint, edit);
    const rest = way === "scan" ? [element("details", { id: "more" }, element("summary", {}, "More about the scan"), ...[...form.more, ...form.every].map(ofSurface))] : form.every.map(ofSurface);
    $("surface-fields").replaceChildren(...form.ways[way].map(ofSurface), ...rest);
    const again = path && [...document.querySelectorAll("[data-path]")].find((input) => input.dataset.path === path);
    if (again && typed) {
      again.value = value;
      typing.add(again);
    }
    if (again) unfold(again);
    again?.focus();
  }
  $("way").value = way;
  for (const input of document.querySelectorAll("[data-path]")) {
    put(input, fields[input.dataset.path] ?? "");
    if (input.dataset.path in fields) unfold(input);
  }
  for (const k of [1, 2]) {
    const source = $(`source-${k}`);
    if (!source) continue;
    const material = form.materials.find(({ id }) => id === fields[`body[${k}].material`]);
    $(`material-${k}`).value = material?.id ?? "";
    source.hidden = !material;
    source.textContent = material ? `${material.shown}. Source: ${material.source}` : "";
    for (const [key] of form.body.slice(0, 4)) {
      document.querySelector(`[data-path="body[${k}].${key}"]`).closest(".row").hidden = Boolean(material);
    }
  }
}

// Marks fields with what is wrong or unusual.
export function mark(error, findings) {
  const of = new Map();
  for (const { field: path, message, severity } of findings) if (!of.has(path)) of.set(path, [message, severity]);
  if (error?.field) of.set(error.field, [error.message, "error"]);
  for (const input of document.querySelectorAll("[data-path]")) {
    const { path } = input.dataset;
    let [text, severity] = of.get(path) ?? of.get(path.replace(/^surface\./, "")) ?? [];
    // The form has names and no lines.
    if (severity === "error" && error?.field_message) text = `${input.labels[0].textContent}: ${error.field_message}`;
    const note = $(`${input.id}-note`);
    note.hidden = !text;
    note.textContent = text ?? "";
    note.classList.toggle("wrong", severity === "error");
    if (text) unfold(input);
    if (severity === "error") input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }
}
