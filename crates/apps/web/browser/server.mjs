// A static server for the tests, below a folder of its own name: links must be relative.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const KINDS = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".svg": "image/svg+xml" };

export function serve(folder) {
  const server = createServer(async ({ url }, answer) => {
    const path = normalize(new URL(url, "http://x").pathname).replace(/^\/some\/where\//, "");
    try {
      const bytes = await readFile(join(folder, path || "index.html"));
      answer.writeHead(200, { "Content-Type": KINDS[extname(path)] ?? "text/plain" }).end(bytes);
    } catch {
      answer.writeHead(404).end();
    }
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => {
    resolve({ url: `http://127.0.0.1:${server.address().port}/some/where/index.html`, close: () => server.close() });
  }));
}
