// A map of heights in whole nanometres, as text with its size and unit.
export function matrix({ side = 64, amplitude = 100, missing = 0 } = {}) {
  const height = (x, y) => Math.round(amplitude * (Math.sin(0.7 * x) + Math.cos(0.9 * y) + Math.sin(0.5 * x - 0.8 * y)));
  const row = (y) => Array.from({ length: side }, (_, x) => (x < missing ? "nan" : height(x, y))).join("\t");
  return `# Width: ${side} um\n# Height: ${side} um\n# Value units: nm\n${Array.from({ length: side }, (_, y) => row(y)).join("\n")}\n`;
}
