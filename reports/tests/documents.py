#!/usr/bin/env python3
"""Documents that a command writes are by their published schema, and spoilt ones are not.

documents.py SCHEMA FILE.json...: python3-jsonschema's reader takes each file, and none of it with a key that nobody
has heard of, with a value of another type, or, at least once for each of its required keys, without that key. Exit
code 0, or 1 and what is wrong; "left out" and 0 where python3-jsonschema is missing.
"""
import copy
import json
import pathlib
import sys

try:
    import jsonschema
except ModuleNotFoundError:
    print("left out: no python3-jsonschema")
    sys.exit(0)

schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
validator = jsonschema.Draft7Validator(schema)
validator.check_schema(schema)
files = sys.argv[2:]
assert files, "no document"


def places(value, path=()):
    """Every value in a document with its path."""
    yield path, value
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, item in items:
        yield from places(item, path + (key,))


def at(document, path):
    for step in path:
        document = document[step]
    return document


def spoilt(document, path, change):
    """A copy that `change` was made to, at the path."""
    out = copy.deepcopy(document)
    change(at(out, path))
    return out


def needed_somewhere(part):
    """All names below `required` of a schema, but those of one or the other and of conditions."""
    if isinstance(part, list):
        return set().union(*map(needed_somewhere, part))
    if not isinstance(part, dict):
        return set()
    own = set(part.get("required", ())) if "properties" in part else set()
    return own.union(*(needed_somewhere(item) for key, item in part.items() if key not in ("if", "then")))


refused, lost = 0, set()
for file in files:
    document = json.loads(pathlib.Path(file).read_text())
    wrong = [f"{list(e.absolute_path)}: {e.message[:200]}" for e in validator.iter_errors(document)]
    assert not wrong, f"{file}: {wrong}"
    for path, value in places(document):
        changes = []
        if isinstance(value, dict):
            changes.append(lambda table: table.update(unheard_of=1))
            for key in value:
                without = spoilt(document, path, lambda table: table.pop(key))
                if not validator.is_valid(without):
                    lost.add(key)
                    refused += 1
                other = [] if isinstance(value[key], dict) else {}
                changes.append(lambda table, key=key, other=other: table.update({key: other}))
        for change in changes:
            assert not validator.is_valid(spoilt(document, path, change)), f"{file}: {path} may be changed"
            refused += 1
missed = needed_somewhere(schema) - lost
assert not missed, f"required, and without it nothing is refused: {sorted(missed)}"
print(f"{len(files)} documents pass, {refused} mistakes are refused")
