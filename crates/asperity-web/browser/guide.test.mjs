// The guide: every page on a narrow screen, and its search.
import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { explorer, page as folder } from "./harness.mjs";

let page, guide;
before(async () => {
  page = await explorer();
  guide = page.site.url.replace("index.html", "guide/");
});
after(() => page?.end());

test("no page scrolls sideways at 360 px, and every picture is there", async () => {
  const { browser, run } = page;
  await browser.cdp("Emulation.setDeviceMetricsOverride", { width: 360, height: 800, deviceScaleFactor: 1, mobile: false });
  const pages = readdirSync(join(folder, "guide")).filter((name) => name.endsWith(".html"));
  assert.ok(pages.length > 30, `${pages.length} pages`);
  for (const name of pages) {
    await browser.go(guide + name);
    const missing = await browser.later(`const images = [...document.images];
      images.forEach((image) => { image.loading = "eager"; });
      await Promise.allSettled(images.map((image) => image.decode()));
      return images.filter((image) => !image.naturalWidth || !image.alt).map((image) => image.src)`);
    assert.deepEqual(missing, [], name);
    const wide = await run(`const { scrollWidth, clientWidth } = document.documentElement;
      return scrollWidth > clientWidth && [...document.body.querySelectorAll("*")].filter((one) => one.getBoundingClientRect().right > clientWidth).map((one) => one.outerHTML.slice(0, 80))`);
    assert.equal(wide, false, `${name}: ${wide}`);
  }
  await browser.cdp("Emulation.clearDeviceMetricsOverride", {});
});

test("a heading is found by typing, and opened by keys", async () => {
  const { browser } = page;
  await browser.go(`${guide}index.html`);
  await browser.type("input", "measured surface");
  await browser.until("return document.querySelector('#found a')", "an entry", 10);
  assert.match(await page.text("found"), /A measured surface/);
  await browser.keys(["\uE004", "\uE007"]);
  await browser.until("return location.hash === '#a-measured-surface'", "the page of the entry", 10);
  assert.match(await page.run("return location.pathname"), /guide.scan-to-stiffness.html$/);
});
