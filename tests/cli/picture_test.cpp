// macula picture: the pixels of a file, as it or its presentation state says.
#include <filesystem>

#include "cli/run_command.h"
#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "image/image_file.h"

namespace macula::cli {
namespace {

class PictureCommand : public CommandTest {
  protected:
    // Three frames of 8 x 7 pixels without a place in a patient; the value is 100 for each column.
    void writeImages() {
        dicom::test::SyntheticSeries series;
        series.modality = "US";
        series.sopClassUid = "1.2.840.10008.5.1.4.1.1.3.1";
        series.size = {8, 7, 3};
        series.intercept = 0.0;
        series.rawInstead = [](const dicom::test::Slice&, int i, int) { return 100 * i; };
        dicom::test::MultiFrame file;
        file.functionalGroups = false;
        file.dimensions = false;
        std::filesystem::create_directory(at("in"));
        dicom::test::writeMultiFrame(at("in/loop.dcm"), series, dicom::test::slicesOf(series), file);
    }
};

TEST_F(PictureCommand, WritesTheGreyOfEachPixel) {
    writeImages();
    const Ran ran =
        runMacula({"picture", at("in"), "-o", at("a.png"), "--window", "350,700", "--image", "3"});
    ASSERT_EQ(ran.exitCode, 0) << ran.err;
    EXPECT_NE(ran.out.find("image 3 of 3: 8 x 7 pixels"), std::string::npos) << ran.out;
    const auto picture = image::readImage(at("a.png"));
    ASSERT_TRUE(picture) << picture.error().message;
    ASSERT_EQ(picture->width, 8);
    ASSERT_EQ(picture->height, 7);
    for (int i = 0; i < 8; ++i)
        EXPECT_NEAR(picture->pixels[std::size_t(i * picture->channels)], i / 7.0, 0.5 / 255.0) << i;
}

TEST_F(PictureCommand, RefusesWhatIsNotThere) {
    writeImages();
    const auto refused = [&](int exitCode, const std::string& words, std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "picture");
        const std::size_t before = fileCount();
        const Ran ran = runMacula(arguments);
        EXPECT_EQ(ran.exitCode, exitCode) << ran.err;
        EXPECT_EQ(ran.errorLines(), 1u) << ran.err;
        EXPECT_NE(ran.err.find(words), std::string::npos) << ran.err;
        EXPECT_EQ(fileCount(), before);
    };
    refused(2, "3 images", {at("in"), "-o", at("a.png"), "--image", "4"});
    refused(2, "window", {at("in"), "-o", at("a.png"), "--window", "3,-1"});
    refused(2, "PNG", {at("in"), "-o", at("a.jpg")});
    refused(3, "presentation state",
            {at("in"), "-o", at("a.png"), "--presentation-state", at("in/loop.dcm")});
    write("a.png", "what was there");
    refused(2, "--overwrite", {at("in"), "-o", at("a.png")});
    EXPECT_EQ(readAll(at("a.png")), "what was there");
}

TEST_F(PictureCommand, InfoTellsOfImages) {
    writeImages();
    const Ran ran = runMacula({"info", at("in")});
    EXPECT_NE(ran.out.find("shown as images"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace macula::cli
