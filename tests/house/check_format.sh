#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Usage: check_format.sh ROOT
# Checks the C++ code against .clang-format. Other versions of clang-format
# format differently: without version 14 the test is skipped (status 77).

set -euo pipefail
cd "${1:?Usage: check_format.sh ROOT}"

for formatter in clang-format-14 clang-format; do
  if "$formatter" --version 2>/dev/null | grep -q 'version 14\.'; then
    break
  fi
  formatter=
done
if [ -z "$formatter" ]; then
  echo "clang-format 14 is not here: skipped"
  exit 77
fi

# New files count before they are committed; without git, all files do.
list_files()
{
  git ls-files --cached --others --exclude-standard -- "$@" 2>/dev/null ||
    find "$@" -type f 2>/dev/null || true
}
mapfile -t files < <(list_files include source components tests tutorials |
  grep -E '\.(h|cc)$' | while read -r file; do [ ! -f "$file" ] || echo "$file"; done)
if [ ${#files[@]} = 0 ]; then
  echo "no code to check"
  exit 1
fi

wrong=()
for file in "${files[@]}"; do
  "$formatter" --dry-run -Werror "$file" 2>/dev/null || wrong+=("$file")
done
if [ ${#wrong[@]} -gt 0 ]; then
  echo "Not formatted; run: $formatter -i ${wrong[*]}"
  exit 1
fi
echo "${#files[@]} files are formatted."
