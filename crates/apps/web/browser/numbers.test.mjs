// The numbers of the page are those of the program, and its lines to paste give them again.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, writeFileSync } from "node:fs";
import { delimiter, dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { EXAMPLES, example, explorer, program } from "./harness.mjs";
import { filesOf, nanometres } from "./files.mjs";

const python = process.env.ASPERITY_PYTHON;
const STEEL = '[[body]]\nyoungs_modulus = "210 GPa"\npoissons_ratio = 0.3\nhardness = "2 GPa"\n';
const head = 'nominal_area = "1 cm2"\n';
const SCENES = {
  ...Object.fromEntries(EXAMPLES.map((name) => [name, example(name)])),
  index: `${head}${STEEL}${STEEL}[surface]\nplasticity_index = 2\nroughness_parameter = 0.04\nasperity_height_std = "1 um"\n`,
  iso: `${head}${STEEL}${STEEL}[surface]\nsq = "1.1 um"\nspd = "200 1/mm2"\nspc = "5 1/mm"\n`,
  moments: `${head}rigid_counterface = true\n${STEEL}[surface]\nm0 = "1e-12 m^2"\nm2 = 1e-3\nm4 = "5e6 1/m^2"\n`,
  materials: `${head}[[body]]\nmaterial = "stainless-304"\n[[body]]\nmaterial = "aluminium"\n[surface]\nasperity_radius = "0.1 mm"\nasperity_density = "400 1/mm2"\nasperity_height_std = "0.5 um"\n`,
  adhesion: `${head}work_of_adhesion = "50 mJ/m2"\nrigid_counterface = true\n[[body]]\nyoungs_modulus = "2 MPa"\npoissons_ratio = 0.5\n[surface]\nasperity_radius = "0.1 mm"\nasperity_density = "400 1/mm2"\nasperity_height_std = "1 um"\n`,
};
const QUICK = ["gw", "ceb", "zmc", "ke", "etsion", "jg", "jg-cosine", "af", "persson", "persson-fudge", "dmt", "jkr"];
let page;

before(async () => (page = await explorer()));
after(() => page?.end());

// Rows of the program, which fails after findings of errors with its table written.
function rows(...options) {
  const { stdout, stderr } = spawnSync(program, [...options, "--format", "json"], { encoding: "utf8" });
  assert.ok(stdout, stderr);
  return JSON.parse(stdout);
}
const saved = (text, name = "scene.toml") => {
  const path = join(page.scratch, name);
  writeFileSync(path, text);
  return path;
};
// The value of a quantity, whose column ends in its unit.
const column = (row, quantity) => {
  const start = quantity.replaceAll("-", "_");
  const ofIt = (key) => key === start || (key.startsWith(`${start}_`) && !/per_area|error|over|fraction/.test(key.slice(start.length)));
  return row[Object.keys(row).find(ofIt)];
};
// How many of the values shown are those of the rows.
function agreed(shown, all, name) {
  let compared = 0;
  for (const row of all) for (const [key, [value, bound]] of Object.entries(shown)) {
    const [model, quantity] = key.split(" ");
    const wanted = model === row.model && column(row, quantity);
    if (typeof wanted !== "number") continue;
    const error = Math.abs(Number(value) - wanted);
    const allowed = Math.max(1e-13, Number(bound ?? 0)) * Math.abs(wanted);
    assert.ok(error <= allowed, `${name} ${key}: ${value}, the program: ${wanted}`);
    compared += 1;
  }
  return compared;
}
const chosen = (select) => page.run(`for (const box of document.querySelectorAll('#models input')) if (!box.disabled && box.checked !== arguments[0].includes(box.value)) box.click();`, select);

test("numbers of ten scenes are those of the program", { skip: !program }, async () => {
  assert.equal(Object.keys(SCENES).length, 10);
  for (const [name, text] of Object.entries(SCENES)) {
    await page.scene(text);
    assert.equal(await page.text("scene-error"), "", name);
    const all = await page.run("return [...document.querySelectorAll('#models input')].filter((box) => !box.disabled).map((box) => box.value)");
    // Random asperities and laws of inclined contacts take seconds: they are compared on one scene.
    await chosen(name === "wheel-rail" ? [...QUICK, "ke-random", "gao"] : all.filter((id) => QUICK.includes(id)));
    let compared = 0;
    for (const load of [10, 250]) {
      await page.change(["#load", `${load} N`]);
      await page.browser.until("return document.documentElement.dataset.state === 'ready'", `${name} at ${load} N`);
      const shown = await page.values();
      const of = (k) => [...new Set(Object.keys(shown).map((key) => key.split(" ")[k]))];
      const quantities = of(1).filter((quantity) => quantity !== "separation");
      // The answer is compared with the corrected rows elsewhere.
      const args = ["--model", of(0).filter((id) => id !== "answer").join(), "--load", String(load), "--quantity", quantities.join()];
      compared += agreed(shown, rows("curve", saved(text), ...args), name);
    }
    assert.ok(compared >= 8, `${name}: ${compared} numbers`);
  }
});

test("boundary elements are those of the program: area within two pixels, gap within 1e-7", { skip: !program }, async () => {
  const [name, bytes] = filesOf(nanometres()).find(([name]) => name === "scan.x3p");
  await page.scene(example("wheel-rail"));
  await page.file(name, bytes);
  await page.run("document.getElementById('solve').click()");
  await page.browser.until("return document.querySelectorAll('#solved [data-quantity=area-fraction]').length >= 5", "solved loads");
  await page.browser.until("return document.documentElement.dataset.state === 'ready'");
  const solved = await page.solved();
  const path = saved(await page.value("scene"));
  const wanted = rows("bem", path, "--pressure", solved.map(({ pressure }) => pressure).join());
  assert.equal(wanted.length, solved.length);
  for (const [k, row] of wanted.entries()) {
    const one = solved[k];
    assert.ok(Math.abs(one.pressure / row.pressure_Pa - 1) < 1e-12);
    assert.ok(Math.abs(one["area-fraction"] - row.area_fraction) <= 2 / 4096, `${one["area-fraction"]} ${row.area_fraction}`);
    const gap = one["mean-gap"];
    assert.ok(Math.abs(gap - row.mean_gap_m) <= 1e-7 * Math.abs(row.mean_gap_m), `${gap} ${row.mean_gap_m}`);
  }
});

test("the lines for a shell and for Python run for every example and give the digits of the page", { skip: !program }, async () => {
  const env = { ...process.env, PATH: `${dirname(program)}${delimiter}${process.env.PATH}` };
  const pasted = (command, ...args) => {
    const { stdout, stderr, status } = spawnSync(command, args, { cwd: page.scratch, env, encoding: "utf8" });
    assert.equal(status, 0, stderr);
    return stdout;
  };
  await page.run("document.getElementById('code').open = true");
  for (const name of ["made-here", ...EXAMPLES]) {
    await page.change(["#example", name]);
    // The models that the page opens with, of which soft bodies have fewer.
    const usual = ["gw", "ke", "jg", "persson-fudge"];
    await chosen(usual);
    await page.browser.until("return document.documentElement.dataset.state === 'ready'", `lines for ${name}`);
    const [, models] = (await page.text("code-shell")).match(/--model (\S+) --load/);
    if (name === "made-here") {
      await page.run("document.getElementById('save-scan').click()");
      for (let k = 0; k < 50 && !existsSync(join(page.scratch, "random-1.x3p")); k++) await new Promise((resolve) => setTimeout(resolve, 100));
    }
    const shown = await page.values();
    saved(await page.value("scene"));
    const compared = agreed(shown, JSON.parse(pasted("bash", "-c", await page.text("code-shell"))), `${name}: shell`);
    assert.ok(compared >= 8, `${name}: ${compared} numbers`);
    if (!python || !existsSync(python)) continue;
    const lines = pasted(python, "-W", "ignore", "-c", await page.text("code-python")).trim().split("\n").map((line) => line.split(" "));
    const of = lines.filter(([, , value]) => value !== "none:");
    assert.equal(agreed(shown, of.map(([model, quantity, value]) => ({ model, [quantity.replaceAll("-", "_")]: Number(value.replaceAll(/[[\]]/g, "")) })), `${name}: Python`), of.length);
    // A value that is missing on the page is missing there, and no other.
    const dashes = models.split(",").flatMap((model) => [...new Set(lines.map(([, quantity]) => quantity))].filter((quantity) => !(`${model} ${quantity}` in shown)).map((quantity) => `${model} ${quantity}`));
    assert.deepEqual(lines.filter(([, , value]) => value === "none:").map(([model, quantity]) => `${model} ${quantity}`), dashes, name);
  }
});
