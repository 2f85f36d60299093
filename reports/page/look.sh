#!/bin/sh
# Looks at a report page in headless Chromium: four screenshots (wide and narrow, light and dark), and a proof
# that every chart was drawn without a JavaScript error. The page draws what comes into view; "#all" asks for
# everything, and the account is read only after that.
#
#   look.sh REPORT_FOLDER [PICTURE_FOLDER]     (default: REPORT_FOLDER/look)
#
# Ends with 1 when the page reports an error, misses a chart or never gets ready.
set -u

say() { printf '%s\n' "look: $*"; }
fail() { printf '%s\n' "look: $*" >&2; exit 1; }

[ $# -ge 1 ] && [ $# -le 2 ] || fail "usage: look.sh REPORT_FOLDER [PICTURE_FOLDER]"
folder=$(cd "$1" 2>/dev/null && pwd) || fail "$1: no such folder"
page="$folder/index.html"
[ -f "$page" ] || fail "$page: no such file; run the report first"
pictures=${2:-"$folder/look"}
mkdir -p "$pictures" || fail "$pictures: cannot be made"

browser=""
for name in ${CHROMIUM:-} chromium chromium-browser google-chrome; do
  if command -v "$name" >/dev/null 2>&1; then browser=$name; break; fi
done
[ -n "$browser" ] || fail "no Chromium found (Debian: apt-get install chromium); CHROMIUM names another one"

work=$(mktemp -d) || fail "no temporary folder"
trap 'rm -rf "$work"' EXIT

# One page load; extra arguments say what to take from it.
browse() {
  "$browser" --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --hide-scrollbars \
    --disable-background-networking --disable-component-update --disable-sync \
    --user-data-dir="$work/profile" --virtual-time-budget=20000 "$@" 2>>"$work/browser.log"
}

# The value of a data attribute of the page's root element.
attribute() { sed -n "s/^.*<html[^>]* data-$1=\"\([^\"]*\)\".*$/\1/p" "$work/dom.html" | head -n 1; }

for width in 1600 400; do
  for theme in light dark; do
    address="file://$page?theme=$theme#all"
    browse --window-size="$width,1200" --dump-dom "$address" >"$work/dom.html" || fail "$browser failed: $(tail -n 3 "$work/browser.log")"
    state=$(attribute state)
    [ "$(attribute everything)" = drawn ] || [ "$state" = error ] || state=unfinished
    case $state in
      ready) ;;
      incomplete) fail "$width px, $theme: parts or charts without data: $(attribute charts-empty)" ;;
      error) fail "$width px, $theme: the page reports: $(attribute errors)" ;;
      *) fail "$width px, $theme: the page never got ready (state: ${state:-none}; drawn: $(attribute charts-drawn); promised: $(attribute charts-promised))" ;;
    esac
    height=$(attribute height)
    [ "${height:-0}" -gt 0 ] || fail "$width px, $theme: the page has no height"
    # Chromium draws no picture taller than this.
    [ "$height" -le 16000 ] || height=16000
    picture="$pictures/page-$width-$theme.png"
    browse --window-size="$width,$height" --screenshot="$picture" "$address" >/dev/null || fail "$browser failed: $(tail -n 3 "$work/browser.log")"
    [ -s "$picture" ] || fail "$picture: not written"
    say "$picture: $(attribute charts-drawn | wc -w) parts and charts drawn"
  done
done
