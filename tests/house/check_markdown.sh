#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Usage: check_markdown.sh ROOT
# Checks that pages are wrapped as .prettierrc has it, and that no page of doc/ has more than 200
# lines. Installs nothing: without prettier (scripts/setup --test) only the lengths are checked,
# and the test is skipped (status 77) if they are in order.

set -euo pipefail
cd "${1:?Usage: check_markdown.sh ROOT}"
longest=200

# New files count before they are committed; without git, all files do.
mapfile -t pages < <({ git ls-files --cached --others --exclude-standard -- '*.md' 2>/dev/null ||
  find . -name '*.md' -not -path '*/node_modules/*' -not -path './build*' \
    -not -path './results/*'; } | while read -r page; do [ ! -f "$page" ] || echo "$page"; done)
if [ ${#pages[@]} = 0 ]; then
  echo "no page to check"
  exit 1
fi

status=0
for page in "${pages[@]}"; do
  lines=$(wc -l <"$page")
  case ${page#./} in
    doc/*) [ "$lines" -le $longest ] || {
      echo "$page: $lines lines, more than $longest: make two pages of it"
      status=1
    } ;;
  esac
done

found=0
unformatted=$(LAMELLA_NO_INSTALL=1 scripts/markdown/prettier --list-different "${pages[@]}") ||
  found=$?
if [ $found = 77 ]; then
  [ $status = 1 ] || exit 77
elif [ $found != 0 ]; then
  echo "Not formatted; run: scripts/format" $unformatted
  status=1
fi
[ $status = 1 ] || echo "${#pages[@]} pages are formatted."
exit $status
