#!/usr/bin/env python3
"""The documents as pages that a screen reader reads well: one language, one main part, headings, tables with headings.

    docs_html.py DOCS OUT    each DOCS/**/*.md through cmark-gfm to OUT/**/*.html, with the pictures that they show

DOCS/README.md becomes index.html; without one the index lists all pages. A link to what is no page is its words alone.
"""

import html
import os
import pathlib
import re
import shutil
import subprocess
import sys

STYLE = """:root{color-scheme:light dark}
body{font:1.1rem/1.6 sans-serif;max-width:52rem;margin:0 auto;padding:1rem;color:#111;background:#fff;overflow-wrap:break-word}
a{color:#0842a0}pre,.wide{overflow-x:auto}pre{padding:.6rem;background:#eee}code{font-size:1rem}
table{border-collapse:collapse}th,td{border:1px solid #767676;padding:.3rem .5rem;text-align:left;vertical-align:top}
img{max-width:100%;height:auto}
@media(prefers-color-scheme:dark){body{color:#eee;background:#111}a{color:#9cc4ff}pre{background:#222}}
"""


def slug(text):
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def plain(markup):
    return html.unescape(re.sub(r"<[^>]+>", "", markup))


def relative(path, start):
    return os.path.relpath(path, start).replace(os.sep, "/")


class Pages:
    def __init__(self, docs, out):
        self.docs, self.out = docs, out
        self.files = sorted(docs.rglob("*.md"))

    def place(self, file):
        """Where the page of a document lies below the folder of pages."""
        inside = file.relative_to(self.docs)
        return inside.with_name("index.html") if inside.name == "README.md" else inside.with_suffix(".html")

    def write_all(self):
        titles = []
        for file in self.files:
            titles.append((self.place(file), self.write(file)))
        if not (self.docs / "README.md").exists():
            rows = "".join(f'<li><a href="{place.as_posix()}">{html.escape(title)}</a></li>\n' for place, title in titles)
            self.save(pathlib.Path("index.html"), "Handrail", f"<h1>Handrail</h1>\n<ul>\n{rows}</ul>\n")

    def write(self, file):
        body = subprocess.run(["cmark-gfm", "-e", "table", "-e", "autolink", "-e", "strikethrough", str(file)],
                              capture_output=True, check=True, text=True, encoding="utf-8").stdout
        seen = {}

        def heading(match):
            name = slug(plain(match.group(2)))
            seen[name] = seen.get(name, -1) + 1
            name += f"-{seen[name]}" if seen[name] else ""
            return f'<h{match.group(1)} id="{name}">{match.group(2)}</h{match.group(1)}>'

        body = re.sub(r"<h([1-6])>(.*?)</h\1>", heading, body, flags=re.S)
        body = re.sub(r'<a href="([^"]*)">(.*?)</a>', lambda m: self.link(file, m.group(1), m.group(2)), body, flags=re.S)
        for source in re.findall(r'<img src="([^"]+)"', body):
            self.copy(file, source)
        number = iter(range(1, 10000))
        body = re.sub(r"<table>", lambda m: f'<section class="wide" tabindex="0" aria-label="{self.table_word(file)} '
                      f'{next(number)}"><table>', body).replace("</table>", "</table></section>")
        body = body.replace("<th>", '<th scope="col">').replace("<th align", '<th scope="col" align')
        body = re.sub(r' align="(\w+)"', r' style="text-align:\1"', body)
        body = body.replace("<pre>", '<pre tabindex="0">').replace(" />", ">")
        # An empty corner of a table is no heading.
        body = re.sub(r'<th scope="col"[^>]*></th>', "<td></td>", body)
        found = re.search(r"<h1[^>]*>(.*?)</h1>", body, flags=re.S)
        title = plain(found.group(1)) if found else file.stem
        self.save(self.place(file), title, body)
        return title

    def german(self, place):
        return place.parts[0] == "de" and len(place.parts) > 1

    def table_word(self, file):
        return "Tabelle" if self.german(self.place(file)) else "Table"

    def link(self, file, address, words):
        if re.match(r"[a-z]+:", address) or address.startswith("#"):
            return f'<a href="{address}">{words}</a>'
        path, _, part = address.partition("#")
        target = pathlib.Path(os.path.normpath(file.parent / path))
        if target.suffix == ".md" and target in self.files:
            here = (self.out / self.place(file)).parent
            to = relative(self.out / self.place(target), here) + (f"#{part}" if part else "")
            return f'<a href="{to}">{words}</a>'
        if target.is_file() and self.docs in target.parents and target.suffix in (".svg", ".png"):
            self.copy(file, path)
            return f'<a href="{path}">{words}</a>'
        return words

    def copy(self, file, source):
        from_path = pathlib.Path(os.path.normpath(file.parent / source))
        if self.docs not in from_path.parents:
            raise SystemExit(f"{file}: {source} is not below {self.docs}")
        to = self.out / from_path.relative_to(self.docs)
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(from_path, to)

    def save(self, place, title, body):
        german = self.german(place)
        home = relative(self.out / "index.html", (self.out / place).parent)
        nav = "" if place.as_posix() == "index.html" else (
            f'<nav aria-label="Handrail"><a href="{home}">{"Alle Seiten" if german else "All pages"}</a></nav>\n')
        text = (f'<!DOCTYPE html>\n<html lang="{"de" if german else "en"}">\n<head>\n<meta charset="utf-8">\n'
                f"<title>{html.escape(title)}</title>\n"
                f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<style>\n{STYLE}</style>\n</head>\n'
                f"<body>\n{nav}<main>\n{body}</main>\n</body>\n</html>\n")
        (self.out / place).parent.mkdir(parents=True, exist_ok=True)
        (self.out / place).write_text(text, encoding="utf-8")


def main():
    docs, out = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(out, ignore_errors=True)
    Pages(docs, out).write_all()


if __name__ == "__main__":
    main()
