# SPDX-License-Identifier: MIT
#
# What `make install` puts where: included by the Makefile, which names the
# folders.
#
#   make install URL=https://...    a home page, for rollcoin.pc
#   make install HWCAPS=1           also for newer x86-64 processors, below
#   make install LDCONFIG=:         without telling the dynamic linker
#   make install FILLED=dir         makes the files that name the prefix there:
#                                   two installs at once need two folders

URL    ?=
FILLED ?= $(O)

# ------------------------------------------------------------------- files made
# Folders below the prefix are written relative to it, so that the whole can be
# moved: by pkg-config's --define-prefix, and for CMake by nothing else.  ROOT is
# the variable that holds it there; CMake's must be no variable of the caller's.
below = $(patsubst $(PREFIX),$2,$(patsubst $(PREFIX)/%,$2/%,$1))
ROOT  := prefix
none  :=
blank := $(none) $(none)

# From CMAKEDIR up to the prefix, or the prefix itself if it lies elsewhere.
inside = $(subst /, ,$(patsubst $(PREFIX)/%,%,$(filter $(PREFIX)/%,$(CMAKEDIR))))
UP     = $(subst $(blank),,$(foreach part,$(inside),/..))
CMAKE_PREFIX = $(if $(inside),$${CMAKE_CURRENT_LIST_DIR}$(UP),$(PREFIX))

FILL = sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' \
           -e 's|@URL@|$(URL)|' -e '/^URL: $$/d' \
           -e 's|@EXEC_PREFIX@|$(call below,$(EXEC_PREFIX),$${$(ROOT)})|' \
           -e 's|@LIBDIR@|$(call below,$(LIBDIR),$${$(ROOT)})|' \
           -e 's|@INCLUDEDIR@|$(call below,$(INCLUDEDIR),$${$(ROOT)})|' \
           -e 's|@RUNDIR@|$(call below,$(RUNDIR),$${$(ROOT)})|' \
           -e 's|@CMAKE_PREFIX@|$(CMAKE_PREFIX)|' \
           -e 's|@SOVERSION@|$(SOVERSION)|' \
           -e 's|@SHARED@|$(REAL_SO)|' -e 's|@IMPORT@|$(IMPORT)|'

CMAKE_FILES := rollcoin-config.cmake rollcoin-config-version.cmake
GENERATED   := $(addprefix $(FILLED)/,rollcoin.pc rollcoin.3 $(CMAKE_FILES))
all: $(GENERATED)

$(FILLED)/rollcoin.pc: $(SRC)/pkgconfig/rollcoin.pc.in force
	mkdir -p $(@D)
	$(FILL) $< >$@.$$PPID
	$(if_new)

$(CMAKE_FILES:%=$(FILLED)/%): ROOT := rollcoin_prefix
$(CMAKE_FILES:%=$(FILLED)/%): $(FILLED)/%: $(SRC)/pkgconfig/cmake/%.in force
	mkdir -p $(@D)
	$(FILL) $< >$@.$$PPID
	$(if_new)

# A manual page from the groups of coin.h.
$(FILLED)/rollcoin.3: $(SRC)/lib/about/man.awk $(SRC)/include/coin.h force
	mkdir -p $(@D)
	LC_ALL=C awk -v version=$(VERSION) -v date=$(DATE) -v docs=$(DOCDIR) \
	    -f $(filter-out force,$^) >$@.$$PPID
	$(if_new)

# ------------------------------------------------------ newer x86-64 processors
# With HWCAPS=1 the shared library once more for each level, from which the
# dynamic linker of glibc takes the best that the processor has.  The flags that
# pin the bits come after -march.
LEVELS := $(if $(HWCAPS),x86-64-v3 x86-64-v4)
$(if $(HWCAPS),$(if $(findstring linux,$(filter x86_64-%,$(TARGET))),,\
    $(error HWCAPS is for Linux on x86-64, not for $(TARGET))))

$(LEVELS:%=$(O)/hwcaps/%/$(REAL_SO)): $(O)/hwcaps/%/$(REAL_SO): force
	+$(AGAIN) O=$(O)/hwcaps/$* CFLAGS='$(CFLAGS) -march=$*' HWCAPS= $@

# ------------------------------------------------------------ places, and files
# install puts the files of a place there, uninstall removes just these.  One
# folder may be several places.
PLACES := $(INCLUDEDIR) $(LIBDIR) $(RUNDIR) $(PKGCONFIGDIR) $(CMAKEDIR) \
          $(MANDIR)/man3 $(LEVELS:%=$(LIBDIR)/glibc-hwcaps/%)

in.$(INCLUDEDIR)   += $(addprefix $(SRC)/,include/coin.h include/coinf.h \
                        docs/examples/cpp/rollcoin.hpp)
in.$(PKGCONFIGDIR) += $(FILLED)/rollcoin.pc
in.$(CMAKEDIR)     += $(addprefix $(FILLED)/,$(CMAKE_FILES))
in.$(MANDIR)/man3  += $(FILLED)/rollcoin.3
in.$(LIBDIR)       += $(LIB_A) $(addprefix $(O)/,$(IMPORT))
in.$(RUNDIR)       += $(O)/$(REAL_SO)
$(foreach level,$(LEVELS),$(eval \
    in.$(LIBDIR)/glibc-hwcaps/$(level) = $(O)/hwcaps/$(level)/$(REAL_SO)))

# The pages, and what they link to, each in a folder of the name that it has here.
DOCUMENTS := $(shell cd $(SRC) && find README.md CHANGELOG.md LICENSE docs/*.md \
               tests/studies/*.md docs/figures docs/examples \
               docs/page/index.html docs/page/preview.jpg include/coin.h \
               $(SOURCES_ONLY))
PLACES    += $(addprefix $(DOCDIR)/,$(dir $(DOCUMENTS)))
$(foreach file,$(DOCUMENTS),$(eval \
    in.$(DOCDIR)/$(dir $(file)) += $(SRC)/$(file)))

# Folders, each with a shared library and its links.
WITH_LINKS = $(addprefix $(DESTDIR),$(RUNDIR) \
             $(LEVELS:%=$(LIBDIR)/glibc-hwcaps/%))

# Lines of a recipe, one for each place.
define put
$(INSTALL) -d $(DESTDIR)$1
$(INSTALL) -m 644 $(in.$1) $(DESTDIR)$1

endef
define take
rm -f $(addprefix $(DESTDIR)$1/,$(notdir $(in.$1)))

endef

# The system's dynamic linker knows what is new after ldconfig; below DESTDIR
# there is no system, and who is not root cannot tell it.
TELL_LINKER = test -n '$(DESTDIR)' || test "$$(id -u)" != 0 || \
              ! command -v $(LDCONFIG) >/dev/null || $(LDCONFIG)

.PHONY: install uninstall
install: $(LEVELS:%=$(O)/hwcaps/%/$(REAL_SO))
install: $(LIB_A) $(LIB_SO) $(GENERATED) ## to PREFIX, below DESTDIR if that is set
	$(foreach place,$(sort $(PLACES)),$(call put,$(place)))
	for folder in $(WITH_LINKS); do for link in $(SO_LINKS); do \
	    ln -sf $(REAL_SO) $$folder/$$link; done; done
	$(TELL_LINKER)

uninstall: ## remove what install put there
	$(foreach place,$(sort $(PLACES)),$(call take,$(place)))
	for folder in $(WITH_LINKS); do for link in $(SO_LINKS); do \
	    rm -f $$folder/$$link; done; done
	-rmdir $(addprefix $(DESTDIR),$(CMAKEDIR) \
	    $(LEVELS:%=$(LIBDIR)/glibc-hwcaps/%)) 2>/dev/null
	-find $(DESTDIR)$(DOCDIR) -depth -type d -exec rmdir {} \; 2>/dev/null
	$(TELL_LINKER)
