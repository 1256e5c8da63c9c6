import type { Page } from "playwright-core";

/** What a canvas shows in the colour of the first cell. */
export interface CellPixels {
  count: number;
  /** Mean place from the canvas's left edge, as a fraction of its width. */
  x: number;
}

export function cellPixels(page: Page, selector: string): Promise<CellPixels> {
  return page.evaluate((wanted) => {
    const canvas = document.querySelector<HTMLCanvasElement>(wanted);
    if (!canvas) throw new Error(`no ${wanted}`);
    const name = getComputedStyle(document.documentElement).getPropertyValue("--cell-0").trim();
    const [red, green, blue] = [1, 3, 5].map((i) => parseInt(name.slice(i, i + 2), 16)) as [
      number,
      number,
      number,
    ];
    const { data } = canvas.getContext("2d")!.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      const off = Math.abs(data[i]! - red) + Math.abs(data[i + 1]! - green) + Math.abs(data[i + 2]! - blue);
      if (off > 24 || data[i + 3]! < 200) continue;
      count += 1;
      sum += (i / 4) % canvas.width;
    }
    return { count, x: count > 0 ? sum / count / canvas.width : NaN };
  }, selector);
}
