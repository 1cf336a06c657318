// What was refused says why at its place, and what was there before stays.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { example, explorer, program, SETTLED } from "./harness.mjs";
import { matrix, nanometres } from "./files.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const field = (path) => `[data-path="${path}"]`;
const note = (path) => page.run(`const field = document.querySelector(arguments[0]); return document.getElementById(field.id + "-note").textContent`, field(path));
const opacity = (selector) => page.run("return getComputedStyle(document.querySelector(arguments[0])).opacity", selector);
const choose = (ids) => page.run("for (const box of document.querySelectorAll('#models input')) if (!box.disabled && box.checked !== arguments[0].includes(box.value)) box.click();", ids);
const disabled = (...ids) => page.run("return arguments[0].map((id) => document.getElementById(id).disabled)", ids);
// A csv of the page among its downloads.
async function saved(name, button) {
  await page.run("document.getElementById(arguments[0]).click()", button);
  for (let k = 0; k < 50 && !readdirSync(page.scratch).includes(name); k++) await new Promise((resolve) => setTimeout(resolve, 100));
  return readFileSync(join(page.scratch, name), "utf8");
}

test("tables begin with a model that yields, then with the one that was ticked last", async () => {
  const first = async () => [await page.value("export-model"), await page.value("law-model")];
  assert.deepEqual(await first(), ["ke", "ke"]);
  await page.run("document.querySelector('#models [value=af]').click()");
  await page.browser.until(SETTLED);
  assert.deepEqual(await first(), ["af", "af"]);
});

test("a refused load has its reason at the field, and the values before are dimmed", async () => {
  await page.scene(example("wheel-rail"));
  await choose(["gw", "ke"]);
  await page.change(["#load", "100 N"]);
  const before = await page.values();
  for (const [load, wanted] of [["-5", /^load is -5 N: models without adhesion carry no tension; add work_of_adhesion in the scene file and choose dmt, jkr/], ["5 kg", /"5 kg" is neither a load nor a pressure: write 2 kN or 5 MPa, for example/], ["0", /0 is neither a load/], ["1e30", /largest force of the model/], ["0,3 N", /decimal comma; write 0\.3/], ["3 mm", /neither a load nor a pressure/]]) {
    await page.change(["#load", load]);
    assert.match(await page.text("load-error"), wanted);
    assert.deepEqual([await page.phase(), await page.text("status")], ["failed", "the load is refused"], load);
    assert.deepEqual([await page.values(), await page.value("load")], [before, load]);
    assert.ok((await opacity("#answers")) < 0.5 && (await opacity("#curve")) < 0.5);
    assert.deepEqual(await disabled("save-csv", "save-svg", "save-values"), [true, true, true], load);
  }
  await page.change(["#load", "200 N"]);
  assert.deepEqual([await page.phase(), await page.text("load-error"), await opacity("#answers")], ["ready", "", "1"]);
  assert.deepEqual(await disabled("save-csv", "save-svg", "save-values"), [false, false, false]);
});

test("a load that slow models refuse with the others is refused, and the values before come back", async () => {
  await page.scene(example("wheel-rail"));
  for (const [ids, load, reason] of [[["gw", "gao"], "1e20 N", /largest force of the model/], [["gao"], "-5", /carry no tension/]]) {
    await choose(ids);
    await page.change(["#load", "100 N"]);
    const before = await page.values();
    await page.change(["#load", load]);
    assert.match(await page.text("load-error"), reason);
    assert.deepEqual([await page.phase(), await page.text("status")], ["failed", "the load is refused"], load);
    assert.deepEqual([await page.values(), parseFloat(await page.value("load"))], [before, parseFloat(load)]);
    assert.ok((await opacity("#answers")) < 0.5 && !/…/.test(await page.text("answers")));
  }
  await page.change(["#load", "200 N"]);
  assert.deepEqual([await page.phase(), await page.text("load-error"), await opacity("#answers")], ["ready", "", "1"]);
});

test("a tension beyond the pull-off has the reason of each model, and models with adhesion answer a refused one", async () => {
  await page.scene(example("elastomer-on-glass").replace("rigid_", "work_of_adhesion = 0.05\nrigid_"));
  await choose(["dmt", "jkr"]);
  await page.change(["#load", "-1 N"]);
  assert.match(await page.text("load-error"), /^dmt: load is -1\.0 N: the surfaces pull off at -0\.\d+ N.*; jkr: load is -1\.0 N: the surfaces pull off at -0\./);
  await page.change(["#load", "10 mN"]);
  await choose(["gw"]);
  await page.change(["#load", "-1 mN"]);
  assert.match(await page.text("load-error"), /models without adhesion carry no tension/);
  await choose(["gw", "dmt"]);
  await page.browser.until(SETTLED);
  assert.deepEqual([await page.phase(), await page.text("load-error"), await page.value("load")], ["ready", "", "-1 mN"]);
});

test("a model that alone refuses a load says why in its row", async () => {
  await page.scene(example("elastomer-on-glass").replace("rigid_", "work_of_adhesion = 0.05\nrigid_"));
  await choose(["gw", "dmt"]);
  await page.change(["#load", "-1 mN"]);
  assert.equal(await page.phase(), "ready");
  assert.match(await page.run("return document.querySelector('#answers td.reason').textContent"), /load is -1 mN: models without adhesion/);
  assert.ok(await page.run("return Boolean(document.querySelector('#answers [data-model=dmt][data-value]'))"));
});

test("an unreadable file leaves the scan of the scene where it is", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("good.txt", matrix(nanometres()));
  const [text, values] = [await page.value("scene"), await page.values()];
  mkdirSync(join(page.scratch, "other"));
  for (const name of ["torn.x3p", "other/good.txt"]) {
    await page.file(name, "PK\u0003\u0004 nothing \u0000");
    assert.match(await page.text("message"), /^(torn\.x3p|good\.txt): /);
    assert.deepEqual([await page.phase(), await page.value("scene")], ["ready", text], name);
    await page.change(["#load", "7 N"], ["#load", "5 kN"]);
  }
  await page.scene(text);
  await page.change(["#load", await page.value("load")]);
  assert.deepEqual(Object.keys(await page.values()), Object.keys(values));
});

test("a file that cannot be used gives the last working scan back, with the newest error alone", async () => {
  const flat = matrix(nanometres()).replaceAll(/^-?\d.*$/gm, (row) => row.replaceAll(/-?\d+/g, "5"));
  for (const bad of [["flat.txt", flat, /flat\.txt: the \d+ heights are all equal/], ["photo.jpg", Buffer.from("\xff\xd8\xff\xe0 JFIF", "latin1"), /photo\.jpg: the file is a picture \(JPEG\): a map of heights was required, as csv/]]) {
    await page.scene(example("wheel-rail"));
    await page.file("good.txt", matrix(nanometres()));
    const kept = async () => [await page.phase(), await page.value("scene"), await page.values(), await page.text("scene-error"), await note("surface.file")];
    const working = await kept();
    assert.equal(working[0], "ready");
    const [name, bytes, wanted] = bad;
    await page.file(name, bytes);
    assert.match(await page.text("message"), wanted);
    assert.deepEqual(await kept(), working, name);
    // A file whose unit is still to be given, and then one that no key makes usable.
    await page.file("bare.csv", "1;2;4;3\n2;1;5;2\n".repeat(8));
    assert.deepEqual([await page.phase(), /unit/.test(await page.text("scene-error"))], ["failed", true]);
    await page.file(name, bytes);
    await page.browser.until("return document.getElementById('message').textContent !== ''", "the newest error", 20);
    assert.match(await page.text("message"), wanted);
    assert.deepEqual(await kept(), working, name);
  }
});

test("a decimal comma of a pixel size is reported at its field and at its line", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("bare.csv", "1;2;4;3\n2;1;5;2\n".repeat(8));
  await page.change([field("surface.unit"), "um"], [field("surface.pixel_size"), "1,5 um"]);
  assert.equal(await note("surface.pixel_size"), "Pixel size: 1,5 um has a decimal comma; write 1.5 um");
  assert.match(await page.text("scene-error"), /pixel_size = "1,5 um" has a decimal comma; write 1\.5 um$/);
});

test("a scan much smaller than the nominal area has a note", async () => {
  await page.scene(example("wheel-rail"));
  const rows = Array.from({ length: 64 }, (_, y) => Array.from({ length: 64 }, (_, x) => Math.round(1000 * (Math.sin(0.11 * x) + Math.cos(0.1 * y)) + 40 * Math.sin(2.1 * x + 1.3 * y))).join("\t")).join("\n");
  await page.file("small.txt", rows);
  await page.scene((await page.value("scene")).replace('file = "small.txt"', 'file = "small.txt"\nunit = "nm"\npixel_size = "0.5 um"'));
  const small = async () => (await page.run("return [...document.querySelectorAll('#findings li')].map((line) => line.textContent)")).filter((line) => /times the area of the scan/.test(line));
  assert.equal((await small()).length, 1, await page.text("findings"));
  assert.match((await small())[0], /^note: nominal area is .* times the area of the scan, and half of Sq² lies in waves longer than .* measure a larger scan$/);
  await page.change([field("nominal_area"), "0.01 mm2"]);
  assert.deepEqual(await small(), []);
});

const masked = (columns) => matrix(nanometres()).replaceAll(new RegExp(`^(-?\\d+\t){${columns}}`, "gm"), "nan\t".repeat(columns));

test("missing points are left out in one click, and a scan of which most are missing is refused", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("whole.txt", matrix(nanometres()));
  const kept = [await page.value("scene"), await page.values()];
  await page.file("most.txt", masked(57));
  assert.match(await page.text("message"), /^most\.txt: 89\.06 % of the points are missing, and the others do not describe the surface: measure again/);
  assert.deepEqual([await page.value("scene"), await page.values(), await page.phase()], [...kept, "ready"]);
  assert.equal(await page.run("return document.querySelectorAll('#message button').length"), 1);
  await page.file("masked.txt", masked(20));
  assert.match(await page.text("message"), /masked\.txt: 31\.25 % of the points are missing, and 10 % are usual/);
  await page.run("document.querySelector('#message button').click()");
  await page.browser.until(SETTLED);
  assert.deepEqual([await page.phase(), await page.text("scene-error"), await page.text("message")], ["ready", "", ""]);
  assert.match(await page.value("scene"), /max_missing = 0\.32/);
  assert.ok(Object.keys(await page.values()).length > 5);
  await page.file("whole.txt", matrix(nanometres()));
  assert.deepEqual([await page.value("scene"), await page.values()], kept);
});

test("boundary elements have few missing points filled in one click, and a message can be closed", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("few.txt", masked(2));
  for (const place of ["elements-note", "contact"]) {
    assert.equal(await page.text(place), "3.125 % of the points are missing, and boundary elements need all Fill the missing points");
  }
  await page.run("document.querySelector('#contact button').click()");
  await page.browser.until(SETTLED);
  assert.deepEqual([await page.phase(), await page.text("elements-note")], ["ready", "64 × 64 pixels, solved in this tab."]);
  await page.file("torn.x3p", "PK\u0003\u0004 nothing \u0000");
  assert.match(await page.text("message"), /^torn\.x3p/);
  await page.run("document.querySelector('#message button').click()");
  assert.equal(await page.run("return document.getElementById('message').hidden"), true);
});

test("values of an implausible number are dimmed, and a link of a refused load is not given", async () => {
  const dimmed = () => page.run("return getComputedStyle(document.getElementById('answers')).opacity");
  await page.scene(example("wheel-rail"));
  assert.equal(await dimmed(), "1");
  await page.change([field("body[1].youngs_modulus"), "210"]);
  assert.deepEqual([await dimmed(), await page.text("status")], ["0.4", "implausible number"]);
  assert.deepEqual(await disabled("save-csv", "save-svg", "save-values"), [true, true, true]);
  await page.change([field("body[1].youngs_modulus"), "210 GPa"]);
  assert.deepEqual([await dimmed(), await page.text("status")], ["1", "ready"]);
  const link = () => page.run("return document.getElementById('copy-link').disabled");
  await page.change(["#load", "1,5 kN"]);
  assert.equal(await link(), true);
  await page.change(["#load", "1.5 kN"]);
  assert.equal(await link(), false);
});

test("the message of a field has its name and the value, and no line", async () => {
  await page.scene(example("wheel-rail"));
  for (const [path, typed, wanted] of [
    ["body[1].poissons_ratio", "0,3", "Poisson's ratio ν: 0,3 has a decimal comma; write 0.3"],
    ["body[1].youngs_modulus", "210,000 MPa", "Young's modulus E: 210,000 MPa is ambiguous; write 210.000 MPa or 210000 MPa"],
    ["body[1].hardness", "-5", "Hardness H: -5.0: a finite number above 0 was required"],
  ]) {
    await page.change([field(path), typed]);
    assert.equal(await note(path), wanted);
    assert.equal(await page.phase(), "failed");
    await page.scene(example("wheel-rail"));
  }
  // What the program's check notes is there too.
  await page.change([field("nominal_area"), "1"]);
  assert.match(await note("nominal_area"), /nominal area is 1 m2 .*1 looks like mm2/);
  await page.change([field("nominal_area"), "1 cubit"]);
  assert.match(await note("nominal_area"), /units: m2, cm2, mm2/);
});

test("a link without its scan keeps load, models and quantity, and asks for the scan", async () => {
  await page.scene(example("wheel-rail"));
  await page.file("asked.txt", matrix(nanometres()));
  await choose(["ke", "jg"]);
  await page.change(["#load", "321 N"], ["#view", "tangent"]);
  const before = await page.values();
  await page.browser.go(await page.run("return location.href"));
  await page.browser.call("POST", "/refresh", {});
  await page.browser.until(SETTLED);
  assert.match(await page.text("message"), /made with the scan asked\.txt/);
  assert.deepEqual(
    [await page.phase(), await page.text("status"), await page.value("load"), await page.value("view"), await page.run("return document.querySelector('#model-box summary').textContent")],
    ["failed", "waiting for asked.txt", "321 N", "tangent", "Models: ke, jg"]);
  await page.file("asked.txt", matrix(nanometres()));
  assert.deepEqual([await page.phase(), await page.text("message"), await page.value("load")], ["ready", "", "321 N"]);
  assert.deepEqual(await page.values(), before);
});

test("boundary elements have stiffnesses beside the models', and the values are saved as shown", async () => {
  await page.change(["#example", "made-here"]);
  await page.browser.until("return document.querySelectorAll('#solved thead [data-pressure]').length >= 6", "solved loads");
  await page.browser.until(SETTLED);
  // The present load is among them.
  await page.browser.until("return document.querySelector('#answers [data-model=bem]')", "the row of boundary elements");
  await page.browser.until(SETTLED);
  const values = await page.values();
  for (const quantity of ["separation", "area-fraction", "tangent", "unloading-stiffness"]) {
    assert.ok(Number(values[`bem ${quantity}`][0]) > 0 && Number(values[`ke ${quantity}`][0]) > 0, quantity);
  }
  assert.ok(Number(values["bem unloading-stiffness"][0]) >= 0.98 * Number(values["bem tangent"][0]));
  await page.change(["#view", "tangent"]);
  assert.match(await page.text("curve"), /boundary elements/);
  const csv = await saved("values.csv", "save-values");
  const lines = csv.trim().split("\n").map((line) => line.split(","));
  const column = lines[0].findIndex((name) => name.startsWith("tangent"));
  assert.ok(lines.every((line) => line.length === lines[0].length), csv);
  assert.equal(lines.find(([model]) => model === "bem")[column], values["bem tangent"][0]);
  assert.equal(lines.find(([model]) => model === "ke")[column], values["ke tangent"][0]);
});

test("boundary elements' stiffnesses are those of the program", { skip: !program }, async () => {
  const solved = (await page.solved()).at(-1);
  await page.run("document.getElementById('save-scan').click()");
  const scene = await saved("scene.toml", "save-scene");
  assert.match(await page.text("scene-files"), /random-1\.x3p .* save them in one folder/);
  assert.doesNotMatch(scene, /stylus|asperity curve|m0/);
  for (let k = 0; k < 50 && !readdirSync(page.scratch).includes("random-1.x3p"); k++) await new Promise((resolve) => setTimeout(resolve, 100));
  const { stdout, stderr } = spawnSync(program, ["bem", join(page.scratch, "scene.toml"), "--pressure", String(solved.pressure), "--quantity", "tangent,unloading-stiffness", "--format", "json"], { encoding: "utf8" });
  const [row] = JSON.parse(stdout || `"${stderr}"`);
  assert.ok(Math.abs(solved["unloading-stiffness"] / row.unloading_stiffness_N_per_m - 1) < 1e-6, JSON.stringify(row));
  assert.ok(Math.abs(solved.tangent / row.tangent_N_per_m - 1) < 1e-3, JSON.stringify(row));
});

test("every example has something to try, and it works", async () => {
  for (const name of ["wheel-rail", "bolted-joint", "elastomer-on-glass", "lapped-seal", "ground-steel"]) {
    const count = await page.change(["#example", name]).then(() => page.run("return document.querySelectorAll('#tries button').length"));
    assert.ok(count >= 2, name);
    for (let k = 0; k < count; k++) {
      const words = await page.run("const button = document.querySelectorAll('#tries button')[arguments[0]]; button.click(); return button.textContent", k);
      await page.browser.until(SETTLED, words);
      assert.deepEqual([await page.phase(), await page.text("message"), await page.text("load-error")], ["ready", "", ""], `${name}: ${words}`);
    }
  }
});
