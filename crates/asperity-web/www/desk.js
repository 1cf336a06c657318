// Desks in workers. A desk that dies is started anew with its files and its scene.
export class Refusal extends Error {
  constructor({ message, line, field }) {
    super(message);
    Object.assign(this, { line, field });
  }
}

export class Desk {
  constructor() {
    this.waiting = new Map();
    this.next = 0;
    // What a new worker needs to know.
    this.files = new Map();
    this.text = null;
    this.start();
  }

  start() {
    this.worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.restart(event.message || "the worker could not be started");
    };
  }

  receive({ id, answer, event, died }) {
    const waiting = this.waiting.get(id);
    if (event) waiting?.happened?.(JSON.parse(event));
    if (died) return this.restart(died);
    if (answer === undefined) return;
    this.waiting.delete(id);
    const { ok, error } = JSON.parse(answer);
    if (error) waiting?.reject(new Refusal(error));
    else waiting?.resolve(ok);
  }

  // Ends the worker at once; what was asked is refused.
  restart(reason) {
    this.worker.terminate();
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    this.start();
    for (const [name, file] of this.files) this.send(file.keys ? "call" : "hand", this.told(name, file)).catch(() => {});
    if (this.text !== null) this.send("call", JSON.stringify({ call: "show", text: this.text })).catch(() => {});
    waiting.forEach(({ reject }) => reject(new Refusal({ message: reason })));
  }

  told(name, { bytes, keys }) {
    return keys ? JSON.stringify({ call: "random", keys }) : { name, bytes };
  }

  send(kind, message, happened) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, happened });
      this.worker.postMessage({ id, kind, message });
    });
  }

  call(call, keys = {}) {
    return this.send("call", JSON.stringify({ call, ...keys }));
  }

  show(text) {
    this.text = text;
    return this.call("show", { text });
  }

  // A file is kept only once the desk has accepted the bytes.
  async hand(name, file) {
    const answer = await this.send(file.keys ? "call" : "hand", this.told(name, file));
    this.files.set(answer.name, file);
    return answer;
  }

  press(pressures, happened) {
    return this.send("press", { pressures: new Float64Array(pressures) }, happened);
  }
}
