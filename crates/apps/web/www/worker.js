// A desk in a worker: messages in, answers out, so that the page never waits.
import init, { Desk } from "./asperity.js";

const ready = init().then(() => new Desk());

onmessage = async ({ data: { id, kind, message } }) => {
  try {
    const desk = await ready;
    let answer;
    if (kind === "hand") answer = desk.hand(message.name, new Uint8Array(message.bytes));
    else if (kind === "press") answer = desk.press(message.pressures, message.leaks, (event) => postMessage({ id, event }));
    else if (kind === "file") return postMessage({ id, file: desk.file(message.name) });
    else answer = desk.call(message);
    postMessage({ id, answer });
  } catch (error) {
    // After a trap the memory of the module is not to be trusted.
    postMessage({ id, died: String(error) });
  }
};
