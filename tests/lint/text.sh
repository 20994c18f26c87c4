#!/bin/sh
# SPDX-License-Identifier: MIT
# Each source that git has carries its licence, and no file a path of somebody's
# machine; tests/README.md has a line for each folder.  What other gates leave
# for a moment is not looked at.
# From `make lint`: SRC OUT.
set -eu
cd "$SRC"
status=0

sources=$(git ls-files 'Makefile' '*/Makefile' '*.[ch]' '*.map' '*.py' '*.sh' \
    '*.awk' '*.mk' .ci/run)
for file in $sources; do
    head -3 "$file" | grep -q 'SPDX-License-Identifier: MIT' ||
        { echo "$file: no SPDX line"; status=1; }
done

# The brackets keep this pattern from finding itself.
if git grep -nE '/[h]ome/|/[r]oot/|/[U]sers/|/[w]ork/|/tmp/[r]c'; then
    echo "paths of a machine"
    status=1
fi
if git grep -nP '\t| +$' -- '*.[ch]' '*.py'; then
    echo "tabs, or blanks at the end of a line"
    status=1
fi
ls -d tests/*/ | sed 's,tests/,,' | grep -v __pycache__ >"$OUT/folders"
sed -n 's/^| `\([a-z]*\/\)` .*/\1/p' tests/README.md | diff - "$OUT/folders" ||
    { echo "tests/README.md: other folders"; status=1; }
exit $status
