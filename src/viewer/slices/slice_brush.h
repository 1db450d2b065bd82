// What the tool for segments does in a pane of slices.
#pragma once

#include <glm/glm.hpp>

namespace macula::viewer {

struct BrushTouch {
    glm::dvec3 mm{0.0};      // on the slice that is on screen, in the world of the study
    glm::dvec3 normal{0.0};  // of the slice; a unit vector
};

// A press of the left button, drags, and a release. All panes share one.
class SliceBrush {
  public:
    virtual ~SliceBrush() = default;

    virtual bool press(const BrushTouch& at) = 0;  // false: there is nothing to drag
    virtual void drag(const BrushTouch& to) = 0;
    virtual void release() = 0;
    virtual void drop() = 0;              // the drag ended, and is not meant
    virtual double radiusMm() const = 0;  // of the ring around the pointer; 0: none
};

}  // namespace macula::viewer
