#!/usr/bin/env bash
# What recording costs the servo: whether the machine code of its loop that nobody records is, instruction by instruction, that of a loop without any
# recorder (the same source without the lines that record), and how many instructions a tick takes by callgrind, unrecorded and recorded, with a simulated
# device in an empty space. Fails where they differ. 77: something it needs is not here.
#   tests/bench/recording_cost.sh [BUILD_FOLDER]     default build/release, where unit_record is built
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} ticks=3000 source=haptic/servo/servo_loop.cpp
for tool in valgrind objdump python3; do command -v "$tool" >/dev/null || { echo "Skipped: $tool is missing."; exit 77; }; done
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
grep -v 'if constexpr (kRecorded)' "$source" >"$work/without.cpp"
lines=$(grep -c 'if constexpr (kRecorded)' "$source")
cp "$source" "$work/with.cpp"
ninja -C "$build" -t compdb >"$work/commands.json"
# How a source of that folder is compiled, without what depends on its name.
flags=$(python3 - "$work/commands.json" <<'PY'
import json, shlex, sys
for one in json.load(open(sys.argv[1])):
    if "/handrail_servo.dir/" not in one.get("output", "") or not one["file"].endswith((".cpp", ".cxx")): continue
    words, keep, skip = shlex.split(one["command"]), [], False
    while words and not words[0].endswith(("c++", "g++")): words.pop(0)
    for word in words[1:]:
        if skip: skip = False
        elif word in ("-o", "-MF", "-MT", "-c", "-include"): skip = True
        elif word not in ("-MD", "-Winvalid-pch"): keep.append(word)
    print(shlex.join(keep))
    break
PY
)
for part in with without; do
    (cd "$build" && eval "c++ $flags -include cstring -c $work/$part.cpp -o $work/$part.o")
    objdump -d --no-addresses --no-show-raw-insn -C "$work/$part.o" |
        awk '/^<.*>:$/ {on = /(step|run)_as<false>/} on' >"$work/$part.txt"
done
code=$(grep -c . "$work/with.txt")
[ "$code" -gt 100 ] || { echo "The loop was not found in the machine code."; exit 1; }
cmp -s "$work/with.txt" "$work/without.txt" || { echo "A loop that nobody records differs from one without a recorder:"; diff "$work/with.txt" "$work/without.txt" | head -20; exit 1; }
echo "Unrecorded, the loop is the same $code lines of machine code with and without the $lines lines that record."
count() {
    valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect='*ServoLoop::step_as*' "$build/bin/unit_record" --gtest_filter="RecordedServo.$2" >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
    echo "$(($(awk '/^summary:/ {print $2}' "$work/out") / ticks)) instructions a tick, $1"
}
count unrecorded 'without_a_recording_*'
count recorded 'stores_each_tick_*'
