#!/usr/bin/env python3
"""Checks pages as text with html-validate.

Usage: check_text.py HTML-VALIDATE CONFIGURATION PAGE...
A page whose name begins with "broken" must break at least four rules; all other pages must break none. The script prints
each fault with its page, line and rule.
"""
import json
import pathlib
import subprocess
import sys


def main():
    judge, configuration, pages = sys.argv[1], sys.argv[2], [str(pathlib.Path(page).resolve()) for page in sys.argv[3:]]
    done = subprocess.run(["node", judge, "--config", configuration, "--formatter", "json", *pages], capture_output=True, text=True, timeout=300, check=False)
    try:
        found = {str(pathlib.Path(page["filePath"]).resolve()): page["messages"] for page in json.loads(done.stdout)}
    except ValueError:
        print(f"html-validate gave no result: {done.stdout}{done.stderr}")
        return 1
    bad = 0
    for page in pages:
        faults, name = found.get(page, []), pathlib.Path(page).name
        if name.startswith("broken"):
            rules = sorted({fault["ruleId"] for fault in faults})
            print(f"{name}: breaks {len(rules)} rules of HTML ({', '.join(rules)}), and has to break at least 4")
            bad += len(rules) < 4
            continue
        for fault in faults:
            print(f"{page}, line {fault['line']}: {fault['message']} ({fault['ruleId']})")
        bad += len(faults) > 0
    print(f"{len(pages)} pages judged as text")
    return 1 if bad else 0


sys.exit(main())
