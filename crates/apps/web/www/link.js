// The state of the page in its address: a copied link, back and forward restore all of it.
import { $, tell } from "./page.js";
import { desks, files, page, state, work } from "./state.js";

// What the user did since the address was written, and what it was written for last.
let [done, last, written] = ["open", "open", ""];

// While the user slides or types, one entry of the history is enough.
const ONE_ENTRY = ["slide", "type"];

export function note(kind) {
  done = kind;
}

// The next movement of the slider, or the next typing, is an entry of its own.
export function rest() {
  last = null;
}

export const writeLink = () => work("page", "link", async () => {
  const kind = done;
  done = null;
  const { text, models, load, view, scan, random, example, leak } = state;
  try {
    const hash = `#s=${await desks.quick.call("link", { state: { scene: text, models, load, view, scan, random, example, leak } })}`;
    if (hash === location.hash) return;
    // The link beside the button is no longer that of the page.
    $("link").hidden = true;
    const again = kind === null || kind === "open" || (kind === last && ONE_ENTRY.includes(kind));
    history[again ? "replaceState" : "pushState"](null, "", hash);
    written = hash;
    last = kind ?? last;
  } catch {
    // The address stays as it is; the page goes on.
  }
});

// Opens the state of the address; whether there was one, and a message if it was not opened.
export async function openLink(setScene) {
  const { hash } = location;
  if (!hash.startsWith("#s=") || hash === written) return { opened: false };
  let found;
  try {
    found = await desks.quick.call("unlink", { link: hash.slice(3) });
  } catch (error) {
    return { opened: false, message: error.message };
  }
  written = hash;
  const { scene, models, load, view, scan, random, example, leak = false } = found;
  Object.assign(state, { models, load, view, scan, random, example, leak });
  if (random && scan && files.get(scan.name)?.checksum !== scan.checksum) files.set(scan.name, { keys: random, checksum: scan.checksum });
  page.wanted = scan && files.get(scan.name)?.checksum !== scan.checksum ? scan : null;
  await setScene(scene, "open");
  if (page.wanted) tell(`The link was made with the scan ${scan.name} (checksum ${scan.checksum}), which it does not contain: choose or drop that file.`);
  return { opened: true };
}

// What there is to say about a file that was given: null if it is the one that the link asks for,
// under whatever name.
export function given(scan) {
  const { wanted } = page;
  if (wanted?.checksum !== scan.checksum) {
    const other = wanted && `${scan.name} is not the file of the link: its checksum is ${scan.checksum}, that of the link ${wanted.checksum}; it is used in its place.`;
    return { name: scan.name, message: other };
  }
  page.wanted = null;
  return { name: wanted.name, message: null };
}
