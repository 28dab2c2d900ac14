// The numbers of measures.css.

const known = new Map();

export function measure(name) {
  let value = known.get(name);
  if (value === undefined) {
    value = parseFloat(getComputedStyle(document.documentElement).getPropertyValue(`--${name}`));
    known.set(name, value);
  }
  return value;
}
