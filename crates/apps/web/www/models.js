// The law of every model, drawn for the asperity of a scene: that of the link, or the ground steel.
import { $, element, lacking, lowered, picture, readings, tell } from "./page.js";
import { Desk } from "./desk.js";

const EXAMPLE = "examples/ground-steel.toml";

function say(phase, text) {
  document.documentElement.dataset.state = phase;
  $("status").textContent = text;
}

async function sceneText(desk) {
  if (!location.hash.startsWith("#s=")) return (await fetch(EXAMPLE)).text();
  const { scene, random, scan } = await desk.call("unlink", { link: location.hash.slice(3) });
  if (random && scan) desk.files.set(scan.name, { keys: random });
  $("back").href = `index.html${location.hash}`;
  return scene;
}

// The equations of a model with their symbols and units, as its page of the guide has them, if the
// guide stands beside this page.
async function equations(address) {
  const box = element("details", {}, element("summary", {}, "Equations"));
  const response = await fetch(address);
  const page = new DOMParser().parseFromString(response.ok ? await response.text() : "", "text/html");
  for (let part = page.getElementById("law")?.nextElementSibling; part && part.tagName !== "H2"; part = part.nextElementSibling) {
    if (part.matches(".highlight")) box.append(element("pre", { className: "wide" }, part.textContent.trimEnd()));
  }
  box.hidden = box.children.length === 1;
  return box;
}

async function card(desk, text, { id, name }) {
  const figure = element("figure", { className: "plot" });
  const about = element("p", { className: "source" }, "being drawn");
  const reading = element("output", { className: "reading-line" });
  reading.setAttribute("aria-label", `values of ${name} under the pointer`);
  readings(figure, reading);
  const box = element("section", { id, data: { model: id } }, element("h2", {}, name), about, figure, reading);
  $("laws").append(box);
  try {
    const { svg, source, kinks, axis, range, guide, asperity } = await desk.ask(text, "law", { model: id });
    const words = [`${source}.`, range && `Range: ${range}.`, kinks.length > 0 && `Kinks or jumps at ${kinks.join(", ")} (${axis}).`];
    about.replaceChildren(...lowered(`${words.filter(Boolean).join(" ")} `), element("a", { href: guide }, "Range, errors and source"));
    figure.before(await equations(guide));
    $("asperity").replaceChildren(...lowered(asperity));
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
    tell(lacking() || error.message);
  }
}

start();
