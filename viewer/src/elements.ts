// Elements of the page by their ids, which page.html among the assets promises.

export function element<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no #${id}`);
  return found as T;
}

/** A checkbox with its text. */
export function checkbox(text: string, checked: boolean, changed: (on: boolean) => void): HTMLLabelElement {
  const label = document.createElement("label");
  const input = document.createElement("input");
  input.type = "checkbox";
  input.checked = checked;
  input.addEventListener("change", () => {
    changed(input.checked);
  });
  label.append(input, ` ${text}`);
  return label;
}

export function option(value: string, text: string): HTMLOptionElement {
  const made = document.createElement("option");
  made.value = value;
  made.textContent = text;
  return made;
}

export interface LegendItem {
  text: string;
  color: string;
  dash?: number[];
  dot?: boolean;
}

/** Swatches with text. */
export function fillLegend(host: HTMLElement, items: LegendItem[]): void {
  host.replaceChildren(
    ...items.map(({ text, color, dash, dot }) => {
      const item = document.createElement("span");
      const swatch = document.createElementNS("http://www.w3.org/2000/svg", "svg");
      swatch.setAttribute("viewBox", "0 0 28 10");
      swatch.setAttribute("aria-hidden", "true");
      const kind = dot ? "circle" : dash ? "line" : "rect";
      const mark = document.createElementNS("http://www.w3.org/2000/svg", kind);
      const shape: Record<string, Record<string, string>> = {
        circle: { cx: "14", cy: "5", r: "4", fill: color },
        line: { x1: "0", x2: "28", y1: "5", y2: "5", stroke: color, "stroke-width": "2.5", "stroke-dasharray": (dash ?? []).join(" ") },
        rect: { width: "28", height: "10", rx: "2", fill: color },
      };
      for (const [key, value] of Object.entries(shape[kind])) mark.setAttribute(key, value);
      swatch.append(mark);
      item.append(swatch, ` ${text}`);
      return item;
    }),
  );
}
