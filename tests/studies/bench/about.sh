#!/bin/sh
# SPDX-License-Identifier: MIT
# The head of a CSV of results: on what, by what and how they came about.
#     CC=... CXX=... about.sh 'build: flags'...
set -eu

# The value of a macro of a header, without quotes.
macro()
{
    printf '#include <%s>\n%s\n' "$1" "$2" |
        $CXX -x c++ -E -P - 2>/dev/null | tail -n 1 | tr -d '"'
}

echo "# CPU:$(sed -n 's/^model name[^:]*://p' /proc/cpuinfo | head -n 1)," \
    "$(uname -sm), one thread"
echo "# compiler: $($CC --version | head -n 1)"
for build in "$@"; do
    echo "# $build"
done
echo "# peers: GSL $(macro gsl/gsl_version.h GSL_VERSION)," \
    "Boost $(macro boost/version.hpp BOOST_LIB_VERSION)," \
    "SUNDIALS $(macro sundials/sundials_config.h SUNDIALS_VERSION)," \
    "MuJoCo $(macro mujoco/mujoco.h mjVERSION_HEADER)," \
    "ODE $(macro ode/version.h dODE_VERSION)," \
    "Bullet $(macro bullet/LinearMath/btScalar.h BT_BULLET_VERSION)"
