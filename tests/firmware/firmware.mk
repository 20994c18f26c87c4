# SPDX-License-Identifier: MIT
#
# The library on processors that are not this one: included by the Makefile.
#
#   make firmware           no operating system: start-up code, QEMU's boards
#   make firmware-update    write what a step takes there into the docs
#   make cross              Linux on other processors by qemu-user; wasm in node
#   make cross-update       the same for these
#
# On each the program of `make repro` has to print the lines that it prints
# here, the same hashes; and what the library takes is what the docs say.

FW      := $(SRC)/tests/firmware
FW_OUT  := $(O)/firmware
BOARD   := $(SRC)/docs/examples/firmware

# --------------------------------------------------------------------- machines
BOARDS := m0 m3 m4f m33 m7 rv32 rv64
CROSS  := i686 aarch64 armhf riscv64 ppc64le s390x wasm32

CC_m0    = $(ARM) -mthumb -masm-syntax-unified -mcpu=cortex-m0
CC_m3    = $(ARM) -mthumb -mcpu=cortex-m3
CC_m4f   = $(ARM) -mthumb -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard
CC_m33   = $(ARM) -mthumb -mcpu=cortex-m33 -mfpu=fpv5-sp-d16 -mfloat-abi=hard
CC_m7    = $(ARM) -mthumb -mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard
RISCV   ?= riscv64-unknown-elf-gcc --specs=picolibc.specs
CC_rv32  = $(RISCV) -mcmodel=medany -march=rv32imac -mabi=ilp32
CC_rv64  = $(RISCV) -mcmodel=medany -march=rv64imafdc -mabi=lp64d

CC_i686    = i686-linux-gnu-gcc -msse2 -mfpmath=sse
CC_aarch64 = aarch64-linux-gnu-gcc
CC_armhf   = arm-linux-gnueabihf-gcc
CC_riscv64 = riscv64-linux-gnu-gcc
CC_ppc64le = powerpc64le-linux-gnu-gcc
CC_s390x   = s390x-linux-gnu-gcc -fexcess-precision=fast
CC_wasm32  = clang --target=wasm32-wasi

# What runs a program; its lines come out by either stream.
fw_qemu  = qemu-system-$1 -nographic -monitor none -serial none \
           -semihosting-config enable=on,target=native -M $2 -kernel
RUN_m0   = $(call fw_qemu,arm,microbit)
RUN_m3   = $(call fw_qemu,arm,mps2-an385)
RUN_m4f  = $(call fw_qemu,arm,mps2-an386)
RUN_m33  = $(call fw_qemu,arm,mps2-an505)
RUN_m7   = $(call fw_qemu,arm,mps2-an500)
RUN_rv32 = $(call fw_qemu,riscv32,virt -bios none)
RUN_rv64 = $(call fw_qemu,riscv64,virt -bios none)

RUN_i686    = qemu-i386
RUN_aarch64 = qemu-aarch64
RUN_armhf   = qemu-arm
RUN_riscv64 = qemu-riscv64
RUN_ppc64le = qemu-ppc64le
RUN_s390x   = qemu-s390x
RUN_wasm32  = node --no-warnings $(FW)/wasi.mjs

# Where a board's flash and memory begin, and where memory ends.
fw_memory   = $(foreach s,FLASH=$1 RAM=$2 STACK=$3,-Wl,--defsym=$s)
MEMORY_m0   = $(call fw_memory,0,0x20000000,0x20004000)
MEMORY_m3   = $(call fw_memory,0,0x20000000,0x20080000)
MEMORY_m4f  = $(MEMORY_m3)
MEMORY_m7   = $(MEMORY_m3)
MEMORY_m33  = $(call fw_memory,0x10000000,0x38000000,0x38080000)
MEMORY_rv32 = $(call fw_memory,0x80000000,0x80200000,0x80280000)
MEMORY_rv64 = $(MEMORY_rv32)

# Which part of hash.c: the boards without a unit for doubles take every fourth
# scene, and the one with 16 KiB of memory no orbit.  The others print what
# `make repro` pins.
FW_PART = $(if $(filter $1,m0),least,$(if $(filter $1,m3 m4f m33 rv32),few))
FW_EXPECTED = $(or $(patsubst %,$(FW_OUT)/host/%.txt,$(call FW_PART,$1)),\
                $(SRC)/tests/repro/expected.txt)
HASH_few   := -DSCENE_STRIDE=4
HASH_least := $(HASH_few) -DWITHOUT_ORBIT

# newlib's sqrt sets errno, which brings a kilobyte of data; the one below it
# does not.  libgcc's addition of doubles is mended (arm_dadd.c) where it is
# what adds them, so that the hashes can be equal.
FW_SQRT = $(foreach f,sqrt sqrtf,-Wl,--defsym=$f=__ieee754_$f)
FW_WRAP = $(foreach f,dadd dsub drsub,-Wl,--wrap=__aeabi_$f)
FW_DADD = m3 m4f m33

# ------------------------------------------------------------------------ rules
FW_C99   = -std=c99 -O2 -ffp-contract=off -Wall -Wextra -Werror \
           -I$(SRC)/include -I$(BOARD)
FW_CC    = $(CC_$1) $(FW_C99) -fno-math-errno $(if $(filter $1,wasm32),,\
           -fno-tree-vectorize -fcallgraph-info=su) -ffunction-sections \
           -fdata-sections -fno-asynchronous-unwind-tables $(DEPENDS)
FW_LINK  = $(CC_$1) -nostdlib -Wl,--gc-sections $(if $(filter m%,$1),$(FW_SQRT))
FW_LIBS  = -Wl,--start-group -lm -lc -lgcc -Wl,--end-group
FW_OBJ   = $(patsubst %,$(FW_OUT)/$1/%.o,\
             $(notdir $(basename $(SOURCES))))
FW_START = $(FW_OUT)/$1/$(if $(filter rv%,$1),riscv,cortex_m).o

# What every machine compiles, and how it is held against this one.
define fw_machine
$(FW_OUT)/$1/%.o: %.c $(O)/flags $(FW)/firmware.mk | $(FW_OUT)/$1
	$$(call FW_CC,$1) -c -o $$@ $$<

$(FW_OUT)/$1/hash.o: $(SRC)/tests/repro/hash.c | $(FW_OUT)/$1
	$$(call FW_CC,$1) $$(HASH_$(call FW_PART,$1)) -c -o $$@ $$<

$(FW_OUT)/$1/%.txt: $(FW_OUT)/$1/%.elf
	timeout 300 $$(RUN_$1) $$< $$(QEMU_$$*) </dev/null >$$@ 2>&1 || \
	    { echo "$1 fails in $$*:"; tail -3 $$@; exit 1; } >&2

$(FW_OUT)/$1/same: $(FW_OUT)/$1/hash.txt $(call FW_EXPECTED,$1)
	cmp $$^
	echo "same hashes  $1"
	touch $$@

$(FW_OUT)/$1:
	mkdir -p $$@
endef
$(foreach m,$(BOARDS) $(CROSS),$(eval $(call fw_machine,$m)))

define fw_board
$(FW_OUT)/$1/%.o: $(FW)/%.c | $(FW_OUT)/$1
	$$(call FW_CC,$1) -c -o $$@ $$<

$(FW_OUT)/$1/%.o: $(BOARD)/%.c | $(FW_OUT)/$1
	$$(call FW_CC,$1) -c -o $$@ $$<

$(FW_OUT)/$1/hash.elf: $(if $(filter $1,$(FW_DADD)),$(FW_OUT)/$1/arm_dadd.o)

$(FW_OUT)/$1/%.elf: $(FW_OUT)/$1/%.o $(call FW_START,$1) $(call FW_OBJ,$1) \
                    $(BOARD)/board.ld
	$$(call FW_LINK,$1) $$(if $$(filter %/arm_dadd.o,$$^),$$(FW_WRAP)) \
	    $$(MEMORY_$1) -T $(BOARD)/board.ld -o $$@ $$(filter %.o,$$^) $$(FW_LIBS)

$(FW_OUT)/$1/as-host: $(FW_OUT)/$1/watchdog.txt $(FW_OUT)/host/watchdog.txt
	cmp $$^
	touch $$@
endef
$(foreach m,$(BOARDS),$(eval $(call fw_board,$m)))

# An orbit and its init take 77 KiB; wasm-ld gives 64 unless told.
FW_STACK := -Wl,-z,stack-size=131072
define fw_cross
$(FW_OUT)/$1/%.elf: $(FW_OUT)/$1/%.o $(call FW_OBJ,$1)
	$$(CC_$1) $(if $(filter wasm32,$1),$(FW_STACK),-static) -o $$@ $$^ -lm
endef
$(foreach m,$(CROSS),$(eval $(call fw_cross,$m)))

# The clock counts instructions, 1 ns each.
QEMU_counts   := -icount shift=0,sleep=off
QEMU_watchdog := $(QEMU_counts)

# This computer's own answers: but for the last line, the hash of all, they are
# among those that `make repro` pins.
$(FW_OUT)/host/%.txt: $(SRC)/tests/repro/hash.c $(LIB_A) | $(FW_OUT)/host
	$(CC) $(FW_C99) $(HASH_$*) -o $(@:.txt=) $< $(LIB_A) -lm
	$(@:.txt=) >$@
	test $$(grep -cvxFf $(SRC)/tests/repro/expected.txt $@) = 1

$(FW_OUT)/host/watchdog.txt: $(BOARD)/watchdog.c $(FW)/host.c $(LIB_A) \
                             | $(FW_OUT)/host
	$(CC) $(FW_C99) -o $(@:.txt=) $(filter %.c,$^) $(LIB_A) -lm
	$(@:.txt=) >$@

$(FW_OUT)/host:
	mkdir -p $@

# A processor too slow for its loop, 64 ns each, is told so.
$(FW_OUT)/m0/late.txt: $(FW_OUT)/m0/watchdog.elf
	timeout 60 $(RUN_m0) $< -icount shift=6,sleep=off </dev/null >$@ 2>&1
	test "$$(head -1 $@)" = '1 rounds: late'

# ---------------------------------------------------------------- what it takes
FW_ENTRIES := coinf_step coinf_run coinf_check coin_step coin_run coin_settle \
              coin_move
FW_TOOLS    = $(if $(filter wasm32,$1),llvm-,$(patsubst \
                %gcc,%,$(firstword $(CC_$1))))

# The objects themselves: what they need, and that they hold no writable data.
define fw_objects
$(FW_OUT)/$1/objects: $(call FW_OBJ,$1) $(SRC)/tests/lint/objects.sh
	TOOLS=$$(call FW_TOOLS,$1) OUT=$(FW_OUT)/$1 \
	    LIBGCC=$$$$($$(CC_$1) -print-libgcc-file-name) \
	    sh $(SRC)/tests/lint/objects.sh $1 $$(filter %.o,$$^)
	touch $$@
endef
$(foreach m,$(BOARDS) $(CROSS),$(eval $(call fw_objects,$m)))

# A program of all that an entry reaches, and nothing else.
define fw_reach
$(FW_OUT)/$1/reach_%: $(call FW_OBJ,$1) $(BOARD)/board.ld
	$$(call FW_LINK,$1) -Wl,-e,$$* $$(MEMORY_$1) -T $(BOARD)/board.ld -o $$@ \
	    $$(filter %.o,$$^) $$(FW_LIBS)
endef
$(foreach m,$(BOARDS),$(eval $(call fw_reach,$m)))

# Of Linux, what an entry reaches in the library; and a program that is counted
# from outside.  No one counts for wasm, nor knows where its frames will lie.
define fw_part_of
$(FW_OUT)/$1/reach_%: $(call FW_OBJ,$1)
	$$(CC_$1) -nostdlib -Wl,--gc-sections -Wl,-e,$$* \
	    $(if $(filter wasm32,$1),-Xlinker --allow-undefined,-r) -o $$@ $$^

$(FW_OUT)/$1/does.o: $(FW)/does.c | $(FW_OUT)/$1
	$$(call FW_CC,$1) -c -o $$@ $$<

$(FW_OUT)/$1/counts.txt: $(FW_OUT)/$1/does.elf $(FW)/count.sh
	sh $(FW)/count.sh $$(RUN_$1) $$< $(FW_ENTRIES) >$$@
endef
$(foreach m,$(CROSS),$(eval $(call fw_part_of,$m)))

fw_needs    = $(foreach m,$1,$(FW_OUT)/$m/objects \
                $(FW_ENTRIES:%=$(FW_OUT)/$m/reach_%) \
                $(if $(filter wasm32,$m),,$(FW_OUT)/$m/counts.txt))
fw_figures  = $(PYTHON) $(FW)/figures.py $1 $(FW_OUT) $(SRC)/$3 \
              '$(notdir $(basename $(SOURCES)))' \
              $(foreach m,$2,$m=$(call FW_TOOLS,$m))

.PHONY: firmware firmware-update cross cross-update cross-x87
firmware: $(BOARDS:%=$(FW_OUT)/%/same) $(BOARDS:%=$(FW_OUT)/%/as-host)
firmware: $(FW_OUT)/m0/late.txt $(call fw_needs,$(BOARDS)) ## equal hashes without an operating system
	$(call fw_figures,firmware,$(BOARDS),docs/embedding.md)
	+$(GATE) sh $(FW)/page.sh

firmware-update: $(call fw_needs,$(BOARDS)) ## write docs/embedding.md's tables
	$(call fw_figures,firmware,$(BOARDS),docs/embedding.md) --update

cross: $(CROSS:%=$(FW_OUT)/%/same) $(call fw_needs,$(CROSS)) cross-x87 ## equal hashes from other processors, and wasm
	$(call fw_figures,cross,$(CROSS),tests/studies/tables.md)

# The x87 keeps more digits than a double has: every source refuses it, and says
# which flags help.
cross-x87: | $(O)
	for source in $(SOURCES); do \
	    ! i686-linux-gnu-gcc -I$(SRC)/include -fsyntax-only $$source \
	        2>$(O)/x87 && grep -q 'error.*i386 -msse2 -mfpmath=sse' $(O)/x87 || \
	        { echo "$$source compiles for the x87"; exit 1; }; done
	echo "i686 without SSE2 is refused, by all of $(words $(SOURCES)) sources"

cross-update: $(call fw_needs,$(CROSS)) ## write their tables in tests/studies/tables.md
	$(call fw_figures,cross,$(CROSS),tests/studies/tables.md) --update
