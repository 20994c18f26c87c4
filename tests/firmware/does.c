/* SPDX-License-Identifier: MIT */
/* does WHAT STEPS: does it, for count.sh, which counts its instructions from
 * outside; then prints how deep its stack went. */
#include "works.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int count, char **argument)
{
    int i = 0;
    while (i < WORKS && (count < 3 || strcmp(argument[1], works[i].name) != 0))
        ++i;
    if (i == WORKS)
        return 2;
    prepare_works();
    works[i].does((uint32_t)atoi(argument[2]));
    printf("%lu\n", (unsigned long)depth(works[i].does));
    return failed;
}
