// A presentation state of PET, which Macula shows in other values than the images have.
#include <gtest/gtest.h>

#include "app/choice/catalogue.h"
#include "app/presentation/presentation_file.h"
#include "app/presentation/state_of_presentation.h"
#include "app/study/study_input.h"
#include "dicom/presentation/presentation_state.h"
#include "pipeline/volume/window.h"
#include "support.h"
#include "synthetic_pet.h"

namespace macula::app {
namespace {

// What is shown in SUV is written as the Bq/mL that the images have; of others such values are refused,
// because nobody has said what they are in SUV.
TEST(PresentationOfPet, HasTheValuesOfTheImages) {
    const dicom::test::TemporaryFolder folder;
    writeFiles(folder.path(), dicom::test::petSeries());
    const auto scan = dicom::test::scan(folder.path());
    ASSERT_TRUE(scan);
    const dicom::Series& series = scan->studies.at(0).series.at(0);
    Progress progress;
    const auto pet = loadStudy(*scan, folder.path(), {}, progress);
    ASSERT_TRUE(pet.ok());
    ASSERT_EQ(pet->volume->unit(), Unit::suvBodyWeight);
    PresentationWish wish;
    const Catalogue catalogue = *builtInCatalogue();
    wish.state.preset = *findPreset(catalogue, "cinematic-pet");
    wish.state.settings.look = trace::Look::mip;
    wish.state.windows.at(std::size_t(trace::Look::mip)) = windowOver({0.0, 8.0});
    wish.state.camera = frameBox(pet->volume->worldBox(), ViewDirection::anterior, 25.0, 1.5);
    wish.volume = pet->volume;
    wish.images = *presentedImages(series, series.stacks.at(0));
    const std::filesystem::path path = folder / "state.dcm";
    ASSERT_TRUE(writePresentation(path, wish).ok());
    const auto read = dicom::readPresentationState(path);
    ASSERT_TRUE(read.ok());
    const double becquerels = 8.0 / dicom::test::kSuvPerBqPerMl;
    EXPECT_NEAR(read->presentation.palette.values.high, becquerels, 1e-3 * becquerels);
    auto foreign = *read;
    foreign.presentation.ownState.clear();
    auto presented = stateOf(foreign, StudyState{}, "a.dcm");
    ASSERT_TRUE(presented.ok());
    const auto done = completeFor(*presented, foreign, *pet->volume, pet->seriesDigest, {}, "a.dcm");
    ASSERT_FALSE(done.ok());
    EXPECT_EQ(done.error().code, ErrorCode::inputNotUsable);
}

}  // namespace
}  // namespace macula::app
