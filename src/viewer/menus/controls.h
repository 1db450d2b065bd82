// Describes controls: names for tests and desktop scripts, titles for screen readers, and tool tips.
#pragma once

#include <QAction>
#include <QLabel>
#include <QString>
#include <QWidget>

namespace macula::viewer {

inline void describe(QWidget& control, const char* name, const QString& title, const QString& tip) {
    control.setObjectName(QLatin1String(name));
    control.setAccessibleName(title);
    control.setToolTip(tip);
}

inline void describe(QAction& action, const char* name, const QString& tip) {
    action.setObjectName(QLatin1String(name));
    action.setToolTip(tip);
}

// For sentences, which wrap and are never read as HTML.
inline void makePlain(QLabel& label, const char* name) {
    label.setObjectName(QLatin1String(name));
    label.setTextFormat(Qt::PlainText);
    label.setWordWrap(true);
}

}  // namespace macula::viewer
