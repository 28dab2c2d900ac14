// Sizes of text: percent of the screen's height as designed, smaller where it would not fit.

const SMALLEST = 11;

// What "percent of the screen's height" is worth in `area`. A tall narrow one (a phone held
// upright) is measured by its width, so that headings stay in proportion to the lines.
export function unit(area) {
  return Math.min(area.clientHeight, area.clientWidth * 1.25) / 100;
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
    const sizes = nodes.map((node) => parseFloat(node.style.fontSize));
    const least = Math.min(...sizes);
    for (const node of nodes) node.style.fontSize = `${least}px`;
  }
}

// Sets the largest size up to `wanted` px at which `inner` lies inside `box`. Words stay whole
// unless that makes them much smaller (Japanese may be parted anywhere) or too small to fit.
export function fit(box, inner, wanted) {
  const fits = (size) => {
    box.style.fontSize = `${size}px`;
    // The padding grows and shrinks with the text.
    const style = getComputedStyle(box);
    const width = box.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
    const height = box.clientHeight - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom);
    return inner.scrollWidth <= width + 1 && inner.scrollHeight <= height + 1;
  };
  const largest = () => {
    if (fits(wanted)) return wanted;
    let low = SMALLEST;
    let high = wanted;
    while (high - low > 0.5) {
      const middle = (low + high) / 2;
      if (fits(middle)) low = middle;
      else high = middle;
    }
    return fits(low) ? low : 0;
  };
  if (box.clientWidth === 0) return;
  delete box.dataset.parted;
  delete box.dataset.cut;
  if (largest() >= wanted * 0.6) return;
  box.dataset.parted = "script";
  if (largest() > 0) return;
  box.dataset.parted = "anywhere";
  // What does not fit at any size shows its beginning, and nothing beside its box.
  if (largest() === 0) box.dataset.cut = "true";
}
