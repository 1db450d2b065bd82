// Shifts and widens the transfer function by a drag in the picture.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <optional>

#include "viewer/editor/study_editor.h"
#include "viewer/transfer/transfer_function_editor.h"

namespace macula::viewer {

// All moves up to end() are one undo step. Edits the same copy as the editor. Lives on the UI thread.
class TransferDrag : public QObject {
    Q_OBJECT

  public:
    // Both outlive this.
    TransferDrag(StudyEditor& session, const TransferFunctionEditor& editor, QObject* parent = nullptr);

    // Movement since the last call, in heights of the picture: right shifts towards larger values, by the
    // curve's width for one height; up widens, four times for one height.
    void drag(QPointF byHeights);
    void end();

  Q_SIGNALS:
    void told(const QString& what);  // for the status line; empty: the drag has ended

  private:
    StudyEditor& session_;
    const TransferFunctionEditor& editor_;
    std::optional<TransferFunctionEditor::Edited> base_;  // the copy and its map when the drag began
    QPointF moved_;                                       // since then
    bool isRefused_ = false;
};

}  // namespace macula::viewer
