// Paints a pane of slices.
#pragma once

#include <QCoreApplication>
#include <QPainter>
#include <QPointF>
#include <QRect>
#include <QStringList>
#include <optional>

#include "viewer/overlay/slice_overlay.h"
#include "viewer/slices/pane_clip.h"
#include "viewer/slices/pane_content.h"
#include "viewer/slices/pane_measurements.h"
#include "viewer/slices/pane_picture.h"

namespace macula::viewer {

// Paints the picture on screen with clip and overlay, whose texts may name the patient.
class SlicePainting {
    Q_DECLARE_TR_FUNCTIONS(SlicePainting)

  public:
    struct Parts {  // outlive this
        const PaneContent& content;
        const PanePicture& picture;
        PaneMeasurements& measurements;
        PaneClip& clip;
    };
    explicit SlicePainting(const Parts& parts) : parts_(parts) {}

    // Lines that identify the study; empty ones are left out.
    void setLines(const QStringList& lines);
    void showNames(bool shown) { namesShown_ = shown; }

    // `pane` in logical pixels; `notes` are over the picture; `pointedAt`: the pointer, if it is in the pane.
    void paint(QPainter& painter, const QRect& pane, const QStringList& notes,
               const std::optional<QPointF>& pointedAt);
    // Around the pointer; nothing for a radius of 0, over a second volume, or without a picture.
    void paintRing(QPainter& painter, const QPointF& pointedAt, double radiusMm) const;
    static void paintFocus(QPainter& painter, const QRect& pane, const QColor& ink);
    static QString noStudyText();

  private:
    SliceOverlay overlay(const QStringList& notes, const std::optional<QPointF>& pointedAt);

    Parts parts_;
    QStringList lines_;
    bool namesShown_ = true;
};

}  // namespace macula::viewer
