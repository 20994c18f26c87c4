# SPDX-License-Identifier: MIT
#
# docs/page/index.html, the page that rolls a coin: included by the Makefile.
#
#   make page         builds it from docs/page: one file, the library within
#   make page-preview draws docs/page/preview.jpg, which links to the page show
#   make js           build/js, the package of docs/examples/js
#   make js-check     its tests pass, also those of its types
#   make page-check   it gives this computer's bits, works in Chromium and
#                     Firefox, and its C listing prints its digits
#
# The first two need what need-wasm says, as `make cross` does, the first also
# binaryen and zopfli; the last node, npm, chromium and firefox-esr: npm installs
# what drives the browsers, and axe-core, in build/page/npm.  js-check needs node
# and tsc.

PAGE      := $(SRC)/docs/page
PAGE_OUT  := $(O)/page
PAGE_HTML := $(PAGE)/index.html
PAGE_JS   := $(patsubst %,$(PAGE)/%.js,core numbers address camera coin table \
               stage graphs listing words sound luck hand time controls)

# The objects of the library for doubles, as WebAssembly.  What the page does
# not call is left out by the linker.
PAGE_CC    = clang --target=wasm32-wasi -Oz -std=c99 -ffp-contract=off -Wall \
             -Wextra -Werror -I$(SRC)/include -ffunction-sections \
             -fdata-sections -fvisibility=hidden $(DEPENDS)
PAGE_LINK  = -nostartfiles -Wl,--no-entry,--gc-sections,--strip-all \
             -Wl,-z,stack-size=131072
PAGE_C    := $(foreach f,page race bits luck,$(PAGE)/$f.c) \
             $(SRC)/tests/support/textbook.c
PAGE_FROM := $(filter-out $(SRC)/lib/float/%,$(SOURCES)) $(PAGE_C)
PAGE_OBJ  := $(patsubst %.c,$(PAGE_OUT)/%.o,$(notdir $(PAGE_FROM)))

.PHONY: page page-check page-preview js js-check need-wasm
page: $(PAGE_OUT)/index.html ## docs/page/index.html, a coin to play with
	cp $< $(PAGE_HTML)

$(foreach f,$(PAGE_C),$(eval vpath $(notdir $f) $(dir $f)))
$(PAGE_OUT)/%.o: %.c $(SRC)/tests/page/page.mk | $(PAGE_OUT) need-wasm
	$(PAGE_CC) -c -o $@ $<

# A program of one line needs the compiler, the linker, the C library and
# compiler-rt.
need-wasm:
	echo 'int main(void) { return 0; }' | \
	    clang --target=wasm32-wasi -x c -o /dev/null - 2>/dev/null || \
	    { echo "WebAssembly needs, on Debian 12: sudo apt-get install clang" \
	    "lld wasi-libc libclang-rt-14-dev-wasm32"; exit 1; } >&2

$(PAGE_OUT)/linked.wasm: $(PAGE_OBJ)
	clang --target=wasm32-wasi $(PAGE_LINK) -o $@ $^ -lm

# A tenth smaller, with the same bits: page-check looks at those.
$(PAGE_OUT)/page.wasm: $(PAGE_OUT)/linked.wasm
	wasm-opt -Oz -o $@ $<

$(PAGE_OUT)/wasm.txt: $(PAGE_OUT)/page.wasm
	zopfli -c $< >$(@D)/wasm.gz
	base64 -w 0 $(@D)/wasm.gz >$@
	echo >>$@

# This computer's hashes of the scenes: the page compares its own with them.
$(PAGE_OUT)/hashes: $(SRC)/tests/page/hashes.c $(PAGE_C) $(PAGE)/page.h \
                    $(LIB_A) | $(PAGE_OUT)
	$(CC_USER) -std=c99 -Wno-missing-prototypes $(PINNED) \
	    -I$(SRC)/include -o $@ $(filter-out %.h,$^) -lm

$(PAGE_OUT)/hashes.txt: $(PAGE_OUT)/hashes
	$< >$@

# What a browser without scripts shows: the animation of README.
$(PAGE_OUT)/rolling.svg: $(SRC)/docs/figures/ghosts.svg | $(PAGE_OUT)
	sed 's/ xmlns="[^"]*"//' $< >$@

$(PAGE_OUT)/index.html: $(PAGE)/page.html $(PAGE)/style.css $(PAGE_JS) \
                        $(PAGE)/embed.awk $(PAGE_OUT)/wasm.txt \
                        $(PAGE_OUT)/hashes.txt $(PAGE_OUT)/rolling.svg
	wasm=$(PAGE_OUT)/wasm.txt hashes=$(PAGE_OUT)/hashes.txt \
	    rolling=$(PAGE_OUT)/rolling.svg style=$(PAGE)/style.css \
	    script='$(PAGE_JS)' awk -f $(PAGE)/embed.awk $(PAGE)/page.html >$@

$(PAGE_OUT):
	mkdir -p $@

PAGE_NPM := $(PAGE_OUT)/npm/node_modules/.package-lock.json
$(PAGE_NPM): $(addprefix $(SRC)/tests/page/,package.json package-lock.json)
	mkdir -p $(PAGE_OUT)/npm
	cp $^ $(PAGE_OUT)/npm
	cd $(PAGE_OUT)/npm && \
	    npm ci --silent --ignore-scripts --no-audit --no-fund

page-check: $(PAGE_OUT)/hashes.txt $(PAGE_OUT)/rolling.svg $(LIB_A) $(PAGE_NPM) ## the page has this computer's bits and works in browsers
	timeout 900 node $(SRC)/tests/page/check.mjs $(SRC) \
	    $(abspath $(PAGE_OUT)) '$(CC)' $(LIB_A) '$(PAGE_JS)'

page-preview: $(PAGE_NPM) ## docs/page/preview.jpg, the page's picture in links
	node $(SRC)/tests/page/preview.mjs $(SRC) $(abspath $(PAGE_OUT))

# Every function of coin.h, and where the memory begins that no data takes.
JS       = $(SRC)/docs/examples/js
JS_WASM := $(O)/js/rollcoin.wasm
JS_NAMES = __heap_base $(shell sed -n 's/^ *\(coin_[a-z_]*\);/\1/p' \
               $(SRC)/lib/about/rollcoin.map)

js: $(JS_WASM) ## build/js, the library as WebAssembly, a package of npm's
	cp $(addprefix $(JS)/,rollcoin.mjs rollcoin.d.ts package.json README.md) \
	    $(SRC)/LICENSE $(SRC)/include/coin.h $(<D)

$(JS_WASM): $(filter-out $(patsubst %.c,$(PAGE_OUT)/%.o,$(notdir $(PAGE_C))),\
              $(PAGE_OBJ))
	mkdir -p $(@D)
	clang --target=wasm32-wasi $(PAGE_LINK) $(JS_NAMES:%=-Wl,--export=%) \
	    -Wl,--initial-memory=4194304 -o $@ $^ -lm

js-check: $(JS_WASM) ## the tests of docs/examples/js pass, of its types too
	node $(SRC)/tests/ffi/test_js.mjs $(JS_WASM)
	tsc --noEmit --strict --target es2022 --module nodenext $(SRC)/tests/ffi/types_js.mts
	mkdir -p $(O)/js/empty
	! PATH=$(abspath $(O))/js/empty $$(command -v $(MAKE)) -f $(SRC)/Makefile \
	    need-wasm >$(O)/js/needs 2>&1
	grep -q 'apt-get install clang lld wasi-libc libclang' $(O)/js/needs
