#include "viewer/slices/typed_window.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "pipeline/volume/window.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/harmless_text.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

struct TypedWindow {
    Q_DECLARE_TR_FUNCTIONS(SliceMenu)
};

}  // namespace

void askForWindow(StudyEditor& session, QWidget* parent) {
    if (!session.hasStudy()) return;
    const Volume& volume = *session.study().measured();
    const std::optional<DisplayWindow> before = session.state().slices.window;
    const DisplayWindow usual = seriesWindow(volume);
    const double width = before.value_or(usual).width;
    auto* dialog = new QDialog(parent);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("window-dialog"));
    dialog->setWindowTitle(TypedWindow::tr("Window of the Slices"));
    auto* form = new QFormLayout(dialog);
    const auto hasChanged = std::make_shared<bool>(false);
    const auto addNumber = [&](const char* name, const QString& title, double DisplayWindow::*member,
                               double least) {
        auto* box = new QDoubleSpinBox(dialog);
        describe(*box, name, title, title);
        box->setRange(least, 1e9);
        // Four digits of the width, as small as values may be.
        box->setDecimals(std::clamp(3 - int(std::floor(std::log10(std::max(width, 1e-9)))), 0, 9));
        box->setValue(before.value_or(usual).*member);
        const QString unit = harmless(QString::fromStdString(volume.unitName()));
        if (!unit.isEmpty()) box->setSuffix(QLatin1Char(' ') + unit);
        form->addRow(title, box);
        QObject::connect(box, &QDoubleSpinBox::valueChanged, &session,
                         [&session, usual, member, hasChanged](double value) {
                             *hasChanged = true;
                             session.drag(TypedWindow::tr("Window"), [&](scene::StudyState& next) {
                                 DisplayWindow typed = next.slices.window.value_or(usual);
                                 typed.*member = value;
                                 typed.explanation.clear();
                                 next.slices.window = typed;
                             });
                         });
        return box;
    };
    QDoubleSpinBox* first = addNumber("window-width", TypedWindow::tr("&Width"), &DisplayWindow::width, 1e-9);
    addNumber("window-level", TypedWindow::tr("&Level"), &DisplayWindow::center, -1e9);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, dialog);
    form->addRow(buttons);
    QObject::connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    // Other steps may have followed, so this puts the window back instead of undoing the last step.
    QObject::connect(dialog, &QDialog::finished, &session, [&session, before, hasChanged](int result) {
        session.endDrag();
        if (result != QDialog::Rejected || !*hasChanged) return;
        session.change(TypedWindow::tr("Window"),
                       [&](scene::StudyState& next) { next.slices.window = before; });
    });
    // The steps of another study are not its own to undo.
    QObject::connect(&session, &StudyEditor::studyShown, dialog, [dialog, hasChanged] {
        *hasChanged = false;
        dialog->reject();
    });
    first->selectAll();
    dialog->open();
}

}  // namespace macula::viewer
