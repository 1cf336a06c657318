// A desk in a worker: messages in, answers out, so that the page never waits.
import init, { Desk } from "./asperity.js";

const hand = (id, file) => postMessage({ id, file }, [file.buffer]);
const ready = init().then(() => new Desk());

onmessage = async ({ data: { id, kind, message } }) => {
  try {
    const desk = await ready;
    let answer;
    if (kind === "hand") answer = desk.hand(message.name, new Uint8Array(message.bytes));
    else if (kind === "press") answer = desk.press(message.pressures, message.leaks, (event) => postMessage({ id, event }));
    else if (kind === "file") return postMessage({ id, file: desk.file(message.name) });
    else if (kind === "heights") return hand(id, desk.heights());
    else if (kind === "report") answer = desk.report(message.heights, message.shape);
    else answer = desk.call(message);
    postMessage({ id, answer });
  } catch (error) {
    // After a trap the memory of the module is not to be trusted.
    postMessage({ id, died: String(error) });
  }
};
