# SPDX-License-Identifier: MIT
#
# rollcoin: build, install and check.  Needs a C compiler, binutils and GNU
# make, no configuration.  `make help` lists the targets.
#
#   make                            the libraries, in build/
#   make demo                       a coin is tossed
#   make O=dir                      the products elsewhere
#   make -f ../rollcoin/Makefile    the same from another folder
#   make install PREFIX=/usr DESTDIR=/tmp/stage
#   make check TESTS=tests/test_run.c
#   make V=1                        show the commands

# ------------------------------------------------------------- where things are
SRC := $(patsubst %/,%,$(dir $(abspath $(lastword $(MAKEFILE_LIST)))))
O   := build

PREFIX       ?= /usr/local
EXEC_PREFIX  ?= $(PREFIX)
BINDIR       ?= $(EXEC_PREFIX)/bin
LIBDIR       ?= $(EXEC_PREFIX)/lib
INCLUDEDIR   ?= $(PREFIX)/include
PKGCONFIGDIR ?= $(LIBDIR)/pkgconfig
CMAKEDIR     ?= $(LIBDIR)/cmake/rollcoin
MANDIR       ?= $(PREFIX)/share/man
DOCDIR       ?= $(PREFIX)/share/doc/rollcoin
DESTDIR      ?=

# make reads a blank in a name as two names.
FOLDERS := CURDIR O DESTDIR PREFIX EXEC_PREFIX BINDIR LIBDIR INCLUDEDIR \
           PKGCONFIGDIR CMAKEDIR MANDIR DOCDIR
$(foreach f,$(FOLDERS),$(if $(word 2,x$($f)x),\
    $(error make cannot work with a blank in $f: '$($f)')))
$(if $(wildcard $(SRC)/include/coin.h),,\
    $(error make cannot work with a blank in the name of the sources' folder))

# What Python and Rust leave among the sources is packed and installed nowhere.
SOURCES_ONLY := -type f ! -path '*/__pycache__/*' ! -path '*/rust/target/*' \
                ! -name Cargo.lock ! -name _native.so

INSTALL      ?= install
LDCONFIG     ?= ldconfig
PKG_CONFIG   ?= pkg-config
CLANG_FORMAT ?= clang-format
PYTHON       ?= python3

# ---------------------------------------------------------------------- version
# The version has one home, coin.h.  Before 1.0 the soname carries the minor
# version.  From 1.0 on it has a number of its own, raised by a break of the ABI
# and by nothing else.
ABI_NUMBER := 1
VERSION    := $(shell sed -n 's/^\#define COIN_VERSION_[MP][A-Z]* //p' \
                      $(SRC)/include/coin.h | paste -sd. -)
SOVERSION  := $(strip $(if $(filter 0.%,$(VERSION)),$(basename $(VERSION)),\
                $(ABI_NUMBER)))
# The newest date of CHANGELOG.md's sections: that of the manual page and of the
# files in the tarball.
DATE        = $(shell sed -n '/^\#\# .*\([0-9]\{4\}-..-..\).*/{s//\1/p;q;}' \
                $(SRC)/CHANGELOG.md)

# ------------------------------------------------------------------------ flags
# The user's flags come first and ours last, so that no -ffp-contract=fast or
# -fvisibility can undo what the pinned bits and the ABI rest on.
# -fno-tree-vectorize: gcc's vectorizer fuses a * b - c, d * e + f in one
# instruction where the processor can (12.2 with -mfma), whatever -ffp-contract
# says.  -fno-math-errno: sqrt is then the processor's instruction alone, with
# the same bits.  TRAPS: clang may compute what a branch then drops, which raises
# its exceptions, unless told that they may trap; for some targets it cannot be.
# The map keeps this folder's name out of the debug information: equal sources
# give equal bytes wherever they are built.
CFLAGS ?= -O2 -g
WARN   := -Wall -Wextra -Wpedantic -Wshadow -Wconversion \
          -Wstrict-prototypes -Wmissing-prototypes -Wundef -Wcast-qual \
          -Wwrite-strings
MAPS   := -ffile-prefix-map=$(SRC)=.
TRAPS  := $(shell set -- -ffp-exception-behavior=maytrap && \
            $(CC) $(CFLAGS) -Werror=unsupported-floating-point-opt $$1 \
            -fsyntax-only -x c /dev/null 2>/dev/null && echo $$1)
PINNED := $(strip -ffp-contract=off -fno-tree-vectorize -fno-math-errno \
            $(TRAPS))
HIDDEN := -fvisibility=hidden

CC_USER  = $(CC) $(WARN) $(CPPFLAGS) $(CFLAGS)
CC_LIB   = $(CC_USER) $(API) -std=c99 $(PINNED) $(MAPS) $(HIDDEN) \
           -I$(SRC)/include
CC_TEST  = $(CC_USER) -std=c11 $(PINNED) $(MAPS) -I$(SRC)/include \
           $(addprefix -I,$(sort $(dir $(SOURCES)))) \
           -I$(SRC)/tests/support $(TEST_SEES)
DEPENDS  = -MMD -MP -MT $@ -MF $(abspath $@).d

# What tests read, and how they compile and link what users would.
TEST_SEES = -DTEST_ROOT='"$(SRC)"' -DTEST_DATA='"$(SRC)/tests/reference"' \
            -DTEST_CC='"$(CC) $(CFLAGS)"' -DTEST_LIB='"$(abspath $(LIB_A))"'

# Recipes are silent; V=1 shows them.
ifndef V
.SILENT:
endif

.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SUFFIXES:
.SECONDARY:
.PHONY: force

# ----------------------------------------------------------------------- target
# What the linker is told, and what the library is called, by the system that
# the compiler makes programs for: Linux and the like, Windows, macOS.  On
# Windows programs are linked to an import library.  -Bsymbolic-functions: the
# library calls its own functions directly, as it does on the other systems
# without being told.
TARGET := $(shell $(CC) -dumpmachine)
ifneq (,$(findstring mingw,$(TARGET)))
REAL_SO   = librollcoin-$(SOVERSION).dll
SO_LINKS  =
IMPORT    = librollcoin.dll.a
TO_SHARED = -shared -Wl,--out-implib,$(O)/$(IMPORT)
API       = -DCOIN_BUILD
RUNDIR    = $(BINDIR)
else ifneq (,$(findstring darwin,$(TARGET)))
REAL_SO   = librollcoin.$(VERSION).dylib
SO_LINKS  = librollcoin.$(SOVERSION).dylib librollcoin.dylib
TO_SHARED = -dynamiclib -install_name $(LIBDIR)/librollcoin.$(SOVERSION).dylib
AR_AS     = rcs
else
REAL_SO   = librollcoin.so.$(VERSION)
SO_LINKS  = librollcoin.so.$(SOVERSION) librollcoin.so
TO_SHARED = -shared -Wl,-soname,librollcoin.so.$(SOVERSION) -Wl,-z,defs \
            -Wl,--version-script=$(EXPORTS) -Wl,--build-id=sha1 \
            -Wl,-Bsymbolic-functions
endif
RUNDIR   ?= $(LIBDIR)
AR_AS    ?= rcsD

# -------------------------------------------------------------------- libraries
SOURCES := $(wildcard $(SRC)/lib/*/*.c)
OBJECTS := $(patsubst %.c,$(O)/objects/%.o,$(notdir $(SOURCES)))
EXPORTS := $(SRC)/lib/about/rollcoin.map
LIB_A   := $(O)/librollcoin.a
LIB_SO  := $(addprefix $(O)/,$(or $(lastword $(SO_LINKS)),$(REAL_SO)))

# Objects lie in one folder: no two sources have one name.
vpath %.c $(sort $(dir $(SOURCES)))

.PHONY: all
all: $(LIB_A) $(LIB_SO) ## the static and the shared library

# One set of objects for both, so that a plugin can take the static one in.
$(O)/objects/%.o: %.c $(O)/flags | $(O)/objects
	cd $(SRC) && $(CC_LIB) -fPIC $(DEPENDS) -c -o $(abspath $@) $<

# Removed first: ar would keep the object of a source that is gone.
$(LIB_A): $(OBJECTS)
	rm -f $@
	$(AR) $(AR_AS) $@ $(OBJECTS)
	echo $@

$(O)/$(REAL_SO): $(OBJECTS) $(EXPORTS) $(SRC)/Makefile
	$(CC_LIB) $(LDFLAGS) -o $@ $(OBJECTS) $(TO_SHARED) -lm
	echo $@

# The name to link to comes with the name to load.
$(LIB_SO): $(addprefix $(O)/,$(firstword $(SO_LINKS)))
$(addprefix $(O)/,$(SO_LINKS)): $(O)/$(REAL_SO)
	ln -sf $(REAL_SO) $@

# All of it as one header, for a project or firmware that takes files in.
SINGLE       := $(O)/single/coin.h

.PHONY: single
single: $(SINGLE) ## build/single/coin.h, the library as one header

$(SINGLE): $(SRC)/LICENSE $(wildcard $(SRC)/lib/about/single.*) \
           $(wildcard $(SRC)/include/*.h $(SRC)/lib/*/*.[ch]) | $(O)/single
	cd $(SRC) && export LC_ALL=C && awk -f lib/about/single.awk \
	    LICENSE include/*.h lib/*/*.c >$(abspath $@)
	echo '#include "coin.h" /* which holds coinf.h */' >$(O)/single/coinf.h
	sed 's/@VERSION@/$(VERSION)/' $(SRC)/lib/about/single.md >$(O)/single/README.md

# Everything compiled depends on this file, which changes when the flags do.
$(O)/flags: force | $(O)
	echo '$(subst ','\'',$(CC_LIB) $(LDFLAGS))' >$@.$$PPID
	$(if_new)

# A source that has moved is still named by what the last build left.
$(SRC)/%.c: ;

# Keeps a file that is made anew in every run, if it has not changed.  The name
# of the new one has make's number: several makes may run at once.
if_new = cmp -s $@.$$PPID $@ && rm $@.$$PPID || mv $@.$$PPID $@

$(O) $(O)/objects $(O)/single $(O)/tests/support:
	mkdir -p $@

-include $(wildcard $(O)/*.d $(O)/*/*.d $(O)/*/*/*.d)

# ---------------------------------------------------------------------- install
# The targets install and uninstall, and what they install beside the libraries.
include $(SRC)/pkgconfig/install.mk

# ------------------------------------------------------------ examples and demo
EXAMPLES := $(patsubst $(SRC)/docs/examples/%.c,$(O)/%,\
                       $(wildcard $(SRC)/docs/examples/*.c))

.PHONY: demo live demo-check examples
# DEMO chooses another scene, as DEMO='--scene quarter'.
DEMO ?= --scene toss
demo: $(O)/rolling_quarter ## toss a US quarter: a table, and drawings in build/
	$(O)/rolling_quarter --out $(O) $(DEMO)

live: $(O)/rolling_quarter ## watch a US quarter tossed, in the terminal
	$(O)/rolling_quarter --live $(DEMO)

demo-check: $(O)/rolling_quarter ## what the demo prints, draws and refuses
	PYTHON=$(PYTHON) sh $(SRC)/tests/demo/run.sh $(O)/rolling_quarter

examples: $(EXAMPLES) ## every program of docs/examples

$(EXAMPLES): $(O)/%: $(SRC)/docs/examples/%.c $(LIB_A) $(O)/flags
	$(CC_USER) -std=c99 $(MAPS) -I$(SRC)/include $(DEPENDS) -o $@ $< \
	    $(LDFLAGS) $(LIB_A) -lm
$(O)/many_tosses: LDFLAGS += -fopenmp

# ------------------------------------------------------------------------ tests
# All tests are one program, linked to tests/support and to the static library,
# whose internals they may call.  It runs the tests of the file that its first
# argument names.  A name in TESTS that matches no file stays as it is: make then
# has no rule for it.
TESTS      ?= tests/test_*.c
TEST_FILES := $(foreach t,$(TESTS),$(or $(wildcard $(SRC)/$t),$t))
TEST_NAMES := $(TEST_FILES:$(SRC)/%.c=$(O)/%)
TEST_PROG  := $(O)/tests/run
TEST_EXTRA := $(O)/tests/support.a
CMOCKA      = $$($(PKG_CONFIG) --cflags cmocka)
CMOCKA_LIBS = $$($(PKG_CONFIG) --libs cmocka)

# What runs a test: nothing, or valgrind.
TEST_RUNNER ?=

# The tests of a file write to another, .log or .failed, so that several run at
# once: as many as make -j says, or as there are processors.
TEST_LOGS = $(TEST_NAMES:=.log)
$(TEST_LOGS): %.log: $(TEST_PROG) force
	if $(TEST_RUNNER) $< $(*F) >$@ 2>&1; then test ! -e $*.failed || rm $*.failed; \
	else mv $@ $*.failed; fi

.PHONY: check checked build-tests need-cmocka
check: ## run the tests, or those that TESTS names
	echo "$(words $(TEST_NAMES)) test files are built and run"
	+$(AGAIN) checked $(if $(filter -j%,$(MAKEFLAGS)),, \
	    -j$$(getconf _NPROCESSORS_ONLN))

checked: $(TEST_LOGS)
	sh $(SRC)/tests/report.sh $(TEST_NAMES)

build-tests: $(TEST_PROG)

# A test is compiled more often than it runs.  A user's CFLAGS stay as they are.
$(O)/tests/%.o: private CFLAGS := $(CFLAGS:-O2=-O0)

$(O)/tests/%.o: $(SRC)/tests/%.c $(O)/flags | $(O)/tests/support need-cmocka
	$(CC_TEST) $(CMOCKA) $(DEPENDS) -c -o $@ $<

$(TEST_EXTRA): $(patsubst $(SRC)/%.c,$(O)/%.o,\
                          $(wildcard $(SRC)/tests/support/*.c))
	rm -f $@
	$(AR) $(AR_AS) $@ $^

# The library that the tests are linked to: one file, or nothing here.
TESTED = $(LIB_A)
$(TEST_PROG): $(TEST_NAMES:=.o) $(TEST_EXTRA) $(TESTED) $(O)/tests/names
	$(CC_TEST) $(LDFLAGS) -o $@ $(filter-out %/names,$^) $(CMOCKA_LIBS) -lm

# The program depends on this file, which changes when TESTS does.
$(O)/tests/names: force | $(O)/tests/support
	echo $(TEST_NAMES) >$@.$$PPID
	$(if_new)

need-cmocka:
	$(PKG_CONFIG) --exists cmocka || { echo "the tests need cmocka:" \
	    "sudo apt-get install pkg-config libcmocka-dev"; exit 1; } >&2

# ------------------------------------------------------- gates of their own kind
# bench.mk and the like: each is told by the variables above.
include $(wildcard $(SRC)/tests/*/*.mk $(SRC)/tests/studies/*/*.mk)

# ----------------------------------------------------------- tarball, packaging
# In a git tree a release holds the tracked files, in an unpacked release those
# of the same folders.  distcheck proves the two ways equal.
TARBALL := $(O)/rollcoin-$(VERSION).tar.xz
SINGLES := $(O)/rollcoin-single-$(VERSION).tar.xz
PACKED   = --no-recursion --format=ustar --mtime='$(DATE) 00:00Z' --owner=0 \
           --group=0 --numeric-owner --mode=u=rwX,go=rX
# Of this make alone: several may pack at once.
PACKING  = $(abspath $(O))/packing.$$PPID

.PHONY: dist need-dist distcheck installcheck consumers hwcaps debian-check \
        versions windows release packages
dist: need-dist $(SINGLE) | $(O) ## rollcoin-VERSION.tar.xz, and the single header's
	mkdir -p $(PACKING)
	cd $(SRC) && if test -e .git; then git ls-files; else find .ci \
	    .clang-format .gitignore CHANGELOG.md LICENSE Makefile README.md docs \
	    include lib pkgconfig tests $(SOURCES_ONLY); fi >$(PACKING)/files
	LC_ALL=C sort -o $(PACKING)/files $(PACKING)/files
	tar -C $(SRC) -cf $(TARBALL:$(O)/%.xz=$(PACKING)/%) $(PACKED) \
	    -T $(PACKING)/files --transform='flags=r;s,^,rollcoin-$(VERSION)/,'
	tar -C $(O)/single -cf $(SINGLES:$(O)/%.xz=$(PACKING)/%) $(PACKED) \
	    README.md coin.h coinf.h \
	    --transform='flags=r;s,^,rollcoin-single-$(VERSION)/,'
	xz -T1 $(PACKING)/*.tar
	mv $(PACKING)/*.xz $(O)
	rm -r $(PACKING)
	wc -c $(TARBALL) $(SINGLES)
	test $$(wc -c <$(TARBALL)) -le 3000000 || echo 'warning: more than 3 MB'

need-dist:
	for tool in xz $(if $(wildcard $(SRC)/.git),git); do command -v $$tool \
	    >/dev/null || { echo "make dist needs xz, and in a clone git: sudo" \
	    "apt-get install xz-utils git" >&2; exit 1; }; done

# What gates are told: this Makefile, and where to work.
GATE  = MAKE='$(MAKE)' CC='$(CC)' PKG_CONFIG='$(PKG_CONFIG)' SRC='$(SRC)' \
        VERSION='$(VERSION)' SOVERSION='$(SOVERSION)' OUT='$(abspath $(O))'
AGAIN = $(MAKE) --no-print-directory -f $(SRC)/Makefile

installcheck: all ## install, build a client by pkg-config, uninstall
	+$(GATE) CXX='$(CXX)' sh $(SRC)/tests/install/install.sh
	+$(GATE) sh $(SRC)/tests/install/plain.sh

consumers: all dist ## CMake and Meson find it, and build the same bits
	+$(GATE) TARBALL=$(abspath $(TARBALL)) sh $(SRC)/tests/install/consumers.sh

hwcaps: all lanes ## lanes; HWCAPS=1: each level of x86-64 is loaded, with the same bits
	+$(GATE) sh $(SRC)/tests/install/hwcaps.sh

debian-check: dist ## Debian packages from docs/examples/debian, their test, lintian
	+$(GATE) TARBALL=$(abspath $(TARBALL)) sh $(SRC)/tests/install/debian.sh

packages: all js $(SINGLE) $(O)/toss ## the packages of each language: a stranger installs them, and tosses
	+$(GATE) CXX='$(CXX)' CARGO='$(CARGO)' PYTHON=$(DEBIAN_PYTHON) \
	    sh $(SRC)/tests/install/packages.sh

versions: dist ## 1.0.0 and 2.3.4, made of a copy: names, packages, bindings, site
	+$(GATE) CXX='$(CXX)' CARGO='$(CARGO)' PYTHON=$(DEBIAN_PYTHON) \
	    BINDGEN='$(BINDGEN)' TARBALL=$(abspath $(TARBALL)) sh $(SRC)/tests/install/versions.sh

release: ## VERSION=X.Y.Z: the sources become that release, but for commit and tag
	$(if $(filter command,$(firstword $(origin VERSION))),,\
	    $(error make release VERSION=X.Y.Z))
	+$(GATE) PYTHON=$(DEBIAN_PYTHON) BINDGEN='$(BINDGEN)' \
	    sh $(SRC)/tests/install/release.sh

windows: ## the DLL and the tests, by mingw-w64 and wine
	+$(GATE) sh $(SRC)/tests/install/windows.sh

distcheck: dist all ## the tarball builds, passes and makes itself again
	+$(GATE) TARBALL=$(abspath $(TARBALL)) sh $(SRC)/tests/install/dist.sh

# ------------------------------------------------------------------------ gates
# A gate whose tool is missing fails.  Four tiers, the quick gates first; each
# tier begins with those before it.  .ci/run runs the first three; the last has
# what measures, and what proves that other gates would notice.
GATES_commit  := check format-check lint-quick
GATES_push    := header-check examples demo-check first-hour site float-check \
                 installcheck consumers hwcaps abi pictures-check \
                 page-check js-check bindings studies-build check-long \
                 distcheck lint sanitize coverage
GATES_merge   := adversary-replay bound debian-check packages versions tsan fuzz \
                 windows msan repro single-check cross firmware
GATES_release := results-check proofs abi-seeds bindings-seeds sweeps \
                 endurance valgrind adversary mutants
# check-long has all of check, and lint all of lint-quick.
GATES_CI       = $(filter-out check lint-quick,$(GATES_commit) $(GATES_push) \
                   $(GATES_merge))
# Made before gates run side by side, each of which then writes files of its own.
GATES_SHARE   := all $(EXAMPLES) build-tests studies-build dist
EACH  = for gate in $1; do echo "=== $$gate"; $(AGAIN) $$gate || exit 1; done

.PHONY: before-commit before-push before-merge before-release list-gates shared
before-commit: ## the gates of a commit: under a minute
	+$(call EACH,$(GATES_commit))

before-push: before-commit ## those and the gates of a push: some minutes
	+$(call EACH,$(GATES_push))

before-merge: before-push ## every gate of CI: 20 minutes on two cores
	+$(call EACH,$(GATES_merge))

before-release: before-merge ## those, long searches, all mutants: two hours
	+$(call EACH,$(GATES_release))

list-gates: # their names, for .ci/run
	echo $(GATES_CI)

shared: $(GATES_SHARE) # what gates share, for .ci/run

.PHONY: check-long sanitize valgrind coverage lint lint-quick header-check \
        repro repro-update
check-long: ## the tests with eight times the random cases, and a million steps
	+ROLLCOIN_TRIES=8 ROLLCOIN_LONG=1 $(AGAIN) check
	+export ROLLCOIN_SEED=$${ROLLCOIN_SEED:-$$($(SEED))} && \
	    echo "the random cases are those of ROLLCOIN_SEED=$$ROLLCOIN_SEED" && \
	    $(AGAIN) check

# Every commit tries other random cases; a tarball, those of its version.
SEED = { git -C $(SRC) rev-parse HEAD 2>/dev/null || echo $(VERSION); } | \
       cksum | cut -d' ' -f1

SANITIZE := -O1 -g -Werror -fsanitize=address,undefined,float-cast-overflow \
            -fno-sanitize-recover=all
sanitize: ## the tests, under the sanitizers; gcc warns of nothing
	+$(AGAIN) O=$(O)/sanitize check CFLAGS='$(SANITIZE)'

valgrind: ## the tests under valgrind
	+$(AGAIN) check \
	    TEST_RUNNER='valgrind -q --error-exitcode=9 --leak-check=full'

# Unoptimised and unmapped: gcov then sees each branch as it is written, and
# finds the sources.  Only what ran inside the library's own objects counts.
COVERED = gcovr -j 2 --root $(SRC) --filter '$(SRC)/lib/' $(O)/coverage/objects
# A copy of a function for each of its callers would have branches of its own
# that no argument of that caller takes: here nothing is always_inline.
COVER   = -O0 --coverage -fprofile-abs-path -Dalways_inline=unused
coverage: ## lines and branches of lib/ that run; the missing are listed
	rm -rf $(O)/coverage
	+ROLLCOIN_LONG=1 $(AGAIN) O=$(O)/coverage check MAPS= \
	    CFLAGS='$(COVER)'
	$(COVERED) --branches --fail-under-line 100 --fail-under-branch 100 || \
	    { $(COVERED); exit 1; }

lint: all ## style, layers, citations, symbols, static analysis
	+$(GATE) WARN='$(WARN)' sh $(SRC)/tests/lint/lint.sh

lint-quick: all ## lint without the static analysis
	+$(GATE) sh $(SRC)/tests/lint/lint.sh quick

header-check: ## coin.h in every dialect of C and C++
	sh $(SRC)/tests/lint/header.sh $(SRC)/include

repro: all ## one hash of many motions, and equal bytes, from every compiler
	+$(GATE) sh $(SRC)/tests/repro/hash.sh
	+$(GATE) sh $(SRC)/tests/repro/fused.sh
	+$(GATE) sh $(SRC)/tests/repro/rebuild.sh

repro-update: ## accept the hashes of this library as the pinned ones
	+$(GATE) sh $(SRC)/tests/repro/hash.sh update

# -------------------------------------------------------------- format, helpers
C_FILES = $(foreach d,include lib/* tests tests/* tests/studies/* docs/examples \
            docs/examples/* docs/page,\
            $(wildcard $(SRC)/$d/*.[ch]))

.PHONY: format format-check clean help
format: ## lay out the C sources (clang-format 14)
	$(CLANG_FORMAT) -i $(C_FILES)

format-check: ## the C sources are laid out so
	$(CLANG_FORMAT) --version | grep -q 'version 14' || \
	    { echo 'format-check needs clang-format 14' >&2; exit 1; }
	$(CLANG_FORMAT) --dry-run -Werror $(C_FILES)

clean: ## remove the products
	rm -rf $(O)

help: ## this list
	list() { for target; do sed -n "s/^$$target:.*## \(.*\)/  $$target\t\1/p" \
	    $(HELP_FROM); done | expand -t 18; }; \
	list $(FIRST); \
	$(foreach tier,commit push merge release,echo; list before-$(tier) | \
	    sed 's/^ /make/'; list $(GATES_$(tier));) \
	echo; echo 'Products, measurements and updates'; \
	list $(filter-out $(FIRST) before-% lint-quick $(GATES_CI) $(GATES_release),\
	    $(HELP_TARGETS))
FIRST        = all demo check install
HELP_FROM    = $(filter-out %.d,$(MAKEFILE_LIST))
HELP_TARGETS = $(shell sed -n 's/^\([a-z-]*\):.*\#\# .*/\1/p' $(HELP_FROM))
