#!/bin/sh
# SPDX-License-Identifier: MIT
# Projects of CMake's and Meson's: those that find the library where make has
# installed it, wherever that was moved to, and those that build it from source,
# with the bits of make's build.
#     consumers.sh [installed]    the first kind only
# From `make consumers`: MAKE CC SRC OUT VERSION SOVERSION TARBALL.
set -eu
work=$OUT/consumers
client=$SRC/tests/install/client.c
rm -rf "$work"
mkdir -p "$work"
export CC

die() { echo "consumers: $*" >&2; exit 1; }
quiet() { "$@" >"$work/log" 2>&1 || { cat "$work/log"; return 1; }; }

unset DESTDIR PKG_CONFIG_PATH PKG_CONFIG_LIBDIR PKG_CONFIG_SYSROOT_DIR MAKEFLAGS
for tool in cmake meson ninja; do
    command -v $tool >/dev/null || die "needs $tool"
done
make="$MAKE --no-print-directory -f $SRC/Makefile O=$OUT FILLED=$work"
make="$make LDCONFIG=:"
$make PREFIX="$work/first" install
mv "$work/first" "$work/moved"

# configure NAME PROJECT [OPTION...]: a project of these lines.
configure()
{
    mkdir -p "$work/$1"
    {
        echo "cmake_minimum_required(VERSION 3.14)"
        echo "project($1 LANGUAGES C)"
        echo "$2"
    } >"$work/$1/CMakeLists.txt"
    name=$1
    shift 2
    quiet cmake -S "$work/$name" -B "$work/$name/build" "$@"
}

find_package() # NAME VERSION
{
    configure "$1" "
        set(prefix mine)
        find_package(rollcoin $2 REQUIRED)
        if(NOT prefix STREQUAL mine)
          message(FATAL_ERROR prefix)
        endif()
        foreach(way rollcoin static)
          add_executable(\${way} $client)
          target_link_libraries(\${way} rollcoin::\${way} m)
        endforeach()" "-DCMAKE_PREFIX_PATH=$work/moved"
}
series=${VERSION%.*}
for version in "" "$series" "$VERSION" "$VERSION EXACT"; do
    find_package found "$version" || die "find_package(rollcoin $version)"
done
quiet cmake --build "$work/found/build"
for way in rollcoin static; do
    "$work/found/build/$way" "$VERSION" || die "the client fails: $way"
done
readelf -d "$work/found/build/rollcoin" |
    grep -q "NEEDED.*librollcoin.so.$SOVERSION\]" || die "not the shared one"
for version in "$series.99" "${series%.*}.$((${series#*.} + 1))" 99; do
    ! find_package "other$version" "$version" >/dev/null ||
        die "find_package(rollcoin $version) finds $VERSION"
done
echo "consumers: CMake finds what was installed and moved, and only its version"

export PKG_CONFIG_PATH="$work/moved/lib/pkgconfig"
mkdir "$work/meson"
cat >"$work/meson/meson.build" <<END
project('client', 'c')
executable('client', 'client.c',
  dependencies: [dependency('rollcoin', version: '>=$VERSION'),
                 meson.get_compiler('c').find_library('m')])
END
cp "$client" "$work/meson"
sed -i "s,^prefix=.*,prefix=$work/moved," "$PKG_CONFIG_PATH/rollcoin.pc"
quiet meson setup "$work/meson/build" "$work/meson" &&
    quiet ninja -C "$work/meson/build" || die "Meson does not build the client"
LD_LIBRARY_PATH=$work/moved/lib "$work/meson/build/client" "$VERSION" ||
    die "the client fails, built by Meson"
echo "consumers: Meson finds it"

mv "$work/moved" "$work/first"
$make PREFIX="$work/first" uninstall
test -z "$(find "$work/first" ! -type d)" || die "uninstall leaves files"
! find_package gone "" >/dev/null 2>&1 || die "CMake still finds it"
test "${1-}" != installed || exit 0

# From source, as a static and as a shared library.  hash.c prints what many
# motions end in.
for shared in OFF ON; do
    configure "source$shared" "
        include(FetchContent)
        FetchContent_Declare(rollcoin
          SOURCE_DIR $SRC SOURCE_SUBDIR pkgconfig/cmake)
        FetchContent_MakeAvailable(rollcoin)
        add_executable(client $client)
        add_executable(hash $SRC/tests/repro/hash.c)
        foreach(program client hash)
          target_link_libraries(\${program} rollcoin::rollcoin m)
        endforeach()" "-DBUILD_SHARED_LIBS=$shared" "-DCMAKE_BUILD_TYPE=Release"
    quiet cmake --build "$work/source$shared/build" -j2
    build=$work/source$shared/build
    "$build/client" "$VERSION" || die "the client fails, from source"
    "$build/hash" | diff "$SRC/tests/repro/expected.txt" - ||
        die "CMake's build has other bits"
done
cat >"$work/names.sh" <<'END'
nm -D --with-symbol-versions --defined-only "$1" | sed 's/^[^ ]* //' | sort
END
so=$(find "$work/sourceON" -name "librollcoin.so.$VERSION")
sh "$work/names.sh" "$so" >"$work/cmake.txt"
sh "$work/names.sh" "$OUT/librollcoin.so" | diff - "$work/cmake.txt" ||
    die "CMake's shared library has other symbols"
echo "consumers: CMake builds the same bits and symbols as make"

# Meson's from a release, to which the wrap adds meson.build.
subprojects=$work/wrap/subprojects
mkdir -p "$subprojects/packagefiles/rollcoin"
cp "$SRC/pkgconfig/meson/meson.build" "$subprojects/packagefiles/rollcoin"
cp "$TARBALL" "$subprojects/packagefiles"
cp "$client" "$SRC/tests/repro/hash.c" "$SRC"/tests/repro/*.h "$work/wrap"
cat >"$subprojects/rollcoin.wrap" <<END
[wrap-file]
directory = rollcoin-$VERSION
source_filename = $(basename "$TARBALL")
source_hash = $(sha256sum "$TARBALL" | cut -d' ' -f1)
patch_directory = rollcoin
[provide]
dependency_names = rollcoin
END
cat >"$work/wrap/meson.build" <<END
project('wrap', 'c', default_options: ['buildtype=release'])
foreach program : ['client', 'hash']
  executable(program, program + '.c',
    dependencies: [dependency('rollcoin', version: '$VERSION'),
                   meson.get_compiler('c').find_library('m')])
endforeach
END
unset PKG_CONFIG_PATH
build=$work/wrap/build
PKG_CONFIG_LIBDIR=/nowhere quiet meson setup "$build" "$work/wrap" &&
    quiet ninja -C "$build" || die "Meson does not build the subproject"
"$build/client" "$VERSION" || die "the client fails, with Meson's subproject"
"$build/hash" | diff "$SRC/tests/repro/expected.txt" - ||
    die "Meson's build has other bits"
echo "consumers: Meson builds the same bits, as a subproject"
