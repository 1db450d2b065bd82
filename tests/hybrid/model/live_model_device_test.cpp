// The peripheral model of what is on a screen, beside the tracer that makes its pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "gpu/lose_device.h"
#include "pipeline/hybrid/frame/compositor.h"
#include "pipeline/hybrid/model/live_model.h"
#include "pipeline/hybrid/model/model_store.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/trace/device_scene.h"
#include "trace/extreme_scenes.h"
#include "trace/gpu_scene.h"

namespace macula::hybrid {
namespace {

using macula::test::loseDeviceAt;
using macula::test::VulkanCall;

constexpr glm::ivec3 kVoxels{24, 24, 24};
constexpr glm::ivec2 kSize{64, 48};

bool always() {
    return true;
}
bool never() {
    return false;
}

// Answers what a test says, and remembers what it was given.
class StoreOfOne final : public ModelStore {
  public:
    StoredModel find(const std::string& key) override {
        ++asked_;
        return key == key_ ? answer_ : StoredModel{.answer = StoredModel::Answer::none};
    }
    void keep(std::shared_ptr<const PeripheralState> state) override { kept_ = std::move(state); }

    std::string key_ = "a";
    StoredModel answer_{};
    int asked_ = 0;
    std::shared_ptr<const PeripheralState> kept_;
};

class LiveModelTest : public trace::DeviceTest {
  protected:
    const std::shared_ptr<const Volume> volume_ =
        scenes::volumeOf(kVoxels, scenes::grid(glm::dvec3(1.0), kVoxels), scenes::blob(kVoxels, 1000));
    const TransferFunction function_ = scenes::ramp(100, 500, 0.6, 1.0);
    const trace::Environment lights_ = trace::Environment::constant(glm::vec3(1.0f));
    const std::shared_ptr<ModelShelf> shelf_ = std::make_shared<ModelShelf>(std::uint64_t(1) << 30);

    static LiveModelOptions options() {
        LiveModelOptions o;
        o.model.firstSteps = 120;
        o.model.roundSteps = 60;
        o.model.settlingSteps = 20;
        o.model.firstCapacity = 300;
        o.model.mostSplats = 300;
        o.model.trend = {.leastFallPerSecond = 0.01, .window = 5, .leastSeconds = 0.02};
        o.model.wanted.sizePx = glm::ivec2(48);
        o.points = {.count = 250, .paths = 32};
        o.samplesPerPixel = 4;
        o.views = 10;
        o.stepsBetweenViews = 4;
        return o;
    }
    trace::View view() const {
        trace::View view = scenes::lookAt(*volume_);
        view.width = kSize.x;
        view.height = kSize.y;
        return view;
    }
    trace::PathTracer onScreen() { return tracer(volume_, function_, lights_, view(), {}); }
    LiveModel beside(const trace::PathTracer& screen, const std::shared_ptr<ModelStore>& store) {
        return std::move(
                   LiveModel::create(device(), screen, std::make_shared<ModelShelf>(1), store, options()))
            .value();
    }
    // What a store says of a model that has learnt.
    StoredModel stored(StoredModel::Answer answer) {
        auto store = std::make_shared<StoreOfOne>();
        store->answer_.answer = StoredModel::Answer::none;
        const trace::PathTracer screen = onScreen();
        LiveModel model = beside(screen, store);
        EXPECT_TRUE(model.show("a", {}).ok());
        search(model);
        learn(model, 60);
        StoredModel found{
            .answer = answer, .splats = model.shown(), .steps = model.news().steps, .gain = model.gain()};
        model.hide();  // hands it to the store
        found.seenMm = store->kept_->seenMm;
        found.state = store->kept_;
        return found;
    }
    LiveModel beside(const trace::PathTracer& screen) {
        return std::move(LiveModel::create(device(), screen, shelf_, nullptr, options())).value();
    }
    static void search(LiveModel& model) {
        for (int i = 0; i < 1000 && model.news().stage == ModelStage::searching; ++i)
            ASSERT_TRUE(model.work(20.0, always).ok());
        ASSERT_TRUE(model.canBeDrawn());
    }
    static void learn(LiveModel& model, std::uint64_t steps = UINT64_MAX) {
        for (int i = 0; i < 5000 && model.hasWork() && model.news().steps < steps; ++i)
            ASSERT_TRUE(model.work(20.0, always).ok());
    }
    std::vector<glm::vec4> drawn(LiveModel& model, const Camera& camera) {
        const auto picture = model.draw(camera, kSize);
        EXPECT_TRUE(picture.ok());
        return (*picture)->read().value();
    }
    static double luminance(const glm::vec4& p) { return 0.2126 * p.x + 0.7152 * p.y + 0.0722 * p.z; }
};

TEST_F(LiveModelTest, IsFoundTaughtAndDrawnBesideAPictureThatStaysAsItIs) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(*screen.trace(64));
    const std::vector<glm::vec4> traced = screen.readback()->radiance;
    LiveModel model = beside(screen);
    EXPECT_EQ(model.news(), ModelNews{});
    EXPECT_FALSE(model.hasWork());
    ASSERT_TRUE(model.show("a", {}).ok());
    EXPECT_EQ(model.news().stage, ModelStage::searching);
    EXPECT_FALSE(model.canBeDrawn());
    EXPECT_FALSE(model.report()) << "there is no model yet";
    search(model);
    EXPECT_NEAR(model.news().splats, 250, 15);
    ASSERT_TRUE(model.report());
    EXPECT_EQ(model.report()->views + model.report()->heldOut, model.news().views);
    EXPECT_GT(model.report()->shownError.value(), 0.0);
    const auto error = [&] {
        const std::vector<glm::vec4> picture = drawn(model, view().camera);
        double sum = 0.0;
        for (std::size_t i = 0; i < picture.size(); ++i) sum += double(glm::length(picture[i] - traced[i]));
        return sum / double(picture.size());
    };
    const double atFirst = error();
    EXPECT_LT(atFirst, 0.15);
    learn(model);
    EXPECT_EQ(model.news().stage, ModelStage::resting);
    EXPECT_FALSE(model.hasWork());
    // Those that it asked for, and some of the gauge's six.
    EXPECT_GT(model.news().views, 10u);
    EXPECT_LE(model.news().views, 16u);
    EXPECT_GE(model.news().steps, 100u);
    EXPECT_LT(error(), atFirst);
    // What is on screen has the samples that it had.
    EXPECT_EQ(screen.statistics()->samplesPerPixel, 64u);
    EXPECT_EQ(screen.readback()->radiance, traced);
}

// A study that is opened again: what was shown at the end is shown at once, and goes on.
TEST_F(LiveModelTest, OfAStoreIsShownAtOnceAndGoesOn) {
    const StoredModel whole = stored(StoredModel::Answer::whole);
    ASSERT_NE(whole.state, nullptr);
    EXPECT_EQ(whole.state->gain, whole.gain);
    auto store = std::make_shared<StoreOfOne>();
    store->answer_ = {};  // pending
    const trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen, store);
    ASSERT_TRUE(model.show("a", {}).ok());
    ASSERT_TRUE(model.work(5.0, always).ok());
    EXPECT_EQ(model.news().stage, ModelStage::searching);
    EXPECT_GT(store->asked_, 1);
    EXPECT_FALSE(model.canBeDrawn());

    store->answer_ = whole;
    store->answer_.answer = StoredModel::Answer::drawable;
    store->answer_.state = nullptr;
    ASSERT_TRUE(model.work(5.0, always).ok());
    EXPECT_EQ(model.news().stage, ModelStage::resuming);
    EXPECT_EQ(model.news().origin, ModelOrigin::stored);
    EXPECT_EQ(model.news().steps, whole.steps);
    ASSERT_TRUE(model.canBeDrawn());
    EXPECT_EQ(model.shown(), whole.splats);
    EXPECT_EQ(model.gain(), whole.gain);
    const std::vector<glm::vec4> atOnce = drawn(model, view().camera);

    store->answer_ = whole;
    ASSERT_TRUE(model.work(5.0, always).ok());
    EXPECT_EQ(model.news().stage, ModelStage::learning);
    EXPECT_EQ(model.news().steps, whole.state->training.steps);
    EXPECT_EQ(model.news().origin, ModelOrigin::stored);
    EXPECT_EQ(drawn(model, view().camera), atOnce) << "the same picture, from the trainer's model";
    learn(model);
    EXPECT_EQ(model.news().stage, ModelStage::resting);
    EXPECT_GE(model.news().steps, whole.state->training.steps);
}

// Putting it away hands it to the store, under its key, only where there is news.
TEST_F(LiveModelTest, WhatWasLearntIsHandedToTheStore) {
    auto store = std::make_shared<StoreOfOne>();
    store->answer_.answer = StoredModel::Answer::none;
    const trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen, store);
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    learn(model, 60);
    const std::shared_ptr<const splat::Splats> shown = model.shown();
    model.hide();
    ASSERT_NE(store->kept_, nullptr);
    EXPECT_EQ(store->kept_->training.options.key, "a");
    EXPECT_GE(store->kept_->training.steps, 60u);
    store->answer_ = {
        .answer = StoredModel::Answer::whole, .splats = shown, .state = std::exchange(store->kept_, nullptr)};
    ASSERT_TRUE(model.show("a", {}).ok());
    EXPECT_TRUE(model.canBeDrawn()) << "the answer was there already: the first picture is of it";
    ASSERT_TRUE(model.work(5.0, always).ok());
    ASSERT_EQ(model.news().origin, ModelOrigin::stored);
    model.hide();
    EXPECT_EQ(store->kept_, nullptr) << "nothing was learnt since";
}

TEST_F(LiveModelTest, WithoutAnAnswerOrOfADamagedOneItBeginsWithPoints) {
    auto store = std::make_shared<StoreOfOne>();
    const trace::PathTracer screen = onScreen();
    LiveModelOptions impatient = options();
    impatient.mostWaitForStore = std::chrono::milliseconds(1);
    LiveModel model = std::move(LiveModel::create(device(), screen, shelf_, store, impatient)).value();
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    EXPECT_EQ(model.news().origin, ModelOrigin::points);

    // Damaged is what comes after what was drawable: the drawn one goes, and the search begins.
    StoredModel drawable = stored(StoredModel::Answer::drawable);
    store->key_ = "b";
    store->answer_ = drawable;
    ASSERT_TRUE(model.show("b", {}).ok());
    for (int i = 0; i < 100 && model.news().stage != ModelStage::resuming; ++i)
        ASSERT_TRUE(model.work(1.0, always).ok());
    ASSERT_TRUE(model.canBeDrawn());
    store->answer_ = {.answer = StoredModel::Answer::damaged};
    ASSERT_TRUE(model.work(5.0, always).ok());
    EXPECT_FALSE(model.canBeDrawn());
    search(model);
    EXPECT_EQ(model.news().origin, ModelOrigin::damagedPoints);
}

// The store has shown what it has, and then it is gone, or the rest cannot be read.
TEST_F(LiveModelTest, WhatIsDrawnWhileItsRestDoesNotComeGivesWayToPoints) {
    const StoredModel drawable = stored(StoredModel::Answer::drawable);
    for (const auto answer : {StoredModel::Answer::none, StoredModel::Answer::warm}) {
        auto store = std::make_shared<StoreOfOne>();
        store->answer_ = drawable;
        const trace::PathTracer screen = onScreen();
        LiveModel model = beside(screen, store);
        ASSERT_TRUE(model.show("a", {}).ok());
        ASSERT_EQ(model.news().stage, ModelStage::resuming);
        store->answer_.answer = answer;
        ASSERT_TRUE(model.work(5.0, always).ok());
        EXPECT_EQ(model.news().stage, ModelStage::searching);
        EXPECT_FALSE(model.canBeDrawn());
        search(model);
        EXPECT_EQ(model.news().origin,
                  answer == StoredModel::Answer::none ? ModelOrigin::points : ModelOrigin::otherLights);
    }
}

// The store gives a model once: what was not gone on with yet is not lost with the device.
TEST_F(LiveModelTest, WhatTheStoreGaveWaitsOnTheShelfWhileItCannotGoOn) {
    const StoredModel whole = stored(StoredModel::Answer::whole);
    auto store = std::make_shared<StoreOfOne>();
    store->answer_ = whole;
    const trace::PathTracer screen = onScreen();
    {
        LiveModel model = std::move(LiveModel::create(device(), screen, shelf_, store, options())).value();
        ASSERT_TRUE(model.show("a", {}).ok());
        ASSERT_EQ(model.news().stage, ModelStage::resuming);
        model.save();  // as after a loss
    }
    EXPECT_EQ(shelf_->find("a"), whole.state);
    store->answer_ = {.answer = StoredModel::Answer::none};
    LiveModel model = std::move(LiveModel::create(device(), screen, shelf_, store, options())).value();
    ASSERT_TRUE(model.show("a", {}).ok());
    EXPECT_EQ(model.news().origin, ModelOrigin::shelf);
    EXPECT_EQ(model.news().steps, whole.state->training.steps);
}

TEST_F(LiveModelTest, BeginsWithTheStoredModelOfOtherLights) {
    StoredModel warm = stored(StoredModel::Answer::warm);
    warm.state = nullptr;
    auto store = std::make_shared<StoreOfOne>();
    store->key_ = "in other lights";
    store->answer_ = warm;
    const trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen, store);
    ASSERT_TRUE(model.show("in other lights", {}).ok());
    ASSERT_TRUE(model.work(5.0, always).ok());
    EXPECT_FALSE(model.canBeDrawn()) << "no model is drawn for another key than its own";
    search(model);
    EXPECT_EQ(model.news().origin, ModelOrigin::otherLights);
    EXPECT_EQ(model.news().splats, warm.splats->size());
}

// The splats of the phase before are a beginning and no more: what is stored of this one, and what this run
// has learnt of it, come first.
TEST_F(LiveModelTest, BeginsWithANeighbourOnlyWhereNothingOfItsOwnIsThere) {
    const trace::PathTracer screen = onScreen();
    LiveModel first = beside(screen);
    ASSERT_TRUE(first.show("phase 1", {}).ok());
    search(first);
    learn(first);
    const auto neighbour = first.shown();

    const auto shelf = std::make_shared<ModelShelf>(std::uint64_t(1) << 30);
    LiveModel model = std::move(LiveModel::create(device(), screen, shelf, nullptr, options())).value();
    ASSERT_TRUE(model.show("phase 2", {}, neighbour).ok());
    EXPECT_FALSE(model.canBeDrawn()) << "it is another phase until it has learnt";
    search(model);
    EXPECT_EQ(model.news().origin, ModelOrigin::neighbour);
    EXPECT_EQ(model.news().splats, neighbour->size());
    learn(model);
    ASSERT_TRUE(model.show("phase 3", {}).ok());  // puts it away
    ASSERT_TRUE(model.show("phase 2", {}, neighbour).ok());
    EXPECT_EQ(model.news().origin, ModelOrigin::shelf);

    const auto store = std::make_shared<StoreOfOne>();
    store->key_ = "phase 2";
    store->answer_ = {.answer = StoredModel::Answer::warm, .splats = neighbour};
    LiveModel stored = beside(screen, store);
    ASSERT_TRUE(stored.show("phase 2", {}, neighbour).ok());
    search(stored);
    EXPECT_EQ(stored.news().origin, ModelOrigin::otherLights);
}

// What a person looks at is learnt from, and wakes a model that had learnt all there was.
TEST_F(LiveModelTest, LearnsFromWhatIsOnScreen) {
    trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    learn(model);
    const std::size_t views = model.news().views;
    ASSERT_FALSE(model.hasWork());
    trace::View close = view();
    close.camera.positionMm = close.camera.targetMm + 0.4 * (close.camera.positionMm - close.camera.targetMm);
    ASSERT_TRUE(screen.setView(close).ok());
    ASSERT_TRUE(*screen.trace(16));
    ASSERT_TRUE(model.learnFrom(screen, close, 16).ok());
    EXPECT_EQ(model.news().views, views + 1);
    ASSERT_TRUE(model.learnFrom(screen, close, 16).ok());
    EXPECT_EQ(model.news().views, views + 1) << "once";
    EXPECT_TRUE(model.hasWork());
    learn(model);
    EXPECT_FALSE(model.hasWork());
    ASSERT_TRUE(*screen.trace(16));
    ASSERT_TRUE(model.learnFrom(screen, close, 32).ok());
    EXPECT_FALSE(model.hasWork()) << "twice the samples are hardly better";
    ASSERT_TRUE(*screen.trace(32));
    ASSERT_TRUE(model.learnFrom(screen, close, 64).ok());
    EXPECT_TRUE(model.hasWork()) << "four times the samples are";
    EXPECT_EQ(model.news().views, views + 1) << "in place of the first";
    learn(model);
    EXPECT_FALSE(model.hasWork());
}

// The same light and coverage on average as what is traced, over what both show, from all sides.
TEST_F(LiveModelTest, IsAsBrightAsWhatIsTraced) {
    constexpr trace::Settings kSettings{.bounces = 4};
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(screen.setSettings(kSettings).ok());
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("a", kSettings).ok());
    search(model);
    learn(model);
    double ofModel = 0.0;
    double ofTracer = 0.0;
    for (int side = 0; side < 8; ++side) {
        Camera camera = view().camera;
        const double angle = glm::radians(45.0 * side);
        const double distance = glm::length(camera.positionMm);
        camera.positionMm =
            distance * glm::dvec3(std::sin(angle), -std::cos(angle), 0.3 * std::sin(2 * angle));
        ASSERT_TRUE(screen.setView({.camera = camera, .width = kSize.x, .height = kSize.y}).ok());
        ASSERT_TRUE(*screen.trace(64));
        const std::vector<glm::vec4> traced = screen.readback()->radiance;
        const std::vector<glm::vec4> picture = drawn(model, camera);
        for (std::size_t i = 0; i < traced.size(); ++i) {
            if (traced[i].w < 0.5f || picture[i].w < 0.5f) continue;
            ofModel += model.gain() * luminance(picture[i]);
            ofTracer += luminance(traced[i]);
        }
    }
    EXPECT_NEAR(ofModel / ofTracer, 1.0, 0.02);
}

TEST_F(LiveModelTest, GivesTheThreadBackAfterEachDispatchAndGoesOnThere) {
    trace::PathTracer screen = onScreen();
    LiveModel whole = beside(screen);
    ASSERT_TRUE(whole.show("whole", {}).ok());
    search(whole);
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("pieces", {}).ok());
    int pieces = 0;
    for (; model.news().stage == ModelStage::searching && pieces < 1000; ++pieces)
        ASSERT_TRUE(model.work(1e9, never).ok());
    EXPECT_GT(pieces, 2);
    ASSERT_TRUE(model.canBeDrawn());
    EXPECT_EQ(drawn(model, view().camera), drawn(whole, view().camera));
    // Views and steps, too.
    const ModelNews before = model.news();
    for (int i = 0; i < 5000 && model.news().views < before.views + 2; ++i)
        ASSERT_TRUE(model.work(1e9, never).ok());
    EXPECT_EQ(model.news().views, before.views + 2);
    EXPECT_LE(model.news().steps, before.steps + 20);
}

// What a hand would have to wait for is not begun, nor what nobody knows the time of.
TEST_F(LiveModelTest, BetweenFramesInMotionItLearnsOnlyWhatFits) {
    trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("a", {}).ok());
    ASSERT_TRUE(model.workWithin(1e6, always).ok()) << "a search waits for the hand to rest";
    EXPECT_EQ(model.news().stage, ModelStage::searching);
    search(model);
    const std::uint64_t first = model.news().steps;
    ASSERT_TRUE(model.workWithin(1e6, always).ok());
    EXPECT_EQ(model.news().steps, first) << "it has not learnt here before";
    for (int i = 0; i < 5000 && (model.news().steps < first + 8 || model.news().views < 8); ++i)
        ASSERT_TRUE(model.work(1e9, never).ok());

    const auto picture = drawn(model, view().camera);
    ModelNews before = model.news();
    ASSERT_TRUE(model.workWithin(0.0, always).ok());
    EXPECT_EQ(model.news(), before) << "there is no time";
    EXPECT_EQ(drawn(model, view().camera), picture);
    int asked = 0;
    ASSERT_TRUE(model.workWithin(1e6, [&] { return ++asked < 40; }).ok());
    EXPECT_EQ(model.news().stage, ModelStage::learning);
    EXPECT_GT(model.news().steps, before.steps);
    before = model.news();
    ASSERT_TRUE(model.workWithin(1e6, never).ok());
    EXPECT_LE(model.news().steps, before.steps + 1) << "the hand moves on";
}

TEST_F(LiveModelTest, IsNeverDrawnForAnotherKeyAndComesBackAsItWas) {
    trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    learn(model, 12);
    const ModelNews before = model.news();
    const std::vector<glm::vec4> whole = drawn(model, view().camera);
    ASSERT_TRUE(model.show("a", {}).ok());
    EXPECT_EQ(model.news(), before);

    Clip half;
    half.planes = {{glm::dvec3(1, 0, 0), 0.0}};
    ASSERT_TRUE(screen.scene().setClip(half).ok());
    ASSERT_TRUE(model.show("half", {}).ok());
    EXPECT_FALSE(model.canBeDrawn());
    EXPECT_EQ(model.news().stage, ModelStage::searching);
    search(model);
    const std::vector<glm::vec4> clipped = drawn(model, view().camera);
    double right = 0.0;
    double left = 0.0;
    for (int y = 0; y < kSize.y; ++y) {
        for (int x = 0; x < kSize.x; ++x)
            (x < kSize.x / 2 ? left : right) += double(clipped[std::size_t(y * kSize.x + x)].w);
    }
    // Seen from the front, what lies to the patient's left, at +x, is at the right.
    EXPECT_GT(right, 10.0 * left);

    ASSERT_TRUE(screen.scene().setClip({}).ok());
    ASSERT_TRUE(model.show("a", {}).ok());
    ASSERT_TRUE(model.canBeDrawn());
    EXPECT_EQ(model.news().steps, before.steps);
    EXPECT_EQ(model.news().views, before.views);
    EXPECT_EQ(drawn(model, view().camera), whole) << "whatever was learnt since, what was shown is shown";
    model.hide();
    EXPECT_FALSE(model.canBeDrawn());
    EXPECT_EQ(model.news().stage, ModelStage::none);
}

TEST_F(LiveModelTest, OfNothingThereIsNone) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(screen.scene().setTransferFunction(scenes::ramp(60000, 61000, 0.6, 1.0)).ok());
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("nothing", {}).ok());
    for (int i = 0; i < 10 && model.hasWork(); ++i) ASSERT_TRUE(model.work(20.0, always).ok());
    EXPECT_EQ(model.news().stage, ModelStage::nothingToSee);
    EXPECT_FALSE(model.canBeDrawn());
}

// Whatever is done while the device has no memory left: what was learnt stays, nothing else is touched, and
// it is made once there is room.
TEST_F(LiveModelTest, WithoutMemoryItSaysSoAndKeepsWhatItHas) {
    trace::PathTracer screen = onScreen();
    ASSERT_TRUE(*screen.trace(4));
    const std::vector<glm::vec4> traced = screen.readback()->radiance;
    LiveModel model = beside(screen);
    {
        ASSERT_TRUE(model.show("a", {}).ok());
        const macula::test::NoMemory full;
        for (int i = 0; i < 1000 && model.hasWork(); ++i) ASSERT_TRUE(model.work(20.0, always).ok());
        EXPECT_GT(full.refused(), 0);
        EXPECT_EQ(model.news().stage, ModelStage::noRoom);
        EXPECT_FALSE(model.canBeDrawn());
        ASSERT_TRUE(model.show("a", {}).ok());
        EXPECT_FALSE(model.hasWork()) << "the same is not tried again";
    }
    EXPECT_EQ(screen.readback()->radiance, traced);
    model.hide();
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    learn(model, 30);
    const Camera front = view().camera;
    const std::vector<glm::vec4> before = drawn(model, front);
    {
        // Pictures of another size than any that it has room for.
        const macula::test::NoMemory full;
        const auto picture = model.draw(front, {1500, 1100});
        EXPECT_GT(full.refused(), 0);
        ASSERT_FALSE(picture.ok());
        EXPECT_EQ(picture.error().code, ErrorCode::outOfMemory);
        EXPECT_EQ(model.news().stage, ModelStage::noRoom);
        EXPECT_FALSE(model.canBeDrawn());
    }
    model.hide();
    ASSERT_TRUE(model.show("a", {}).ok());
    ASSERT_TRUE(model.canBeDrawn()) << "what was learnt is on the shelf";
    EXPECT_GE(model.news().steps, 30u);
    EXPECT_EQ(drawn(model, front).size(), before.size());
}

// From splats to what the window is given, no pixel and no splat goes through the host.
TEST_F(LiveModelTest, APictureInMotionStaysOnTheDevice) {
    trace::PathTracer screen = onScreen();
    LiveModel model = beside(screen);
    ASSERT_TRUE(model.show("a", {}).ok());
    search(model);
    Compositor compositor = *Compositor::create(device());
    const auto frame = [&](double degrees) {
        Camera camera = view().camera;
        const double distance = glm::length(camera.positionMm);
        camera.positionMm =
            distance * glm::dvec3(std::sin(glm::radians(degrees)), -std::cos(glm::radians(degrees)), 0.0);
        const auto splats = model.draw(camera, kSize);
        ASSERT_TRUE(splats.ok());
        ASSERT_TRUE(compositor.compose({.splats = *splats, .sizePx = kSize}, {}).ok());
        ASSERT_TRUE(device()->waitForAll().ok());
    };
    frame(0.0);
    const std::uint64_t before = device()->bytesRead();
    for (int i = 1; i <= 5; ++i) frame(10.0 * i);
    // Where the device lists the splats of tiles itself, it tells how many there are.
    EXPECT_LE(device()->bytesRead() - before, 5 * sizeof(std::uint32_t));
}

// The device is lost while it searches, while it learns, and while it is drawn; what was learnt is not.
TEST_F(LiveModelTest, WhatWasLearntOutlivesTheDevice) {
    const auto withOwnDevice = [&](const std::function<void(LiveModel&)>& doThis) {
        const std::shared_ptr<gpu::Device> own = *gpu::Device::create(instance());
        trace::PathTracer screen = *trace::PathTracer::create(own);
        ASSERT_TRUE(screen.scene().setVolume(volume_).ok());
        ASSERT_TRUE(screen.scene().setTransferFunction(function_).ok());
        ASSERT_TRUE(screen.scene().setEnvironment(lights_).ok());
        LiveModel model = *LiveModel::create(own, screen, shelf_, nullptr, options());
        ASSERT_TRUE(model.show("a", {}).ok());
        doThis(model);
        loseDeviceAt(VulkanCall::submit, 1, 0);
    };
    const auto lose = [](LiveModel& model) {
        loseDeviceAt(VulkanCall::submit, 2, 1);
        Result<void> done;
        for (int i = 0; i < 100 && done; ++i) done = model.work(20.0, always);
        ASSERT_FALSE(done.ok());
        EXPECT_EQ(done.error().code, ErrorCode::deviceLost);
        model.save();
    };
    withOwnDevice([&](LiveModel& model) {
        lose(model);
        EXPECT_EQ(shelf_->size(), 0u);
    });
    withOwnDevice([&](LiveModel& model) {
        EXPECT_FALSE(model.canBeDrawn());
        search(model);
        learn(model, 30);
        lose(model);
    });
    withOwnDevice([&](LiveModel& model) {
        ASSERT_TRUE(model.canBeDrawn());
        EXPECT_GT(model.news().views, 0u);
        loseDeviceAt(VulkanCall::submit, 1, 1);
        const auto picture = model.draw(view().camera, kSize);
        ASSERT_FALSE(picture.ok());
        EXPECT_EQ(picture.error().code, ErrorCode::deviceLost);
        model.save();
    });
    withOwnDevice([&](LiveModel& model) {
        ASSERT_TRUE(model.canBeDrawn());
        learn(model);
        EXPECT_EQ(model.news().stage, ModelStage::resting);
    });
}

}  // namespace
}  // namespace macula::hybrid
