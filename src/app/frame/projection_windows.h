// Which of the values projections show, from black to white.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "base/volume.h"
#include "pipeline/trace/look.h"

namespace macula::app {

// One window for each look, as the largest value along a ray and the mean have little to do with each other:
// the one that somebody set in this look, by hand or by a preset; else that of the series, for MIP only if
// that is not mostly white. So it does not depend on what was chosen in other looks, where nobody saw a
// window.
class ProjectionWindows {
  public:
    DisplayWindow of(trace::Look look, const Volume& volume) const;

    void set(trace::Look look, std::optional<DisplayWindow> window) { set_.at(std::size_t(look)) = window; }

    // `from`, changed by a hand that moved by so much of the picture's height: wider to the right, brighter
    // up.
    void drag(trace::Look look, const DisplayWindow& from, glm::dvec2 byHeights);
    void forget(trace::Look look);  // what was set
    // Before another volume is asked for.
    void forgetAll() { *this = {}; }

  private:
    std::array<std::optional<DisplayWindow>, trace::kLooks.size()> set_;
    mutable std::optional<DisplayWindow> maximum_;  // of the volume; takes a while to find
};

// Width and level, as radiologists have them: "W 400 L 40 HU".
std::string windowText(const DisplayWindow& window, const std::string& unit);

}  // namespace macula::app
