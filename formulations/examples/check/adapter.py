#!/usr/bin/env python3
"""A joint behind `halfway check`, an isotropic spring: moment k times the rotation vector, force k d at node b."""
import json
import math
import sys


def answer(r):
    if "hello" in r:
        return {"name": "isotropic spring", "kinds": ["linear_angular"], "law": "isotropic", "frames": False}
    K, a, b = r["law"]["K"], r["a"], r["b"]
    if r["kind"] != "linear_angular" or r["law"]["type"] != "linear":
        return {"skipped": "linear_angular joints with a linear law alone"}
    if any(K[i][j] != (K[i // 3 * 3][i // 3 * 3] if i == j else 0) for i in range(6) for j in range(6)):
        return {"skipped": "one stiffness for translation and one for rotation alone"}
    if any(n.get("o", [0, 0, 0]) != [0, 0, 0] or n.get("h", [1, 0, 0, 0]) != [1, 0, 0, 0] for n in (a, b)):
        return {"skipped": "the joint is at the nodes, in their axes"}
    (s, x, y, z), (w, i, j, k) = a["q"], b["q"]
    c = w * s + i * x + j * y + k * z  # the rotation from a to b in global axes: q_b times the inverse of q_a
    v = [s * i - w * x - j * z + k * y, s * j - w * y - k * x + i * z, s * k - w * z - i * y + j * x]
    sine = math.hypot(*v)
    turn = 2 * math.atan2(sine, abs(c)) / math.copysign(sine, c) if sine > 0 else 0
    force = [K[0][0] * (x_b - x_a) for x_a, x_b in zip(a["x"], b["x"])]
    moment = [K[3][3] * turn * e for e in v]
    return {"loads": [-e for e in force + moment] + force + moment}


for line in sys.stdin:
    request = json.loads(line)
    print(json.dumps({"id": request["id"], **answer(request)}), flush=True)
