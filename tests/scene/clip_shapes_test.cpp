// What a person does with each shape that a clip can have, from the list of them.
#include "scene/clip/clip_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include "base/phantom.h"
#include "scene/clip/clip_handles.h"
#include "scene/clip/edited_clip.h"
#include "scene/clip/handles_on_slice.h"
#include "scene/clip/removed_on_slice.h"

namespace macula::scene {
namespace {

const Volume& volume() {
    static const Volume made = phantom::make({.size = {12, 10, 8}, .spacingMm = {20, 20, 25}});
    return made;
}

slices::SliceFrame frame() {
    return {.plane = slices::planeOf(slices::Orientation::axial, {3, 4, 5}),
            .mmPerPixel = 1.1,
            .sizePx = {260, 240}};
}

// A clip of one shape for each tool of the panel, and the same inside out.
std::vector<OptionalClip> clipsOfTools() {
    std::vector<OptionalClip> clips;
    for (const PanelTool& tool : panelTools()) {
        const ValueRange sizes = tool.sizesMm(volume());
        const double mm = std::clamp(tool.firstMm, sizes.low, sizes.high);
        const auto removed = tool.removed({}, volume().worldBox().centre(), mm, volume());
        EXPECT_TRUE(removed.ok()) << tool.key;
        if (!removed) continue;
        const auto kept = turnedInsideOut(*removed, volume());
        EXPECT_TRUE(kept.ok()) << tool.key;
        if (kept) clips.insert(clips.end(), {*removed, *kept});
    }
    return clips;
}

TEST(ShownShapes, AToolOfThePanelRemovesWhatTurningInsideOutShows) {
    ASSERT_FALSE(panelTools().empty());
    const std::vector<OptionalClip> clips = clipsOfTools();
    ASSERT_EQ(clips.size(), 2 * panelTools().size());
    const Box all = volume().worldBox();
    for (std::size_t i = 0; i < clips.size(); ++i) {
        const bool isKept = i % 2 == 1;
        const Clip inMm = macula::clipFor(*clips[i], volume());
        EXPECT_EQ(shows(inMm, all.centre()), isKept) << i;
        EXPECT_EQ(shows(inMm, all.low + 1.0), !isKept) << i;
        const auto shapes = shownShapes(inMm);
        ASSERT_EQ(shapes.size(), 1u) << i;
        EXPECT_FALSE(shapes[0]->remark().empty()) << i;
    }
}

TEST(ShownShapes, AToolOfAHandRemovesWhatItHolds) {
    ASSERT_FALSE(handTools().empty());
    std::set<std::string_view> keys;
    for (const HandTool& tool : handTools()) {
        EXPECT_TRUE(keys.insert(tool.key).second) << tool.key;
        EXPECT_FALSE(tool.name.empty());
        Clip clip;
        tool.remove(clip, {10, 20, 30}, 30.0);
        ASSERT_TRUE(validate(clip).ok()) << tool.key;
        EXPECT_EQ(shownShapes(clip).size(), 1u) << tool.key;
        EXPECT_FALSE(shows(clip, {10, 20, 30})) << tool.key;
        EXPECT_FALSE(shows(clip, {10, 20, 58})) << tool.key;
        EXPECT_TRUE(shows(clip, {10, 20, 90})) << tool.key;
    }
    EXPECT_TRUE(std::ranges::is_sorted(handTools(), {}, &HandTool::place));
}

TEST(ShownShapes, RemoveOfASliceWhatTheyDoNotShow) {
    for (const OptionalClip& clip : clipsOfTools()) {
        const Clip inMm = macula::clipFor(*clip, volume());
        const std::vector<Contour> removed = shownShapes(inMm).at(0)->removedOn(frame());
        int checked = 0;
        for (int y = 3; y < frame().sizePx.y; y += 7) {
            for (int x = 3; x < frame().sizePx.x; x += 7) {
                const glm::dvec2 px(x + 0.37, y + 0.41);
                const auto isShown = [&](double dx, double dy) {
                    return shows(inMm, frame().worldFromPicture(px + glm::dvec2(dx, dy)));
                };
                const bool here = isShown(0, 0);
                // At a border a curve is a polygon.
                if (isShown(-2, 0) != here || isShown(2, 0) != here || isShown(0, -2) != here ||
                    isShown(0, 2) != here)
                    continue;
                ASSERT_EQ(isInsideContours(removed, px), !here) << x << " " << y;
                ++checked;
            }
        }
        EXPECT_GT(checked, 300);
    }
}

TEST(ShownShapes, KnowTheirHandles) {
    for (const OptionalClip& clip : clipsOfTools()) {
        const auto shapes = shownShapes(macula::clipFor(*clip, volume()));
        const auto handles = shapes.at(0)->handles(volume().worldBox());
        EXPECT_FALSE(handles.empty());
        for (const PlacedHandle& placed : handles) {
            EXPECT_TRUE(shapes[0]->has(placed.handle));
            const auto moved =
                withHandleAt(clip, {}, placed.handle, placed.atMm + 2.0 * placed.along, volume());
            EXPECT_TRUE(moved.ok());
        }
        const slices::SliceFrame axial = frame();
        HandlesOnSlice slice(axial, volume());
        shapes[0]->addHandles(slice);
        const auto onSlice = slice.take();
        EXPECT_FALSE(onSlice.empty());
        for (const PlacedHandle& placed : onSlice) EXPECT_TRUE(shapes[0]->has(placed.handle));
        EXPECT_FALSE(shapes[0]->has({.kind = ClipHandle::Kind::face}));
        EXPECT_FALSE(shapes[0]->has({.kind = ClipHandle::Kind::eye}));
    }
}

}  // namespace
}  // namespace macula::scene
