// Colours that a designer gave, checked before they are used.

import { measure } from "./measures.js";

export function colour(text) {
  return typeof text === "string" && CSS.supports("color", text) ? text : "";
}

// Whether dark letters are easier to read on this colour than white ones (WCAG 2).
export function isLight(node) {
  const parts = getComputedStyle(node).backgroundColor.match(/[\d.]+/g)?.map(Number) ?? [];
  if (parts.length === 4 && parts[3] < 0.5) return true;
  const [red, green, blue] = parts.map((part) => {
    const share = part / 255;
    return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue > measure("light");
}
