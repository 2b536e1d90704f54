#!/usr/bin/env bash
# Fuzzes every parser of the harness table. Each gets a fixed number of runs from a fixed seed, so that a finding can be
# repeated:
#   cmake --preset asan && cmake --build --preset asan --target parsers_fuzzer && tests/fuzz/fuzz_all.sh
# Longer, with other seeds and only some parsers; new inputs that are worth keeping are added to build/fuzz/corpus:
#   tests/fuzz/fuzz_all.sh -max_total_time=600 -seed=7 map obj
# Exit status 1: something was found, and the input is in build/fuzz/found. Fix the fault and keep the input in
# tests/fuzz/inputs/NAME/regressions.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
fuzzer=build/asan/bin/parsers_fuzzer
limits=(-seed=20261121) names=() grow=
for word in "$@"; do
    case $word in
        -max_total_time=* | -runs=*) limits+=("$word") grow=-runs=-1 ;;
        -*) limits+=("$word") ;;
        *) names+=("$word") ;;
    esac
done
[ ${#names[@]} -gt 0 ] || mapfile -t names < <("$fuzzer")
# Number of runs for each parser, which take about two seconds on an ordinary machine. Parsers that use files are
# slower.
declare -A runs=([map]=3000 [obj]=10000 [picture]=20000 [settings]=600 [side_file]=400 [scenario]=3000 [language]=1500 [path]=40000 [falcon]=100000 [boot_image]=100000 [hid]=60000
    [haply]=40000)
# Fixes the addresses, because containers that are ordered by address would otherwise have another order each time.
same=(setarch -R)
"${same[@]}" true 2>/dev/null || { same=(); echo "Addresses cannot be fixed here, so what is tried may differ from time to time."; }
mkdir -p build/fuzz/found
failed=0
for name in "${names[@]}"; do
    corpus=build/fuzz/corpus/$name
    [ -n "$grow" ] || rm -rf "$corpus"
    mkdir -p "$corpus"
    known=("tests/fuzz/inputs/$name/seeds")
    [ ! -d "tests/fuzz/inputs/$name/regressions" ] || known+=("tests/fuzz/inputs/$name/regressions")
    log=build/fuzz/$name.log
    if ${same[@]+"${same[@]}"} "$fuzzer" "$name" "-dict=tests/fuzz/inputs/$name/words.dict" -max_len=4096 -timeout=1000 -rss_limit_mb=1024 -print_final_stats=1 \
        "-artifact_prefix=build/fuzz/found/$name-" ${grow:--runs=${runs[$name]:-1000}} "${limits[@]}" "$corpus" "${known[@]}" >"$log" 2>&1; then
        echo "$name: $(grep -o 'Done .*' "$log" || echo done)"
    else
        echo "$name: something was found." && tail -n 25 "$log"
        failed=1
    fi
done
exit $failed
