#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""command_line.py PROGRAM SOURCE [--runs N] [--seed S] [--jobs J] [--only I] [--keep FOLDER]

Runs the program with command lines drawn from a seed: all subcommands, with the shipped files
changed in a few places and with hostile options; some with a full standard output, some
interrupted. Run I of a seed is always the same (--only I repeats it, --keep leaves its folder). It
is a failure if a run
- ends by a signal, or with an exit status other than 0, 1 and 2 (130 if it was interrupted);
- takes longer than 20 s (on a busy machine: of processor time), or continues after an interruption;
- ends with 0 or 1, and its output is incomplete: CSV, JSON, XML or a page that does not parse, a
  missing file, a standard output that could not be written;
- ends with 2 and a message that is not one line, or leaves a file behind.
"""
import argparse
import collections
import csv
import dataclasses
import io
import json
import multiprocessing
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

import drawn_commands
import drawn_inputs

MOST_SECONDS = 20
MOST_SECONDS_OF_AN_INTERRUPTION = 4  # the limit is 2; the machine may be busy
MOST_MEMORY = 6 << 30


@dataclasses.dataclass
class Outcome:
    code: int | None  # None: it did not end
    out: bytes
    err: bytes
    seconds: float


def refuse_constant(name):
    raise ValueError(name + " is no JSON")


def csv_problem(text):
    rows = list(csv.reader(io.StringIO("".join(line for line in io.StringIO(text, newline="") if not line.startswith("#")))))
    if not rows:
        return "CSV without a header"
    uneven = [row for row in rows if len(row) != len(rows[0])]
    return f"a CSV row with {len(uneven[0])} cells of {len(rows[0])}: {uneven[0]}" if uneven else None


def form_problem(form, data):
    """The fault of an output of that form, or None."""
    if not data:
        return "it is empty"
    if form in ("png", "pdf", "figure", "any"):
        return None
    try:
        text = data.decode()
        if form == "json":
            json.loads(text, parse_constant=refuse_constant)
        elif form in ("xml", "svg"):
            xml.etree.ElementTree.fromstring(text)
        elif form == "html" and not text.rstrip().endswith("</html>"):
            return "the page has no end"
        elif form == "csv" and (problem := csv_problem(text)):
            return problem
    except (ValueError, csv.Error, xml.etree.ElementTree.ParseError) as error:
        return str(error)
    return None if text.endswith("\n") or form in ("svg", "html") else "its last line has no end"


def written_problem(folder, name, form):
    path = folder / name
    if form == "folder":
        return None if path.is_dir() and any(path.iterdir()) else f"{name} is missing"
    if not path.is_file():
        return f"{name} is missing"
    problem = form_problem(form, path.read_bytes())
    return problem and f"{name}: {problem}"


def left_over(folder, command):
    """Names of new files in the folder that are not complete results."""
    results = {name for name, form in command.written.items() if not written_problem(folder, name, form)}
    results |= {name.split("/")[0] for name in results}
    return [name for name in sorted(os.listdir(folder))
            if name not in command.files and name not in results and not name.startswith(command.kept or "\0")]


def message_problem(command, outcome, mode):
    lines = outcome.err.decode(errors="replace").splitlines()
    if lines and all(re.match(r"in\.toml:\d+: .*; ", line) for line in lines):
        return None  # a line for each claim of a ledger that cannot be read
    if "--exec" in command.arguments or mode == "full":
        lines = lines[-1:]  # after the output of the other program, or after the scene as a file
    if len(lines) != 1 or len(lines[0].strip()) < 10:
        return f"exit status 2 with {len(lines)} lines on standard error"
    return None


def problems_of(command, outcome, mode, folder):
    """The faults of a run."""
    code = outcome.code
    if code is None:
        return ["it was still running after " + f"{outcome.seconds:.1f} s" + (" of an interruption" if mode == "stop" else "")]
    if code not in (0, 1, 2) and not (mode == "stop" and code in (130, -signal.SIGINT)):
        return [f"exit status {code}"]
    found = []
    if code == 2 and (problem := message_problem(command, outcome, mode)):
        found.append(problem)
    if code in (0, 1):
        if mode == "full" and command.printed in ("csv", "json", "md", "tex", "text"):
            found.append(f"exit status {code} although nothing could be printed")
        if mode != "full" and command.printed in ("csv", "json", "md", "tex", "text"):
            problem = form_problem(command.printed, outcome.out)
            found += [f"exit status {code}, standard output: {problem}"] if problem else []
        found += [p for name, form in command.written.items() if (p := written_problem(folder, name, form))]
    # If one output could not be written, another complete one may exist.
    if code == 2 and b"cannot write" not in outcome.err and command.arguments[0] != "verify":
        command.written = {}
    left = left_over(folder, command)
    return found + ([f"exit status {code}, left behind: {' '.join(left)}"] if left else [])


def is_late(process, seconds, most):
    """True if a process that has run for `seconds` takes too long; it may take longer on a busy
    machine."""
    if seconds < most:
        return False
    fields = pathlib.Path(f"/proc/{process}/stat").read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()
    used = (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    return used > 0.8 * most or seconds > 15 * most


def run(program, command, mode, delay, folder):
    temporary = folder.with_name(folder.name + ".tmp")
    temporary.mkdir()
    environment = {**os.environ, "TMPDIR": str(temporary), "LC_ALL": "C.UTF-8"}
    begun = time.monotonic()
    with open("/dev/full", "wb") as full, tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err, \
            tempfile.TemporaryFile() as given:
        given.write(command.stdin)
        given.seek(0)
        child = subprocess.Popen([program, *[w.encode("utf-8", "surrogatepass") for w in command.arguments]], cwd=folder,
                                 stdin=given, stdout=full if mode == "full" else out, stderr=err, env=environment,
                                 start_new_session=True)
        most = MOST_SECONDS
        code = None
        if mode == "stop":
            try:
                code = child.wait(delay)
            except subprocess.TimeoutExpired:
                child.send_signal(signal.SIGINT)
                begun, most = time.monotonic(), MOST_SECONDS_OF_AN_INTERRUPTION
        while code is None and not is_late(child.pid, time.monotonic() - begun, most):
            try:
                code = child.wait(0.5)
            except subprocess.TimeoutExpired:
                pass
        if code is None:
            os.killpg(child.pid, signal.SIGKILL)
            child.wait()
        seconds = time.monotonic() - begun
        out.seek(0)
        err.seek(0)
        outcome = Outcome(code, out.read(), err.read(), seconds)
    shutil.rmtree(temporary, ignore_errors=True)
    return outcome


SETTINGS = None


def set_up(settings):
    global SETTINGS
    SETTINGS = settings
    SETTINGS.library = drawn_inputs.Library(settings.source)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def one(index):
    """Index, subcommand, exit status, seconds, problems and the command line of a run."""
    rng = random.Random(f"{SETTINGS.seed}:{index}")
    command = drawn_commands.drawn_command(rng, SETTINGS.library)
    mode = rng.choices(["usual", "full", "stop"], [92, 4, 4])[0]
    delay = rng.choice([0.01, 0.03, 0.1, 0.3])
    folder = pathlib.Path(SETTINGS.folder) / str(index)
    folder.mkdir()
    for name, data in command.files.items():
        (folder / name).write_bytes(data)
    outcome = run(SETTINGS.program, command, mode, delay, folder)
    problems = problems_of(command, outcome, mode, folder)
    if problems and SETTINGS.keep:
        kept = pathlib.Path(SETTINGS.keep) / str(index)
        shutil.rmtree(kept, ignore_errors=True)
        shutil.copytree(folder, kept, symlinks=True)
        (kept / "stdin").write_bytes(command.stdin)
        (kept / "stdout").write_bytes(outcome.out)
        (kept / "stderr").write_bytes(outcome.err)
        line = shlex.join(w.encode("utf-8", "replace").decode() for w in command.arguments)
        (kept / "command").write_text(f"{mode} {delay}\n{line}\n{problems}\n", encoding="utf-8")
    shutil.rmtree(folder, ignore_errors=True)
    return index, command.arguments[0] if command.arguments else "", outcome, problems, mode, command.arguments


def report(result):
    index, _, outcome, problems, mode, arguments = result
    line = ascii(shlex.join(arguments))[1:-1]
    print(f"run {index} ({mode}): edgeproof {line[:600]}")
    for problem in problems:
        print("    " + ascii(problem)[1:-1][:400])
    print("    " + ascii(outcome.err.decode(errors="replace"))[1:-1][-400:], flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("--runs", type=int, default=20000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", type=int, action="append")
    parser.add_argument("--keep")
    settings = parser.parse_args()
    settings.program = str(pathlib.Path(settings.program).resolve())
    runs = settings.only or range(settings.first, settings.first + settings.runs)
    codes = collections.Counter()
    slowest = []
    failures = []
    begun = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="edgeproof-fuzz-") as settings.folder:
        with multiprocessing.Pool(settings.jobs, set_up, (settings,)) as pool:
            for done, result in enumerate(pool.imap_unordered(one, runs, chunksize=4), 1):
                index, name, outcome, problems, *_ = result
                codes[outcome.code] += 1
                slowest = sorted([*slowest, (round(outcome.seconds, 1), index, name)])[-12:]
                if problems:
                    failures.append(result)
                    report(result)
                if done % 1000 == 0:
                    print(f"{done} runs, {len(failures)} failures, {time.monotonic() - begun:.0f} s", flush=True)
            # Runs that were slow together with others may be fast alone.
            slow = [f for f in failures if f[2].code is None]
        with multiprocessing.Pool(1, set_up, (settings,)) as pool:
            again = {f[0]: pool.apply(one, (f[0],)) for f in slow}
    failures = [again.get(f[0], f) for f in failures]
    failures = [f for f in failures if f[3]]
    print("exit statuses: " + ", ".join(f"{code}: {n}" for code, n in sorted(codes.items(), key=str)))
    print("slowest: " + ", ".join(f"{s} s ({name}, run {i})" for s, i, name in reversed(slowest)))
    print(f"{sum(codes.values())} runs of seed {settings.seed}, {len(failures)} failures: "
          + " ".join(str(f[0]) for f in failures))
    return 1 if failures or not codes else 0


if __name__ == "__main__":
    sys.exit(main())
