# SPDX-License-Identifier: MIT
#
# Speed against accuracy: included by the Makefile, whose SRC, O, CC, CFLAGS,
# WARN, MAPS, PINNED and PYTHON it uses.
#
#   make bench      measure, and print what came out    (ten minutes)
#   make charts     the same and the atlas, then renew tests/studies/bench/results, the
#                   pictures and the tables of docs/accuracy.md, docs/limits.md
#                   (twelve minutes)
#   make results    all that results-check looks at          (an hour)
#   make figures    pictures and tables from tests/studies/bench/results as they are
#   make atlas      the maps of docs/limits.md, not timed   (three minutes)
#   make natural    the calls of a frame loop                (one minute)
#   make batch      many coins at once                       (one minute)
#   make slides     coins that slip, beside other methods    (two minutes)
#   make orbits     an orbit beside steps, part of charts    (two minutes)
#   make longrun    ten million steps of everything          (half an hour)
#
# Library, textbook and peers are built twice, alike: portable and native.  A
# busy machine shows: wait for a quiet one, and run nothing beside.

BENCH_SRC := $(SRC)/tests/studies/bench
RESULTS   := $(BENCH_SRC)/results
BENCH_OUT  = $(O)/bench
BUILDS    := portable native
FLAGS_portable := -O2
FLAGS_native   := -O3 -march=native
# A third build, of peers alone: native, with products and sums fused.
FUSED          := gsl odeint
FLAGS_fused    := $(FLAGS_native) -ffp-contract=fast

BENCHES := $(patsubst $(BENCH_SRC)/%.c,%,$(wildcard $(BENCH_SRC)/bench_*.c))
SHARED_BY_BENCHES := scene workprec atlas counted movers textbook plain \
                     sliding
PEERS        := gsl odeint cvode ode mujoco
LIBS_gsl     := -lgsl -lgslcblas
LIBS_cvode   := -lsundials_cvode -lsundials_nvecserial \
                -lsundials_sunnonlinsolfixedpoint
LIBS_ode     := -lode -lstdc++
LIBS_mujoco  := -lmujoco
LIBS_orbit   := $(LIBS_gsl)
LIBS_slide   := -lsundials_cvode -lsundials_nvecserial \
                -lsundials_sunlinsoldense -lsundials_sunmatrixdense

BENCH_SEES = -I$(SRC)/include -I$(BENCH_SRC) $(MAPS) \
             $(addprefix -I,$(sort $(dir $(SOURCES)))) \
             -D_POSIX_C_SOURCE=200809L \
             -DBENCH_DATA='"$(SRC)/tests/reference"'
BENCH_CC   = $(CC) $(WARN) $(CPPFLAGS) $(CFLAGS) -std=c11 $(PINNED) \
             $(BENCH_SEES)
# What the library pins is its own affair: others get the build's plain flags,
# without contraction.
PLAIN     := -ffp-contract=off
# Headers of others are not ours to warn about.
PEER_CC    = $(CC) -w $(CFLAGS) -std=c11 $(PLAIN) $(BENCH_SEES)
PEER_CXX   = $(CXX) -w $(CFLAGS) -std=c++17 $(PLAIN) $(BENCH_SEES)

# One build of everything, in $(O)/bench/$1.
define bench_build
$(BENCH_OUT)/$1 $(BENCH_OUT)/$1/lib:
	mkdir -p $$@

$(BENCH_OUT)/$1/lib/%.o: %.c $(O)/flags | $(BENCH_OUT)/$1/lib
	$$(BENCH_CC) $(FLAGS_$1) $$(DEPENDS) -c -o $$@ $$<

$(BENCH_OUT)/$1/%.o: $(BENCH_SRC)/%.c $(O)/flags | $(BENCH_OUT)/$1
	$$(BENCH_CC) $(FLAGS_$1) $$(DEPENDS) -c -o $$@ $$<

$(BENCH_OUT)/$1/textbook.o $(BENCH_OUT)/$1/plain.o \
$(BENCH_OUT)/$1/sliding.o: $(BENCH_OUT)/$1/%.o: $(BENCH_SRC)/%.c \
    | $(BENCH_OUT)/$1
	$$(PEER_CC) $(FLAGS_$1) -c -o $$@ $$<

NEEDED_$1 := $$(SHARED_BY_BENCHES:%=$(BENCH_OUT)/$1/%.o) \
             $$(patsubst %.c,$(BENCH_OUT)/$1/lib/%.o,$(notdir $(SOURCES)))

$$(BENCHES:%=$(BENCH_OUT)/$1/%): $(BENCH_OUT)/$1/%: $(BENCH_OUT)/$1/%.o \
    $$(NEEDED_$1)
	$$(BENCH_CC) $(FLAGS_$1) $$(LDFLAGS) -o $$@ $$^ -lm

$(BENCH_OUT)/$1/peer_%: $(BENCH_SRC)/peers/%.c $$(NEEDED_$1) | need-peers
	$$(PEER_CC) $(FLAGS_$1) -o $$@ $$^ $$(LIBS_$$*) -lm

$(BENCH_OUT)/$1/peer_%: $(BENCH_SRC)/peers/%.cpp $$(NEEDED_$1) | need-peers
	$$(PEER_CXX) $(FLAGS_$1) -o $$@ $$^ -lm
endef
$(foreach b,$(BUILDS),$(eval $(call bench_build,$b)))

$(BENCH_OUT)/native/fused_%: $(BENCH_SRC)/peers/%.c $(NEEDED_native) | need-peers
	$(PEER_CC) $(FLAGS_fused) -o $@ $^ $(LIBS_$*) -lm

$(BENCH_OUT)/native/fused_%: $(BENCH_SRC)/peers/%.cpp $(NEEDED_native) | need-peers
	$(PEER_CXX) $(FLAGS_fused) -o $@ $^ -lm

-include $(wildcard $(BENCH_OUT)/*/*.d $(BENCH_OUT)/*/lib/*.d)

.PHONY: build-bench need-peers need-charts need-bits results-check bench \
        charts results figures longrun costs batch atlas atlas-check orbits natural \
        slides
build-bench: $(foreach b,$(BUILDS),$(BENCHES:%=$(BENCH_OUT)/$b/%)) ## the benchmarks compile

# A peer that is missing would make our curve look better than it is.
need-peers:
	for h in gsl/gsl_odeiv2.h boost/numeric/odeint.hpp cvode/cvode.h \
	    mujoco/mujoco.h ode/ode.h; do echo "#include <$$h>" | \
	    $(CXX) -x c++ -fsyntax-only - 2>/dev/null || \
	    { echo "the benchmarks need <$$h>: sudo apt-get install g++" \
	    "libgsl-dev libboost-dev libsundials-dev libmujoco-dev libode-dev"; \
	    exit 1; }; done >&2

need-charts:
	for tool in gnuplot valgrind $(PYTHON); do command -v $$tool \
	    >/dev/null || { echo "the charts need $$tool: sudo apt-get" \
	    "install gnuplot-nox valgrind python3" >&2; exit 1; }; done

# A CSV says which bits made it: those that are pinned, and that are so.
BITS = sh $(BENCH_SRC)/bits.sh $(SRC)
need-bits: $(O)/tests/test_selftest $(O)/tests/test_float
	for test in $^; do $$test >$(O)/bits.log 2>&1 || \
	    { cat $(O)/bits.log; exit 1; }; done

results-check: ## the kept measurements are of the bits that the code has
	$(BITS) $(RESULTS)

DRAW = for py in curves atlas; do $(PYTHON) $(BENCH_SRC)/$$py.py $(RESULTS) \
           $(BENCH_OUT)/curves || exit 1; done && \
       $(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(SRC)/docs/accuracy.md \
           $(SRC)/docs/limits.md && \
       for f in $(BENCH_SRC)/*.gp; do gnuplot -e "from='$(BENCH_OUT)/curves'" \
           -e "results='$(RESULTS)'" -e "to='$(SRC)/docs/figures'" $$f || \
           exit 1; done && $(SLIM)
SLIMMER = $(PYTHON) $(BENCH_SRC)/slim.py $(SRC)/docs/figures/*.svg
SLIM = $(SLIMMER) && $(SCHEMES) && $(SLIMMER)
COSTS = { $(ABOUT); $(PYTHON) $(BENCH_SRC)/costs.py $(BENCH_OUT); } \
        >$(BENCH_OUT)/costs.csv
ABOUT = CC='$(CC)' CXX='$(CXX)' sh $(BENCH_SRC)/about.sh \
        'portable: $(FLAGS_portable) $(PLAIN)' \
        'native: $(FLAGS_native) $(PLAIN)' 'library: $(PINNED) besides' \
        'fused: peers alone, $(FLAGS_fused)'; $(BITS)
EACH_BUILD = for b in $(BUILDS); do

TIMED = build-bench need-charts need-bits $(BENCH_OUT)/truth \
        $(BENCH_OUT)/count \
        $(foreach b,$(BUILDS),$(PEERS:%=$(BENCH_OUT)/$b/peer_%)) \
        $(FUSED:%=$(BENCH_OUT)/native/fused_%)

# One after the other, whatever -j says: they are timed.
bench: $(TIMED) ## speed against accuracy, beside other solvers (10 minutes)
	echo "measuring: leave the machine alone"
	{ $(ABOUT); echo build,method,ns_per_step,textbook_over_it; \
	    $(EACH_BUILD) $(BENCH_OUT)/$$b/bench_steps $$b || exit 1; done; \
	    } >$(BENCH_OUT)/steps.csv
	{ $(ABOUT); echo build,scene,method,setting,error,ns_per_unit,$(\
	    )slopes_per_unit,textbook_ns,status; \
	    $(EACH_BUILD) $(BENCH_OUT)/$$b/bench_accuracy $$b || exit 1; \
	    for p in $(PEERS); do test $$b.$$p = native.ode -o \
	        $$b.$$p = native.mujoco || $(BENCH_OUT)/$$b/peer_$$p $$b || \
	        exit 1; done; done; for p in $(FUSED); do \
	        $(BENCH_OUT)/native/fused_$$p fused || exit 1; done; \
	    } >$(BENCH_OUT)/rungs.csv
	$(PYTHON) $(BENCH_SRC)/rungs.py <$(BENCH_OUT)/rungs.csv \
	    >$(BENCH_OUT)/accuracy.csv
	{ $(ABOUT); echo build,call,rate,ns,textbook_steps,error; \
	    $(EACH_BUILD) $(BENCH_OUT)/$$b/bench_frames $$b || exit 1; done; \
	    } >$(BENCH_OUT)/frames.csv
	{ $(ABOUT); echo build,lanes,abreast_ns,alone_ns,gain,busy_alike,busy_any; \
	    $(EACH_BUILD) $(BENCH_OUT)/$$b/bench_abreast $$b || exit 1; done; \
	    } >$(BENCH_OUT)/abreast.csv
	{ $(ABOUT); $(BENCH_OUT)/portable/bench_best; } >$(BENCH_OUT)/best.csv
	$(BENCH_OUT)/truth >$(BENCH_OUT)/truth.csv
	{ $(ABOUT); $(BENCH_OUT)/portable/bench_reliability \
	    $(BENCH_OUT)/truth.csv; \
	    } >$(BENCH_OUT)/reliability.csv
	$(COSTS)
	$(BATCH)
	$(NATURAL)
	$(PYTHON) $(BENCH_SRC)/summary.py $(BENCH_OUT)

$(BENCH_OUT)/truth: $(BENCH_SRC)/peers/truth.cpp | need-peers
	$(PEER_CXX) -O2 -o $@ $<

charts: bench $(BENCH_OUT)/portable/peer_orbit ## measure, and renew the charts
	mkdir -p $(RESULTS)
	$(MAP)
	$(ORBITS)
	for t in steps accuracy frames abreast best reliability costs batch \
	    natural atlas; do \
	    cp $(BENCH_OUT)/$$t.csv $(RESULTS)/$$t.csv; done
	$(DRAW)

figures: need-charts ## draw the charts from the kept results
	mkdir -p $(BENCH_OUT)
	$(DRAW)

# What becomes of a coin under every step: not timed, so at any time.
MAPPED := bench_accuracy peer_gsl peer_odeint
MAP     = for p in $(MAPPED); do ( $(BENCH_OUT)/portable/$$p atlas \
              >$(BENCH_OUT)/$$p.csv || rm $(BENCH_OUT)/$$p.csv ) & done; wait; \
          { $(ABOUT); echo family,method,x,outcomes; \
            cat $(MAPPED:%=$(BENCH_OUT)/%.csv) || exit 1; \
          } >$(BENCH_OUT)/atlas.csv

atlas: $(MAPPED:%=$(BENCH_OUT)/portable/%) need-charts need-bits ## the maps of docs/limits.md (3 minutes)
	mkdir -p $(RESULTS)
	$(MAP)
	cp $(BENCH_OUT)/atlas.csv $(RESULTS)
	$(DRAW)

atlas-check: $(BENCH_OUT)/portable/bench_accuracy # the maps' references, by another route
	$< atlas references >$(BENCH_OUT)/references.csv
	$(BENCH_SRC)/atlas_check.py <$(BENCH_OUT)/references.csv

BATCH = { $(ABOUT); echo build,coins,method,steps,dt_W,alone_ns,$(\
          )abreast_ns,textbook_ns; \
          $(EACH_BUILD) $(BENCH_OUT)/$$b/bench_batch $$b || exit 1; done; \
          } >$(BENCH_OUT)/batch.csv

batch: $(BUILDS:%=$(BENCH_OUT)/%/bench_batch) need-charts need-bits ## many coins at once: measure, and draw (one minute)
	mkdir -p $(RESULTS)
	$(BATCH)
	cp $(BENCH_OUT)/batch.csv $(RESULTS)
	$(DRAW)

# What a frame loop calls.
NATURAL = { $(ABOUT); $(PYTHON) $(BENCH_SRC)/natural.py $(BENCH_OUT) \
            $(BUILDS) || exit 1; } >$(BENCH_OUT)/natural.csv

natural: $(BUILDS:%=$(BENCH_OUT)/%/bench_calls) need-charts need-bits ## what the calls of a frame loop cost (one minute)
	mkdir -p $(RESULTS)
	$(NATURAL)
	cp $(BENCH_OUT)/natural.csv $(RESULTS)

# Solved once, or stepped: what n frames cost, and how the phases of steppers
# err against an orbit's.
ORBITS  = for what in costs ratios phase; do { $(ABOUT); \
              $(BENCH_OUT)/portable/peer_orbit $$what || exit 1; \
              } >$(RESULTS)/orbit_$$what.csv || exit 1; done

orbits: $(BENCH_OUT)/portable/peer_orbit need-charts need-bits ## an orbit beside steps (two minutes)
	$(ORBITS)
	$(DRAW)

slides: $(BENCH_OUT)/native/peer_slide need-charts need-bits ## coins that slip, beside other methods (two minutes)
	mkdir -p $(RESULTS)
	{ $(ABOUT); $<; } >$(BENCH_OUT)/slides.csv
	cp $(BENCH_OUT)/slides.csv $(RESULTS)
	$(DRAW)

results: ## measure anew all that results-check looks at (an hour)
	+for what in charts slides silent adversary adversary-update longrun \
	    figures; do \
	    $(AGAIN) $$what || exit 1; done

longrun: $(BENCH_OUT)/portable/bench_longrun need-bits ## what ten million steps do (half an hour)
	mkdir -p $(RESULTS)
	{ $(ABOUT); $<; } >$(BENCH_OUT)/longrun.csv
	{ $(ABOUT); $< damping; } >$(BENCH_OUT)/damping.csv
	cp $(BENCH_OUT)/longrun.csv $(BENCH_OUT)/damping.csv $(RESULTS)

# The sources that step once more, with a double that counts.  Where a sign is
# moved by its bits the length of the chain is lost: it is 0 then.
COUNTED := $(patsubst %.c,$(BENCH_OUT)/counted/%.o,$(notdir \
             $(filter $(SRC)/lib/motion/% $(SRC)/lib/step/%,$(SOURCES))))

$(BENCH_OUT)/counted:
	mkdir -p $@

$(BENCH_OUT)/counted/%.o: %.c $(BENCH_SRC)/arithmetic.h \
                          $(wildcard $(SRC)/lib/*/*.h) | $(BENCH_OUT)/counted
	$(CXX) -std=c++20 -O1 -w -fpermissive -x c++ -I$(SRC)/include \
	    -ftrivial-auto-var-init=zero -include $(BENCH_SRC)/arithmetic.h -c -o $@ $<

$(BENCH_OUT)/count: $(BENCH_SRC)/count.cpp $(COUNTED)
	$(CXX) -std=c++20 -O1 -w -I$(SRC)/include -o $@ $^

costs: $(BENCH_OUT)/count need-charts # after bench, whose steps.csv it reads
	$(COSTS)
