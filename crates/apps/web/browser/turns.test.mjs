// The order of work and the restarts of workers, without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Desk } from "../www/desk.js";
import { Turns } from "../www/turns.js";

const gate = () => {
  let open;
  const promise = new Promise((resolve) => { open = resolve; });
  return { promise, open };
};

test("order of pieces", async () => {
  const [turns, done, first] = [new Turns(), [], gate()];
  const piece = (name) => async () => done.push(name);
  const running = turns.add("page", "answer", async () => { await first.promise; done.push("answer 1"); });
  const replaced = turns.add("page", "answer", piece("answer 2"));
  turns.add("page", null, piece("edit 1"));
  turns.add("page", null, piece("edit 2"));
  const last = turns.add("page", "answer", piece("answer 3"));
  turns.add("other", "answer", piece("elsewhere"));
  assert.ok(turns.busy);
  assert.equal(await replaced, undefined);
  first.open();
  await Promise.all([running, last]);
  assert.deepEqual(done, ["elsewhere", "answer 1", "edit 1", "edit 2", "answer 3"]);
  await new Promise(setImmediate);
  assert.ok(!turns.busy);
});

test("running pieces", async () => {
  const [turns, first] = [new Turns(), gate()];
  const answer = turns.add("page", "answer", async () => { await first.promise; return "all of it"; });
  turns.add("page", "draw", async () => {});
  first.open();
  assert.equal(await answer, "all of it");
});

test("failures are told", async () => {
  const turns = new Turns();
  const wrong = turns.add("page", "a", async () => { throw new Error("no"); });
  const right = turns.add("page", "a", async () => "yes");
  await assert.rejects(wrong, /no/);
  assert.equal(await right, "yes");
});

test("never idle between", async () => {
  const seen = [];
  const turns = new Turns(() => seen.push(turns?.busy));
  let inner;
  await turns.add("page", "edit", async () => {
    inner = turns.add("page", "scene", async () => {});
  });
  await inner;
  await new Promise(setImmediate);
  assert.equal(seen.pop(), false);
  assert.ok(seen.every(Boolean), String(seen));
});

// A worker that answers, or dies at messages that contain a word.
function workers(deadly = /$^/) {
  const made = [];
  const start = () => {
    const worker = { calls: [], terminate() { this.ended = true; } };
    worker.postMessage = ({ id, message }) => {
      worker.calls.push(message);
      const text = typeof message === "string" ? message : message.name;
      const files = text.includes("a.txt") ? ["a.txt"] : [];
      const data = deadly.test(text) ? { id, died: "unreachable" } : { id, answer: JSON.stringify({ ok: { files, name: "a.txt", checksum: "1" } }) };
      queueMicrotask(() => worker.ended || worker.onmessage({ data }));
    };
    made.push(worker);
    return worker;
  };
  return { made, start };
}

test("deadly texts end", async () => {
  const { made, start } = workers(/poison/);
  const desk = new Desk(new Map(), start);
  assert.equal(made.length, 0);
  await desk.ask("good", "answer");
  await assert.rejects(desk.ask("poison", "answer"), /3 times in/);
  assert.equal(made.length, 3, "two restarts");
  await assert.rejects(desk.ask("good", "answer"), /3 times in/);
  assert.equal(made.length, 3, "and no more");
  desk.forgive();
  await desk.ask("good again", "answer");
  assert.equal(made.length, 4);
  assert.deepEqual(made[3].calls.map((text) => JSON.parse(text).call), ["show", "answer"]);
});

test("texts shown again", async () => {
  const { made, start } = workers();
  const desk = new Desk(new Map(), start);
  await desk.ask("good", "answer");
  const answer = desk.ask("good", "curve");
  desk.died("unreachable");
  await answer;
  assert.deepEqual(made[1].calls.map((text) => JSON.parse(text).call), ["show", "curve"]);
});

test("files handed over", async () => {
  const { made, start } = workers();
  const file = (text) => ({ file: { size: text.length, arrayBuffer: async () => new TextEncoder().encode(text).buffer } });
  const files = new Map([["a.txt", file("one")], ["b.txt", file("two")]]);
  const desk = new Desk(files, start);
  const given = () => made.at(-1).calls.filter((message) => message.name).map(({ name }) => name);
  await desk.ask("no file", "answer");
  assert.deepEqual(given(), []);
  await desk.ask("a.txt", "answer");
  await desk.ask("a.txt", "curve");
  assert.deepEqual(given(), ["a.txt"]);
  files.set("a.txt", file("other"));
  await desk.ask("a.txt", "curve");
  assert.deepEqual(given(), ["a.txt", "a.txt"]);
  desk.end("stopped");
  await desk.ask("a.txt", "curve");
  assert.equal(made.length, 2);
  assert.deepEqual(given(), ["a.txt"]);
});
