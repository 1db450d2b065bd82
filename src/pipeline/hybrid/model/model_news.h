// How far a live model (live_model.h) has come, for those who tell a person.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace macula::hybrid {

enum class ModelStage {
    none,       // nobody asked for one
    searching,  // for a stored one, or for the points that it begins with, and learns what they look like
    resuming,   // what was shown before is drawn, while the rest of it is read
    learning,
    resting,       // it has learnt what its pictures can teach it
    nothingToSee,  // there is nothing that it could be of
    noRoom,        // the device has no memory for it beside what is shown
    failed,        // it could not be made or drawn, for another reason
};

// The name as in reports; a literal.
constexpr std::string_view nameOf(ModelStage stage) {
    switch (stage) {
        case ModelStage::none:
            return "none";
        case ModelStage::searching:
            return "searching";
        case ModelStage::resuming:
            return "resuming";
        case ModelStage::learning:
            return "learning";
        case ModelStage::resting:
            return "resting";
        case ModelStage::nothingToSee:
            return "nothing to see";
        case ModelStage::noRoom:
            return "no room";
        case ModelStage::failed:
            return "failed";
    }
    return {};
}

// What it began with.
enum class ModelOrigin {
    none,           // there is no model
    points,         // nothing of use was stored
    damagedPoints,  // likewise: what was stored is damaged
    shelf,          // itself, shown before in this run of the program
    stored,         // itself, stored by an earlier one
    otherLights,    // the stored model of other lights
    otherTrainer,   // the stored model of an older trainer or tracer
};

// The name as in reports, and why; literals.
constexpr std::string_view nameOf(ModelOrigin origin) {
    switch (origin) {
        case ModelOrigin::none:
            return "none";
        case ModelOrigin::points:
        case ModelOrigin::damagedPoints:
            return "fresh";
        case ModelOrigin::shelf:
        case ModelOrigin::stored:
            return "resumed";
        case ModelOrigin::otherLights:
            return "warm";
        case ModelOrigin::otherTrainer:
            return "stale";
    }
    return {};
}
constexpr std::string_view describe(ModelOrigin origin) {
    switch (origin) {
        case ModelOrigin::none:
            return "there is no model";
        case ModelOrigin::points:
            return "no model of this is stored";
        case ModelOrigin::damagedPoints:
            return "the stored model of this is damaged";
        case ModelOrigin::shelf:
            return "this was shown before";
        case ModelOrigin::stored:
            return "a model of this was stored";
        case ModelOrigin::otherLights:
            return "a model of this in other lights was stored";
        case ModelOrigin::otherTrainer:
            return "a model of this was stored by another version of the trainer or the tracer";
    }
    return {};
}

struct ModelNews {
    ModelStage stage = ModelStage::none;
    ModelOrigin origin = ModelOrigin::none;
    std::uint32_t splats = 0;
    std::uint64_t steps = 0;
    std::size_t views = 0;  // it has learnt from, or is judged by

    // It shows more than a coarse picture would (coarse_picture.h), or has learnt for as long as that takes
    // where nothing is held out that could tell.
    bool isSharp = false;

    bool operator==(const ModelNews&) const = default;
};

// The one place that says so. A model that is not fit is shown nowhere where there can be another picture.
constexpr bool isFitToBeShown(const ModelNews& model) {
    const bool isThere = model.stage == ModelStage::resuming || model.stage == ModelStage::learning ||
                         model.stage == ModelStage::resting;
    return isThere && model.isSharp;
}

}  // namespace macula::hybrid
