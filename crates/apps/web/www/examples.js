// Scenes to start from, the examples of the scene files among them, and what to try on each.
import { $, element } from "./page.js";
import { page, state, work } from "./state.js";
import { answer, edit, setModels, setScene, setView, shownAgain } from "./scene.js";
import { elements } from "./elements.js";
import { usualRandom, useScan } from "./scans.js";

// What a button does, and whether that is on the page.
const view = (id) => ({ act: () => setView(id), done: () => state.view === id && page.drawn === id });
const models = (...ids) => ({
  act: () => setModels([...state.models, ...ids.filter((id) => !state.models.includes(id))]),
  done: () => ids.every((id) => state.models.includes(id)),
});
const load = (text) => ({ act: () => answer({ text }), done: () => state.load === text });
const value = (path, text) => ({
  act: () => edit([{ path, value: text }]),
  done: () => page.shown?.fields[path] === text,
});
const solution = { act: () => elements.solve(false), done: () => Boolean(page.load && elements.at(page.load.pascals)) };
const adhesion = value("work_of_adhesion", "50 mJ/m2");
const unloading = view("unloading-stiffness");

const UNLOAD = ["How stiff is it when it is unloaded?", "Show the unloading stiffness", unloading];
const INCLINED = ["Do inclined asperities change the answer? Gao and AT take some seconds.", "Add Gao and AT", models("gao", "at")];

// Its surface is made here, for boundary elements.
const FIRST = "made-here";
// Questions, each with the words of a button and what it does.
const TRIES = {
  [FIRST]: [
    UNLOAD,
    ["What does a body of copper change?", "Second body: copper", {
      ...value("body[2].material", "copper-cold-worked"),
      done: () => Boolean(page.shown?.fields["body[2].material"]?.startsWith("copper")),
    }],
    INCLINED,
    ["Is the area that boundary elements find at this load that of the models?", "Solve this load", solution],
  ],
  "ground-steel": [
    ["What do asperities of different radii change?", "Add GW, KE and JG random", models("gw-random", "ke-random", "jg-random")],
    UNLOAD,
  ],
  "wheel-rail": [
    ["How much touches where the patch carries 500 MPa?", "Load of 500 MPa", load("500 MPa")],
    ["What does a wheel as hard as a bearing change?", "Second body: 7 GPa", value("body[2].hardness", "7 GPa")],
    INCLINED,
  ],
  "bolted-joint": [
    ["How stiff is the joint under a preload of 20 kN?", "Load of 20 kN", load("20 kN")],
    ["How stiff is it in shear?", "Show the tangential stiffness", view("tangential-stiffness")],
    ["What does a plate of steel change?", "First body: steel", value("body[1].material", "steel-a36")],
  ],
  "elastomer-on-glass": [
    ["What does adhesion change?", "Work of adhesion 50 mJ/m²", {
      ...adhesion,
      act: () => {
        state.models = ["gw", "dmt", "jkr"];
        return adhesion.act();
      },
    }],
    ["How many spots touch?", "Show the number of contacts", view("contacts")],
  ],
  "lapped-seal": [
    ["How much touches at 2 MPa?", "Load of 2 MPa", load("2 MPa")],
    ["What does a rougher lapping change?", "Sq of 200 nm", value("surface.sq", "200 nm")],
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
  $("tries").replaceChildren(...(TRIES[state.example] ?? []).map(([question, act, { act: does }]) =>
    element("li", {}, `${question} `, element("button", { type: "button", onclick: does }, act), element("span", { className: "source" }))));
  tick();
}

// Marks what the page shows already.
function tick() {
  const all = TRIES[state.example] ?? [];
  [...$("tries").children].forEach((item, k) => {
    const done = Boolean(all[k]?.[2].done());
    item.querySelector("button").disabled = done;
    item.querySelector("span").textContent = done ? " ✓ on the page" : "";
  });
}
shownAgain(tick);

export async function exampleText(name) {
  const response = await fetch(name === FIRST ? `${name}.toml` : `examples/${name}.toml`).catch(() => {
    throw new Error(`the example ${name} could not be read, as there is no connection to ${location.host || "its folder"}: connect again and choose it once more`);
  });
  if (!response.ok) throw new Error(`the example ${name} could not be loaded: reload the page`);
  return response.text();
}

export function openExample(name, kind = "example") {
  page.old = true;
  return work("page", "example", () => open(name, kind).catch((error) => {
    page.old = false;
    throw error;
  }));
}

async function open(name, kind) {
  let text = await exampleText(name);
  let [scan, random] = [null, null];
  page.wanted = null;
  if (name === FIRST) ({ text, scan, random } = await useScan(text, { typed: usualRandom() }));
  Object.assign(state, { load: "", scan, random });
  tries(name);
  setScene(text, kind).then(() => page.shown?.scan && !page.shown.scan.refused && elements.solved.length === 0 && elements.solve(true));
}
