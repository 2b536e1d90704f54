#!/usr/bin/env bash
# Instructions per tick of every renderer on some scenes, counted by callgrind: the same on any machine. Lines "SCENE<tab>RENDERER<tab>INSTRUCTIONS" on
# standard output, for `compare_renderers --instructions FILE`.
#   tests/bench/compare.sh [BUILD_FOLDER] [SCENE...]      default build/release and the scenes below, as `compare_renderers --list` names them
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
shift || true
scenes=("$@")
[ ${#scenes[@]} -gt 0 ] || scenes=("T1 plane" "T4b three" "T5a crevice" "T6 box edge, solid" "T9a slivers" "T16a soup" "sphere of 980" "sphere of 9680" "sphere of 100820" "sphere of 1003520" "map first_room")
command -v valgrind >/dev/null || { echo "valgrind is missing; install the package valgrind." >&2; exit 1; }
out=$(mktemp)
trap 'rm -f "$out"' EXIT
for scene in "${scenes[@]}"; do
    [ "$scene" != worst ] || continue
    for renderer in handrail penalty_sum sequential_planes active_set single_precision; do
        line=$(valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$build/bin/compare_renderers" --scene "$scene" --count "$renderer" 2>/dev/null)
        awk -F'\t' -v OFS='\t' -v total="$(awk '/^summary:/ {print $2}' "$out")" '{printf "%s\t%s\t%.0f\n", $1, $2, total / $3}' <<<"$line"
    done
done
# The worst places, of our own renderer alone: the mean tick and the worst of all. worst_touch asks for the counts after each.
if [ ${#scenes[@]} -gt 1 ] || [ "${scenes[0]}" = worst ]; then for number in {0..9}; do
    said=$(valgrind --tool=callgrind --callgrind-out-file="$out" --toggle-collect='*measured_ticks*' "$build/bin/worst_touch" 300 "$number" count 2>/dev/null)
    grep -h '^totals:' "$out".* | awk -v scene="${said%%$'\n'*}" '{ all += $2; if ($2 > most) most = $2 }
        END { printf "%s\thandrail\t%.0f\n%s\tworst tick\t%.0f\n", scene, all / 300, scene, most }'
    rm -f "$out".*
done; fi
