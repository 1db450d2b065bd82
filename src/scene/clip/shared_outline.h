// Immutable points of an outline, shared by its copies: a study has many outlines, and each undo step holds
// them all.
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace macula::scene {

class SharedOutline {
  public:
    using Points = std::vector<glm::dvec2>;

    SharedOutline() = default;
    // Implicit, so that points can stand for an outline.
    SharedOutline(Points points)
        : points_(points.empty() ? nullptr : std::make_shared<const Points>(std::move(points))) {}
    SharedOutline(std::initializer_list<glm::dvec2> points) : SharedOutline(Points(points)) {}

    const Points& points() const {
        static const Points none;
        return points_ ? *points_ : none;
    }
    operator const Points&() const { return points(); }
    Points::const_iterator begin() const { return points().begin(); }
    Points::const_iterator end() const { return points().end(); }
    std::size_t size() const { return points().size(); }
    const glm::dvec2& front() const { return points().front(); }
    const glm::dvec2& operator[](std::size_t i) const { return points()[i]; }

    // Equal for copies that share their points; null without points.
    const void* identity() const { return points_.get(); }
    bool operator==(const SharedOutline& b) const { return points_ == b.points_ || points() == b.points(); }

  private:
    std::shared_ptr<const Points> points_;  // null: none
};

}  // namespace macula::scene
