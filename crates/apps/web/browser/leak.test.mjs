// Leaks through the gap of a solved contact: those of the program, and the flow of a fluid.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { filesOf, nanometres } from "./files.mjs";
import { example, explorer, program, SETTLED } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const heads = () => page.run("return [...document.querySelectorAll('#solved tbody th')].map((head) => head.textContent)");
const click = (id) => page.run("document.getElementById(arguments[0]).click()", id);
const leak = () => page.run(`return ["viscosity", "pressure_drop"].map((key) => {
  const field = document.getElementById("leak-" + key);
  return [field.value, field.getAttribute("aria-invalid"), document.getElementById(field.id + "-note").textContent];
})`);
// Solves the load of the page, and its map of the flow, if leaks are asked for.
async function solve(load) {
  await page.change(["#load", load]);
  await click("solve-load");
  await page.browser.until("return document.documentElement.dataset.elements === 'ready' && document.querySelector('#answers [data-model=bem]')", load);
  await page.browser.until(SETTLED);
}

test("unasked, there are no leaks", async () => {
  const [name, bytes] = filesOf(nanometres()).find(([name]) => name === "scan.x3p");
  await page.scene(example("wheel-rail"));
  await page.file(name, bytes);
  await solve("30 N");
  assert.deepEqual((await heads()).filter((head) => /gap|flow/.test(head)), ["mean gap", "mean open gap"]);
  assert.equal(await page.run("return document.getElementById('fluid').hidden"), true);
});

test("gaps are those of the program within 1e-6, and the flow follows the fluid", { skip: !program }, async () => {
  await click("leaks");
  await solve("60 N");
  assert.match((await heads()).join(), /hydraulic gap along x,hydraulic gap along y,hydraulic gap of the effective medium,map,map of the flow$/);
  await page.change(["#leak-viscosity", "2 mPa s"], ["#leak-pressure_drop", "3 bar"]);
  const path = join(page.scratch, "scene.toml");
  writeFileSync(path, await page.value("scene"));
  const solved = (await page.solved()).at(-1);
  const fluid = ["--viscosity", "2 mPa s", "--pressure-drop", "3bar", "--quantity", "effective-medium-gap"];
  const { stdout, stderr } = spawnSync(program, ["bem", path, "--pressure", String(solved.pressure), ...fluid, "--format", "json"], { encoding: "utf8" });
  const [row] = JSON.parse(stdout || `"${stderr}"`);
  for (const [quantity, column] of [["hydraulic-gap-x", "hydraulic_gap_x_m"], ["hydraulic-gap-y", "hydraulic_gap_y_m"], ["effective-medium-gap", "effective_medium_gap_m"], ["flow-x", "flow_x_m3_per_s"], ["flow-y", "flow_y_m3_per_s"]]) {
    assert.ok(Math.abs(solved[quantity] / row[column] - 1) < 1e-6, `${quantity}: ${solved[quantity]}, the program: ${row[column]}`);
  }
  // A square: h³ Δp/(12 μ).
  for (const way of ["x", "y"]) assert.ok(Math.abs(solved[`flow-${way}`] / (solved[`hydraulic-gap-${way}`] ** 3 * 3e5 / 24e-3) - 1) < 1e-13);
  // The load before has the gaps of no solution, and says so.
  assert.match(await page.run("return document.querySelector('#solved [data-quantity=hydraulic-gap-x]').parentElement.cells[1].title"), /^not solved; move to this load/);
  await page.run("[...document.querySelectorAll('#solved button')].at(-1).click()");
  assert.match(await page.text("contact-reading"), /: flow from left to right through the gap$/);
});

test("a wrong fluid is refused at its field, and has no flow", async () => {
  const [viscosity, drop] = [["2 mPa s", "false", ""], ["3 bar", "false", ""]];
  assert.deepEqual(await leak(), [viscosity, drop]);
  for (const [key, typed, wanted] of [["viscosity", "46 cSt", /"46 cSt" is a kinematic viscosity: multiply it by the density/], ["viscosity", "20", /^20 has no unit: write 1 mPa s, for example$/],
    ["viscosity", "-2 mPa s", /a number above 0 was required/], ["pressure_drop", "", /^a flow needs both: write 1 bar, for example$/]]) {
    await page.change([`#leak-${key}`, typed]);
    const found = await leak();
    const [of, other] = key === "viscosity" ? found : [found[1], found[0]];
    assert.deepEqual([of.slice(0, 2), other[1]], [[typed, "true"], "false"]);
    assert.match(of[2], wanted);
    assert.ok(!(await heads()).some((head) => /flow along/.test(head)) && (await page.text("message")) === "");
    await page.change(["#leak-viscosity", viscosity[0]], ["#leak-pressure_drop", drop[0]]);
  }
  assert.ok((await heads()).some((head) => /flow along/.test(head)));
});

test("a sealed contact has a note for each direction, and a link keeps the fluid", async () => {
  await solve("200 kN");
  assert.equal((await page.solved()).at(-1)["flow-x"], 0);
  for (const way of ["x", "y"]) assert.match(await page.text("solved-notes"), new RegExp(`no open path of pixels leads along ${way} with`));
  await page.browser.go(await page.run("return location.href"));
  await page.browser.call("POST", "/refresh", {});
  await page.browser.until(SETTLED);
  assert.deepEqual([(await leak())[0][0], await page.run("return document.getElementById('leaks').checked")], ["2 mPa s", true]);
});
