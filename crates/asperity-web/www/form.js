// The form: a view of the text of the scene. An edited field is a change of the text.
import { $, element, lowered, put, typing } from "./page.js";

const BODY = [
  ["youngs_modulus", "Young's modulus E", "210 GPa"],
  ["poissons_ratio", "Poisson's ratio ν", "0.3"],
  ["hardness", "Hardness H", "2 GPa"],
  ["yield_strength", "Yield strength", "700 MPa"],
  ["thermal_conductivity", "Thermal conductivity", "50 W/(m K)"],
  ["electrical_resistivity", "Electrical resistivity", "1.7e-7 ohm m"],
];
const INTERFACE = [
  ["equivalent_modulus", "Equivalent modulus", "115 GPa"],
  ["poissons_ratio", "Poisson's ratio ν", "0.3"],
  ["hardness", "Hardness H", "2 GPa"],
];
const WAYS = {
  asperities: [
    ["asperity_radius", "Asperity radius R", "0.2 mm"],
    ["asperity_density", "Asperity density η", "200 1/mm2"],
    ["asperity_height_std", "Height std σ_z", "1 um"],
  ],
  index: [
    ["plasticity_index", "Plasticity index ψ", "2"],
    ["roughness_parameter", "η R σ_z", "0.04"],
    ["asperity_height_std", "Height std σ_z", "1 um"],
  ],
  moments: [
    ["m0", "m0, mean of z²", "1e-12 m^2"],
    ["m2", "m2, mean of z′²", "1e-4"],
    ["m4", "m4, mean of z″²", "5e4 1/m^2"],
  ],
  iso: [["sq", "Sq", "1.1 um"], ["spd", "Spd", "200 1/mm2"], ["spc", "Spc", "5 1/mm"]],
  scan: [
    ["file", "File", "scan.x3p"],
    ["unit", "Unit of the heights", "um"],
    ["pixel_size", "Pixel size", "1.5 um"],
    ["periodic", "Periodic", ["true", "false"]],
  ],
};
const EVERY = [["heights", "Heights", "gaussian"], ["asperities", "Asperities", ["equal", "random"]]];
// Rarely set for a scan.
const MORE = [
  ["estimator", "Estimator", ["moments", "summits"]],
  ["level", "Form removed", ["plane", "quadratic", "mean", "none"]],
  ["filter", "Long cut-off", "0.8 mm"],
  ["smooth", "Short cut-off", "2 um"],
  ["fill_missing", "Fill missing points", ["true", "false"]],
  ["despike", "Replace outliers", ["true", "false"]],
  ["max_missing", "Missing points, at most", "0.1"],
  ...EVERY,
];

// A labelled field of a path; a list of choices makes a select.
export function field(path, label, hint, edit) {
  const id = `field-${path.replace(/[^a-z0-9]+/gi, "-")}`;
  let input;
  if (Array.isArray(hint)) {
    input = element("select", { id, data: { path } });
    input.append(element("option", { value: "" }, "default"), ...hint.map((name) => element("option", {}, name)));
  } else {
    input = element("input", { id, type: "text", placeholder: hint, autocomplete: "off", data: { path } });
  }
  input.setAttribute("aria-describedby", `${id}-note`);
  input.addEventListener("change", () => edit([{ path, value: input.value.trim() || null }]));
  const note = element("p", { id: `${id}-note`, className: "note", hidden: true });
  return element("div", { className: "row" }, element("label", { htmlFor: id }, ...lowered(label)), input, note);
}

function body(k, edit, materials) {
  const box = element("div", { className: "body" }, element("h3", {}, k === 1 ? "First body" : "Second body"));
  const path = `body[${k}].material`;
  const pick = element("select", { id: `material-${k}`, data: { path } });
  pick.append(element("option", { value: "" }, "own values"));
  pick.append(...materials.map(({ id, name }) => element("option", { value: id }, name)));
  pick.addEventListener("change", () => edit([{ path, value: pick.value }], k));
  pick.setAttribute("aria-describedby", `${pick.id}-note`);
  box.append(element("div", { className: "row wide" }, element("label", { htmlFor: pick.id }, "Material"), pick));
  box.append(element("p", { id: `${pick.id}-note`, className: "note", hidden: true }));
  box.append(element("p", { className: "source", id: `source-${k}`, hidden: true }));
  box.append(...BODY.map(([key, label, hint]) => field(`body[${k}].${key}`, label, hint, edit)));
  return box;
}

let built = "";

// Builds the fields that the scene needs, and fills them.
export function fill(shown, edit, materials) {
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
      bodies.append(...INTERFACE.map(([key, label, hint]) => field(`interface.${key}`, label, hint, edit)));
    } else {
      bodies.append(body(1, edit, materials));
      const check = element("input", { type: "checkbox", id: "rigid", checked: rigid });
      check.addEventListener("change", () => edit([{ path: "rigid_counterface", value: check.checked ? "true" : null }]));
      bodies.append(element("label", {}, check, " rigid counterface"));
      if (!rigid) bodies.append(body(2, edit, materials));
    }
    bodies.append(field("nominal_area", "Nominal area", "1 cm2", edit));
    const ofSurface = ([key, label, hint]) => field(`surface.${key}`, label, hint, edit);
    const rest = way === "scan" ? [element("details", { id: "more" }, element("summary", {}, "More about the scan"), ...MORE.map(ofSurface))] : EVERY.map(ofSurface);
    $("surface-fields").replaceChildren(...WAYS[way].map(ofSurface), ...rest);
    const again = path && [...document.querySelectorAll("[data-path]")].find((input) => input.dataset.path === path);
    if (again && typed) {
      again.value = value;
      typing.add(again);
    }
    if (again?.closest("#more")) $("more").open = true;
    again?.focus();
  }
  if (way === "scan" && MORE.some(([key]) => `surface.${key}` in fields)) $("more").open = true;
  $("way").value = way;
  for (const input of document.querySelectorAll("[data-path]")) {
    put(input, fields[input.dataset.path] ?? "");
  }
  for (const k of [1, 2]) {
    const source = $(`source-${k}`);
    if (!source) continue;
    const material = materials.find(({ id }) => id === fields[`body[${k}].material`]);
    $(`material-${k}`).value = material?.id ?? "";
    source.hidden = !material;
    source.textContent = material ? `${material.shown}. Source: ${material.source}` : "";
    for (const [key] of BODY.slice(0, 4)) {
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
    let [text, severity] = of.get(input.dataset.path) ?? [];
    // The form has names and no lines.
    if (severity === "error" && error?.field_message) text = `${input.labels[0].textContent}: ${error.field_message}`;
    const note = $(`${input.id}-note`);
    note.hidden = !text;
    note.textContent = text ?? "";
    note.classList.toggle("wrong", severity === "error");
    if (text && input.closest("#more")) $("more").open = true;
    if (severity === "error") input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }
}
