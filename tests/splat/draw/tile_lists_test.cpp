// Lists of tiles against a loop over splats and tiles that knows nothing of parts and cores.
#include "pipeline/splat/draw/tile_lists.h"

#include <algorithm>

#include "pipeline/splat/draw/host_projection.h"
#include "pipeline/splat/draw/reference_host.h"
#include "shared/splat_frame.h"
#include "splat/draw/reference_scenes.h"
#include "splat/instruction_sets.h"

namespace macula::splat {
namespace {

using shared::kScreenTexels;

// Some equally deep.
std::vector<glm::vec4> screenOf(std::size_t count, const RasterView& view) {
    Dice dice(21);
    Splats splats;
    splats.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        splats.position[i] = dice.vec3(-40, 40);
        splats.position[i].y = std::round(splats.position[i].y * 64.0f) / 64.0f;
        splats.logScale[i] = dice.vec3(-2, 0.5);
        splats.rotation[i] = dice.quaternion();
    }
    return projectOnHost(splats, view, {});
}

// What sortIntoTiles must give for 8 x 3 tiles.
struct PlainLists {
    std::vector<std::vector<glm::uvec2>> entries = std::vector<std::vector<glm::uvec2>>(24);
    std::vector<glm::uvec2> pairs;
    std::uint32_t count = 0;
};

PlainLists plainLists(const std::vector<glm::vec4>& screen, const RasterView& view, int tileRows) {
    const auto splats = static_cast<std::uint32_t>(screen.size() / kScreenTexels);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < splats; ++i) {
        if (screen[i * kScreenTexels + 1].y > 0.0f) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return screen[a * kScreenTexels + 1].z < screen[b * kScreenTexels + 1].z;
    });
    reference::HostSingle host(view, {});
    PlainLists lists;
    lists.pairs.assign(splats, glm::uvec2(0));
    for (const std::uint32_t splat : order) {
        const glm::vec4* t = &screen[splat * kScreenTexels];
        const reference::HostSingle::ScreenSplat s{.mean = {t[0].x, t[0].y},
                                                   .conic = {t[0].z, t[0].w, t[1].x},
                                                   .opacity = t[1].y,
                                                   .depthMm = t[1].z,
                                                   .extent = {t[1].w, t[2].w}};
        glm::ivec2 first, end;
        host.pixelsOf(s, view.sizePx, first, end);
        const std::uint32_t before = lists.count;
        for (int tile = 0; tile < 24; ++tile) {
            const glm::ivec2 low = glm::ivec2(tile % 8 * 8, tile / 8 * tileRows);
            const glm::ivec2 high = glm::min(low + glm::ivec2(8, tileRows), view.sizePx);
            const bool touches = first.x < high.x && first.y < high.y && end.x > low.x && end.y > low.y;
            const bool inside = first.x >= low.x && first.y >= low.y && end.x <= high.x && end.y <= high.y;
            if (touches && first.x < end.x && first.y < end.y &&
                (inside || host.showsIn(s, low, high, host.frame)))
                lists.entries[std::size_t(tile)].emplace_back(splat, lists.count++);
        }
        lists.pairs[splat] = glm::uvec2(before, lists.count - before);
    }
    return lists;
}

void expectPlainLists(const TileLists& lists, const PlainLists& expected) {
    ASSERT_EQ(lists.tiles, glm::ivec2(8, 3));
    ASSERT_EQ(lists.entries.size(), expected.count);
    ASSERT_EQ(lists.pairs, expected.pairs);
    for (std::size_t tile = 0; tile < expected.entries.size(); ++tile) {
        const glm::uvec2 range = lists.ranges[tile];
        ASSERT_EQ(std::vector(lists.entries.begin() + range.x, lists.entries.begin() + range.y),
                  expected.entries[tile]);
    }
}

TEST(TileLists, AreThoseOfAPlainLoop) {
    constexpr int kTileRows = 16;
    RasterView view = frontView({61, 47}, 14.0);
    TileLists lists;
    // Small ones are made in one part, large ones in several; the second time with what the first left.
    for (const std::size_t count : {100'000u, 500u, 0u, 40'000u}) {
        std::vector<glm::vec4> screen = screenOf(count, view);
        for (std::size_t i = 0; i < screen.size(); i += 7 * kScreenTexels)
            screen[i + 1].y = 0.0f;  // not shown
        const PlainLists expected = plainLists(screen, view, kTileRows);
        onEachInstructionSet([&] {
            ASSERT_TRUE(sortIntoTiles(screen, view, {}, kTileRows, 1u << 30, lists).ok());
            expectPlainLists(lists, expected);
        });
        if (expected.count > 0) {
            const auto tooMany = sortIntoTiles(screen, view, {}, kTileRows, expected.count - 1, lists);
            ASSERT_FALSE(tooMany.ok());
            EXPECT_EQ(tooMany.error().code, ErrorCode::outOfMemory);
        }
    }
}

// Many tiles, of which there are several vectors.
TEST(TileLists, ALargeSplatShowsInAllTilesThatItTouches) {
    const RasterView view = frontView({16 * 61, 1}, 0.2);
    TileLists lists;
    onEachInstructionSet([&] {
        const std::vector<glm::vec4> screen{
            {488.0f, 0.5f, 1e-6f, 0.0f}, {1.0f, 0.9f, 1.0f, 1e4f}, {1, 1, 1, 3.0f}};
        ASSERT_TRUE(sortIntoTiles(screen, view, {}, 16, 1u << 30, lists).ok());
        ASSERT_EQ(lists.entries.size(), 122u);
        for (std::uint32_t n = 0; n < 122; ++n) ASSERT_EQ(lists.entries[n], glm::uvec2(0, n));
        EXPECT_EQ(lists.pairs.front(), glm::uvec2(0, 122));
    });
}

}  // namespace
}  // namespace macula::splat
