// How far a live model (live_model.h) has come, for those who tell a person.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace macula::hybrid {

enum class ModelStage {
    none,       // nobody asked for one
    searching,  // for the points that it begins with, and learns what they look like
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

struct ModelNews {
    ModelStage stage = ModelStage::none;
    std::uint32_t splats = 0;
    std::uint64_t steps = 0;
    std::size_t views = 0;  // it has learnt from, or is judged by

    bool operator==(const ModelNews&) const = default;
};

}  // namespace macula::hybrid
