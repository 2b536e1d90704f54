#!/usr/bin/env bash
# Fuzzes each parser for minutes, from a new seed each time. Keeps the corpora outside the repository:
#   tests/fuzz/fuzz_long.sh [MINUTES] [NAME...]        by default 10 minutes for each parser
# The corpora are in $HANDRAIL_CORPORA, or in ~/.cache/handrail-fuzz. Each begins with the seeds of tests/fuzz/inputs.
# The script minimises it afterwards, and the next call continues with it. After a finding, the parser continues with
# another seed. The script prints one line for each parser.
# Exit status 1: something was found. Fix the fault and keep the input in tests/fuzz/inputs/NAME/regressions.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fuzzer=${HANDRAIL_FUZZER:-build/asan/bin/parsers_fuzzer}
minutes=10
if [[ "${1:-}" =~ ^[0-9]+$ ]]; then minutes=$1 && shift; fi
names=("$@")
[ ${#names[@]} -gt 0 ] || mapfile -t names < <("$fuzzer")
home=${HANDRAIL_CORPORA:-${XDG_CACHE_HOME:-$HOME/.cache}/handrail-fuzz}
mkdir -p "$home/found" "$home/logs"

# Fuzzes a parser until the time is over or something is found. Fails if something was found.
fuzz() {
    local name=$1 log=$2 seconds=$3 seed=$4 known=("tests/fuzz/inputs/$1/seeds")
    [ ! -d "tests/fuzz/inputs/$name/regressions" ] || known+=("tests/fuzz/inputs/$name/regressions")
    "$fuzzer" "$name" "-dict=tests/fuzz/inputs/$name/words.dict" -max_len=4096 -timeout=1000 -rss_limit_mb=1024 -print_final_stats=1 \
        "-artifact_prefix=$home/found/$name-" "-max_total_time=$seconds" "-seed=$seed" "$home/$name" "${known[@]}" >"$log" 2>&1
}

# Replaces the corpus by those of its inputs that together reach the same code.
minimise() {
    local name=$1 fresh=$home/$1.minimised
    rm -rf "$fresh" && mkdir "$fresh"
    if "$fuzzer" "$name" -merge=1 -max_len=4096 -rss_limit_mb=1024 "$fresh" "$home/$name" "tests/fuzz/inputs/$name/seeds" \
        >"$home/logs/$name.minimise.log" 2>&1; then
        rm -rf "${home:?}/$name" && mv "$fresh" "$home/$name"
    else
        rm -rf "$fresh"
    fi
}

failed=0
for name in "${names[@]}"; do
    mkdir -p "$home/$name"
    end=$((SECONDS + 60 * minutes)) runs=0 found=0 seeds=() turn=0
    while left=$((end - SECONDS)) && [ "$left" -gt 0 ]; do
        seed=$((RANDOM * 32768 + RANDOM + 1)) log=$home/logs/$name.$((++turn)).log
        seeds+=("$seed")
        fuzz "$name" "$log" "$left" "$seed" || found=$((found + 1))
        done_now=$(grep -oE 'number_of_executed_units: *[0-9]+' "$log" | grep -oE '[0-9]+$' || true)
        runs=$((runs + ${done_now:-0}))
        # If a known input fails, the fuzzer ends immediately, and starting it again would find nothing new.
        [ "$turn" -lt 50 ] || break
    done
    minimise "$name"
    reached=$(grep -ohE 'cov: [0-9]+' "$log" | tail -n 1 || true)
    echo "$name: $minutes minutes, $runs inputs, ${reached:-cov: unknown}, $(find "$home/$name" -type f | wc -l) kept, seeds ${seeds[*]}, $([ "$found" = 0 ] && echo "nothing found" || echo "found $found: $home/found/$name-*")"
    [ "$found" = 0 ] || failed=1
done
exit $failed
