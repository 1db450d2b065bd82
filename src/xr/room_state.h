// What a person can choose in the room, as one value. Knows no OpenXR.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::xr {

// How much of the time of frames goes to what is traced where the eyes look.
enum class RoomQuality { fast, balanced, fine };
double foveaShareOf(RoomQuality quality);          // of the usual budget: 1 is balanced
std::uint32_t mostSamplesOf(RoomQuality quality);  // of each pixel of it, while nothing moves

struct RoomState {
    std::shared_ptr<const TransferFunction> transferFunction = {};
    std::shared_ptr<const Clip> clip = {};  // null: all of the volume is shown
    RoomQuality quality = RoomQuality::balanced;

    bool operator==(const RoomState& b) const;  // by value
};

// Steps that can be undone.
class RoomHistory {
  public:
    static constexpr std::size_t kMostSteps = 200;  // older ones are forgotten

    explicit RoomHistory(RoomState first) : states_{std::move(first)} {}
    const RoomState& now() const { return states_.back(); }
    void push(RoomState next);  // nothing happens where it is the same
    bool canUndo() const { return states_.size() > 1; }
    const RoomState& before() const;  // after canUndo
    void undo() { states_.pop_back(); }

  private:
    std::vector<RoomState> states_;
};

// A picture of the left eye, as it is shown: 8 bits each, row 0 on top. Holds no names.
struct EyeView {
    glm::ivec2 sizePx{0};
    std::vector<std::uint8_t> rgba;  // opaque
};

}  // namespace macula::xr
