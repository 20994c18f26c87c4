/* SPDX-License-Identifier: MIT */
/* The directed search: climbs towards the largest unwarned error in parts of
 * the documented bound, from many starts, for every public function.
 *     adversary search EVALUATIONS SEED PART PARTS [FUNCTION]
 *     adversary replay FILE
 * Equal arguments do equal work and print equal lines. */
#include "law.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>

namespace
{
/* A climb begins where there is a claim.  One that has not risen by this factor
 * in so many evaluations ends: next to a smooth maximum it would rise a little
 * for ever. */
constexpr double RISE = 1.001;
constexpr long PATIENCE = 300;

using chance = std::mt19937_64;

/* In [0, 1). */
double next(chance *c)
{
    return double((*c)() >> 11) * 0x1p-53;
}

genome anywhere(chance *c)
{
    genome g;
    for (double &gene : g)
        gene = next(c);
    return g;
}

/* One to three genes moved, by 1e-16 to 1 of their range, or drawn anew. */
genome beside(genome g, int genes, chance *c)
{
    for (int k = int(1 + 3 * next(c)); k > 0; --k) {
        double &gene = g[size_t(next(c) * genes)];
        const double size = std::pow(10, -16 * next(c));
        gene += size * (2 * next(c) - 1);
        if (next(c) < 0.15 || !(gene >= 0 && gene < 1))
            gene = next(c);
    }
    return g;
}

/* ----------------------------------------------------------------- search */

struct best {
    double ratio = NO_CLAIM;
    scene at = {};
};

best search(const row &r, long evaluations, uint64_t seed)
{
    chance c(seed);
    best found;
    genome at = {};
    double top = NO_CLAIM, mark = 0; /* of a climb; at its last rise */
    for (long i = 0, since = 0; i < evaluations; ++i, ++since) {
        const bool anew = since == PATIENCE || top == NO_CLAIM;
        const genome g = anew ? anywhere(&c) : beside(at, r.genes, &c);
        scene s = scene_of(g, r.narrow);
        if (r.draw)
            r.draw(&s, g.data());
        const double ratio = r.law(s, anew ? NO_CLAIM : top);
        if (anew || ratio > RISE * mark) {
            mark = std::max(0.0, ratio);
            since = 0;
        }
        if (anew || ratio >= top) {
            top = ratio;
            at = g;
        }
        if (ratio > found.ratio)
            found = {ratio, s};
    }
    return found;
}

uint64_t seed_of(const row &r, uint64_t seed)
{
    for (char c : r.function)
        seed = seed * 1099511628211u + uint64_t(c);
    return seed;
}

/* Every row once in parts: its evaluations, by its own seed. */
int search_all(const std::vector<row> &rows, int argc, char **argv)
{
    const long most = std::atol(argv[2]);
    const uint64_t seed = std::strtoull(argv[3], nullptr, 10);
    const int part = std::atoi(argv[4]), parts = std::atoi(argv[5]);
    const char *pattern = argc > 6 ? argv[6] : "";
    int beyond = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const row &r = rows[i];
        const long n = most / r.share;
        if (int(i) % parts != part ||
            r.function.find(pattern) == std::string::npos)
            continue;
        const best b = search(r, n, seed_of(r, seed));
        std::printf("%s,%ld,%.3g,%s,%s\n", r.function.c_str(), n, b.ratio,
                    r.bound.c_str(), text_of(b.at).c_str());
        std::fflush(stdout);
        beyond += b.ratio > 1;
    }
    return beyond > 0;
}

/* ----------------------------------------------------------------- replay */

/* Each line: a function, and its scene.  A # begins a comment. */
int replay(const std::vector<row> &rows, const char *file)
{
    std::ifstream in(file);
    int cases = 0, beyond = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string name = line.substr(0, line.find(' '));
        scene s;
        if (name[0] == '#')
            continue;
        const auto r =
            std::find_if(rows.begin(), rows.end(),
                         [&](const row &of) { return of.function == name; });
        if (r == rows.end() || !scene_from(line.c_str() + name.size(), &s)) {
            std::fprintf(stderr, "adversary: not a case: %s\n", line.c_str());
            return 2;
        }
        const double ratio = r->law(s, NO_CLAIM);
        ++cases;
        beyond += ratio > 1;
        if (ratio > 1)
            std::printf("beyond its bound, %.3g times: %s\n", ratio,
                        line.c_str());
    }
    std::printf("%d cases replayed, %d beyond their bounds\n", cases, beyond);
    return cases == 0 || beyond > 0;
}
} // namespace

int main(int argc, char **argv)
{
    std::vector<row> rows;
    for (const auto &table : {FORMULAS, MOTIONS, EVENTS, THROWS, THICK})
        rows.insert(rows.end(), table.begin(), table.end());
    if (argc >= 6 && !std::strcmp(argv[1], "search"))
        return search_all(rows, argc, argv);
    if (argc == 3 && !std::strcmp(argv[1], "replay"))
        return replay(rows, argv[2]);
    std::fputs("usage: adversary search EVALUATIONS SEED PART PARTS "
               "[FUNCTION]\n       adversary replay FILE\n",
               stderr);
    return 2;
}
