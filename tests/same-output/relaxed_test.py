# SPDX-License-Identifier: BSD-3-Clause
"""What the modes of scripts/same-output accept and refuse."""
import json

import relaxed

CSV = "u,p,p_bound\n1,14.3,{}\n# a: 0.99 +- {} (from P)\n"
CASES = (  # old, new, whether the mode `bounds` accepts it
    (CSV.format("1e-9", "2e-9"), CSV.format("2e-9", "1e-12"), True),
    (CSV.format("1e-9", "2e-9"), CSV.format("2.1e-9", "2e-9"), False),
    (CSV.format("1e-9", "2e-9"), CSV.format("1e-9", "5e-9"), False),
    (CSV.format("1e-9", "0"), CSV.format("1e-9", "1e-30"), False),
    (CSV.format("1e-9", "0"), CSV.format("1e-9", "0").replace("14.3", "14.4"), False),
    (CSV.format("1e-9", "0"), CSV.format("1e-9", "0") + "1,2,3\n", False),
    ("| u | p_bound |\n| 1 | 1e-9  |", "| u | p_bound |\n| 1 | 1.5e-9 |", True),
    ("| u | p_bound |\n| 1 | 1e-9  |", "| u | p_bound |\n| 2 | 1e-9   |", False),
    ('{"p": "1", "p_bound": "3e-8"}', '{"p": "1", "p_bound": "6e-8"}', True),
    ('{"p": "1", "p_bound": "3e-8"}', '{"p": "1", "p_bound": "7e-8"}', False),
)
for old, new, accepted in CASES:
    assert relaxed.same_but_for_bounds(old.encode(), new.encode()) == accepted, (old, new)

CLAIM = {"id": "EQ01", "verdict": "refuted", "correct": "2*a", "quoted": None, "note": "old", "evidence": {}}
for change, accepted in (({"note": "new"}, True), ({"verdict": "confirmed"}, False), ({"correct": None}, False)):
    old, new = ({"1 exit status": b"0", "file v/verdicts.json": json.dumps({"claims": [claim]}).encode()}
                for claim in (CLAIM, CLAIM | change))
    assert (relaxed.verdicts_of(old) == relaxed.verdicts_of(new)) == accepted, change
print(f"{len(CASES) + 3} cases passed")
