// What stands on the keys, by language: pages of rows, the first page to begin with.

const DIGITS = "1234567890";
const LATIN = {
  en: ["qwertyuiop", "asdfghjkl", "zxcvbnm'-"],
  de: ["qwertzuiopü", "asdfghjklöä", "yxcvbnmß-"],
  fr: ["azertyuiop", "qsdfghjklm", "wxcvbnéèç'-"],
};
const ACCENTS = ["àáâãäåæçèé", "êëìíîïñòó", "ôõöøùúûüœ"];
// As on the walls of schools: from right to left, a column a consonant. ゛, ゜ and 小 change
// what has just been typed.
const KANA = ["わらやまはなたさかあ", "をり゛みひにちしきい", "んるゆむふぬつすくう", "ーれ゜めへねてせけえ", "小ろよもほのとそこお"];

export const PAD = ["123", "456", "789"];

// label: what leads to the page. once: it is left again after one letter.
export function pages(language) {
  if (language === "ja") {
    return [
      { name: "kana", label: "あ", rows: KANA },
      { name: "latin", label: "abc", rows: [DIGITS, ...LATIN.en], shift: true },
    ];
  }
  return [
    { name: "letters", label: "abc", rows: [DIGITS, ...(LATIN[language] ?? LATIN.en)], shift: true },
    { name: "accents", label: "áü", rows: [DIGITS, ...ACCENTS], shift: true, once: true },
  ];
}

export const decimalMark = (language) => (["de", "fr", "es", "it", "nl", "pt"].includes(language) ? "," : ".");

const MARKS = { "゛": "\u3099", "゜": "\u309a" };
const LARGE = "あいうえおつやゆよわ";
const SMALL = "ぁぃぅぇぉっゃゅょゎ";

export const isChange = (key) => key in MARKS || key === "小";

// The letter as the key changes it, or back; the letter itself where there is no such thing.
export function changed(letter, key) {
  if (key === "小") {
    if (LARGE.includes(letter)) return SMALL[LARGE.indexOf(letter)];
    return SMALL.includes(letter) ? LARGE[SMALL.indexOf(letter)] : letter;
  }
  const plain = letter.normalize("NFD")[0];
  const made = (plain + MARKS[key]).normalize("NFC");
  if (made.length > 1) return letter;
  return made === letter ? plain : made;
}
