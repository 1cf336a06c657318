// The answer: its values are those of `asperity curve --corrected`, and everything that is said
// about models follows from it.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { EXAMPLES, example, explorer, program, SETTLED } from "./harness.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const choose = (ids) => page.run("for (const box of document.querySelectorAll('#models input')) if (!box.disabled && box.checked !== arguments[0].includes(box.value)) box.click();", ids);
const first = () => page.run("return Object.fromEntries([...document.querySelectorAll('#answer dl div')].map((one) => [...one.children].map((part) => part.textContent)))");
const basis = () => page.text("basis");
const of = (below, model) => page.run(`return Object.fromEntries([...document.querySelectorAll(arguments[0] + ' [data-value]')]
  .filter(({ dataset }) => dataset.model === arguments[1]).map(({ dataset }) => [dataset.quantity, { ...dataset }]))`, below, model);
const against = () => page.run("return Object.fromEntries([...document.querySelectorAll('#answers tbody tr')].map((row) => [row.cells[0].textContent, row.cells[1]?.textContent]))");

// Columns of the program: the value and the ends of its interval.
const COLUMNS = {
  separation: ["separation_m", "separation_lower_m", "separation_upper_m"],
  "area-fraction": ["area_fraction", "area_fraction_lower", "area_fraction_upper"],
  tangent: ["tangent_N_per_m", "tangent_lower_N_per_m", "tangent_upper_N_per_m"],
  "unloading-stiffness": ["unloading_stiffness_N_per_m", "unloading_stiffness_lower_N_per_m", "unloading_stiffness_upper_N_per_m"],
  "mean-pressure": ["mean_pressure_Pa", "mean_pressure_lower_Pa", "mean_pressure_upper_Pa"],
};
const QUANTITIES = ["area-fraction", "tangent", "unloading-stiffness", "mean-pressure"];
function corrected(text, load, model) {
  const path = join(page.scratch, "scene.toml");
  writeFileSync(path, text);
  const options = ["curve", path, "--model", model, "--corrected", "--load", load, "--quantity", QUANTITIES.join(), "--format", "json"];
  const { stdout } = spawnSync(program, options, { encoding: "utf8" });
  return JSON.parse(stdout || "[]").find((row) => String(row.model).endsWith("-corrected"));
}

test("values and ends of intervals are those of the corrected rows of the program", { skip: !program }, async () => {
  let compared = 0;
  for (const name of EXAMPLES) for (const load of name === "elastomer-on-glass" ? ["0.05", "0.7"] : ["200", "2000"]) {
    const text = example(name);
    await page.scene(text);
    await page.change(["#load", `${load} N`]);
    const found = await of("#answers", "answer");
    const row = corrected(text, load, name === "elastomer-on-glass" ? "gw" : "ke");
    for (const [quantity, columns] of Object.entries(COLUMNS)) {
      const wanted = columns.map((column) => row?.[column]);
      if (typeof wanted[0] !== "number") {
        assert.equal(found[quantity]?.lower, undefined, `${name} ${quantity}`);
        continue;
      }
      const { value, lower, upper } = found[quantity];
      for (const [k, shown] of [value, lower, upper].entries()) {
        assert.ok(Math.abs(shown / wanted[k] - 1) < 1e-9, `${name} ${load} ${quantity}: ${shown}, the program: ${wanted[k]}`);
      }
      assert.ok(Number(lower) <= Number(value) && Number(value) <= Number(upper));
      compared += 1;
    }
  }
  assert.ok(compared > 20, `${compared}`);
});

test("the answer has area, stiffnesses, plasticity and the model to use at every load", async () => {
  await page.scene(example("lapped-seal"));
  await page.change(["#load", "1 MPa"]);
  const shown = await first();
  assert.match(shown["real area"], /^[\d.]+ %[\d.]+ to [\d.]+$/);
  assert.match(shown["first-loading stiffness"], /^[\d.]+ [GM]N\/m[\d.]+ to [\d.]+$/);
  assert.match(shown["plasticity index"], /^[\d.]+(nothing yields|a few contacts yield|contacts yield)$/);
  assert.match(shown["model to use"], /^[a-z-]+area [+−]?\d+ %, stiffness [+−]?\d+ %/);
  assert.match(await basis(), /From boundary elements on \d+ surfaces like this one; 9 of 10 lie in the intervals/);
  // The column of the table has the same deviations.
  const [, model, area, stiffness] = shown["model to use"].match(/^([a-z-]+)area ([^,]+ %), stiffness ([+−]?\d+ %)/);
  assert.equal((await against())[model], `${area}, ${stiffness}`);
});

test("a model that ignores yielding is near by chance, and the next beside it", async () => {
  await page.change(["#example", "made-here"]);
  await page.change(["#load", "5 MPa"]);
  assert.match((await first())["model to use"], /^gwarea [^;]+, by chance: it ignores yielding; (ke|jg) [+−]\d+ %, [+−]\d+ %$/);
});

test("without evidence the answer is that of the recommended model, with the reason", async () => {
  // So soft that no like surface was solved.
  await page.scene(example("bolted-joint").replace("= 275e6", "= 140e6"));
  const shown = await first();
  assert.match(shown["real area"], /by ke$/);
  assert.match(shown["model to use"], /^ke/);
  assert.match(await basis(), /^ ?No evidence here \(plasticity index = .* solved up to [\d.]+\): values by ke\.$/);
  const [answer, ke] = [await of("#answers", "answer"), await of("#answers", "ke")];
  assert.equal(answer.tangent.value, ke.tangent.value);
  assert.equal(answer.tangent.lower, undefined);
});

test("an invented surface says so until the user gives one", async () => {
  await page.change(["#example", "lapped-seal"]);
  assert.match(await basis(), /^An example surface \(Sq [\d.]+ [nµ]m\)\./);
  await page.change(["#material-1", "copper-cold-worked"]);
  assert.match(await basis(), /^An example surface/);
  await page.change(['[data-path="surface.sq"]', "300 nm"]);
  assert.doesNotMatch(await basis(), /example surface/);
});

test("boundary elements of this scan at this load are the answer", async () => {
  await page.change(["#example", "made-here"]);
  await page.change(["#load", "200 MPa"]);
  assert.match(await basis(), /From boundary elements on \d+ surfaces/);
  await page.run("document.getElementById('solve-load').click()");
  await page.browser.until("return /on this scan at this load/.test(document.getElementById('basis').textContent)", "the solved load", 60);
  await page.browser.until(SETTLED);
  const [answer, bem] = [await of("#answers", "answer"), await of("#answers", "bem")];
  for (const quantity of ["area-fraction", "tangent", "unloading-stiffness"]) assert.equal(answer[quantity].value, bem[quantity].value);
  const ke = await of("#answers", "ke");
  const off = Math.round(100 * (ke["area-fraction"].value / bem["area-fraction"].value - 1));
  assert.equal((await against()).ke.split(",")[0], `${off > 0 ? "+" : ""}${off} %`.replace("-", "−"));
});

test("models of the table are compared at once, the others after a press, and added by theirs", async () => {
  await page.scene(example("lapped-seal"));
  await choose(["gw", "ke"]);
  await page.browser.until(SETTLED);
  const lines = () => page.run("return [...document.querySelectorAll('#compared li')].map((line) => line.textContent)");
  assert.equal((await lines()).length, 2);
  assert.match(String(await lines()), /ke area [+−]?\d+ %, stiffness/);
  await page.run("document.getElementById('compare').click()");
  await page.browser.until("return /^all \\d+ models compared/.test(document.getElementById('compared-count').textContent)", "all models", 120);
  const all = await lines();
  assert.ok(all.length > 8, all.join("\n"));
  await page.run("[...document.querySelectorAll('#compared button')].find((one) => one.textContent === 'jg').click()");
  await page.browser.until(SETTLED);
  assert.ok("jg" in (await against()));
  // Another load has other deviations.
  await page.change(["#load", "2 MPa"]);
  assert.equal((await lines()).length, 3);
});

test("a model out of its range is marked", async () => {
  await page.change(["#example", "made-here"]);
  await choose(["gw", "ke", "at"]);
  await page.browser.until("return document.querySelectorAll('#answers [data-model=at]').length > 3", "at", 120);
  await page.browser.until(SETTLED);
  assert.match((await against()).at, /^⚠ \+\d+ %, \+\d+ %$/);
  assert.doesNotMatch((await against()).ke, /⚠/);
  assert.match(await page.run("return [...document.querySelectorAll('#answers tr')].find((row) => row.cells[0].textContent === 'at').cells[1].title"), /more than .*30 % from the answer/);
});
