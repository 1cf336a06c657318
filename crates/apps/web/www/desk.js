// Desks in workers. A worker is started when it is first asked, and anew after it died.
export class Refusal extends Error {
  constructor({ message, line, field, died = false }) {
    super(message);
    Object.assign(this, { line, field, died });
  }
}

// Deaths of a worker without an answer in between: it is started anew twice.
const MOST_DEATHS = 3;

export class Desk {
  // `files`: what the page can hand over, by name: { file } of the computer or { keys } of a random
  // surface.
  constructor(files, start = () => new Worker(new URL("worker.js", import.meta.url), { type: "module" })) {
    Object.assign(this, { files, make: start, waiting: new Map(), next: 0, deaths: 0, broken: "" });
    this.end();
  }

  // Ends the worker; what was asked is refused with the reason.
  end(reason = "ended", died = false) {
    this.worker?.terminate();
    Object.assign(this, { worker: null, held: new Map(), text: null, shown: null });
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    waiting.forEach(({ reject }) => reject(new Refusal({ message: reason, died })));
  }

  start() {
    this.worker = this.make();
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => {
      event.preventDefault?.();
      this.died(event.message || "it could not be loaded");
    };
  }

  died(reason) {
    this.deaths += 1;
    const what = `the calculation ended unexpectedly (${String(reason).slice(0, 200)})`;
    if (this.deaths >= MOST_DEATHS) this.broken = `${what}, ${this.deaths} times in a row: save the scene file, and edit the scene or reload the page`;
    this.end(this.broken || `${what}: try again`, true);
  }

  // Another scene may succeed where the last one did not.
  forgive() {
    if (!this.broken) return;
    this.broken = "";
    this.deaths -= 1;
  }

  receive({ id, answer, event, file, died }) {
    const waiting = this.waiting.get(id);
    if (died) return this.died(died);
    if (event) return waiting?.happened?.(JSON.parse(event));
    this.waiting.delete(id);
    if (file) return waiting?.resolve(file);
    const { ok, error } = JSON.parse(answer);
    if (error) waiting?.reject(new Refusal(error));
    else waiting?.resolve(ok);
  }

  send(kind, message, happened, transfer = []) {
    if (this.broken) return Promise.reject(new Refusal({ message: this.broken }));
    if (!this.worker) this.start();
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, happened });
      this.worker.postMessage({ id, kind, message }, transfer);
    });
  }

  call(call, keys = {}) {
    return this.send("call", JSON.stringify({ call, ...keys }));
  }

  // Hands over a file of the page, whose bytes are read now; its name and its checksum.
  async hand(name, given) {
    let answer;
    if (given.keys) {
      answer = await this.call("random", { keys: given.keys });
    } else {
      await this.call("admit", { name, size: given.file.size });
      const bytes = await given.file.arrayBuffer().catch((error) => {
        throw new Refusal({ message: `${name} could not be read (${error.message}): choose it again`, field: "surface.file" });
      });
      answer = await this.send("hand", { name, bytes }, undefined, [bytes]);
    }
    this.held.set(answer.name, given);
    this.text = null;
    return answer;
  }

  // Makes a text the scene of this desk, with the files that it names and the page has.
  async show(text) {
    const [names, wanted] = [this.shown?.files ?? [], (name) => this.files.has(name) && this.held.get(name) !== this.files.get(name)];
    if (this.text === text && !names.some(wanted)) return this.shown;
    this.text = null;
    let shown = await this.call("show", { text });
    const missing = shown.files.filter(wanted);
    if (missing.length > 0) {
      for (const name of missing) await this.hand(name, this.files.get(name));
      shown = await this.call("show", { text });
    }
    // The desk keeps the files of its scene alone.
    for (const name of this.held.keys()) if (!shown.files.includes(name)) this.held.delete(name);
    Object.assign(this, { text, shown });
    return shown;
  }

  // Asks again while the worker died and may be started anew.
  async sure(asks) {
    for (;;) {
      try {
        const answer = await asks();
        this.deaths = 0;
        return answer;
      } catch (error) {
        if (!error.died || this.broken) throw error;
      }
    }
  }

  // Shows a text to a worker that lives on when it has been shown.
  async ready(text) {
    await this.show(text);
    if (this.text !== text) throw new Refusal({ message: "the calculation was started anew: try again", died: true });
  }

  // Asks about the scene of a text.
  ask(text, call, keys = {}) {
    return this.sure(async () => {
      await this.ready(text);
      return this.call(call, keys);
    });
  }

  async press(text, pressures, leaks, happened) {
    await this.sure(() => this.ready(text));
    const answer = await this.send("press", { pressures: new Float64Array(pressures), leaks }, happened);
    this.deaths = 0;
    return answer;
  }

  // The bytes of a file of the scene.
  async file(text, name) {
    await this.sure(() => this.ready(text));
    return this.send("file", { name });
  }
}
