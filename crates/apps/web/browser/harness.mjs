// The explorer in a browser of its own, and what tests do with it. ASPERITY names the program.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { open } from "./webdriver.mjs";
import { serve } from "./server.mjs";

export const root = join(dirname(fileURLToPath(import.meta.url)), "../../../..");
export const page = process.env.ASPERITY_PAGE ?? join(root, "target/page");
export const program = process.env.ASPERITY;
export const READY = "return document.documentElement.dataset.state === 'ready'";
export const SETTLED = "return ['ready', 'failed'].includes(document.documentElement.dataset.state)";
export const example = (name) => readFileSync(join(root, `crates/answer/inputs/examples/${name}.toml`), "utf8");
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
    text: (id) => run("return document.getElementById(arguments[0]).textContent", id),
    value: (id) => run("return document.getElementById(arguments[0]).value", id),
    phase: () => run("return document.documentElement.dataset.state"),
    // [value, bound] of each model and quantity below an element.
    values: (below = "#answers") => run(`return Object.fromEntries([...document.querySelectorAll(arguments[0] + ' [data-value]:not([data-model=answer])')]
      .map(({ dataset: { model, quantity, value, bound } }) => [model + ' ' + quantity, [value, bound]]))`, below),
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
