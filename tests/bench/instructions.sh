#!/usr/bin/env bash
# Mean instructions per tick, counted by callgrind: of servo_tick, and of touch_tick within it, on the recorded walk through quake-e1m1.map (ball 5 mm,
# scale 1); with the word spheres, of touch_tick on spheres of 1e3 to 1e6 triangles (mesh_touch); with surfaces, on each way to feel a surface (surface_touch);
# with bodies, among things that stand or move (bodies_touch); with guidance, of servo_tick while the hand is not guided, pulled, and among 32 grooves.
#   tests/bench/instructions.sh [BUILD_FOLDER] [TICKS] [MOST] [walk|spheres|surfaces|bodies|guidance]     default build/release 60000 5000 walk; fails above MOST
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release} ticks=${2:-60000} most=${3:-5000} where=${4:-walk}
command -v valgrind >/dev/null || { echo "valgrind is missing; install the package valgrind."; exit 1; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
# count WHAT COMMAND...
count() {
    local what=$1
    shift
    valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$@" 2>/dev/null
    local mean=$(($(awk '/^summary:/ {print $2}' "$out") / ticks))
    echo "$mean instructions per $what (mean of $ticks)"
    [ "$mean" -le "$most" ] || { echo "More than $most."; exit 1; }
}
case $where in
walk) for part in servo touch; do count "${part}_tick" "$build/bin/touch_walk" "$ticks" "$part"; done ;;
spheres) for frequency in 7 22 71 224; do count touch_tick "$build/bin/mesh_touch" "$ticks" "$frequency" count; done ;;
surfaces) for kind in plain slippery weakening damped guarded rounded sheet one-sided friction sine square picture facets shaded; do count "touch_tick on $kind" "$build/bin/surface_touch" "$ticks" "$kind"; done ;;
bodies) for mode in none still far pushing; do count "touch_tick, bodies $mode" "$build/bin/bodies_touch" "$ticks" "$mode"; done ;;
guidance) for part in servo pull grooves; do count "servo_tick, $part" "$build/bin/touch_walk" "$ticks" "$part"; done ;;
*) echo "walk, spheres, surfaces, bodies or guidance, not $where."; exit 2 ;;
esac
