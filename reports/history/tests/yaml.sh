#!/bin/sh
# The workflow and README's snippet are YAML, with the jobs and steps that are meant; a spoilt one is refused.
# Usage: yaml.sh TOP. Exit code 77: no YAML reader here.
set -u
top=$1
python=/usr/bin/python3 # Debian's packages are its own
"$python" -c 'import yaml' 2> /dev/null || { echo "yaml: left out: no Python module yaml (Debian: python3-yaml)"; exit 77; }
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "yaml: $1" >&2; exit 1; }
# Each step of each job runs something, and nothing it runs is empty.
read_yaml() {
  "$python" -c 'import sys, yaml
root = yaml.safe_load(open(sys.argv[1]))
jobs = root.get("jobs", {"steps": root})
steps = [step for job in jobs.values() for step in job["steps"]]
assert steps and all(bool(step.get("run")) != bool(step.get("uses")) for step in steps), steps
assert all("runs-on" in job for job in root.get("jobs", {}).values())' "$1" 2> "$folder/err"
}
sed -n '/^```yaml$/,/^```$/{/^```/!p}' "$top/README.md" > "$folder/readme.yml"
cp "$top/.github/workflows/halfway.yml" "$folder/workflow.yml"
for name in readme workflow; do
  read_yaml "$folder/$name.yml" || fail "$name: $(tail -n 1 "$folder/err")"
  sed 's/^\( *\)- run: \(.*\)/\1- run: {\2/' "$folder/$name.yml" > "$folder/spoilt"
  read_yaml "$folder/spoilt" && fail "$name: the reader takes anything"
  sed 's/- run: .*/- run:/' "$folder/$name.yml" > "$folder/spoilt"
  read_yaml "$folder/spoilt" && fail "$name: a step that runs nothing is taken"
done
exit 0
