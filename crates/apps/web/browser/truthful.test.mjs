// What the page says follows what is on it: advice, impossible answers, what was done.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { example, explorer, SETTLED } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const field = (path) => `[data-path="${path}"]`;
const choose = (ids) => page.run("for (const box of document.querySelectorAll('#models input')) if (!box.disabled && box.checked !== arguments[0].includes(box.value)) box.click();", ids);
const click = async (id) => {
  await page.run("document.getElementById(arguments[0]).click()", id);
  await page.browser.until(SETTLED, id);
};
const lines = (list) => page.run("return [...document.querySelectorAll(arguments[0])].map((line) => line.textContent)", list);
const pressTry = async (k) => {
  await page.run("document.querySelectorAll('#tries button')[arguments[0]].click()", k);
  await page.browser.until(SETTLED, `try ${k}`);
};
const ticks = () => page.run("return [...document.querySelectorAll('#tries button')].map((button) => button.disabled)");
const KEYS = /\w+_fraction|\b[a-z]{2,}_[a-z_]{2,}/;

test("a place without values says why, and a button adds models that have them", async () => {
  await page.change(["#example", "ground-steel"]);
  await page.browser.until(SETTLED);
  await page.change(["#load", "20 kN"]);
  assert.match(String(await lines("#findings li")), /use ke or jg/);
  await choose(["persson-fudge"]);
  await page.change(["#view", "unloading-stiffness"]);
  assert.match(await page.text("curve"), /persson-fudge has no unloading stiffness here: choose other models/);
  assert.ok(await page.run("return document.getElementById('save-svg').disabled"));
  await choose([]);
  await page.browser.until(SETTLED);
  assert.match(await page.text("curve"), /no model is chosen: choose models to see their unloading stiffness/);
  await choose(["ke-random"]);
  await page.browser.until(SETTLED);
  assert.match(await page.text("curve"), /^ke-random has no unloading stiffness here: .*; ke-random cannot give contact radii, which need asperities of one radius/);
  await pressTry(0);
  assert.equal((await ticks())[0], true);
  await page.change(["#example", "ground-steel"]);
  await choose(["gw", "ke", "jg", "persson-fudge"]);
});

test("a wrong unit of a field is not blamed on the load", async () => {
  await page.scene(example("wheel-rail").replace(/youngs_modulus = .*/, "youngs_modulus = 210"));
  await choose(["gw", "ke"]);
  assert.match(String(await lines("#findings li")), /210 looks like GPa/);
  assert.doesNotMatch(await page.text("load-error"), /no model describes this load/);
  assert.deepEqual(await lines("#answers tr.marked"), []);
});

test("values of another load are not saved", async () => {
  await page.scene(example("wheel-rail"));
  const disabled = () => page.run("return document.getElementById('save-values').disabled");
  assert.equal(await disabled(), false);
  await page.change(["#load", "1,5"]);
  assert.equal(await disabled(), true);
  await page.change(["#load", "1.5 MPa"]);
  assert.equal(await disabled(), false);
});

test("findings have the names of the table and no keys", async () => {
  await page.scene(example("elastomer-on-glass"));
  await choose(["gw", "persson"]);
  await page.change(["#load", "0.5 MPa"]);
  const findings = await lines("#findings li");
  assert.ok(findings.some((line) => /gw: the real area is 1\.346 times the nominal area/.test(line)), String(findings));
  assert.ok(findings.every((line) => !KEYS.test(line)), findings.join("\n"));
});

test("answers that no contact has are marked with their reason", async () => {
  await page.scene(example("elastomer-on-glass"));
  await choose(["gw", "persson-fudge"]);
  await page.change(["#load", "1.5 MPa"]);
  assert.deepEqual([await page.phase(), await page.text("load-error"), await page.text("status")], ["ready", "", "ready"]);
  const marks = await lines("#answers tr.marked");
  assert.equal(marks.length, 1);
  assert.match(marks[0], /⚠ gw: impossible result: .*the real area is 2\.8\d* times the nominal area/);
  await page.change(["#load", "1e30 N"]);
  assert.match(String(await lines("#answers tr.marked")), /persson-fudge: impossible result: .*the mean pressure on the real area is 1e34 Pa, above the equivalent modulus \(2\.667e6 Pa\)/);
  assert.match(await page.text("load-error"), /^no model describes this load: /);
  assert.equal(await page.run("return document.getElementById('load').getAttribute('aria-invalid')"), "true");
  assert.equal(await page.text("status"), "no model describes the load");
  await page.change(["#load", "1 kPa"]);
  assert.deepEqual([await page.text("load-error"), await page.text("status"), await lines("#answers tr.marked")], ["", "ready", []]);
});

test("refusals have at most five digits, the unit of their box and no command of a shell", async () => {
  await page.scene(example("wheel-rail"));
  await choose(["gw", "ke"]);
  await page.change(["#load", "1e30 N"]);
  const refused = await page.text("load-error");
  const digits = (number) => number.replaceAll(/e.*|\D/g, "").replaceAll(/^0+|0+$/g, "").length;
  assert.ok((refused.match(/\d[\d.e+-]*/g) ?? []).every((number) => digits(number) <= 5), refused);
  await page.change(["#load", "1 MPa"], ["#unit", "Pa"], ["#load", "1 kip"]);
  assert.match(await page.text("load-error"), /neither a load nor a pressure/);
  await page.change(["#load", "1 MPa"]);
  await page.scene(example("wheel-rail").replace(/youngs_modulus = .*/, 'material = "unobtainium"'));
  const error = await page.text("scene-error");
  assert.match(error, /material/);
  assert.doesNotMatch(error, /asperity materials/);
});

test("where jkr pulls off, the page names the model of opening as the program does", async () => {
  await page.scene(example("elastomer-on-glass").replace("rigid_", "work_of_adhesion = 0.05\nrigid_"));
  await choose(["jkr"]);
  await page.change(["#load", "-1 N"]);
  assert.match(await page.text("load-error"), /pull off at .*; jkr-separation, which describes opening, may carry more/);
});

test("a stopped solution says which loads are solved and which are missing", async () => {
  const make = (side, shortest) => page.run(`document.getElementById('random-pixels').value = arguments[0];
    document.getElementById('random-shortest').value = arguments[1]; document.getElementById('make-random').click()`, side, shortest);
  await page.change(["#example", "made-here"]);
  await make("1024", "2 um");
  await page.browser.until("return document.getElementById('elements-note').textContent.includes('1024')", "a surface of 1024 pixels");
  await page.browser.until(SETTLED);
  await page.change(["#load", "123 N"]);
  await page.run("document.getElementById('solve').click()");
  await page.browser.until("return !document.getElementById('solved').hidden", "a solved load", 60);
  await click("stop");
  // The load of the page is solved before all others, and the lists are in the order of the loads.
  assert.match(await page.text("iterations"), /^stopped: solved 123 N/);
  assert.ok(await page.run("return Boolean(document.querySelector('#answers [data-model=bem]'))"));
  const order = await page.run("return [...document.querySelectorAll('#solved thead [data-pressure]')].map((head) => Number(head.dataset.pressure))");
  assert.deepEqual(order, [...order].sort((a, b) => a - b));
  const [, solved, missing] = (await page.text("iterations")).match(/^stopped: solved (.+); missing (.+)$/);
  const there = await page.run("return [...document.querySelectorAll('#solved thead [data-pressure]')].length");
  const all = [...solved.split(", "), ...missing.split(", ")];
  assert.deepEqual([solved.split(", ").length, new Set(all).size], [there, all.length]);
  assert.ok(all.length >= 6 && all.every((load) => /^[\d.]+ [mkM]?N$/.test(load)), all.join());
});

test("what to try is ticked where the page shows it already", async () => {
  await page.change(["#example", "bolted-joint"]);
  assert.deepEqual(await ticks(), [false, false, false]);
  await pressTry(1);
  assert.deepEqual(await ticks(), [false, true, false]);
  assert.match(await page.text("tries"), /Show the tangential stiffness ✓ on the page/);
  await page.change(["#view", "tangent"]);
  assert.deepEqual(await ticks(), [false, false, false]);
  await pressTry(0);
  await pressTry(2);
  assert.deepEqual(await ticks(), [true, false, true]);
});

test("boundary elements and models have one name, and variants their own sentence", async () => {
  await page.change(["#example", "ground-steel"]);
  await choose(["ke-random"]);
  await page.browser.until(SETTLED);
  const titles = await page.run("return Object.fromEntries([...document.querySelectorAll('#models label')].map((label) => [label.textContent.trim(), label.title]))");
  for (const id of ["persson-fudge", "ke-random", "at-additive", "at-overlap", "jg-cosine-random"]) assert.ok(id in titles, `${id}: ${Object.keys(titles)}`);
  assert.match(titles["ke-random"], /^ke-random: Kogut & Etsion \(2002\); averaged over asperities whose heights and radii differ/);
  assert.equal(await page.run("return document.querySelector('#answers tbody th:first-child[title^=\"ke-random\"]').textContent"), "ke-random");
  await page.change(["#example", "made-here"]);
  await page.browser.until("return document.querySelector('#answers [data-model=bem]')", "the solved load", 60);
  assert.deepEqual([(await lines("#answers tbody th")).at(-1), /boundary elements/.test(await page.text("curve"))], ["boundary elements", true]);
});

test("a changed example no longer has its description", async () => {
  await page.change(["#example", "made-here"]);
  assert.match(await page.value("scene"), /^# Ground steel on a flat [^]*# ground steel, hardened/);
  await page.change(["#material-2", "copper-cold-worked"]);
  assert.match(await page.value("scene"), /^# Changed from: Ground steel on a flat/);
  await page.change([field("body[1].hardness"), "6 GPa"]);
  const scene = await page.value("scene");
  assert.doesNotMatch(scene, /hardened steel/);
  assert.equal(scene.match(/Changed from/g).length, 1);
});

test("the answer of the scene before is dimmed as soon as another is opened, and is not read out", async () => {
  await page.scene(example("wheel-rail"));
  const now = () => page.run("return [document.documentElement.hasAttribute('data-stale'), document.getElementById('spoken').textContent]");
  assert.match((await now())[1], /^At .*real area/);
  const opened = await page.run(`const field = document.getElementById("example");
    field.value = "made-here";
    field.dispatchEvent(new Event("change", { bubbles: true }));
    return [document.documentElement.hasAttribute("data-stale"), getComputedStyle(document.querySelector("#answer dl")).opacity, document.getElementById("spoken").textContent]`);
  assert.deepEqual(opened, [true, "0.4", ""]);
  await page.browser.until(SETTLED);
  assert.equal((await now())[0], false);
  assert.match((await now())[1], /^At /);
  await page.scene("nominal_area = ");
  assert.deepEqual(await now(), [false, ""]);
  await page.scene(example("wheel-rail"));
  await page.change(["#load", "0,3 N"]);
  assert.deepEqual(await now(), [true, ""]);
  assert.equal(await page.text("load-other"), "");
  await page.change(["#load", "3 N"]);
  assert.match((await now())[1], /^At 3 N/);
  assert.match(await page.text("load-other"), /Pa$/);
});

test("psi is a unit behind a number", async () => {
  await page.scene(example("wheel-rail"));
  await page.change(["[data-path='body[1].youngs_modulus']", "30e6 psi"]);
  assert.match(await page.text("inputs"), /30e6 psi is [\d.e]+ [kG]Pa/);
  assert.doesNotMatch(await page.text("inputs"), /30e6 ψ/);
});
