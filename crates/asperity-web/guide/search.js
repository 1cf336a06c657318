// Finds titles and headings that have all the words; the index is a file beside this one.

const MOST = 20;
const place = document.getElementById("search");
const query = document.getElementById("query");
const found = document.getElementById("found");
let index;

const plain = (text) => text.toLowerCase();

function matches(entries, words) {
  const rank = ({ page, heading }) => {
    const [title, text] = [plain(page), plain(heading)];
    if (!words.every((word) => title.includes(word) || text.includes(word))) return 0;
    // Whole pages first, then headings that have a word themselves.
    if (!heading) return 3;
    return words.some((word) => text.includes(word)) ? 2 : 1;
  };
  const ranked = entries.map((entry) => [rank(entry), entry]).filter(([score]) => score > 0);
  return ranked.sort(([a], [b]) => b - a).slice(0, MOST).map(([, entry]) => entry);
}

function item({ page, heading, address }) {
  const link = document.createElement("a");
  link.href = address;
  link.textContent = heading || page;
  if (heading) {
    const where = document.createElement("span");
    where.textContent = ` in ${page}`;
    link.append(where);
  }
  const row = document.createElement("li");
  row.append(link);
  return row;
}

function message(text) {
  const row = document.createElement("li");
  row.textContent = text;
  return row;
}

async function read() {
  return (await fetch("search.json")).json();
}

async function search() {
  const asked = query.value;
  const words = plain(asked).split(/\s+/).filter(Boolean);
  let entries;
  try {
    entries = await (index ??= read());
  } catch {
    index = undefined;
    found.replaceChildren(message("the index search.json cannot be read; use the contents"));
    return;
  }
  // Typed on while the index was read: the later search answers.
  if (asked !== query.value) return;
  const rows = words.length > 0 ? matches(entries, words).map(item) : [];
  found.replaceChildren(...(words.length > 0 && rows.length === 0 ? [message("no title or heading has these words")] : rows));
}

query.addEventListener("input", search);
place.addEventListener("keydown", (event) => {
  if (event.key === "Escape") {
    query.value = "";
    found.replaceChildren();
    query.focus();
  }
  if (event.key === "Enter" && event.target === query) found.querySelector("a")?.click();
});
// A result on this page leaves the page where it is.
found.addEventListener("click", () => found.replaceChildren());
place.hidden = false;
// On a narrow screen the text comes first.
if (matchMedia("(max-width: 56rem)").matches) document.querySelector("details").open = false;
