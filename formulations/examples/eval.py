#!/usr/bin/env python3
"""`halfway eval` from Python, one process for many requests: eval.py PROGRAM

Checks a joint of one's own (here the half-way frame at xi = 1/2, by hand) against it."""
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


worst = 0
for i in range(1, 31):
    phi = 0.1 * i  # rad about x
    answer = ask({"id": i, "formulation": "invariant", "kind": "angular", "want": ["loads"],
                  "law": {"type": "linear", "K": [1, 10, 100]},
                  "a": {"x": [0, 0, 0], "q": [1, 0, 0, 0]},
                  "b": {"x": [0, 0, 0], "q": [math.cos(phi / 2), math.sin(phi / 2), 0, 0]}})
    own = [0, 0, 0, -phi, 0, 0, 0, 0, 0, phi, 0, 0]  # internal loads (f_a, m_a, f_b, m_b): K = 1 N m/rad about x
    worst = max(worst, max(abs(x - y) for x, y in zip(answer["loads"], own)))
program.stdin.close()
print("30 joints, within rounding:", worst < 1e-14 * 3)
sys.exit(program.wait())
