#!/usr/bin/env python3
"""A joint behind `halfway check`, an isotropic spring: moment k times the rotation vector, force k d at node b."""
import sys

sys.dont_write_bytecode = True  # no folder of it beside the sources
from protocol import isotropic, rotation_vector, serve

HELLO = {"name": "isotropic spring", "kinds": ["linear_angular"], "law": "isotropic", "ends": False}


def loads(question):
    k_force, k_moment = isotropic(question)
    a, b = question["a"], question["b"]
    force = [k_force * (x_b - x_a) for x_a, x_b in zip(a["x"], b["x"])]
    moment = [k_moment * turn for turn in rotation_vector(a["q"], b["q"])]
    return [-e for e in force + moment] + force + moment


serve(HELLO, loads)
