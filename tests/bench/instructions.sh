#!/usr/bin/env bash
# Mean instructions per servo_tick, and of touch_tick within it, on the recorded walk through quake-e1m1.map (ball 5 mm, scale 1), counted by callgrind.
#   tests/bench/instructions.sh [BUILD_FOLDER] [TICKS] [MOST]     default build/release 60000 5000; fails above MOST
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} ticks=${2:-60000} most=${3:-5000}
command -v valgrind >/dev/null || { echo "valgrind is missing; install the package valgrind."; exit 1; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for part in servo touch; do
    valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$build/bin/touch_walk" "$ticks" "$part" 2>/dev/null
    total=$(awk '/^summary:/ {print $2}' "$out")
    mean=$((total / ticks))
    echo "$mean instructions per ${part}_tick (mean of $ticks)"
    [ "$mean" -le "$most" ] || { echo "More than $most."; exit 1; }
done
