// Distances between two places of the matter that is seen in 3D.
#pragma once

#include <QObject>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/overlay/picture_tool.h"

namespace macula::viewer {

// While it is out, each second place adds a distance to the measurements of the study, on whatever slices its
// ends lie; dots draw the distances over the picture. It takes no drags, so that the picture can be turned
// between both places.
class DistanceIn3d : public QObject, public PictureTool {
    Q_OBJECT

  public:
    explicit DistanceIn3d(StudyEditor& session, QObject* parent = nullptr);  // the session outlives it

    bool isOut() const { return isOut_; }
    void setOut(bool out);  // forgets an end without another
    // A place, patient LPS mm. Returns the distance that it completes, as it was added.
    std::optional<slices::Measurement> add(const glm::dvec3& mm);

    bool press(const PicturePlace&) override { return false; }
    void move(const PicturePlace&) override {}
    void release(const PicturePlace&) override {}
    void giveUp() override {}
    bool changesPicture() const override { return false; }
    std::optional<Qt::CursorShape> point(const PicturePlace&) override { return std::nullopt; }
    bool turnWheel(double, const PictureGeometry&) override { return false; }
    std::vector<ToolMark> marks(const PictureGeometry& picture) const override;

  Q_SIGNALS:
    void drawn();  // the marks have changed

  private:
    StudyEditor& session_;
    bool isOut_ = false;
    std::optional<glm::dvec3> beginMm_;
};

}  // namespace macula::viewer
