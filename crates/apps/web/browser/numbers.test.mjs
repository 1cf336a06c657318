// The numbers of the page are those of the program, and its lines to paste give them again.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, writeFileSync } from "node:fs";
import { delimiter, dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { EXAMPLES, example, explorer, program, READY } from "./harness.mjs";
import { matrix } from "./files.mjs";

const python = process.env.ASPERITY_PYTHON;
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
test("models agree", { skip: !program }, async () => {
  for (const name of EXAMPLES) {
    await page.scene(example(name));
    const all = await page.all("#models input:not(:disabled)", "value");
    // Random asperities and laws of inclined contacts take seconds: they are compared on one scene.
    await page.choose(name === "wheel-rail" ? [...QUICK, "ke-random", "gao"] : all.filter((id) => QUICK.includes(id)));
    await page.change(["#load", "250 N"]);
    await page.browser.until(READY, name);
    const shown = await page.values();
    const of = (k) => [...new Set(Object.keys(shown).map((key) => key.split(" ")[k]))];
    const quantities = of(1).filter((quantity) => quantity !== "separation");
    const args = ["--model", of(0).join(), "--load", "250", "--quantity", quantities.join()];
    const compared = agreed(shown, rows("curve", saved(example(name)), ...args), name);
    assert.ok(compared >= 8, `${name}: ${compared} numbers`);
  }
});

test("boundary elements agree", { skip: !program }, async () => {
  await page.scene(example("wheel-rail"));
  await page.file("scan.txt", matrix());
  await page.click("leaks");
  await page.click("add-seal");
  await page.click("solve");
  await page.browser.until(READY);
  const solved = await page.solved();
  const path = saved(await page.value("scene"));
  const quantities = ["tangent", "unloading-stiffness", "hydraulic-gap-x", "hydraulic-gap-y", "leak"];
  const wanted = rows("bem", path, "--pressure", solved.map(({ pressure }) => pressure).join(), "--quantity", quantities.join());
  assert.equal(wanted.length, solved.length);
  for (const [k, row] of wanted.entries()) {
    const one = solved[k];
    assert.ok(Math.abs(one.pressure / row.pressure_Pa - 1) < 1e-12);
    assert.ok(Math.abs(one["area-fraction"] - row.area_fraction) <= 2 / 4096, `${one["area-fraction"]} ${row.area_fraction}`);
    for (const [quantity, within] of [["mean-gap", 1e-7], ["tangent", 1e-3], ["unloading-stiffness", 1e-6], ["hydraulic-gap-x", 1e-6], ["hydraulic-gap-y", 1e-6], ["leak-x", 1e-6]]) {
      const found = column(row, quantity);
      assert.ok(Math.abs(one[quantity] - found) <= within * Math.abs(found), `${quantity}: ${one[quantity]}, the program: ${found}`);
    }
  }
  // The load of the page is among them: it is the answer, and saved.
  const [answer, bem] = [await page.cell("answer", "tangent"), await page.cell("bem", "tangent")];
  assert.equal(answer.value, bem.value);
  const lines = (await page.saved("values.csv", "save-values")).trim().split("\n").map((line) => line.split(","));
  assert.equal(lines.find(([model]) => model === "bem")[lines[0].findIndex((name) => name.startsWith("tangent"))], bem.value);
});

test("pasted lines agree", { skip: !program }, async () => {
  const env = { ...process.env, PATH: `${dirname(program)}${delimiter}${process.env.PATH}` };
  const pasted = (command, ...args) => {
    const { stdout, stderr, status } = spawnSync(command, args, { cwd: page.scratch, env, encoding: "utf8" });
    assert.equal(status, 0, stderr);
    return stdout;
  };
  await page.run(`document.getElementById("code").open = true`);
  for (const name of ["made-here", "lapped-seal", "elastomer-on-glass"]) {
    await page.change(["#example", name]);
    // The models that the page opens with, of which soft bodies have fewer.
    const usual = ["gw", "ke", "jg", "persson-fudge"];
    await page.choose(usual);
    await page.browser.until(READY, `lines for ${name}`);
    const [, models] = (await page.text("code-shell")).match(/--model (\S+) --load/);
    if (name === "made-here") await page.saved("random-1.x3p", "save-scan");
    const shown = await page.values();
    saved(await page.value("scene"));
    const compared = agreed(shown, JSON.parse(pasted("bash", "-c", await page.text("code-shell"))), `${name}: shell`);
    assert.ok(compared >= 8, `${name}: ${compared} numbers`);
    if (!python || !existsSync(python)) continue;
    const lines = pasted(python, "-W", "ignore", "-c", await page.text("code-python")).trim().split("\n").map((line) => line.split(" ")).filter(([model]) => model !== "best");
    const of = lines.filter(([, , value]) => value !== "none:");
    assert.equal(agreed(shown, of.map(([model, quantity, value]) => ({ model, [quantity.replaceAll("-", "_")]: Number(value.replaceAll(/[[\]]/g, "")) })), `${name}: Python`), of.length);
    // A value that is missing on the page is missing there, and no other.
    const dashes = models.split(",").filter((model) => model !== "best").flatMap((model) => [...new Set(lines.map(([, quantity]) => quantity))].filter((quantity) => !(`${model} ${quantity}` in shown)).map((quantity) => `${model} ${quantity}`));
    assert.deepEqual(lines.filter(([, , value]) => value === "none:").map(([model, quantity]) => `${model} ${quantity}`), dashes, name);
  }
});
