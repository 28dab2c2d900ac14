#!/bin/sh
# What a robot gets: situ without Qt, from a clean environment, running a project of its own.
# bare_check.sh PYTHON
set -eu
here=$(cd "$(dirname "$0")/.." && pwd)
bare=$(mktemp -d)
trap 'rm -rf "$bare"' EXIT
"$1" -m venv "$bare/venv"
"$bare/venv/bin/python" -m pip install -qq --disable-pip-version-check "$here" -c "$here/constraints.txt"
cd "$bare"
if venv/bin/python -c 'import PySide6' 2>/dev/null; then
    echo "bare_check: Qt was installed with situ; it belongs to the extra studio" >&2
    exit 1
fi
venv/bin/situ new ward --template conversation
for scenario in ward/scenarios/*.jsonl; do
    venv/bin/situ run ward --script "$scenario" --speed 50 --endpoint tcp://127.0.0.1:0 --state state
done
