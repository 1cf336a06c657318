// A browser over WebDriver, with nothing but node: chromium and chromedriver must be installed.
import { spawn } from "node:child_process";
import { request } from "node:http";
import { createServer } from "node:net";

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

function freePort() {
  return new Promise((resolve) => {
    const server = createServer().listen(0, "127.0.0.1", () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

// A connection each: one that is kept is closed unseen while a test waits for the program.
function ask(url, method, body) {
  return new Promise((resolve, reject) => {
    const asked = request(url, { method, agent: false }, async (answer) => {
      const parts = [];
      for await (const part of answer) parts.push(part);
      resolve(Buffer.concat(parts).toString());
    });
    asked.on("error", reject);
    asked.end(body && JSON.stringify(body));
  });
}

export async function open({ width = 1280, height = 900, dark = false, downloads } = {}) {
  const port = await freePort();
  const driver = spawn("chromedriver", [`--port=${port}`], { stdio: "ignore" });
  const send = async (method, path, body) => {
    const { value } = JSON.parse(await ask(`http://127.0.0.1:${port}${path}`, method, body));
    if (value?.error) throw new Error(`${value.error}: ${value.message.slice(0, 400)}`);
    return value;
  };
  for (let k = 0; k < 150; k++) {
    if (await send("GET", "/status").then(({ ready }) => ready, () => false)) break;
    await pause(100);
  }
  const args = ["--headless=new", "--no-sandbox", "--disable-gpu", `--window-size=${width},${height}`];
  if (dark) args.push("--blink-settings=preferredColorScheme=0");
  const prefs = downloads ? { "download.default_directory": downloads, "profile.default_content_setting_values.automatic_downloads": 1 } : {};
  const wanted = { "goog:chromeOptions": { args, prefs }, "goog:loggingPrefs": { browser: "ALL", performance: "ALL" } };
  const { sessionId } = await send("POST", "/session", { capabilities: { alwaysMatch: wanted } });
  const call = (method, path, body) => send(method, `/session/${sessionId}${path}`, body);
  const run = (script, ...values) => call("POST", "/execute/sync", { script, args: values });
  const cdp = (cmd, params) => call("POST", "/goog/cdp/execute", { cmd, params });
  return {
    pid: driver.pid,
    call,
    run,
    cdp,
    // The value that a promise of the script gives.
    later: (script, ...values) => call("POST", "/execute/async", {
      script: `const done = arguments[arguments.length - 1]; (async (...values) => { ${script} })(...[...arguments].slice(0, -1)).then(done, (error) => done({ error: String(error) }))`,
      args: values,
    }),
    go: (url) => call("POST", "/url", { url }),
    async until(script, what = script, seconds = 120) {
      for (const end = Date.now() + 1000 * seconds; Date.now() < end; await pause(50)) {
        const found = await run(script);
        if (found) return found;
      }
      throw new Error(`not within ${seconds} s: ${what}`);
    },
    async element(selector) {
      const found = await call("POST", "/element", { using: "css selector", value: selector });
      return Object.values(found)[0];
    },
    async type(selector, text) {
      await call("POST", `/element/${await this.element(selector)}/value`, { text });
    },
    keys: (list) => call("POST", "/actions", {
      actions: [{ type: "key", id: "keys", actions: list.flatMap((value) => [{ type: "keyDown", value }, { type: "keyUp", value }]) }],
    }),
    errors: async () => (await call("POST", "/se/log", { type: "browser" })).filter(({ level }) => level === "SEVERE").map(({ message }) => message),
    async requests() {
      const log = await call("POST", "/se/log", { type: "performance" });
      const events = log.map(({ message }) => JSON.parse(message).message);
      return events.filter(({ method }) => method === "Network.requestWillBeSent").map(({ params }) => params.request.url);
    },
    async picture() {
      return Buffer.from(await call("GET", "/screenshot"), "base64");
    },
    async close() {
      await call("DELETE", "").catch(() => {});
      driver.kill();
    },
  };
}
