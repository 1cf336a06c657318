// What is given to the page: scene files, several files at once, units, and ways to go back.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { example, explorer, SETTLED } from "./harness.mjs";
import { matrix, nanometres } from "./files.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const field = (path) => `[data-path="${path}"]`;
const note = (path) => page.run(`const field = document.querySelector(arguments[0]); return document.getElementById(field.id + "-note").textContent`, field(path));
const STEEL = 'nominal_area = "1 cm2"\nrigid_counterface = true\n[[body]]\nyoungs_modulus = "210 GPa"\npoissons_ratio = 0.3\nhardness = "2 GPa"\n';
const scan = matrix(nanometres());
// Heights without their unit.
const bare = scan.replace(/^# Value units.*\n/m, "");

// Drops files, each a name and a text.
async function drop(...list) {
  await page.run(`const dataTransfer = new DataTransfer();
    for (const [name, text] of arguments[0]) dataTransfer.items.add(new File([text], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer, cancelable: true }));`, list);
  await page.browser.until(SETTLED, JSON.stringify(list.map(([name]) => name)));
}
const solvedLoads = () => page.run("return [...document.querySelectorAll('#solved thead [data-pressure]')].map(({ dataset }) => dataset.pressure)");
const state = async () => [await page.phase(), await page.text("message"), await page.text("scene-error")];

test("a dropped scene opens, with its scan if both are dropped", async () => {
  await drop(["own.toml", example("lapped-seal")]);
  assert.deepEqual([await page.value("scene"), ...(await state())], [example("lapped-seal"), "ready", "", ""]);
  const text = `${STEEL}[surface]\nfile = "scans/a.txt"\nunit = "nm"\n`;
  const own = bare.replace("# Width", "# width");
  for (const files of [[["own.toml", text], ["a.txt", own]], [["a.txt", own], ["scene.txt", text]]]) {
    await page.scene(example("wheel-rail"));
    await drop(...files);
    assert.deepEqual([await page.value("scene"), ...(await state())], [text, "ready", "", ""]);
    assert.ok(Object.keys(await page.values()).length > 5);
  }
});

test("a scene without its scan says which it needs, and takes it", async () => {
  const text = `${STEEL}[surface]\nfile = "scans/later.txt"\nlevel = "mean"\n`;
  await drop(["own.toml", text]);
  assert.deepEqual([await page.phase(), await page.text("status")], ["failed", "waiting for scans/later.txt"]);
  assert.match(await page.text("curve"), /needs the scan scans\/later\.txt: choose or drop that file/);
  await drop(["later.txt", scan]);
  assert.deepEqual([await page.value("scene"), ...(await state())], [text, "ready", "", ""]);
});

test("no file is left out in silence", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["a.txt", scan], ["b.txt", scan]);
  assert.match(await page.text("message"), /^a\.txt is used, and not b\.txt: choose one scan/);
  assert.equal(await page.value("field-surface-file"), "a.txt");
  await drop(["own.toml", example("lapped-seal")], ["b.txt", scan]);
  assert.match(await page.text("message"), /^b\.txt: not used, as own\.toml does not name it/);
  assert.equal(await page.value("scene"), example("lapped-seal"));
});

test("a dropped file starts clean", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["bare.txt", bare]);
  await page.change([field("surface.unit"), "um"]);
  assert.equal(await page.phase(), "ready");
  await drop(["own.txt", scan]);
  assert.deepEqual(await state(), ["ready", "", ""]);
  assert.equal(await page.value("field-surface-unit"), "");
  await drop(["torn.x3p", "PK\u0003\u0004 nothing"]);
  assert.match(await page.text("message"), /^torn\.x3p/);
  await drop(["next.txt", scan]);
  assert.deepEqual(await state(), ["ready", "", ""]);
});

test("units that are not decimal are taken with a note of what they were taken as", async () => {
  await page.scene(example("wheel-rail"));
  for (const [path, typed, wanted] of [
    ["body[1].hardness", "250 HV", /: 250 HV is 2\.644 GPa/],
    ["body[1].youngs_modulus", "30 Msi", /: 30 Msi is 206\.8 GPa/],
    ["nominal_area", "0.2 in2", /: 0\.2 in2 is 129 mm2/],
  ]) {
    await page.change([field(path), typed]);
    assert.match(await note(path), wanted);
    assert.deepEqual(await state(), ["ready", "", ""]);
  }
  await page.change(["#load", "145 psi"]);
  assert.equal(await page.text("load-error"), "");
  assert.match(await page.text("load-other"), /^= 999\.7 kPa; 129 N$/);
  await page.change(["#load", "5 kg"]);
  assert.match(await page.text("load-error"), /neither a load nor a pressure: write 2 kN or 5 MPa, for example$/);
  await page.change(["#load", "1 MPa"]);
});

test("an example that cannot be read says that there is no connection", async () => {
  await page.browser.cdp("Network.enable", {});
  const offline = (offline) => page.browser.cdp("Network.emulateNetworkConditions", { offline, latency: 0, downloadThroughput: -1, uploadThroughput: -1 });
  await offline(true);
  try {
    await page.change(["#example", "bolted-joint"]);
    assert.match(await page.text("message"), /bolted-joint could not be read, as there is no connection to 127\.0\.0\.1/);
  } finally {
    await offline(false);
  }
  assert.match((await page.browser.errors()).join(), /ERR_INTERNET_DISCONNECTED/);
});

test("boundary elements stay where load, quantity or models change, and come back with their scene", async () => {
  await page.change(["#example", "made-here"]);
  await page.browser.until("return document.querySelectorAll('#solved thead [data-pressure]').length >= 6", "solved loads");
  await page.browser.until(SETTLED);
  const [solved, text] = [await solvedLoads(), await page.value("scene")];
  await page.change(["#view", "tangent"]);
  await page.change(["#load", "3 MPa"]);
  await page.run("history.back()");
  await page.browser.until("return document.getElementById('load').value !== '3 MPa'", "the load before");
  await page.browser.until(SETTLED);
  assert.deepEqual(await solvedLoads(), solved);
  await page.change([field("nominal_area"), "2 cm2"]);
  assert.deepEqual(await page.run("return [document.getElementById('solved').hidden, document.querySelector('#answers [data-model=bem]')]"), [true, null]);
  await page.run("history.back()");
  await page.browser.until("return !document.getElementById('scene').value.includes('2 cm2')", "the area before");
  await page.browser.until(SETTLED);
  assert.equal(await page.value("scene"), text);
  assert.deepEqual(await solvedLoads(), solved);
  assert.ok(await page.run("return document.querySelector('#contact image') !== null"));
});

test("the way back of a description has what was typed", async () => {
  const text = `${STEEL}[surface]\nsq = "95 nm"\nspd = "20000 1/mm2"\nspc = "50 1/mm"\n`;
  await page.scene(text);
  await page.change(["#way", "moments"]);
  assert.match(await page.value("scene"), /m0 = /);
  await page.change([field("nominal_area"), "2 cm2"]);
  await page.change(["#way", "iso"]);
  assert.equal(await page.value("scene"), text.replace("1 cm2", "2 cm2"));
  await page.change(["#way", "moments"]);
  await page.change([field("surface.m0"), "1e-14"]);
  await page.change(["#way", "iso"]);
  assert.match(await page.value("scene"), /sq = 1e-7|sq = 1\.0*e-7|sq = 9\.99\d*e-8/);
});

test("an implausible number is noted at its field, and its values are not saved", async () => {
  await page.scene(example("lapped-seal"));
  await page.change([field("surface.sq"), "0.7"]);
  assert.match(await note("surface.sq"), /0\.7 looks like um/);
  assert.deepEqual(await page.run("return ['save-csv', 'save-svg', 'save-values'].map((id) => document.getElementById(id).disabled)"), [true, true, true]);
  await page.change([field("surface.sq"), "0.7 um"]);
  assert.deepEqual([await note("surface.sq"), await page.run("return document.getElementById('save-csv').disabled")], ["", false]);
});
