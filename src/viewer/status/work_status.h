// Shows background work in the status line.
#pragma once

#include <QObject>
#include <QString>

#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

// Shows work that emits began, progressed (not all work does), ended and failed in its bar, whose button
// cancels the work. Earlier messages are hidden when it begins. The bar shows `stage` until the work reports
// a stage of its own.
template <class Work>
void showWork(Work& work, WorkBar& bar, const QString& stage, Notifications& notifications) {
    QObject::connect(&work, &Work::began, &bar, [&bar, &notifications, stage] {
        notifications.hide();
        bar.begin(stage);
    });
    if constexpr (requires { &Work::progressed; })
        QObject::connect(&work, &Work::progressed, &bar, &WorkBar::setProgress);
    QObject::connect(&bar, &WorkBar::cancelClicked, &work, [&work] { work.cancel(); });
    QObject::connect(&work, &Work::ended, &bar, &QWidget::hide);
    QObject::connect(&work, &Work::failed, &notifications,
                     [&notifications](const Error& error) { notifications.fail(error); });
}

}  // namespace macula::viewer
