#!/usr/bin/env bash
# Fuzzes every parser of the harness table, each for so many runs from a fixed seed, so that what it finds is found again:
#   cmake --preset asan && cmake --build --preset asan --target parsers_fuzzer && tests/fuzz/fuzz_all.sh
#   tests/fuzz/fuzz_all.sh -max_total_time=600 -seed=7 map obj     longer, of one's own; what is new and worth keeping grows in build/fuzz/corpus
# Ends with 1 if anything was found: then the input lies in build/fuzz/found. Mend it, and keep it in tests/fuzz/inputs/NAME/regressions.
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
# What a parser does in about two seconds on an ordinary machine. Those that go through files are slower.
declare -A runs=([map]=3000 [obj]=10000 [picture]=20000 [settings]=600 [side_file]=400 [scenario]=3000 [language]=1500 [path]=40000 [falcon]=100000 [boot_image]=100000 [hid]=60000
    [haply]=40000)
# Always the same: what is kept by address would else be met in another order each time.
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
