// Models against the answer: those of the table at once, the others after a press of the button.
import { $, element } from "./page.js";
import { chosen, desks, implausible, page, state, work } from "./state.js";
import { elements } from "./elements.js";

// The rows of models that are not in the table, at the load of the page.
let others = new Map();
// Adds a model to the table.
let add = () => {};

const allowed = () => (page.shown?.models ?? []).filter(({ reason }) => !reason).map(({ id }) => id);

export function startCompare(adds) {
  add = adds;
  $("compare").addEventListener("click", compareAll);
}

// Another load or another solution has other deviations.
export function forget() {
  others = new Map();
  $("compared-count").textContent = "";
  $("comparing").hidden = true;
}

export function showCompared() {
  const rows = new Map([...others, ...page.values]);
  // The nearest first, then those that cannot be compared.
  const rank = ({ against, mark }) => [!against, Boolean(mark), Boolean(against?.lacks), against?.off];
  const before = (a, b) => rank(a).map((part, k) => part - rank(b)[k]).find((part) => part) ?? 0;
  const list = [...rows.values()].sort(before);
  const name = (id) => (chosen().includes(id) ? element("strong", {}, id)
    : element("button", { type: "button", title: "add to the table", onclick: () => add(id) }, id));
  $("compared").replaceChildren(...list.map(({ model, against, outside, reason }) =>
    element("li", {}, name(model), `${outside ? " ⚠" : ""} ${against?.words ?? reason ?? (page.best?.use?.model === model ? "the recommended model" : "not compared")}`)));
  $("compare").disabled = !page.load || implausible() || allowed().every((id) => rows.has(id));
}

function compareAll() {
  const { shown, text } = page;
  const { load } = state;
  const current = () => page.shown === shown && state.load === load;
  const ids = allowed().filter((id) => !page.values.has(id));
  const bar = Object.assign($("comparing"), { hidden: false, max: ids.length, value: 0 });
  $("compare").disabled = true;
  work("slow", "compare", async () => {
    let done = 0;
    for (const id of ids) {
      if (!current()) return;
      $("compared-count").textContent = `${done} of ${ids.length} compared; next ${id}`;
      const { rows } = await desks.slow.ask(text, "answer", { models: [id], load: { text: load }, solved: elements.known() });
      if (!current()) return;
      done += 1;
      bar.value = done;
      others.set(id, rows[0]);
      showCompared();
    }
    $("compared-count").textContent = `all ${page.values.size + done} models compared`;
    bar.hidden = true;
  });
}
