#include "viewer/volume/join_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(JoinQuestion)
};

}  // namespace

void askToJoin(QWidget* parent, const QString& question, std::function<void()> join) {
    auto* box = new QMessageBox(QMessageBox::Question, Words::tr("One series?"),
                                question + Words::tr(" Are they one series?"), QMessageBox::Cancel, parent);
    box->setInformativeText(
        Words::tr("If you join them, check that all of them are of one patient and one examination."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(Words::tr("&Join Them"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(yes, &QPushButton::clicked, box, [join = std::move(join)] { join(); });
    box->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer
