// Words that stand nowhere may be misspelt: the search knows words with one other letter as word~1.
const field = document.querySelector("input[name=query]");
const result = document.querySelector(".md-search-result__meta");
new MutationObserver(() => {
  const words = field.value.trim();
  if (!result.textContent.startsWith("No matching") || words.includes("~") || result.querySelector("button")) return;
  const near = document.createElement("button");
  near.textContent = "Search for words spelt like these";
  near.className = "md-button";
  near.addEventListener("click", () => {
    field.value = words.split(/\s+/).map((word) => (word.length > 3 ? `${word}~1` : word)).join(" ");
    field.dispatchEvent(new Event("keyup"));
    field.focus();
  });
  result.append(" ", near);
}).observe(result, { childList: true, characterData: true, subtree: true });
