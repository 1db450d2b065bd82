// What lies over an image: shutters and overlays, made here in closed form, and the real ones of
// ../shared/data.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "dicom/planar/display_shutter.h"
#include "dicom/planar/overlay_planes.h"
#include "dicom/planar/planar_frame.h"
#include "support.h"
#include "synthetic.h"

namespace macula::dicom::test {
namespace {

PlanarHeader headerWith(const Edit& edit) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.edits.push_back(edit);
    const auto files = writeFiles(folder.path(), series, {slicesOf(series).front()});
    const auto read = readPlanarHeader(files.at(0));
    EXPECT_TRUE(read);
    return read ? *read : PlanarHeader{};
}

std::vector<std::string> seenThrough(const DisplayShutter& shutter, int columns, int rows,
                                     double heightOverWidth = 1.0) {
    const std::vector<bool> hidden = hiddenBy(shutter, columns, rows, heightOverWidth);
    std::vector<std::string> lines;
    for (int j = 0; j < rows; ++j) {
        lines.emplace_back();
        for (int i = 0; i < columns; ++i)
            lines.back() += hidden[std::size_t(j) * std::size_t(columns) + std::size_t(i)] ? '.' : 'x';
    }
    return lines;
}
using Lines = std::vector<std::string>;

TEST(DisplayShutters, ShowWhatAllOfTheirShapesShow) {
    DisplayShutter shutter;
    shutter.rectangle = {.left = 2, .right = 4, .top = 2, .bottom = 3};
    EXPECT_EQ(seenThrough(shutter, 5, 4), (Lines{".....", ".xxx.", ".xxx.", "....."}));
    shutter.polygon = {{2, 2}, {3, 2}, {3, 4}, {2, 4}};
    EXPECT_EQ(seenThrough(shutter, 5, 4), (Lines{".....", ".xx..", ".xx..", "....."}));
    shutter.rectangle.reset();
    EXPECT_EQ(seenThrough(shutter, 5, 4), (Lines{".....", ".xx..", ".xx..", ".xx.."}));
    shutter.polygon.clear();
    shutter.circle = {.centre = {3, 3}, .radius = 2};
    EXPECT_EQ(seenThrough(shutter, 5, 5), (Lines{"..x..", ".xxx.", "xxxxx", ".xxx.", "..x.."}));
    EXPECT_EQ(seenThrough(shutter, 5, 5, 2.0), (Lines{".....", "..x..", "xxxxx", "..x..", "....."}))
        << "pixels twice as high as wide: round on the screen";
}

TEST(DisplayShutters, HideAsManyPixelsAsACircleLeavesOut) {
    const DisplayShutter shutter{.circle = DisplayShutter::Circle{{200, 200}, 150}};
    const auto hidden = hiddenBy(shutter, 400, 400, 1.0);
    const double seen = double(std::ranges::count(hidden, false));
    EXPECT_NEAR(seen, std::numbers::pi * 150 * 150, 0.01 * seen);
}

TEST(DisplayShutters, AreReadInRowsAndColumns) {
    const auto shutter = headerWith([](DcmItem& item) {
                             put(item, DCM_ShutterShape, "RECTANGULAR\\CIRCULAR\\POLYGONAL");
                             put(item, DCM_ShutterLeftVerticalEdge, "3");
                             put(item, DCM_ShutterRightVerticalEdge, "7");
                             put(item, DCM_ShutterUpperHorizontalEdge, "2");
                             put(item, DCM_ShutterLowerHorizontalEdge, "5");
                             put(item, DCM_CenterOfCircularShutter, "4\\6");
                             put(item, DCM_RadiusOfCircularShutter, "9");
                             put(item, DCM_VerticesOfThePolygonalShutter, "1\\2\\3\\4\\5\\6");
                             putWord(item, DCM_ShutterPresentationValue, 0x8000);
                         }).shutter;
    ASSERT_TRUE(shutter && shutter->rectangle && shutter->circle);
    EXPECT_EQ(shutter->rectangle->left, 3);
    EXPECT_EQ(shutter->rectangle->bottom, 5);
    EXPECT_EQ(shutter->circle->centre, glm::ivec2(6, 4)) << "the row comes first in the file";
    EXPECT_EQ(shutter->polygon, (std::vector<glm::ivec2>{{2, 1}, {4, 3}, {6, 5}}));
    EXPECT_EQ(shutter->grey, 0x80);
}

TEST(DisplayShutters, ThatMakeNoSenseAreNone) {
    for (const Edit& edit :
         std::vector<Edit>{[](DcmItem& item) { put(item, DCM_ShutterShape, "RECTANGULAR"); },
                           [](DcmItem& item) { put(item, DCM_ShutterShape, "BITMAP"); },
                           [](DcmItem& item) {
                               put(item, DCM_ShutterShape, "CIRCULAR");
                               put(item, DCM_CenterOfCircularShutter, "4\\6");
                               put(item, DCM_RadiusOfCircularShutter, "-2147483648");
                           },
                           [](DcmItem& item) {
                               put(item, DCM_ShutterShape, "POLYGONAL");
                               put(item, DCM_VerticesOfThePolygonalShutter, "1\\2\\3");
                           }})
        EXPECT_FALSE(headerWith(edit).shutter);
    const DisplayShutter far{.circle = DisplayShutter::Circle{{-1 << 20, 1 << 20}, 1 << 20}};
    EXPECT_EQ(std::ranges::count(hiddenBy(far, 8, 8, 1.0), true), 64);
}

// Bits as the file packs them, the first pixel in the lowest one.
Edit overlay(Uint16 group, int columns, int rows, std::vector<Uint16> words, const Edit& more = {}) {
    return [=](DcmItem& item) {
        item.putAndInsertUint16(DcmTag(group, 0x0010, EVR_US), Uint16(rows));
        item.putAndInsertUint16(DcmTag(group, 0x0011, EVR_US), Uint16(columns));
        item.putAndInsertString(DcmTag(group, 0x0040, EVR_CS), "G");
        item.putAndInsertUint16(DcmTag(group, 0x0100, EVR_US), 1);
        item.putAndInsertUint16(DcmTag(group, 0x0102, EVR_US), 0);
        if (!words.empty())
            item.putAndInsertUint16Array(DcmTag(group, 0x3000, EVR_OW), words.data(),
                                         static_cast<unsigned long>(words.size()));
        if (more) more(item);
    };
}
Edit origin(Uint16 group, Sint16 row, Sint16 column) {
    return [=](DcmItem& item) {
        const std::array<Sint16, 2> at{row, column};
        item.putAndInsertSint16Array(DcmTag(group, 0x0050, EVR_SS), at.data(), 2);
    };
}

TEST(OverlayPlanes, MarkThePixelsWhoseBitsAreSet) {
    const auto planes = headerWith(overlay(0x6002, 3, 2, {0b100001}, origin(0x6002, 2, -1))).overlays;
    ASSERT_EQ(planes.size(), 1u);
    const auto mask = maskOf(planes[0], 5);
    ASSERT_TRUE(mask) << "one plane without a number of frames lies over all";
    // Its first pixel lies at column -1, row 2: the first marked one outside, the other at (1, 3).
    EXPECT_TRUE(mask->marks(0, 2));
    EXPECT_FALSE(mask->marks(0, 1));
    EXPECT_FALSE(mask->marks(-1, 1));
    EXPECT_TRUE(mask->marks(-2, 1));
    EXPECT_FALSE(mask->marks(1000, 1000));
}

TEST(OverlayPlanes, OfSeveralFramesLieWhereTheirOriginSays) {
    const auto planes = headerWith(overlay(0x6000, 2, 2, {0b1000'0001}, [](DcmItem& item) {
                            item.putAndInsertString(DcmTag(0x6000, 0x0015, EVR_IS), "2");
                            item.putAndInsertUint16(DcmTag(0x6000, 0x0051, EVR_US), 3);
                        })).overlays;
    ASSERT_EQ(planes.size(), 1u);
    EXPECT_FALSE(maskOf(planes[0], 1));
    ASSERT_TRUE(maskOf(planes[0], 2));
    EXPECT_EQ(maskOf(planes[0], 2)->isOn, (std::vector<bool>{true, false, false, false}));
    EXPECT_EQ(maskOf(planes[0], 3)->isOn, (std::vector<bool>{false, false, false, true}));
    EXPECT_FALSE(maskOf(planes[0], 4));
}

TEST(OverlayPlanes, AsLargeAsOfARadiographAreRead) {
    const std::vector<Uint16> all(std::size_t(2048) * 2500 / 16, 0xffff);
    const auto planes = headerWith(overlay(0x6000, 2048, 2500, all)).overlays;
    ASSERT_EQ(planes.size(), 1u);
    const auto mask = maskOf(planes[0], 0);
    EXPECT_EQ(std::ranges::count(mask->isOn, true), 2048 * 2500);
}

TEST(OverlayPlanes, ThatMakeNoSenseAreNone) {
    EXPECT_TRUE(headerWith(overlay(0x6000, 512, 512, {1, 2, 3})).overlays.empty()) << "too short";
    EXPECT_TRUE(headerWith(overlay(0x6000, 0, 4, {1, 2, 3})).overlays.empty());
    EXPECT_TRUE(headerWith(overlay(0x6000, 4, 4, {})).overlays.empty()) << "neither data nor a bit";
    EXPECT_TRUE(headerWith(overlay(0x6000, 2, 2, {1}, [](DcmItem& item) {
                    item.putAndInsertString(DcmTag(0x6000, 0x0015, EVR_IS), "2147483647");
                })).overlays.empty());
}

TEST(OverlayPlanes, InBitsOfThePixelsAreReadFromThem) {
    const TemporaryFolder folder;
    SyntheticSeries series;
    series.format = {16, 12, 11, false};
    series.rawInstead = [](const Slice&, int i, int j) { return 10 * i + j; };
    series.edits.push_back(overlay(0x6000, 8, 7, {}, [](DcmItem& item) {
        item.putAndInsertUint16(DcmTag(0x6000, 0x0100, EVR_US), 16);
        item.putAndInsertUint16(DcmTag(0x6000, 0x0102, EVR_US), 13);
    }));
    const auto files = writeFiles(folder.path(), series, {slicesOf(series).front()});
    editFile(files.at(0), [](DcmItem& item) {
        const Uint16* cells = nullptr;
        unsigned long count = 0;
        ASSERT_TRUE(item.findAndGetUint16Array(DCM_PixelData, cells, &count).good());
        std::vector<Uint16> changed(cells, cells + count);
        changed[8 * 2 + 3] |= 1u << 13;
        item.putAndInsertUint16Array(DCM_PixelData, changed.data(), count);
    });
    const auto found = scan(folder.path());
    ASSERT_TRUE(found);
    const Stack& stack = found->studies.at(0).series.at(0).stacks.at(0);
    const auto header = readPlanarHeader(files.at(0));
    ASSERT_TRUE(header);
    const auto frame = loadPlanarFrame(stack, 0, *header);
    ASSERT_TRUE(frame) << frame.error().message;
    ASSERT_EQ(frame->overlays.size(), 1u);
    EXPECT_TRUE(frame->overlays[0].marks(3, 2));
    EXPECT_EQ(std::ranges::count(frame->overlays[0].isOn, true), 1);
    EXPECT_EQ(frame->values[8 * 2 + 3], 32.0F - 1024.0F) << "the bit is no part of the value";
}

TEST(OverlayPlanes, OfRealFilesAreInPixelsAndInElements) {
    SKIP_WITHOUT_SHARED_DATA();
    const std::filesystem::path file = sharedData() / "planar/2_structured/gsps_overlays/image.dcm";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the planar data are not on this machine";
    const auto header = readPlanarHeader(file);
    ASSERT_TRUE(header);
    const auto found = scan(file);
    ASSERT_TRUE(found);
    const auto frame = loadPlanarFrame(found->studies.at(0).series.at(0).stacks.at(0), 0, *header);
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->overlays.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(frame->overlays[i].group, 0x6000 + 2 * int(i));
        EXPECT_GT(std::ranges::count(frame->overlays[i].isOn, true), 0) << i;
    }
    EXPECT_LE(*std::ranges::max_element(frame->values), 4095.0F);
}

}  // namespace
}  // namespace macula::dicom::test
