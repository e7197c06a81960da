// Colours, from the style sheet where it has them, so that light and dark agree with it.

export interface Theme {
  dark: boolean;
  ink: string;
  muted: string;
  line: string;
  scene: string;
  structure: string;
  edge: string;
  limit: string;
  contact: string;
  /** Of vehicles, plans and pairs. */
  series: string[];
  component: Record<string, string>;
}

const LIGHT = ["#1565c0", "#e67700", "#00897b", "#8e24aa", "#5d4037", "#ad1457", "#2e7d32", "#455a64", "#9e9d24", "#c62828"];
const DARK = ["#5aa9ff", "#ffab40", "#4dd0b8", "#ce93d8", "#bcaaa4", "#f48fb1", "#81c784", "#b0bec5", "#dce775", "#ef9a9a"];
const LIGHT_COMPONENT = { x: "#d1495b", y: "#2e8b57", z: "#2a6fbb", w: "#6b7780" };
const DARK_COMPONENT = { x: "#ff8593", y: "#6fd39b", z: "#7ab6ff", w: "#b4bfc6" };

const darkMode = matchMedia("(prefers-color-scheme: dark)");

export function theme(): Theme {
  const style = getComputedStyle(document.documentElement);
  const get = (name: string): string => style.getPropertyValue(`--${name}`).trim();
  return {
    dark: darkMode.matches,
    ink: get("ink"),
    muted: get("muted"),
    line: get("line"),
    scene: get("scene"),
    structure: get("structure"),
    edge: get("edge"),
    limit: get("limit"),
    contact: get("contact"),
    series: darkMode.matches ? DARK : LIGHT,
    component: darkMode.matches ? DARK_COMPONENT : LIGHT_COMPONENT,
  };
}

export function onThemeChange(listener: () => void): void {
  darkMode.addEventListener("change", listener);
}
