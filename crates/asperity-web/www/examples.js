// Scenes to start from, the examples of the scene files among them, and what to try on each.
import { $, element } from "./page.js";
import { page, state, work } from "./state.js";
import { answer, edit, setModels, setScene, setView } from "./scene.js";
import { elements } from "./elements.js";
import { usualRandom, useScan } from "./scans.js";

const UNLOAD = ["How stiff is it when it is unloaded?", "Show the unloading stiffness", () => setView("unloading-stiffness")];
const INCLINED = ["Do inclined asperities change the answer? Gao and AT take some seconds.", "Add Gao and AT", () => add("gao", "at")];
const add = (...ids) => setModels([...state.models, ...ids.filter((id) => !state.models.includes(id))]);
const typed = (text) => answer({ text });

// Its surface is made here, for boundary elements.
const FIRST = "made-here";
// Questions, each with the words of a button and what it does.
const TRIES = {
  [FIRST]: [
    UNLOAD,
    ["What does a body of copper change?", "Second body: copper", () => edit([{ path: "body[2].material", value: "copper-cold-worked" }], 2)],
    INCLINED,
    ["Is the area that boundary elements find at this load that of the models?", "Solve this load", () => elements.solve(false)],
  ],
  "ground-steel": [
    UNLOAD,
    ["What do asperities of one radius change?", "Equal asperities", () => edit([{ path: "surface.asperities", value: "equal" }])],
  ],
  "wheel-rail": [
    ["How much touches where the patch carries 500 MPa?", "Load of 500 MPa", () => typed("500 MPa")],
    ["What does a wheel as hard as a bearing change?", "Second body: 7 GPa", () => edit([{ path: "body[2].hardness", value: "7 GPa" }])],
    INCLINED,
  ],
  "bolted-joint": [
    ["How stiff is the joint under a preload of 20 kN?", "Load of 20 kN", () => typed("20 kN")],
    ["How stiff is it in shear?", "Show the tangential stiffness", () => setView("tangential-stiffness")],
    ["What does a plate of steel change?", "First body: steel", () => edit([{ path: "body[1].material", value: "steel-a36" }], 1)],
  ],
  "elastomer-on-glass": [
    ["What does adhesion change?", "Work of adhesion 50 mJ/m²", () => {
      state.models = ["gw", "dmt", "jkr"];
      return edit([{ path: "work_of_adhesion", value: "50 mJ/m2" }]);
    }],
    ["How many spots touch?", "Show the number of contacts", () => setView("contacts")],
  ],
  "lapped-seal": [
    ["How much touches at 2 MPa?", "Load of 2 MPa", () => typed("2 MPa")],
    ["What does a rougher lapping change?", "Sq of 200 nm", () => edit([{ path: "surface.sq", value: "200 nm" }])],
  ],
};

export const EXAMPLES = [
  [FIRST, "Ground steel, with a surface made here"],
  ["ground-steel", "Ground steel, from moments"],
  ["wheel-rail", "Wheel on a rail"],
  ["bolted-joint", "Bolted joint"],
  ["elastomer-on-glass", "Elastomer on glass"],
  ["lapped-seal", "Lapped seal"],
];

// What to try on an example; nothing for another scene.
export function tries(name) {
  state.example = Object.hasOwn(TRIES, name ?? "") ? name : null;
  $("try").hidden = !state.example;
  $("tries").replaceChildren(...(TRIES[state.example] ?? []).map(([question, act, does]) =>
    element("li", {}, `${question} `, element("button", { type: "button", onclick: does }, act))));
}

export async function exampleText(name) {
  const response = await fetch(name === FIRST ? `${name}.toml` : `examples/${name}.toml`);
  if (!response.ok) throw new Error(`the example ${name} could not be loaded: reload the page`);
  return response.text();
}

export const openExample = (name, kind = "example") => work("page", "example", async () => {
  let text = await exampleText(name);
  let [scan, random] = [null, null];
  page.wanted = null;
  if (name === FIRST) ({ text, scan, random } = await useScan(text, { typed: usualRandom() }));
  Object.assign(state, { load: "", scan, random });
  tries(name);
  setScene(text, kind).then(() => page.shown?.scan && !page.shown.scan.refused && elements.solve(true));
});
