#!/usr/bin/env python3
"""Manual pages and completions from what the program says of itself, so that none of them can tell anything else.

    from_help.py PROGRAM OUT    writes OUT/man/..., OUT/bash/handrail and OUT/zsh/_handrail

Every command has a page, in English and in German: `man handrail`, `man handrail-export`.
"""

import dataclasses
import gzip
import os
import pathlib
import re
import subprocess
import sys

LANGUAGES = {
    "en": {"NAME": "NAME", "USAGE": "SYNOPSIS", "WHAT": "DESCRIPTION", "END": "EXIT STATUS", "SEE": "SEE ALSO",
           "BOOK": "Handrail", "GUIDE": "The user guide lies in"},
    "de": {"NAME": "BEZEICHNUNG", "USAGE": "ÜBERSICHT", "WHAT": "BESCHREIBUNG", "END": "RÜCKGABEWERT",
           "SEE": "SIEHE AUCH", "BOOK": "Handrail", "GUIDE": "Das Handbuch liegt in"},
}
GUIDE = "/usr/share/doc/handrail/html/index.html"


@dataclasses.dataclass
class Entry:
    label: str  # "--scale S", "WORLD", "info"
    text: str

    @property
    def options(self):
        return re.findall(r"(?:^|[ ,])(--?[a-z][a-z-]*|-[a-z])(?=[ ,]|$)", re.sub(r"Excludes:.*", "", self.label))

    @property
    def value(self):
        """What an option takes: "FILE"; nothing for a flag."""
        found = re.match(r"[-a-z,]+ ([A-Z][\w.=]*)(?: |$|:)", self.label)
        return found.group(1) if found and found.group(1) != "Excludes" else ""


@dataclasses.dataclass
class Help:
    about: list
    usage: str
    sections: list  # (title, [Entry])
    footer: str

    def entries(self):
        return [entry for _, entries in self.sections for entry in entries]

    def commands(self):
        return [entry for entry in self.entries() if re.fullmatch(r"[a-z]+", entry.label)]

    def options(self):
        return [entry for entry in self.entries() if entry.label.startswith("-")]


def help_of(program, language, command=None):
    words = [program] + ([command] if command else []) + ["--help"]
    clean = {"PATH": os.environ["PATH"], "HOME": "/nonexistent",
             "LC_ALL": {"en": "C.UTF-8", "de": "de_DE.UTF-8"}[language]}
    for name in ("ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS"):
        if name in os.environ:
            clean[name] = os.environ[name]
    said = subprocess.run(words, env=clean, capture_output=True, check=True, text=True, encoding="utf-8").stdout
    return parse(said)


def parse(said):
    """The help's parts, told apart by their shape alone, which is the same in every language."""
    about, usage, sections, footer = [], "", [], []
    for line in said.splitlines():
        if not usage:
            if re.match(r"\S+: handrail\b", line):
                usage = line.split(": ", 1)[1]
            elif line.strip():
                about.append(line.strip())
        elif re.fullmatch(r"\S.*:", line):
            sections.append((line[:-1], []))
        elif line.startswith("   ") and sections and sections[-1][1]:
            last = sections[-1][1][-1]
            last.text = (last.text + " " + line.strip()).strip()
        elif line.startswith("  ") and sections:
            label, _, text = line.strip().partition("  ")
            sections[-1][1].append(Entry(label, text.strip()))
        elif line.strip():
            footer.append(line.strip())
    if not about or not usage or not sections:
        raise SystemExit("from_help.py: this help is shaped in a way that it does not know:\n" + said)
    return Help(about, usage, sections, " ".join(footer))


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq")
    return "\\&" + text if text.startswith(".") else text


def page(name, version, said, words, others):
    first = re.split(r"(?<=[a-zäöüß])\. |\.$|: ", said.about[0].replace("Handrail: ", ""))[0]
    lines = [f'.TH "{name.upper()}" 1 "" "handrail {version}" "{words["BOOK"]}"',
             f'.SH "{words["NAME"]}"', f"{roff(name)} \\- {roff(first)}",
             f'.SH "{words["USAGE"]}"', ".B handrail", roff(said.usage.split(" ", 1)[1]) if " " in said.usage else "",
             f'.SH "{words["WHAT"]}"']
    for sentence in said.about:
        lines += [roff(sentence), ".br"]
    lines.pop()
    for title, entries in said.sections:
        lines.append(f'.SH "{roff(title.upper())}"')
        for entry in entries:
            lines += [".TP", f"\\fB{roff(entry.label)}\\fR", roff(entry.text)]
    if said.footer:
        lines += [f'.SH "{words["END"]}"', roff(re.sub(r"^[^:]*: ", "", said.footer, count=1))]
    lines += [f'.SH "{words["SEE"]}"', ", ".join(f"\\fB{roff(other)}\\fR(1)" for other in others) + ".", ".PP",
              roff(words["GUIDE"]), f"\\fI{roff(GUIDE)}\\fR."]
    return "\n".join(line for line in lines if line) + "\n"


BASH_HEAD = """# Completion of handrail for bash; made from its own help.
_handrail() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command="" at options="" worlds="" world
    for ((at = 1; at < COMP_CWORD; ++at)); do
        case ${COMP_WORDS[at]} in
            COMMANDS) command=${COMP_WORDS[at]}; break ;;
        esac
    done
    compopt -o filenames 2>/dev/null
    case $before in
        VALUED) COMPREPLY=($(compgen -f -- "$word")); return ;;
    esac
    case $command in
"""
BASH_TAIL = """    esac
    if [[ $word == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$word"))
        return
    fi
    for world in "${HANDRAIL_WORLDS:-/usr/share/handrail/worlds}"/*.map; do
        world=${world##*/}
        worlds+=" ${world%.map}"
    done
    if [[ -z $command ]]; then worlds+=" ALL_COMMANDS"; fi
    COMPREPLY=($(compgen -W "$worlds" -- "$word") $(compgen -f -- "$word"))
}
complete -F _handrail handrail
"""


def bash(helps):
    commands = [name for name in helps if name]
    valued = sorted({o for h in helps.values() for e in h.options() if e.value for o in e.options})
    out = BASH_HEAD.replace("COMMANDS", "|".join(commands)).replace("VALUED", "|".join(valued))
    for name, said in helps.items():
        options = " ".join(option for entry in said.options() for option in entry.options)
        out += f'        "{name}") options="{options}" ;;\n'
    return out + BASH_TAIL.replace("ALL_COMMANDS", " ".join(commands))


def zsh_quoted(text):
    return text.replace("'", "’").replace("[", "(").replace("]", ")").replace(":", "\\:")


def zsh_arguments(said):
    lines = []
    for entry in said.options():
        value = f":{entry.value.lower()}:_files" if entry.value else ""
        for option in entry.options:
            lines.append(f"'*{option}[{zsh_quoted(entry.text)}]{value}'")
    return lines


def zsh(helps):
    out = "#compdef handrail\n# Made from the program's own help.\n_handrail() {\n    local -a commands\n    commands=(\n"
    for command in helps[""].commands():
        out += f"        '{command.label}:{zsh_quoted(command.text)}'\n"
    out += "    )\n    case ${words[2]} in\n"
    for name, said in helps.items():
        if name:
            out += f"        {name})\n            (( CURRENT > 2 )) && {{ shift words; (( CURRENT-- ))\n"
            out += "            _arguments " + " \\\n                ".join(zsh_arguments(said) + ["'*:file:_files'"])
            out += "\n            return; } ;;\n"
    out += "    esac\n    (( CURRENT == 2 )) && _describe command commands\n"
    out += "    _arguments " + " \\\n        ".join(zsh_arguments(helps[""]) + ["'*:world:_files'"])
    return out + "\n}\n_handrail \"$@\"\n"


def main():
    program, out = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    version = subprocess.run([program, "--version"], capture_output=True, check=True, text=True).stdout.split()[1]
    for language, words in LANGUAGES.items():
        helps = {"": help_of(program, language)}
        for command in helps[""].commands():
            helps[command.label] = help_of(program, language, command.label)
        names = {name: f"handrail-{name}" if name else "handrail" for name in helps}
        folder = out / "man" / ("man1" if language == "en" else f"{language}/man1")
        folder.mkdir(parents=True, exist_ok=True)
        for name, said in helps.items():
            others = [other for key, other in names.items() if key != name] if not name else ["handrail"]
            text = page(names[name], version, said, words, others).encode("utf-8")
            (folder / f"{names[name]}.1.gz").write_bytes(gzip.compress(text, 9, mtime=0))
        if language == "en":
            for path, text in (("bash/handrail", bash(helps)), ("zsh/_handrail", zsh(helps))):
                (out / path).parent.mkdir(parents=True, exist_ok=True)
                (out / path).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
