/* SPDX-License-Identifier: MIT */
/* hashes.c: the hashes of the page's scenes, as this processor makes them. */
#include "../../docs/page/page.h"

#include <stdio.h>

int32_t page_scene_count(void);
const char *page_scene_word(int32_t k, int32_t which);
const char *page_hash(int32_t k);

int main(void)
{
    for (int32_t k = 0; k < page_scene_count(); ++k)
        printf("%s %s\n", page_scene_word(k, 0), page_hash(k));
    return 0;
}
