// The keys of a pane of slices.
#pragma once

#include <QCoreApplication>
#include <QPointF>
#include <glm/glm.hpp>
#include <optional>

#include "viewer/editor/study_editor.h"
#include "viewer/slices/pane_curve.h"
#include "viewer/slices/pane_measurements.h"
#include "viewer/slices/pane_turn.h"
#include "viewer/slices/pane_zoom.h"
#include "viewer/slices/slice_hand.h"
#include "viewer/slices/slice_popups.h"
#include "viewer/slices/slice_travel.h"
#include "viewer/slices/slice_windowing.h"

class QKeyEvent;

namespace macula::viewer {

// Passes keys to the parts of the pane, which outlive it.
class SliceKeys {
    Q_DECLARE_TR_FUNCTIONS(SliceKeys)

  public:
    struct Parts {
        StudyEditor& session;
        const PaneContent& content;
        PaneZoom& zoom;
        SliceTravel& travel;
        SliceWindowing& windowing;
        PaneMeasurements& measurements;
        SliceCine& cine;
        SliceHand& hand;
        SlicePopups& popups;
        PaneCurve& curve;
        PaneTurn& turn;
    };
    explicit SliceKeys(const Parts& parts) : parts_(parts) {}

    // The pane, in logical pixels.
    struct Pane {
        glm::ivec2 sizePx{1};
        bool isVisible = true;                  // cine runs only then
        std::optional<QPointF> pointedAt = {};  // the pointer, while it is in the pane
    };
    // Returns whether it handled the key; without a study it handles none.
    bool press(const QKeyEvent& event, const Pane& pane);

  private:
    void turnPlanes(bool clockwise, bool byStep);
    bool pressPlain(int key, bool withShift, const Pane& pane);
    bool pressOfMeasurements(int key);

    Parts parts_;
};

}  // namespace macula::viewer
