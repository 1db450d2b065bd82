#include "viewer/join_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace macula::viewer {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("JoinQuestion", text);
}

}  // namespace

void askToJoin(QWidget* parent, const QString& question, std::function<void()> join) {
    auto* box = new QMessageBox(QMessageBox::Question, tr("One series?"),
                                question + tr(" Are they one series?"), QMessageBox::Cancel, parent);
    box->setInformativeText(
        tr("If you join them, check that all of them are of one patient and one examination."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(tr("&Join Them"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(yes, &QPushButton::clicked, box, [join = std::move(join)] { join(); });
    box->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer
