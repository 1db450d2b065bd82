#include "live/frame/scene_ids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/phantom.h"
#include "pipeline/volume/mask_bits.h"

namespace macula::live {
namespace {

scene::Drawing drawing() {
    return {.transferFunction = std::make_shared<const TransferFunction>(),
            .lights = std::make_shared<const trace::LightRig>()};
}

TEST(SceneIds, AreTheSameForTheSameAndForWhatComesBack) {
    SceneIds names;
    const scene::Drawing a = drawing();
    const std::string first = names.of(1, a);
    EXPECT_EQ(names.of(1, a), first);
    // An equal clip, made anew, is the same.
    scene::Drawing clipped = a;
    clipped.clip = std::make_shared<const Clip>(Clip{.planes = {{.offsetMm = 3.0}}});
    const std::string second = names.of(1, clipped);
    EXPECT_NE(second, first);
    clipped.clip = std::make_shared<const Clip>(*clipped.clip);
    EXPECT_EQ(names.of(1, clipped), second);
    EXPECT_EQ(names.of(1, a), first);
    clipped.clip = std::make_shared<const Clip>();
    EXPECT_EQ(names.of(1, clipped), first);
}

TEST(SceneIds, TellPhasesApartWithoutKeepingTheirVolumes) {
    SceneIds names;
    auto first = std::make_shared<const Volume>(phantom::make({.size = {4, 4, 4}}));
    const auto second = std::make_shared<const Volume>(*first);
    const scene::Drawing a = drawing();
    const std::string ofFirst = names.of(1, a, first);
    EXPECT_NE(names.of(1, a, second), ofFirst);
    EXPECT_EQ(names.of(1, a, first), ofFirst);
    EXPECT_EQ(first.use_count(), 1);
}

// Grey values of cut faces pass the exposure unchanged: a model holds them divided by it.
TEST(SceneIds, DependOnTheExposureWhereFacesShowValues) {
    SceneIds names;
    scene::Drawing cut = drawing();
    cut.clip = std::make_shared<const Clip>(Clip{.planes = {{.offsetMm = 3.0}}});
    const std::string plain = names.of(1, cut);
    cut.settings.exposure = 2.0;
    EXPECT_EQ(names.of(1, cut), plain);
    Clip grey = *cut.clip;
    grey.greyFaces = DisplayWindow{.center = 40.0, .width = 400.0};
    cut.clip = std::make_shared<const Clip>(grey);
    const std::string bright = names.of(1, cut);
    EXPECT_EQ(names.of(1, cut), bright);
    cut.settings.exposure = 1.0;
    EXPECT_NE(names.of(1, cut), bright);
    cut.settings.exposure = 2.0;
    cut.settings.toneMap = trace::ToneMap::hue;
    EXPECT_NE(names.of(1, cut), bright);
}

// A function that is being edited is another at each step: none is kept for ever, and no name is used twice.
TEST(SceneIds, OfManyTheLastUsedAreRemembered) {
    SceneIds names;
    const scene::Drawing first = drawing();
    const std::string itsName = names.of(1, first);
    scene::Drawing second = drawing();
    const std::weak_ptr<const TransferFunction> forgotten = second.transferFunction;
    const std::string other = names.of(1, second);
    std::vector<std::string> seen{itsName, other};
    second = {};
    for (std::size_t i = 0; i < 3 * SceneIds::kRemembered; ++i) {
        seen.push_back(names.of(1, drawing()));
        EXPECT_EQ(names.of(1, first), itsName);
    }
    EXPECT_TRUE(forgotten.expired());
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::adjacent_find(seen.begin(), seen.end()), seen.end());
}

// Scenes are remembered by the dozen: with what is large they would fill the memory.
TEST(SceneIds, KnowSegmentsMasksAndVolumesWithoutKeepingThem) {
    SceneIds names;
    const scene::Drawing plain = drawing();
    const auto withBox = [&](std::shared_ptr<const TintBox> box, float opacity) {
        scene::Drawing coloured = plain;
        Additions added;
        added.tints = SegmentTints{std::move(box), {{.opacity = opacity}}};
        coloured.additions = std::make_shared<const Additions>(added);
        return coloured;
    };
    auto box = std::make_shared<const TintBox>();
    const std::weak_ptr<const TintBox> goneBox = box;
    const std::string first = names.of(1, withBox(box, 1.0f));
    EXPECT_EQ(names.of(1, withBox(box, 1.0f)), first);
    EXPECT_NE(names.of(1, withBox(box, 0.5f)), first);
    box.reset();
    EXPECT_TRUE(goneBox.expired());
    EXPECT_NE(names.of(1, withBox(std::make_shared<const TintBox>(), 1.0f)), first);

    auto bits = std::make_shared<const MaskBits>();
    const std::weak_ptr<const MaskBits> goneBits = bits;
    scene::Drawing masked = drawing();
    const auto mask = [&](std::shared_ptr<const MaskBits> of) {
        Clip clip;
        clip.mask.emplace();
        clip.mask->bits = std::move(of);
        masked.clip = std::make_shared<const Clip>(clip);
    };
    mask(bits);
    const std::string second = names.of(1, masked);
    EXPECT_EQ(names.of(1, masked), second);
    mask(std::make_shared<const MaskBits>());
    EXPECT_NE(names.of(1, masked), second);
    bits.reset();
    EXPECT_TRUE(goneBits.expired());
}

TEST(SceneIds, DifferInWhateverAModelDependsOn) {
    SceneIds names;
    const scene::Drawing a = drawing();
    std::vector<std::string> seen{names.of(7, a)};
    const auto isNew = [&](const scene::Drawing& other) {
        const std::string name = names.of(7, other);
        const bool is = std::find(seen.begin(), seen.end(), name) == seen.end();
        seen.push_back(name);
        return is;
    };
    scene::Drawing b = a;
    b.transferFunction = std::make_shared<const TransferFunction>();
    EXPECT_TRUE(isNew(b)) << "an equal one may be of another file";
    b = a;
    b.lights = std::make_shared<const trace::LightRig>();
    EXPECT_TRUE(isNew(b));
    b = a;
    b.clip = std::make_shared<const Clip>(Clip{.ball = Ball{}});
    EXPECT_TRUE(isNew(b));
    b.clip = std::make_shared<const Clip>(Clip{.ball = Ball{}, .greyFaces = DisplayWindow{}});
    EXPECT_TRUE(isNew(b));
    b = a;
    b.settings.look = trace::Look::clear;
    EXPECT_TRUE(isNew(b));
    b = a;
    b.settings.bounces = 9;
    EXPECT_TRUE(isNew(b));
    b = a;
    b.settings.lightStrength = 2.0;
    EXPECT_TRUE(isNew(b));
    b = a;
    b.settings.lightRotationDeg = 30.0;
    EXPECT_TRUE(isNew(b));
    EXPECT_NE(names.of(8, a), seen.front());
    // What only changes how it is displayed.
    b = a;
    b.settings.seed = 5;
    b.settings.exposure = 2.0;
    b.settings.toneMap = trace::ToneMap::hue;
    b.settings.denoising = trace::Denoising::on;
    b.settings.errorThreshold = 0.1;
    b.remarks = Text("clipped");
    EXPECT_EQ(names.of(8, b), names.of(8, a));
}

}  // namespace
}  // namespace macula::live
