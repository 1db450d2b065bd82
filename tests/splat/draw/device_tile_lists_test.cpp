// Lists of tiles that the device makes: those of the host, and the same pictures and derivatives to the bit.
#include "pipeline/splat/draw/device_tile_lists.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>

#include "gpu/shared_device.h"
#include "gpu/shared_layout.h"
#include "pipeline/gpu/spirv_reflection.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/draw/radix_sort.h"
#include "pipeline/splat/draw/rasterizer.h"
#include "shaders/splat.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

using shared::SplatListState;

class RadixSortOnDevice : public gpu::SharedDeviceTest {
  protected:
    static gpu::Buffer bufferOf(const std::vector<glm::uvec2>& items) {
        gpu::Buffer buffer = std::move(*gpu::Buffer::create(
            device(), {.label = "items", .bytes = std::max<std::size_t>(items.size(), 1) * 8}));
        if (!items.empty()) {
            EXPECT_TRUE(gpu::uploadTo<glm::uvec2>(buffer, items).ok());
        }
        return buffer;
    }

    static std::vector<glm::uvec2> sorted(const std::vector<glm::uvec2>& items, int bits) {
        const RadixSort sort = std::move(*RadixSort::create(device(), items.size()));
        const gpu::Buffer from = bufferOf(items);
        const gpu::Buffer other = bufferOf(std::vector<glm::uvec2>(items.size()));
        const gpu::Buffer state = std::move(*gpu::Buffer::create(
            device(), {.label = "state",
                       .bytes = sizeof(SplatListState),
                       .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT}));
        const auto count = static_cast<std::uint32_t>(items.size());
        const std::uint32_t blocks = (count + shared::kSortBlock - 1) / shared::kSortBlock;
        const SplatListState value{.count = count, .blocks = blocks, .groups = {blocks, 1, 1}};
        EXPECT_TRUE(gpu::uploadTo<SplatListState>(state, std::span(&value, 1)).ok());
        auto recorder = std::move(*gpu::Recorder::create(device(), "sort"));
        const gpu::Buffer& result = sort.record(recorder, state, from, other, bits);
        EXPECT_TRUE(recorder.submit().ok());
        std::vector<glm::uvec2> found = *gpu::read<glm::uvec2>(result);
        found.resize(items.size());
        return found;
    }

    static std::vector<glm::uvec2> expected(std::vector<glm::uvec2> items) {
        std::stable_sort(items.begin(), items.end(),
                         [](const glm::uvec2& a, const glm::uvec2& b) { return a.x < b.x; });
        return items;
    }
};

TEST_F(RadixSortOnDevice, IsAStableSortOfAnyNumber) {
    std::mt19937 random(3);
    for (const std::uint32_t count : {0u, 1u, 2u, 255u, 1023u, 1024u, 1025u, 5000u, 131'072u, 131'073u}) {
        for (const int bits : {32, 20, 8, 3, 0}) {
            if (count > 5000 && bits != 20) continue;
            std::vector<glm::uvec2> items;
            const std::uint32_t mask = bits == 32 ? ~0u : (1u << bits) - 1u;
            for (std::uint32_t i = 0; i < count; ++i)
                items.emplace_back(static_cast<std::uint32_t>(random()) & mask, i);
            ASSERT_EQ(sorted(items, bits), expected(items)) << count << " by " << bits << " bits";
        }
    }
}

TEST_F(RadixSortOnDevice, KeysThatAreAlikeOrInOrder) {
    std::vector<glm::uvec2> items;
    for (std::uint32_t i = 0; i < 3000; ++i) items.emplace_back(0xffffffffu, i);
    EXPECT_EQ(sorted(items, 32), items);
    for (std::uint32_t i = 0; i < 3000; ++i) items[i] = {i, 2 * i};
    EXPECT_EQ(sorted(items, 32), items);
    std::reverse(items.begin(), items.end());
    EXPECT_EQ(sorted(items, 32), expected(items));
}

constexpr std::uint32_t kMostDifferentiated = 100'000;  // more take time, and show nothing new

// What one rasterizer draws and differentiates.
struct Seen {
    std::vector<glm::vec4> picture;
    std::vector<float> depths;
    std::vector<float> gradients;
    std::vector<std::uint32_t> visible;
    std::vector<shared::SplatStatistics> statistics;
    std::uint64_t pairCount = 0;
    std::vector<glm::uvec2> ranges, entries, pairs;
};

class DeviceLists : public gpu::SharedDeviceTest {
  protected:
    static std::vector<glm::uvec2> firstOf(const gpu::TexelBuffer& texels, std::size_t count) {
        std::vector<glm::uvec2> values = *gpu::read<glm::uvec2>(texels.buffer());
        EXPECT_LE(count, values.size());
        values.resize(count);
        return values;
    }

    static Seen seen(Rasterizer& rasterizer, const Splats& splats, const RasterView& view,
                     const Blending& blending) {
        Seen seen;
        const auto count = static_cast<std::uint32_t>(splats.size());
        const auto room = std::max(count, 1u);
        auto parameters = std::move(*SplatBuffer::create(device(), "parameters", room, splats.shDegree));
        EXPECT_TRUE(parameters.upload(componentsOf(splats)).ok());
        const auto drawn = rasterizer.draw(parameters, count, view, blending);
        EXPECT_TRUE(drawn.ok()) << (drawn.ok() ? Text() : drawn.error().message);
        seen.picture = *rasterizer.picture().read();
        seen.depths = *gpu::read<float>(rasterizer.depths());
        seen.depths.resize(seen.picture.size());
        seen.pairCount = drawn->pairCount();
        const TileBuffers& lists = rasterizer.tileLists();
        const glm::ivec2 tiles = (view.sizePx + glm::ivec2(7, 15)) / glm::ivec2(8, 16);
        seen.ranges = firstOf(*lists.ranges, std::size_t(tiles.x) * std::size_t(tiles.y));
        seen.entries = firstOf(*lists.entries, seen.pairCount);
        seen.pairs = count > 0 ? firstOf(lists.pairs, count) : std::vector<glm::uvec2>();
        if (count > kMostDifferentiated) return seen;

        auto gradients = std::move(*SplatBuffer::create(device(), "gradients", room, splats.shDegree));
        Dice dice(3);
        std::vector<glm::vec4> gradient(seen.picture.size());
        for (glm::vec4& g : gradient) g = glm::vec4(dice.vec3(-1, 1), dice.uniform(-1, 1));
        const auto uploaded =
            std::move(*DevicePicture::upload(device(), "gradient", view.sizePx.x, view.sizePx.y, gradient));
        auto recorder = std::move(*gpu::Recorder::create(device(), "backward"));
        rasterizer.clearStatistics(recorder);
        EXPECT_TRUE(rasterizer.recordBackward(recorder, *drawn, parameters, uploaded, gradients).ok());
        EXPECT_TRUE(recorder.submit().ok());
        seen.gradients = *gradients.download(count);
        seen.visible = *gpu::read<std::uint32_t>(rasterizer.visible());
        seen.visible.resize(count);
        seen.statistics = *gpu::read<shared::SplatStatistics>(rasterizer.statistics());
        seen.statistics.resize(count);
        return seen;
    }

    template <class T>
    static bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
        return a.size() == b.size() &&
               (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
    }

    static Rasterizer rasterizer(const Splats& splats, ListMaker lists, std::uint64_t mostPairs = 0) {
        const auto room = static_cast<std::uint32_t>(std::max<std::size_t>(splats.size(), 1));
        return std::move(*Rasterizer::create(device(), room, splats.shDegree, {16, 16, mostPairs, lists}));
    }

    // What both have drawn; the pairs.
    static std::uint64_t expectSame(const Splats& splats, const RasterView& view, const std::string& what,
                                    const Blending& blending = {}) {
        Rasterizer onHost = rasterizer(splats, ListMaker::host);
        Rasterizer onDevice = rasterizer(splats, ListMaker::device);
        EXPECT_FALSE(onHost.listsOnDevice());
        EXPECT_TRUE(onDevice.listsOnDevice());
        const Seen expected = seen(onHost, splats, view, blending);
        const Seen found = seen(onDevice, splats, view, blending);
        EXPECT_EQ(found.pairCount, expected.pairCount) << what;
        EXPECT_TRUE(sameBits(found.ranges, expected.ranges)) << what;
        EXPECT_TRUE(sameBits(found.entries, expected.entries)) << what;
        EXPECT_TRUE(sameBits(found.pairs, expected.pairs)) << what;
        EXPECT_TRUE(sameBits(found.picture, expected.picture)) << what;
        EXPECT_TRUE(sameBits(found.depths, expected.depths)) << what;
        EXPECT_TRUE(sameBits(found.visible, expected.visible)) << what;
        EXPECT_TRUE(sameBits(found.gradients, expected.gradients)) << what;
        EXPECT_TRUE(sameBits(found.statistics, expected.statistics)) << what;
        return found.pairCount;
    }

    static Splats behind(Splats splats, std::size_t every) {
        for (std::size_t i = 0; i < splats.size(); i += every) splats.position[i].y = -1000.0f;
        return splats;
    }
};

TEST_F(DeviceLists, OfRandomScenesAreThoseOfTheHost) {
    for (const int degree : {0, 1}) {
        for (const glm::ivec2 size : {glm::ivec2(61, 47), {300, 200}, {8, 16}, {1, 1}, {1000, 9}}) {
            const Splats splats = behind(singleOf(randomModel(7 + std::uint32_t(degree), 700, degree)), 5);
            expectSame(splats, frontView(size, 14.0), fmt::format("{} x {}", size.x, size.y));
        }
    }
    // Classic edges, and the eye among the splats.
    const Splats splats = singleOf(randomModel(9, 1000, 0));
    EXPECT_GT(expectSame(splats, frontView({200, 160}), "classic", blendingOf(LowPass::classic)), 1000u);
    RasterView inside = frontView({200, 160}, 60.0);
    inside.eyeMm = {0, -10, 0};
    EXPECT_GT(expectSame(splats, inside, "inside"), 5000u);
}

TEST_F(DeviceLists, OfEquallyDeepOnesAreInTheirOrder) {
    Splats splats = singleOf(randomModel(11, 3000, 0));
    for (std::size_t i = 0; i < splats.size(); ++i) splats.position[i].y = i % 3 == 0 ? 0.0f : 0.5f;
    EXPECT_GT(expectSame(splats, frontView({120, 100}), "two depths"), 3000u);
}

TEST_F(DeviceLists, OfNothing) {
    const RasterView view = frontView({40, 30});
    for (const std::size_t count : {0u, 1u, 300u}) {
        const Splats splats = behind(singleOf(emptyModel(count)), 1);
        EXPECT_EQ(expectSame(splats, view, fmt::format("{} behind the eye", count)), 0u);
    }
    EXPECT_GT(expectSame(singleOf(oneSplat(5.0)), view, "one"), 0u);
}

TEST_F(DeviceLists, OfScreenFillingOnes) {
    // All tiles of each: 50 x 40 of them.
    Splats splats = singleOf(randomModel(13, 150, 0));
    for (auto& scale : splats.logScale) scale = glm::vec3(8.0f);
    for (auto& logit : splats.opacityLogit) logit = -1.0f;
    EXPECT_EQ(expectSame(splats, frontView({400, 640}), "filling"), 150u * 50 * 40);
}

TEST_F(DeviceLists, OfAMillionTinyOnes) {
    Splats splats;
    splats.resize(1'000'000);
    Dice dice(15);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        splats.position[i] = dice.vec3(-40, 40);
        splats.logScale[i] = glm::vec3(-3.0f);
    }
    EXPECT_GT(expectSame(splats, frontView({160, 120}), "a million"), 500'000u);
}

// More pairs than there is room for at first: it is made, and the next picture needs no more.
TEST_F(DeviceLists, RoomIsMadeWhenItIsNeeded) {
    Splats splats = singleOf(randomModel(17, 40, 0));
    for (auto& scale : splats.logScale) scale = glm::vec3(7.0f);
    const RasterView view = frontView({400, 640});
    auto parameters = std::move(*SplatBuffer::create(device(), "parameters", 40, 0));
    ASSERT_TRUE(parameters.upload(componentsOf(splats)).ok());
    Rasterizer onDevice = rasterizer(splats, ListMaker::device);
    RasterPass pass;
    const auto record = [&] {
        auto recorder = std::move(*gpu::Recorder::create(device(), "draw"));
        pass = *onDevice.recordDraw(recorder, parameters, 40, view, {});
        EXPECT_TRUE(recorder.submit().ok());
        return onDevice.settle(pass);
    };
    Result<bool> settled = record();
    ASSERT_TRUE(settled.ok());
    EXPECT_FALSE(*settled);
    const std::vector<glm::vec4> empty = *onDevice.picture().read();
    for (const glm::vec4& pixel : empty) ASSERT_EQ(pixel, glm::vec4(0.0f));
    const std::vector<glm::uvec2> none = firstOf(onDevice.tileLists().pairs, 40);
    for (const glm::uvec2& pair : none) ASSERT_EQ(pair.y, 0u);
    settled = record();
    ASSERT_TRUE(settled.ok());
    EXPECT_TRUE(*settled);
    EXPECT_EQ(pass.pairCount(), 40u * 50 * 40);
    Rasterizer onHost = rasterizer(splats, ListMaker::host);
    ASSERT_TRUE(onHost.draw(parameters, 40, view, {}).ok());
    EXPECT_EQ(*onDevice.picture().read(), *onHost.picture().read());
}

TEST_F(DeviceLists, TooManyIsAnErrorAndTheNextPictureIsRight) {
    const Splats many = singleOf(randomModel(19, 500, 0));
    const RasterView view = frontView({200, 160});
    auto parameters = std::move(*SplatBuffer::create(device(), "parameters", 500, 0));
    ASSERT_TRUE(parameters.upload(componentsOf(many)).ok());
    Rasterizer few = rasterizer(many, ListMaker::device, 50);
    const Result<RasterPass> tooMany = few.draw(parameters, 500, view, {});
    ASSERT_FALSE(tooMany.ok());
    EXPECT_EQ(tooMany.error().code, ErrorCode::outOfMemory);
    ASSERT_TRUE(few.draw(parameters, 1, view, {}).ok());
    Rasterizer onHost = rasterizer(many, ListMaker::host);
    ASSERT_TRUE(onHost.draw(parameters, 1, view, {}).ok());
    EXPECT_EQ(*few.picture().read(), *onHost.picture().read());
}

TEST(DeviceListsLayout, IsThatOfTheKernels) {
    for (const auto& [code, binding] : {std::pair{shaders::splat_sort_count_comp, 0u},
                                        {shaders::splat_sort_scan_comp, 0u},
                                        {shaders::splat_sort_scatter_comp, 0u},
                                        {shaders::splat_tile_entries_comp, 0u},
                                        {shaders::splat_tile_starts_comp, 1u},
                                        {shaders::splat_tile_ranges_comp, 1u},
                                        {shaders::splat_tile_emit_comp, 5u}}) {
        const auto reflection = gpu::reflectSpirv(code.words);
        ASSERT_TRUE(reflection.ok());
        const auto* state = reflection->bindings.at(binding).block.find("state");
        ASSERT_NE(state, nullptr) << code.name;
        expectLayoutMatches<SplatListState>(
            *state, {MACULA_FIELD(SplatListState, count), MACULA_FIELD(SplatListState, blocks),
                     MACULA_FIELD(SplatListState, groups), MACULA_FIELD(SplatListState, wanted),
                     MACULA_FIELD(SplatListState, capacity)});
    }
}

}  // namespace
}  // namespace macula::splat
