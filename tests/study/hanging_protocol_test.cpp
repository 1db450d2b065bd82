// Hanging protocols: which images they choose of studies with priors, and what is kept of them.
#include "study/hanging/hanging_protocol.h"

#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "dicom/support.h"
#include "dicom/synthetic.h"
#include "found_by_hand.h"

namespace macula::study {
namespace {

using dicom::test::put;

// A mammogram or radiograph of one frame.
HangingImage image(const FoundVolumes& found, std::size_t study, std::size_t series, int prior) {
    const dicom::Study& of = found.scan().studies.at(study);
    const dicom::Series& its = of.series.at(series);
    return {.of = {&of, &its, &its.stacks.front()},
            .place = 0,
            .prior = prior,
            .isVolume = its.stacks.front().canBeVolume(),
            .isLocalizer = false,
            .modality = its.modality,
            .bodyPart = {},
            .laterality = {},
            .view = {}};
}

const HangingProtocol& builtIn(std::string_view title) {
    const auto& all = builtInHangingProtocols();
    const auto found = std::ranges::find_if(all, [&](const auto& each) { return each.title == title; });
    EXPECT_NE(found, all.end()) << title;
    return *found;
}

std::string firstFor(const HangingImages& images) {
    for (const HangingProtocol& each : builtInHangingProtocols())
        if (isFor(each, images)) return each.title.english();
    return {};
}

// A CT with a thin and a thick series and a scout, and three older ones; one of another patient.
class SlicesWithPriors : public testing::Test {
  protected:
    SlicesWithPriors() {
        dicom::Scan scan;
        for (const char* date : {"20200101", "20210101", "20220101"})
            scan.studies.push_back(test::studyOf(0, "DOE^JANE", date, "Chest",
                                                 {test::seriesOf(1, "Thin", {test::volumeOf(200)}),
                                                  test::seriesOf(2, "Thick", {test::volumeOf(40)})}));
        scan.studies.push_back(test::studyOf(1, "ROE^RICHARD", "20220601", "Chest",
                                             {test::seriesOf(1, "Thick", {test::volumeOf(40)})}));
        dicom::Stack scout = test::volumeOf(3);
        for (dicom::Frame& frame : scout.frames) frame.imageType = {"ORIGINAL", "PRIMARY", "LOCALIZER"};
        scan.studies.push_back(test::studyOf(
            0, "DOE^JANE", "20230101", "Chest",
            {test::seriesOf(1, "Scout", {scout}), test::seriesOf(2, "Thick", {test::volumeOf(300)}),
             test::seriesOf(3, "Thin", {test::volumeOf(200)})}));
        scan.studies.push_back(test::studyOf(0, "DOE^JANE", "20190101", "Head",
                                             {test::seriesOf(1, "T1", {test::volumeOf(40, "MR")}, "MR")}));
        scan.patients = 2;
        found_ = std::make_shared<const FoundVolumes>(std::move(scan));
        Progress progress;
        auto read = hangingImages(found_->scan().studies.at(4), *found_, progress);
        EXPECT_TRUE(read);
        if (read) images_ = *std::move(read);
    }
    std::shared_ptr<const FoundVolumes> found_;
    HangingImages images_;
};

TEST_F(SlicesWithPriors, ComeNewestFirstOfThePatientAndTheModality) {
    ASSERT_EQ(images_.studies.size(), 4u);
    EXPECT_EQ(images_.studies[0]->date, "20230101");
    EXPECT_EQ(images_.studies[1]->date, "20220101");
    EXPECT_EQ(images_.studies[3]->date, "20200101");
    EXPECT_EQ(images_.images.size(), 3u + 3u * 2u);
    for (const std::size_t study : {0u, 2u, 4u})
        EXPECT_EQ(&studyToRead(found_->scan().studies.at(study), *found_), images_.studies[0]);
    EXPECT_EQ(studyToRead(found_->scan().studies.at(3), *found_).date, "20220601") << "of another patient";
    EXPECT_TRUE(priorsOf(found_->scan().studies.at(0), *found_).empty())
        << "none is older, and the MR is none";
}

TEST_F(SlicesWithPriors, HangTheLargestSeriesAndThoseOfItsName) {
    EXPECT_EQ(firstFor(images_), "Slices with three priors");
    const auto hung = hang(builtIn("Slices with three priors"), images_);
    ASSERT_EQ(hung.size(), 4u);
    for (int prior = 0; prior < 4; ++prior) {
        ASSERT_TRUE(hung[std::size_t(prior)]);
        const HangingImage& image = images_.images[*hung[std::size_t(prior)]];
        EXPECT_EQ(image.prior, prior);
        EXPECT_EQ(image.of.series->description, "Thick") << "as the largest of the study that is read";
    }
}

TEST_F(SlicesWithPriors, WithoutThemOnlyTheSeriesHang) {
    std::erase_if(images_.images, [](const HangingImage& each) { return each.prior > 0; });
    EXPECT_EQ(firstFor(images_), "Two series of slices");
    const auto hung = hang(builtIn("Slices beside the prior"), images_);
    EXPECT_TRUE(hung[0]);
    EXPECT_FALSE(hung[1]);
    EXPECT_TRUE(hang(builtIn("Slices beside the prior"), {})[0] == std::nullopt);
    EXPECT_FALSE(isFor(builtIn("Slices beside the prior"), {}));
}

TEST_F(SlicesWithPriors, WhatAPersonSeesIsHungAgain) {
    // The thin series of the study, nothing, that of the prior before the last, the scout.
    const std::vector<std::optional<std::size_t>> shown{2, std::nullopt, 5, 0};
    const HangingProtocol own = protocolOf("Mine", 2, 2, shown, true, images_);
    EXPECT_TRUE(isFor(own, images_));
    EXPECT_EQ(hang(own, images_), shown);
    const auto read = hangingProtocolsFromJson(toJson(std::vector{own}));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->at(0), own);
}

class Mammograms : public testing::Test {
  protected:
    // Views in the order of files, which is no order of hanging.
    Mammograms() {
        dicom::Scan scan;
        for (const char* date : {"20220101", "20240101"}) {
            std::vector<dicom::Series> all;
            for (int n = 0; n < 4; ++n)
                all.push_back(
                    test::seriesOf(n + 1, "", {test::refused(dicom::key::kSingleSlice, "MG")}, "MG"));
            scan.studies.push_back(test::studyOf(0, "DOE^JANE", date, "Mammography", std::move(all)));
        }
        found_ = std::make_shared<const FoundVolumes>(std::move(scan));
        for (int prior = 0; prior < 2; ++prior) {
            const std::size_t study = prior == 0 ? 1 : 0;
            images_.studies.push_back(&found_->scan().studies[study]);
            for (std::size_t series = 0; series < 4; ++series) {
                HangingImage each = image(*found_, study, series, prior);
                each.laterality = series % 2 == 0 ? "L" : "R";
                each.view = series < 2 ? "MLO" : "CC";
                images_.images.push_back(each);
            }
        }
    }
    std::string sideAndView(std::optional<std::size_t> place) const {
        if (!place) return "-";
        return images_.images[*place].laterality + images_.images[*place].view +
               std::to_string(images_.images[*place].prior);
    }
    std::shared_ptr<const FoundVolumes> found_;
    HangingImages images_;
};

TEST_F(Mammograms, HangWithTheChestWallsTogether) {
    EXPECT_EQ(firstFor(images_), "Mammograms above the prior");
    std::string order;
    for (const auto& place : hang(builtIn("Mammograms above the prior"), images_))
        order += sideAndView(place) + " ";
    EXPECT_EQ(order, "RCC0 LCC0 RMLO0 LMLO0 RCC1 LCC1 RMLO1 LMLO1 ");
}

TEST_F(Mammograms, OfOneViewHangSideBySide) {
    std::erase_if(images_.images,
                  [](const HangingImage& each) { return each.prior > 0 || each.view == "CC"; });
    EXPECT_EQ(firstFor(images_), "Mammograms of both sides");
    const auto hung = hang(builtIn("Mammograms of both sides"), images_);
    EXPECT_EQ(sideAndView(hung[0]), "RMLO0");
    EXPECT_EQ(sideAndView(hung[1]), "LMLO0");
}

TEST(HangingImagesOfFiles, SayTheirBodyPartSideAndView) {
    const dicom::test::TemporaryFolder folder;
    dicom::test::SyntheticSeries series;
    series.modality = "CR";
    series.sopClassUid = UID_ComputedRadiographyImageStorage;
    series.size = {8, 8, 2};
    series.rawInstead = [](const dicom::test::Slice&, int i, int) { return i; };
    int written = 0;
    series.edits.push_back([&](DcmItem& item) {
        item.findAndDeleteElement(DCM_ImagePositionPatient);
        item.findAndDeleteElement(DCM_ImageOrientationPatient);
        put(item, DCM_BodyPartExamined, "CHEST");
        put(item, DCM_ViewPosition, written++ == 0 ? "PA" : "LL");
        put(item, DCM_Laterality, "L");
        put(item, DCM_StudyDate, "20240101");
    });
    dicom::test::writeFiles(folder.path(), series);
    Progress progress;
    auto scan = dicom::scanFolder(folder.path(), progress);
    ASSERT_TRUE(scan);
    const FoundVolumes found(*std::move(scan));
    const auto images = hangingImages(found.scan().studies.front(), found, progress);
    ASSERT_TRUE(images);
    ASSERT_EQ(images->images.size(), 2u);
    EXPECT_EQ(images->images[0].bodyPart, "CHEST");
    EXPECT_EQ(images->images[0].laterality, "L");
    EXPECT_NE(images->images[0].view, images->images[1].view);
    EXPECT_EQ(firstFor(*images), "Two X-rays");
    CancelToken stopped;
    stopped.cancel();
    Progress none({}, stopped);
    EXPECT_EQ(hangingImages(found.scan().studies.front(), found, none).error().code, ErrorCode::cancelled);
}

TEST(HangingProtocolsAsJson, RefuseWhatIsNoProtocol) {
    for (const char* text :
         {"", "[]", "{}", R"({"protocols": 3})", R"({"protocols": [{}]})", R"({"protocols": [3]})",
          R"({"protocols": [{"name": "", "rows": 1, "columns": 1, "boxes": []}]})",
          R"({"protocols": [{"name": "a", "rows": 0, "columns": 1, "boxes": []}]})",
          R"({"protocols": [{"name": "a", "rows": 1, "columns": 999, "boxes": []}]})",
          R"({"protocols": [{"name": "a", "rows": "1", "columns": 1, "boxes": []}]})",
          R"({"protocols": [{"name": "a", "rows": 1, "columns": 1, "boxes": [{}, {}]}]})",
          R"({"protocols": [{"name": "a", "rows": 1, "columns": 1, "boxes": [{"prior": -1}]}]})",
          R"({"protocols": [{"name": "a", "rows": 1, "columns": 1, "boxes": [{"number": 1e300}]}]})",
          "{\"protocols\": [{\"name\": \"\xff\", \"rows\": 1, \"columns\": 1, \"boxes\": []}]}"}) {
        const auto read = hangingProtocolsFromJson(text);
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().code, ErrorCode::inputNotUsable);
    }
    EXPECT_TRUE(hangingProtocolsFromJson(R"({"protocols": []})")->empty());
}

TEST(HangingProtocolsOfAPerson, AreAddedByName) {
    HangingProtocol mine{.name = "Mine"};
    mine.boxes = {{}};
    auto all = withHangingProtocol({}, mine);
    ASSERT_TRUE(all);
    mine.isLinked = true;
    all = withHangingProtocol(*all, mine);
    ASSERT_TRUE(all);
    ASSERT_EQ(all->size(), 1u);
    EXPECT_TRUE(all->front().isLinked);
    mine.name.clear();
    EXPECT_FALSE(withHangingProtocol(*all, mine));
    mine.name.assign(kLongestHangingName + 1, 'x');
    EXPECT_FALSE(withHangingProtocol(*all, mine));
    for (std::size_t n = all->size(); n < kMostHangingProtocols; ++n) {
        mine.name = "Number " + std::to_string(n);
        all = withHangingProtocol(*all, mine);
        ASSERT_TRUE(all);
    }
    mine.name = "One more";
    EXPECT_FALSE(withHangingProtocol(*all, mine));
}

}  // namespace
}  // namespace macula::study
