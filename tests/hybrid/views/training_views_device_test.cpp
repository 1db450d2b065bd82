// Which views tell a trained model something.
#include "pipeline/hybrid/views/training_views.h"

#include "splat/train/training_scene.h"

namespace macula::hybrid {
namespace {

class Admission : public splat::TrainingTest {
  protected:
    static constexpr double kRadiusMm = 200.0;

    static Box seenMm() { return {.low = {-kRadiusMm, 0.0, 0.0}, .high = {kRadiusMm, 0.0, 0.0}}; }

    // As the truth is from there, or something else.
    static TracedView seenFrom(double degrees, bool asItIs = true) {
        const double angle = glm::radians(degrees);
        TracedView view{.camera = {.positionMm = {500 * std::sin(angle), -500 * std::cos(angle), 0.0},
                                   .verticalFovDeg = 14.0},
                        .sizePx = {45, 40},
                        .samplesPerPixel = 4.0};
        view.rgba = draw(truth(), splat::rasterView(view.camera, view.sizePx, glm::dvec3(0.0)).value());
        if (!asItIs) std::reverse(view.rgba.begin(), view.rgba.end());
        return view;
    }
};

TEST_F(Admission, IsForWhatShowsSomethingNew) {
    splat::Trainer trained = std::move(splat::Trainer::create(device(), start(), options(0))).value();
    for (const double degrees : {0.0, 90.0, 180.0, 270.0})
        ASSERT_TRUE(learnFrom(trained, seenMm(), seenFrom(degrees)).ok());
    ASSERT_TRUE(trained.step(60).ok());
    const float byArea = weightByArea(trained.view(0).view, seenMm(), glm::dvec3(0.0));
    EXPECT_GT(std::abs(byArea - 1.0f), 0.1f);
    const auto admitted = [&](const TracedView& view) {
        return admit(trained, trainingView(trained, seenMm(), view).value(), kRadiusMm).value();
    };
    EXPECT_EQ(admitted(seenFrom(90.5)), Novelty::none);
    EXPECT_EQ(trained.viewCount(), 4u);
    EXPECT_EQ(admitted(seenFrom(45.0)), Novelty::pose);
    EXPECT_EQ(trained.viewCount(), 5u);
    EXPECT_EQ(admitted(seenFrom(45.0)), Novelty::none) << "it has that one already";
    EXPECT_EQ(admitted(seenFrom(45.0, false)), Novelty::none) << "and knows nothing from there yet";
    ASSERT_TRUE(trained.step(2).ok());
    EXPECT_EQ(admitted(seenFrom(45.0)), Novelty::none);
    EXPECT_EQ(admitted(seenFrom(45.0, false)), Novelty::picture);
    EXPECT_EQ(trained.viewCount(), 6u);
    ASSERT_TRUE(trained.step(2).ok());
    EXPECT_EQ(admitted(seenFrom(45.0, false)), Novelty::none) << "it has that one now";
    EXPECT_FLOAT_EQ(trained.lastGood().views.back().given->weight, weightBySamples(4.0) * byArea);

    TracedView outline = seenFrom(135.0);
    ASSERT_TRUE(learnCoverageFrom(trained, seenMm(), outline).ok());
    EXPECT_EQ(trained.view(6).kind, splat::ViewKind::outline);
    EXPECT_EQ(trained.view(6).weight, byArea);
    EXPECT_EQ(admitted(seenFrom(135.0)), Novelty::pose) << "an outline is no picture";
    EXPECT_EQ(trained.viewCount(), 8u);

    TracedView bad = seenFrom(90.0);
    bad.rgba.pop_back();
    EXPECT_EQ(admit(trained, trainingView(trained, seenMm(), bad).value(), kRadiusMm).error().code,
              ErrorCode::inputNotUsable);
    TracedView parallel = seenFrom(90.0);
    parallel.camera = inParallel(parallel.camera);
    EXPECT_EQ(trainingView(trained, seenMm(), parallel).error().code, ErrorCode::usage);
    EXPECT_EQ(trained.viewCount(), 8u);
}

TEST_F(Admission, LooksWithoutLearning) {
    splat::Trainer looking = trainer(start(), options(4), truthViews());
    splat::Trainer other = trainer(start(), options(4), truthViews());
    ASSERT_TRUE(looking.step(3).ok());
    ASSERT_TRUE(other.step(3).ok());
    const splat::TrainingView view{.view = heldOut(), .pixels = draw(truth(), heldOut())};
    const double before = looking.differenceTo(view).value();
    const splat::TrainingView itself{.view = heldOut(), .pixels = draw(*looking.snapshot(), heldOut())};
    EXPECT_NEAR(looking.differenceTo(itself).value(), 0.0, 1e-6);
    ASSERT_TRUE(looking.step(40).ok());
    ASSERT_TRUE(other.step(40).ok());
    EXPECT_TRUE(splat::testing::sameBits(*looking.snapshot(), *other.snapshot()));
    EXPECT_LT(looking.differenceTo(view).value(), 0.7 * before);
}

}  // namespace
}  // namespace macula::hybrid
