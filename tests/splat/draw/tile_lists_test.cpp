// Lists of tiles against a loop over splats and tiles that knows nothing of parts and cores.
#include "pipeline/splat/draw/tile_lists.h"

#include <algorithm>

#include "pipeline/splat/draw/host_projection.h"
#include "pipeline/splat/draw/reference_host.h"
#include "shared/splat_frame.h"
#include "splat/draw/reference_scenes.h"

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

TEST(TileLists, AreThoseOfAPlainLoop) {
    constexpr int kTileRows = 16;
    RasterView view = frontView({61, 47}, 14.0);
    TileLists lists;
    // Small ones are made in one part, large ones in several; the second time with what the first left.
    for (const std::size_t count : {100'000u, 500u, 0u, 40'000u}) {
        std::vector<glm::vec4> screen = screenOf(count, view);
        for (std::size_t i = 0; i < screen.size(); i += 7 * kScreenTexels)
            screen[i + 1].y = 0.0f;  // not shown
        const std::size_t splats = screen.size() / kScreenTexels;
        ASSERT_TRUE(sortIntoTiles(screen, view, {}, kTileRows, 1u << 30, lists).ok());
        ASSERT_EQ(lists.pairs.size(), splats);

        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < splats; ++i) {
            if (screen[i * kScreenTexels + 1].y > 0.0f) order.push_back(i);
        }
        std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return screen[a * kScreenTexels + 1].z < screen[b * kScreenTexels + 1].z;
        });
        reference::HostSingle host(view, {});
        ASSERT_EQ(lists.tiles, glm::ivec2(8, 3));
        std::vector<std::vector<glm::uvec2>> expected(24);
        std::uint32_t pairs = 0;
        for (const std::uint32_t splat : order) {
            const glm::vec4* t = &screen[splat * kScreenTexels];
            const reference::HostSingle::ScreenSplat s{.mean = {t[0].x, t[0].y},
                                                       .conic = {t[0].z, t[0].w, t[1].x},
                                                       .opacity = t[1].y,
                                                       .depthMm = t[1].z,
                                                       .extent = {t[1].w, t[2].w}};
            glm::ivec2 first, end;
            host.pixelsOf(s, view.sizePx, first, end);
            const std::uint32_t before = pairs;
            for (int tile = 0; tile < 24; ++tile) {
                const glm::ivec2 low = glm::ivec2(tile % 8 * 8, tile / 8 * kTileRows);
                const glm::ivec2 high = glm::min(low + glm::ivec2(8, kTileRows), view.sizePx);
                const bool touches = first.x < high.x && first.y < high.y && end.x > low.x && end.y > low.y;
                const bool inside =
                    first.x >= low.x && first.y >= low.y && end.x <= high.x && end.y <= high.y;
                if (touches && first.x < end.x && first.y < end.y &&
                    (inside || host.showsIn(s, low, high, host.frame)))
                    expected[std::size_t(tile)].emplace_back(splat, pairs++);
            }
            ASSERT_EQ(lists.pairs[splat], glm::uvec2(before, pairs - before)) << splat;
        }
        ASSERT_EQ(lists.entries.size(), pairs);
        for (std::size_t tile = 0; tile < expected.size(); ++tile) {
            const glm::uvec2 range = lists.ranges[tile];
            ASSERT_EQ(std::vector(lists.entries.begin() + range.x, lists.entries.begin() + range.y),
                      expected[tile]);
        }
        if (pairs > 0) {
            const auto tooMany = sortIntoTiles(screen, view, {}, kTileRows, pairs - 1, lists);
            ASSERT_FALSE(tooMany.ok());
            EXPECT_EQ(tooMany.error().code, ErrorCode::outOfMemory);
        }
    }
}

}  // namespace
}  // namespace macula::splat
