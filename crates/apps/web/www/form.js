// The form: a view of the text of the scene. An edited field is a change of the text.
import { $, element, lowered, options, put, typing } from "./page.js";

// A labelled field of a path; choices, between bars, make a select. `of` tells it from that of the
// other body. A number without a unit is in the one beside the label.
export function field(path, [label, hint, unit], edit, of = "") {
  const id = `field-${path.replace(/[^a-z0-9]+/gi, "-")}`;
  let input;
  if (hint.includes("|")) {
    input = element("select", { id, data: { path, label } });
    input.append(element("option", { value: "" }, "default"), ...hint.split("|").map((name) => element("option", {}, name)));
  } else {
    input = element("input", { id, type: "text", placeholder: hint && `e.g. ${hint}`, autocomplete: "off", data: { path, label } });
  }
  input.setAttribute("aria-describedby", `${id}-note`);
  if (of) input.setAttribute("aria-label", `${label} of the ${of}${unit && `, in ${unit}`}`);
  input.addEventListener("change", () => edit([{ path, value: input.value.trim() || null }]));
  const note = element("p", { id: `${id}-note`, className: "note", hidden: true });
  const units = unit ? [" ", element("small", { className: "unit", title: `a number without a unit is in ${unit}` }, unit)] : [];
  return element("div", { className: "row" }, element("label", { htmlFor: id }, ...lowered(label), ...units), input, note);
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
  const pick = element("select", { id: `material-${k}`, data: { path, label: "Material" } });
  pick.append(element("option", { value: "" }, "own values"));
  pick.append(...form.materials.map(({ id, name }) => element("option", { value: id }, name)));
  pick.addEventListener("change", () => edit([{ path, value: pick.value }]));
  pick.setAttribute("aria-describedby", `${pick.id}-note`);
  pick.setAttribute("aria-label", `Material of the ${name}`);
  box.append(element("div", { className: "row wide" }, element("label", { htmlFor: pick.id }, "Material"), pick));
  box.append(element("p", { id: `${pick.id}-note`, className: "note", hidden: true }));
  box.append(element("p", { className: "source", id: `source-${k}`, hidden: true }));
  const fields = form.body.map(([key, ...about]) => field(`body[${k}].${key}`, about, edit, name));
  const [main, rare] = [fields.slice(0, MAIN), fields.slice(MAIN)];
  box.append(...main, element("details", { className: "rare" }, element("summary", {}, "More about this body"), ...rare));
  return box;
}

// What the other of two rough surfaces is, with its fields if it is another.
const OTHER = [["same", "the same"], ["smooth", "smooth"], ["another", "another"]];
let isAnother = false;

function other(edit, fields) {
  const pick = element("select", { id: "other-surface" });
  options(pick, OTHER);
  pick.addEventListener("change", () => {
    isAnother = pick.value === "another";
    edit([{ path: "surface.other", value: pick.value }]);
  });
  const row = element("div", { className: "row" }, element("label", { htmlFor: pick.id }, "Other surface"), pick);
  return [row, element("div", { id: "other-fields" }, ...fields)];
}

let built = "";

// Builds the fields that the scene needs, and fills them.
export function fill(shown, edits, form) {
  const { fields, way } = shown;
  const edit = (changes) => edits(changes, isAnother);
  const has = (start) => Object.keys(fields).some((path) => path.startsWith(start));
  const rigid = fields.rigid_counterface === "true";
  const sealed = has("seal.");
  const curved = has("curvature.");
  const kind = [has("interface."), rigid, way, sealed, curved].join();
  if (kind !== built) {
    built = kind;
    // Another form keeps the place of the user, and what is being typed there.
    const { dataset: { path } = {}, value } = document.activeElement ?? {};
    const typed = typing.has(document.activeElement);
    const bodies = $("bodies");
    bodies.replaceChildren(element("legend", {}, "Bodies"));
    if (has("interface.")) {
      bodies.append(...form.interface.map(([key, ...about]) => field(`interface.${key}`, about, edit)));
    } else {
      bodies.append(body(1, edit, form));
      const check = element("input", { type: "checkbox", id: "rigid", checked: rigid });
      check.addEventListener("change", () => edit([{ path: "rigid_counterface", value: check.checked ? "true" : null }]));
      bodies.append(element("label", {}, check, " rigid counterface"));
      if (!rigid) bodies.append(body(2, edit, form));
    }
    const [area, ...ofArea] = form.area;
    const radii = form.curvature.map(([key, ...about]) => field(`curvature.${key}`, about, edit));
    // Curved bodies have no nominal area.
    if (!curved) bodies.append(field(area, ofArea, edit));
    bodies.append(element("details", { id: "curved" }, element("summary", {}, "Curved bodies"), ...radii));
    const ofSurface = ([key, ...about]) => field(`surface.${key}`, about, edit);
    isAnother = false;
    const rest = way === "scan" ? [element("details", { id: "more" }, element("summary", {}, "More about the scan"), ...[...form.more, ...form.every].map(ofSurface))] : form.every.map(ofSurface);
    const ofOther = shown.other ? other(edit, form.other.map(ofSurface)) : [];
    $("surface-fields").replaceChildren(...form.ways[way].map(ofSurface), ...ofOther, ...rest);
    $("add-seal").hidden = sealed;
    $("seal").replaceChildren(...(sealed ? form.seal.map(([key, ...about]) => field(`seal.${key}`, about, edit)) : []));
    const again = path && [...document.querySelectorAll("[data-path]")].find((input) => input.dataset.path === path);
    if (again && typed) {
      again.value = value;
      typing.add(again);
    }
    if (again) unfold(again);
    again?.focus();
  }
  $("way").value = way;
  if (shown.other) {
    // Another one may still have the numbers of the first.
    isAnother = shown.other === "another" || (isAnother && shown.other === "same");
    $("other-surface").value = isAnother ? "another" : shown.other;
    $("other-fields").hidden = !isAnother;
  }
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

// Options of files, shown where one is given or a file asks for it.
const ASKED = ["channel", "units", "columns", "skip_lines", "missing", "factor", "delimiter"].map((key) => `surface.${key}`);

// Marks fields with what is wrong or unusual.
export function mark(error, findings) {
  const of = new Map();
  for (const { field: path, message, severity } of findings) if (!of.has(path)) of.set(path, [message, severity]);
  if (error?.field) of.set(error.field, [error.message, "error"]);
  for (const input of document.querySelectorAll("[data-path]")) {
    const { path } = input.dataset;
    let [text, severity] = of.get(path) ?? of.get(path.replace(/^surface\./, "")) ?? [];
    // The form has names and no lines.
    if (severity === "error" && error?.field_message) text = `${input.dataset.label}: ${error.field_message}`;
    const note = $(`${input.id}-note`);
    note.hidden = !text;
    note.textContent = text ?? "";
    note.classList.toggle("wrong", severity === "error");
    if (text) unfold(input);
    if (ASKED.includes(path)) input.closest(".row").hidden = !text && !input.value;
    if (severity === "error") input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }
}
