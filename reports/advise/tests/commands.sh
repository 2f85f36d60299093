#!/bin/sh
# The command as a new user tries it: answers, files of one's own, refusals, exit codes.
#   commands.sh HALFWAY_ADVISE
set -eu
program=$1
ask() { "$program" advise "$@"; }
reports=$(cd "$(dirname "$0")/../.." && pwd)
# shellcheck source=reports/tests/commands.sh
. "$(dirname "$0")/../../tests/commands.sh"
said() {  # WORDS ARGUMENT...
  words=$1
  shift
  "$program" advise "$@" >said 2>told || { cat told; fail "advise $*"; }
  grep -qF -- "$words" said || { cat said; fail "$* does not say '$words'"; }
}

# The first question: an anisotropic bushing, 30 degrees, within 1 %.
said 'use 5 % to 8.6 deg (rod4); or identify a cubic term' \
  c3_buckling --degrees 30 --tolerance 0.01
said 'Advice: invariant' c3_buckling --truth rod --degrees 47
grep -q 'beyond 49\.[0-9] deg none' said || { cat said; fail "the rod's margin"; }
[ "$(grep -vc '^wrote ' said)" -le 12 ] || fail "more than a summary"
for file in index.html advice.json map.csv; do
  [ -s "out/advise/c3_buckling/$file" ] || fail "no $file"
done
grep -q '<title>Halfway: advice for c3_buckling</title>' out/advise/c3_buckling/index.html || fail "the page has no title"
grep -q '^50,.*,invariant' out/advise/c3_buckling/map.csv || fail "the map of ratio 50 has no invariant"
refused_in_one_line 2 'cannot be a folder' c1_skewed_torque --out /proc/no/such/folder

# For programs: one document on stdout, nothing beside it.
said '"schema": "halfway-advice-1"' c1_skewed_torque --json
[ ! -s told ] || { cat told; fail "--json on stderr"; }
[ "$(head -c 1 said)" = '{' ] || fail "--json: not a document alone"

# A truth of one's own.
cat >mine.toml <<'TOML'
title = "A bushing of mine"
outputs = ["theta_x", "theta_y", "theta_z"]
[joint]
kind = "angular"
[joint.law]
type = "linear"
compliance = [1.59343e-3, 1.43837e-2, 4.00635e-4]
[[load]]
type = "fixed_moment"
value = [0.99995, 0, 0.01]
[path]
factor_end = 100
TOML
printf 'factor, theta_x, theta_y, theta_z\n0,0,0,0\n10,0.0159,1e-5,4e-5\n50,0.0797,2e-4,2e-4\n100,0.1593,8e-4,4e-4\n' >mine.csv
said 'mine.csv, 3 rows up to load factor 100' mine.toml --truth mine.csv
printf 'factor,theta_x\n10,oops\n' >bad.csv
refused_in_one_line 2 "bad.csv: line 2: 'oops' is not a finite number" mine.toml --truth bad.csv
printf 'factor,theta_x\n10,1\n5,1\n' >bad.csv
refused_in_one_line 2 'bad.csv: line 3: load factor 5: must ascend from 0' mine.toml --truth bad.csv
printf 'load,theta_x\n10,1\n' >bad.csv
refused_in_one_line 2 "bad.csv: line 1: no column 'factor'; found: load, theta_x" mine.toml --truth bad.csv
printf 'factor,phi\n10,1\n' >bad.csv
refused_in_one_line 2 'bad.csv: line 1: no column of an output; found: factor, phi; allowed: theta_x' mine.toml --truth bad.csv
printf 'factor,theta_x\n200,1\n' >bad.csv
refused_in_one_line 2 'load factor 200, lies beyond what is asked' mine.toml --truth bad.csv
: >bad.csv
refused_in_one_line 2 'bad.csv: no row with a load factor above 0' mine.toml --truth bad.csv
refused_in_one_line 2 '--truth none.csv: no such file' mine.toml --truth none.csv

# Laws that no kernel takes, and a shaft.
sed -e 's/^compliance.*/k1 = [10, 20, 30]\nk3 = [5, 5, 5]/' -e 's/"linear"/"polynomial"/' -e 's/^factor_end.*/factor_end = 0.1/' mine.toml >curved.toml
said 'Advice: fasse' curved.toml --moving
sed -e 's/^compliance.*/stiffness = [0, 30, 30]/' -e 's/^value.*/value = [0, 2, 1]/' -e 's/^factor_end.*/factor_end = 1/' mine.toml >shaft.toml
said 'the shaft turns freely' shaft.toml

# What is wrong with the question.
refused_in_one_line 2 "unknown scene 'c3_buckeling' (did you mean 'c3_buckling'?)" c3_buckeling
refused_in_one_line 2 'nowhere.toml: no such scene file' nowhere.toml
printf 'title = "x"\n[joint]\nkind = "angular"\n' >broken.toml
refused_in_one_line 2 'broken.toml' broken.toml
refused_in_one_line 2 'a scene of a mechanism; allowed: a scene of one joint' four_bar
refused_in_one_line 2 'a scene of a chain; allowed: a scene of one joint' roll_up
refused_in_one_line 2 '--tolerance 0: allowed: above 0 and below 1' c1_skewed_torque --tolerance 0
refused_in_one_line 2 '--tolerance' c1_skewed_torque --tolerance much
refused_in_one_line 2 '--tolerance nan: allowed' c1_skewed_torque --tolerance nan
refused_in_one_line 2 '--degrees 200: allowed: above 0 and below 180' c1_skewed_torque --degrees 200
refused_in_one_line 2 '--measure max: allowed: norm' c1_skewed_torque --measure max
refused_in_one_line 2 '--periods -1: allowed: 0 or more' c1_skewed_torque --periods -1
refused_in_one_line 2 '--truth oracle: allowed: auto, rod, chain:N, body' c1_skewed_torque --truth oracle
refused_in_one_line 2 '--truth chain:1: allowed: chain:N' c1_skewed_torque --truth chain:1
refused_in_one_line 2 '--truth body: scene c1_skewed_torque is of no body whose 3D analysis is kept' c1_skewed_torque --truth body
refused_in_one_line 2 '--truth rod: scene c6_compression_shear: no joint.length' c6_compression_shear --truth rod

# By its schema: one that is advised, none that suffices, without a truth; and spoilt ones are not.
for question in 'c3_buckling --truth rod --degrees 47' 'c3_buckling --degrees 30' 'c1_skewed_torque --truth none'; do
  # shellcheck disable=SC2086
  "$program" advise $question --json >"${question##* }.json" 2>told || { cat told; fail "$question --json"; }
done
/usr/bin/python3 "$reports/tests/documents.py" "$reports/advice.schema.json" 47.json 30.json none.json || fail "documents are not by their schema"
