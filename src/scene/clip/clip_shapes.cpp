#include "scene/clip/clip_shapes.h"

#include <algorithm>
#include <type_traits>

namespace macula::scene {

namespace {

// One of each kind, for what does not depend on where it is.
std::vector<ShownShapePtr> oneOfEach() {
    std::vector<ShownShapePtr> shapes;
    Clip none;
    forEachPart(none, [&](auto& part, Keep keep) {
        using Shape = typename std::remove_cvref_t<decltype(part)>::value_type;
        shapes.push_back(shown(Shape{}, keep, 0));
    });
    return shapes;
}

}  // namespace

std::vector<glm::dvec3> ShownShape::dots(const PictureRays&, const Box&) const {
    return {};
}

bool ShownShape::has(const ClipHandle& handle) const {
    return std::ranges::count(handles(Box{}), handle, &PlacedHandle::handle) > 0;
}

std::vector<ShownShapePtr> shownShapes(const Clip& clipMm) {
    std::vector<ShownShapePtr> shapes;
    std::size_t planes = 0;
    forEachShape(clipMm, [&](const ClipShape auto& shape, Keep keep) {
        using Shape = std::remove_cvref_t<decltype(shape)>;
        shapes.push_back(shown(shape, keep, std::is_same_v<Shape, HalfSpace> ? planes++ : 0));
    });
    return shapes;
}

const std::vector<PanelTool>& panelTools() {
    static const std::vector<PanelTool> all = [] {
        std::vector<PanelTool> tools;
        for (const ShownShapePtr& shape : oneOfEach())
            if (auto tool = shape->panelTool()) tools.push_back(*std::move(tool));
        return tools;
    }();
    return all;
}

const std::vector<HandTool>& handTools() {
    static const std::vector<HandTool> all = [] {
        std::vector<HandTool> tools;
        for (const ShownShapePtr& shape : oneOfEach())
            if (auto tool = shape->handTool()) tools.push_back(*std::move(tool));
        std::ranges::stable_sort(tools, {}, &HandTool::place);
        return tools;
    }();
    return all;
}

}  // namespace macula::scene
