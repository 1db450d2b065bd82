#include "study/list/series_thumbnail.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "dicom/support.h"
#include "dicom/synthetic.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;
using dicom::test::SyntheticSeries;
using dicom::test::TemporaryFolder;

// 64 x 48 pixels of 0.7 x 1.1 mm. In the middle one of five slices each quarter has a raw value of its own:
// 0 and 1000 in the first rows, 2000 and 3000 in the last; all others are 500. Values are 1024 less.
class QuartersTest : public testing::Test {
  protected:
    void SetUp() override { write({}); }
    void write(const std::vector<dicom::test::Edit>& edits) {
        fs::remove_all(folder_ / "DOE^JANE");
        SyntheticSeries series;
        series.edits = edits;
        series.shuffleNumbers = false;
        series.size = {64, 48, 5};
        series.rawInstead = [](const dicom::test::Slice& slice, int i, int j) -> std::optional<int> {
            if (slice.place != 2) return 500;
            return (i < 32 ? 0 : 1000) + (j < 24 ? 0 : 2000);
        };
        dicom::test::writeFiles(folder_ / "DOE^JANE", series);
        const auto found = dicom::test::scan(folder_.path());
        ASSERT_TRUE(found);
        stack_ = found->studies.at(0).series.at(0).stacks.at(0);
        ASSERT_EQ(stack_.frames.size(), 5u);
    }
    Thumbnail thumbnail() const {
        const auto made = thumbnailOf(stack_);
        EXPECT_TRUE(made.ok()) << (made.ok() ? Text() : made.error().message);
        return made.ok() ? *made : Thumbnail{};
    }
    // In the middle of the quarters: first row left and right, last row left and right.
    static std::vector<int> quartersOf(const Thumbnail& picture) {
        if (picture.widthPx < 4 || picture.heightPx < 4) return {};
        std::vector<int> greys;
        for (const int y : {picture.heightPx / 4, 3 * picture.heightPx / 4}) {
            for (const int x : {picture.widthPx / 4, 3 * picture.widthPx / 4})
                greys.push_back(picture.grey.at(std::size_t(y * picture.widthPx + x)));
        }
        return greys;
    }
    void setWindow(double center, double width, const std::string& function) {
        for (dicom::Frame& frame : stack_.frames)
            frame.windows = {{.center = center, .width = width, .explanation = {}, .function = function},
                             {.center = 1e6, .width = 1.0, .explanation = {}, .function = {}}};
    }
    TemporaryFolder folder_;
    dicom::Stack stack_;
};

using Greys = std::vector<int>;

TEST_F(QuartersTest, IsTheMiddleSliceAsItWasAcquired) {
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 85, 170, 255}));
}

TEST_F(QuartersTest, PixelsAreSquare) {
    const Thumbnail picture = thumbnail();
    EXPECT_EQ(picture.widthPx, 64);
    EXPECT_EQ(picture.heightPx, int(std::lround(48 * 1.1 / 0.7)));
    EXPECT_EQ(picture.grey.size(), std::size_t(picture.widthPx) * std::size_t(picture.heightPx));
}

TEST_F(QuartersTest, ItsFirstWindowCounts) {
    setWindow(1476.0, 4000.0, "LINEAR_EXACT");  // from -524 to 3476
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 32, 96, 159}));
    setWindow(476.0, 1.0, "LINEAR");
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 0, 255, 255}));
}

TEST_F(QuartersTest, AWindowOfOtherValuesDoesNotCount) {
    setWindow(476.0, 1.0, "LINEAR");
    for (dicom::Frame& frame : stack_.frames) frame.realWorld = true;
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 85, 170, 255}));
}

TEST_F(QuartersTest, Monochrome1IsInvertedAndPaddingIsBlack) {
    write({[](DcmItem& item) { dicom::test::put(item, DCM_PhotometricInterpretation, "MONOCHROME1"); }});
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{255, 170, 85, 0}));
    setWindow(476.0, 3000.0, "LINEAR_EXACT");
    for (dicom::Frame& frame : stack_.frames) frame.padding = dicom::RawRange{0, 0};
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 170, 85, 0}));
}

TEST_F(QuartersTest, NothingButPaddingIsBlack) {
    for (dicom::Frame& frame : stack_.frames) frame.padding = dicom::RawRange{0, 4095};
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 0, 0, 0}));
}

TEST_F(QuartersTest, OnlyTheMiddleFileIsRead) {
    const std::size_t middle = stack_.slices.at(2).below;
    const fs::path kept = stack_.frames.at(middle).instance->file;
    for (const dicom::Frame& frame : stack_.frames) {
        if (frame.instance->file != kept) fs::remove(frame.instance->file);
    }
    EXPECT_EQ(quartersOf(thumbnail()), (Greys{0, 85, 170, 255}));
    fs::remove(kept);
    const auto made = thumbnailOf(stack_);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ((made.error().message.english() + made.error().hint.english()).find("DOE"), std::string::npos);
}

TEST_F(QuartersTest, ImagesThatAreNoVolumeHaveOneToo) {
    write({[](DcmItem& item) { item.findAndDeleteElement(DCM_PixelSpacing); }});
    stack_.slices.clear();
    stack_.worldFromVoxel.reset();
    for (dicom::Frame& frame : stack_.frames) frame.plane.reset();
    const Thumbnail picture = thumbnail();
    EXPECT_EQ(quartersOf(picture), (Greys{0, 85, 170, 255}));
    EXPECT_EQ(picture.heightPx, 48) << "a size of pixels that is not known";
}

TEST_F(QuartersTest, CanBeCancelled) {
    const CancelToken token;
    token.cancel();
    const auto made = thumbnailOf(stack_, token);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::cancelled);
}

TEST(SeriesThumbnail, OfNoImageIsAnError) {
    const auto made = thumbnailOf(dicom::Stack{});
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().code, ErrorCode::inputNotUsable);
}

TEST(SeriesThumbnail, OneValueIsGrey) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.rawInstead = [](const dicom::test::Slice&, int, int) -> std::optional<int> { return 700; };
    series.size = {6, 6, 1};
    dicom::test::writeFiles(folder.path(), series);
    const auto found = dicom::test::scan(folder.path());
    ASSERT_TRUE(found);
    const auto made = thumbnailOf(found->studies.at(0).series.at(0).stacks.at(0));
    ASSERT_TRUE(made.ok()) << made.error().message;
    for (const std::uint8_t grey : made->grey) EXPECT_NEAR(grey, 127, 1);
}

struct Size {
    int columns, rows;
    double columnSpacingMm, rowSpacingMm;
    int widthPx, heightPx;
};

TEST(Shrunk, HasAtMost128SquarePixelsASide) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    for (const Size& size : std::vector<Size>{
             {512, 512, 0.7, 0.7, 128, 128},
             {512, 256, 0.5, 0.5, 128, 64},
             {10, 10, 1.0, 3.0, 10, 30},
             {100, 100, 1.0, 4.0, 32, 128},
             {1, 1, 1.0, 1.0, 1, 1},
             {1, 4000, 1.0, 1.0, 1, 128},
             {20, 10, std::nan(""), 1.0, 20, 10},
             {20, 10, 1.0, kInfinity, 20, 10},
             {20, 10, 0.0, 1.0, 20, 10},
             {20, 10, 1.0, -1.0, 20, 10},
             {10, 10, 1e300, 1e-300, 128, 1},
             {10, 10, 1e-300, 1e300, 1, 128},
         }) {
        const std::vector<std::uint8_t> even(std::size_t(size.columns) * std::size_t(size.rows), 200);
        const Thumbnail small =
            shrunk(even, size.columns, size.rows, size.columnSpacingMm, size.rowSpacingMm);
        EXPECT_EQ(small.widthPx, size.widthPx) << size.columns << " " << size.columnSpacingMm;
        EXPECT_EQ(small.heightPx, size.heightPx) << size.rows << " " << size.rowSpacingMm;
        EXPECT_EQ(small.grey,
                  std::vector<std::uint8_t>(std::size_t(size.widthPx) * std::size_t(size.heightPx), 200));
    }
}

TEST(Shrunk, PixelsAreMeansOfWhatTheyCover) {
    std::vector<std::uint8_t> stripes;
    for (int n = 0; n < 256; ++n) stripes.push_back(n % 2 == 0 ? 0 : 200);
    EXPECT_EQ(shrunk(stripes, 256, 1, 1.0, 1.0).grey, std::vector<std::uint8_t>(128, 100));
    // 192 to 128: a cell and a half each.
    std::vector<std::uint8_t> steps(192, 0);
    steps[1] = 90;
    const Thumbnail small = shrunk(steps, 192, 1, 1.0, 1.0);
    EXPECT_EQ(small.grey[0], 30);
    EXPECT_EQ(small.grey[1], 30);
    EXPECT_EQ(small.grey[2], 0);
}

TEST(Shrunk, SmallPicturesAreKept) {
    const std::vector<std::uint8_t> grey{1, 2, 3, 4, 5, 6};
    EXPECT_EQ(shrunk(grey, 3, 2, 0.8, 0.8).grey, grey);
}

}  // namespace
}  // namespace macula::study
