# SPDX-License-Identifier: MIT
#
# The library in single precision, coinf.h: included by the Makefile.  Its
# sources are made from those of lib/ by float.awk; where lib/float has one of
# the same name, from that.
FLOAT_SOURCES := batch carry check energy integrals lanes legendre params \
                 pose rates reaction rk4 run selftest sincos state symplectic
FLOAT_HEADERS := carry change frame lanes legendre method motion number \
                 outcome params pinned precision reaction rk4 run sincos \
                 sine stage state stepper width
FLOAT_C       := $(FLOAT_SOURCES:%=$(O)/float/coinf_%.c)
FLOAT_H       := $(FLOAT_HEADERS:%=$(O)/float/coinf_%.h)
STATIC        += $(FLOAT_SOURCES:%=$(O)/static/coinf_%.o)
SHARED        += $(FLOAT_SOURCES:%=$(O)/shared/coinf_%.o)

.PHONY: float
float: $(FLOAT_C) $(FLOAT_H) ## build/float, the sources in single precision

FLOAT_AWK = LC_ALL=C awk -f $(SRC)/lib/float/float.awk $< >$@

$(O)/float/coinf_%: $(SRC)/lib/float/% $(SRC)/lib/float/float.awk | $(O)/float
	$(FLOAT_AWK)

$(O)/float/coinf_%: $(SRC)/lib/% $(SRC)/lib/float/float.awk | $(O)/float
	$(FLOAT_AWK)

FLOAT_MAP = $(if $(MAPS),-ffile-prefix-map=$(abspath $(O)/float)=float)
CC_FLOAT  = cd $(SRC) && $(CC_LIB) $(FLOAT_MAP)

$(O)/static/coinf_%.o: $(O)/float/coinf_%.c $(FLOAT_H) $(O)/flags | $(O)/static
	echo "CC  $(@F)"
	$(CC_FLOAT) $(DEPENDS) -c -o $(abspath $@) $(abspath $<)

$(O)/shared/coinf_%.o: $(O)/float/coinf_%.c $(FLOAT_H) $(O)/flags | $(O)/shared
	echo "CC  $(@F) (shared)"
	$(CC_FLOAT) -fPIC $(DEPENDS) -c -o $(abspath $@) $(abspath $<)

$(O)/float:
	mkdir -p $@
