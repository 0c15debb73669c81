# SPDX-License-Identifier: BSD-3-Clause
"""The examples of docs/guide/python.md and of the package print the results that are shown."""
import doctest
import os
import re

import edgeproof


def run(text, name):
    # A fence ends the output of an example.
    text = re.sub(r"(?m)^```.*$", "", text)
    test = doctest.DocTestParser().get_doctest(text, {}, name, name, 0)
    runner = doctest.DocTestRunner(optionflags=doctest.ELLIPSIS)
    runner.run(test)
    assert runner.failures == 0
    return runner.tries


def test_the_page(source):
    before = os.getcwd()
    os.chdir(source)
    try:
        page = (source / "docs" / "guide" / "python.md").read_text(encoding="utf-8")
        assert run(page, "docs/guide/python.md") >= 20
    finally:
        os.chdir(before)


def test_the_package_shows_how_to_begin():
    lines = [line[4:] for line in edgeproof.__doc__.splitlines() if line.startswith("    ") and
             not line.startswith("     ")]
    code = "\n".join(lines[:4])
    names = {}
    exec(code, names)
    assert names["p"].proved
