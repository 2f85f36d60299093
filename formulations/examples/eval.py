#!/usr/bin/env python3
"""`halfway eval` from Python, one process for many requests: eval.py PROGRAM

Checks a joint of one's own (here the half-way frame at xi = 1/2, by hand) against it, pose by pose and then all at once."""
import json
import math
import subprocess
import sys

program = subprocess.Popen([sys.argv[1], "eval"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)


def ask(request):
    program.stdin.write(json.dumps(request) + "\n")
    program.stdin.flush()
    answer = json.loads(program.stdout.readline())
    if "error" in answer:
        raise ValueError(answer["error"]["message"])
    return answer


def turned(phi):  # rad about x
    return {"x": [0, 0, 0], "q": [math.cos(phi / 2), math.sin(phi / 2), 0, 0]}


joint = {"formulation": "invariant", "kind": "angular", "law": {"type": "linear", "K": [1, 10, 100]}, "want": ["loads"]}
angles = [0.1 * i for i in range(1, 31)]
worst = 0
for i, phi in enumerate(angles):
    answer = ask({**joint, "id": i, "a": turned(0), "b": turned(phi)})
    own = [0, 0, 0, -phi, 0, 0, 0, 0, 0, phi, 0, 0]  # internal loads (f_a, m_a, f_b, m_b): K = 1 N m/rad about x
    worst = max(worst, max(abs(x - y) for x, y in zip(answer["loads"], own)))
print("30 joints, within rounding:", worst < 1e-14 * 3)

# One request: the joint once, and a list for each answer. What poses leave out, here a, stands beside them.
block = ask({**joint, "a": turned(0), "poses": [{"b": turned(phi)} for phi in angles]})
print("30 poses of one joint, largest moment on b:", round(max(loads[9] for loads in block["loads"]), 12), "N m")
program.stdin.close()
sys.exit(program.wait())
