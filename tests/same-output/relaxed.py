# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/same-output ignores in its modes `bounds` and `verdicts`."""
import decimal
import json
import re

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
INLINE = re.compile(rf"((?:\+-|±|\\pm)\s*|_?bound\"?[:=] *\"?){NUMBER}")
SEPARATORS = (",", "|", "&")
RATIO = 2  # a new bound is at most twice the old one


def without_bounds(text):
    """A text whose bounds are replaced by a word, and the bounds. Bounds follow `+-` or a key that ends with `bound`, or
    stand in a column whose head ends with `bound`. White space is folded, because the widths of columns follow bounds."""
    bounds, lines, head = [], [], (None, [])

    def taken(match):
        bounds.append(match[0][len(match[1]):])
        return match[1] + "BOUND"
    for line in text.split("\n"):
        line = INLINE.sub(taken, line)
        for separator in SEPARATORS:
            cells = line.split(separator)
            columns = [k for k, c in enumerate(cells) if re.search(r"bound\W*$", c)]
            if len(cells) > 1 and columns and not re.search(r"\d", cells[columns[0]]):
                head = (separator, columns)
        cells = line.split(head[0]) if head[0] else []
        for k in head[1]:
            if k < len(cells) and re.fullmatch(rf"\W*{NUMBER}\W*", cells[k]):
                bounds.append(re.search(NUMBER, cells[k])[0])
                cells[k] = "BOUND"
        lines.append(" ".join((head[0].join(cells) if cells else line).split()))
    return "\n".join(lines), bounds


def same_but_for_bounds(old, new):
    """Whether two outputs have the same text and values, and no new bound is greater than twice the old one."""
    (old_text, old_bounds), (new_text, new_bounds) = (without_bounds(data.decode(errors="replace")) for data in (old, new))
    return old_text == new_text and len(old_bounds) == len(new_bounds) and all(
        decimal.Decimal(n) <= RATIO * decimal.Decimal(o) for o, n in zip(old_bounds, new_bounds))


def verdicts_of(outputs):
    """The outputs of `verify` that a reader acts on: exit status, and for each claim the verdict and the correction."""
    kept = {name: data for name, data in outputs.items() if name.endswith("exit status")}
    for name, data in outputs.items():
        if name.endswith("verdicts.json"):
            try:
                claims = json.loads(data)["claims"]
            except (ValueError, KeyError, UnicodeDecodeError):
                continue
            rows = (json.dumps([c.get(k) for k in ("id", "verdict", "correct", "quoted")]) for c in claims)
            kept[name] = "\n".join(rows).encode()
    return kept
