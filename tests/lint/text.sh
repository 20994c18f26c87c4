#!/bin/sh
# SPDX-License-Identifier: MIT
# Each source carries its licence, and no file a path of somebody's machine.
# From `make lint`: SRC.
set -eu
cd "$SRC"
status=0

sources=$(find Makefile include lib tests docs .ci \
    \( -name Makefile -o -name '*.[ch]' -o -name '*.map' -o -name '*.py' \
    -o -name '*.sh' -o -name '*.awk' -o -name '*.mk' -o -path .ci/run \) -type f)
for file in $sources; do
    head -3 "$file" | grep -q 'SPDX-License-Identifier: MIT' ||
        { echo "$file: no SPDX line"; status=1; }
done

# The brackets keep this pattern from finding itself.
if grep -rnE '/[h]ome/|/[r]oot/|/[U]sers/|/[w]ork/|/tmp/[r]c' --exclude-dir=build \
    --exclude-dir=.git .; then
    echo "paths of a machine"
    status=1
fi
if grep -rnIP '\t| +$' --include='*.[ch]' --include='*.py' include lib tests docs
then
    echo "tabs, or blanks at the end of a line"
    status=1
fi
exit $status
