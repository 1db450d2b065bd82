// A panel that clips the volume: by name, by faces in mm, and at the cross-hair.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <functional>
#include <vector>

#include "scene/clip/clip_shapes.h"
#include "scene/clip/edited_clip.h"
#include "viewer/clip/face_row.h"
#include "viewer/clip/wheel_guard.h"
#include "viewer/editor/study_editor.h"

namespace macula::viewer {

// Shows the clip of the session's state, and proposes changes to it. A button is disabled while its edit
// would fail, and its tool tip says why. The session outlives it.
class ClipPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ClipPanel(StudyEditor& session, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    using Edited = Result<scene::OptionalClip>;
    // A button and its edit, which is called only while a study is open.
    struct Tool {
        QPushButton* button;
        QString what;
        std::function<Edited()> edit;
        bool showsAll = false;  // also removes the cuts
    };

    // A shape that a button removes, and the size that a person chose for it.
    struct SizedShape {
        scene::PanelTool tool;
        QDoubleSpinBox* size;
    };

    void makeClips();
    QWidget* makeFaces();
    QWidget* makeCuts();
    QWidget* makeSizes();  // slab, shapes of a size, and corner
    QPushButton* addShapeTool(const scene::PanelTool& shape, QDoubleSpinBox& size);
    QPushButton* addTool(const QString& text, const QString& name, const QString& what,
                         std::function<Edited()> edit);
    QDoubleSpinBox* makeMmBox(const QString& name, const QString& what, double mm);

    void chooseFromList(int index);
    void propose(const Edited& edited, bool isDrag, bool showsAll = false);
    void showStudy();
    void showClip();
    void showInList();
    void showFaces();
    void showTools();  // also shows the cross-hair's position

    const Volume& volume() const { return *session_.study().volume; }
    const scene::OptionalClip& clip() const { return session_.state().clip; }
    glm::dvec3 crosshairMm() const;
    Edited removedSide(scene::Face side) const;
    Edited removedCorner() const;
    Edited withoutClip() const;

    StudyEditor& session_;
    WheelGuard* guard_;
    QComboBox* clips_;
    std::vector<FaceRow*> faces_;  // in the order of scene::kFaces
    std::vector<Tool> tools_;
    QLabel* besides_;
    QLabel* crosshair_;
    QLabel* trouble_;
    QComboBox* orientations_ = nullptr;
    QDoubleSpinBox* thickness_ = nullptr;
    std::vector<SizedShape> shapes_;
    QComboBox* corners_ = nullptr;
    scene::OptionalClip lastOwn_;  // this study's last unlisted clip, for the list to restore
};

}  // namespace macula::viewer
