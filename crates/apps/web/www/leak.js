// Leaks: the hydraulic gaps of loads that are solved, and the flow of a fluid through them.
import { $, element } from "./page.js";
import { answers, ask, desks, page, state, work } from "./state.js";
import { note, writeLink } from "./link.js";
import { elements } from "./elements.js";

const FIELDS = [["viscosity", "Viscosity", "1 mPa s"], ["pressure_drop", "Pressure drop over the scan", "1 bar"]];
const GAPS = ["hydraulic-gap-x", "hydraulic-gap-y"];
const place = (key) => $(`leak-${key}`);

// What is wrong stands below its field.
function say(error) {
  for (const [key] of FIELDS) {
    const wrong = error?.field === `leak.${key}`;
    const text = $(`leak-${key}-note`);
    text.hidden = !wrong;
    text.textContent = wrong ? error.message : "";
    place(key).setAttribute("aria-invalid", String(wrong));
  }
}

// The flows through the gaps that are there; none without a fluid.
export const flow = () => work("page", "flow", async () => {
  const { text } = page;
  const gaps = ({ cells }) => GAPS.map((gap) => cells.find(({ quantity }) => quantity === gap)?.digits).filter(Boolean).map(Number);
  const solved = elements.solved.filter((one) => gaps(one).length === GAPS.length);
  let [found, error] = [null, null];
  try {
    if (answers() && Object.values(state.leak ?? {}).some(Boolean)) found = await ask(desks.quick, "flow", { ...state.leak, gaps: solved.map(gaps) });
  } catch (refused) {
    if (!refused.field?.startsWith("leak.")) throw refused;
    error = refused;
  }
  if (text !== page.text) return;
  say(error);
  for (const one of elements.solved) one.flow = found && solved.includes(one) ? { head: found.head, cells: found.cells[solved.indexOf(one)] } : null;
  if (elements.solved.length > 0) elements.table();
});

// Shows the leak of the state.
export function showLeak() {
  $("leaks").checked = Boolean(state.leak);
  $("fluid").hidden = !state.leak;
  for (const [key] of FIELDS) place(key).value = state.leak?.[key] ?? place(key).value;
}

export function leak() {
  $("fluid").append(...FIELDS.map(([key, label, hint]) => {
    const id = `leak-${key}`;
    const input = element("input", { id, type: "text", placeholder: `e.g. ${hint}`, autocomplete: "off" });
    input.setAttribute("aria-describedby", `${id}-note`);
    const wrong = element("p", { id: `${id}-note`, className: "note wrong", hidden: true });
    return element("div", { className: "row" }, element("label", { htmlFor: id }, label), input, wrong);
  }));
  elements.flow = flow;
  $("leak").addEventListener("change", () => {
    state.leak = $("leaks").checked ? Object.fromEntries(FIELDS.map(([key]) => [key, place(key).value.trim()])) : null;
    showLeak();
    note("leak");
    writeLink();
    flow();
  });
}
