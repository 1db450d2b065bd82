// A peripheral model goes on from a file as if it had never stopped, and shows what it showed.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/new_process.h"
#include "hybrid/model/peripheral_scene.h"
#include "pipeline/hybrid/model/peripheral_file.h"

namespace macula::hybrid {
namespace {

namespace fs = std::filesystem;
using splat::testing::expectSame;
using splat::testing::sameBits;

constexpr const char* kFolder = "MACULA_TEST_FOLDER";

class PeripheralFileTest : public PeripheralTest {
  protected:
    // Multiples of the steps between judging, with two pictures held out and with three.
    static constexpr std::uint64_t kJudgedAt = 60;
    static constexpr std::uint64_t kJudgedLater = 120;

    static std::string fileOf(const PeripheralModel& model) {
        std::ostringstream stream;
        splat::PackedPictures packed;
        EXPECT_TRUE(writePeripheral(stream, *model.state(), packed).ok());
        return stream.str();
    }
    static PeripheralModel resumed(const std::string& bytes, const PeripheralOptions& o = neverPaused()) {
        std::istringstream stream(bytes);
        const auto file = readPeripheral(stream, bytes.size());
        EXPECT_TRUE(file.ok());
        EXPECT_FALSE(file->isTrainingOnly);
        return std::move(PeripheralModel::resume(device(), file->state, o)).value();
    }
    static void stepTo(PeripheralModel& model, std::uint64_t step) {
        const auto isBefore = [&] { return model.report().training.steps < step; };
        while (isBefore()) ASSERT_TRUE(model.step(1e6, isBefore).ok());
    }
    // And is judged there, which takes no step.
    static void judgeAt(PeripheralModel& model, std::uint64_t step) {
        stepTo(model, step);
        for (std::size_t i = 0; i < model.report().heldOut; ++i) ASSERT_TRUE(model.step(0.0).ok());
        ASSERT_EQ(model.report().training.steps, step);
    }
    // Between two times at which it is judged.
    static PeripheralModel taught() {
        PeripheralModel model = begun(neverPaused());
        giveWanted(model, truth(), 6);
        stepTo(model, 33);
        return model;
    }
};

TEST_F(PeripheralFileTest, GoesOnAsIfItHadNeverStopped) {
    PeripheralModel whole = taught();
    PeripheralModel again = resumed(fileOf(whole));
    EXPECT_EQ(again.report().heldOut, 2u);
    EXPECT_TRUE(sameBits(*again.shown().splats, *whole.shown().splats));
    EXPECT_GT(again.shown().generation, whole.shown().generation);
    expectSame(again.state()->training, whole.state()->training, "read");
    judgeAt(whole, kJudgedAt);
    judgeAt(again, kJudgedAt);
    expectSame(again.state()->training, whole.state()->training, "gone on");
    EXPECT_EQ(*again.report().error, *whole.report().error);
    EXPECT_TRUE(sameBits(*again.shown().splats, *whole.shown().splats));
    // Both want the same, and make the same of it.
    const auto a = whole.wantedView().value();
    const auto b = again.wantedView().value();
    ASSERT_TRUE(a && b);
    EXPECT_EQ(a->camera.positionMm, b->camera.positionMm);
    const auto offered = whole.offer(picture(truth(), a->camera));
    ASSERT_TRUE(offered.ok());
    EXPECT_EQ(*again.offer(picture(truth(), b->camera)), *offered);
    judgeAt(whole, kJudgedLater);
    judgeAt(again, kJudgedLater);
    expectSame(again.state()->training, whole.state()->training, "with one more picture");
    EXPECT_EQ(*again.report().error, *whole.report().error);
}

TEST_F(PeripheralFileTest, GoesOnInANewProcess) {
    std::string name = (fs::temp_directory_path() / "macula-peripheral-XXXXXX").string();
    const fs::path folder = mkdtemp(name.data());
    PeripheralModel whole = taught();
    std::ofstream(folder / "from.macula", std::ios::binary) << fileOf(whole);
    ASSERT_EQ(setenv(kFolder, folder.c_str(), 1), 0);
    EXPECT_EQ(test::runInNewProcess("PeripheralFileTest.DISABLED_NewProcess"), 0);
    unsetenv(kFolder);
    judgeAt(whole, kJudgedAt);
    std::ifstream stream(folder / "to.macula", std::ios::binary);
    const auto file = readPeripheral(stream, fs::file_size(folder / "to.macula"));
    ASSERT_TRUE(file.ok()) << file.error().message;
    const PeripheralState expected = *whole.state();
    expectSame(file->state.training, expected.training, "by another process");
    EXPECT_TRUE(sameBits(file->state.shown ? *file->state.shown : file->state.training.splats,
                         *whole.shown().splats));
    ASSERT_EQ(file->state.heldOut.size(), expected.heldOut.size());
    for (std::size_t i = 0; i < expected.heldOut.size(); ++i)
        EXPECT_TRUE(sameBits(file->state.heldOut[i]->pixels, expected.heldOut[i]->pixels));
    fs::remove_all(folder);
}

// What the one before has done elsewhere.
TEST_F(PeripheralFileTest, DISABLED_NewProcess) {
    const char* named = std::getenv(kFolder);
    if (named == nullptr) GTEST_SKIP();
    std::ifstream from(fs::path(named) / "from.macula", std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(from), {}};
    PeripheralModel model = resumed(bytes);
    judgeAt(model, kJudgedAt);
    std::ofstream(fs::path(named) / "to.macula", std::ios::binary) << fileOf(model);
}

// The trained model has become worse since: that is no reason to show it after a pause.
TEST_F(PeripheralFileTest, ShowsNothingWorseThanWasShown) {
    PeripheralOptions o = neverPaused();
    o.newViewsForRound = 1e9;
    PeripheralModel model = begun(o);
    giveWanted(model, truth(), 8);
    learn(model, 100);
    splat::Splats wrong = truth();
    for (glm::vec3& dc : wrong.dc) dc *= 0.2f;
    for (int i = 0; i < 24; ++i)
        ASSERT_EQ(*model.offer(picture(wrong, cameraAt(15.0 * i + 7.0, 200.0)), false), Offered::learnt);
    learn(model, 300);
    const PeripheralReport before = model.report();
    ASSERT_GT(*before.error, 1.5 * *before.shownError) << "it was to become worse";
    const std::string bytes = fileOf(model);
    std::istringstream stream(bytes);
    const auto drawable = readDrawable(stream, bytes.size());
    ASSERT_TRUE(drawable.ok()) << drawable.error().message;
    EXPECT_TRUE(sameBits(*drawable->splats, *model.shown().splats));
    EXPECT_FALSE(sameBits(*drawable->splats, model.state()->training.splats));
    EXPECT_EQ(drawable->key, "one");
    EXPECT_EQ(drawable->steps, before.training.steps);

    PeripheralModel again = resumed(bytes, o);
    EXPECT_TRUE(sameBits(*again.shown().splats, *model.shown().splats));
    expectSame(again.state()->training, model.state()->training, "the trainer is none the better for it");
    EXPECT_NEAR(*again.report().shownError, *before.shownError, 1e-4 * *before.shownError);
    learn(again, 60);
    EXPECT_LE(*again.report().shownError, (1.0001 + o.shownMayBeWorse) * *before.shownError);
}

}  // namespace
}  // namespace macula::hybrid
