// Work that overlaps, stops, dies or is refused, and what stays on the page.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { example, explorer, field, READY, SETTLED } from "./harness.mjs";
import { matrix } from "./files.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const SAVES = ["save-csv", "save-svg", "save-values"];
const dimmed = () => page.run(`return getComputedStyle(document.getElementById("answers")).opacity < 0.5`);
const pressures = () => page.run(`return [...document.querySelectorAll("#solved thead [data-pressure]")].map(({ dataset }) => Number(dataset.pressure))`);
const made = async (side, shortest) => {
  await page.change(["#random-pixels", side], ["#random-shortest", shortest]);
  await page.run(`document.getElementById("make-random").click()`);
  await page.browser.until(`return document.getElementById("elements-note").textContent.includes(${side})`, `${side} pixels`);
  await page.browser.until(SETTLED);
};

test("edits are kept", async () => {
  await page.run(`document.getElementById("solve").click()`);
  assert.equal(await page.phase(), "busy");
  await page.run(`const area = document.querySelector("[data-path=nominal_area]"); area.focus(); area.value = "3 m";
    area.dispatchEvent(new Event("input", { bubbles: true }))`);
  await page.change(["#load", "100 N"], ["#load", "321 N"], ["#view", "tangent"]);
  assert.deepEqual([await page.run(`return document.getElementById("load").dataset.newtons`), await page.value("field-nominal-area")], ["321", "3 m"]);
  await page.change([field("nominal_area"), "3 cm2"], [field("body[1].youngs_modulus"), "190 GPa"], [field("body[1].poissons_ratio"), "0.29"]);
  const scene = await page.value("scene");
  for (const wanted of ["3 cm2", "190 GPa", "0.29"]) assert.ok(scene.includes(wanted), wanted);
});

test("solutions come back", async () => {
  await page.change(["#example", "made-here"]);
  await page.opened();
  await page.browser.until(SETTLED);
  const solved = await pressures();
  assert.deepEqual(solved, [...solved].sort((a, b) => a - b));
  await page.change(["#load", "3 MPa"]);
  await page.change([field("nominal_area"), "2 cm2"]);
  assert.deepEqual([await page.run(`return document.getElementById("solved").hidden`), await page.cell("bem", "tangent")], [true, {}]);
  await page.run(`history.back()`);
  await page.browser.until(`return !document.getElementById("scene").value.includes("2 cm2")`);
  await page.browser.until(SETTLED);
  assert.deepEqual(await pressures(), solved);
  assert.equal((await page.all("#contact image")).length, 1);
});

test("solutions stop", async () => {
  await made("1024", "2 um");
  await page.run(`document.getElementById("solve").click()`);
  await page.browser.until(`return document.getElementById("iterations").textContent.includes("iteration")`, "progress");
  const took = await page.browser.later(`const start = performance.now();
    document.getElementById("stop").click();
    while (document.documentElement.dataset.state === "busy") await new Promise((done) => setTimeout(done));
    return performance.now() - start`);
  assert.ok(took < 200, `${took} ms`);
  await made("128", "12.5 um");
  await page.run(`document.getElementById("solve").click()`);
  await page.opened();
});

test("slow models follow", async () => {
  await page.scene(example("wheel-rail"));
  await page.choose(["gw", "ke", "at"]);
  const models = new Set(await page.run(`return [...document.querySelectorAll("#answers [data-value]")].map(({ dataset }) => dataset.model)`));
  assert.ok(models.has("ke") && models.has("at"));
});

test("refused loads dim", async () => {
  for (const models of [["gw", "ke"], ["gao"]]) {
    await page.choose(models);
    await page.change(["#load", "100 N"]);
    const values = await page.values();
    for (const load of ["-5 N", "5 kg"]) {
      await page.change(["#load", load]);
      assert.deepEqual([await page.phase(), await page.value("load"), await dimmed(), (await page.text("load-error")) !== ""], ["failed", load, true, true]);
      assert.deepEqual([await page.values(), ...(await page.disabled("copy-link", ...SAVES))], [values, true, true, true, true]);
    }
    await page.change(["#load", "200 N"]);
    assert.deepEqual([await page.phase(), await page.text("load-error"), await dimmed()], ["ready", "", false]);
  }
});

test("impossible results", async () => {
  await page.scene(example("elastomer-on-glass"));
  await page.choose(["gw", "persson-fudge"]);
  await page.change(["#load", "1.5 MPa"]);
  assert.deepEqual([await page.all("#answers tr.marked td"), await page.text("load-error")].map((one) => one.length), [1, 0]);
  await page.change(["#load", "1e30 N"]);
  assert.equal(await page.run(`return document.getElementById("load").getAttribute("aria-invalid")`), "true");
  await page.change(["#load", "1 kPa"]);
  assert.deepEqual([(await page.all("#answers tr.marked")).length, await page.text("load-error")], [0, ""]);
});

test("errors leave nothing", async () => {
  await page.scene(example("wheel-rail"));
  await page.choose(["gw", "ke"]);
  assert.notEqual(await page.text("spoken"), "");
  await page.scene(example("wheel-rail").replace(/youngs_modulus = .*/, 'youngs_modulus = "210 mm"'));
  assert.deepEqual([await page.phase(), await page.text("spoken"), (await page.all("#curve svg, #answers [data-value]")).length], ["failed", "", 0]);
  assert.ok(!(await page.disabled(...SAVES, "solve")).includes(false));
  assert.deepEqual(await page.all("[aria-invalid=true]", "id"), ["field-body-1-youngs-modulus", "scene"]);
  const line = 1 + example("wheel-rail").split("\n").findIndex((line) => line.startsWith("youngs_modulus"));
  assert.deepEqual(await page.all("#lines b"), [String(line)]);
  // A number that cannot be meant dims what follows from it.
  await page.scene(example("wheel-rail").replace(/youngs_modulus = .*/, "youngs_modulus = 210"));
  assert.deepEqual([await page.phase(), await dimmed(), ...(await page.disabled(...SAVES))], ["ready", true, true, true, true]);
  assert.notEqual(await page.text("field-body-1-youngs-modulus-note"), "");
  await page.scene(example("wheel-rail"));
  assert.deepEqual([await page.phase(), await dimmed(), ...(await page.disabled(...SAVES))], ["ready", false, false, false, false]);
});

test("missing curves", async () => {
  await page.choose(["persson-fudge"]);
  await page.change(["#view", "unloading-stiffness"]);
  assert.deepEqual([(await page.all("#curve svg")).length, (await page.all("#curve .none")).length, ...(await page.disabled("save-svg"))], [0, 1, true]);
  await page.choose(["ke"]);
  assert.deepEqual([(await page.all("#curve svg")).length, ...(await page.disabled("save-svg"))], [1, false]);
});

test("offline", async () => {
  await page.browser.cdp("Network.enable", {});
  const offline = (offline) => page.browser.cdp("Network.emulateNetworkConditions", { offline, latency: 0, downloadThroughput: -1, uploadThroughput: -1 });
  await offline(true);
  await page.change(["#example", "bolted-joint"]);
  await offline(false);
  assert.notEqual(await page.text("message"), "");
  assert.match((await page.browser.errors()).join(), /ERR_INTERNET_DISCONNECTED/);
});

test("scans are solved", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("few.txt", matrix({ missing: 2 }));
  assert.deepEqual(await page.disabled("solve"), [true]);
  await page.run(`document.querySelector("#contact button").click()`);
  await page.browser.until(READY);
  assert.deepEqual(await page.disabled("solve"), [false]);
  await page.change(["#load", "60 N"]);
  await page.click("leaks");
  await page.click("add-seal");
  // Helium instead of the first of the list.
  await page.change(["#field-seal-gas", "helium"], ["#field-seal-width", "300 mm"]);
  assert.match(await page.value("scene"), /\[seal\][^[]*width = "300 mm"[^[]*gas = "helium"/s);
  await page.click("solve-load");
  await page.browser.until(`return document.querySelector("#solved [data-quantity=leak-x]")`, "a leak");
  // mbar l/s are R T times kg/s.
  const [solved] = await page.solved();
  for (const way of ["x", "y"]) assert.ok(Math.abs(solved[`leak-${way}-mbar-l-per-s`] / (solved[`leak-${way}`] * 10 * 2077.264 * 293.15) - 1) < 1e-5);
  assert.equal((await page.all("#solved button")).length, 2);
  await page.change(["#field-seal-length", "2 mPa"]);
  assert.deepEqual(await page.all("#fluid [aria-invalid=true]", "id"), ["field-seal-length"]);
});

// A fresh page in which a script runs before all others.
async function opened(script, check, phase) {
  const other = await explorer({ script });
  try {
    assert.equal(await other.phase(), phase);
    await check(other);
  } finally {
    await other.close();
  }
}

test("old browsers", async () => {
  for (const script of ["delete window.WebAssembly;", "WebAssembly.validate = () => false;"]) {
    await opened(script, async (other) => assert.notEqual(await other.text("message"), ""), "failed");
  }
});

test("workers start anew", async () => {
  const missing = `window.started = 0; const Real = Worker; window.Worker = class extends Real {
    constructor() { super("missing.js"); window.started += 1; } };`;
  await opened(missing, async (other) => {
    assert.equal(await other.run(`return window.started`), 3);
    await other.scene("# mine");
    assert.deepEqual([await other.phase(), await other.value("scene")], ["failed", "# mine"]);
  }, "failed");
  const counted = `window.workers = []; const Real = Worker; window.Worker = class extends Real { constructor(...given) { super(...given); window.workers.push(this); } };`;
  await opened(counted, async (other) => {
    await other.run(`const load = document.getElementById("load"); load.value = "77 N"; load.dispatchEvent(new Event("change", { bubbles: true }));
      window.workers[0].onmessage({ data: { id: 0, died: "unreachable" } })`);
    await other.browser.until(`return document.documentElement.dataset.state === "ready" && document.getElementById("load").dataset.newtons === "77"`, "the answer");
    assert.equal(await other.text("message"), "");
  }, "ready");
});
