// Every hostile study: what comes of it, and what is said. No wrong volume is silent.
#include "hostile_studies.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "base/paths.h"
#include "pitfalls/opened.h"

namespace macula::dicom::test {
namespace {

class HostileStudies : public ::testing::TestWithParam<HostileStudy> {};

bool isOf(const Volume& volume, const SyntheticSeries& truth) {
    const glm::dmat4 affine = truth.expectedAffine();
    return volume.size() == truth.size && affineError(volume.worldFromVoxel(), affine) < 1e-3 &&
           std::abs(volume.value(0, 0, 0) - truth.rampOf()(transformPoint(affine, glm::dvec3(0)))) < 1.0;
}

bool holds(const std::vector<Message>& messages, std::string_view key) {
    return std::any_of(messages.begin(), messages.end(),
                       [&](const Message& m) { return m.key == key && m.severity >= Severity::warning; });
}

// Anywhere that `render` tells of.
bool isSaid(const Opened& opened, const std::vector<std::shared_ptr<const Volume>>& volumes,
            std::string_view key) {
    for (const auto& volume : volumes) {
        if (holds(volume->provenance().messages, key)) return true;
    }
    for (const Message* message : opened.messages()) {
        if (message->key == key && message->severity >= Severity::warning) return true;
    }
    return false;
}

TEST_P(HostileStudies, IsShownAndSaid) {
    const HostileStudy& study = GetParam();
    const TemporaryFolder folder;
    const std::vector<SyntheticSeries> truths = study.write(folder.path());
    const Opened opened(folder.path());
    std::vector<std::shared_ptr<const Volume>> volumes;
    for (const Stack* stack : opened.volumes()) {
        volumes.push_back(opened.load(*stack));
        ASSERT_NE(volumes.back(), nullptr);
    }
    EXPECT_EQ(volumes.size(), study.volumes) << opened.keys();
    for (const std::string_view key : study.said)
        EXPECT_TRUE(isSaid(opened, volumes, key)) << key << " is not among " << opened.keys();
    for (const SyntheticSeries& truth : truths) {
        const auto found = std::find_if(volumes.begin(), volumes.end(),
                                        [&](const auto& volume) { return isOf(*volume, truth); });
        ASSERT_NE(found, volumes.end()) << opened.keys();
        expectVolumeOf(**found, truth);
    }
    EXPECT_TRUE(truths.size() >= study.volumes || !study.said.empty());
    // Where nothing has to be said, nothing is.
    if (study.said.empty()) {
        EXPECT_FALSE(isSaid(opened, volumes, key::kAlternatingValues));
        EXPECT_FALSE(isSaid(opened, volumes, key::kChangesAlongStack));
    }
}

INSTANTIATE_TEST_SUITE_P(All, HostileStudies, ::testing::ValuesIn(hostileStudies()), [](const auto& study) {
    std::string name(study.param.name);
    for (char& c : name) c = c == '-' || c == '.' ? '_' : c;
    return name;
});

TEST(HostileStudiesPage, ListsEachOfThem) {
    std::ostringstream page;
    page << std::ifstream(macula::test::projectFolder() / "docs/dicom.md").rdbuf();
    std::string table;
    for (const HostileStudy& study : hostileStudies()) {
        std::string said;
        for (const std::string_view key : study.said)
            said += fmt::format("{}`{}`", said.empty() ? "" : ", ", key);
        table += fmt::format("| `{}` | {} | {} | {} |\n", study.name, study.about, study.shown, said);
    }
    EXPECT_NE(page.str().find(table), std::string::npos) << "the table should be:\n" << table;
}

}  // namespace
}  // namespace macula::dicom::test
