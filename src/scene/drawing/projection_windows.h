// Which of the values projections show, from black to white.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/volume.h"
#include "pipeline/trace/look.h"

namespace macula::app {

// What projections of a volume are seen through when nobody has set a window: that of the series, for MIP
// only if that is not mostly white. A window belongs to a look, as the largest value along a ray and the mean
// have little to do with each other.
class SeriesWindows {
  public:
    DisplayWindow of(trace::Look look, const Volume& volume) const;
    // Must be called before another volume is asked for.
    void forget() {
        series_.reset();
        maximum_.reset();
    }

  private:
    mutable std::optional<DisplayWindow> series_;  // of the volume; both take a while to find
    mutable std::optional<DisplayWindow> maximum_;
};

// `from`, changed by a hand that moved by so much of the picture's height: wider to the right, brighter up.
// Never wider than twice the values of the volume, nor centred beside them, unless `from` or a window of its
// series is: farther on the picture is one grey.
DisplayWindow dragged(const DisplayWindow& from, glm::dvec2 byHeights, const Volume& volume);

// Width and level, as radiologists have them: "W 400 L 40 HU".
std::string windowText(const DisplayWindow& window, const std::string& unit);

}  // namespace macula::app
