# SPDX-License-Identifier: GPL-3.0-or-later
import json

import pytest

import edgeproof

# The Hertz pressure E* C sqrt(a^2 - x^2)/2 of the textbooks, once right and once wrong.
LEDGER = """
[ledger]
name = "own"
source = "a test"
[[family]]
name = "hertz"
profile = "power-law"
count = 3
points = 2
u = ["1e-12", "1/20", "1/5", "3/7"]
[family.parameters]
m = ["1"]
C = ["3/7", "1e-6"]
a = ["3/2", "0.02"]
Es = ["7/3"]
"""
CLAIM = """
[[claim]]
id = "{id}"
kind = "compare"
lines = [1, 2]
printed = '''{says}'''
over = "hertz"
of = "p(x)"
says = "{says}"
"""


@pytest.fixture
def ledger(tmp_path):
    file = tmp_path / "own.toml"
    file.write_text(LEDGER + CLAIM.format(id="right", says="Es*C/2*sqrt(a^2-x^2)") +
                    CLAIM.format(id="wrong", says="Es*C/3*sqrt(a^2-x^2)"))
    return file


def test_verdicts(ledger):
    calls = []
    audit = edgeproof.verify(ledger, digits=30, progress=lambda done, of: calls.append((done, of)))
    assert audit.ledger == "own" and audit.source == "a test" and audit.digits == 30
    assert [c.id for c in audit] == ["right", "wrong"] and len(audit) == 2
    assert audit["right"].verdict in ("proved", "confirmed") and audit["right"].holds
    assert audit["wrong"].verdict == "refuted" and not audit["wrong"].holds
    assert audit.refuted == (audit["wrong"],) and audit.counts["refuted"] == 1
    assert audit["wrong"].correct and audit["wrong"].evidence["kind"] == "compare"
    assert audit["wrong"].rests_on == "enclosures" and audit["wrong"].certificate is None
    assert audit.differences is None and "1 refuted" in audit.summary
    assert calls and calls[-1][1] == 2
    with pytest.raises(KeyError):
        audit["other"]
    assert json.loads(json.dumps(audit.to_dict()))["claims"][1]["verdict"] == "refuted"


def test_only_and_recorded_verdicts(source):
    audit = edgeproof.verify(source / "verify/moore-hills.toml", digits=20, only="EQ18")
    assert [c.id for c in audit] == ["EQ18"]
    assert audit.differences == ()


def test_errors(ledger):
    ledger.write_text(ledger.read_text().replace('says = "Es*C/3', 'says = "Ez*C/3'))
    with pytest.raises(edgeproof.InputError, match="Ez") as raised:
        edgeproof.verify(ledger)
    assert raised.value.file == str(ledger) and raised.value.line is not None
    with pytest.raises(edgeproof.InputError, match="digits"):
        edgeproof.verify(ledger, digits=5)
    with pytest.raises(edgeproof.InputError, match="threads"):
        edgeproof.verify(ledger, threads=-1)
