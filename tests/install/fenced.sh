# SPDX-License-Identifier: MIT
# shellcheck shell=sh
# fenced LANGUAGE: the block of that language in "Ten lines" of README.md.
fenced()
{
    sed -n '/^## Ten lines/,/^## Test it/p' "$SRC/README.md" |
        sed -n "/^\`\`\`$1\$/,/^\`\`\`\$/{/^\`/d;p}"
}
