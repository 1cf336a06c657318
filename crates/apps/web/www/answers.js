// The load, the table of values, the curves and what is found about them.
import { $, cell, element, heading, lowered, noPicture, numbers as attributes, options, picture, put } from "./page.js";

// What the answer has before there are values: their place on the screen.
const PARTS = ["real area", "first-loading stiffness", "stiffness of small vibrations", "plasticity index", "model to use"];

// The values at the load with their intervals, where they are from, and the model to use.
export function answer(found, isExample) {
  const part = (name, data, shown, more) => element("div", { title: more },
    element("dt", {}, name), element("dd", {}, element("b", { data }, shown), element("small", {}, more)));
  $("answer").querySelector("dl").replaceChildren(...(found ? [
    ...found.first.map((one) => part(one.name, attributes(one, "answer"), one.shown, one.by)),
    part("model to use", {}, found.model || "none", found.also),
  ] : PARTS.map((name) => part(name, {}, "–", ""))));
  const [example, basis] = $("basis").children;
  basis.textContent = found?.basis ?? "";
  basis.title = found?.basis ?? "";
  example.textContent = found && isExample ? `An example surface (${found.surface}).` : "";
}

// Columns: quantities; rows: models, those without values yet with dots, and boundary elements.
export function table(views, ids, values, best, about = () => "") {
  const [head, body] = [$("answers").tHead, $("answers").tBodies[0]];
  head.replaceChildren(element("tr", {}, heading("model"), heading("area, stiffness against the answer", "How far real area and first-loading stiffness of a model are from the answer; ⚠ where the model is out of its range."), ...views.map(({ label, definition }) => heading(label, definition))));
  const waiting = () => views.map(() => element("td", { className: "none", title: "being calculated" }, "…"));
  const cells = (id, row) => (row.reason ? [element("td", { className: "reason", colSpan: views.length }, row.reason)] : row.cells.map((value) => cell(value, id)));
  const against = (row) => element("td", { className: "against", title: row?.outside ?? row?.against ?? "" },
    row?.outside ? "⚠ " : "", row?.against ?? "");
  const first = best ? [element("tr", { className: "answer" }, element("th", { scope: "row" }, "answer"), against(), ...cells("answer", best.row))] : [];
  body.replaceChildren(...first, ...ids.map((id) => {
    const row = values.get(id);
    const name = element("th", { scope: "row", title: about(id) }, id);
    const line = element("tr", {}, name, against(row), ...(row ? cells(id, row) : waiting()));
    return row?.mark ? [line, marked(id, row.mark, views)] : [line];
  }).flat());
  if (best?.solved) {
    const name = element("th", { scope: "row", title: "the scan of this scene, solved pixel by pixel" }, "boundary elements");
    body.append(element("tr", {}, name, against(best.solved), ...cells("bem", best.solved)));
  }
}

// Why the values above are those of no contact.
function marked(id, reason, views) {
  const text = element("td", { className: "reason", colSpan: views.length + 2 }, "⚠ ", element("strong", {}, `${id}: impossible result`), `: ${reason}`);
  return element("tr", { className: "marked", data: { marked: id } }, text);
}

export function load(shown, typed) {
  const field = $("load");
  put(field, shown.text);
  if (typed) $("slider").value = shown.position;
  $("slider").setAttribute("aria-valuetext", shown.text);
  $("unit").value = shown.unit;
  $("load-other").textContent = shown.other;
  Object.assign(field.dataset, { newtons: shown.newtons, pascals: shown.pascals });
  $("load-error").textContent = "";
  field.removeAttribute("aria-invalid");
}

// Each reason once, with its models.
function byReason(rows) {
  const models = new Map();
  for (const { model, reason, mark } of rows) models.set(reason ?? mark, [...(models.get(reason ?? mark) ?? []), model]);
  return [...models];
}

// Why no model answers, with the models of a reason where there are several.
export const commonRefusal = (rows) => byReason(rows).map(([reason, ids], _, { length }) => (length > 1 ? `${ids.join(", ")}: ${reason}` : reason)).join("; ");

// A load at which every model has a reason or a mark: the values stand with their marks.
export function undescribed(rows) {
  const message = rows.length > 0 && rows.every(({ reason, mark }) => reason || mark) ? `no model describes this load: ${commonRefusal(rows)}` : "";
  $("load-error").textContent = message;
  if (message) $("load").setAttribute("aria-invalid", "true");
  return message;
}

export function refuseLoad(message, typed = $("load").value) {
  put($("load"), typed);
  // Beside it stood the load before.
  $("load-other").textContent = "";
  $("load-error").textContent = message;
  $("load").setAttribute("aria-invalid", "true");
}

// The list of models with what each lacks.
export function models(list, chosen, changed) {
  const box = $("models");
  const words = element("p", { className: "source" });
  const focused = box.contains(document.activeElement) && document.activeElement.value;
  box.replaceChildren(...list.map(({ id, about, reason }) => {
    const check = element("input", { type: "checkbox", value: id, checked: chosen.includes(id) && !reason, disabled: Boolean(reason) });
    check.addEventListener("change", () => changed([...box.querySelectorAll("input:checked")].map((one) => one.value)));
    const label = element("label", { title: reason ?? about }, check, ` ${id}`);
    // What the model is, also by tap and key.
    for (const event of ["pointerover", "focusin"]) label.addEventListener(event, () => { words.textContent = reason ? `${id}: ${reason}` : about; });
    if (reason) label.setAttribute("aria-disabled", "true");
    return label;
  }), words);
  if (focused) box.querySelector(`[value="${focused}"]`)?.focus();
  names(chosen);
}

export function names(chosen) {
  const summary = $("model-box").querySelector("summary");
  summary.textContent = `Models: ${chosen.join(", ")}`;
  summary.title = chosen.join(", ");
}

export function views(list, chosen) {
  options($("view"), list.map(({ id, label }) => [id, label]), chosen);
  $("definitions").querySelector("dl").replaceChildren(...list.flatMap(({ label, definition }) =>
    [element("dt", {}, label), element("dd", {}, definition)]));
}

export function curve(svg, ids, view) {
  picture($("curve"), svg, `${view} against the load by ${ids.join(", ")}`);
}

let listed = [];

export function findings(list) {
  listed = list;
  $("no-findings").hidden = list.length > 0;
  $("tab-findings").textContent = list.length > 0 ? `Findings (${list.length})` : "Findings";
  const [first] = list.filter(({ severity }) => severity !== "note");
  $("first-warning").replaceChildren(...(first ? ["⚠ ", ...lowered(first.message)] : []));
  $("first-warning").title = first?.message ?? "";
  $("findings").querySelector("ul").replaceChildren(
    ...list.map(({ severity, message, code }) => element("li", { className: severity, data: { code } }, ...lowered(`${severity}: ${message}`))));
}

// More findings, without those that are there.
export function addFindings(list) {
  const known = new Set(listed.map(({ message }) => message));
  findings([...listed, ...list.filter(({ message }) => !known.has(message))]);
}

export function numbers(list) {
  $("numbers").replaceChildren(...list.map(({ name, digits, shown, meaning }) =>
    element("tr", {}, element("th", { scope: "row" }, ...lowered(name)), element("td", { title: digits }, shown), element("td", {}, ...lowered(meaning)))));
}

// Shows load, models and quantity of the state while the scene has an error.
export function keep({ load, models, view }) {
  if (load) put($("load"), load);
  names(models);
  if (view) $("view").value = view;
}

// No values, no curves; the place of the curves says why.
export function clear(why) {
  answer(null);
  table([], [], new Map());
  findings([]);
  numbers([]);
  noPicture($("curve"), why);
  $("load-other").textContent = "";
  $("load-error").textContent = "";
  for (const key of ["newtons", "pascals"]) delete $("load").dataset[key];
}
