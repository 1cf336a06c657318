// Leaks: whether the flow through the gap is solved, too, and the seal that the scene gets.
import { $ } from "./page.js";
import { page, state } from "./state.js";
import { note, writeLink } from "./link.js";

// Shows the leak of the state.
export function showLeak() {
  $("leaks").checked = Boolean(state.leak);
  $("fluid").hidden = !state.leak;
}

export function leak(edit) {
  $("leaks").addEventListener("change", ({ target }) => {
    state.leak = target.checked;
    showLeak();
    note("leak");
    writeLink();
  });
  // All that a leak of gas needs; a viscosity makes it a liquid.
  const needed = () => page.form.seal.filter(([key]) => key !== "viscosity");
  $("add-seal").addEventListener("click", () =>
    edit(needed().map(([key, , typed]) => ({ path: `seal.${key}`, value: typed.split("|")[0] }))));
}
