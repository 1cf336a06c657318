// Boundary elements in a worker of their own, load by load. Stopping ends the worker.
import { $, cell, element, picture, tell } from "./page.js";

const HEAD = ["load", "pressure", "area fraction", "mean gap", "plastic share", "patches"];

export class Elements {
  constructor(desk, changed) {
    Object.assign(this, { desk, changed, solved: [], shown: null, running: 0 });
    $("stop").addEventListener("click", () => this.stop());
  }

  // What the scene allows, after every change of it.
  allow(scan) {
    if (this.running) this.stop();
    this.clear();
    const refused = scan ? scan.refused : "They need the heights of a surface: drop a scan or make a random surface.";
    $("elements-note").textContent = refused ?? `${scan.rows} × ${scan.columns} pixels, solved in this tab.`;
    $("solve").disabled = $("solve-load").disabled = Boolean(refused);
  }

  clear() {
    this.solved = [];
    this.shown = null;
    $("contact").replaceChildren();
    $("solved").hidden = true;
    $("iterations").textContent = "";
  }

  async solve(pressures) {
    const run = ++this.running;
    this.busy(true);
    try {
      await this.desk.press(pressures, (event) => run === this.running && this.happened(event));
    } catch (error) {
      if (run === this.running && error.message !== "stopped") tell(error.message);
    }
    if (run === this.running) {
      this.running = 0;
      this.busy(false);
    }
  }

  stop() {
    this.running = 0;
    this.desk.restart("stopped");
    this.busy(false);
    $("iterations").textContent = "stopped";
  }

  busy(busy) {
    $("stop").hidden = $("progress").hidden = !busy;
    $("solve").disabled = $("solve-load").disabled = busy;
    document.documentElement.dataset.elements = busy ? "busy" : "ready";
    if (busy) $("iterations").textContent = "starting";
    else if ($("iterations").textContent !== "stopped") $("iterations").textContent = "";
  }

  happened(event) {
    if (event.event === "progress") {
      const { done, count, iterations, residual } = event;
      $("progress").max = count;
      $("progress").value = done;
      $("iterations").textContent = `load ${done} of ${count} done; iteration ${iterations}, residual ${residual.toExponential(0)}`;
    } else if (event.event === "failed") {
      tell(event.message);
    } else {
      this.solved = this.solved.filter(({ pressure }) => pressure !== event.pressure);
      this.solved.push(event);
      this.solved.sort((a, b) => a.pressure - b.pressure);
      this.showNear();
      this.table();
      this.changed();
    }
  }

  // The map at the present load, or at the next heavier one that is solved.
  showNear() {
    const present = Number($("load").dataset.pascals);
    const near = this.solved.find(({ pressure }) => pressure >= present) ?? this.solved.at(-1);
    if (near && near !== this.shown) this.show(near);
  }

  show(one) {
    const { svg, load } = one;
    this.shown = one;
    picture($("contact"), svg, `contact pressures at ${load}`);
  }

  table() {
    const table = $("solved");
    table.hidden = false;
    table.tHead.replaceChildren(element("tr", {}, ...HEAD.map((name) => element("th", { scope: "col" }, name)), element("th", {}, "map")));
    table.tBodies[0].replaceChildren(...this.solved.map((one) => {
      const row = element("tr", { data: { pressure: one.pressure } }, ...one.cells.map((value) => cell(value, "bem")));
      const button = element("button", { type: "button", onclick: () => this.show(one) }, "show");
      button.setAttribute("aria-label", `show the map at ${one.load}`);
      row.append(element("td", {}, button));
      return row;
    }));
  }

  // The points of a quantity that boundary elements give.
  points(view) {
    const of = { "area-fraction": "area", separation: "gap" }[view];
    return of ? this.solved.map((one) => [one.pressure, one[of]]) : [];
  }
}
