// A view that is said as a presentation state, and read again.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/sha256.h"
#include "scene/choice/catalogue.h"
#include "scene/presentation/presentation_of_state.h"
#include "scene/presentation/state_of_presentation.h"
#include "support.h"

namespace macula::scene {

inline const Catalogue& catalogue() {
    static const Catalogue all = *builtInCatalogue();
    return all;
}

inline std::shared_ptr<const TransferFunction> preset(const std::string& name) {
    for (const auto& each : catalogue().presets) {
        if (each->name == name) return each;
    }
    ADD_FAILURE() << name;
    return catalogue().presets.front();
}

inline ClipPreset clip(const std::string& name) {
    for (const auto& each : catalogue().clips) {
        if (each->name == name) return *each;
    }
    ADD_FAILURE() << name;
    return {};
}

inline double distance(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b);
}

class APresentation : public testing::Test {
  protected:
    void SetUp() override {
        // Along the patient's axes, and not.
        straight_ = std::make_shared<const Volume>(dicom::test::smallVolume(
            affine({2.0, 0, 0}, {0, 2.5, 0}, {0, 0, 3.0}, {-5.0, 10.0, 700.0}), {1.0, -1000.0}, "CT"));
        oblique_ = std::make_shared<const Volume>(dicom::test::smallVolume());
        state_.preset = preset("ct-bone");
        state_.settings.look = trace::Look::dvr;
        state_.settings.shading = trace::Shading::headlight;
        state_.camera = frameBox(straight_->worldBox(), ViewDirection::left, 25.0, 1.5);
    }
    dicom::PresentationState said(const Volume& volume, bool withOwnState, bool isDeidentified = false) {
        auto said = presentationOf(state_, volume, 1.5, isDeidentified);
        EXPECT_TRUE(said.ok()) << (said ? Text() : said.error().message);
        if (!said) return {};
        leftOut_ = said->leftOut;
        said->presentation.series.seriesInstanceUid = kSeries;
        if (!withOwnState) said->presentation.ownState.clear();
        return {.presentation = said->presentation, .messages = {}};
    }
    PresentedState again(const dicom::PresentationState& read, const Volume& volume) {
        auto presented = stateOf(read, StudyState{}, "a.dcm");
        EXPECT_TRUE(presented.ok()) << (presented ? Text() : presented.error().message);
        if (!presented) return {};
        const auto done = completeFor(*presented, read, volume, sha256Hex(kSeries), {}, "a.dcm");
        EXPECT_TRUE(done.ok()) << (done ? Text() : done.error().message);
        return *presented;
    }

    static constexpr const char* kSeries = "2.25.4711";
    const dicom::test::TemporaryFolder folder_;
    std::shared_ptr<const Volume> straight_;
    std::shared_ptr<const Volume> oblique_;
    StudyState state_;
    std::vector<Text> leftOut_;
};

}  // namespace macula::scene
