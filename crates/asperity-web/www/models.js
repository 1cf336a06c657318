// The law of every model, drawn for the asperity of a scene: that of the link, or the ground steel.
import { $, element, picture, tell } from "./page.js";
import { Desk } from "./desk.js";

const EXAMPLE = "examples/ground-steel.toml";

function say(phase, text) {
  document.documentElement.dataset.state = phase;
  $("status").textContent = text;
}

// Asperities of one radius: laws are of one asperity.
async function sceneText(desk) {
  const changes = [{ path: "surface.asperities", value: null }];
  return desk.call("edit", { text: await given(desk), changes });
}

async function given(desk) {
  if (!location.hash.startsWith("#s=")) return (await fetch(EXAMPLE)).text();
  const { scene, random, scan } = await desk.call("unlink", { link: location.hash.slice(3) });
  if (random && scan) desk.files.set(scan.name, { keys: random });
  $("back").href = `index.html${location.hash}`;
  return scene;
}

async function card(desk, text, { id, name }) {
  const figure = element("figure", { className: "plot" });
  const about = element("p", { className: "source" }, "being drawn");
  const box = element("section", { id, data: { model: id } }, element("h2", {}, name), about, figure);
  $("laws").append(box);
  try {
    const { svg, source, kinks, axis, range, guide } = await desk.ask(text, "law", { model: id });
    const words = [`${source}.`, range && `Range: ${range}.`, kinks.length > 0 && `Kinks or jumps at ${kinks.join(", ")} (${axis}).`];
    about.replaceChildren(`${words.filter(Boolean).join(" ")} `, element("a", { href: guide }, "Equations, range and source"));
    picture(figure, svg, `force and area of one asperity by ${name} against the interference`);
  } catch (error) {
    about.replaceChildren(error.message);
    figure.remove();
  }
}

async function start() {
  const desk = new Desk(new Map());
  try {
    const text = await desk.sure(() => sceneText(desk));
    const shown = await desk.sure(() => desk.show(text));
    if (shown.error) throw new Error(shown.error.message);
    say("busy", "drawing");
    // Whole-surface theories have no asperity; quick laws come first.
    const models = shown.models.filter(({ reason, whole }) => !reason && !whole);
    if (models.length === 0) throw new Error("no model of the scene has a law of one asperity");
    for (const slow of [false, true]) {
      for (const model of models.filter((one) => one.slow === slow)) await card(desk, text, model);
    }
    say("ready", "ready");
  } catch (error) {
    say("failed", "failed");
    tell(typeof WebAssembly === "object" ? error.message : "This browser has no WebAssembly: the guide shows the laws without it.");
  }
}

start();
