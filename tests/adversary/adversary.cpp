/* SPDX-License-Identifier: MIT */
/* The directed search: climbs towards the largest unwarned error in parts of
 * the documented bound, from many starts, for every public function.
 *     adversary search EVALUATIONS SEED PART PARTS [FUNCTION]
 *     adversary replay FILE
 * Equal arguments do equal work and print equal lines. */
#include "row.hpp"

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace
{
/* A climb begins where there is a claim.  One that has not risen by this factor
 * in so many evaluations ends: next to a smooth maximum it would rise a little
 * for ever. */
constexpr double RISE = 1.001;
constexpr long PATIENCE = 300;

/* ----------------------------------------------------------------- chance */

struct chance {
    uint64_t state;

    double next() /* splitmix64, in [0, 1) */
    {
        uint64_t z = state += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    int below(int n)
    {
        return int(next() * n);
    }
};

genome anywhere(chance *c)
{
    genome g;
    for (double &gene : g)
        gene = c->next();
    return g;
}

/* One to three genes moved, by 1e-16 to 1 of their range, or drawn anew. */
genome beside(const genome &from, chance *c)
{
    genome g = from;
    for (int k = 1 + c->below(3); k > 0; --k) {
        double &gene = g[size_t(c->below(GENES))];
        const double size = std::pow(10, -16 * c->next());
        gene += size * (2 * c->next() - 1);
        if (c->next() < 0.15 || !(gene >= 0 && gene < 1))
            gene = c->next();
    }
    return g;
}

/* ----------------------------------------------------------------- search */

struct best {
    double ratio = NO_CLAIM;
    scene at = {};
};

scene made(const row &r, const genome &g)
{
    scene s = scene_of(g, r.narrow);
    if (r.edge)
        r.edge(&s, g.data(), r.kind);
    return s;
}

/* The quick truth errs by a thousandth of a double's rounding: the top of a
 * climb, where it matters, is looked at again. */
constexpr double MATTERS = 0.3;
void confirm(const row &r, const best &top, best *b)
{
    if (!(top.ratio > b->ratio))
        return;
    const double ratio =
        top.ratio > MATTERS ? r.exact(top.at, r.kind, NO_CLAIM) : top.ratio;
    if (ratio > b->ratio)
        *b = {ratio, top.at};
}

best search(const row &r, long evaluations, uint64_t seed)
{
    chance c = {seed};
    best found, top;
    genome at = {};
    double mark = 0; /* the ratio at the last rise */
    long since = 0;
    for (long i = 0; i < evaluations; ++i) {
        const bool anew = since >= PATIENCE || top.ratio == NO_CLAIM;
        if (anew) {
            confirm(r, top, &found);
            top = best();
            mark = 0;
        }
        const genome g = anew ? anywhere(&c) : beside(at, &c);
        const scene s = made(r, g);
        const double ratio = r.quick(s, r.kind, top.ratio);
        const bool rises = ratio > RISE * mark;
        since = anew || rises ? 0 : since + 1;
        mark = rises ? ratio : mark;
        if (anew || ratio >= top.ratio) {
            top = {ratio, s};
            at = g;
        }
    }
    confirm(r, top, &found);
    return found;
}

void print(const row &r, long evaluations, const best &b)
{
    std::printf("%s,%ld,%.3g,%s,%s\n", r.function, evaluations, b.ratio,
                r.bound, text_of(b.at).c_str());
    std::fflush(stdout);
}

uint64_t seed_of(const row &r, uint64_t seed)
{
    for (const char *c = r.function; *c; ++c)
        seed = seed * 1099511628211u + uint64_t(*c);
    return seed;
}

bool wanted(const row &r, const char *pattern)
{
    return !pattern || std::strstr(r.function, pattern);
}

/* A long search asks every function equally often. */
constexpr long LONG = 1000000;
long evaluations_of(const row &r, long most)
{
    return most / (most < LONG ? r.share : 1);
}

/* Every row once in parts: its evaluations, by its own seed. */
int search_all(const std::vector<row> &rows, int argc, char **argv)
{
    const long evaluations = std::atol(argv[2]);
    const uint64_t seed = std::strtoull(argv[3], nullptr, 10);
    const int part = std::atoi(argv[4]), parts = std::atoi(argv[5]);
    const char *pattern = argc > 6 ? argv[6] : nullptr;
    int beyond = 0;
    for (size_t i = 0; i < rows.size(); ++i) {
        const row &r = rows[i];
        const long n = evaluations_of(r, evaluations);
        if (int(i) % parts != part || !wanted(r, pattern))
            continue;
        const best b = search(r, n, seed_of(r, seed));
        print(r, n, b);
        beyond += b.ratio > 1;
    }
    return beyond > 0;
}

/* ----------------------------------------------------------------- replay */

const row *row_named(const std::vector<row> &rows, const char *name)
{
    for (const row &r : rows)
        if (!std::strcmp(r.function, name))
            return &r;
    return nullptr;
}

/* Each line: a function, and its scene.  A # begins a comment. */
int replay(const std::vector<row> &rows, const char *file)
{
    std::FILE *in = std::fopen(file, "r");
    char line[2048], name[64];
    int cases = 0, beyond = 0;
    while (in && std::fgets(line, sizeof line, in)) {
        scene s;
        int end = 0;
        if (line[0] == '#' || std::sscanf(line, "%63s%n", name, &end) != 1)
            continue;
        const row *r = row_named(rows, name);
        if (!r || !scene_from(line + end, &s)) {
            std::fprintf(stderr, "adversary: not a case: %s", line);
            return 2;
        }
        const double ratio = r->exact(s, r->kind, NO_CLAIM);
        ++cases;
        beyond += ratio > 1;
        if (ratio > 1)
            std::printf("beyond its bound, %.3g times: %s", ratio, line);
    }
    if (in)
        std::fclose(in);
    std::printf("%d cases replayed, %d beyond their bounds\n", cases, beyond);
    return cases == 0 || beyond > 0;
}
} // namespace

int main(int argc, char **argv)
{
    std::vector<row> rows;
    for (const auto &of :
         {observables, exact_motions, steps, rolling_motions, slips, throws}) {
        const std::vector<row> some = of();
        rows.insert(rows.end(), some.begin(), some.end());
    }
    if (argc >= 6 && !std::strcmp(argv[1], "search"))
        return search_all(rows, argc, argv);
    if (argc == 3 && !std::strcmp(argv[1], "replay"))
        return replay(rows, argv[2]);
    std::fputs("usage: adversary search EVALUATIONS SEED PART PARTS "
               "[FUNCTION]\n       adversary replay FILE\n",
               stderr);
    return 2;
}
