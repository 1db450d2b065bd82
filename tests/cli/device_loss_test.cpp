// The command while its graphics device is lost; see gpu/lose_device.h.
#include "cli/run_command.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

class DeviceLoss : public CommandTest {
  protected:
    Ran render(const std::string& name, const std::string& losses) {
        return runMacula(
            {"render", "-o", at(name), "--size", "48x40", "--spp", "8", "--denoise", "--seed", "3"},
            {"LD_PRELOAD=" MACULA_LOSE_DEVICE, "MACULA_TEST_LOSE=" + losses,
             "ASAN_OPTIONS=verify_asan_link_order=0"});
    }
};

TEST_F(DeviceLoss, ThePictureIsMadeAnewAndThatIsSaid) {
    const Ran whole = render("whole.png", "submit:1:0");
    ASSERT_EQ(whole.exitCode, 0) << whole.err;
    EXPECT_EQ(whole.err.find("stopped responding"), std::string::npos) << whole.err;
    const Ran lost = render("lost.png", "submit:6:2");
    ASSERT_EQ(lost.exitCode, 0) << lost.err;
    const std::size_t first = lost.err.find("macula: note: The graphics device stopped responding");
    ASSERT_NE(first, std::string::npos) << lost.err;
    EXPECT_NE(lost.err.find("stopped responding", first + 40), std::string::npos) << lost.err;
    EXPECT_EQ(lost.errorLines(), 0u);
    const auto expected = image::readImage(at("whole.png"));
    const auto got = image::readImage(at("lost.png"));
    ASSERT_TRUE(expected.ok() && got.ok());
    EXPECT_TRUE(expected->pixels == got->pixels);
}

TEST_F(DeviceLoss, TheThirdIsTheLastAndNothingIsWritten) {
    const Ran ran = render("never.png", "submit:6:3");
    EXPECT_EQ(ran.exitCode, 4);
    EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
    EXPECT_NE(ran.err.find("3 times within a minute"), std::string::npos) << ran.err;
    EXPECT_NE(ran.err.find("MACULA_DEVICE"), std::string::npos) << ran.err;
    EXPECT_EQ(fileCount(), 0u);
}

}  // namespace
}  // namespace macula::cli
