// Runs the native kernels of pictures without a device.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "pipeline/splat/draw/host_projection.h"
#include "pipeline/splat/draw/tile_lists.h"
#include "pipeline/splat/native/native_raster.h"
#include "pipeline/splat/native/native_raster_back.h"
#include "shared/splat_frame.h"
#include "splat/draw/reference_scenes.h"
#include "splat/instruction_sets.h"

namespace macula::splat {

template <class T>
void bindTo(gpu::NativeDispatch& dispatch, std::uint32_t number, std::vector<T>& values) {
    dispatch.bind(number, std::as_writable_bytes(std::span(values)));
}

// What a device has after the splats are projected and sorted.
struct NativeScene {
    NativeScene(const Splats& splats, const RasterView& view, const Blending& blending, int tileRows = 16)
        : screen(projectOnHost(splats, view, blending)) {
        EXPECT_TRUE(sortIntoTiles(screen, view, blending, tileRows, 1u << 30, lists).ok());
        frame.front() = {.view = splatView(view, blending),
                         .count = static_cast<std::uint32_t>(screen.size() / shared::kScreenTexels),
                         .capacity = 0,
                         .tiles = lists.tiles,
                         .tileRows = tileRows};
        const std::size_t pixels = std::size_t(view.sizePx.x) * std::size_t(view.sizePx.y);
        picture.assign(pixels, glm::vec4(7.0f));
        depths.assign(pixels, 7.0f);
        if (screen.empty()) screen.resize(shared::kScreenTexels);
    }

    gpu::NativeDispatch dispatch() {
        gpu::NativeDispatch result(
            {static_cast<std::uint32_t>(lists.tiles.x), static_cast<std::uint32_t>(lists.tiles.y), 1}, {});
        bindTo(result, 0, frame);
        bindTo(result, 1, screen);
        bindTo(result, 2, lists.ranges);
        bindTo(result, 3, lists.entries);
        bindTo(result, 4, picture);
        return result;
    }

    // Fills `picture` and `depths`.
    void draw() {
        gpu::NativeDispatch drawn = dispatch();
        bindTo(drawn, 5, depths);
        nativeRaster()(drawn);
    }

    // The sums of all pairs, slot by slot.
    std::vector<float> drawBack(std::vector<glm::vec4>& gradient, const BackSlots& slots) {
        std::vector<float> pairs(lists.entries.size() * std::size_t(slots.slots * shared::kPairValues) + 1,
                                 7.0f);
        gpu::NativeDispatch drawn = dispatch();
        bindTo(drawn, 5, gradient);
        bindTo(drawn, 6, pairs);
        nativeRasterBack(slots)(drawn);
        EXPECT_EQ(pairs.back(), 7.0f);  // nothing behind them
        pairs.pop_back();
        return pairs;
    }

    std::vector<shared::SplatFrame> frame = std::vector<shared::SplatFrame>(1);
    std::vector<glm::vec4> screen;
    TileLists lists;
    std::vector<glm::vec4> picture;
    std::vector<float> depths;
};

// A scene for what is not about one kind of splats.
struct NativeCase {
    glm::ivec2 sizePx;
    int tileRows;
    std::size_t splats;
};
inline constexpr std::array<NativeCase, 6> kNativeCases{{{{61, 47}, 16, 300},
                                                         {{64, 48}, 16, 300},
                                                         {{61, 47}, 8, 100},
                                                         {{20, 9}, 5, 100},
                                                         {{1, 1}, 16, 40},
                                                         {{20, 9}, 16, 0}}};
inline RasterView nativeViewOf(const NativeCase& c) {
    return frontView(c.sizePx, 14.0);
}

}  // namespace macula::splat
