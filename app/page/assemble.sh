#!/usr/bin/env bash
# assemble.sh FOLDER CORE OUTPUT: joins page.html, the scripts and the core (CORE.js and CORE.wasm) into one file, in
# which the building is still missing.
set -euo pipefail
folder=$1 core=$2 output=$3
while IFS= read -r line; do
    case $line in
    *@WASM@*) printf '%s' "${line%@WASM@*}" && gzip -9 -n -c "$core.wasm" | base64 -w 0 && printf '%s\n' "${line#*@WASM@}" ;;
    *@CORE@*) printf '%s' "${line%@CORE@*}" && sed 's|</script|<\\/script|g' "$core.js" && printf '%s\n' "${line#*@CORE@}" ;;
    *@WORKER@*) printf '%s' "${line%@WORKER@*}" && cat "$folder/worker.js" && printf '%s\n' "${line#*@WORKER@}" ;;
    *@PAGE@*) cat "$folder/page.js" ;;
    *) printf '%s\n' "$line" ;;
    esac
done <"$folder/page.html" >"$output"
