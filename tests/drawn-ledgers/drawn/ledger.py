# SPDX-License-Identifier: BSD-3-Clause
"""Claims with their truth, their families, and the text of a ledger."""
import dataclasses

# The permitted verdicts, by the known truth of the claim. Only a false claim may have any verdict
# except the two that confirm it.
RIGHT_VERDICTS = {
    "true": {"proved", "confirmed"},
    "false": {"refuted", "imprecise", "underspecified"},
    "imprecise": {"imprecise"},        # a figure that is one unit off
    "some": {"underspecified", "imprecise"},  # it holds for some sizes of the contact, not for all
    "no value": {"underspecified"},    # the printed formula has no value
}


@dataclasses.dataclass(frozen=True)
class Family:
    """A family of a ledger. `parameters`: pairs of a name and a tuple of exact texts."""
    profile: str
    parameters: tuple
    count: int = 1
    u: tuple = ()
    points: int = 1
    knots: tuple = ()
    slopes: tuple = ()

    def value(self, name):
        return dict(self.parameters)[name][0]


@dataclasses.dataclass
class Claim:
    """`keys`: the keys of its kind. `truth`: of RIGHT_VERDICTS, or a bool. `label`: a class of similar claims. `why`: the
    reason for its truth."""
    kind: str
    keys: dict
    family: Family | None
    truth: str
    label: str
    why: str = ""
    most_digits: int = 1000
    group: str = ""  # the row of the table; empty: the kind

    def __post_init__(self):
        self.truth = {True: "true", False: "false"}.get(self.truth, self.truth)


def family(profile, count=1, u=(), points=1, knots=(), slopes=(), **parameters):
    lists = tuple((name, (v,) if isinstance(v, str) else tuple(v)) for name, v in parameters.items())
    return Family(profile, lists, count, tuple(u), points, tuple(knots), tuple(slopes))


def _text(value):
    if isinstance(value, dict):
        return "{ " + ", ".join(f'"{k}" = {_text(v)}' for k, v in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_text(v) for v in value) + "]"
    if isinstance(value, int):
        return str(value)
    return '"' + str(value) + '"'


class Ledger:
    """The text of a ledger, which contains each family once."""

    def __init__(self, name):
        self.name = name
        self.claims = []
        self._names = {}
        self._families = []

    def _name_of(self, of):
        if of not in self._names:
            lines = [f'profile = "{of.profile}"', f"count = {of.count}"]
            lines += [f"points = {of.points}"] if of.points > 1 else []
            lines += [f"u = {_text(of.u)}"] if of.u else []
            if of.profile.startswith("piecewise"):
                lines += [f"knots = {_text(of.knots)}", f"slopes = {_text(of.slopes)}"]
            lines += ["[family.parameters]"] + [f"{n} = {_text(v)}" for n, v in of.parameters]
            name = f"f{len(self._names) + 1}"
            self._families.append("\n".join(["[[family]]", f'name = "{name}"', *lines]))
            self._names[of] = name
        return self._names[of]

    def add(self, claim):
        self.claims.append(claim)

    def text(self):
        blocks = []
        for number, claim in enumerate(self.claims, 1):
            lines = [f"# {claim.truth}: {claim.label}" + (f". {claim.why}" if claim.why else ""),
                     "[[claim]]", f'id = "C{number}"', f'kind = "{claim.kind}"']
            lines += [f"{key} = {_text(value)}" for key, value in claim.keys.items()]
            if claim.family is not None:
                lines.append(f'over = "{self._name_of(claim.family)}"')
            blocks.append("\n".join(lines))
        head = f'[ledger]\nname = "{self.name}"\nsource = "drawn"'
        return "\n\n".join([head, *self._families, *blocks]) + "\n"
