// The explorer in a browser of its own, and what tests do with it. ASPERITY names the program.
import assert from "node:assert/strict";
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { open } from "./webdriver.mjs";
import { serve } from "./server.mjs";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
export const page = process.env.ASPERITY_PAGE ?? join(root, "target/page");
export const program = process.env.ASPERITY;
export const field = (path) => `[data-path="${path}"]`;
export const READY = "return document.documentElement.dataset.state === 'ready'";
export const SETTLED = "return ['ready', 'failed'].includes(document.documentElement.dataset.state)";
export const example = (name) => readFileSync(join(root, `crates/answer/scene/examples/${name}.toml`), "utf8");
export const EXAMPLES = ["wheel-rail", "bolted-joint", "elastomer-on-glass", "lapped-seal", "ground-steel"];

// A window of the page; `script` runs in it before all others.
export async function explorer({ script, address = (url) => url, ...options } = {}) {
  const scratch = mkdtempSync(join(tmpdir(), "asperity-page-"));
  const site = await serve(page);
  const browser = await open({ downloads: scratch, ...options });
  const run = browser.run;
  if (script) await browser.cdp("Page.addScriptToEvaluateOnNewDocument", { source: script });
  await browser.go(address(site.url));
  await browser.until(SETTLED, "the first page");
  const give = {
    // Gives controls values one after the other at once, and waits for what follows.
    async change(...list) {
      await run(`for (const [selector, value, event = "change"] of arguments[0]) {
        const field = document.querySelector(selector);
        field.value = value;
        field.dispatchEvent(new Event(event, { bubbles: true }));
      }`, list);
      await browser.until(SETTLED, JSON.stringify(list).slice(0, 80));
    },
    async file(name, bytes) {
      const path = join(scratch, name);
      writeFileSync(path, bytes);
      await browser.type("#scan", path);
      await browser.until(SETTLED, name);
    },
  };
  return {
    browser, site, scratch, run, ...give,
    scene: (text) => give.change(["#scene", text, "input"]),
    // Ticks these models, and no others.
    async choose(ids) {
      await run(`for (const box of document.querySelectorAll("#models input:not(:disabled)")) if (box.checked !== arguments[0].includes(box.value)) box.click()`, ids);
      await browser.until(SETTLED, String(ids));
    },
    async click(id) {
      await run(`document.getElementById(arguments[0]).click()`, id);
      await browser.until(SETTLED, id);
    },
    // A property of each element of a list.
    all: (selector, of = "textContent") => run(`return [...document.querySelectorAll(arguments[0])].map((one) => one[arguments[1]])`, selector, of),
    // The attributes of the cell of a model and a quantity.
    cell: (model, quantity) => run(`return { ...document.querySelector("#answers [data-model=" + arguments[0] + "][data-quantity=" + arguments[1] + "]")?.dataset }`, model, quantity),
    disabled: (...ids) => run(`return arguments[0].map((id) => document.getElementById(id).disabled)`, ids),
    opened: () => browser.until(`return document.querySelectorAll("#solved thead [data-pressure]").length >= 6`, "solved loads"),
    text: (id) => run("return document.getElementById(arguments[0]).textContent", id),
    value: (id) => run("return document.getElementById(arguments[0]).value", id),
    phase: () => run("return document.documentElement.dataset.state"),
    // [value, bound] of each model and quantity below an element.
    values: (below = "#answers") => run(`return Object.fromEntries([...document.querySelectorAll(arguments[0] + ' [data-value]:not([data-model=answer])')]
      .map(({ dataset: { model, quantity, value, bound } }) => [model + ' ' + quantity, [value, bound]]))`, below),
    // A file among the downloads, after a press.
    async saved(name, id) {
      await run(`document.getElementById(arguments[0]).click()`, id);
      const path = join(scratch, name);
      for (let k = 0; k < 50 && !existsSync(path); k++) await new Promise((resolve) => setTimeout(resolve, 100));
      return readFileSync(path, "utf8");
    },
    // The loads that boundary elements solved, each with its numbers.
    solved: () => run(`const rows = [...document.querySelectorAll("#solved tr")];
      return [...document.querySelectorAll("#solved thead [data-pressure]")].map((_, k) => Object.fromEntries(
        rows.map((row) => row.cells[k + 1].dataset).filter(({ value }) => value !== undefined).map(({ quantity, value }) => [quantity, Number(value)])))`),
    // What was asked of other hosts, and what the console holds as an error.
    async strays() {
      const { origin } = new URL(site.url);
      const away = (url) => !url.startsWith(origin) && !/^(data|blob|about|chrome)/.test(url);
      return [...(await browser.requests()).filter(away), ...(await browser.errors())];
    },
    // Closes a window that asked no other host and has no error in its console.
    async end() {
      try {
        assert.deepEqual(await this.strays(), []);
      } finally {
        await this.close();
      }
    },
    async close() {
      await browser.close();
      site.close();
    },
  };
}
