// Files: every format, bad ones, and names that look like HTML.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { example, explorer, program } from "./harness.mjs";
import { filesOf, matrix, nanometres } from "./files.mjs";

let page;
before(async () => (page = await explorer()));
after(() => page?.end());

const sq = async () => Number(await page.run("return document.querySelector('#scan-numbers td')?.title"));

test("every format is read, and the same heights have the same Sq", async () => {
  let first;
  for (const [name, bytes, keys] of filesOf(nanometres())) {
    await page.scene(example("wheel-rail"));
    await page.file(name, bytes);
    if (keys) {
      assert.match(await page.text("scene-error"), /surface.*(unit|pixel)/);
      await page.scene((await page.value("scene")).replace(`file = "${name}"`, `file = "${name}"\n${keys}`));
    }
    assert.deepEqual([await page.phase(), await page.text("scene-error"), await page.text("message")], ["ready", "", ""], name);
    assert.ok(Object.keys(await page.values()).length > 5, name);
    if (name === "profile.txt") continue;
    first ??= await sq();
    assert.ok(Math.abs((await sq()) / first - 1) < 1e-9, `${name}: ${await sq()}`);
  }
});

test("the Sq of a file is that of the program", { skip: !program }, async () => {
  const [name, bytes] = filesOf(nanometres(37)).find(([name]) => name === "scan.gwy");
  await page.scene(example("wheel-rail"));
  await page.file(name, bytes);
  const { stdout } = spawnSync(program, ["surface", join(page.scratch, name), "--format", "json"], { encoding: "utf8" });
  const [found] = [JSON.parse(stdout)].flat();
  assert.ok(Math.abs((await sq()) / found.sq - 1) < 1e-13, `${await sq()} ${found.sq}`);
});

test("bad files have a message, and the page goes on", async () => {
  const map = nanometres();
  const x3p = filesOf(map).find(([name]) => name === "scan.x3p")[1];
  const broken = Buffer.from(x3p);
  broken.fill(0x55, 600, 900);
  for (const [name, bytes, wanted] of [
    ["empty.x3p", "", /empty\.x3p is empty \(0 bytes\)/],
    ["torn.x3p", x3p.subarray(0, x3p.length / 2), /torn\.x3p: the file is damaged .*: the list of its parts, at its end, is missing/],
    ["corrupt.x3p", broken, /corrupt\.x3p: .*damaged .*: the bytes of .* are not those that were stored/],
    ["single.txt", "x_um\tz_nm\n3\t5\n", /single\.txt: x: a single position, 3\.0, was found/],
    ["nan.txt", matrix(map).replaceAll(/^-?\d.*$/gm, (row) => row.replaceAll(/-?\d+/g, "nan")), /nan\.txt/],
    ["picture.png", Buffer.from("\x89PNG\r\n\x1a\n................", "latin1"), /picture\.png/],
  ]) {
    await page.scene(example("wheel-rail"));
    await page.file(name, bytes);
    const shown = `${await page.text("message")} ${await page.text("scene-error")}`;
    assert.match(shown, wanted);
    assert.ok(!/undefined|NaN m|panicked/.test(shown), shown);
  }
  await page.scene(example("wheel-rail"));
  assert.deepEqual([await page.phase(), await page.text("scene-error")], ["ready", ""]);
});

test("nothing of a scene or of a file's name becomes markup", async () => {
  const sly = '<img src=x onerror="document.title=1"><b id=sly>';
  await page.scene(example("wheel-rail").replace(/hardness = .*/, `hardness = '${sly}'`));
  assert.match(await page.text("scene-error"), /<b id=sly>/);
  await page.scene(example("wheel-rail"));
  await page.file('<b id=sly>"&.txt', matrix(nanometres()));
  assert.match(await page.value("scene"), /<b id=sly>/);
  assert.ok(Object.keys(await page.values()).length > 5, await page.text("scene-error"));
  await page.file("<b id=sly>.x3p", "PK\u0003\u0004 nothing");
  assert.match(`${await page.text("message")} ${await page.text("scene-error")}`, /<b id=sly>/);
  assert.equal(await page.run("return document.getElementById('sly')"), null);
  assert.match(await page.run("return document.title"), /asperity/);
});
