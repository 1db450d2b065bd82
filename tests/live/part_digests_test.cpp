// Volumes, masks and segments are read once to be told apart, however many scenes they are part of.
#include "live/model/part_digests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include "base/fingerprint.h"
#include "base/phantom.h"
#include "live/model/scene_digests.h"
#include "live/store/model_key_of_drawing.h"
#include "pipeline/volume/mask_bits.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {
namespace {

std::shared_ptr<const Volume> phantomOf(const glm::ivec3& size) {
    return std::make_shared<const Volume>(phantom::make({.size = size}));
}

std::shared_ptr<const TintBox> boxOf(const Volume& volume, std::uint8_t colour) {
    auto box = std::make_shared<TintBox>();
    box->volumeSize = volume.size();
    box->size = glm::ivec3(2);
    box->voxels.assign(8, colour);
    return box;
}

std::shared_ptr<const MaskBits> bitsOf(const Volume& volume, std::uint32_t word) {
    auto bits = std::make_shared<MaskBits>();
    bits->size = volume.size();
    bits->words.assign((volume.voxelCount() + 31) / 32, word);
    return bits;
}

// A mask, a second volume and a segment, all at once.
scene::Drawing drawingWith(const std::shared_ptr<const Volume>& volume,
                           const std::shared_ptr<const Volume>& second) {
    Clip clip;
    clip.mask.emplace();
    clip.mask->bits = bitsOf(*volume, 0xf0f0f0f0u);
    Additions added;
    added.second.emplace();
    added.second->volume = second;
    added.second->function =
        std::make_shared<const TransferFunction>(scene::choosePreset("cinematic-bone")->function);
    added.tints = SegmentTints{boxOf(*volume, 1), {{.rgb = {1.0f, 0.0f, 0.0f}, .opacity = 1.0f}}};
    scene::Drawing drawing;
    drawing.transferFunction = added.second->function;
    drawing.lights = std::make_shared<const trace::LightRig>();
    drawing.clip = std::make_shared<const Clip>(clip);
    drawing.additions = std::make_shared<const Additions>(added);
    return drawing;
}

TEST(PartDigests, AnotherOpacityOrCurveReadsNothingAgain) {
    const auto volume = phantomOf({12, 10, 8});
    const auto second = phantomOf({9, 8, 7});
    scene::Drawing drawing = drawingWith(volume, second);
    const std::string digest = fingerprint(*volume);
    PartDigests parts;
    const session::ModelKey first = modelKeyOf(digest, *volume, drawing, parts);
    EXPECT_EQ(parts.made(), 3u) << "the mask, the second volume and the segment";
    PartDigests none;
    EXPECT_EQ(first.digest(), modelKeyOf(digest, *volume, drawing, none).digest())
        << "known or not, it is the same";

    std::vector<std::string> seen{first.digest()};
    for (const float opacity : {0.9f, 0.5f, 0.0f}) {
        Additions next = *drawing.additions;
        next.tints->colours.front().opacity = opacity;
        TransferFunction curve = *next.second->function;
        curve.opacity.front().value -= 1.0;
        next.second->function = std::make_shared<const TransferFunction>(curve);
        drawing.additions = std::make_shared<const Additions>(next);
        seen.push_back(modelKeyOf(digest, *volume, drawing, parts).digest());
    }
    EXPECT_EQ(parts.made(), 3u);
    std::ranges::sort(seen);
    EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end()) << "all of them are other models";
}

TEST(PartDigests, OtherPartsAreReadAndToldApart) {
    const auto volume = phantomOf({12, 10, 8});
    const auto second = phantomOf({9, 8, 7});
    PartDigests parts;
    EXPECT_EQ(parts.of(second), fingerprint(*second));
    EXPECT_NE(parts.of(volume), parts.of(second));
    EXPECT_NE(parts.of(boxOf(*volume, 1)), parts.of(boxOf(*volume, 2)));
    Mask mask;
    mask.bits = bitsOf(*volume, 1u);
    const std::string one = parts.of(mask, *volume);
    mask.bits = bitsOf(*volume, 3u);
    EXPECT_NE(parts.of(mask, *volume), one);
}

// The same labels hide other voxels for other numbers, kept or removed, and in another volume.
TEST(PartDigests, OfLabelsItMattersWhichAndWhere) {
    const auto volume = phantomOf({6, 5, 4});
    const auto larger = phantomOf({6, 5, 8});
    std::vector<std::uint16_t> labels(volume->voxelCount(), 0);
    labels[3] = 1;
    labels[7] = 2;
    auto map = LabelMap::create(volume->size(), volume->worldFromVoxel(), {}, labels);
    ASSERT_TRUE(map.ok());
    Mask mask;
    mask.labels = std::make_shared<const LabelMap>(*std::move(map));
    PartDigests parts;
    std::vector<std::string> seen{parts.of(mask, *volume)};
    mask.numbers = {1};
    seen.push_back(parts.of(mask, *volume));
    EXPECT_EQ(parts.of(mask, *volume), seen.back());
    EXPECT_EQ(parts.made(), 2u);
    mask.numbers = {2};
    seen.push_back(parts.of(mask, *volume));
    mask.keep = Keep::outside;
    seen.push_back(parts.of(mask, *volume));
    seen.push_back(parts.of(mask, *larger));
    std::ranges::sort(seen);
    EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
}

// One owner may have two volumes, as a study and its prior: neither is taken for the other.
TEST(PartDigests, TwoPartsOfOneOwnerAreTwo) {
    struct Both {
        Volume a = phantom::make({.size = {6, 5, 4}});
        Volume b = phantom::make({.size = {4, 5, 6}});
    };
    const auto both = std::make_shared<const Both>();
    PartDigests parts;
    EXPECT_EQ(parts.of(std::shared_ptr<const Volume>(both, &both->a)), fingerprint(both->a));
    EXPECT_EQ(parts.of(std::shared_ptr<const Volume>(both, &both->b)), fingerprint(both->b));
}

TEST(PartDigests, OfManyThreadsOneReads) {
    const auto volume = phantomOf({40, 40, 40});
    PartDigests parts;
    std::vector<std::string> found(6);
    {
        std::vector<std::jthread> threads;
        for (std::string& each : found) threads.emplace_back([&] { each = parts.of(volume); });
    }
    EXPECT_EQ(parts.made(), 1u);
    EXPECT_EQ(found, std::vector<std::string>(6, fingerprint(*volume)));
}

// What is closed is not kept, and what comes to lie in its place is another.
TEST(PartDigests, OfWhatIsGoneNothingIsKnown) {
    PartDigests parts;
    for (const int depth : {3, 4, 5, 6}) {
        const auto volume = phantomOf({5, 5, depth});
        std::weak_ptr<const Volume> gone = volume;
        EXPECT_EQ(parts.of(volume), fingerprint(*volume));
        EXPECT_EQ(gone.use_count(), 1) << "it is not held";
    }
    EXPECT_EQ(parts.made(), 4u);
}

}  // namespace
}  // namespace macula::live
