# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# fenced LANGUAGE: the block of that language in "A whole program" of README.md.
fenced()
{
    sed -n '/^## A whole program/,/^## Test it/p' "$SRC/README.md" |
        sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`/d;p}"
}
