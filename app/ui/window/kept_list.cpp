#include "app/ui/window/kept_list.h"

#include "app/model/experiment.h"
#include "app/ui/scene/thumbnail.h"
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
constexpr std::int64_t pictureFrames = 24; ///< at most: a picture must not take long
constexpr int margin = 16;

enum Column { scene, frames, changed };

/// Returns the title of what was kept; where its lesson is not installed, the names of its file.
QString titleOf(const LessonLibrary &library, const StepName &name)
{
    const LessonEntry *lesson = library.lesson(name.lesson);
    const lessons::Step *step = lesson ? lesson->step(name.step) : nullptr;
    return step ? KeptList::tr("%1: %2").arg(lesson->title, step->title)
                : KeptList::tr("%1: %2 (not installed)").arg(name.lesson, name.step);
}

}

QString timeOf(const QDateTime &when)
{
    const QString time = when.time().toString("HH:mm");
    if (when.date() == QDate::currentDate())
        return time;
    return QLocale().toString(when.date(), QLocale::ShortFormat) + ' ' + time;
}

KeptList::KeptList(const LessonLibrary &library, const Theme &theme, QWidget *parent)
    : QDialog(parent), m_library(library), m_theme(theme), m_rows(new QTreeWidget(this)),
      m_recover(new QPushButton(tr("Recover"), this)), m_delete(new QPushButton(tr("Delete"), this))
{
    setWindowTitle(tr("Recover scenes"));
    auto *said = new QLabel(tr("These scenes were not saved. Recover one to go on with it."), this);
    said->setWordWrap(true);
    m_rows->setHeaderLabels({tr("Scene"), tr("Frames"), tr("Last changed")});
    m_rows->setAccessibleName(tr("Scenes that were not saved"));
    m_rows->setRootIsDecorated(false);
    m_rows->setIconSize(pictureSize);
    m_rows->installEventFilter(this);
    m_recover->setToolTip(tr("Go on with the selected scene (Return)"));
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
        one->setAutoDefault(false); // Return belongs to the list
    connect(m_recover, &QPushButton::clicked, this, &KeptList::recoverSelected);
    connect(m_delete, &QPushButton::clicked, this, &KeptList::deleteSelected);
    connect(done, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_rows, &QTreeWidget::itemDoubleClicked, this, &KeptList::recoverSelected);
    connect(m_rows, &QTreeWidget::itemSelectionChanged, this, &KeptList::refreshButtons);
    connect(&m_later, &QTimer::timeout, this, &KeptList::readNext);
    resize(listSize);
}

void KeptList::list(const std::vector<KeptScene> &scenes)
{
    m_scenes = scenes;
    m_rows->clear();
    for (const KeptScene &one : m_scenes)
        addRow(one);
    m_rows->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_rows->header()->setSectionResizeMode(Column::scene, QHeaderView::Stretch);
    m_rows->header()->setStretchLastSection(false);
    m_rows->setCurrentItem(m_rows->topLevelItem(0));
    m_rows->setFocus();
    refreshButtons();
    m_read = 0;
    m_later.start(0);
}

void KeptList::addRow(const KeptScene &one)
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

void KeptList::readNext()
{
    if (!isVisible() || m_read >= m_scenes.size()) {
        m_later.stop();
        return;
    }
    read(*m_rows->topLevelItem(static_cast<int>(m_read)), m_scenes[m_read]);
    ++m_read;
}

void KeptList::read(QTreeWidgetItem &row, const KeptScene &one) const
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
    } catch (const Refusal &) {
        row.setText(Column::frames, tr("damaged"));
    } catch (const sim::Error &) {
        row.setText(Column::frames, tr("damaged"));
    }
}

const KeptScene *KeptList::selected() const
{
    const int row = m_rows->indexOfTopLevelItem(m_rows->currentItem());
    return row < 0 ? nullptr : &m_scenes[static_cast<std::size_t>(row)];
}

void KeptList::recoverSelected()
{
    if (const KeptScene *one = selected()) {
        const KeptScene scene = *one; // the list may be gone before it is opened
        accept();
        emit recovers(scene);
    }
}

void KeptList::deleteSelected()
{
    if (const KeptScene *one = selected())
        emit deletes(KeptScene(*one));
}

void KeptList::refreshButtons()
{
    m_recover->setEnabled(selected());
    m_delete->setEnabled(selected());
}

bool KeptList::eventFilter(QObject *watched, QEvent *event)
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
