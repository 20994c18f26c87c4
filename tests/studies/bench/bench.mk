# SPDX-License-Identifier: MIT
#
# Speed against accuracy: included by the Makefile, whose SRC, O, CC, CFLAGS,
# WARN, MAPS, PINNED and PYTHON it uses.  tests/studies/README.md says what each
# target answers, and how long it takes.
#
# Library, textbook and peers are built twice, alike: portable and native.  A
# busy machine shows: wait for a quiet one, and run nothing beside.

BENCH_SRC := $(SRC)/tests/studies/bench
RESULTS   := $(BENCH_SRC)/results
BENCH_OUT  = $(O)/bench
BUILDS    := portable native
FLAGS_portable := -O2
FLAGS_native   := -O3 -march=native
# The vectorizer shortens the textbook's step in the portable build, by 130
# instructions, and slows it in the native one: each gets the quicker.
TEXTBOOK_native := -fno-tree-vectorize
# A third build, of peers alone: native, with products and sums fused.
FUSED          := gsl odeint
FLAGS_fused    := $(FLAGS_native) -ffp-contract=fast

BENCHES := $(patsubst $(BENCH_SRC)/%.c,%,$(wildcard $(BENCH_SRC)/bench_*.c))
SHARED_BY_BENCHES := scene workprec atlas textbook sliding
PEERS        := gsl odeint cvode ode mujoco
LIBS_gsl     := -lgsl -lgslcblas
LIBS_cvode   := -lsundials_cvode -lsundials_nvecserial \
                -lsundials_sunnonlinsolfixedpoint
LIBS_ode     := -lode -lstdc++
LIBS_mujoco  := -lmujoco
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

$(BENCH_OUT)/$1/textbook.o $(BENCH_OUT)/$1/sliding.o: \
    $(BENCH_OUT)/$1/%.o: $(BENCH_SRC)/%.c | $(BENCH_OUT)/$1
	$$(PEER_CC) $(FLAGS_$1) $(TEXTBOOK_$1) -c -o $$@ $$<

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

.PHONY: build-bench studies-build need-peers need-charts need-bits \
        results-check charts results figures longrun costs batch atlas orbits \
        slides engine-frames need-engines
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
need-bits: $(TEST_PROG)
	$< test_selftest >$(O)/bits.log 2>&1 || { cat $(O)/bits.log; exit 1; }

results-check: ## the kept measurements are of the bits that the code has
	$(BITS) $(RESULTS)

STUDIED  = $(SRC)/docs/accuracy.md $(SRC)/docs/limits.md \
           $(SRC)/docs/luck.md \
           $(SRC)/tests/studies/tables.md
DRAW     = mkdir -p $(BENCH_OUT) && \
           $(PYTHON) $(BENCH_SRC)/curves.py $(RESULTS) $(BENCH_OUT)/curves && \
           $(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(STUDIED) && \
           for gp in accuracy batch longrun orbit slides; do \
               $(call GNUPLOT,$(BENCH_OUT)/curves,$$gp) || exit 1; done && \
           $(SLIM)
GNUPLOT  = gnuplot -e "from='$1'" -e "results='$(RESULTS)'" \
           -e "to='$(SRC)/docs/figures'" $(BENCH_SRC)/$2.gp
SLIMMER = $(PYTHON) $(BENCH_SRC)/slim.py $(SRC)/docs/figures/*.svg
SLIM = $(SLIMMER) && $(SCHEMES) && $(SLIMMER)
ABOUT = CC='$(CC)' CXX='$(CXX)' sh $(BENCH_SRC)/about.sh \
        'portable: $(FLAGS_portable) $(PLAIN)' \
        'native: $(FLAGS_native) $(PLAIN)' 'library: $(PINNED) besides' \
        'textbook, native: $(TEXTBOOK_native) besides' \
        'fused: peers alone, $(FLAGS_fused)'; $(BITS)
# $(call RESULT,NAME,COMMAND): what a command prints, under a head, becomes a
# result when it has come to its end.
RESULT = { $(ABOUT); $2 || exit 1; } >$(BENCH_OUT)/$1.csv && \
         cp $(BENCH_OUT)/$1.csv $(RESULTS)
EACH_BUILD = for b in $(BUILDS); do

figures: need-charts ## draw the charts from the kept results
	$(DRAW)

# The parts of charts, one after the other, whatever -j says: they are timed.
costs: $(BUILDS:%=$(BENCH_OUT)/%/bench_costs) need-charts need-bits ## what calls cost: the table of docs/accuracy.md (2 minutes)
	$(call RESULT,costs,$(PYTHON) $(BENCH_SRC)/costs.py $(BENCH_OUT) $(BUILDS))
	$(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(STUDIED)

batch: $(BUILDS:%=$(BENCH_OUT)/%/bench_batch) need-charts need-bits ## many coins at once (1 minute)
	$(call RESULT,batch,echo $(BATCH_HEAD); $(EACH_BUILD) \
	    $(BENCH_OUT)/$$b/bench_batch $$b || exit 1; done)

orbits: $(BENCH_OUT)/portable/bench_orbit need-charts need-bits ## an orbit beside steps (1 minute)
	$(call RESULT,orbit_costs,$<)

slides: $(BENCH_OUT)/native/peer_slide need-charts need-bits ## coins that slip, beside other methods (2 minutes)
	$(call RESULT,slides,$<)
	$(DRAW)

BATCH_HEAD := build,coins,method,steps,dt_W,alone_ns,abreast_ns,textbook_ns
FRAMES_HEAD := call,rate,ns,error
RUNGS_HEAD := build,scene,method,setting,error,ns_per_unit,textbook_ns,status
RUNGS = echo $(RUNGS_HEAD); $(EACH_BUILD) \
        $(BENCH_OUT)/$$b/bench_accuracy $$b || exit 1; \
        for p in $(PEERS); do test $$b.$$p = native.ode -o \
        $$b.$$p = native.mujoco || $(BENCH_OUT)/$$b/peer_$$p $$b || exit 1; \
        done; done; for p in $(FUSED); do \
        $(BENCH_OUT)/native/fused_$$p fused || exit 1; done

# The binding, installed beside the results.
$(BENCH_OUT)/site: $(LIB_A) $(LIB_SO)
	$(DEBIAN_PYTHON) -m pip -q --disable-pip-version-check install \
	    --root-user-action=ignore --no-index --no-deps --upgrade --target $@ \
	    $(SRC)/docs/examples/python
	touch $@

TIMED = build-bench need-charts need-bits $(BENCH_OUT)/site \
        $(foreach b,$(BUILDS),$(PEERS:%=$(BENCH_OUT)/$b/peer_%)) \
        $(FUSED:%=$(BENCH_OUT)/native/fused_%)

charts: $(TIMED) ## speed against accuracy, beside other solvers (10 minutes)
	echo "measuring: leave the machine alone"
	mkdir -p $(RESULTS)
	$(call RESULT,frames,echo $(FRAMES_HEAD); \
	    $(BENCH_OUT)/portable/bench_frames)
	$(call RESULT,python,PYTHONPATH=$(BENCH_OUT)/site $(DEBIAN_PYTHON) \
	    $(BENCH_SRC)/python.py $(SRC)/tests/reference/quarter.csv)
	{ $(ABOUT); $(RUNGS); } >$(BENCH_OUT)/rungs.csv
	$(PYTHON) $(BENCH_SRC)/rungs.py <$(BENCH_OUT)/rungs.csv \
	    >$(BENCH_OUT)/accuracy.csv
	cp $(BENCH_OUT)/accuracy.csv $(RESULTS)
	+for part in costs batch orbits figures; do $(AGAIN) $$part || exit 1; done

# Debian's Bullet has floats, its ODE and MuJoCo doubles.
ENGINES_CXX = $(CXX) $(CFLAGS) -Wall -Wextra -std=c++17 $(PLAIN) \
              -I$(SRC)/include -I$(BENCH_SRC) \
              $$($(PKG_CONFIG) --cflags bullet | sed s/-I/-isystem/)
ENGINES_LIBS = $(LIB_A) -lode -lBulletDynamics -lBulletCollision \
               -lLinearMath -lmujoco -lpthread -lm
$(BENCH_OUT)/engine_frames: $(BENCH_SRC)/peers/engine_frames.cpp \
                            $(BENCH_SRC)/peers/engines.h $(BENCH_SRC)/clock.h \
                            $(LIB_A) $(O)/flags | need-engines
	mkdir -p $(@D)
	$(ENGINES_CXX) -o $@ $< $(ENGINES_LIBS)

need-engines:
	for h in ode/ode.h bullet/btBulletDynamicsCommon.h mujoco/mujoco.h; do \
	    echo "#include <$$h>" | $(CXX) -I/usr/include/bullet -x c++ \
	    -fsyntax-only - 2>/dev/null || { echo "the engines need <$$h>: sudo" \
	    "apt-get install libode-dev libbullet-dev libmujoco-dev"; \
	    exit 1; }; done >&2

engine-frames: $(BENCH_OUT)/engine_frames need-bits ## a frame by coin_move and by physics engines (1 minute)
	$(call RESULT,engine_frames,$<)
	$(DRAW)

# What becomes of a coin under every step: not timed, so at any time, and made
# anew each time.
MAPPED := bench_accuracy peer_gsl peer_odeint
MAPS_AT = $(BENCH_OUT)/atlas
atlas: $(MAPPED:%=$(BENCH_OUT)/portable/%) need-charts ## the maps of docs/limits.md (3 minutes)
	mkdir -p $(MAPS_AT)
	for p in $(MAPPED); do ( $(BENCH_OUT)/portable/$$p atlas \
	    >$(MAPS_AT)/$$p.csv || rm $(MAPS_AT)/$$p.csv ) & done; wait
	{ echo family,method,x,outcomes; cat $(MAPPED:%=$(MAPS_AT)/%.csv); } \
	    >$(MAPS_AT)/atlas.csv
	$(PYTHON) $(BENCH_SRC)/atlas.py $(MAPS_AT)
	$(PYTHON) $(BENCH_SRC)/summary.py $(MAPS_AT) $(STUDIED)
	$(call GNUPLOT,$(MAPS_AT),atlas)
	$(SLIM)

results: ## measure anew all that results-check looks at
	+for what in charts slides engine-frames needs silent adversary \
	    adversary-update longrun luck-engines luck figures; do \
	    $(AGAIN) $$what || exit 1; done

longrun: $(BENCH_OUT)/portable/bench_longrun need-bits ## what ten million steps do (half an hour)
	$(call RESULT,longrun,$<)
	$(call RESULT,damping,$< damping)

# Every study program that needs no other solver.
STUDIES = $(BENCHES:%=$(BENCH_OUT)/portable/%) \
          $(addprefix $(O)/limits/,silent endurance) \
          $(addprefix $(O)/real/,fixed tuning) $(O)/needs/needs
studies-build: $(STUDIES) luck-small ## the programs of tests/studies that need no peer are built
