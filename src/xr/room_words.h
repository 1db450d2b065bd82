// The texts in the room: on the panel, and before the eyes. In English, unless a host has other words.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "base/text.h"
#include "xr/clip_tools.h"
#include "xr/room_state.h"

namespace macula::xr {

// %1 is replaced by an argument. A button of half the panel's width has room for 15 letters; the glyphs are
// those of panel_picture.h.
struct RoomWords {
    std::string shift = "Shift";
    std::string knifeOn = "Knife: on";
    std::string knifeOff = "Knife: off";
    std::string hold = "Hold: %1";
    std::string nothing = "nothing";
    std::string resetClips = "Reset clips";
    std::string undo = "Undo";
    std::string takePicture = "Take picture";
    std::string otherWrist = "Other wrist";
    std::string realSize = "Real size 1:1";
    std::string larger = "%1 times real size";
    std::string smaller = "1/%1 of real size";
    std::string notCalibrated = "Size is not calibrated";  // instead of all sizes
    std::string recentre = "Before me";
    std::string quality = "Quality: %1";
    std::string fast = "fast";
    std::string balanced = "balanced";
    std::string fine = "fine";
    std::string notForDiagnosis = "Not for primary diagnosis";

    std::string isRealSize = "Real size 1:1: a millimetre is a millimetre.";
    std::string isBeforeYou = "Before you, at real size 1:1.";
    std::string nothingLeft = "Nothing would be left to see: that was not done.";
    std::string noMoreCuts = "No more than six cuts: undo one, or reset the clips.";
    std::string lostPlace = "The headset has lost its place. Look around.";
    std::string pictureWritten = "Picture %1 is written.";

    std::string edited = "edited";              // marks a changed preset, as scene::ownCopy does
    std::map<std::string, std::string> titles;  // of built-in presets, by the English title
    char decimalSign = '.';
    // Translates errors, notes and the names of shapes. Called on any thread.
    std::function<std::string(const Text&)> say = [](const Text& text) { return text.english(); };

    const std::string& of(RoomQuality chosen) const;
    std::string of(ClipTool tool) const;  // of a tool other than the knife
    std::string ofTitle(std::string_view title) const;
    std::string ofNumber(std::string number) const;  // `number` has a decimal point
};

// `pattern` with `what` instead of %1.
std::string filled(std::string pattern, std::string_view what);

}  // namespace macula::xr
