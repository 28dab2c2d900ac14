// Dates typed by digits alone, in the order that the screen's language writes them in.

const SIZES = { day: 2, month: 2, year: 4 };
const WRITTEN = /^(?<year>\d{4})-(?<month>\d{2})-(?<day>\d{2})$/;
const LETTERS = {
  en: { day: "D", month: "M", year: "Y" },
  de: { day: "T", month: "M", year: "J" },
  fr: { day: "J", month: "M", year: "A" },
  es: { day: "D", month: "M", year: "A" },
};

// The parts in their order, and what stands between them.
function written() {
  const language = document.documentElement.lang.replaceAll("_", "-");
  const options = { calendar: "gregory", numberingSystem: "latn" };
  let format;
  try {
    format = new Intl.DateTimeFormat(language, options);
  } catch {
    format = new Intl.DateTimeFormat("en", options);
  }
  const parts = format.formatToParts(new Date(2000, 0, 2));
  return {
    order: parts.map((part) => part.type).filter((type) => type in SIZES),
    between: parts.find((part) => part.type === "literal")?.value.trim() || "-",
  };
}

// What is to be typed, as DD/MM/YYYY.
export function datePattern() {
  const { order, between } = written();
  const letters = LETTERS[document.documentElement.lang.slice(0, 2)] ?? LETTERS.en;
  return order.map((type) => letters[type].repeat(SIZES[type])).join(between);
}

// What has been typed, as a date as far as it goes.
export function dateTyped(text) {
  const { order, between } = written();
  let digits = text.replace(/\D/g, "");
  const pieces = [];
  for (const type of order) {
    if (digits) pieces.push(digits.slice(0, SIZES[type]));
    digits = digits.slice(SIZES[type]);
  }
  return pieces.join(between);
}

// YYYY-MM-DD of what was typed; undefined: there is no such day (yet).
export function dateRead(text) {
  let digits = text.replace(/\D/g, "");
  const found = {};
  for (const type of written().order) {
    found[type] = digits.slice(0, SIZES[type]);
    digits = digits.slice(SIZES[type]);
  }
  const date = `${found.year}-${found.month}-${found.day}`;
  return isDay(date) ? date : undefined;
}

// Whether it is YYYY-MM-DD of a day that there is.
export function isDay(text) {
  const moment = new Date(`${text}T00:00Z`);
  return WRITTEN.test(text) && !Number.isNaN(moment.getTime()) && moment.toISOString().startsWith(text);
}

// The reverse of `dateRead`; what is no date stays as it is.
export function dateShown(value) {
  const match = WRITTEN.exec(value);
  return match ? dateTyped(written().order.map((type) => match.groups[type]).join("")) : value;
}
