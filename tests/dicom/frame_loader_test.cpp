// A frame that is decoded alone is the slice of the volume, and an error where there is none.
#include "dicom/frame_loader.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

namespace fs = std::filesystem;

struct Loaded {
    explicit Loaded(const fs::path& folder) : found(scan(folder)) {}
    const Stack& stack() const { return found->studies.at(0).series.at(0).stacks.at(0); }
    std::optional<Scan> found;
};

void expectFramesOf(const Stack& stack, const Volume& volume) {
    ASSERT_EQ(stack.slices.size(), stack.frames.size());
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        const auto frame = loadFrame(stack, stack.slices[k].below);
        ASSERT_TRUE(frame) << frame.error().message;
        ASSERT_EQ(frame->columns, volume.size().x);
        ASSERT_EQ(frame->rows, volume.size().y);
        ASSERT_EQ(frame->values.size(), std::size_t(frame->columns) * std::size_t(frame->rows));
        for (int j = 0; j < frame->rows; ++j) {
            for (int i = 0; i < frame->columns; ++i) {
                const float value =
                    frame->values[std::size_t(j) * std::size_t(frame->columns) + std::size_t(i)];
                EXPECT_NEAR(value, volume.value(i, j, int(k)), 1e-3) << i << " " << j << " " << k;
            }
        }
    }
}

TEST(FrameLoader, AFileOfItsOwnIsTheSliceOfTheVolume) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.slope = 0.5;
    writeFiles(folder.path(), series);
    const Loaded loaded(folder.path());
    const auto volume = load(loaded.found->studies.at(0).series.at(0));
    ASSERT_NE(volume, nullptr);
    expectFramesOf(loaded.stack(), *volume);
}

TEST(FrameLoader, AFrameOfMany) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.transferSyntaxUid = UID_RLELosslessTransferSyntax;
    writeMultiFrame(folder / "image", series, slicesOf(series));
    const Loaded loaded(folder.path());
    const auto volume = load(loaded.found->studies.at(0).series.at(0));
    ASSERT_NE(volume, nullptr);
    expectFramesOf(loaded.stack(), *volume);
}

TEST(FrameLoader, SignedCellsHaveTheirSign) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.format = {16, 16, 15, true};
    series.intercept = 0.0;
    series.ramp = Ramp{.value = -500.0, .throughMm = transformPoint(series.worldFromVoxel, glm::dvec3(0.0))};
    writeFiles(folder.path(), series);
    const Loaded loaded(folder.path());
    const auto volume = load(loaded.found->studies.at(0).series.at(0));
    ASSERT_NE(volume, nullptr);
    expectFramesOf(loaded.stack(), *volume);
}

TEST(FrameLoader, PaddingIsNoValueAlsoWhereOnlyOtherFramesDeclareIt) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.rawInstead = [](const Slice&, int i, int j) -> std::optional<int> {
        return i == 3 && j == 2 ? std::optional(0) : std::nullopt;
    };
    std::vector<Slice> slices = slicesOf(series);
    for (std::size_t k = 1; k < slices.size(); ++k)
        slices[k].edits.emplace_back([](DcmItem& item) { putWord(item, DCM_PixelPaddingValue, 0); });
    writeFiles(folder.path(), series, slices);
    const Loaded loaded(folder.path());
    for (std::size_t f = 0; f < loaded.stack().frames.size(); ++f) {
        const auto frame = loadFrame(loaded.stack(), f);
        ASSERT_TRUE(frame) << frame.error().message;
        for (std::size_t n = 0; n < frame->values.size(); ++n)
            EXPECT_EQ(std::isnan(frame->values[n]), n == 2u * std::size_t(series.size.x) + 3u) << f;
    }
}

TEST(FrameLoader, AnImageThatIsNoVolumeIsDecodedToo) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.size.z = 1;
    writeFiles(folder.path(), series);
    const Loaded loaded(folder.path());
    ASSERT_FALSE(loaded.stack().canBeVolume());
    EXPECT_TRUE(loadFrame(loaded.stack(), 0));
}

TEST(FrameLoader, AFileThatIsGoneIsAnErrorThatNamesNobody) {
    const TemporaryFolder folder;
    const auto files = writeFiles(folder / "DOE^JOHN", SyntheticSeries{});
    const Loaded loaded(folder.path());
    const fs::path gone = loaded.stack().frames.at(4).instance->file;
    fs::remove(gone);
    const auto frame = loadFrame(loaded.stack(), 4);
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::inputNotUsable);
    EXPECT_EQ(frame.error().where, gone.string());
    EXPECT_EQ((frame.error().message.english() + frame.error().hint.english()).find("DOE"),
              std::string::npos);
    EXPECT_TRUE(loadFrame(loaded.stack(), 5)) << "the others are not in its way";
}

TEST(FrameLoader, RefusesWhatIsNoGrey) {
    const TemporaryFolder folder;
    writeFiles(folder.path(), SyntheticSeries{});
    const Loaded loaded(folder.path());
    Stack stack = loaded.stack();
    const auto with = [&](auto change) {
        auto instance = std::make_shared<Instance>(*loaded.stack().frames.at(0).instance);
        change(*instance);
        stack.frames.at(0).instance = instance;
        const auto frame = loadFrame(stack, 0);
        return frame.ok() ? Text() : frame.error().message;
    };
    EXPECT_EQ(with([](Instance&) {}), "");
    EXPECT_EQ(with([](Instance& i) { i.photometricInterpretation = "PALETTE COLOR"; }),
              message(key::kColourImage).sentence);
    EXPECT_EQ(with([](Instance& i) { i.samplesPerPixel = 3; }), message(key::kColourImage).sentence);
    EXPECT_EQ(with([](Instance& i) { i.format.reset(); }), message(key::kUnsupportedBits).sentence);
    for (const int size : {-1, 0, 70'000, std::numeric_limits<int>::max()}) {
        EXPECT_NE(with([&](Instance& i) { i.columns = size; }), "") << size;
        EXPECT_NE(with([&](Instance& i) { i.rows = size; }), "") << size;
    }
}

TEST(FrameLoader, CancelledBeforeItBegins) {
    const TemporaryFolder folder;
    writeFiles(folder.path(), SyntheticSeries{});
    const Loaded loaded(folder.path());
    const CancelToken token;
    token.cancel();
    const auto frame = loadFrame(loaded.stack(), 0, token);
    ASSERT_FALSE(frame);
    EXPECT_EQ(frame.error().code, ErrorCode::cancelled);
}

}  // namespace
}  // namespace macula::dicom::test
