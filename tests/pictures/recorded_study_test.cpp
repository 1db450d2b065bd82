// What is told of a recording: figures of its frames in motion, and why none had a fovea.
#include "pictures/recorded_study.h"

#include <gtest/gtest.h>

namespace macula::pictures {
namespace {

constexpr const char* kAdvice = "not sharp enough to be shown: give it longer by --learn";

// A small picture before a model that learns is fit to be shown.
live::FrameShown early() {
    live::FrameShown frame{.picture = live::OnScreen::preview, .stage = live::Stage::moving};
    frame.look = trace::Look::cinematic;
    frame.latencyMs = 20.0;
    frame.model.stage = hybrid::ModelStage::learning;
    frame.model.isSharp = false;
    return frame;
}

live::LiveRecording recordingOf(std::vector<live::FrameShown> frames) {
    live::LiveRecording recording;
    for (live::FrameShown& shown : frames) {
        live::RecordedFrame frame;
        shown.inputSequence = recording.frames.size() + 1;
        frame.atS = 0.1 * double(recording.frames.size());
        frame.phase = live::RecordingPhase::moving;
        frame.shown = std::move(shown);
        recording.frames.push_back(std::move(frame));
    }
    return recording;
}

std::string told(const std::vector<live::FrameShown>& frames) {
    return textOf(motionFigures(recordingOf(frames)));
}

TEST(RecordedStudy, SaysThatTheModelCameTooLateForAnyFovea) {
    const std::string line = told({early(), early(), early()});
    EXPECT_NE(line.find("0 of 3 with a fovea."), std::string::npos) << line;
    EXPECT_NE(line.find(kAdvice), std::string::npos) << line;

    live::FrameShown withFovea = early();
    withFovea.picture = live::OnScreen::model;
    withFovea.model.isSharp = true;
    withFovea.foveaAgeMs = 40.0;
    EXPECT_EQ(told({early(), withFovea}).find("--learn"), std::string::npos) << "one had a fovea";
}

TEST(RecordedStudy, AdvisesNothingThatWouldNotHelp) {
    live::FrameShown projection = early();
    projection.look = trace::Look::mip;
    live::FrameShown parallel = early();
    parallel.camera.parallelHeightMm = 200.0;
    live::FrameShown fit = early();
    fit.model.isSharp = true;
    live::FrameShown failed = early();
    failed.model.stage = hybrid::ModelStage::failed;
    live::FrameShown noRoom = early();
    noRoom.model.stage = hybrid::ModelStage::noRoom;
    live::FrameShown none = early();
    none.model = {};
    for (const live::FrameShown& frame : {projection, parallel, fit, failed, noRoom, none})
        EXPECT_EQ(told({frame, frame}).find("--learn"), std::string::npos) << nameOf(frame.model.stage);
    EXPECT_EQ(told({}), "No frame followed the camera.");
}

}  // namespace
}  // namespace macula::pictures
