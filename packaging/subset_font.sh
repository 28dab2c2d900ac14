#!/bin/sh
# Makes resources/fonts/NotoSansCJKjp-*.otf of Noto Sans CJK (Debian: fonts-noto-cjk), given where it
# lies: the letters of JIS X 0208 and of names (code page 932); of the rarer
# ones (level 2) no bold. Needs fonttools.
#     sh packaging/subset_font.sh /usr/share/fonts/opentype/noto
set -eu
cd "$(dirname "$0")/../resources/fonts"
letters=$(mktemp)
trap 'rm -f "$letters"' EXIT
for weight in Regular Bold; do
    python3 - "$weight" >"$letters" <<'PYTHON'
import sys

pairs = [bytes([lead, trail]) for lead in range(0x81, 0xFD) for trail in range(0x40, 0xFD)]
if sys.argv[1] == "Bold":
    pairs = [pair for pair in pairs if pair < b"\x98\x9f"]
halfwidth = range(0xFF61, 0xFFA0)
print("".join(map(chr, range(0x20, 0x7F))), "〜‖−", *map(chr, halfwidth))
print(*(pair.decode("cp932", "ignore") for pair in pairs))
PYTHON
    pyftsubset "$1/NotoSansCJK-$weight.ttc" --font-number=0 --text-file="$letters" --no-hinting \
        --layout-features=palt,vert,locl,ccmp --name-IDs='*' \
        --output-file="NotoSansCJKjp-$weight.otf"
done
