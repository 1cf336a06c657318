// Scenes to start from: the examples of the scene files.
import { randomKeys } from "./scans.js";

export const EXAMPLES = [
  ["ground-steel", "Ground steel, with a surface made here"],
  ["wheel-rail", "Wheel on a rail"],
  ["bolted-joint", "Bolted joint"],
  ["elastomer-on-glass", "Elastomer on glass"],
  ["lapped-seal", "Lapped seal"],
];

export async function openExample(name, { desks, state, setScene }) {
  const response = await fetch(`examples/${name}.toml`);
  if (!response.ok) throw new Error(`the example ${name} could not be loaded`);
  let text = await response.text();
  Object.assign(state, { load: "", scan: null, random: null });
  if (name === EXAMPLES[0][0]) {
    // A realisation of that surface, for boundary elements.
    const keys = randomKeys();
    const made = await Promise.all(Object.values(desks).map((desk) => desk.hand("", { keys })));
    Object.assign(state, { scan: made[0], random: keys });
    text = await desks.quick.call("use-scan", { text, name: made[0].name });
    const changes = ["asperities", "separation_from"].map((key) => ({ path: `surface.${key}`, value: null }));
    text = await desks.quick.call("edit", { text, changes });
  }
  await setScene(text);
}
