// Training where the device makes the lists of tiles: the same bits as where the host does.
#include "gpu/lose_device.h"
#include "splat/train/training_scene.h"
#include "splat/training_support.h"

namespace macula::splat {
namespace {

class TrainerLists : public TrainingTest {
  protected:
    static TrainingState after(std::uint64_t steps, ListMaker lists, const Splats& model,
                               const TrainerOptions& o, const std::vector<TrainingView>& of) {
        Trainer trainer = std::move(Trainer::create(device(), model, o, lists)).value();
        for (const TrainingView& view : of) EXPECT_TRUE(trainer.addView(view).ok());
        EXPECT_TRUE(trainer.step(steps).ok());
        return std::move(trainer.state()).value();
    }
};

TEST_F(TrainerLists, OnTheDeviceAreTheSameTraining) {
    TrainerOptions o = options(10);
    o.density = {.firstStep = 8, .every = 8, .lastStep = 24};
    const TrainingState onHost = after(30, ListMaker::host, start(), o, truthViews());
    const TrainingState onDevice = after(30, ListMaker::device, start(), o, truthViews());
    testing::expectSame(onDevice, onHost, "after 30 steps");
}

// So many splats that fill every tile.
Splats thoseThatFill(Splats model, std::size_t count) {
    model.resize(count);
    for (glm::vec3& scale : model.logScale) scale = glm::vec3(6.0f);
    return model;
}

TrainingView largeView(glm::ivec2 sizePx = {400, 320}) {
    TrainingView view{
        .view = rasterView({.positionMm = {0, -500, 0}, .verticalFovDeg = 14.0}, sizePx, glm::dvec3(0.0))
                    .value()};
    view.pixels.assign(std::size_t(sizePx.x) * std::size_t(sizePx.y), glm::vec4(0.25f, 0.5f, 0.25f, 0.75f));
    return view;
}

// Of ten splats that fill a thousand tiles each there are more pairs than there is room for at first.
TEST_F(TrainerLists, AStepThatHasNoRoomIsDoneAgain) {
    const Splats model = thoseThatFill(truth(), 10);
    const TrainingView view = largeView();
    const TrainerOptions o = options(0);

    // What the trainer draws with: the first time it has no room.
    auto parameters = std::move(*SplatBuffer::create(device(), "parameters", 10, model.shDegree));
    ASSERT_TRUE(parameters.upload(componentsOf(model)).ok());
    Rasterizer rasterizer =
        std::move(*Rasterizer::create(device(), 10, model.shDegree, {.lists = ListMaker::device}));
    auto recorder = std::move(*gpu::Recorder::create(device(), "draw"));
    Result<RasterPass> pass =
        rasterizer.recordDraw(recorder, parameters, 10, view.view, blendingOf(model.lowPass));
    ASSERT_TRUE(pass.ok());
    ASSERT_TRUE(recorder.submit().ok());
    const Result<bool> hadRoom = rasterizer.settle(*pass);
    ASSERT_TRUE(hadRoom.ok());
    EXPECT_FALSE(*hadRoom);

    const TrainingState onHost = after(2, ListMaker::host, model, o, {view});
    const TrainingState onDevice = after(2, ListMaker::device, model, o, {view});
    EXPECT_EQ(onDevice.optimizer.stepsDone, 2u);
    testing::expectSame(onDevice, onHost, "after 2 steps");
    EXPECT_NE(onHost.splats.dc, model.dc);
}

// The derivatives of the pairs grow while commands are recorded: the smaller buffer must go before there is
// room for the larger one.
TEST_F(TrainerLists, WhatIsDroppedWhileRecordingMakesRoom) {
    const Splats model = thoseThatFill(truth(), 40);  // in 250 tiles
    const TrainingView view = largeView({200, 160});
    const TrainingState expected = after(2, ListMaker::device, model, options(0), {view});
    Trainer trainer = std::move(Trainer::create(device(), model, options(0), ListMaker::device)).value();
    ASSERT_TRUE(trainer.addView(view).ok());
    // The picture takes 512 kB. The derivatives of the pairs there is room for at first, 4096, take 44 bytes
    // each, and those of one and a half times 10 000 660 kB.
    const test::NoMemory full(600'000, 150'000);
    const auto done = trainer.step(2);
    ASSERT_TRUE(done.ok()) << done.error().message;
    EXPECT_GT(full.refused(), 0);
    testing::expectSame(trainer.state().value(), expected, "after 2 steps");
}

// A view that the device has no room for is left out, and the others are learnt all the same. When there is
// room for none, that is an error, and not for ever.
TEST_F(TrainerLists, AViewWithoutRoomDoesNotStopTheOthers) {
    for (const ListMaker lists : {ListMaker::host, ListMaker::device}) {
        Trainer trainer = std::move(Trainer::create(device(), start(), options(0), lists)).value();
        ASSERT_TRUE(trainer.addView(largeView()).ok());
        for (const TrainingView& view : truthViews()) ASSERT_TRUE(trainer.addView(view).ok());
        {
            const test::NoMemory full(1'000'000);  // of the large picture
            const auto done = trainer.step(20);
            ASSERT_TRUE(done.ok()) << done.error().message;
            EXPECT_GT(full.refused(), 0);
            EXPECT_EQ(done->steps, 20u);
            EXPECT_GT(done->loss, 0.0);
            EXPECT_FALSE(trainer.wasDrawn(0));
            for (std::size_t i = 1; i < trainer.viewCount(); ++i) EXPECT_TRUE(trainer.wasDrawn(i)) << i;
        }
        TrainerOptions other = options(0);
        other.seed = 4;
        ASSERT_TRUE(trainer.goOnWith(other, 0).ok());
        ASSERT_TRUE(trainer.step(6).ok());
        EXPECT_TRUE(trainer.wasDrawn(0));
        EXPECT_TRUE(trainer.state()->splats.validate().ok());
    }
    Trainer alone = std::move(Trainer::create(device(), start(), options(0))).value();
    ASSERT_TRUE(alone.addView(largeView()).ok());
    {
        const test::NoMemory full(1'000'000);
        EXPECT_EQ(alone.step(1).error().code, ErrorCode::outOfMemory);
        EXPECT_EQ(alone.step(1).error().code, ErrorCode::outOfMemory);
    }
    EXPECT_TRUE(alone.step(1).ok());
}

}  // namespace
}  // namespace macula::splat
