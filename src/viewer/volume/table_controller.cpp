#include "viewer/volume/table_controller.h"

#include <QAction>
#include <QMainWindow>

#include "viewer/status/study_notes.h"
#include "viewer/status/work_status.h"
#include "viewer/volume/hidden_voxels.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/volume/table_removal.h"

namespace macula::viewer {

TableController::TableController(const WindowContext& context)
    : QObject(&context.window), table_(context.shown.table()), bar_(new WorkBar) {
    showWork(table_, *bar_, tr("Looking for the table"), context.notifications);
    connect(&table_, &TableRemoval::changed, &context.notes, &StudyNotes::show);
    context.notes.ask(NoteOn::table, [&table = table_] { return table.notes(); });
    connect(&context.shown.hidden(), &HiddenVoxels::failed, &context.notifications,
            &Notifications::failUnlessCancelled);
    connect(&context.shown.additions(), &ShownAdditions::failed, &context.notifications,
            &Notifications::failUnlessCancelled);
}

QAction& TableController::action() const {
    return table_.action();
}

void TableController::endAt(const QAction& action) {
    connect(&action, &QAction::triggered, &table_, &TableRemoval::cancel);
}

}  // namespace macula::viewer
