# SPDX-License-Identifier: GPL-3.0-or-later
"""The named wrong edits of tests/mutations, whose README gives the format."""
import contextlib
import functools
import re
import tomllib
from dataclasses import dataclass
from fnmatch import fnmatchcase

from tree_copy import ROOT

FOLDER = ROOT / "tests" / "mutations"


class Malformed(Exception):
    pass


LITERAL = r'"(?:[^"\\]|\\.)*"'


@functools.cache
def test_cases(folder):
    """The names of the doctest cases in a folder."""
    texts = [text for path in folder.rglob("*.cpp")
             for text in re.findall(rf"TEST_CASE(?:_TEMPLATE)?\(\s*((?:{LITERAL}\s*)+)", path.read_text())]
    return ["".join(literal[1:-1] for literal in re.findall(LITERAL, text)) for text in texts]


@dataclass(frozen=True)
class Mutation:
    name: str
    why: str
    file: str
    find: str
    replace: str
    target: str
    case: str | None = None
    ctest: str | None = None

    def test(self):
        """The identity of the test; each test is run once on the unchanged code."""
        return (self.target, self.case, self.ctest)

    def command(self, build):
        if self.ctest is not None:
            return ["ctest", "--test-dir", str(build), "--no-tests=error", "-R", self.ctest]
        chosen = f"--test-case={self.case}" if self.case else "--test-suite-exclude=slow"
        return [str(build / "bin" / self.target), chosen]

    def fault(self, root):
        """The reason why the edit does not apply to the tree at root, or None."""
        path = root / self.file
        if not path.is_file():
            return f"no file {self.file}"
        count = path.read_text().count(self.find)
        if count != 1:
            return f"its text occurs {count} times in {self.file}"
        folder = root / "tests" / self.target.removeprefix("test_")
        if self.case and not any(fnmatchcase(name.lower(), pattern.lower())
                                 for name in test_cases(folder) for pattern in self.case.split(",")):
            return f"{self.target} has no test case {self.case!r}"
        return None

    @contextlib.contextmanager
    def made(self, tree):
        """Makes the edit in tree, and undoes it after the block."""
        path = tree / self.file
        original = path.read_text()
        path.write_text(original.replace(self.find, self.replace))
        try:
            yield
        finally:
            path.write_text(original)


def load(path):
    try:
        fields = tomllib.loads(path.read_text())
        mutation = Mutation(name=path.stem, **fields)
    except (tomllib.TOMLDecodeError, TypeError) as error:
        raise Malformed(f"{path}: {error}") from error
    if not all(isinstance(value, str) for value in fields.values()):
        raise Malformed(f"{path}: every value is text")
    if mutation.case and mutation.ctest:
        raise Malformed(f"{path}: case and ctest exclude each other")
    if not mutation.find or mutation.find == mutation.replace:
        raise Malformed(f"{path}: the edit changes nothing")
    return mutation


def load_all(names=()):
    """The edits with these names, or all."""
    files = {path.stem: path for path in sorted(FOLDER.glob("*.toml"))}
    unknown = [name for name in names if name not in files]
    if unknown:
        raise Malformed(f"no edit is called {', '.join(unknown)}")
    return [load(files[name]) for name in (names or files)]


def first_errors(built):
    """The first error in a compiler's output, or the end of the output."""
    errors = [line for line in built.stdout.splitlines() if "error:" in line]
    return errors[0] if errors else built.stdout[-300:]
