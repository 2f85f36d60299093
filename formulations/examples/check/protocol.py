"""What adapters of `halfway check` share: JSON lines in, one answer a line out. An adapter brings `loads`."""
import json
import math
import sys


class Skipped(Exception):
    """Why the program cannot answer a question, which is a good one."""


def serve(hello, loads):
    """Answers until the input ends. hello: what the program says of itself (README.md); loads: from a question to
    f_a, m_a, f_b, m_b, or Skipped."""
    for line in sys.stdin:
        question = json.loads(line)
        try:
            answer = hello if "hello" in question else {"loads": loads(question)}
        except Skipped as reason:
            answer = {"skipped": str(reason)}
        print(json.dumps({"id": question["id"], **answer}), flush=True)


def isotropic(question):
    """The stiffnesses of translation and of rotation of a joint at its bodies that has no others."""
    K, bodies = question["law"]["K"], (question["a"], question["b"])
    if question["kind"] != "linear_angular" or question["law"]["type"] != "linear":
        raise Skipped("linear_angular joints with a linear law alone")
    if any(K[i][j] != (K[i // 3 * 3][i // 3 * 3] if i == j else 0) for i in range(6) for j in range(6)):
        raise Skipped("one stiffness for translation and one for rotation alone")
    if any(n.get("o", [0, 0, 0]) != [0, 0, 0] or n.get("h", [1, 0, 0, 0]) != [1, 0, 0, 0] for n in bodies):
        raise Skipped("the joint is at the nodes, in their axes")
    return K[0][0], K[3][3]


def rotation_vector(p, q):
    """From the axes of quaternion p to those of q, global axes: of q times the inverse of p, on the shorter way."""
    (s, x, y, z), (w, i, j, k) = p, q
    c = w * s + i * x + j * y + k * z
    v = [s * i - w * x - j * z + k * y, s * j - w * y - k * x + i * z, s * k - w * z - i * y + j * x]
    sine = math.hypot(*v)
    turn = 2 * math.atan2(sine, abs(c)) / math.copysign(sine, c) if sine > 0 else 0
    return [turn * e for e in v]
