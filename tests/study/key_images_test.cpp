// The key images of a folder: what selections name, what they reject, and how the list of studies marks them.
#include "study/documents/key_images.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "study/list/study_tree.h"
#include "study/open/opened_study.h"
#include "support.h"
#include "synthetic.h"

namespace macula::study {
namespace {

namespace fs = std::filesystem;
using dicom::test::appended;
using dicom::test::nested;
using dicom::test::put;

class KeyImagesOfAFolder : public testing::Test {
  protected:
    void SetUp() override {
        series_.size = {8, 7, 12};
        slices_ = dicom::test::slicesOf(series_);
        dicom::test::writeFiles(folder_ / "ct", series_, slices_);
    }
    void select(const std::string& name, const std::string& code, const std::string& title,
                const std::vector<std::string>& uids) {
        dicom::test::Shell keys{.sopClassUid = UID_KeyObjectSelectionDocumentStorage,
                                .modality = "KO",
                                .sopInstanceUid = "2.25.32" + name,
                                .seriesUid = "2.25.33" + name};
        keys.edits.push_back([&, this](DcmItem& root) {
            put(root, DCM_PatientName, series_.patientName);
            put(root, DCM_PatientID, series_.patientId);
            put(root, DCM_StudyInstanceUID, series_.studyUid);
            put(root, DCM_ValueType, "CONTAINER");
            DcmItem& concept_ = nested(root, DCM_ConceptNameCodeSequence);
            put(concept_, DCM_CodeValue, code);
            put(concept_, DCM_CodingSchemeDesignator, "DCM");
            put(concept_, DCM_CodeMeaning, title);
            for (const std::string& uid : uids) {
                DcmItem& image = appended(root, DCM_ContentSequence);
                put(image, DCM_RelationshipType, "CONTAINS");
                put(image, DCM_ValueType, "IMAGE");
                DcmItem& sop = nested(image, DCM_ReferencedSOPSequence);
                put(sop, DCM_ReferencedSOPClassUID, UID_CTImageStorage);
                put(sop, DCM_ReferencedSOPInstanceUID, uid);
            }
        });
        dicom::test::writeShell(folder_ / (name + ".dcm"), keys);
    }
    KeyImages find(const fs::path& path) {
        auto study = openStudy(path, progress_);
        EXPECT_TRUE(study) << study.error().message;
        found_ = study->found;
        const auto keys = findKeyImages(*found_, progress_);
        EXPECT_TRUE(keys) << keys.error().message;
        return keys ? *keys : KeyImages();
    }
    std::string detailsOf(Names names, const KeyImages& keys) {
        std::string all;
        for (const StudyRow& row : studyTree(*found_, names, &keys).rows)
            for (const Text& line : row.details) all += line.english() + "|";
        return all;
    }

    dicom::test::TemporaryFolder folder_;
    dicom::test::SyntheticSeries series_;
    std::vector<dicom::test::Slice> slices_;
    std::shared_ptr<const FoundVolumes> found_;
    Progress progress_;
};

TEST_F(KeyImagesOfAFolder, AreThoseThatSelectionsNameEachOnce) {
    select("1", "113000", "Of Interest", {slices_[9].sopInstanceUid, "2.25.404", slices_[2].sopInstanceUid});
    select("2", "113002", "For Referring Provider", {slices_[2].sopInstanceUid, slices_[4].sopInstanceUid});
    const KeyImages keys = find(folder_.path());
    ASSERT_EQ(keys.images().size(), 3u) << "one is not here, and one is named twice";
    EXPECT_EQ(keys.inOrder().size(), 3u);
    const auto uidOf = [](const KeyImage& image) {
        return image.place.stack->frames[image.place.frame].instance->sopInstanceUid;
    };
    EXPECT_EQ(uidOf(keys.images()[0]), slices_[9].sopInstanceUid) << "as the selection has them";
    EXPECT_EQ(uidOf(keys.images()[1]), slices_[2].sopInstanceUid);
    EXPECT_EQ(uidOf(keys.images()[2]), slices_[4].sopInstanceUid);
    EXPECT_NE(detailsOf(Names::shown, keys).find("★ 3 key images: Of Interest, For Referring Provider"),
              std::string::npos);
    const std::string hidden = detailsOf(Names::hidden, keys);
    EXPECT_NE(hidden.find("★ 3 key images|"), std::string::npos) << "titles may name somebody";
    EXPECT_EQ(hidden.find("Referring"), std::string::npos);
}

TEST_F(KeyImagesOfAFolder, RejectedImagesAreNoneToStepTo) {
    select("1", "113001", "Rejected for Quality Reasons", {slices_[3].sopInstanceUid});
    select("2", "113000", "Of Interest", {slices_[5].sopInstanceUid});
    const KeyImages keys = find(folder_.path());
    ASSERT_EQ(keys.images().size(), 2u);
    ASSERT_EQ(keys.inOrder().size(), 1u);
    EXPECT_FALSE(keys.images()[keys.inOrder()[0]].isRejected);
    const std::string details = detailsOf(Names::shown, keys);
    EXPECT_NE(details.find("★ 1 key image: Of Interest"), std::string::npos);
    EXPECT_NE(details.find("Rejected images: 1: Rejected for Quality Reasons"), std::string::npos);
}

TEST_F(KeyImagesOfAFolder, ManifestsChooseNone) {
    select("1", "113030", "Manifest", {slices_[3].sopInstanceUid});
    const KeyImages keys = find(folder_.path());
    EXPECT_TRUE(keys.images().empty());
    EXPECT_EQ(detailsOf(Names::shown, keys).find("key image"), std::string::npos);
}

// Slices 2 and 4 by truth/2_structured.json.
TEST_F(KeyImagesOfAFolder, OfTheSharedSelection) {
    SKIP_WITHOUT_SHARED_DATA();
    const fs::path data = dicom::test::sharedData() / "planar/2_structured/made_ko_and_gsps";
    if (!fs::exists(data)) GTEST_SKIP() << "not here: " << data;
    const KeyImages keys = find(data);
    ASSERT_EQ(keys.images().size(), 2u);
    for (std::size_t n = 0; n < 2; ++n) {
        const ImagePlace& place = keys.images()[n].place;
        EXPECT_EQ(place.stack->frames[place.frame].instance->file.filename(), n == 0 ? "02.dcm" : "04.dcm");
        EXPECT_EQ(keys.images()[n].why.english(), "Of Interest");
    }
}

}  // namespace
}  // namespace macula::study
