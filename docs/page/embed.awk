# SPDX-License-Identifier: MIT
# Puts files where a page names them: a line that is @NAME@ becomes the contents
# of the files that the variable NAME of the environment lists, a script without
# its blank lines and comments.
#     style=style.css script='a.js b.js' awk -f embed.awk page.html

/^@[a-z]+@$/ {
    name = substr($0, 2, length($0) - 2)
    count = split(ENVIRON[name], file, " ")
    if (count == 0) {
        print "embed.awk: no files for " $0 >"/dev/stderr"
        exit 1
    }
    for (k = 1; k <= count; ++k) {
        while ((got = (getline line <file[k])) > 0)
            if (name != "script" || line !~ /^[ \t]*(\/\/.*)?$/)
                print line
        if (got < 0) {
            print "embed.awk: cannot read " file[k] >"/dev/stderr"
            exit 1
        }
        close(file[k])
    }
    next
}

{ print }
