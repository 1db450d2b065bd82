#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "shader/shader_lib.h"
#include "shader/statistics.h"

namespace macula {
namespace {

using Lib = ShaderLibTwofold;
using Point = Lib::vec2;

// Whether 2^k points lie one in each of the 2^k rectangles of every shape.
bool isNet(const std::vector<Point>& points) {
    for (std::size_t columns = 1; columns <= points.size(); columns *= 2) {
        const std::size_t rows = points.size() / columns;
        std::set<std::size_t> cells;
        for (const Point& p : points)
            cells.insert(std::size_t(p.x * double(columns)) * rows + std::size_t(p.y * double(rows)));
        if (cells.size() != points.size()) return false;
    }
    return true;
}

TEST(Net, EveryAlignedRunIsOne) {
    Lib lib;
    for (const unsigned seed : {0u, 1u, 77u, 0xffffffffu}) {
        for (const unsigned choice : {0u, 1u, 9u}) {
            for (const unsigned size : {1u, 2u, 4u, 64u, 1024u}) {
                for (const unsigned start : {0u, size, 5 * size, 0xfffffc00u}) {
                    std::vector<Point> points;
                    for (unsigned i = 0; i < size; ++i)
                        points.push_back(lib.netPoint({start + i, seed}, choice));
                    EXPECT_TRUE(isNet(points)) << seed << ' ' << choice << ' ' << size << ' ' << start;
                }
            }
        }
    }
}

// What makes an estimate unbiased: over the seeds each single point is uniform, at the ends of the index too.
TEST(Net, EachPointIsUniformOverTheSeeds) {
    Lib lib;
    constexpr int kSide = 16;
    constexpr unsigned kSeeds = 1u << 17;
    for (const unsigned index : {0u, 1u, 2u, 12345u, 0xffffffffu}) {
        for (const unsigned choice : {0u, 3u}) {
            std::vector<double> cells(kSide * kSide, 0.0);
            for (unsigned seed = 0; seed < kSeeds; ++seed) {
                const Point p = lib.netPoint({index, seed}, choice);
                ++cells[std::size_t(p.x * kSide) * kSide + std::size_t(p.y * kSide)];
            }
            const std::vector<double> expected(cells.size(), double(kSeeds) / double(cells.size()));
            EXPECT_LT(std::abs(statistics::chiSquareDeviate(cells, expected)), statistics::kDeviateLimit)
                << index << ' ' << choice;
        }
    }
}

// Two numbers, each from a stream of points, are as independent as their even marginals allow: no cell of
// their joint distribution has more than chance would give it.
void expectIndependent(const std::vector<std::pair<double, double>>& pairs, const char* what) {
    constexpr int kSide = 16;
    std::vector<double> cells(kSide * kSide, 0.0);
    for (const auto& [a, b] : pairs) ++cells[std::size_t(a * kSide) * kSide + std::size_t(b * kSide)];
    const std::vector<double> expected(cells.size(), double(pairs.size()) / double(cells.size()));
    EXPECT_LT(statistics::chiSquareDeviate(cells, expected), statistics::kDeviateLimit) << what;
}

TEST(Net, ChoicesKnowNothingOfEachOther) {
    Lib lib;
    const auto pairsOf = [&](unsigned one, unsigned other) {
        std::vector<std::pair<double, double>> pairs;
        for (unsigned seed = 0; seed < 64; ++seed) {
            for (unsigned i = 0; i < 1024; ++i)
                pairs.emplace_back(lib.netPoint({i, seed}, one).x, lib.netPoint({i, seed}, other).y);
        }
        return pairs;
    };
    expectIndependent(pairsOf(0, 1), "from where to a surface point, where to the light");
    expectIndependent(pairsOf(1, 2), "light, and on");
    expectIndependent(pairsOf(1, 3), "light, and light of the next vertex");
}

TEST(Net, AreasOfThePictureAreNets) {
    Lib lib;
    for (const unsigned edge : {1u, 2u, 4u, 8u}) {
        for (const auto& [left, top] : {std::pair{0u, 0u}, {3u, 5u}, {100u, 8u}}) {
            for (const unsigned firstSample : {0u, 4u, 4096u}) {
                std::vector<Point> points;
                for (unsigned y = 0; y < edge; ++y) {
                    for (unsigned x = 0; x < edge; ++x) {
                        for (unsigned s = 0; s < 4; ++s) {
                            const auto net =
                                lib.netOfPixel(left * edge + x, top * edge + y, firstSample + s, 11);
                            points.push_back(lib.netPoint(net, 1));
                        }
                    }
                }
                EXPECT_TRUE(isNet(points)) << edge << ' ' << left << ' ' << top << ' ' << firstSample;
            }
        }
    }
}

TEST(Net, SamplesAndNeighboursAreIndependentBeyondTheirNet) {
    Lib lib;
    std::vector<std::pair<double, double>> later;   // the same pixel, another four samples
    std::vector<std::pair<double, double>> seeds;   // another picture
    std::vector<std::pair<double, double>> beside;  // first samples of neighbours
    for (unsigned y = 0; y < 256; ++y) {
        for (unsigned x = 0; x < 256; ++x) {
            const double here = lib.netPoint(lib.netOfPixel(x, y, 0, 1), 1).x;
            later.emplace_back(here, lib.netPoint(lib.netOfPixel(x, y, 4, 1), 1).x);
            seeds.emplace_back(here, lib.netPoint(lib.netOfPixel(x, y, 0, 2), 1).x);
            beside.emplace_back(here, lib.netPoint(lib.netOfPixel(x, y + 256, 0, 1), 1).y);
        }
    }
    expectIndependent(later, "later samples");
    expectIndependent(seeds, "seeds");
    expectIndependent(beside, "far pixels");
}

// What it is for: the area under a diagonal, by four points.
TEST(Net, FourPointsAreLessNoisyThanFourDraws) {
    Lib lib;
    constexpr unsigned kPixels = 1u << 14;
    double squares = 0.0;
    for (unsigned pixel = 0; pixel < kPixels; ++pixel) {
        double below = 0.0;
        for (unsigned s = 0; s < 4; ++s) {
            const Point p = lib.netPoint(lib.netOfPixel(pixel % 128, pixel / 128, s, 5), 1);
            below += p.x + p.y < 1.0 ? 0.25 : 0.0;
        }
        squares += (below - 0.5) * (below - 0.5);
    }
    constexpr double kOfDraws = 0.25 / 4.0;
    EXPECT_LT(squares / kPixels, 0.55 * kOfDraws);
    EXPECT_GT(squares / kPixels, 0.0);
}

TEST(Net, BitsDecideAboutThoseAboveThemOnly) {
    Lib lib;
    for (unsigned seed = 0; seed < 100; ++seed) {
        for (unsigned bit = 0; bit < 32; ++bit) {
            const unsigned x = 0x9e3779b9u * (seed + 1);
            const unsigned change = lib.permutedUpwards(x, seed) ^ lib.permutedUpwards(x ^ (1u << bit), seed);
            EXPECT_EQ(change & ((1u << bit) | ((1u << bit) - 1u)), 1u << bit);
        }
    }
}

TEST(Net, IsTheSameInFloatAndDoubleAndNeverReachesOne) {
    Lib lib;
    ShaderLibSingle single;
    for (unsigned i = 0; i < 100000; ++i) {
        const Point p = lib.netPoint({i * 2654435761u, i}, i % 9);
        const auto q = single.netPoint({i * 2654435761u, i}, i % 9);
        ASSERT_EQ(p.x, double(q.x));
        ASSERT_EQ(p.y, double(q.y));
        ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
    }
}

}  // namespace
}  // namespace macula
