// What each shape of a clip is to a person: what a slice shows of it, its handles, and the tools that make
// it. World frame: patient LPS, mm.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "scene/camera/picture_rays.h"
#include "scene/clip/kept_box.h"
#include "scene/clip/slice_polygons.h"

namespace macula::scene {

class HandlesOnSlice;

struct ClipHandle {
    enum class Kind {
        face,         // a face of keptBox
        removedFace,  // a face of a box that is removed
        plane,        // an oblique plane of the clip
        eye,          // the plane of the EyeCut
        corner,
        ballCentre,
        ballRadius,
    };
    Kind kind = Kind::face;
    Face face = Face::right;  // for face and removedFace
    std::size_t plane = 0;    // for plane: index into Clip::planes

    bool operator==(const ClipHandle&) const = default;
};

struct PlacedHandle {
    ClipHandle handle;
    glm::dvec3 atMm{0.0};
    glm::dvec3 along{0.0};  // unit: the direction it can move in; zero: any direction
    // The centre of what looks the same from all sides: the handle may lie, and move, on any side of it.
    std::optional<glm::dvec3> aroundMm = {};
};

// A button of a panel that removes a shape of a size at the cross-hair.
struct PanelTool {
    std::string_view key;      // names the button: "clip-ball"
    std::string_view sizeKey;  // and its size: "clip-radius"
    Text button;
    Text whatItDoes;
    Text size;
    Text whatSizeIs;
    double firstMm = 20.0;
    ValueRange (*sizesMm)(const Volume& volume);  // that are usable
    Result<OptionalClip> (*removed)(const OptionalClip& clip, const glm::dvec3& atMm, double sizeMm,
                                    const Volume& volume);
};

// A shape that a hand in the headset holds, and removes from what it shows.
struct HandTool {
    std::string_view key;
    Text name;             // at most 9 letters, see RoomWords
    int place = 0;         // in the order in which a person is offered them
    bool isRound = false;  // its outline is a ring; if not, the faces of a box
    void (*remove)(Clip& clip, const glm::dvec3& centreMm, double halfMm);  // in place of an earlier one
};

// A shape of a clip, in mm. A new shape begins in pipeline/volume/clip.h; here it has its class in shapes/,
// and a line below.
class ShownShape {
  public:
    virtual ~ShownShape() = default;

    // Whether it bounds keptBox, whose faces are one part of a clip together.
    virtual bool isFace() const { return false; }
    // What a person is told besides the faces: "A ball is removed." Empty for a face, and for planes, which
    // are counted.
    virtual Text remark() const { return {}; }

    // Contours that wind around what it removes of a slice, as removedContours.
    virtual std::vector<Contour> removedOn(const slices::SliceFrame& frame) const = 0;
    // The line where its border meets the slice, within the outline of the volume if it does not end itself.
    // Empty if it misses the slice, or is a face.
    virtual Contour lineOn(const slices::SliceFrame& frame, const Contour& volumeOutline) const = 0;
    // Its border in the picture of a camera. Empty if it is a face.
    virtual std::vector<glm::dvec3> dots(const PictureRays&, const Box& volumeMm) const;

    virtual std::vector<PlacedHandle> handles(const Box& volumeMm) const = 0;
    virtual void addHandles(HandlesOnSlice& slice) const = 0;
    bool has(const ClipHandle& handle) const;
    // Of a clip with this shape, as scene::withHandleAt and turnedInsideOut.
    virtual Result<OptionalClip> withHandleAt(const OptionalClip& clip, const ClipHandle& handle,
                                              const glm::dvec3& mm, const Volume& volume) const = 0;
    virtual Result<OptionalClip> turnedInsideOut(ClipPreset clip, const Volume& volume) const = 0;

    virtual std::optional<PanelTool> panelTool() const { return {}; }
    virtual std::optional<HandTool> handTool() const { return {}; }
};
using ShownShapePtr = std::unique_ptr<const ShownShape>;

// `number`: of a plane, its index into Clip::planes.
ShownShapePtr shown(const OrientedBox& box, Keep keep, std::size_t number);
ShownShapePtr shown(const HalfSpace& plane, Keep keep, std::size_t number);
ShownShapePtr shown(const Octant& corner, Keep keep, std::size_t number);
ShownShapePtr shown(const Ball& ball, Keep keep, std::size_t number);

// The shapes of a clip in mm, in the order of forEachShape.
std::vector<ShownShapePtr> shownShapes(const Clip& clipMm);

// Of all shapes that a clip can have.
const std::vector<PanelTool>& panelTools();
const std::vector<HandTool>& handTools();

}  // namespace macula::scene
