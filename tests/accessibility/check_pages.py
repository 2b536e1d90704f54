#!/usr/bin/env python3
"""Checks pages with axe-core in headless Chromium.

Usage: check_pages.py AXE.min.js PAGE... [--narrow PAGE...]
Shows each page light at widths of 1280 and 320 pixels, and dark at 1280 pixels. Pages after --narrow are shown only
light at 320 pixels.

A page whose name begins with "broken" must have at least four violations; all other pages must have none. No other page
may be wider than the window. The script prints how many questions axe leaves open. Only the contrast over the plan may be
among them, because axe cannot tell what is behind a text in a drawing; unit_report computes that contrast instead.
"""
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

# Added to each page: when the page has loaded, axe checks it and sends the result to the page around it.
RUN = """
<script>%s</script>
<script>
addEventListener('load', async () => {
  const tags = ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'];
  const root = document.documentElement;
  const wider = root.scrollWidth - root.clientWidth;
  const result = await axe.run({exclude: ['script']}, {runOnly: tags});
  const brief = list => list.map(rule => ({id: rule.id, help: rule.help, count: rule.nodes.length, where: rule.nodes[0].target.join(' ')}));
  parent.postMessage({wider, passed: result.passes.length, violations: brief(result.violations), open: brief(result.incomplete)}, '*');
});
</script>
"""

# A page that shows the checked pages one after another, each in a frame of the requested width, and collects their
# results. Starting a browser for each page would take longer than checking all of them.
AROUND = """<!doctype html><html lang="en"><head><title>All pages</title></head><body><script>
const pages = %s, told = pages.map(() => null);
const next = at => {
  if (at === pages.length) {
    const all = document.createElement('pre');
    all.id = 'axe-told';
    all.textContent = JSON.stringify(told);
    document.body.append(all);
    return;
  }
  const frame = document.createElement('iframe');
  frame.style = `border: 0; height: 900px; width: ${pages[at].width}px`;
  frame.src = pages[at].file;
  const done = event => {
    if (event && event.source !== frame.contentWindow) return;
    removeEventListener('message', done);
    clearTimeout(late);
    if (event) told[at] = event.data;
    frame.remove();
    next(at + 1);
  };
  const late = setTimeout(done, 30000);
  addEventListener('message', done);
  document.body.append(frame);
};
next(0);
</script></body></html>
"""


def judged(pages, axe, dark):
    """Returns axe's result for each (page, width) as a dict; None if the browser gave no result for it."""
    with tempfile.TemporaryDirectory() as folder:
        shown = []
        for at, (page, width) in enumerate(pages):
            text = re.sub(r'<meta http-equiv="Content-Security-Policy"[^>]*>', "", page.read_text(encoding="utf-8"))
            copy = pathlib.Path(folder) / f"page{at}.html"
            copy.write_text(text.replace("</body>", RUN % axe + "</body>"), encoding="utf-8")
            shown.append({"file": copy.name, "width": width})
        around = pathlib.Path(folder) / "around.html"
        around.write_text(AROUND % json.dumps(shown), encoding="utf-8")
        done = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
             f"--user-data-dir={folder}/profile", f"--blink-settings=preferredColorScheme={0 if dark else 1}", "--window-size=1280,900",
             f"--virtual-time-budget={31000 * len(pages)}", "--timeout=400000", "--dump-dom", around.as_uri()],
            capture_output=True, text=True, timeout=450, check=False)
    found = re.search(r'<pre id="axe-told">(.*?)</pre>', done.stdout, re.S)
    return json.loads(html.unescape(found.group(1))) if found else [None] * len(pages)


def main():
    axe = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    bad = 0
    pages = sys.argv[2:]
    whole = pages.index("--narrow") if "--narrow" in pages else len(pages)
    wide, narrow = ([pathlib.Path(page) for page in some] for some in (pages[:whole], pages[whole + 1:]))
    for dark, shown in ((True, [(page, 1280) for page in wide]),
                        (False, [(page, 1280) for page in wide] + [(page, 320) for page in wide + narrow])):
        for (page, width), told in zip(shown, judged(shown, axe, dark)):
            broken = page.name.startswith("broken")
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
