// Voxels on the device: all that is seen, no more, and coarsely when there is no room.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "base/parallel.h"
#include "base/phantom.h"
#include "pipeline/gpu/kernel.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/reference_tracer.h"
#include "pipeline/trace/scene_view.h"
#include "shaders/test_trace.h"
#include "trace/gpu_scene.h"
#include "trace/scenes.h"

namespace macula::trace {
namespace {

constexpr std::uint64_t kSlotBytes = kSlotValues * sizeof(std::uint16_t);

using Sparse = DeviceTest;

// Visible between two values.
TransferFunction band(double low, double high) {
    TransferFunction function = scenes::homogeneous(0.1);
    function.opacity = {{low, 0.0}, {low, 0.1}, {high, 0.4}, {high, 0.0}};
    return function;
}

View viewOf(const Volume& volume, int size) {
    return {
        .camera = frameBox(volume.worldBox(), ViewDirection::left, 30, 1.0), .width = size, .height = size};
}

PathTracer tracerWith(const std::shared_ptr<gpu::Device>& device, const std::shared_ptr<const Volume>& volume,
                      const MemoryLimits& limits, int size) {
    auto made = PathTracer::create(device, limits);
    PathTracer result = std::move(made).value();
    EXPECT_TRUE(result.scene().setVolume(volume).ok());
    EXPECT_TRUE(result.scene().setEnvironment(Environment::constant(glm::vec3(1.0f))).ok());
    EXPECT_TRUE(result.setView(viewOf(*volume, size)).ok());
    return result;
}

std::vector<glm::vec4> pictureOf(PathTracer& tracer, std::uint32_t samples) {
    EXPECT_TRUE(*tracer.trace(samples));
    return tracer.readback()->radiance;
}

// The volume as it is when its blocks are kept at these levels, by averages of our own.
std::shared_ptr<const Volume> coarsened(const Volume& volume, const BrickGrid& grid,
                                        std::span<const std::uint8_t> levels) {
    return scenes::volumeOf(volume.size(), volume.worldFromVoxel(), [&](int i, int j, int k) {
        const std::uint8_t level = levels[grid.blockIndex(i / 8, j / 8, k / 8)];
        if (level == 0 || level == kAbsent) return volume.stored(i, j, k);
        const int edge = 1 << level;
        const glm::ivec3 low = glm::ivec3(i, j, k) / edge * edge;
        const glm::ivec3 end = glm::min(low + edge, volume.size());
        double sum = 0.0;
        double count = 0.0;
        for (int c = low.z; c < end.z; ++c) {
            for (int b = low.y; b < end.y; ++b) {
                for (int a = low.x; a < end.x; ++a, ++count) sum += volume.stored(a, b, c);
            }
        }
        return static_cast<std::uint16_t>(std::floor(sum / count + 0.5));
    });
}

// Every voxel as the shaders read it.
void expectFound(const std::shared_ptr<gpu::Device>& device, const std::shared_ptr<const Volume>& volume,
                 const TransferFunction& function, const MemoryLimits& limits) {
    auto made = SceneView::create(std::make_shared<DeviceScene>(device, limits));
    SceneView view = std::move(made).value();
    DeviceScene& scene = view.scene();
    ASSERT_TRUE(scene.setVolume(volume).ok());
    ASSERT_TRUE(scene.setTransferFunction(function).ok());
    ASSERT_TRUE(scene.setEnvironment(Environment::constant(glm::vec3(1.0f))).ok());
    ASSERT_TRUE(view.look(viewOf(*volume, 8), {}).ok());
    const auto kernel = gpu::Kernel::create(
        device, shaders::fetch_comp,
        {.specializations = {{"kPoolViews", scene.poolViews()}, {"kPoolViewShift", scene.poolViewShift()}}});
    ASSERT_TRUE(kernel.ok());
    const std::size_t count = volume->voxelCount();
    const auto found = gpu::Buffer::create(device, {.label = "found", .bytes = count * sizeof(glm::vec2)});
    auto recorder = gpu::Recorder::create(device, "fetch");
    std::vector<gpu::Binding> bindings = view.bindings();
    bindings.emplace_back(*found);
    recorder->dispatch(*kernel, {static_cast<std::uint32_t>(count)}, bindings);
    ASSERT_TRUE(recorder->submit().ok());
    const auto values = gpu::read<glm::vec2>(*found);
    ASSERT_TRUE(values.ok());

    const BrickGrid grid = makeBrickGrid(*volume);
    const EntryMap map = entryMapOf(*volume);
    const Medium medium = makeMedium(*volume, grid, function);
    const auto show = blocksToShow(grid, medium.bounds);
    const Coarsening plan =
        fitBlocks(grid, show, medium.extinctionPerMm,
                  std::min({limits.voxelBytes / kSlotBytes, kMostPoolViews * limits.viewValues / kSlotValues,
                            std::uint64_t{1} << 30}));
    EXPECT_EQ(scene.voxelMemory().coarseBlocks, plan.coarse);
    EXPECT_EQ(scene.messages().size(), plan.coarse > 0 ? 1u : 0u);
    const auto expected = coarsened(*volume, grid, plan.levels);
    for (std::size_t i = 0; i < count; ++i) {
        const auto x = int(i % std::size_t(volume->size().x));
        const auto y = int(i / std::size_t(volume->size().x) % std::size_t(volume->size().y));
        const auto z = int(i / std::size_t(volume->size().x) / std::size_t(volume->size().y));
        const std::size_t block = grid.blockIndex(x / 8, y / 8, z / 8);
        const int entry = show[block] ? map.entryOf(expected->voxels()[i]) : grid.blockRanges[block].low;
        ASSERT_EQ((*values)[i].x, float(entry))
            << x << " " << y << " " << z << " level " << int(plan.levels[block]);
        ASSERT_EQ((*values)[i].y, 0.0f) << x << " " << y << " " << z;
    }
}

TEST_F(Sparse, EveryVoxelIsFoundAtEveryLevelOnEveryKindOfDevice) {
    std::mt19937 random(8);
    const auto card = *gpu::Device::create(instance(), {.separateMemory = true});
    for (const glm::ivec3 size : {glm::ivec3(1, 1, 1), {8, 8, 8}, {7, 8, 9}, {16, 40, 24}, {45, 17, 31}}) {
        const auto volume = scenes::volumeOf(size, glm::dmat4(1.0), [&](int i, int j, int) {
            return static_cast<std::uint16_t>(1000 * (i / 8) + 300 * (j / 8) + int(random() % 250));
        });
        const double most = volume->storedRange().high + 1.0;
        for (const auto& on : {device(), card}) {
            expectFound(on, volume, band(-1, most), {});            // all
            expectFound(on, volume, band(2000, 2400), {});          // some
            expectFound(on, volume, band(most + 1, most + 2), {});  // nothing
            // In views of so many blocks, as large volumes have them; few are coarse, of 16 all are whole.
            for (const std::uint64_t slots : {1, 2, 4, 16})
                expectFound(on, volume, band(2000, 2400), {.viewValues = slots * kSlotValues});
            for (const std::uint64_t slots : {7, 2, 1, 0})
                expectFound(on, volume, band(-1, most), {.voxelBytes = slots * kSlotBytes + 100});
        }
    }
}

// Values by distance from the middle, so that a band is a shell; never two alike within a block, but in the
// first `zeros` voxels of each axis.
std::shared_ptr<const Volume> onion(int edge, int zeros = 0) {
    return scenes::volumeOf(glm::ivec3(edge), glm::dmat4(1.0), [&](int i, int j, int k) {
        if (std::max({i, j, k}) < zeros) return std::uint16_t(0);
        const double r = std::hypot(i - 0.5 * edge, j - 0.5 * edge, k - 0.5 * edge);
        return static_cast<std::uint16_t>(100.0 * r + (i + j + k) % 3);
    });
}

// The whole volume on the device, or only what is visible: the same picture, bit for bit.
TEST_F(Sparse, WhatIsNotUploadedIsNotMissed) {
    const auto volume = onion(72);
    for (const Filter filter : kFilters) {
        PathTracer all = tracerWith(device(), volume, {}, 48);
        PathTracer few = tracerWith(device(), volume, {}, 48);
        ASSERT_TRUE(all.setSettings({.filter = filter}).ok());
        ASSERT_TRUE(few.setSettings({.filter = filter}).ok());
        ASSERT_TRUE(all.scene().setTransferFunction(band(0, 9000)).ok());
        EXPECT_EQ(all.statistics()->voxels.poolBytes, 729 * kSlotBytes);
        ASSERT_TRUE(all.scene().setTransferFunction(band(1500, 1700)).ok());
        EXPECT_EQ(all.statistics()->voxels.uploadedBytes, 0u);
        ASSERT_TRUE(few.scene().setTransferFunction(band(1500, 1700)).ok());
        EXPECT_LT(few.statistics()->voxels.poolBytes, 400 * kSlotBytes);
        EXPECT_EQ(pictureOf(all, 8), pictureOf(few, 8));
    }
}

// Nor are the voxels that tell the normals of surfaces.
TEST_F(Sparse, SurfacesAreTheSameWhereLittleIsUploaded) {
    const auto volume = onion(72);
    const auto wet = [](double low, double high) {
        TransferFunction function = band(low, high);
        function.surface = {.weight = 1.0, .gradientPerMm = 10.0};
        return function;
    };
    for (const Filter filter : kFilters) {
        PathTracer all = tracerWith(device(), volume, {}, 48);
        PathTracer few = tracerWith(device(), volume, {}, 48);
        ASSERT_TRUE(all.setSettings({.filter = filter}).ok());
        ASSERT_TRUE(few.setSettings({.filter = filter}).ok());
        ASSERT_TRUE(all.scene().setTransferFunction(wet(0, 9000)).ok());
        ASSERT_TRUE(all.scene().setTransferFunction(wet(1500, 1700)).ok());
        ASSERT_TRUE(few.scene().setTransferFunction(wet(1500, 1700)).ok());
        const auto picture = pictureOf(few, 8);
        EXPECT_EQ(pictureOf(all, 8), picture);
        EXPECT_LT(few.statistics()->voxels.poolBytes, 729 * kSlotBytes);
        ASSERT_TRUE(few.scene().setTransferFunction(band(1500, 1700)).ok());
        EXPECT_NE(pictureOf(few, 8), picture) << "a surface must show";
    }
}

// What was drawn before with a filter that reaches further does not change a picture.
TEST_F(Sparse, APictureIsTheSameAfterASmoothOne) {
    const auto volume = onion(72);
    PathTracer fresh = tracerWith(device(), volume, {}, 48);
    ASSERT_TRUE(fresh.scene().setTransferFunction(band(1500, 1700)).ok());
    PathTracer used = tracerWith(device(), volume, {}, 48);
    ASSERT_TRUE(used.scene().setTransferFunction(band(1500, 1700)).ok());
    ASSERT_TRUE(used.setSettings({.filter = Filter::smooth}).ok());
    const auto smooth = pictureOf(used, 8);
    ASSERT_TRUE(used.setSettings({}).ok());
    const auto again = pictureOf(used, 8);
    EXPECT_NE(again, smooth);
    EXPECT_EQ(again, pictureOf(fresh, 8));
}

TEST_F(Sparse, OnlyTheDifferenceIsUploaded) {
    const auto volume = onion(72);
    const BrickGrid grid = makeBrickGrid(*volume);
    const auto shown = [&](const TransferFunction& function) {
        return blocksToShow(grid, makeMedium(*volume, grid, function).bounds);
    };
    const TransferFunction inner = band(1000, 1200);
    const TransferFunction outer = band(1150, 2600);
    const auto a = shown(inner);
    const auto b = shown(outer);
    std::uint64_t inA = 0;
    std::uint64_t onlyInB = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        inA += a[i];
        onlyInB += b[i] && !a[i];
    }
    ASSERT_GT(onlyInB, 50u);
    PathTracer t = tracerWith(device(), volume, {}, 32);
    ASSERT_TRUE(t.scene().setTransferFunction(inner).ok());
    EXPECT_EQ(t.statistics()->voxels.uploadedBlocks, inA);
    EXPECT_EQ(t.statistics()->voxels.uploadedBytes, inA * kSlotBytes);
    EXPECT_EQ(t.statistics()->voxels.poolBytes, inA * kSlotBytes);
    ASSERT_TRUE(t.scene().setTransferFunction(outer).ok());
    EXPECT_EQ(t.statistics()->voxels.uploadedBytes, onlyInB * kSlotBytes);
    for (const TransferFunction& again : {inner, outer, inner}) {  // was there, and is still
        ASSERT_TRUE(t.scene().setTransferFunction(again).ok());
        EXPECT_EQ(t.statistics()->voxels.uploadedBytes, 0u);
    }
    TransferFunction colours = inner;
    colours.colour = {{0.0, {1, 0.2, 0.1}}};
    ASSERT_TRUE(t.scene().setTransferFunction(colours).ok());
    EXPECT_EQ(t.statistics()->voxels.uploadedBytes, 0u);
    // A clip hides bricks like a curve does.
    ASSERT_TRUE(t.scene().setTransferFunction(band(0, 9000)).ok());
    ASSERT_TRUE(t.scene().setClip({.planes = {{{1, 0, 0}, 36.0}}}).ok());
    EXPECT_EQ(t.statistics()->voxels.uploadedBytes, 0u);
    EXPECT_LT(t.statistics()->voxels.shownBlocks, 600u);
    PathTracer clipped = tracerWith(device(), volume, {}, 32);
    ASSERT_TRUE(clipped.scene().setClip({.planes = {{{1, 0, 0}, 36.0}}}).ok());
    ASSERT_TRUE(clipped.scene().setTransferFunction(band(0, 9000)).ok());
    EXPECT_EQ(clipped.statistics()->voxels.uploadedBlocks, t.statistics()->voxels.shownBlocks);
    EXPECT_EQ(pictureOf(clipped, 4), pictureOf(t, 4));
}

// Too little room for both of two looks: what is not visible goes, and every picture is that of a fresh
// tracer.
TEST_F(Sparse, WhatIsHiddenMakesRoom) {
    const auto volume = onion(72);
    const TransferFunction looks[] = {band(1000, 1200), band(2000, 2200), band(2900, 3100), band(1000, 2000)};
    std::uint64_t most = 0;
    std::vector<std::vector<glm::vec4>> expected;
    for (const TransferFunction& look : looks) {
        PathTracer fresh = tracerWith(device(), volume, {}, 32);
        ASSERT_TRUE(fresh.scene().setTransferFunction(look).ok());
        most = std::max(most, fresh.statistics()->voxels.poolBytes);
        expected.push_back(pictureOf(fresh, 4));
    }
    PathTracer t = tracerWith(device(), volume, {.voxelBytes = most}, 32);
    std::mt19937 random(9);
    for (int turn = 0; turn < 12; ++turn) {
        const std::size_t look = random() % std::size(looks);
        ASSERT_TRUE(t.scene().setTransferFunction(looks[look]).ok());
        EXPECT_LE(t.statistics()->voxels.poolBytes, most);
        EXPECT_TRUE(t.statistics()->messages.empty());
        EXPECT_EQ(pictureOf(t, 4), expected[look]) << turn;
    }
}

// A pool in several views shows the same bits as in one, in every look, and grows and shrinks likewise.
TEST_F(Sparse, SeveralViewsOfThePoolShowWhatOneShows) {
    const auto volume = onion(40);
    for (const Look look : {Look::cinematic, Look::clear, Look::dvr, Look::mip, Look::average}) {
        PathTracer whole = tracerWith(device(), volume, {}, 32);
        // 4 x 2^15 values are room for all 125 blocks.
        PathTracer parts = tracerWith(device(), volume, {.viewValues = std::uint64_t{1} << 15}, 32);
        for (PathTracer* t : {&whole, &parts}) ASSERT_TRUE(t->setSettings({.look = look}).ok());
        for (const TransferFunction& function : {band(-1, 400), band(-1, 4000), band(1000, 1200)}) {
            for (PathTracer* t : {&whole, &parts}) ASSERT_TRUE(t->scene().setTransferFunction(function).ok());
            EXPECT_EQ(pictureOf(parts, 2), pictureOf(whole, 2)) << int(look);
            if (function.opacity.back().value == 4000 || look == Look::mip) {
                EXPECT_GT(parts.statistics()->voxels.poolBytes, 2u << 15) << "several views";
            }
            EXPECT_TRUE(parts.statistics()->messages.empty());
        }
    }
}

// The sentence says which limit it was.
TEST_F(Sparse, WhatBoundThePoolIsTold) {
    const auto volume = onion(72);  // 729 blocks
    const auto adviceWith = [&](const MemoryLimits& limits) {
        PathTracer t = tracerWith(device(), volume, limits, 16);
        EXPECT_TRUE(t.scene().setTransferFunction(band(-1, 5000)).ok());
        const auto messages = t.statistics()->messages;
        return messages.size() == 1 ? messages.front().action.english() : std::string();
    };
    EXPECT_NE(adviceWith({.voxelBytes = 20 * kSlotBytes}).find("allow more memory for voxels"),
              std::string::npos);
    EXPECT_NE(adviceWith({.viewValues = 16 * kSlotValues}).find("buffers hold no more"), std::string::npos);
    EXPECT_EQ(adviceWith({}), "");
}

TEST_F(Sparse, NothingVisibleUploadsNothingAndShowsNothing) {
    const auto volume = onion(72);
    PathTracer t = tracerWith(device(), volume, {}, 16);
    ASSERT_TRUE(t.scene().setTransferFunction(band(60000, 60001)).ok());
    const VoxelMemory memory = t.statistics()->voxels;
    EXPECT_EQ(memory.visibleBricks, 0u);
    EXPECT_EQ(memory.shownBlocks, 0u);
    EXPECT_EQ(memory.uploadedBytes, 0u);
    EXPECT_LE(memory.poolBytes, kSlotBytes);
    for (const glm::vec4& pixel : pictureOf(t, 2)) EXPECT_EQ(pixel, glm::vec4(0.0f));
}

// The device with a coarse pool against the reference with a volume that is coarse by itself.
TEST_F(Sparse, ACoarseVolumeIsTracedAsIfItWereSo) {
    // The tables begin with the smallest value: it is in a block of its own, and no average takes it away.
    const auto volume = onion(72, 8);
    const TransferFunction look = band(1000, 3000);
    const BrickGrid grid = makeBrickGrid(*volume);
    const Environment sky = Environment::constant(glm::vec3(1.0f));
    for (const std::uint64_t slots : {200u, 20u, 3u}) {
        PathTracer t = tracerWith(device(), volume, {.voxelBytes = slots * kSlotBytes}, 48);
        ASSERT_TRUE(t.scene().setTransferFunction(look).ok());
        Medium medium = makeMedium(*volume, grid, look);
        const Coarsening plan =
            fitBlocks(grid, blocksToShow(grid, medium.bounds), medium.extinctionPerMm, slots);
        EXPECT_EQ(t.statistics()->voxels.coarseBlocks, plan.coarse);
        EXPECT_GT(plan.coarse, 0u);
        EXPECT_LE(t.statistics()->voxels.poolBytes, slots * kSlotBytes);
        coverCoarseBlocks(medium, grid, plan.levels);
        const auto coarse = coarsened(*volume, grid, plan.levels);
        auto params = *makeTraceParams(*volume, medium, sky, viewOf(*volume, 48), {});
        ASSERT_EQ(entryMapOf(*volume).low, entryMapOf(*coarse).low);
        const auto sums =
            ReferenceTracer(*coarse, medium, sky).trace(params, Filter::trilinear, Precision::single, 0, 8);
        const auto picture = pictureOf(t, 8);
        int different = 0;
        for (std::size_t i = 0; i < sums.size(); ++i)
            different += glm::length(glm::dvec4(picture[i]) - sums[i] / 8.0) > 1e-3 ? 1 : 0;
        EXPECT_LT(different, int(sums.size() / 50)) << slots;
    }
}

TEST_F(Sparse, ACoarsePictureIsNearTheFineOneAndSaysSo) {
    const auto volume = std::make_shared<const Volume>(
        phantom::make({.size = {128, 112, 80}, .spacingMm = {2.4, 2.4, 3.75}}));
    TransferFunction bone = scenes::homogeneous(1.0);
    bone.opacity = {{150, 0.0}, {400, 0.8}};
    PathTracer fine = tracerWith(device(), volume, {}, 64);
    ASSERT_TRUE(fine.scene().setTransferFunction(bone).ok());
    EXPECT_TRUE(fine.statistics()->messages.empty());
    const auto expected = pictureOf(fine, 32);
    const std::uint64_t full = fine.statistics()->voxels.uploadedBytes;
    double last = 0.0;
    for (const std::uint64_t part : {2, 6, 40}) {
        PathTracer t = tracerWith(device(), volume, {.voxelBytes = full / part}, 64);
        ASSERT_TRUE(t.scene().setTransferFunction(bone).ok());
        const auto statistics = *t.statistics();
        EXPECT_LE(statistics.voxels.poolBytes, full / part);
        ASSERT_EQ(statistics.messages.size(), 1u);
        const Message& message = statistics.messages.front();
        EXPECT_EQ(message.key, "voxels-coarsened");
        EXPECT_EQ(message.severity, Severity::warning);
        EXPECT_EQ(std::get<std::int64_t>(message.arguments[0].value),
                  std::int64_t(statistics.voxels.coarseBlocks));
        EXPECT_FALSE(message.sentence.empty());
        EXPECT_FALSE(message.action.empty());
        const auto picture = pictureOf(t, 32);
        double difference = 0.0;
        glm::dvec4 mean(0.0);
        glm::dvec4 expectedMean(0.0);
        for (std::size_t i = 0; i < picture.size(); ++i) {
            difference += std::abs(double(picture[i].a) - double(expected[i].a)) / double(picture.size());
            mean += glm::dvec4(picture[i]) / double(picture.size());
            expectedMean += glm::dvec4(expected[i]) / double(picture.size());
        }
        RecordProperty("difference" + std::to_string(part), std::to_string(difference));
        EXPECT_GE(difference, last);
        last = difference;
        EXPECT_LT(difference, part == 2 ? 0.02 : part == 6 ? 0.05 : 0.15) << part;
        EXPECT_NEAR(mean.a / expectedMean.a, 1.0, part == 40 ? 0.3 : 0.1) << part;
    }
}

TEST_F(Sparse, BudgetsAreTheLeastOfAllLimits) {
    gpu::DeviceInfo info;
    info.maxTexelBufferElements = 1 << 27;
    info.maxAllocationBytes = std::uint64_t{1} << 31;
    constexpr std::uint64_t kMiB = 1 << 20;
    const auto expect = [&info](const MemoryLimits& limits, std::uint64_t available, std::uint64_t held,
                                std::uint64_t bytes, PoolBound bound) {
        const PoolRoom room = poolRoom(limits, info, available, held);
        EXPECT_EQ(room.slotCount, bytes / kSlotBytes);
        EXPECT_EQ(int(room.bound), int(bound)) << bytes;
    };
    expect({}, 8192 * kMiB, 0, 1024 * kMiB, PoolBound::buffers);  // four views
    expect({.viewValues = 1 << 20}, 8192 * kMiB, 0, 8 * kMiB, PoolBound::buffers);
    expect({}, 80 * kMiB, 0, 70 * kMiB, PoolBound::memory);  // what is free
    expect({}, 40 * kMiB, 40 * kMiB, 70 * kMiB, PoolBound::memory);
    expect({.isSecond = true}, 80 * kMiB, 0, 40 * kMiB, PoolBound::memory);
    expect({.isSecond = true}, 8192 * kMiB, 0, 256 * kMiB, PoolBound::buffers);  // one view
    expect({.voxelBytes = 5 * kMiB}, 80 * kMiB, 0, 5 * kMiB, PoolBound::setting);
    info.maxTexelBufferElements = UINT32_MAX;
    info.maxAllocationBytes = UINT64_MAX;
    expect({}, UINT64_MAX / 2, 0, ((std::uint64_t{1} << 31) / kSlotValues - 1) * kSlotBytes,
           PoolBound::buffers);  // 31 bits
    info.maxAllocationBytes = 3 * kMiB;
    expect({}, 80 * kMiB, 0, 3 * kMiB, PoolBound::buffers);
    info.maxTexelBufferElements = 65536;  // the least that Vulkan allows
    info.maxAllocationBytes = UINT64_MAX;
    expect({}, 80 * kMiB, 0, kMiB / 2, PoolBound::buffers);
}

// Visible below slice `visible`; never two voxels alike beside each other.
std::shared_ptr<const Volume> tall(glm::ivec3 size, int visible) {
    const std::size_t plane = std::size_t(size.x) * std::size_t(size.y);
    std::vector<std::uint16_t> voxels(plane * std::size_t(size.z));
    parallelFor(std::size_t(size.z), [&](std::size_t k) {
        const int base = int(k) < visible ? 1000 : 0;
        for (std::size_t i = 0; i < plane; ++i)
            voxels[k * plane + i] = static_cast<std::uint16_t>(base + int((i * 7 + k * 3) & 255));
    });
    auto made = Volume::create({.size = size, .worldFromVoxel = glm::dmat4(1.0)}, std::move(voxels));
    return std::make_shared<const Volume>(std::move(made).value());
}

TEST_F(Sparse, MemoryGrowsWithWhatIsVisible) {
    constexpr glm::ivec3 kSize{96, 96, 160};
    const double dense = 2.0 * 96 * 96 * 160;
    for (const int percent : {0, 5, 10, 25, 50, 75, 100}) {
        const int slices = 160 * percent / 100;
        PathTracer t = tracerWith(device(), tall(kSize, slices), {}, 8);
        ASSERT_TRUE(t.scene().setTransferFunction(band(900, 2000)).ok());
        const VoxelMemory memory = t.statistics()->voxels;
        // No more than two layers of blocks beside what is visible: interpolation reaches over, and slices
        // end in blocks.
        EXPECT_LE(double(memory.poolBytes), dense * (percent / 100.0 + 2.0 * 8 / 160)) << percent;
        EXPECT_GE(double(memory.poolBytes), dense * percent / 100.0) << percent;
        EXPECT_LT(double(memory.gridBytes), 0.04 * dense);
        EXPECT_TRUE(t.statistics()->messages.empty());
    }
}

TEST_F(Sparse, ATenthOfALargeVolumeTakesATenthOfItsSize) {
    PathTracer t = tracerWith(device(), tall({512, 512, 1024}, 102), {}, 16);
    ASSERT_TRUE(t.scene().setTransferFunction(band(900, 2000)).ok());
    const VoxelMemory memory = t.statistics()->voxels;
    const double dense = 2.0 * 512 * 512 * 1024;
    RecordProperty("poolMiB", std::to_string(double(memory.poolBytes) / 1048576.0));
    RecordProperty("gridMiB", std::to_string(double(memory.gridBytes) / 1048576.0));
    EXPECT_LE(double(memory.poolBytes), 0.102 * dense);
    EXPECT_LE(double(memory.gridBytes), 0.022 * dense);
    EXPECT_TRUE(t.statistics()->messages.empty());
    double covered = 0.0;
    for (const glm::vec4& pixel : pictureOf(t, 1)) covered += double(pixel.a) / 256.0;
    EXPECT_GT(covered, 0.005);
}

// More visible voxels than a texel buffer of 2^27 has room for, as most devices have.
TEST_F(Sparse, AVolumeOf512By512By1200IsWholeWhenHalfOfItIsVisible) {
    const auto volume = tall({512, 512, 1200}, 600);
    PathTracer t = tracerWith(device(), volume, {.viewValues = std::uint64_t{1} << 27}, 16);
    ASSERT_TRUE(t.scene().setTransferFunction(band(900, 2000)).ok());
    const auto statistics = *t.statistics();
    EXPECT_TRUE(statistics.messages.empty());
    EXPECT_EQ(statistics.voxels.coarseBlocks, 0u);
    EXPECT_GT(statistics.voxels.poolBytes, std::uint64_t{2} << 27);
}

// More voxels than the device's texel buffers take, more bytes than its storage buffers do, a size that no
// block divides.
TEST_F(Sparse, AVolumeOf512By512By2000IsShownWithinTheLimitsOfTheDevice) {
    const auto volume = tall({512, 512, 2000}, 200);
    const std::uint64_t limit =
        poolRoom({}, device()->info(), device()->memoryAvailableBytes(), 0).slotCount * kSlotBytes;
    PathTracer t = tracerWith(device(), volume, {}, 16);
    ASSERT_TRUE(t.scene().setTransferFunction(band(900, 2000)).ok());
    EXPECT_TRUE(t.statistics()->messages.empty());
    EXPECT_LE(double(t.statistics()->voxels.poolBytes), 0.11 * 2.0 * 512 * 512 * 2000);
    const auto tenth = pictureOf(t, 1);
    // All of it.
    ASSERT_TRUE(t.scene().setTransferFunction(band(-1, 2000)).ok());
    const auto statistics = *t.statistics();
    EXPECT_LE(statistics.voxels.poolBytes, limit);
    if (limit < std::uint64_t{2} * 512 * 512 * 2000) {
        ASSERT_EQ(statistics.messages.size(), 1u);
        EXPECT_GT(statistics.voxels.coarseBlocks, statistics.voxels.shownBlocks / 2);
        EXPECT_GT(double(statistics.voxels.poolBytes), 0.9 * double(limit)) << "what there is should be used";
    }
    const auto all = pictureOf(t, 1);
    const auto covered = [](const std::vector<glm::vec4>& picture) {
        return std::count_if(picture.begin(), picture.end(), [](const glm::vec4& p) { return p.a > 0.5f; });
    };
    EXPECT_GT(covered(all), 3 * std::max<std::ptrdiff_t>(covered(tenth), 1));
    // And back.
    ASSERT_TRUE(t.scene().setTransferFunction(band(900, 2000)).ok());
    EXPECT_TRUE(t.statistics()->messages.empty());
    EXPECT_EQ(pictureOf(t, 1), tenth);
}

}  // namespace
}  // namespace macula::trace
