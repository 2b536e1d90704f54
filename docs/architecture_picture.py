#!/usr/bin/env python3
"""Makes docs/architecture.svg from the #include lines of the program: each folder a room, as low as what it includes lets it lie, an arrow from who includes to what
is included. An arrow is left out where a longer way of arrows tells the same. The same include lines give the same picture, byte for byte.

    docs/architecture_picture.py           writes docs/architecture.svg
    docs/architecture_picture.py --check   says whether it is up to date (status 1 if not)
"""
import re
import sys
from pathlib import Path
from xml.sax.saxutils import escape

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs" / "architecture.svg"
PARTS = ("app", "audio-cues", "haptic", "settings", "worlds")  # all that is in the program
COLOURS = {"app": "#f6d9a8", "audio-cues": "#f3c6d3", "haptic": "#c5dcf5", "settings": "#e4e0d8", "worlds": "#cfe8c5"}
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)
ROOM_HEIGHT, FLOOR_HEIGHT, GAP, LETTER, MARGIN = 30, 92, 22, 7.4, 24


def rooms_and_includes():
    """{folder: folders it includes}, itself left out, of every folder with sources of the program."""
    included = {}
    for part in PARTS:
        for path in sorted((ROOT / part).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            folder = path.parent.relative_to(ROOT).as_posix()
            names = included.setdefault(folder, set())
            for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
                other = name.rpartition("/")[0]
                if other.startswith(PARTS) and other != folder:  # the tests' hard cases, which the comparison shares, are no room
                    names.add(other)
    for folder, names in included.items():
        for name in names - included.keys():
            sys.exit(f"{folder} includes a file of {name}, where no sources lie.")
    return included


def floors_of(included):
    """{folder: floor}, 0 for what includes nothing of ours, else one above the highest that it includes."""
    floors, on_the_way = {}, []

    def floor(folder):
        if folder in on_the_way:
            sys.exit("These folders include each other in a circle: " + ", ".join(on_the_way[on_the_way.index(folder):]) + ".")
        if folder not in floors:
            on_the_way.append(folder)
            floors[folder] = 1 + max((floor(other) for other in sorted(included[folder])), default=-1)
            on_the_way.pop()
        return floors[folder]

    for folder in sorted(included):
        floor(folder)
    return floors


def arrows_of(included):
    """What no longer way tells, in order."""
    reached = {}

    def reach(folder):
        if folder not in reached:
            reached[folder] = set()
            for other in included[folder]:
                reached[folder] |= {other} | reach(other)
        return reached[folder]

    return [(folder, other) for folder in sorted(included) for other in sorted(included[folder])
            if not any(other in reach(between) for between in included[folder] if between != other)]


class Stop:
    """A room, or where a long arrow passes a floor."""

    def __init__(self, floor, folder=None):
        self.floor, self.folder, self.above, self.below = floor, folder, [], []
        self.width = len(folder) * LETTER + 22 if folder else 6
        self.x = 0.0  # its middle


def join(upper, lower):
    upper.below.append(lower)
    lower.above.append(upper)


def crossings(floors):
    """How often arrows cross, over all pairs of neighbouring floors."""
    count = 0
    for upper in floors[1:]:
        place = {stop: i for i, stop in enumerate(floors[upper[0].floor - 1])}
        ends = [place[other] for stop in upper for other in sorted(stop.below, key=place.get)]
        count += sum(ends[j] < ends[i] for i in range(len(ends)) for j in range(i + 1, len(ends)))
    return count


def order(floors):
    """Stops of each floor by the middle of what they are joined to, down and up in turn; the order with the fewest crossings counts."""
    best, fewest = [list(stops) for stops in floors], crossings(floors)
    for sweep in range(40):
        going_up = sweep % 2 == 0
        for stops in floors[1:] if going_up else floors[-2::-1]:
            beside = floors[stops[0].floor + (-1 if going_up else 1)]
            place = {stop: i for i, stop in enumerate(beside)}
            own = {stop: i for i, stop in enumerate(stops)}

            def middle(stop):
                near = [place[other] for other in (stop.below if going_up else stop.above)]
                return sum(near) / len(near) if near else own[stop] * len(beside) / len(own)

            stops.sort(key=lambda stop: (middle(stop), own[stop]))
        if crossings(floors) < fewest:
            best, fewest = [list(stops) for stops in floors], crossings(floors)
    floors[:] = best


def spread(stops, wished):
    """As near to the wished places as rooms beside each other allow, in least squares: runs that would overlap share their mean."""
    offset, at = [], 0.0
    for i, stop in enumerate(stops):
        if i:
            at += (stops[i - 1].width + stop.width) / 2 + GAP
        offset.append(at)
    runs = []  # [sum, count]
    for wish, push in zip(wished, offset):
        runs.append([wish - push, 1])
        while len(runs) > 1 and runs[-2][0] / runs[-2][1] > runs[-1][0] / runs[-1][1]:
            last = runs.pop()
            runs[-1] = [runs[-1][0] + last[0], runs[-1][1] + last[1]]
    base = [total / count for total, count in runs for _ in range(count)]
    for stop, low, push in zip(stops, base, offset):
        stop.x = low + push


def lay_out(included):
    levels = floors_of(included)
    floors = [[] for _ in range(1 + max(levels.values()))]
    stops = {}
    for folder in sorted(included):
        stops[folder] = Stop(levels[folder], folder)
        floors[levels[folder]].append(stops[folder])
    ways = []
    for folder, other in arrows_of(included):
        way = [stops[folder]]
        for floor in range(levels[folder] - 1, levels[other], -1):
            way.append(Stop(floor))
            floors[floor].append(way[-1])
        way.append(stops[other])
        for upper, lower in zip(way, way[1:]):
            join(upper, lower)
        ways.append(way)
    order(floors)
    for here in floors:
        spread(here, [0.0] * len(here))
    for _ in range(60):
        for here in floors + floors[::-1]:
            spread(here, [(sum(o.x for o in s.above + s.below) / len(s.above + s.below)) if s.above or s.below else s.x for s in here])
    left = min(stop.x - stop.width / 2 for here in floors for stop in here)
    for here in floors:
        for stop in here:
            stop.x += MARGIN - left
    return floors, ways


def svg(included):
    floors, ways = lay_out(included)
    width = max(stop.x + stop.width / 2 for here in floors for stop in here) + MARGIN
    height = len(floors) * FLOOR_HEIGHT - (FLOOR_HEIGHT - ROOM_HEIGHT) + 2 * MARGIN

    def top(stop):
        return MARGIN + (len(floors) - 1 - stop.floor) * FLOOR_HEIGHT

    def sentence(folder):
        names = sorted(included[folder])
        return f"{folder} includes " + (", ".join(names) if names else "nothing of ours") + "."

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" role="img" aria-labelledby="title desc" '
           'font-family="DejaVu Sans, Verdana, sans-serif" font-size="12">',
           "<!-- Made by docs/architecture_picture.py from the include lines; not to be edited. -->",
           '<title id="title">The folders of Handrail and what they include</title>',
           '<desc id="desc">Each folder lies on the lowest floor above all that it includes. From the top: ' + escape(" ".join(
               f"Floor {floor}: " + " ".join(sentence(stop.folder) for stop in here if stop.folder)
               for floor, here in reversed(list(enumerate(floors))))) + "</desc>",
           '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto"><path d="M0 0L8 4L0 8z" fill="#555"/>'
           "</marker></defs>",
           f'<rect width="{width:.0f}" height="{height:.0f}" fill="#fff"/>']
    for way in ways:
        start, end = way[0], way[-1]
        x, y = start.x, top(start) + ROOM_HEIGHT
        path = f"M{x:.1f} {y:.1f}"
        for stop in way[1:]:
            to = top(stop) - (1 if stop is end else 0)
            bend = (to - y) / 2
            path += f"C{x:.1f} {y + bend:.1f} {stop.x:.1f} {to - bend:.1f} {stop.x:.1f} {to:.1f}"
            x, y = stop.x, to
            if stop is not end:
                y += ROOM_HEIGHT
                path += f"V{y:.1f}"
        out.append(f'<path d="{path}" fill="none" stroke="#777" stroke-width="1.2" marker-end="url(#tip)"><title>{escape(start.folder)} includes '
                   f"{escape(end.folder)}</title></path>")
    for here in reversed(floors):
        for stop in here:
            if not stop.folder:
                continue
            out.append(f'<g><title>{escape(sentence(stop.folder))}</title><rect x="{stop.x - stop.width / 2:.1f}" y="{top(stop):.1f}" width="{stop.width:.1f}" '
                       f'height="{ROOM_HEIGHT}" rx="4" fill="{COLOURS[stop.folder.split("/")[0]]}" stroke="#444"/><text x="{stop.x:.1f}" y="{top(stop) + 20:.1f}" '
                       f'text-anchor="middle" fill="#111">{escape(stop.folder)}</text></g>')
    return "\n".join(out + ["</svg>", ""])


def main():
    picture = svg(rooms_and_includes())
    if "--check" not in sys.argv[1:]:
        PICTURE.write_text(picture, encoding="utf-8")
    elif not PICTURE.exists() or PICTURE.read_text(encoding="utf-8") != picture:
        sys.exit("docs/architecture.svg is not what the include lines say; docs/architecture_picture.py makes it anew.")


if __name__ == "__main__":
    main()
