// Scenes to start from: the examples of the scene files, and what to try on the first.
import { $, element } from "./page.js";
import { desks, page, state, work } from "./state.js";
import { answer, edit, setModels, setScene, setView } from "./scene.js";
import { elements } from "./elements.js";
import { usualRandom, useScan } from "./scans.js";

export const EXAMPLES = [
  ["ground-steel", "Ground steel, with a surface made here"],
  ["wheel-rail", "Wheel on a rail"],
  ["bolted-joint", "Bolted joint"],
  ["elastomer-on-glass", "Elastomer on glass"],
  ["lapped-seal", "Lapped seal"],
];
const FIRST = EXAMPLES[0][0];

const TRIES = [
  ["How stiff is it when it is unloaded?", "Show the unloading stiffness", () => setView("unloading-stiffness")],
  ["What does a body of copper change?", "Second body: copper", () => edit([{ path: "body[2].material", value: "copper-cold-worked" }], 2)],
  ["Do inclined asperities change the answer? Gao and AT take some seconds.", "Add Gao and AT", () => setModels([...state.models, ...["gao", "at"].filter((id) => !state.models.includes(id))])],
  ["Is the area that boundary elements find at this load that of the models?", "Solve this load", () => page.load && elements.solve([page.load.pascals])],
];

export function tries() {
  $("tries").replaceChildren(...TRIES.map(([question, act, does]) =>
    element("li", {}, `${question} `, element("button", { type: "button", onclick: does }, act))));
}

export async function exampleText(name) {
  const response = await fetch(`examples/${name}.toml`);
  if (!response.ok) throw new Error(`the example ${name} could not be loaded: reload the page`);
  return response.text();
}

export const openExample = (name, kind = "example") => work("page", "example", async () => {
  let text = await exampleText(name);
  let [scan, random] = [null, null];
  if (name === FIRST) {
    // A realisation of that surface, for boundary elements.
    ({ text, scan, random } = await useScan(text, { typed: usualRandom() }));
    const changes = ["asperities", "separation_from"].map((key) => ({ path: `surface.${key}`, value: null }));
    text = await desks.quick.call("edit", { text, changes });
  }
  Object.assign(state, { load: "", scan, random });
  $("try").hidden = name !== FIRST;
  setScene(text, kind).then(() => page.shown?.scan && !page.shown.scan.refused && elements.solve([]));
});
