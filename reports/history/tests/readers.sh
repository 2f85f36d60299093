#!/bin/sh
# What is exported, read by those whom it is for; what they cannot read is refused by them.
# Usage: readers.sh PROGRAM READER. Exit code 77: the reader is not installed here.
set -u
program=$1
reader=$2
here=$(cd "$(dirname "$0")" && pwd)
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "$reader: $1" >&2; exit 1; }
left_out() { echo "$reader: left out: no $1"; exit 77; }
python=/usr/bin/python3  # Debian's packages are its own
needs_module() { "$python" -c "import $1" 2> /dev/null || left_out "Python module $1 (Debian: $2)"; }

# kept FILE FACTOR: a run of two times and three other figures; times are FACTOR permille of their own.
kept() {
  awk -v factor="$2" 'BEGIN {
    print "{\"schema\":\"halfway-history\",\"version\":1,\"figures\":["\
      "[\"<e> & \\\"1\\\", x\",\"eps\",\"accuracy\",\"down\",\"f\"],[\"f/fails\",\"rad\",\"accuracy\",\"down\",\"f\"],"\
      "[\"f/none\",\"\",\"accuracy\",\"none\",\"\"],[\"ops\",\"flops\",\"count\",\"down\",\"\"],"\
      "[\"t/<1>\",\"ns per joint\",\"time\",\"down\",\"f\"],[\"t/2\",\"ns per joint\",\"time\",\"down\",\"f\"]]}"
    printf "{\"commit\":\"abc123\",\"dirty\":false,\"date\":\"2026-01-02T03:04:05Z\",\"title\":\"t\",\"release\":\"\",\"load\":null,\"libraries\":{},"
    printf "\"machine\":{\"cpu\":\"a \\\"p\\\"\",\"cores\":2,\"caches\":\"\",\"microcode\":\"\"},\"compiler\":\"g++\",\"flags\":\"-O3\",\"build_type\":\"Release\",\"isa\":\"\","
    printf "\"times\":["
    for (i = 4; i <= 5; ++i) {
      printf "%s[%d,%d,990,1010,9,[", (i == 4 ? "" : ","), i, 310 * factor
      for (k = 0; k < 9; ++k) printf "%s%d", (k ? "," : ""), 310 * factor + 100 * k - 400
      printf "]]"
    }
    print "],\"changes\":[[0,1e-15,\"at_most\",0.0,0.0,1e-12,\"pass\"],[1,0.5,\"equal\",0.0,0.0,0.1,\"fail\"],"\
      "[2,null,\"report\",0.0,0.0,0.0,\"left_out\"],[3,334.0,\"none\",0.0,0.0,0.0,\"none\"]]}"
  }' > "$folder/lines"
  "$program" history import "$folder/lines" --file "$1" > /dev/null || fail "the fixture cannot be imported"
}
export_as() { "$program" history export --file "$1" --format "$2" --out "$3" || fail "not exported"; }

# valid SCHEMA FILE, by Python's jsonschema.
valid() {
  "$python" -c 'import json, sys, jsonschema
jsonschema.Draft7Validator(json.loads(sys.argv[1])).validate(json.load(open(sys.argv[2])))' "$1" "$2" 2> /dev/null
}

# valid_by_ajv SCHEMA FILE: as Bencher's own console checks it. The packages are those of the page's checks.
ajv_modules=$here/../../page/package.json
valid_by_ajv() {
  node -e 'const Ajv = require("node:module").createRequire(process.argv[1])("ajv");
const valid = new Ajv({strict: true}).compile(JSON.parse(process.argv[2]));
process.exit(valid(JSON.parse(require("node:fs").readFileSync(process.argv[3], "utf8"))) ? 0 : 1)' "$ajv_modules" "$1" "$2" 2> "$folder/err"
}

# Bencher's, as its console has it, and the five fields of github-action-benchmark.
bmf_schema='{"type":"object","additionalProperties":{"type":"object","additionalProperties":{"type":"object","required":["value"],
  "properties":{"value":{"type":"number"},"lower_value":{"type":"number"},"upper_value":{"type":"number"}},"additionalProperties":false}}}'
github_schema='{"type":"array","minItems":1,"items":{"type":"object","required":["name","value","unit"],"additionalProperties":false,
  "properties":{"name":{"type":"string"},"value":{"type":"number"},"unit":{"type":"string"},"range":{"type":"string"},"extra":{"type":"string"}}}}'
spoilt_bmf() { sed 's/310.0/null/' "$1"; }
spoilt_github() { sed 's/"value": [0-9.e-]*/"value": null/' "$1"; }

kept "$folder/base.sqlite" 1000
out=$folder/out
case $reader in
  google) # compare.py of Google Benchmark: 9 repetitions a side, 10 % slower
    [ -e /usr/share/benchmark/compare.py ] || left_out "compare.py (Debian: libbenchmark-tools)"
    needs_module scipy python3-scipy
    kept "$folder/head.sqlite" 1100
    export_as "$folder/base.sqlite" google "$folder/base.json"
    export_as "$folder/head.sqlite" google "$folder/head.json"
    compare() { "$python" /usr/share/benchmark/compare.py -d "$folder/dump" benchmarks "$@" > "$out" 2>&1; }
    compare "$folder/base.json" "$folder/head.json" || fail "compare.py: $(tail -n 3 "$out")"
    "$python" - "$folder/dump" <<'PYTHON' || fail "compare.py did not read what was exported"
import json, sys
rows = [r for r in json.load(open(sys.argv[1])) if r['name'] != 'OVERALL_GEOMEAN']
assert [r['name'] for r in rows] == ['t/2', 't/<1>'], rows
for r in rows:
    assert len(r['measurements']) == 9 and r['time_unit'] == 'ns', r
    assert all(0.09 < m['time'] < 0.11 for m in r['measurements']), r
    assert 309 < r['measurements'][4]['real_time'] < 311, r
    assert r['utest']['time_pvalue'] < 0.001 and r['utest']['nr_of_repetitions'] == 9, r
PYTHON
    sed 's/real_time/wall_time/' "$folder/head.json" > "$folder/spoilt"
    compare "$folder/base.json" "$folder/spoilt" && fail "compare.py reads anything"
    ;;
  junit) # Jenkins' schema
    command -v xmllint > /dev/null || left_out "xmllint (Debian: libxml2-utils)"
    schema=$here/../../tests/xsd/junit-10.xsd
    export_as "$folder/base.sqlite" junit "$out"
    xmllint --noout --schema "$schema" "$out" 2> "$folder/err" || fail "$(cat "$folder/err")"
    # What GitLab shows: the text of a failure.
    [ "$(xmllint --xpath 'string(//testcase[@name="f/fails"]/failure)' "$out")" = '0.5 rad; 0 within 0.1' ] || fail "no text"
    [ "$(xmllint --xpath 'count(//testcase[@classname and @name])' "$out")" -eq 4 ] || fail "not every case"
    sed 's/ errors="0"//' "$out" > "$folder/spoilt"
    xmllint --noout --schema "$schema" "$folder/spoilt" 2> /dev/null && fail "the schema takes anything"
    ;;
  ctest) # a small dashboard run; its Test.xml by CDash's own schema
    command -v xmllint > /dev/null || left_out "xmllint (Debian: libxml2-utils)"
    printf 'BuildDirectory: %s\nSourceDirectory: %s\nSite: here\nBuildName: this\n' "$folder" "$folder" > "$folder/DartConfiguration.tcl"
    printf 'add_test(measured "%s" history export --file "%s" --format ctest --figure ^t/)\n' "$program" "$folder/base.sqlite" > "$folder/CTestTestfile.cmake"
    (cd "$folder" && ctest -M Experimental -T Start -T Test > "$out" 2>&1) || fail "$(tail -n 3 "$out")"
    xml=$(echo "$folder"/Testing/*-*/Test.xml)
    xmllint --noout --schema "$here/xsd/Test.xsd" "$xml" 2> "$folder/err" || fail "$(cat "$folder/err")"
    value=$(xmllint --xpath 'string(//NamedMeasurement[@type="numeric/double" and @name="t/<1>, ns"]/Value)' "$xml")
    [ "$value" = 310 ] || fail "the measurement of t/<1> is '$value', not 310"
    sed 's/<Value>/<Number>/; s/<.Value>/<\/Number>/' "$xml" > "$folder/spoilt"
    xmllint --noout --schema "$here/xsd/Test.xsd" "$folder/spoilt" 2> /dev/null && fail "the schema takes anything"
    ;;
  bmf)
    needs_module jsonschema python3-jsonschema
    export_as "$folder/base.sqlite" bmf "$out"
    valid "$bmf_schema" "$out" || fail "not valid"
    "$python" -c 'import json, sys
all = json.load(open(sys.argv[1]))
assert all["t/2"]["latency"] == {"value": 310, "lower_value": 306.9, "upper_value": 313.1}, all
assert abs(all["<e> & \"1\", x"]["digits"]["value"] - 15) < 1e-9 and all["ops"]["count"]["value"] == 334, all
assert "f/none" not in all' "$out" || fail "other values"
    spoilt_bmf "$out" > "$folder/spoilt"
    valid "$bmf_schema" "$folder/spoilt" && fail "the schema takes anything"
    ;;
  github)
    needs_module jsonschema python3-jsonschema
    export_as "$folder/base.sqlite" github "$out"
    valid "$github_schema" "$out" || fail "not valid"
    grep -q '"f/none"' "$out" && fail "a number that is none is there"
    spoilt_github "$out" > "$folder/spoilt"
    valid "$github_schema" "$folder/spoilt" && fail "the schema takes anything"
    ;;
  ajv) # both again, by ajv
    command -v node > /dev/null || left_out "node (Debian: nodejs)"
    [ -e "$here/../../page/node_modules/ajv/package.json" ] || left_out "ajv (npm ci in reports/page, as its check.sh does)"
    for form in bmf github; do
      schema=$bmf_schema
      [ "$form" = bmf ] || schema=$github_schema
      export_as "$folder/base.sqlite" "$form" "$out"
      valid_by_ajv "$schema" "$out" || fail "$form is not valid: $(tail -n 3 "$folder/err")"
      "spoilt_$form" "$out" > "$folder/spoilt"
      valid_by_ajv "$schema" "$folder/spoilt" && fail "the schema of $form takes anything"
      [ -s "$folder/err" ] && fail "ajv: $(head -n 3 "$folder/err")"
    done
    ;;
  openmetrics) # Prometheus' parser
    needs_module prometheus_client python3-prometheus-client
    parse() {
      "$python" -c 'import sys
from prometheus_client.openmetrics.parser import text_string_to_metric_families as families
all = {(s.name, s.labels["figure"]): s.value for f in families(open(sys.argv[1]).read()) for s in f.samples}
assert all[("halfway_time_seconds", "t/<1>")] == 3.1e-07, all
assert all[("halfway_value", "<e> & \"1\", x")] == 1e-15 and len(all) == 7, all' "$1" 2> "$folder/err"
    }
    export_as "$folder/base.sqlite" openmetrics "$out"
    parse "$out" || fail "$(tail -n 2 "$folder/err")"
    grep -v EOF "$out" > "$folder/spoilt"
    parse "$folder/spoilt" && fail "the parser takes anything"
    ;;
  csv)
    [ -x "$python" ] || left_out "python3"
    read_csv() {
      "$python" -c 'import csv, sys
rows = {r["figure"]: r for r in csv.DictReader(open(sys.argv[1], newline=""), strict=True)}
assert len(rows) == 6 and all(None not in r and None not in r.values() for r in rows.values()), rows
assert rows["<e> & \"1\", x"]["value"] == "1e-15" and rows["t/2"]["low"] == "306.9", rows
assert rows["f/none"]["value"] == "", rows' "$1" 2> "$folder/err"
    }
    export_as "$folder/base.sqlite" csv "$out"
    read_csv "$out" || fail "$(tail -n 1 "$folder/err")"
    sed 's/""/"/' "$out" > "$folder/spoilt"
    read_csv "$folder/spoilt" && fail "the reader takes anything"
    ;;
  *) fail "no such reader" ;;
esac
echo "$reader: read, and a spoilt one refused"
