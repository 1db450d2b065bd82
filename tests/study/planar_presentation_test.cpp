// Presentation states on images: against pictures that DCMTK drew of the files of ../shared/data, and made
// here in closed form.
#include "study/planar/planar_presentation.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "dicom/synthetic_softcopy.h"
#include "image/image_file.h"
#include "study/list/study_tree.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;

dicom::SoftcopyState stateOf(const std::string& uid) {
    dicom::SoftcopyState said;
    said.seriesUids = {"1.2.3"};
    said.images = {{.sopInstanceUid = uid}};
    return said;
}

struct Shown {
    dicom::Frame frame;
    dicom::PlanarHeader header;
    dicom::PlanarFrame pixels;

    Shown() {
        auto instance = std::make_shared<dicom::Instance>();
        instance->sopInstanceUid = "1.2.3.4";
        instance->format = dicom::CellFormat{16, 12, 11, false};
        frame.instance = instance;
        pixels = {.columns = 3, .rows = 1, .values = {0, 2000, 4095}, .rgb = {}};
    }
    std::optional<PresentedImage> by(const dicom::SoftcopyState& said) const {
        return presentedOn(said, frame, header, pixels, usualDisplay(frame, header, pixels));
    }
};

TEST(PlanarPresentations, WithoutAWindowShowAllThatThePixelsCanHold) {
    const Shown shown;
    const auto image = shown.by(stateOf("1.2.3.4"));
    ASSERT_TRUE(image);
    EXPECT_EQ(pictureOf(shown.pixels, shown.header, image->display).bytes,
              (std::vector<std::uint8_t>{0, 125, 255}));
    EXPECT_FALSE(shown.by(stateOf("1.2.3.5"))) << "of another image";
}

TEST(PlanarPresentations, TakeThePlaceOfThePolarityOfTheImage) {
    Shown shown;
    shown.header.isLowBright = true;
    dicom::SoftcopyState said = stateOf("1.2.3.4");
    EXPECT_EQ(pictureOf(shown.pixels, shown.header, shown.by(said)->display).bytes.front(), 0);
    said.isInverse = true;
    EXPECT_EQ(pictureOf(shown.pixels, shown.header, shown.by(said)->display).bytes.front(), 255);
}

TEST(PlanarPresentations, OfOtherValuesLeaveTheWindowAndSaySo) {
    Shown shown;
    shown.frame.slope = 2.0;
    dicom::SoftcopyState said = stateOf("1.2.3.4");
    said.windows.push_back({.images = {}, .window = DisplayWindow{.center = 7, .width = 8}, .table = {}});
    const auto image = shown.by(said);
    ASSERT_TRUE(image);
    EXPECT_NE(image->display.window.center, 7.0);
    EXPECT_EQ(image->notes.size(), 1u);
    said.slope = 2.0;
    EXPECT_EQ(shown.by(said)->display.window.center, 7.0);
}

TEST(PlanarPresentations, ByATableMapAsItSays) {
    const Shown shown;
    dicom::SoftcopyState said = stateOf("1.2.3.4");
    const dicom::VoiTable table{
        std::make_shared<const dicom::ModalityLut>(dicom::ModalityLut{2000, {200, 100}}), 8, ""};
    said.windows.push_back({.images = {}, .window = {}, .table = table});
    EXPECT_EQ(pictureOf(shown.pixels, shown.header, shown.by(said)->display).bytes,
              (std::vector<std::uint8_t>{200, 200, 100}));
}

TEST(PlanarPresentations, ShowTheOverlaysOfTheirLayersAlone) {
    Shown shown;
    for (const int group : {0x6000, 0x6002})
        shown.pixels.overlays.push_back(
            {.group = group, .columns = 1, .rows = 1, .origin = {1, 1}, .isOn = {true}});
    dicom::SoftcopyState said = stateOf("1.2.3.4");
    EXPECT_TRUE(shown.by(said)->overlays.empty());
    said.overlays.push_back({.group = 0x6002, .layer = "A"});
    ASSERT_EQ(shown.by(said)->overlays.size(), 1u);
    EXPECT_EQ(shown.by(said)->overlays[0].group, 0x6002);
}

TEST(PlanarPresentations, OfAnyAngleTurnByQuarters) {
    const Shown shown;
    dicom::SoftcopyState said = stateOf("1.2.3.4");
    said.rotationDeg = -90;
    EXPECT_EQ(shown.by(said)->quarters, 3);
    said.rotationDeg = 45;
    EXPECT_EQ(shown.by(said)->quarters, 0);
    EXPECT_EQ(shown.by(said)->notes.size(), 1u);
}

// Two radiographs of one series, without a place in the patient, and a state of the second one.
class ListedPresentations : public testing::Test {
  protected:
    std::unique_ptr<FoundVolumes> found(const std::string& patientOfState) {
        dicom::test::SyntheticSeries series;
        series.modality = "DX";
        series.sopClassUid = UID_DigitalXRayImageStorageForPresentation;
        series.size = {8, 7, 2};
        series.edits.push_back([](DcmItem& item) {
            item.findAndDeleteElement(DCM_ImagePositionPatient);
            item.findAndDeleteElement(DCM_ImageOrientationPatient);
        });
        auto slices = dicom::test::slicesOf(series);
        slices[0].sopInstanceUid = "2.25.71";
        slices[1].sopInstanceUid = "2.25.72";
        dicom::test::writeFiles(folder_.path(), series, slices);
        dicom::test::SyntheticSoftcopy state{.patientId = patientOfState, .imageUids = {"2.25.72"}};
        if (patientOfState != "SYN1") {
            state.patientName = "OTHER^ONE";
            state.studyUid = "2.25.1999";
        }
        dicom::test::writeSoftcopy(folder_ / "state.dcm", state);
        auto scan = dicom::test::scan(folder_.path());
        EXPECT_TRUE(scan);
        return std::make_unique<FoundVolumes>(*std::move(scan));
    }
    static const StudyRow* presentationRow(const StudyTree& tree) {
        const auto row = std::ranges::find(tree.rows, StudyRow::Kind::presentation, &StudyRow::kind);
        return row == tree.rows.end() ? nullptr : &*row;
    }
    dicom::test::TemporaryFolder folder_;
};

TEST_F(ListedPresentations, OpenTheImagesThatTheyAreOf) {
    const auto all = found("SYN1");
    const auto series = planarSeriesOf(*all);
    ASSERT_EQ(series.size(), 1u);
    const auto listed = presentationsOf(*all, series[0]);
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_EQ(listed[0].label, "LUNG");
    const StudyTree tree = studyTree(*all);
    const StudyRow* row = presentationRow(tree);
    ASSERT_TRUE(row != nullptr && row->presentation);
    EXPECT_EQ(row->presentation->images, series[0].stack);
    EXPECT_TRUE(row->whyNot.empty());
}

TEST_F(ListedPresentations, OfAnotherPatientAreNone) {
    const auto all = found("OTHER");
    const auto series = planarSeriesOf(*all);
    ASSERT_EQ(series.size(), 1u);
    EXPECT_TRUE(presentationsOf(*all, series[0]).empty());
    const StudyTree tree = studyTree(*all);
    const StudyRow* row = presentationRow(tree);
    ASSERT_NE(row, nullptr);
    EXPECT_FALSE(row->presentation);
    EXPECT_FALSE(row->whyNot.empty());
}

TEST(PlanarPictures, AreTurnedClockwiseAndThenMirrored) {
    const PlanarPicture picture{3, 2, false, {1, 2, 3, 4, 5, 6}};
    EXPECT_EQ(turned(picture, 1, false).bytes, (std::vector<std::uint8_t>{4, 1, 5, 2, 6, 3}));
    EXPECT_EQ(turned(picture, 2, false).bytes, (std::vector<std::uint8_t>{6, 5, 4, 3, 2, 1}));
    EXPECT_EQ(turned(picture, 1, true).bytes, (std::vector<std::uint8_t>{1, 4, 2, 5, 3, 6}));
    EXPECT_EQ(turned(picture, 1, true).columns, 2);
    const PlanarPicture colours{2, 1, true, {1, 2, 3, 4, 5, 6}};
    EXPECT_EQ(turned(colours, 0, true).bytes, (std::vector<std::uint8_t>{4, 5, 6, 1, 2, 3}));
}

// How many pixels differ from DCMTK's picture by more than a grey, and how many there are. DCMTK's program
// draws values, polarity and turn, but neither shutters nor overlays.
std::pair<std::size_t, std::size_t> differing(const fs::path& folder, const char* state, const char* image,
                                              const char* reference) {
    const auto said = dicom::readSoftcopyState(folder / state);
    const auto found = dicom::test::scan(folder / image);
    const auto header = dicom::readPlanarHeader(folder / image);
    if (!said || !found || !header) return {1, 0};
    const dicom::Stack& stack = found->studies.at(0).series.at(0).stacks.at(0);
    const auto pixels = dicom::loadPlanarFrame(stack, 0, *header);
    const auto drawn = image::readImage(folder / reference);
    if (!pixels || !drawn) return {1, 0};
    const auto shown = presentedOn(*said, stack.frames[0], *header, *pixels,
                                   usualDisplay(stack.frames[0], *header, *pixels));
    if (!shown) return {1, 0};
    PlanarPicture picture = pictureOf(*pixels, *header, shown->display);
    picture = turned(picture, shown->quarters, shown->isMirrored);
    EXPECT_EQ(picture.columns, drawn->width);
    EXPECT_EQ(picture.rows, drawn->height);
    if (picture.columns != drawn->width || picture.rows != drawn->height) return {1, 0};
    std::size_t differ = 0;
    for (std::size_t i = 0; i < picture.bytes.size(); ++i) {
        const float grey = drawn->pixels[i * std::size_t(drawn->channels)];
        if (std::abs(std::lround(255.0F * grey) - long{picture.bytes[i]}) > 1) ++differ;
    }
    return {differ, picture.bytes.size()};
}

TEST(PlanarPresentations, OfRealFilesAreThePicturesThatDcmtkDrew) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = dicom::test::sharedData() / "planar/2_structured";
    if (!fs::is_directory(data)) GTEST_SKIP() << "the planar data are not on this machine";
    using Counts = std::pair<std::size_t, std::size_t>;
    EXPECT_EQ(differing(data / "gsps_overlays", "pr.dcm", "image.dcm", "ref_dcmtk.png"),
              Counts(0, 512 * 512));
    EXPECT_EQ(
        differing(data / "made_ko_and_gsps", "pr_1.dcm", "images/02.dcm", "ref_dcmtk_pr_1_image_02.png"),
        Counts(0, 96 * 128));
    EXPECT_EQ(
        differing(data / "made_ko_and_gsps", "pr_2.dcm", "images/02.dcm", "ref_dcmtk_pr_2_image_02.png"),
        Counts(0, 96 * 128));
}

}  // namespace
}  // namespace macula::study
