// A hand in the picture that shifts and widens the transfer function.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>

#include "viewer/session/viewer_session.h"
#include "viewer/transfer/transfer_function_editor.h"

namespace macula::viewer {

// From the first movement to end() all is one step of the session's history. What is edited is the copy that
// the editor edits. Lives on the UI thread.
class TransferDrag : public QObject {
    Q_OBJECT

  public:
    // Both outlive this.
    TransferDrag(ViewerSession& session, const TransferFunctionEditor& editor, QObject* parent = nullptr);

    // Since the last time, in heights of the picture: to the right shifts towards larger values, one height
    // by as much as the curve is wide; up widens, four times for a height.
    void drag(QPointF byHeights);
    void end();

  signals:
    void told(const QString& what);  // for the status line; empty: it is over

  private:
    ViewerSession& session_;
    const TransferFunctionEditor& editor_;
    std::optional<TransferFunctionEditor::Edited> base_;  // as it was when the hand began
    QPointF moved_;                                       // since then
    bool isRefused_ = false;
};

}  // namespace macula::viewer
