#!/bin/sh
# The published schema of scene files is what the reader asks for: generated again, and held against files by another
# program's reader (python3-jsonschema; left out by name where it is missing).
# Usage: schema.sh PROGRAM SCENES
set -u
program=$1
scenes=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "schema: $1" >&2; exit 1; }

"$program" list --schema > "$folder/schema.json" 2> "$folder/unseen" || fail "halfway list --schema exits with $?"
[ ! -s "$folder/unseen" ] || fail "keys that no scene has, so that nothing is known of them: $(cat "$folder/unseen")"
# A formulation more is a name more, and nothing else.
"$program" list --types | cut -d' ' -f1 > "$folder/formulations"
diff "$scenes/scene.schema.json" "$folder/schema.json" | sed -n 's/^[<>] *"\{0,1\}\([^",]*\)"\{0,1\},\{0,1\}$/\1/p' |
  grep -vxFf "$folder/formulations" &&
  fail "the reader asks for something else: ./halfway list --schema > reference/scenes/scene.schema.json"

python=/usr/bin/python3
"$python" -c 'import jsonschema, tomllib' 2> /dev/null || { echo "left out: no python3-jsonschema"; exit 0; }
"$python" - "$folder/schema.json" "$scenes" "$program" "$folder" <<'PYTHON'
import copy, json, pathlib, subprocess, sys, tomllib
import jsonschema

schema = json.loads(pathlib.Path(sys.argv[1]).read_text())
scenes, program, folder = pathlib.Path(sys.argv[2]), sys.argv[3], pathlib.Path(sys.argv[4])
validator = jsonschema.Draft7Validator(schema)
validator.check_schema(schema)
files = {file: tomllib.loads(file.read_text()) for file in sorted(scenes.rglob("*.toml"))}
assert len(files) > 25, f"{len(files)} scenes"

for file, scene in files.items():
    wrong = [f"{list(e.absolute_path)}: {e.message}" for e in validator.iter_errors(scene)]
    assert not wrong, f"{file}: {wrong}"


def tables(value, path=()):
    """Each table of a scene with its path, but for those whose keys are the scene's own names."""
    if isinstance(value, dict) and "values" not in path:
        yield path, value
        for key, item in value.items():
            yield from tables(item, path + (key,))
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from tables(item, path + (i,))


# Whatever table has an unknown key is refused, what has another type, and what loses a key that all like it need.
refused = 0
for file, scene in files.items():
    for path, table in tables(scene):
        changed = copy.deepcopy(scene)
        at = changed
        for step in path:
            at = at[step]
        at["unheard_of"] = 1
        assert not validator.is_valid(changed), f"{file}: {path} may have any key"
        refused += 1
for key, value in {"title": 3, "xis": "0.5", "outputs": "theta_x", "formulations": ["inv"], "path": []}.items():
    for file, scene in files.items():
        assert not validator.is_valid(scene | {key: value}), f"{file}: {key} = {value} passes"
        refused += 1
for path in (("title",), ("joint", "kind"), ("joint", "law"), ("joint", "law", "type"), ("path", "factor_end"), ("chain", "links"), ("chain", "EA")):
    lost = 0
    for file, scene in files.items():
        changed = copy.deepcopy(scene)
        at = changed
        for step in path[:-1]:
            at = at.get(step, {}) if isinstance(at, dict) else {}
        if not isinstance(at, dict) or path[-1] not in at or (path[0] == "path" and ("steps" in at or "chain" in scene)):
            continue
        del at[path[-1]]
        needed = not validator.is_valid(changed)
        lost += needed
    # A path of a mechanism may count steps instead, so that none is needed everywhere.
    assert lost or path == ("path", "factor_end"), f"{path} is needed nowhere"
    refused += lost
print(f"{len(files)} scenes pass, {refused} mistakes are refused")
PYTHON
