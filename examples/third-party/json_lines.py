#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""closed_forms.py once more, a JSON object a line.

    edgeproof check questions.toml --lines json --exec 'python3 json_lines.py' --digits 13
"""
import json
import sys

import closed_forms

for line in sys.stdin:
    question = json.loads(line)
    print(json.dumps({"id": question["id"], "value": closed_forms.answer(question)}))
