# SPDX-License-Identifier: BSD-3-Clause
"""Input files for command_line.py: reduced copies of the shipped files, and structured mutations of them."""
import pathlib
import re

# Values at and beyond the limits of the readers. None of them is valid input that needs much work.
HOSTILE = [
    "0", "-0", "1", "-1", "1/2", "2", "10", "1e-3", "1e3", "0.3333333333333333333333333333", "1e-40", "1e-300",
    "1e40", "1e300", "1.797e308", "4.9e-324", "1e309", "1e400", "-1e400", "1e-400", "1e99999", "1e-99999", "1e100001",
    "1e99999999999999999999", "2^(2^64)", "10^10^10", "2^-(2^64)", "(1+1e-30)^(1e30)", "1/0", "0/0", "nan", "inf",
    "-inf", "", " ", "pi", "-pi", "pi/16", "sqrt(2)", "sqrt(-1)", "log(0)", "gamma(1e9)", "sin(1e99999)", "exp(1e9)",
    "exp(-1e9)", "x", "a", "b", "a/2", "a+b", "u", "P", "1%", "200%", "-5%", "1 mm", "1,5", "0x10", "1_000", "true",
    "sum(1/k,k,1,1000000000)", "sum(k,k,1,100)", "integral(s,s,0,1)", "a=1", "1;2", "é", "\u202e1", "\\", "'", '"',
    "`echo`", "$(echo)", "%s%n", "../x", "/", "(" * 300 + "1" + ")" * 300, "-" * 300 + "1", "1" + "0" * 400,
    "9" * 2000, "1+" * 400 + "1", "nan(1)", "1e", "e", "E", "i", "right", "left", "both", "power-law", "piecewise",
]
WORDS = ["right", "left", "both", "power-law", "hertz", "cylinder-on-flat", "flat-and-rounded", "tilted-wedge",
         "tilted-flat-and-rounded", "piecewise", "piecewise-symmetric", "together", "normal-first", "first_exit",
         "measure", "pressure", "shear", "slip", "coefficients", "extent", "contact", "p", "q", "c_0", "s_1", "d"]
HEADER = re.compile(r"^\[\[?([^\[\]]+)\]\]?\s*(#.*)?$")
VALUE = re.compile(r'"([^"\n]*)"|(?<![\w."])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w."])')


def tables(text):
    """The text in pieces, each from a header to the next; the first piece precedes all headers."""
    pieces, quoted = [[]], False
    for line in text.splitlines(keepends=True):
        if not quoted and HEADER.match(line.strip()):
            pieces.append([])
        pieces[-1].append(line)
        quoted ^= (line.count("'''") + line.count('"""')) % 2 == 1
    return ["".join(piece) for piece in pieces]


def name_of(piece):
    match = HEADER.match(piece.split("\n", 1)[0].strip())
    return match.group(1).strip() if match else ""


def short_lists(text, rng, most=3):
    """Lists of many entries cut down to a few, so that a run is cheap."""
    def cut(match):
        entries = re.findall(r'"[^"]*"|[^\s,]+', match.group(2))
        if len(entries) > most:
            chosen = sorted(rng.sample(range(len(entries)), most))
            return match.group(1) + "[" + ", ".join(entries[i] for i in chosen) + "]"
        return match.group(0)
    return re.sub(r"(?m)^(\w+ = )\[([^\[\]{}#]*)\]", cut, text)


def small_recipe(text, rng):
    """The head and one scene of a recipe."""
    pieces = tables(text)
    groups = sorted({".".join(name_of(p).split(".")[:2]) for p in pieces if name_of(p).count(".") >= 1})
    chosen = rng.choice(groups)
    kept = [p for p in pieces if name_of(p) == chosen or name_of(p).startswith(chosen + ".") or "." not in name_of(p)]
    return short_lists("".join(kept), rng)


def small_ledger(text, rng):
    """A ledger with one or two of its claims, mostly without its [later] tables."""
    pieces = tables(text)
    head = None
    groups = {}  # the tables of each claim, by the index of its first
    kept = set()
    for i, piece in enumerate(pieces):
        kind = name_of(piece).split(".")[0]
        head = i if name_of(piece) == "claim" else head
        if kind == "claim" and head is not None:
            groups.setdefault(head, []).append(i)
        elif kind != "later" or rng.random() < 0.05:
            kept.add(i)
    for chosen in rng.sample(sorted(groups), min(len(groups), rng.choice([1, 1, 2]))):
        kept.update(groups[chosen])
    return "".join(pieces[i] for i in sorted(kept))


def small_table(text, rng, most=12):
    """The notes, the header and some rows of a CSV file."""
    lines = text.splitlines(keepends=True)
    head = next((i for i, line in enumerate(lines) if not line.startswith("#")), 0) + 1
    rows = lines[head:]
    first = rng.randrange(max(1, len(rows) - most))
    return "".join(lines[:head][-3:] + rows[first:first + most])


class Library:
    """The shipped files by kind: scene, design, recipe, ledger, answers, mesh."""

    def __init__(self, source):
        source = pathlib.Path(source)
        corpus = source / "tests/fuzz/corpus"
        files = {
            "scene": [*(source / "examples/scenes").glob("*.toml"), source / "examples/compare/cylinder.toml",
                      *(corpus / "scene").glob("*.toml")],
            "design": (source / "examples/design").glob("*.toml"),
            "recipe": [f for f in (source / "reference").glob("*.toml") if f.name != "hard-cases.toml"]
            + [source / "examples/third-party/questions.toml", *(corpus / "recipe").glob("*.toml")],
            "ledger": [source / "verify/moore-hills.toml", source / "examples/third-party/formulas.toml",
                       *(corpus / "ledger").glob("*.toml")],
            "answers": [*(source / "reference").glob("*.csv"), *(corpus / "answers").glob("*.csv")],
            "mesh": [*(source / "examples/compare").glob("*.csv")],
        }
        self.texts = {kind: [f.read_text(encoding="utf-8") for f in sorted(of)] for kind, of in files.items()}
        self.texts["slip"] = [text for text in self.texts["scene"] if "\nfriction" in text]

    def plain(self, kind, rng):
        """A shipped file of that kind, reduced."""
        text = rng.choice(self.texts[kind])
        if kind == "recipe":
            return small_recipe(text, rng)
        if kind == "ledger":
            return small_ledger(text, rng)
        if kind == "answers":
            return small_table(text, rng)
        return short_lists(text, rng) if kind in ("scene", "slip") else text

    def drawn(self, kind, rng):
        """The bytes of a file of that kind: half of them are unchanged, the others are changed in
        one to three places."""
        text = self.plain(kind, rng)
        if rng.random() < 0.5:
            return text.encode()
        for _ in range(rng.choice([1, 1, 1, 1, 2, 3])):
            change = rng.choice(TABLE_CHANGES if kind in ("answers", "mesh") else TOML_CHANGES)
            text = change(text, rng, self, kind)
        data = text.encode("utf-8", "surrogatepass")
        return broken_bytes(data, rng) if rng.random() < 0.04 else data


def broken_bytes(data, rng):
    at = rng.randrange(len(data) + 1)
    choice = rng.randrange(5)
    if choice == 0:
        return data[:at]
    if choice == 1:
        return data[:at] + bytes(rng.randrange(256) for _ in range(rng.randrange(1, 9))) + data[at:]
    if choice == 2:
        return b"\xef\xbb\xbf" + data
    if choice == 3:
        return data.replace(b"\n", b"\r\n")
    return data[:at] + b"\0" + data[at:]


def hostile(rng):
    return rng.choice(HOSTILE) if rng.random() < 0.8 else rng.choice(WORDS)


def near(text, rng):
    """A number of the same kind: other digits, sign or size."""
    choice = rng.randrange(6)
    if choice == 0:
        return "-" + text
    if choice == 1:
        return text + rng.choice(["0", "5", "e1", "e-9", "e9", "/3", "*2", "%", "^2", "^-1"])
    if choice == 2 and text:
        at = rng.randrange(len(text))
        return text[:at] + rng.choice("0123456789") + text[at + 1:]
    if choice == 3:
        return "(" + text + ")*" + rng.choice(["1e-12", "1e12", "1e-100", "pi", "-1", "(1-1e-15)"])
    if choice == 4:
        return text[1:]
    return str(rng.randrange(-3, 100))


def toml_value(value, rng):
    if rng.random() < 0.12:
        return rng.choice(["[]", "{}", "true", "1e400", "nan", "-1", "0", "99999999999999999999", "1979-05-27", "''",
                           '["1", "2"]', '{ from = "0", to = "1" }', '{ from = "1e-9", to = "1", points = 4 }'])
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'


def change_value(text, rng, _library, _kind):
    """Replaces one value by a hostile or a near one."""
    places = [m for m in VALUE.finditer(text) if text.rfind("#", text.rfind("\n", 0, m.start()) + 1, m.start()) < 0]
    if not places:
        return text
    place = rng.choice(places)
    old = place.group(1) if place.group(1) is not None else place.group(0)
    new = near(old, rng) if rng.random() < 0.75 else hostile(rng)
    return text[:place.start()] + toml_value(new, rng) + text[place.end():]


def swap_values(text, rng, library, kind):
    """Replaces a value of this file by one of another file."""
    places = list(VALUE.finditer(text))
    others = list(VALUE.finditer(library.plain(rng.choice([kind, kind, "scene", "ledger", "recipe"]), rng)))
    if not places or not others:
        return text
    place = rng.choice(places)
    return text[:place.start()] + rng.choice(others).group(0) + text[place.end():]


def lines_of(text):
    return text.splitlines(keepends=True) or [""]


def dropped(parts):
    """A change that leaves out one of the parts, lines or tables."""
    def change(text, rng, _library, _kind):
        pieces = parts(text)
        del pieces[rng.randrange(len(pieces))]
        return "".join(pieces)
    return change


def inserted(parts, kinds=None):
    """A change that inserts a part of a file of these kinds (and mostly of the same kind), or doubles one."""
    def change(text, rng, library, kind):
        pieces = parts(text)
        others = parts(library.plain(rng.choice([kind, kind, *kinds]), rng)) if kinds else pieces
        pieces.insert(rng.randrange(len(pieces) + 1), rng.choice(others))
        return "".join(pieces)
    return change


drop_line, drop_table, double_line = dropped(lines_of), dropped(tables), inserted(lines_of)
foreign_line = inserted(lines_of, ["scene", "design", "ledger"])
foreign_table = inserted(tables, ["scene", "design", "ledger", "recipe"])


def rename_key(text, rng, _library, _kind):
    keys = list(re.finditer(r"(?m)^\s*([\w.-]+)\s*=", text))
    if not keys:
        return text
    key = rng.choice(keys)
    new = rng.choice([rng.choice(keys).group(1), key.group(1)[:-1], key.group(1) + "x", "", "a.b", '"a b"', "P", "M",
                      "tolerance", "friction", "terms", "x", "digits", "alpha", "b"])
    return text[:key.start(1)] + new + text[key.end(1):]


def change_header(text, rng, _library, _kind):
    headers = list(re.finditer(r"(?m)^\[.*\]$", text))
    if not headers:
        return text
    header = rng.choice(headers)
    new = rng.choice(["[profile]", "[load]", "[shear]", "[ask]", "[units]", "[[claim]]", "[[family]]", "[", "[[x]]", "[]",
                      "[design]", "[scenes.x.load]", "[define]", header.group(0) * 2])
    return text[:header.start()] + new + text[header.end():]


def add_key(text, rng, _library, _kind):
    """Adds a key that some file of the kind may have, with a hostile value, below a header."""
    pieces = tables(text)
    at = rng.randrange(len(pieces))
    key = rng.choice(["a", "b", "P", "M", "width", "contact_modulus", "E1", "nu1", "Q", "bulk_tension", "friction", "path",
                      "edges", "terms", "u", "x", "tolerance", "digits", "quantities", "process_zone", "alpha", "title",
                      "kind", "count", "points", "says", "of", "over", "vary", "with", "where", "undefined", "id",
                      "printed", "rounding", "maximise", "knots", "slopes", "t", "R", "m", "C", "phi"])
    pieces[at] = pieces[at].rstrip("\n") + "\n" + key + " = " + toml_value(hostile(rng), rng) + "\n"
    return "".join(pieces)


TOML_CHANGES = [change_value] * 8 + [swap_values] * 3 + [add_key] * 3 + [
    rename_key, rename_key, drop_line, drop_line, double_line, foreign_line, foreign_line, drop_table, foreign_table,
    change_header]


def table_cells(text, rng, _library, _kind):
    """Changes one cell, or one column of all rows."""
    lines = lines_of(text)
    rows = [i for i, line in enumerate(lines) if not line.startswith("#") and "," in line]
    if not rows:
        return text
    one = rng.choice(rows)
    column = rng.randrange(lines[one].count(",") + 1)
    how = rng.randrange(5)
    value = hostile(rng)
    for i in [one] if rng.random() < 0.6 else rows[1:]:
        cells = lines[i].rstrip("\n").split(",")
        if column < len(cells):
            if how == 0:
                del cells[column]
            else:
                cells[column] = near(cells[column], rng) if how < 3 else value
        lines[i] = ",".join(cells) + "\n"
    return "".join(lines)


def other_separator(text, rng, _library, _kind):
    return text.replace(",", rng.choice([";", "\t", " ", ",,", " , "]))


def reversed_rows(text, _rng, _library, _kind):
    lines = lines_of(text)
    return "".join(lines[:1] + lines[:0:-1])


TABLE_CHANGES = [table_cells] * 8 + [drop_line, double_line, foreign_line, other_separator, reversed_rows]
