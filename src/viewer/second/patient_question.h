// The question before a volume of another patient is shown beside the study.
#pragma once

#include <QString>
#include <QStringList>
#include <functional>

class QWidget;

namespace macula::viewer {

// Returns at once; later calls `open` if the person agrees, else `leave`. `differs` names attributes, without
// values: "ID". Enter and Esc decline.
void askAboutPatient(QWidget* parent, const QStringList& differs, std::function<void()> open,
                     std::function<void()> leave);

}  // namespace macula::viewer
