// The progress of a live model (live_model.h), for display.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace macula::hybrid {

enum class ModelStage {
    none,       // no model was requested
    searching,  // for a stored model, or for points to begin with; then takes the first steps
    resuming,   // draws the stored splats, while the rest of the file is read
    learning,
    resting,       // has learnt what its pictures can teach it
    nothingToSee,  // the scene shows nothing
    noRoom,        // the device has too little memory for a model
    failed,        // the model could not be made or drawn, for another reason
};

// The name in reports; a string literal.
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

// What a model began with.
enum class ModelOrigin {
    none,           // there is no model
    points,         // no useful model was stored
    damagedPoints,  // likewise, because the stored model is damaged
    shelf,          // this model, shown before in this run of the program
    stored,         // this model, stored by an earlier run
    otherLights,    // a stored model under other lights
    otherTrainer,   // a stored model of another trainer or tracer version
    neighbour,      // a model of nearly the same matter: of the phase before or after
};

// The name in reports, and the reason; string literals.
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
        case ModelOrigin::neighbour:
            return "neighbour";
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
        case ModelOrigin::neighbour:
            return "a model of a neighbouring phase was there";
    }
    return {};
}

struct ModelNews {
    ModelStage stage = ModelStage::none;
    ModelOrigin origin = ModelOrigin::none;
    std::uint32_t splats = 0;
    std::uint64_t steps = 0;
    std::size_t views = 0;  // learnt or held out

    // The model shows more than a coarse picture would (coarselyShown); or, if too few pictures are held
    // out to judge that, it has learnt for as long as this usually takes.
    bool isSharp = false;

    bool operator==(const ModelNews&) const = default;
};

// The only place that decides this. An unfit model is shown only if there cannot be another picture.
constexpr bool isFitToBeShown(const ModelNews& model) {
    const bool isThere = model.stage == ModelStage::resuming || model.stage == ModelStage::learning ||
                         model.stage == ModelStage::resting;
    return isThere && model.isSharp;
}

}  // namespace macula::hybrid
