/** The colours of the style sheet, for what is drawn on a canvas. */
export interface Theme {
  text: string;
  quiet: string;
  line: string;
  lumen: string;
  tissue: string;
  cells: string[];
}

export function readTheme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const read = (name: string) => style.getPropertyValue(name).trim();
  return {
    text: read("--text"),
    quiet: read("--quiet"),
    line: read("--line"),
    lumen: read("--lumen"),
    tissue: read("--tissue"),
    cells: [read("--cell-0"), read("--cell-1"), read("--cell-2"), read("--cell-3")],
  };
}

/** Calls back whenever the system changes between light and dark. */
export function onThemeChange(changed: () => void): () => void {
  const query = window.matchMedia("(prefers-color-scheme: dark)");
  query.addEventListener("change", changed);
  return () => query.removeEventListener("change", changed);
}

/** Five stops of viridis: even to the eye, and legible to those who do not see all colours. */
const stops = [
  [68, 1, 84],
  [59, 82, 139],
  [33, 145, 140],
  [94, 201, 98],
  [253, 231, 37],
] as const;

/** The colour of a fraction from 0 to 1. */
export function speedColour(fraction: number): string {
  const place = Math.min(1, Math.max(0, fraction)) * (stops.length - 1);
  const from = Math.min(stops.length - 2, Math.floor(place));
  const part = place - from;
  const mix = stops[from]!.map((value, k) => Math.round(value + (stops[from + 1]![k]! - value) * part));
  return `rgb(${mix.join(" ")})`;
}
