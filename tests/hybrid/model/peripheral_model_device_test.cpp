// A model that runs by itself, on the device: what it learns from are pictures of a known one.
#include "gpu/lose_device.h"
#include "hybrid/model/peripheral_scene.h"

namespace macula::hybrid {
namespace {

using Peripheral = PeripheralTest;
using test::VulkanCall;

TEST_F(Peripheral, StopsByItselfAndIsWokenByWhatIsNew) {
    PeripheralModel model = begun();
    EXPECT_EQ(model.report().pause, Pause::noViews);
    ASSERT_TRUE(model.step(10.0).ok());
    EXPECT_EQ(model.report().training.steps, 0u);
    EXPECT_TRUE(splat::testing::sameBits(*model.shown().splats, withDirections(TrainingTest::start())));
    EXPECT_EQ(model.state()->training.splats.shDegree, 1);
    EXPECT_EQ(model.shown().generation, 1u);

    EXPECT_EQ(giveWanted(model, truth(), 8), 5u);
    PeripheralReport report = model.report();
    EXPECT_EQ(report.heldOut, 3u);
    ASSERT_TRUE(report.error);
    EXPECT_EQ(report.isSharp, std::optional(false)) << "its splats are not where they belong";
    const double before = *report.error;
    const std::uint64_t steps = run(model);
    report = model.report();
    EXPECT_TRUE(isComparedAsJudged(model)) << "by squares it would be judged worse than it is";
    EXPECT_EQ(report.pause, Pause::flat) << describe(report.pause);
    EXPECT_GT(steps, 50u);
    EXPECT_LT(*report.error, 0.6 * before);
    EXPECT_LE(*report.shownError, 1.01 * *report.error);
    EXPECT_GT(model.shown().generation, 2u);
    EXPECT_GT(psnrOf(*model.shown().splats), psnrOf(TrainingTest::start()) + 3.0);
    EXPECT_EQ(report.isSharp, std::optional(true));
    auto resumed = PeripheralModel::resume(device(), *model.state(), options());
    ASSERT_TRUE(resumed.ok());
    EXPECT_EQ(resumed->report().isSharp, std::optional(true)) << "it is judged at once";

    // Paused, it costs nothing and changes nothing.
    const auto submitted = test::countOf(VulkanCall::submit);
    const std::uint64_t generation = model.shown().generation;
    for (int i = 0; i < 100; ++i) ASSERT_TRUE(model.step(1000.0).ok());
    EXPECT_EQ(test::countOf(VulkanCall::submit), submitted);
    EXPECT_EQ(model.report().training.steps, steps);
    EXPECT_EQ(model.shown().generation, generation);

    // What it has does not wake it, what is new does, and with enough of that there is another round.
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(20.0)), false), Offered::learnt);
    EXPECT_FALSE(model.isPaused());
    run(model);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(20.5)), false), Offered::nothingNew);
    EXPECT_TRUE(model.isPaused());
    EXPECT_EQ(model.report().rounds, 1u);

    // Of the same view, one of more samples replaces one of fewer.
    const auto withSamples = [](double samples) {
        TracedView view = picture(truth(), cameraAt(20.0));
        view.samplesPerPixel = samples;
        return view;
    };
    for (const double samples : {2.0, 8.0}) {
        EXPECT_EQ(*model.offer(withSamples(samples), false), Offered::nothingNew) << samples;
        EXPECT_TRUE(model.isPaused());
    }
    const std::size_t views = model.report().views;
    EXPECT_EQ(*model.offer(withSamples(32.0), false), Offered::learnt);
    EXPECT_FALSE(model.isPaused());
    EXPECT_EQ(model.report().views, views);
    run(model);
    EXPECT_EQ(*model.offer(withSamples(8.0), false), Offered::nothingNew);
    giveWanted(model, truth(), 3);
    run(model);
    EXPECT_EQ(model.report().rounds, 2u);
    EXPECT_TRUE(isComparedAsJudged(model));
    EXPECT_GT(model.report().training.splats, 60u);
    EXPECT_EQ(model.state()->training.splats.shDegree, 1);
}

TEST_F(Peripheral, IsWokenByThePictureThatItCanBeJudgedBy) {
    PeripheralOptions o = options();
    o.firstSteps = 20;
    PeripheralModel model = begun(o);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(0.0))), Offered::heldOut);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(20.0))), Offered::learnt);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(40.0))), Offered::learnt);
    const std::uint64_t steps = run(model);
    EXPECT_EQ(model.report().pause, Pause::notJudged);
    EXPECT_EQ(model.report().isSharp, std::nullopt);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(60.0))), Offered::heldOut);
    EXPECT_FALSE(model.isPaused());
    EXPECT_GT(run(model), steps);
    EXPECT_EQ(model.report().pause, Pause::flat);
}

TEST_F(Peripheral, DoesOneThingAtATimeWhenThereIsNoTime) {
    PeripheralModel model = begun();
    giveWanted(model, truth(), 8);
    std::uint64_t steps = 0;
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        ASSERT_TRUE(model.step(0.0).ok());
        const std::uint64_t now = model.report().training.steps;
        ASSERT_LE(now, steps + 1);
        compared += now == steps ? 1 : 0;
        steps = now;
    }
    // Three pictures every 15 steps.
    EXPECT_EQ(compared, 9);
}

// A vessel, or a few nodules far apart.
TEST_F(Peripheral, WantsViewsOfWhatCoversLittleOfAny) {
    ModelStart sparse = start();
    for (glm::vec3& scale : sparse.splats.logScale) scale -= 4.0f;
    PeripheralModel model = std::move(PeripheralModel::begin(device(), sparse, options())).value();
    const TracedView seen = picture(sparse.splats, cameraAt(0.0));
    double covered = 0.0;
    for (const glm::vec4& pixel : seen.rgba) covered += pixel.a;
    ASSERT_GT(covered, 0.0);
    ASSERT_LT(covered, 0.04 * double(seen.rgba.size()));
    giveWanted(model, sparse.splats, 6);
    EXPECT_GT(model.report().views, 1u);
    EXPECT_GT(model.report().heldOut, 0u);
}

TEST_F(Peripheral, JudgesAtTheCostThatIsStated) {
    PeripheralModel model = begun(neverPaused());
    // Held-out pictures are larger than what it learns from.
    for (int i = 0; i < 8; ++i) {
        const auto wanted = model.wantedView().value();
        ASSERT_TRUE(wanted);
        const glm::ivec2 size = i == 0 || i == 3 ? glm::ivec2(90, 80) : kSize;
        ASSERT_TRUE(model.offer(picture(truth(), wanted->camera, size)).ok());
    }
    const PeripheralState state = model.lastGood();
    double heldOutPx = 0.0;
    for (const auto& heldOut : state.heldOut) heldOutPx += double(heldOut->pixels.size());
    ASSERT_GT(heldOutPx, 2.0 * 90.0 * 80.0);
    std::uint64_t steps = 0;
    std::uint64_t comparisons = 0;
    for (int i = 0; i < 250; ++i) {  // one thing at a time
        ASSERT_TRUE(model.step(0.0).ok());
        const std::uint64_t now = model.report().training.steps;
        comparisons += now == steps ? 1u : 0u;
        steps = now;
    }
    // A fifth of the pixels, and not much less: they are compared at whole numbers of steps.
    const double comparedPx = double(comparisons) / double(state.heldOut.size()) * heldOutPx;
    const double learntPx = double(steps) * double(kSize.x * kSize.y);
    EXPECT_LE(comparedPx, options().judgingShare * learntPx);
    EXPECT_GT(comparedPx, 0.5 * options().judgingShare * learntPx);
    EXPECT_GT(model.report().judgingSeconds, 0.0);
    EXPECT_GT(model.report().trainingSeconds, model.report().judgingSeconds);
}

TEST_F(Peripheral, AsksForTheOtherSideAndIsBetterThereForIt) {
    // Nothing of the back is seen from the front, and the start knows no colours.
    splat::Splats opaque = truth();
    for (float& logit : opaque.opacityLogit) logit = 5.0f;
    for (glm::vec3& scale : opaque.logScale) scale = glm::max(scale, glm::vec3(std::log(8.0f)));
    ModelStart grey = start();
    grey.splats = opaque;
    for (glm::vec3& dc : grey.splats.dc) dc = glm::vec3(0.5f);
    PeripheralModel model = std::move(PeripheralModel::begin(device(), grey, neverPaused())).value();
    for (const double degrees : {-25.0, -15.0, -5.0, 5.0, 15.0, 25.0})
        ASSERT_TRUE(model.offer(picture(opaque, cameraAt(degrees))).ok());
    learn(model, 150);
    const splat::Splats oneSided = *model.shown().splats;
    const double front = psnrFrom(oneSided, opaque, cameraAt(0.0));
    for (int i = 0; i < 5; ++i) {
        const auto wanted = model.wantedView().value();
        ASSERT_TRUE(wanted);
        const glm::dvec3 from = glm::normalize(wanted->camera.positionMm);
        if (i == 0) {
            EXPECT_GT(from.y, 0.6) << "the views were from -y";
        }
        EXPECT_GT(from.y, -0.75);
        ASSERT_TRUE(model.offer(picture(opaque, wanted->camera)).ok());
    }
    learn(model, 500);
    const auto gainOf = [&](const splat::Splats& after) {
        double gain = 0.0;
        for (const Camera& camera : {cameraAt(180.0), cameraAt(160.0, 60.0), cameraAt(200.0, -60.0)})
            gain += (psnrFrom(after, opaque, camera) - psnrFrom(oneSided, opaque, camera)) / 3.0;
        return gain;
    };
    const splat::Splats after = model.state()->training.splats;
    EXPECT_GT(gainOf(after), 2.0);
    EXPECT_GT(psnrFrom(after, opaque, cameraAt(0.0)), front - 2.0);
    EXPECT_GT(gainOf(*model.shown().splats), 2.0);
}

// A thin disc, known from both its faces: newest is what lies along its edge, and nothing shows from there.
TEST_F(Peripheral, AsksForWhatShowsWhereTheNewestViewsShowNothing) {
    ModelStart disc = start();
    splat::Splats& splats = disc.splats;
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const double angle = 2.4 * double(i);
        const double radius = 45.0 * std::sqrt((double(i) + 0.5) / double(splats.size()));
        splats.position[i] = glm::vec3(radius * std::cos(angle), 0.0, radius * std::sin(angle));
        splats.rotation[i] = glm::vec4(1, 0, 0, 0);
        splats.logScale[i] = glm::vec3(std::log(5.0f), std::log(0.1f), std::log(5.0f));
        splats.opacityLogit[i] = 5.0f;
    }
    PeripheralModel model = std::move(PeripheralModel::begin(device(), disc, neverPaused())).value();
    for (const double degrees : {0.0, 180.0})
        ASSERT_TRUE(model.offer(picture(splats, cameraAt(degrees))).ok());
    const auto wanted = model.wantedView().value();
    ASSERT_TRUE(wanted);
    const glm::dvec3 from = glm::normalize(wanted->camera.positionMm - wanted->camera.targetMm);
    EXPECT_GT(std::abs(from.y), 0.1) << "from the edge nothing shows";
    EXPECT_LT(std::abs(from.y), 0.9) << "both faces are known";
}

// The same order of offers and steps is the same model, whoever asks what.
TEST_F(Peripheral, IsAFunctionOfTheSeed) {
    PeripheralModel one = begun();
    PeripheralModel two = begun();
    for (int i = 0; i < 6; ++i) {
        const auto a = one.wantedView().value();
        const auto b = two.wantedView().value();
        ASSERT_TRUE(a && b);
        EXPECT_EQ(a->camera.positionMm, b->camera.positionMm);
        ASSERT_TRUE(one.offer(picture(truth(), a->camera)).ok());
        ASSERT_TRUE(two.offer(picture(truth(), b->camera)).ok());
        const auto once = [n = 0]() mutable { return ++n < 2; };
        ASSERT_TRUE(one.step(1e6, once).ok());
        ASSERT_TRUE(two.step(1e6, once).ok());
        (void)one.report();
    }
    EXPECT_TRUE(splat::testing::sameBits(one.state()->training.splats, two.state()->training.splats));
    PeripheralOptions other = options();
    other.seed = 8;
    EXPECT_NE(begun(other).wantedView().value()->camera.positionMm,
              begun().wantedView().value()->camera.positionMm);
}

// A little worse again and again would be much.
TEST_F(Peripheral, WhatIsShownDoesNotGetWorseLittleByLittle) {
    PeripheralOptions o = neverPaused();
    o.shownMayBeWorse = 0.8;
    o.newViewsForRound = 1e9;  // a round begins with warm rates, and much is worse at once
    PeripheralModel model = begun(o);
    giveWanted(model, truth(), 8);
    learn(model, 60);
    double best = *model.report().shownError;
    // From now on all pictures are more and more wrong, and those by which it is judged are not.
    for (int i = 0; i < 24; ++i) {
        splat::Splats wrong = truth();
        for (glm::vec3& dc : wrong.dc) dc *= 1.0f - 0.04f * float(i);
        ASSERT_EQ(*model.offer(picture(wrong, cameraAt(15.0 * i + 7.0, 200.0)), false), Offered::learnt);
        learn(model, 15);
        best = std::min(best, *model.report().shownError);
        ASSERT_LE(*model.report().shownError, (1.0 + o.shownMayBeWorse) * best);
    }
    EXPECT_GT(*model.report().error, 2.0 * best) << "it was to become worse";
}

// What is shown is judged by a new picture as it is, and not as if it were the model, which has become worse
// since.
TEST_F(Peripheral, ANewPictureDoesNotExcuseWhatHasBecomeWorse) {
    PeripheralOptions o = neverPaused();
    o.newViewsForRound = 1e9;
    PeripheralModel model = begun(o);
    giveWanted(model, truth(), 8);
    learn(model, 100);
    const double good = psnrOf(*model.shown().splats);
    splat::Splats wrong = truth();
    for (glm::vec3& dc : wrong.dc) dc *= 0.2f;
    for (int i = 0; i < 24; ++i)
        ASSERT_EQ(*model.offer(picture(wrong, cameraAt(15.0 * i + 7.0, 200.0)), false), Offered::learnt);
    learn(model, 300);
    const PeripheralReport before = model.report();
    ASSERT_GT(*before.error, 1.5 * *before.shownError) << "it was to become worse";
    // Whoever is held out now.
    std::size_t offered = 0;
    while (model.report().heldOut < before.heldOut + 1 && offered < 40)
        ASSERT_TRUE(model.offer(picture(truth(), cameraAt(9.0 * double(offered++), -150.0))).ok());
    ASSERT_EQ(model.report().heldOut, before.heldOut + 1);
    // Of the new one alone.
    const double held = double(before.heldOut);
    const double error = (held + 1.0) * *model.report().error - held * *before.error;
    const double shownError = (held + 1.0) * *model.report().shownError - held * *before.shownError;
    EXPECT_GT(error, 1.3 * shownError);
    EXPECT_GT(psnrOf(*model.shown().splats), good - 1.0);
}

TEST_F(Peripheral, ReducesPicturesThatAreLargerThanOfUse) {
    PeripheralOptions o = options();
    o.learntSidePx = 90;
    PeripheralModel model = begun(o);
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(0.0))), Offered::heldOut);
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(40.0), {181, 160})), Offered::learnt);
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(80.0), {90, 80})), Offered::learnt);
    const splat::TrainingState state = model.lastGood().training;
    ASSERT_EQ(state.views.size(), 2u);
    EXPECT_EQ(state.views[0].given->view.sizePx, glm::ivec2(90, 80));
    EXPECT_EQ(state.views[1].given->view.sizePx, glm::ivec2(90, 80));
    ASSERT_TRUE(model.step(10.0).ok());
}

TEST_F(Peripheral, TakesNoMorePicturesThanItsShareOfTheMemory) {
    PeripheralOptions o = options();
    const double free = double(device()->memoryAvailableBytes());
    o.viewsShare = 2.5 * 27.0 * kSize.x * kSize.y / free;
    PeripheralModel model = begun(o);
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(0.0))), Offered::heldOut);
    int learnt = 0;
    while (learnt < 6 &&
           *model.offer(picture(truth(), cameraAt(15.0 + 15.0 * learnt)), false) != Offered::full)
        ++learnt;
    EXPECT_GE(learnt, 2);
    EXPECT_LE(learnt, 4);  // one more is held out
    EXPECT_FALSE(*model.wantedView());
    ASSERT_TRUE(model.step(10.0).ok());
}

TEST_F(Peripheral, WithoutMemoryForAStepItPausesAndGoesOnWhenWoken) {
    PeripheralModel model = begun(neverPaused());
    giveWanted(model, truth(), 6);
    learn(model, 20);
    const auto shown = model.shown();
    // Of a size that it has no room to compare yet.
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(33.0, 20.0), {61, 47}), false), Offered::learnt);
    {
        const test::NoMemory full;
        Result<void> done;
        for (int i = 0; i < 100 && done.ok(); ++i) done = model.step(20.0);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, ErrorCode::outOfMemory);
        const int refused = full.refused();
        EXPECT_GT(refused, 0);
        EXPECT_EQ(model.report().pause, Pause::outOfMemory);
        EXPECT_TRUE(model.step(1000.0).ok());
        EXPECT_EQ(full.refused(), refused) << "paused, it does not try again";
    }
    EXPECT_TRUE(model.shown().splats->validate().ok());
    EXPECT_TRUE(model.lastGood().training.splats.validate().ok());
    EXPECT_GE(model.shown().generation, shown.generation);

    EXPECT_TRUE(model.isPaused());
    ASSERT_EQ(*model.offer(picture(truth(), cameraAt(66.0, -20.0), {61, 47}), false), Offered::learnt);
    EXPECT_FALSE(model.isPaused());
    learn(model, 150);
    EXPECT_GT(psnrOf(*model.shown().splats), psnrOf(TrainingTest::start()) + 3.0);
}

TEST_F(Peripheral, TakesPicturesOfAnySizeAndSaysWhatBecameOfThem) {
    PeripheralOptions o = options();
    o.mostViews = 7;
    PeripheralModel model = begun(o);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(0.0))), Offered::heldOut);
    EXPECT_TRUE(model.isPaused()) << "nothing to learn from yet";
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(0.0))), Offered::learnt) << "known only to the judge";
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(40.0, 0.0, 5.0), {64, 64}), false), Offered::learnt);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(80.0, 0.0, 2.0), {17, 90}), false), Offered::heldOut)
        << "without two nothing is judged";
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(120.0, 0.0, 10.0), {300, 20}), false), Offered::learnt);
    ASSERT_TRUE(model.step(1.0).ok());

    TracedView bad = picture(truth(), cameraAt(200.0));
    bad.rgba.pop_back();
    EXPECT_EQ(model.offer(bad).error().code, ErrorCode::inputNotUsable);
    bad.rgba.assign(std::size_t(kSize.x) * std::size_t(kSize.y), glm::vec4(std::nanf("")));
    EXPECT_EQ(model.offer(bad).error().code, ErrorCode::inputNotUsable);
    bad.sizePx = {0, 0};
    EXPECT_EQ(model.offer(bad).error().code, ErrorCode::usage);
    EXPECT_EQ(model.report().views, 3u);
    EXPECT_EQ(model.report().heldOut, 2u);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(200.0))), Offered::learnt);
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(240.0))), Offered::heldOut) << "from another side";
    EXPECT_EQ(*model.offer(picture(truth(), cameraAt(280.0))), Offered::full);
    EXPECT_FALSE(*model.wantedView());
    EXPECT_EQ(model.report().views, 4u);
}

}  // namespace
}  // namespace macula::hybrid
