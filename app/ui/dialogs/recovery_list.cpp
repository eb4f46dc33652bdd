#include "app/ui/dialogs/recovery_list.h"

#include "app/model/experiment/experiment.h"
#include "app/model/text/phrases.h"
#include "app/ui/scene/drawing/thumbnail.h"
#include "sim/base/error.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr QSize pictureSize{84, 62};
constexpr QSize listSize{560, 380};
constexpr std::int64_t pictureFrames = 24; ///< limits the time that a picture takes
constexpr int margin = 16;

enum Column { scene, frames, changed };

/// Returns the title of an autosaved scene, or the names stored in its file if its lesson is not installed.
QString titleOf(const LessonLibrary &library, const StepName &name)
{
    const LessonEntry *lesson = library.lesson(name.lesson);
    const lessons::Step *step = lesson ? lesson->step(name.step) : nullptr;
    return step ? labelled(lesson->title, step->title)
                : RecoveryList::tr("%1: %2 (not installed)").arg(name.lesson, name.step);
}

}

QString timeOf(const QDateTime &when)
{
    const QString time = when.time().toString("HH:mm");
    if (when.date() == QDate::currentDate())
        return time;
    return QLocale().toString(when.date(), QLocale::ShortFormat) + ' ' + time;
}

RecoveryList::RecoveryList(const LessonLibrary &library, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_library(library), m_theme(theme), m_rows(new QTreeWidget(this)),
      m_recover(new QPushButton(tr("Recover"), this)), m_delete(new QPushButton(tr("Delete"), this))
{
    setWindowTitle(tr("Recover scenes"));
    auto *said = new QLabel(tr("These scenes were not saved. Recover one to continue with it."), this);
    said->setWordWrap(true);
    m_rows->setHeaderLabels({tr("Scene"), tr("Frames"), tr("Last changed")});
    m_rows->setAccessibleName(tr("Scenes that were not saved"));
    m_rows->setRootIsDecorated(false);
    m_rows->setIconSize(pictureSize);
    m_rows->installEventFilter(this);
    m_recover->setToolTip(tr("Continue with the selected scene (Return)"));
    m_delete->setToolTip(tr("Delete the selected scene for good (Del)"));
    auto *done = new QPushButton(tr("Close"), this);
    done->setToolTip(tr("Keep them all for later (Esc)"));
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_recover);
    buttons->addWidget(m_delete);
    buttons->addStretch(1);
    buttons->addWidget(done);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(12);
    column->addWidget(said);
    column->addWidget(m_rows, 1);
    column->addLayout(buttons);
    for (QPushButton *one : {m_recover, m_delete, done})
        one->setAutoDefault(false); // Return is for the list
    connect(m_recover, &QPushButton::clicked, this, &RecoveryList::recoverSelected);
    connect(m_delete, &QPushButton::clicked, this, &RecoveryList::deleteSelected);
    connect(done, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_rows, &QTreeWidget::itemDoubleClicked, this, &RecoveryList::recoverSelected);
    connect(m_rows, &QTreeWidget::itemSelectionChanged, this, &RecoveryList::refreshButtons);
    connect(&m_timer, &QTimer::timeout, this, &RecoveryList::readNext);
    resize(listSize);
}

void RecoveryList::list(const std::vector<RecoveredScene> &scenes)
{
    m_scenes = scenes;
    m_rows->clear();
    for (const RecoveredScene &one : m_scenes)
        addRow(one);
    m_rows->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_rows->header()->setSectionResizeMode(Column::scene, QHeaderView::Stretch);
    m_rows->header()->setStretchLastSection(false);
    m_rows->setCurrentItem(m_rows->topLevelItem(0));
    m_rows->setFocus();
    refreshButtons();
    m_read = 0;
    m_timer.start(0);
}

void RecoveryList::addRow(const RecoveredScene &one)
{
    auto *row = new QTreeWidgetItem(m_rows);
    QPixmap blank(pictureSize);
    blank.fill(m_theme.tokens().sunk);
    row->setIcon(Column::scene, blank);
    row->setText(Column::scene, titleOf(m_library, one.name));
    row->setToolTip(Column::scene, row->text(Column::scene));
    row->setText(Column::changed, timeOf(one.when));
    row->setTextAlignment(Column::frames, Qt::AlignRight | Qt::AlignVCenter);
}

void RecoveryList::readNext()
{
    if (!isVisible() || m_read >= m_scenes.size()) {
        m_timer.stop();
        return;
    }
    read(*m_rows->topLevelItem(static_cast<int>(m_read)), m_scenes[m_read]);
    ++m_read;
}

void RecoveryList::read(QTreeWidgetItem &row, const RecoveredScene &one) const
{
    const LessonEntry *lesson = m_library.lesson(one.name.lesson);
    const lessons::Step *found = lesson ? lesson->step(one.name.step) : nullptr;
    if (!found)
        return;
    try {
        const Experiment read = readExperiment(one.file, m_library);
        row.setText(Column::frames, QLocale().toString(static_cast<qlonglong>(read.frames)));
        lessons::Step step = *found;
        step.prepareScript = [script = read.script](sim::Script &opened) { opened = script; };
        const auto length = static_cast<int>(std::min(read.frames, pictureFrames));
        row.setIcon(Column::scene, thumbnail(step, read.script.values, m_theme, pictureSize, length));
    } catch (const UserError &) {
        row.setText(Column::frames, tr("damaged"));
    } catch (const sim::Error &) {
        row.setText(Column::frames, tr("damaged"));
    }
}

const RecoveredScene *RecoveryList::selected() const
{
    const int row = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    return row < 0 ? nullptr : &m_scenes[static_cast<std::size_t>(row)];
}

void RecoveryList::recoverSelected()
{
    if (const RecoveredScene *one = selected()) {
        const RecoveredScene scene = *one; // a copy, because accept() may destroy the list
        accept();
        emit recovers(scene);
    }
}

void RecoveryList::deleteSelected()
{
    if (const RecoveredScene *one = selected())
        emit deletes(RecoveredScene(*one));
}

void RecoveryList::refreshButtons()
{
    m_recover->setEnabled(selected());
    m_delete->setEnabled(selected());
}

bool RecoveryList::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent *>(event)->key();
        const bool recovers = key == Qt::Key_Return || key == Qt::Key_Enter;
        if (recovers)
            recoverSelected();
        else if (key == Qt::Key_Delete)
            deleteSelected();
        if (recovers || key == Qt::Key_Delete)
            return true;
    }
    return QDialog::eventFilter(watched, event);
}

}
