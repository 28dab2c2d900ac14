// Sizes and lines of text: percent of the screen's height as designed, smaller where it would not
// fit. The editor follows the same steps (docs/screen.md): change both.

import { element } from "./element.js";
import { measure } from "./measures.js";

const fitted = new WeakMap(); // box -> {key: what its size hangs on, size, even: what its lines do}
let fonts = 0; // how often some have come

export function fontsCame() {
  fonts += 1;
}

// What "percent of the screen's height" is worth in `area`. A tall narrow one (a phone held
// upright) is measured by its width, so that headings stay in proportion to the lines.
export function unit(area) {
  return Math.min(area.clientHeight, area.clientWidth * measure("narrow")) / 100;
}

// What looks alike is written alike: all of one kind, box and wanted size as small as the one
// that has the most to say.
export function even(parts) {
  const groups = new Map();
  for (const { node, component } of parts) {
    if (component.type !== "button" || node.dataset.cut) continue;
    const key = JSON.stringify([component.width, component.height, component.size]);
    groups.set(key, [...(groups.get(key) ?? []), node]);
  }
  for (const nodes of groups.values()) {
    const least = Math.min(...nodes.map((node) => fitted.get(node)?.size ?? Infinity));
    for (const node of nodes) node.style.fontSize = `${least}px`;
  }
}

// Writes a text in its parts: white space, or phrases, each a list of what must not be parted of
// it. Lines end between them: phrases stay whole, unless they are `parted`.
export function write(inner, parts, parted = false) {
  const nodes = [];
  for (const part of parts) {
    if (typeof part === "string") {
      nodes.push(part);
      continue;
    }
    for (const one of parted ? part : [part.join("")]) {
      const whole = element("span", "whole");
      whole.textContent = one;
      if (nodes.at(-1)?.className === "whole") nodes.push(element("wbr"));
      nodes.push(whole);
    }
  }
  inner.replaceChildren(...nodes);
}

// Writes a text into `inner`, in the largest size up to `wanted` px at which it lies inside `box`.
// Phrases stay whole unless that makes them much smaller, words unless nothing else fits. What says
// the same in the same room stays as it is.
export function fit(box, inner, wanted, parts) {
  const { clientWidth, clientHeight, dataset } = box;
  if (clientWidth === 0) return;
  const key = JSON.stringify([fonts, clientWidth, clientHeight, wanted, dataset.filled, dataset.rank, parts]);
  if (fitted.get(box)?.key === key) return;
  fitAnew(box, inner, wanted, parts);
  fitted.set(box, { key, size: parseFloat(box.style.fontSize) });
}

function fitAnew(box, inner, wanted, parts) {
  const smallest = measure("smallest");
  const fits = (size) => {
    box.style.fontSize = `${size}px`;
    // The padding grows and shrinks with the text.
    const style = getComputedStyle(box);
    const width = parseFloat(style.width) - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
    const height = parseFloat(style.height) - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom);
    return inner.scrollWidth <= width + 1 && parseFloat(getComputedStyle(inner).height) <= height + 1;
  };
  const largest = () => {
    if (fits(wanted)) return wanted;
    let low = smallest;
    let high = wanted;
    while (high - low > 0.5) {
      const middle = (low + high) / 2;
      if (fits(middle)) low = middle;
      else high = middle;
    }
    return fits(low) ? low : 0;
  };
  inner.style.width = "";
  if (box.dataset.parted || inner.textContent !== parts.flat().join("")) write(inner, parts);
  delete box.dataset.parted;
  delete box.dataset.cut;
  if (largest() >= wanted * measure("whole")) return;
  write(inner, parts, true);
  box.dataset.parted = "script";
  if (largest() > 0) return;
  box.dataset.parted = "anywhere";
  // What does not fit at any size shows its beginning, and nothing beside its box.
  if (largest() === 0) box.dataset.cut = "true";
}

// Evens out the lines of a text: as narrow as it can be without one more.
export function balance(box, inner) {
  const known = fitted.get(box);
  if (!known || known.even === box.style.fontSize) return;
  known.even = box.style.fontSize;
  inner.style.width = "";
  const high = inner.clientHeight;
  if (box.dataset.cut || high < parseFloat(getComputedStyle(inner).lineHeight) * 1.5) return;
  const most = Math.ceil(parseFloat(getComputedStyle(inner).width));
  let [low, least] = [0, most];
  while (least - low > 1) {
    const middle = Math.floor((low + least) / 2);
    inner.style.width = `${middle}px`;
    if (inner.clientHeight > high || inner.scrollWidth > middle) low = middle;
    else least = middle;
  }
  // One more, so that nothing hangs on how letters are rounded.
  inner.style.width = least < most ? `${least + 1}px` : "";
}
