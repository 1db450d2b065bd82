// D28: numbers of the geometry with commas, blanks or semicolons where backslashes and points should be.
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>

#include "opened.h"

namespace macula::dicom::test {
namespace {

using D28Separators = Pitfall;

std::string replaced(std::string text, char from, const std::string& to) {
    std::string result;
    for (const char c : text) result += c == from ? to : std::string(1, c);
    return result;
}

Edit rewritten(const std::vector<DcmTagKey>& tags, const std::function<std::string(std::string)>& change) {
    return [tags, change](DcmItem& item) {
        for (const DcmTagKey& tag : tags) {
            OFString value;
            ASSERT_TRUE(item.findAndGetOFStringArray(tag, value).good());
            put(item, tag, change(value.c_str()));
        }
    };
}

TEST_F(D28Separators, AreReadWhereThereIsOneReading) {
    const std::vector<DcmTagKey> all{DCM_PixelSpacing, DCM_ImagePositionPatient, DCM_ImageOrientationPatient};
    const std::vector<std::function<std::string(std::string)>> ways{
        [](const std::string& text) { return replaced(text, '\\', ","); },
        [](const std::string& text) { return replaced(text, '\\', " "); },
        [](const std::string& text) { return replaced(text, '\\', "; "); },
    };
    series.worldFromVoxel = glm::dmat4(1.0);
    series.worldFromVoxel[0] = {0.75, 0, 0, 0};
    series.worldFromVoxel[1] = {0, 1.25, 0, 0};
    series.worldFromVoxel[2] = {0, 0, 2.5, 0};
    for (std::size_t w = 0; w < ways.size(); ++w) {
        SCOPED_TRACE(w);
        const TemporaryFolder own;
        SyntheticSeries written = series;
        written.edits = {rewritten(all, ways[w])};
        writeFiles(own.path(), written);
        const Opened opened(own.path());
        expectOnlyVolume(opened, series);
        const Message* told = opened.find(key::kRepairedNumbers);
        ASSERT_NE(told, nullptr) << opened.keys();
        EXPECT_EQ(told->severity, Severity::warning);
        EXPECT_EQ(numberArgument(*told, "count"), series.size.z);
    }
}

TEST_F(D28Separators, DecimalCommasAreReadBetweenBackslashes) {
    series.edits = {rewritten({DCM_PixelSpacing}, [](const std::string&) { return "0,75\\0,5"; })};
    series.worldFromVoxel = glm::dmat4(1.0);
    series.worldFromVoxel[0] = {0.5, 0, 0, 0};
    series.worldFromVoxel[1] = {0, 0.75, 0, 0};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    expectOnlyVolume(opened, series);
    EXPECT_TRUE(opened.says(key::kRepairedNumbers)) << opened.keys();
}

TEST_F(D28Separators, WhatHasSeveralReadingsIsNamed) {
    series.edits = {rewritten({DCM_PixelSpacing}, [](const std::string&) { return "1,5"; })};
    writeFiles(folder.path(), series);
    const Opened opened = open();
    EXPECT_TRUE(opened.volumes().empty());
    const Message* told = opened.find(key::kMalformedNumbers);
    ASSERT_NE(told, nullptr) << opened.keys();
    EXPECT_NE(told->sentence.english().find("PixelSpacing"), std::string::npos) << told->sentence;
    EXPECT_FALSE(opened.says(key::kNoPixelSpacing)) << "they do say it";
}

TEST_F(D28Separators, OfAnotherProgram) {
    SKIP_WITHOUT_SHARED_DATA();
    const Opened opened(sharedData() / "failures/other/spacing-comma-separated");
    const auto volumes = opened.volumes();
    ASSERT_EQ(volumes.size(), 1u) << opened.keys();
    EXPECT_EQ(volumes[0]->spacingMm->x, 0.7);
    EXPECT_EQ(volumes[0]->spacingMm->y, 0.9);
}

}  // namespace
}  // namespace macula::dicom::test
