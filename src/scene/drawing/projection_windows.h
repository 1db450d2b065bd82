// The windows of projections: the values that they show, from black to white.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/volume.h"
#include "pipeline/trace/look.h"

namespace macula::scene {

// The default windows for projections of a volume: that of the series, for MIP only if that is not mostly
// white (maximumWindow). Each look has its own window, because the largest value along a ray and the mean can
// lie far apart.
class SeriesWindows {
  public:
    DisplayWindow of(trace::Look look, const Volume& volume) const;
    // Must be called before `of` gets another volume.
    void forget() {
        series_.reset();
        maximum_.reset();
    }

  private:
    mutable std::optional<DisplayWindow> series_;  // cached: both take a while to find
    mutable std::optional<DisplayWindow> maximum_;
};

// `from` after a drag by `byHeights`, in picture heights, y downwards: wider to the right, brighter up. Never
// wider than twice the range of the volume's values, nor centred outside of it, unless `from` or a window of
// the series is: beyond that the picture is one grey.
DisplayWindow dragged(const DisplayWindow& from, glm::dvec2 byHeights, const Volume& volume);

// Width and level, as radiologists have them: "W 400 L 40 HU".
std::string windowText(const DisplayWindow& window, const std::string& unit);

}  // namespace macula::scene
