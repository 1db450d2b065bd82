// Training where the device makes the lists of tiles: the same bits as where the host does.
#include "splat/training_scene.h"
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

// Of ten splats that fill a thousand tiles each there are more pairs than there is room for at first.
TEST_F(TrainerLists, AStepThatHasNoRoomIsDoneAgain) {
    Splats model = truth();
    model.resize(10);
    for (glm::vec3& scale : model.logScale) scale = glm::vec3(6.0f);
    TrainingView view{
        .view = rasterView({.positionMm = {0, -500, 0}, .verticalFovDeg = 14.0}, {400, 320}, glm::dvec3(0.0))
                    .value()};
    view.pixels.assign(400 * 320, glm::vec4(0.25f, 0.5f, 0.25f, 0.75f));
    TrainerOptions o = options(0);

    // What the trainer draws with: the first time it has no room.
    auto parameters = std::move(*SplatBuffer::create(device(), "parameters", 10, model.shDegree));
    ASSERT_TRUE(parameters.upload(componentsOf(model)).ok());
    Rasterizer rasterizer =
        std::move(*Rasterizer::create(device(), 10, model.shDegree, {.lists = ListMaker::device}));
    auto recorder = std::move(*gpu::Recorder::create(device(), "draw"));
    ASSERT_TRUE(rasterizer.recordDraw(recorder, parameters, 10, view.view, blendingOf(model.lowPass)).ok());
    ASSERT_TRUE(recorder.submit().ok());
    const Result<bool> hadRoom = rasterizer.settle();
    ASSERT_TRUE(hadRoom.ok());
    EXPECT_FALSE(*hadRoom);

    const TrainingState onHost = after(2, ListMaker::host, model, o, {view});
    const TrainingState onDevice = after(2, ListMaker::device, model, o, {view});
    EXPECT_EQ(onDevice.optimizer.stepsDone, 2u);
    testing::expectSame(onDevice, onHost, "after 2 steps");
    EXPECT_NE(onHost.splats.dc, model.dc);
}

}  // namespace
}  // namespace macula::splat
