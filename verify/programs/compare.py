#!/usr/bin/env python3
"""Answers of the programs against those of the day they were measured: compare.py PROGRAMS.tsv DATA [CASE ...]

PROGRAMS.tsv is what build.sh wrote, DATA the folder reference/data/programs. Largest relative errors of a force or a
moment, by case, against the accuracy in the header of the data. Exit 77: no program is there."""
import json
import math
import re
import shlex
import subprocess
import sys
from pathlib import Path

PARTS = ("f_a", "m_a", "f_b", "m_b")
DEPEND_ON_MASS = ("bullet_default", "mujoco_weld")  # no force laws: README.md
HELLO = {"id": "hello", "hello": {"protocol": "halfway-check", "version": 1}}


def request(pose, kind):
    """Of a measured pose, with its springs of that kind."""
    k = {"linear": pose["k_trans"], "angular": pose["k_rot"]}.get(kind, pose["k_trans"] + pose["k_rot"])
    K = [[k[i] if i == j else 0 for j in range(len(k))] for i in range(len(k))]
    return {"id": f"{kind}{pose['id']}", "kind": kind, "law": {"type": "linear", "K": K}, "a": pose["a"],
            "b": pose["b"], "want": ["loads"]}


def broken(whole):
    """What every program has to refuse or pass over, and then go on: (line, keys of which the answer has one)."""
    coupled = json.loads(json.dumps(whole))
    coupled["law"]["K"][0][1] = coupled["law"]["K"][1][0] = 0.5
    return [("{not JSON", {"error"}), ("[1]", {"error"}), (json.dumps({**whole, "kind": "square"}), {"error"}),
            (json.dumps({**whole, "a": {"x": [0, 0, 0], "q": [0, 0, 0, 0]}}), {"error", "skipped"}),
            (json.dumps(coupled), {"skipped"})]


def ask(command, lines):
    run = subprocess.run(shlex.split(command), input="".join(line + "\n" for line in lines), capture_output=True,
                         text=True, timeout=300)
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    if run.returncode or len(answers) != len(lines):
        last = run.stderr.strip().splitlines()[-1:]
        raise ValueError(f"{len(answers)} answers to {len(lines)} requests, exit code {run.returncode} {last}")
    return answers


def apart(loads, measured):
    """Largest relative difference of a force or a moment. What was measured as zero is held against one newton."""
    worst = 0
    for i, part in enumerate(PARTS):
        size = math.hypot(*measured[part]) or 1
        worst = max(worst, math.dist(loads[3 * i:3 * i + 3], measured[part]) / size)
    return worst


def loads_of(answer):
    if "loads" not in answer:
        raise ValueError(f"no loads: {json.dumps(answer)}")
    return answer["loads"]


def compare(case, command, poses):
    """Name and error of each comparison with what was measured, and what is wrong with the protocol."""
    requests = {kind: [request(pose, kind) for pose in poses] for kind in ("linear_angular", "angular", "linear")}
    for kind in ("linear_angular", "angular"):
        heavy = {"mass": [2, 0.5], "inertia": [3, 0.7]}
        requests[kind + ", heavy"] = [{**one, **heavy} for one in requests[kind]]
    bad = broken(requests["linear_angular"][1]) + broken(requests["angular"][1])
    asked = [HELLO] + sum(requests.values(), [])
    answers = ask(command, [json.dumps(one) for one in asked] + [line for line, _ in bad])
    kinds, rest = answers[0]["kinds"], iter(answers[1:])
    answered = {name: [next(rest) for _ in poses] for name in requests}

    main_kind = "linear_angular" if "linear_angular" in kinds else "angular"
    loads = {"as measured": list(map(loads_of, answered[main_kind]))}
    if len(kinds) == 3 and case != "bullet_default":  # a measured law is linear in K
        both = zip(map(loads_of, answered["linear"]), map(loads_of, answered["angular"]))
        loads["linear + angular"] = [[u + v for u, v in zip(x, y)] for x, y in both]
    if case not in DEPEND_ON_MASS:
        loads["other masses"] = list(map(loads_of, answered[main_kind + ", heavy"]))
    refusals = zip(bad, rest)
    wrong = [f"to '{line[:40]}' {json.dumps(answer)}" for (line, keys), answer in refusals if not keys & set(answer)]
    return {name: max(map(apart, those, poses)) for name, those in loads.items()}, wrong


def main(table, folder, chosen):
    ran, failed = 0, 0
    for line in Path(table).read_text().splitlines():
        case, command, *reason = line.split("\t")
        if chosen and case not in chosen:
            continue
        if command == "-":
            print(f"{case:20} left out: {reason[0]}")
            continue
        data = json.loads((Path(folder) / f"{case}.json").read_text())
        accuracy = float(re.search(r"about (\S+)", data["header"]["accuracy"]).group(1))
        ran += 1
        try:
            errors, wrong = compare(case, command, data["poses"])
        except (ValueError, KeyError, OSError, subprocess.TimeoutExpired) as problem:
            errors, wrong = {}, [str(problem)]
        wrong += [f"{name}: off by more" for name, error in errors.items() if not error <= accuracy]
        print(f"{case:20} within {accuracy:.0e}:", ", ".join(f"{name} {error:.1e}" for name, error in errors.items()))
        for text in wrong:
            print(f"  WRONG {text}")
        failed += bool(wrong)
    print(f"{ran - failed} passed, {failed} failed")
    return 77 if ran == 0 else failed > 0


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:]))
