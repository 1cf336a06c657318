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

test("a scene file that cannot be read leaves the scene and its scan, and the page says why", async () => {
  await page.scene(example("wheel-rail"));
  await drop(["kept.txt", scan]);
  const [text, values] = [await page.value("scene"), await page.values()];
  for (const [name, torn] of [["torn.toml", "nominal_area = "], ["picture.toml", "\u0089PNG\r\n"], ["other.toml", "a = 1\n"]]) {
    await drop([name, torn]);
    assert.match(await page.text("message"), new RegExp(`^${name}: `));
    assert.deepEqual([await page.phase(), await page.value("scene"), await page.values()], ["ready", text, values], name);
  }
  // The scan is still that of the page.
  await page.change(["#load", "7 N"]);
  assert.deepEqual([await page.phase(), await page.value("load")], ["ready", "7 N"]);
  await drop(["torn.toml", "nominal_area = "], ["other.txt", scan]);
  assert.deepEqual([await page.phase(), await page.value("scene")], ["ready", text]);
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

test("a look at another description of the surface changes nothing", async () => {
  const head = STEEL.replace("rigid_counterface = true\n", "");
  for (const surface of ['sq = "95 nm" # measured\nspd = "20000 1/mm2"\nspc = "50 1/mm"\n', "asperity_radius = 18.3e-6\nasperity_density = 6.4e9\nasperity_height_std = 1e-7\n"]) {
    const text = `${head}${head.slice(head.indexOf("[[body]]"))}[surface]\n${surface}`;
    await page.scene(text);
    const [first, values] = [await page.value("way"), await page.values()];
    for (const way of ["finish", "moments", first]) await page.change(["#way", way]);
    assert.deepEqual([await page.value("scene"), await page.values()], [text, values]);
    await page.change(["#way", "finish"]);
    await page.change([field("nominal_area"), "2 cm2"]);
    await page.change(["#way", first]);
    assert.equal(await page.value("scene"), text.replace("1 cm2", "2 cm2"));
  }
  await page.scene(`${STEEL}[surface]\nsq = "95 nm"\nspd = "20000 1/mm2"\nspc = "50 1/mm"\n`);
  await page.change(["#way", "moments"]);
  await page.change([field("surface.m0"), "1e-14"]);
  await page.change(["#way", "iso"]);
  assert.match(await page.value("scene"), /sq = 1e-7|sq = 1\.0*e-7|sq = 9\.99\d*e-8/);
});

test("Ra 0.8 is in um, and two like bodies have two such surfaces until another is chosen", async () => {
  await page.scene(example("bolted-joint"));
  for (const k of [1, 2]) await page.change([`#material-${k}`, "steel-1040-cold-drawn"]);
  await page.change(["#way", "finish"]);
  await page.change([field("surface.ra"), "0.8"]);
  await page.change([field("surface.finish"), "ground"]);
  assert.deepEqual([await page.value("field-surface-ra"), await page.value("other-surface")], ["0.8 um", "same"]);
  await page.change([field("nominal_area"), "1 cm2"]);
  await page.change(["#load", "5 MPa"]);
  const stiffness = () => page.run("const { value, lower, upper } = document.querySelector('#answers [data-model=answer][data-quantity=tangent]').dataset; return [value, lower, upper].map((x) => Number((x / 1e9).toPrecision(3)))");
  const visible = () => page.run("return !document.getElementById('other-fields').hidden");
  // By the program from `counterface = { ra = 8e-7, finish = "ground" }`, and without it.
  assert.deepEqual([await stiffness(), await visible()], [[0.962, 0.877, 1.09], false]);
  await page.change(["#other-surface", "smooth"]);
  assert.deepEqual([await stiffness(), await visible()], [[1.36, 1.22, 1.55], false]);
  await page.change(["#other-surface", "another"]);
  assert.deepEqual([await stiffness(), await visible()], [[0.962, 0.877, 1.09], true]);
  await page.change([field("surface.ra"), "1.6"]);
  assert.match(await page.value("scene"), /ra = "1\.6 um"[^]*counterface = \{ ra = "0\.8 um", finish = "ground" \}/);
  await page.change([field("surface.counterface.ra"), "1.6"]);
  await page.change(["#other-surface", "same"]);
  assert.equal(await visible(), false);
  assert.deepEqual(await state(), ["ready", "", ""]);
  // Bands, and no table, of which the page says why.
  assert.match(await page.text("curve"), /lower to upper end/);
  assert.deepEqual([await page.run("return document.getElementById('export-model').options.length"), await page.run("return document.getElementById('save-table').disabled")], [0, true]);
  assert.match(await page.text("no-table"), /^No table of gw, ke, jg, persson-fudge: .*within ranges only/);
});

test("every field of a number shows its unit", async () => {
  const bare = () => page.run("return [...document.querySelectorAll('#inputs input[data-path]')].filter((input) => /\\d [a-zA-ZµΩ]/.test(input.placeholder) && !input.labels[0].querySelector('.unit')).map((input) => input.dataset.path)");
  for (const name of ["ground-steel", "lapped-seal", "wheel-rail"]) {
    await page.scene(example(name));
    assert.deepEqual(await bare(), []);
  }
  await page.change(["#way", "finish"]);
  assert.deepEqual([await bare(), await page.run("return document.querySelector('label[for=field-surface-ra]').textContent")], [[], "Roughness Ra µm"]);
});

test("tables are offered of models that have one, and the page says why others have none", async () => {
  await page.scene(example("wheel-rail"));
  await page.browser.until("return document.getElementById('export-model').options.length > 0", "tables");
  const offered = await page.run("return [...document.getElementById('export-model').options].map(({ value }) => value)");
  assert.ok(offered.includes("ke") && !offered.includes("persson-fudge"), String(offered));
  assert.match(await page.text("no-table"), /^No table of persson-fudge: .*hurst/);
  assert.equal(await page.run("return document.getElementById('save-table').disabled"), false);
});

test("an implausible number is noted at its field, and its values are not saved", async () => {
  await page.scene(example("lapped-seal"));
  await page.change([field("surface.sq"), "0.7"]);
  assert.match(await note("surface.sq"), /0\.7 looks like um/);
  assert.deepEqual(await page.run("return ['save-csv', 'save-svg', 'save-values'].map((id) => document.getElementById(id).disabled)"), [true, true, true]);
  await page.change([field("surface.sq"), "0.7 um"]);
  assert.deepEqual([await note("surface.sq"), await page.run("return document.getElementById('save-csv').disabled")], ["", false]);
});
