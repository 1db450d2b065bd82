// The selected point of a transfer function, and the edits that mouse and keys propose.
#pragma once

#include <QObject>
#include <optional>

#include "scene/transfer/edited_transfer.h"
#include "viewer/transfer/transfer_plot.h"

namespace macula::viewer {

// Does not change the function of the plot: an edit emits the wanted one, which a listener may give to the
// plot before the signal returns.
class TransferEdits : public QObject {
    Q_OBJECT

  public:
    explicit TransferEdits(TransferPlot& plot) : plot_(plot) {}  // outlives this

    std::optional<PointId> selected() const { return selected_; }
    void select(std::optional<PointId> point);
    void deselectIfGone();
    // Selects the next or previous point; points of opacity come before those of colour. Beyond the last,
    // selects none and returns false.
    bool selectNext(bool forwards);

    void propose(const TransferFunction& function, bool isDrag);
    void removeSelected();
    // Adds a point halfway from the selected one to the next, or to the end of the axis.
    void addBesideSelected();
    // Proposes what was added; if that was accepted, selects and returns the new point.
    std::optional<PointId> add(PointId::Curve curve, const scene::Added& added, bool isDrag);

    void endDrag() { Q_EMIT dragEnded(); }
    // True if a colour point is selected.
    bool askForColour();

  Q_SIGNALS:
    void edited(const macula::TransferFunction& function);   // a complete edit
    void dragged(const macula::TransferFunction& function);  // during a drag
    void dragEnded();
    void selectionChanged();
    void colourAsked();  // a person wants to edit the selected point's colour

  private:
    TransferPlot& plot_;
    std::optional<PointId> selected_;
};

}  // namespace macula::viewer
