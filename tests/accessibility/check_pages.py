#!/usr/bin/env python3
"""check_pages.py AXE.min.js PAGE... [--narrow PAGE...]: axe-core over each page in headless Chromium, light and dark, at 1280 and 320 pixels;
those after --narrow light at 320 pixels alone.

A page whose name begins with "broken" must have at least four violations, every other none, and none may be wider than the window. What axe leaves to be looked at is
told; contrast over the plan is among it, since axe cannot tell what lies behind a text in a drawing, and is worked out by unit_report instead.
"""
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

RUN = """
<script>%s</script>
<script>
addEventListener('load', async () => {
  const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
  const told = document.createElement('pre');
  told.id = 'axe-told';
  const root = document.documentElement;
  const wider = root.scrollWidth - root.clientWidth;
  const result = await axe.run({exclude: ['script']}, {runOnly: tags});
  const brief = list => list.map(rule => ({id: rule.id, help: rule.help, count: rule.nodes.length, where: rule.nodes[0].target.join(' ')}));
  told.textContent = JSON.stringify({wider, passed: result.passes.length, violations: brief(result.violations), open: brief(result.incomplete)});
  document.body.append(told);
});
</script>
"""


def judged(page, axe, dark, width):
    """What axe says of one page, as a dict; None where the browser gave nothing."""
    text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", page.read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / "page.html"
        copy.write_text(text.replace("</body>", RUN % axe + "</body>"), encoding="utf-8")
        done = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
             f"--user-data-dir={folder}/profile", f"--blink-settings=preferredColorScheme={0 if dark else 1}", f"--window-size={width},900",
             "--virtual-time-budget=30000", "--timeout=60000", "--dump-dom", copy.as_uri()],
            capture_output=True, text=True, timeout=120, check=False)
    found = re.search(r'<pre id="axe-told">(.*?)</pre>', done.stdout, re.S)
    return json.loads(html.unescape(found.group(1))) if found else None


def main():
    axe = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    bad = 0
    pages = sys.argv[2:]
    whole = pages.index("--narrow") if "--narrow" in pages else len(pages)
    for at, page in enumerate(pages):
        if at == whole:
            continue
        page = pathlib.Path(page)
        broken = page.name.startswith("broken")
        for dark, width in ((False, 1280), (True, 1280), (False, 320)) if at < whole else ((False, 320),):
            told = judged(page, axe, dark, width)
            what = f"{page.parent.name}/{page.name}, {'dark' if dark else 'light'}, {width} pixels"
            if told is None:
                print(f"{what}: the browser gave no result")
                bad += 1
                continue
            count = len(told["violations"])
            print(f"{what}: {told['passed']} rules passed, {count} violations, {len(told['open'])} to be looked at, {told['wider']} pixels too wide")
            for rule in told["violations"]:
                print(f"  {rule['id']}: {rule['help']} ({rule['count']}, first {rule['where']})")
            if broken:
                bad += count < 4
            else:
                bad += count > 0 or told["wider"] > 0 or any(rule["id"] != "color-contrast" for rule in told["open"])
    return 1 if bad else 0


sys.exit(main())
