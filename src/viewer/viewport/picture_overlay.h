// The overlay of the 3D picture: names and notes, letters of the sides, cube, scale, and the marks of tools.
#pragma once

#include <QSize>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "live/frame/picture_text.h"
#include "scene/camera/orbit_camera.h"
#include "scene/drawing/drawing.h"
#include "viewer/overlay/cube_and_scale.h"
#include "viewer/overlay/painted_text.h"
#include "viewer/overlay/tool_marks.h"

namespace macula::viewer {

// Repaints a part only if it would look different. Needs a QGuiApplication.
class PictureOverlay {
  public:
    // Lines that identify patient and study.
    void setNames(std::vector<std::string> names);
    // Lines about the picture that names do not hide.
    void setNotes(std::vector<std::string> notes) { notes_ = std::move(notes); }
    // Both return whether anything changed.
    bool showNames(bool shown);
    bool showCube(bool shown);  // with the scale
    bool showsNames() const { return namesShown_; }
    bool showsCube() const { return cubeShown_; }

    // For a picture of `pixels` device pixels on a screen of `pixelRatio`; may be null.
    std::shared_ptr<const live::PictureText> text(const scene::Drawing& drawing, QSize pixels,
                                                  double pixelRatio);
    // `picture`: nothing without a study. `letters` are those of its camera. May be null. Takes a few tenths
    // of a millisecond, little enough for each step of a drag.
    std::shared_ptr<const live::PictureText> marks(const std::optional<MarkedPicture>& picture,
                                                   std::vector<ToolMark> ofTools,
                                                   const scene::EdgeLetters& letters);

  private:
    struct TextOf {
        LinesOver lines;
        QSize pixels;
        double pixelRatio = 0.0;
        double fontScale = 0.0;

        bool operator==(const TextOf&) const = default;
    };
    struct Marked {
        MarkedPicture picture;
        bool hasCube = true;
        double fontScale = 1.0;
        std::vector<ToolMark> ofTools = {};

        bool operator==(const Marked&) const = default;
    };
    static std::shared_ptr<const live::PictureText> paintStanding(const Marked& marked,
                                                                  const scene::EdgeLetters& letters);

    std::vector<std::string> names_;
    std::vector<std::string> notes_;
    bool namesShown_ = true;
    bool cubeShown_ = true;
    TextOf textOf_;  // the sources of text_
    std::shared_ptr<const live::PictureText> text_;
    std::optional<Marked> marked_;                       // the sources of marks_
    std::shared_ptr<const live::PictureText> standing_;  // letters, cube and scale: a part of marks_
    std::shared_ptr<const live::PictureText> marks_;
};

}  // namespace macula::viewer
