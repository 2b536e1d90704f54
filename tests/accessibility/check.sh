#!/usr/bin/env bash
# Usage: check.sh REPORT_PAGES FOLDER
# REPORT_PAGES writes pages into FOLDER, and this script makes the pages of the guides as the package contains them.
# html-validate checks all pages as text, and axe-core checks them in a headless Chromium.
# Exit status 0: all passed. 1: a page has a fault, or a page with deliberate faults has too few. 77: a browser, npm or
# the packages are not available; the script says which, and still checks what it can.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1 folder=$2
skip() { echo "Skipped: $*"; exit 77; }

for tool in npm python3; do
    command -v "$tool" >/dev/null || skip "$tool is not installed, so nobody has judged the pages."
done
mkdir -p "$folder/npm" "$folder/pages"
if ! cmp -s "$here/package-lock.json" "$folder/npm/package-lock.json" || [ ! -e "$folder/npm/node_modules/.package-lock.json" ]; then
    cp "$here/package.json" "$folder/npm/"
    # package-lock.json contains checksums. No script of a package runs.
    cp "$here/package-lock.json" "$folder/npm/lock" && cp "$folder/npm/lock" "$folder/npm/package-lock.json"
    (cd "$folder/npm" && timeout 120 npm ci --ignore-scripts --no-audit --no-fund >npm.log 2>&1) ||
        { rm -f "$folder/npm/package-lock.json"; skip "html-validate and axe-core cannot be fetched, so nobody has judged the pages."; }
fi
rm -f "$folder"/pages/*.html
"$program" "$folder/pages"
guides=() narrow=()
if command -v cmark-gfm >/dev/null; then
    python3 "$here/../../app/packaging/docs_html.py" "$here/../../docs" "$folder/guides"
    # A page with deliberate faults: it lacks the language, a title and the text of a picture. Its headings skip levels,
    # and two parts have the same name.
    sed -e 's/ lang="en"//' -e 's|<title>.*</title>||' -e 's/ alt="[^"]*"//' -e 's/<\(\/\?\)h2/<\1h5/' -e 's/<h5 id="[^"]*"/<h5 id="twice"/' \
        "$folder/guides/architecture.html" >"$folder/guides/broken-guide.html"
    # The browser shows every page at the narrowest width. It also shows the index, long tables and code wide and dark.
    guides=("$folder"/guides/{index,user-guide/keys,developer/examples,broken-guide}.html)
    mapfile -t narrow < <(find "$folder/guides" -name '*.html' | sort | grep -vxFf <(printf '%s\n' "${guides[@]}"))
else
    echo "Skipped: cmark-gfm is not installed, so no page of the guides is judged."
fi

faults=0
python3 "$here/check_text.py" "$folder/npm/node_modules/html-validate/bin/html-validate.mjs" "$here/html-validate.json" \
    "$folder"/pages/*.html "${guides[@]}" "${narrow[@]}" || faults=1
if ! command -v chromium >/dev/null; then
    [ "$faults" -eq 0 ] || exit 1
    skip "chromium is not installed, so no browser has judged the pages."
fi
python3 "$here/check_pages.py" "$folder/npm/node_modules/axe-core/axe.min.js" "$folder"/pages/*.html "${guides[@]}" --narrow "${narrow[@]}" || faults=1
exit "$faults"
