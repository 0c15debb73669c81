# SPDX-License-Identifier: BSD-3-Clause
"""Runs `edgeproof verify` on drawn ledgers and counts verdicts by the known truth of the claims."""
import collections
import concurrent.futures
import dataclasses
import json
import os
import subprocess

from .ledger import RIGHT_VERDICTS


@dataclasses.dataclass
class Judged:
    claim: object
    digits: int
    verdict: str
    note: str

    @property
    def wrong(self):
        return self.verdict not in RIGHT_VERDICTS[self.claim.truth] | {"undecided"}


def run(edgeproof, ledger, digits, path, seconds):
    """The verdict on every claim of a ledger; path: the file for its text."""
    path.write_text(ledger.text())
    out = path.with_suffix("")
    command = [edgeproof, "verify", path, "--digits", str(digits), "--out", out, "--threads", "1"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=seconds, check=False)
        problem = f"exit status {done.returncode}: {done.stderr[-300:]}" if done.returncode not in (0, 2) else ""
    except subprocess.TimeoutExpired:
        problem = f"no answer in {seconds} s"
    verdicts, errors = {}, {}
    if not problem:
        try:
            found = json.loads((out / "verdicts.json").read_text())
            verdicts = {c["id"]: (c["verdict"], c["note"] or "") for c in found["claims"]}
            errors = {e["id"]: ("error", f"{e['problem']}; {e['instead']}") for e in found.get("errors", [])}
        except (OSError, ValueError) as error:
            problem = f"{error}: {done.stderr[-300:]}"
    judged = []
    for number, claim in enumerate(ledger.claims, 1):
        name = f"C{number}"
        verdict, note = verdicts.get(name) or errors.get(name) or ("error", problem or "not among the verdicts")
        judged.append(Judged(claim, digits, verdict, note))
    return judged


def run_all(edgeproof, jobs, folder, seconds, threads):
    """jobs: pairs of a ledger and digits."""
    with concurrent.futures.ThreadPoolExecutor(threads or os.cpu_count()) as pool:
        tasks = [pool.submit(run, edgeproof, ledger, digits, folder / f"{ledger.name}.toml", seconds) for ledger,
                 digits in jobs]
        return [judged for task in tasks for judged in task.result()]


def refuted_share(all_judged, group):
    """The share of refuted claims among the false ones of a group, and their number."""
    false = [j for j in all_judged if j.claim.group == group and j.claim.truth == "false"]
    return sum(j.verdict == "refuted" for j in false) / max(1, len(false)), len(false)


def table(all_judged):
    """Lines: kind, claims, true and false ones, wrong verdicts on them (and on others), undecided ones, errors."""
    rows = collections.defaultdict(collections.Counter)
    for j in all_judged:
        truth = j.claim.truth if j.claim.truth in ("true", "false") else "other"
        for row in (j.claim.group or j.claim.kind, "all"):
            rows[row].update({"claims": 1, truth: 1, f"wrong {truth}": j.wrong, "undecided": j.verdict == "undecided",
                              "errors": j.verdict == "error"})
    columns = ("claims", "true", "wrong true", "false", "wrong false", "other", "wrong other", "undecided", "errors")
    lines = [f"{'kind':16}" + "".join(f"{name:>13}" for name in columns)]
    for kind, c in sorted(rows.items(), key=lambda r: (r[0] == "all", r[0])):
        lines.append(f"{kind:16}" + "".join(f"{c[name]:>13}" for name in columns))
    return "\n".join(lines)
