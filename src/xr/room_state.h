// All that a person can choose in the room, as one value. Knows no OpenXR.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::xr {

// The share of frame time that goes to tracing where the eyes look.
enum class RoomQuality { fast, balanced, fine };
double foveaShareOf(RoomQuality quality);          // relative to the usual budget: 1 is balanced
std::uint32_t mostSamplesOf(RoomQuality quality);  // per pixel of the fovea, while nothing moves

struct RoomState {
    std::shared_ptr<const TransferFunction> transferFunction = {};
    std::shared_ptr<const Clip> clip = {};  // null: all of the volume is shown
    RoomQuality quality = RoomQuality::balanced;

    bool operator==(const RoomState& b) const;  // by value
};

// States that can be undone.
class RoomHistory {
  public:
    static constexpr std::size_t kMostSteps = 200;  // older ones are dropped

    explicit RoomHistory(RoomState first) : states_{std::move(first)} {}
    const RoomState& now() const { return states_.back(); }
    void push(RoomState next);  // does nothing for an equal state
    bool canUndo() const { return states_.size() > 1; }
    const RoomState& before() const;  // needs canUndo()
    void undo() { states_.pop_back(); }

  private:
    std::vector<RoomState> states_;
};

// The left eye's picture as displayed: 8 bits each, row 0 on top. Holds no names.
struct EyeView {
    glm::ivec2 sizePx{0};
    std::vector<std::uint8_t> rgba;  // opaque
};

}  // namespace macula::xr
