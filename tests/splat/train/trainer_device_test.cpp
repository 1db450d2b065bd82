// What the trainer learns, and what it is asked to learn from.
#include <chrono>
#include <functional>
#include <limits>

#include "splat/train/training_scene.h"

namespace macula::splat {
namespace {

class TrainerOnDevice : public TrainingTest {};

// In a picture that it has not seen, too.
TEST_F(TrainerOnDevice, Learns) {
    Trainer trained = trainer(start(), options(30), truthViews());
    const auto early = trained.step(kViews);
    ASSERT_TRUE(early.ok());
    const double before = psnrOf(start());
    const auto late = trained.step(55);
    ASSERT_TRUE(late.ok());
    const double after = psnrOf(*trained.snapshot());
    EXPECT_EQ(late->steps, 60u);
    EXPECT_EQ(late->splats, kNumber);
    EXPECT_LT(late->loss, 0.35 * early->loss);
    EXPECT_LT(late->l1, 0.35 * early->l1);
    EXPECT_GT(after, before + 6.0) << before << " dB before";
}

TEST_F(TrainerOnDevice, LearnsColourByDirection) {
    // Nothing else is to be learnt.
    Splats target = truth(1);
    for (glm::vec3& sh : target.sh) sh *= 4.0f;
    Splats without = target;
    for (glm::vec3& sh : without.sh) sh = glm::vec3(0.0f);
    const std::vector<TrainingView> seen = views(target);
    const auto off = [&](const Splats& model) {
        return psnr(draw(model, heldOut()), draw(target, heldOut()));
    };
    const auto learnt = [&](int degree) {
        Splats from = without;
        from.setShDegree(degree);
        TrainerOptions o = options(0);
        o.optimizer.sh = o.optimizer.dc;
        Trainer trained = trainer(from, o, seen);
        EXPECT_TRUE(trained.step(100).ok());
        return off(*trained.snapshot());
    };
    const double plain = learnt(0);
    const double byDirection = learnt(1);
    EXPECT_GT(byDirection, off(without) + 3.0) << plain;
    EXPECT_GT(byDirection, plain + 2.0) << off(without);
}

// Black on black: only what shines through tells.
TEST_F(TrainerOnDevice, LearnsCoverageByItself) {
    Splats target = truth();
    for (glm::vec3& dc : target.dc) dc = glm::vec3(-0.5f / 0.28209479f);
    Splats model = target;
    for (float& logit : model.opacityLogit) logit -= 1.5f;
    const auto coverage = [](const std::vector<glm::vec4>& pixels) {
        double sum = 0.0;
        for (const glm::vec4& pixel : pixels) sum += double(pixel.a);
        return sum;
    };
    const std::vector<TrainingView> seen = views(target);
    for (const glm::vec4& pixel : seen.front().pixels) ASSERT_LT(glm::length(glm::vec3(pixel)), 1e-6f);
    Trainer trained = trainer(model, options(0), seen);
    ASSERT_TRUE(trained.step(60).ok());
    const double right = coverage(draw(target, heldOut()));
    const double before = coverage(draw(model, heldOut()));
    const double after = coverage(draw(*trained.snapshot(), heldOut()));
    EXPECT_LT(before, 0.8 * right);
    EXPECT_NEAR(after, right, 0.05 * right);
}

// The colours that are given with it are wrong, and nothing comes of them.
TEST_F(TrainerOnDevice, LearnsCoverageWithoutColours) {
    Splats model = truth();
    for (float& logit : model.opacityLogit) logit -= 1.5f;
    std::vector<TrainingView> seen = truthViews();
    for (TrainingView& view : seen) {
        view.kind = ViewKind::outline;
        for (glm::vec4& pixel : view.pixels) pixel = glm::vec4(glm::vec3(7.0f), pixel.w);
    }
    const auto off = [&](const Splats& splats) {
        const auto drawn = draw(splats, heldOut());
        const auto right = draw(truth(), heldOut());
        double sum = 0.0;
        for (std::size_t i = 0; i < drawn.size(); ++i) sum += std::abs(double(drawn[i].w - right[i].w));
        return sum;
    };
    Trainer trained = trainer(model, options(0), seen);
    const auto report = trained.step(60);
    ASSERT_TRUE(report.ok());
    const Splats learnt = *trained.snapshot();
    EXPECT_LT(off(learnt), 0.3 * off(model));
    EXPECT_TRUE(testing::sameBits(learnt.dc, model.dc));
    EXPECT_EQ(report->l1, 0.0) << "of no picture anything is known";
}

// As if they had never been there, but for what was learnt from them.
TEST_F(TrainerOnDevice, StandInsAreForgotten) {
    std::vector<TrainingView> seen = truthViews();
    for (std::size_t i = 0; i < seen.size(); i += 2)
        seen[i].kind = i % 4 == 0 ? ViewKind::outline : ViewKind::standIn;
    Trainer trained = trainer(start(), options(), seen);
    ASSERT_TRUE(trained.step(20).ok());
    TrainingState without = *trained.state();
    std::erase_if(without.views,
                  [](const TrainingState::View& view) { return view.given->kind != ViewKind::picture; });
    trained.forgetStandIns();
    EXPECT_EQ(trained.viewCount(), seen.size() / 2);
    EXPECT_EQ(trained.lastGood().views.size(), seen.size() / 2);
    for (std::size_t i = 0; i < trained.viewCount(); ++i) EXPECT_EQ(trained.view(i).kind, ViewKind::picture);

    Trainer other = std::move(Trainer::resume(device(), without)).value();
    ASSERT_TRUE(trained.step(20).ok());
    ASSERT_TRUE(other.step(20).ok());
    EXPECT_TRUE(testing::sameBits(*trained.snapshot(), *other.snapshot()));
}

// As if the better picture had been there from then on, with what is known of the view.
TEST_F(TrainerOnDevice, ABetterPictureTakesThePlaceOfAView) {
    std::vector<TrainingView> seen = truthViews();
    for (glm::vec4& pixel : seen[1].pixels) pixel *= glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    Trainer trained = trainer(start(), options(), seen);
    ASSERT_TRUE(trained.step(20).ok());
    TrainingState better = *trained.state();
    TrainingView heavier = truthViews()[1];
    heavier.weight *= 2.0f;
    better.views[1].given = std::make_shared<const TrainingView>(heavier);
    better.views[1].loss *= 2.0;
    ASSERT_TRUE(trained.replaceView(1, heavier).ok());
    EXPECT_EQ(trained.viewCount(), seen.size());
    EXPECT_TRUE(trained.wasDrawn(1));
    EXPECT_EQ(trained.lastGood().views[1].given->pixels, truthViews()[1].pixels);

    Trainer other = std::move(Trainer::resume(device(), better)).value();
    ASSERT_TRUE(trained.step(20).ok());
    ASSERT_TRUE(other.step(20).ok());
    EXPECT_TRUE(testing::sameBits(*trained.snapshot(), *other.snapshot()));
}

TEST_F(TrainerOnDevice, APictureThatTellsNothingTakesNoPlace) {
    Trainer trained = trainer(start(), options(), truthViews());
    TrainingView nothing = truthViews()[1];
    for (glm::vec4& pixel : nothing.pixels) pixel = glm::vec4(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(trained.replaceView(1, nothing).error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(trained.view(1).pixels, truthViews()[1].pixels);
    EXPECT_TRUE(trained.step(kViews).ok());
}

// Hundreds in a row would make it forget what it knows.
TEST_F(TrainerOnDevice, OfViewsThatComeLaterOneIsDrawnAtEverySixthStep) {
    Trainer trained = trainer(start(), options(0), truthViews());
    const auto drawn = [&] {
        std::size_t count = 0;
        for (std::size_t i = 0; i < trained.viewCount(); ++i) count += trained.wasDrawn(i) ? 1 : 0;
        return count;
    };
    for (std::size_t n = 1; n <= kViews; ++n) {
        ASSERT_TRUE(trained.step(1).ok());
        EXPECT_EQ(drawn(), n) << "at first each once";
    }
    ASSERT_TRUE(trained.step(3).ok());
    for (const TrainingView& view : truthViews()) ASSERT_TRUE(trained.addView(view).ok());
    ASSERT_TRUE(trained.step(12).ok());
    EXPECT_EQ(drawn(), kViews + 2u);
    ASSERT_TRUE(trained.step(18).ok());
    EXPECT_EQ(drawn(), 2u * kViews);
}

// Two pictures from the same place that contradict each other.
TEST_F(TrainerOnDevice, TheHeavierPictureCountsMore) {
    Splats between = truth();
    for (glm::vec3& dc : between.dc) dc = glm::vec3(-1.0f);
    const auto brightness = [&](float weightOfBright) {
        std::vector<TrainingView> both(2, truthViews().front());
        both[0].weight = weightOfBright;
        both[1].weight = 1.0f / weightOfBright;
        for (glm::vec4& pixel : both[1].pixels) pixel *= glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
        Trainer trained = trainer(between, options(0), both);
        EXPECT_TRUE(trained.step(20).ok());
        double sum = 0.0;
        for (const glm::vec4& pixel : draw(*trained.snapshot(), both[0].view)) sum += double(pixel.g);
        return sum;
    };
    EXPECT_GT(brightness(3.0f), 1.5 * brightness(1.0f / 3.0f));
}

TEST_F(TrainerOnDevice, PicturesThatTellNothingAreRefused) {
    const float nan = std::nanf("");
    Trainer trained = std::move(Trainer::create(device(), start(), options())).value();
    EXPECT_EQ(trained.step(1).error().code, ErrorCode::usage);
    const TrainingView good = truthViews().front();
    const auto refused = [&](TrainingView view, ErrorCode code) {
        const auto added = trained.addView(std::move(view));
        ASSERT_FALSE(added.ok());
        EXPECT_EQ(added.error().code, code);
        EXPECT_EQ(trained.viewCount(), 0u);
        EXPECT_TRUE(trained.lastGood().views.empty());
    };
    TrainingView bad = good;
    bad.pixels.assign(bad.pixels.size(), glm::vec4(nan));
    refused(bad, ErrorCode::inputNotUsable);
    bad = good;
    bad.pixels.pop_back();
    refused(bad, ErrorCode::inputNotUsable);
    bad.pixels.clear();
    refused(bad, ErrorCode::inputNotUsable);
    for (const float weight : {0.0f, -1.0f, nan, std::numeric_limits<float>::infinity(), 2e6f}) {
        bad = good;
        bad.weight = weight;
        refused(bad, ErrorCode::inputNotUsable);
    }
    bad = good;
    bad.view.focalPx.x = 0.0;
    refused(bad, ErrorCode::usage);
    EXPECT_EQ(trained.step(1).error().code, ErrorCode::usage);
    ASSERT_TRUE(trained.addView(good).ok());
    EXPECT_TRUE(trained.step(1).ok());
}

// Not at the first step that comes to it, and at all that follow.
TEST_F(TrainerOnDevice, APictureThatIsTooLargeToCompareIsRefused) {
    // Of sums by tiles, the largest are the pixels themselves; by strips, sums over windows.
    const std::uint64_t bytesPerPixel = lossWorkOf(*device()) == LossWork::byTiles ? 16 : 64;
    const std::uint64_t most = device()->info().maxStorageBufferBytes / bytesPerPixel;
    const int side = static_cast<int>(std::sqrt(double(most))) + 1;
    if (side > 5000) GTEST_SKIP() << "on this device, pictures may be larger than there is memory for here";
    Trainer trained = trainer(start(), options(), truthViews());
    Trainer undisturbed = trainer(start(), options(), truthViews());
    TrainingView large = truthViews().front();
    large.view.sizePx = {side, side};
    large.pixels.assign(std::size_t(side) * std::size_t(side), glm::vec4(0.5f));
    for (int i = 0; i < 2; ++i) {
        const auto added = trained.addView(large);
        ASSERT_FALSE(added.ok());
        EXPECT_EQ(added.error().code, ErrorCode::outOfMemory);
        EXPECT_EQ(trained.viewCount(), truthViews().size());
        EXPECT_EQ(trained.lastGood().views.size(), truthViews().size());
        ASSERT_TRUE(trained.step(7).ok());
        ASSERT_TRUE(undisturbed.step(7).ok());
        EXPECT_TRUE(testing::sameBits(*trained.snapshot(), *undisturbed.snapshot()));
    }
}

// Pixels that are no numbers are unknown: the rest is learnt.
TEST_F(TrainerOnDevice, LearnsAroundUnknownPixels) {
    std::vector<TrainingView> holed = truthViews();
    for (std::size_t v = 0; v < holed.size(); ++v) {
        for (std::size_t i = v; i < holed[v].pixels.size(); i += 7)
            holed[v].pixels[i][int(i % 4)] =
                v % 2 == 0 ? std::nanf("") : std::numeric_limits<float>::infinity();
    }
    Trainer trained = trainer(start(), options(30), holed);
    const auto report = trained.step(60);
    ASSERT_TRUE(report.ok());
    EXPECT_TRUE(std::isfinite(report->loss));
    const Splats learnt = *trained.snapshot();
    ASSERT_TRUE(learnt.validate().ok());
    EXPECT_GT(psnrOf(learnt), psnrOf(start()) + 5.0);
}

TEST_F(TrainerOnDevice, WhatIsNowhereFades) {
    std::vector<TrainingView> empty = truthViews();
    for (TrainingView& view : empty) view.pixels.assign(view.pixels.size(), glm::vec4(0.0f));
    Trainer trained = trainer(start(), options(0), empty);
    const auto early = trained.step(kViews);
    ASSERT_TRUE(early.ok());
    const auto late = trained.step(35);
    ASSERT_TRUE(late.ok());
    EXPECT_LT(late->loss, 0.5 * early->loss);
    EXPECT_TRUE(trained.snapshot()->validate().ok());
}

TEST_F(TrainerOnDevice, WhatIsNotInAViewStays) {
    Splats behind = start();
    for (glm::vec3& position : behind.position) position.y -= 2000.0f;
    Trainer trained = trainer(behind, options(), {truthViews().front()});
    ASSERT_TRUE(trained.step(3).ok());
    EXPECT_TRUE(testing::sameBits(*trained.snapshot(), behind));
}

TEST_F(TrainerOnDevice, AModelWithoutSplatsStaysOne) {
    for (const std::uint32_t capacity : {0u, 10u}) {
        TrainerOptions o = options();
        o.capacity = capacity;
        Trainer trained = trainer(Splats{}, o, truthViews());
        const auto report = trained.step(kViews);
        ASSERT_TRUE(report.ok()) << report.error().message;
        EXPECT_EQ(report->splats, 0u);
        EXPECT_GT(report->loss, 0.0);
        EXPECT_EQ(trained.snapshot()->size(), 0u);
        if (capacity == 0) continue;
        const auto state = trained.state();
        ASSERT_TRUE(state.ok());
        EXPECT_TRUE(Trainer::resume(device(), *state)->step(1).ok());
    }
}

TEST_F(TrainerOnDevice, ModelsItCannotTrainAreRefused) {
    EXPECT_EQ(Trainer::create(device(), truth(2), options()).error().code, ErrorCode::usage);
    Splats bad = start();
    bad.dc[3].x = std::nanf("");
    EXPECT_EQ(Trainer::create(device(), bad, options()).error().code, ErrorCode::inputNotUsable);
    for (const float length : {0.0f, 3e38f}) {  // no direction, and one whose square is too large
        Splats unturned = start();
        unturned.rotation[0] = glm::vec4(length);
        EXPECT_EQ(Trainer::create(device(), unturned, options()).error().code, ErrorCode::inputNotUsable);
    }
    std::vector<TrainerOptions> senseless(7, options());
    senseless[0].stages[1].halvings = -1;
    senseless[1].stages[1].halvings = 40;
    senseless[2].loss.dssimWeight = 1.5f;
    senseless[3].loss.exposure = std::nanf("");
    senseless[4].density.every = 0;
    senseless[5].density.splitShare = std::nan("");
    senseless[6].optimizer.position = 0.0;
    for (const TrainerOptions& o : senseless)
        EXPECT_EQ(Trainer::create(device(), start(), o).error().code, ErrorCode::usage);
}

// Whatever numbers one splat has, as long as they are some: the model stays a valid one, and nothing of the
// others is no number.
TEST_F(TrainerOnDevice, AModelOfExtremesStaysValid) {
    constexpr float kHuge = 3e38f;
    const std::vector<std::function<void(Splats&)>> changes{
        [](Splats& s) { s.position[0] = glm::vec3(kHuge); },
        [](Splats& s) { s.position[0] = glm::vec3(-1e20f, 1e-40f, 1e5f); },
        [](Splats& s) { s.logScale[0] = glm::vec3(80.0f); },
        [](Splats& s) { s.logScale[0] = glm::vec3(-kHuge, kHuge, 0.0f); },
        [](Splats& s) { s.rotation[0] = glm::vec4(1e18f); },
        [](Splats& s) { s.opacityLogit[0] = kHuge; },
        [](Splats& s) { s.opacityLogit[0] = -kHuge; },
        [](Splats& s) { s.dc[0] = glm::vec3(kHuge, -kHuge, 1e-40f); },
        [](Splats& s) { s.sh[0] = glm::vec3(kHuge); }};
    for (std::size_t c = 0; c < changes.size(); ++c) {
        Splats model = start(1);
        changes[c](model);
        auto trained = Trainer::create(device(), model, options(2));
        ASSERT_TRUE(trained.ok()) << c << ": " << trained.error().message;
        for (const TrainingView& view : truthViews()) ASSERT_TRUE(trained->addView(view).ok());
        ASSERT_TRUE(trained->step(8).ok()) << c;
        const Splats learnt = *trained->snapshot();
        EXPECT_TRUE(learnt.validate().ok()) << c;
        std::size_t moved = 0;
        for (std::size_t i = 1; i < kSplats; ++i) moved += learnt.dc[i] != model.dc[i] ? 1 : 0;
        // Not all: a huge one may hide some.
        EXPECT_GT(moved, kSplats / 2) << c << ": the others learn";
    }
}

TEST_F(TrainerOnDevice, RoomForMoreChangesNothing) {
    TrainerOptions roomy = options(4);
    roomy.capacity = 1000;
    Trainer tight = trainer(start(), options(4), truthViews());
    Trainer wide = trainer(start(), roomy, truthViews());
    ASSERT_TRUE(tight.step(8).ok());
    ASSERT_TRUE(wide.step(8).ok());
    EXPECT_TRUE(testing::sameBits(*tight.snapshot(), *wide.snapshot()));
    EXPECT_EQ(tight.report().loss, wide.report().loss);
}

TEST_F(TrainerOnDevice, ItsSeedDecides) {
    const auto after = [](std::uint32_t seed) {
        TrainerOptions o = options(4);
        o.seed = seed;
        Trainer trained = trainer(start(), o, truthViews());
        EXPECT_TRUE(trained.step(8).ok());
        return *trained.snapshot();
    };
    const Splats first = after(1);
    EXPECT_TRUE(testing::sameBits(first, after(1)));
    EXPECT_FALSE(testing::sameBits(first, after(2)));
}

TEST_F(TrainerOnDevice, StopsWhenAsked) {
    Trainer trained = trainer(start(), options(), truthViews());
    int asked = 0;
    const auto three = trained.step(10, [&] { return ++asked < 3; });
    ASSERT_TRUE(three.ok());
    EXPECT_EQ(three->steps, 3u);
    EXPECT_EQ(three->loss, 0.0);  // not all views were drawn
    EXPECT_EQ(trained.step(0)->steps, 3u);
}

}  // namespace
}  // namespace macula::splat
