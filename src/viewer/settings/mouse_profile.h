// What the buttons of the mouse do on slices and on images, as a person knows it from another viewer.
#pragma once

#include <QString>
#include <array>

namespace macula::viewer {

enum class MouseDrag { tool, window, pan, zoom, scroll };

// `left` acts without a tool: on slices with the cross-hair, where a click still sets it and marks can still
// be dragged. MouseDrag::tool is what the tool does.
struct MouseProfile {
    const char* name;  // in settings
    MouseDrag leftOnSlices;
    MouseDrag leftOnImages;
    MouseDrag middle;
    MouseDrag right;
};
inline constexpr std::array kMouseProfiles{
    MouseProfile{"macula", MouseDrag::tool, MouseDrag::window, MouseDrag::pan, MouseDrag::window},
    MouseProfile{"window", MouseDrag::window, MouseDrag::window, MouseDrag::pan, MouseDrag::zoom},
    MouseProfile{"scroll", MouseDrag::scroll, MouseDrag::scroll, MouseDrag::window, MouseDrag::zoom},
};

// The one in use; the first until another is chosen.
const MouseProfile& mouseProfile();
// An unknown name chooses the first. On the UI thread.
void useMouseProfile(const QString& name);

// Scrolling by a drag: an image for each.
inline constexpr double kScrollPx = 8.0;

}  // namespace macula::viewer
