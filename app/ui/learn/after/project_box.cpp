#include "app/ui/learn/after/project_box.h"

#include "app/model/text/phrases.h"
#include "app/ui/dock/button_flow.h"
#include "app/ui/learn/after/level_box.h"
#include "app/ui/learn/narration_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int cardSideMargin = 16;

}

ProjectBox::ProjectBox(const OpenRun &run, ProjectDesk &desk, Shows shows, const Theme &theme,
                       QWidget *parent)
    : QFrame(parent), m_run(run), m_desk(desk), m_shows(shows), m_theme(theme), m_title(new QLabel(this)),
      m_count(new QLabel(this)), m_content(new QWidget(this)),
      m_brief(new NarrationText(theme, m_content, NarrationText::Kind::aside))
{
    setObjectName(shows == Shows::lesson ? "project" : "projectCard");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_brief->setObjectName("projectBrief");
    makeHead();
    auto *inner = new QVBoxLayout(m_content);
    inner->setContentsMargins(0, 2, 0, 4);
    inner->setSpacing(4);
    inner->addWidget(m_brief);
    m_buttons = new ButtonFlow(m_content);
    m_start = m_buttons->add<QToolButton>("startProject", tr("Start"), {});
    m_goOn = m_buttons->add<QToolButton>("goOnProject", tr("Go on"), tr("Opens what you have built so far"));
    m_putAway = m_buttons->add<QToolButton>("putAwayProject", tr("Put away"),
                                            tr("Removes this project from here. What you built stays."));
    inner->addWidget(m_buttons);
    m_column = new QVBoxLayout;
    m_column->setSpacing(0);
    inner->addLayout(m_column);
    // Copies, because the box shows another lesson as soon as the place is open.
    connect(m_start, &QToolButton::clicked, this, [this] { m_desk.start(QString(m_lesson)); });
    connect(m_goOn, &QToolButton::clicked, this, [this] { m_desk.goOn(QString(m_lesson)); });
    connect(m_putAway, &QToolButton::clicked, &desk, &ProjectDesk::putAway);
    connect(&desk, &ProjectDesk::changed, this, &ProjectBox::follow);
    run.onChange(ChangeKind::texts, this, [this] {
        m_shownTitle.clear(); // the levels are made again
        follow();
    });
    if (shows == Shows::current)
        connect(&desk, &ProjectDesk::opened, this, [this] { unfold(true); });
    follow();
}

void ProjectBox::makeHead()
{
    const bool isCard = m_shows == Shows::current;
    m_title->setObjectName("heading");
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    m_count->setObjectName("caption");
    m_fold = new QToolButton(this);
    m_fold->setObjectName("foldProject");
    m_fold->setAutoRaise(true);
    m_fold->setFocusPolicy(Qt::TabFocus);
    m_fold->setVisible(isCard);
    connect(m_fold, &QToolButton::clicked, this, [this] { unfold(m_content->isHidden()); });
    auto *row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(m_fold, 0, Qt::AlignTop);
    row->addWidget(m_title, 1);
    row->addWidget(m_count);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(isCard ? cardSideMargin : 0, isCard ? 4 : 12, isCard ? cardSideMargin : 0, 4);
    column->setSpacing(0);
    column->addLayout(row);
    column->addWidget(m_content);
    unfold(!isCard);
}

void ProjectBox::unfold(bool isOpen)
{
    m_fold->setText(isOpen ? QStringLiteral("▾") : QStringLiteral("▸"));
    m_fold->setToolTip(isOpen ? tr("Fold the project") : tr("Show the brief and the levels of the project"));
    m_fold->setAccessibleName(m_fold->toolTip());
    m_content->setVisible(isOpen);
    emit heightChanged();
}

QString ProjectBox::wantedLesson() const
{
    if (m_shows == Shows::lesson)
        return m_desk.projectOf(m_run.lesson().id) ? m_run.lesson().id : QString();
    const QString &current = m_desk.current();
    return m_run.isSandbox() && !current.isEmpty() && m_desk.isAtPlace(current) ? current : QString();
}

void ProjectBox::follow()
{
    const QString wanted = wantedLesson();
    const lessons::Project *project = wanted.isEmpty() ? nullptr : m_desk.projectOf(wanted);
    if (wanted != m_lesson)
        m_shownTitle.clear(); // the levels are made again
    m_lesson = project ? wanted : QString();
    setVisible(project);
    m_isStale = !isVisible();
    if (!project || m_isStale) {
        emit heightChanged();
        return;
    }
    if (project->title != m_shownTitle)
        makeLevels();
    refresh();
}

void ProjectBox::showEvent(QShowEvent *)
{
    if (m_isStale)
        follow();
}

void ProjectBox::makeLevels()
{
    const lessons::Project &project = *m_desk.projectOf(m_lesson);
    m_shownTitle = project.title;
    m_brief->setText(project.brief);
    for (LevelBox *level : m_levels) {
        level->hide();
        level->deleteLater(); // the change may come from one of its buttons
    }
    m_levels.clear();
    bool isNext = true;
    for (const lessons::ProjectLevel &level : project.levels) {
        auto *box = new LevelBox(m_desk, m_lesson, level, m_theme, m_content);
        m_column->addWidget(box);
        m_levels.push_back(box);
        connect(box, &LevelBox::changed, this, &ProjectBox::heightChanged);
        if (isNext && !m_desk.isPassed(m_lesson, level.id)) {
            box->setUnfolded(true);
            isNext = false;
        }
    }
}

void ProjectBox::refresh()
{
    m_title->setText(m_shows == Shows::lesson ? tr("Project: %1").arg(m_shownTitle) : m_shownTitle);
    m_count->setText(
        partOf(QString::number(m_desk.passedLevels(m_lesson)), QString::number(m_levels.size())));
    m_count->setToolTip(tr("Levels that you have passed"));
    setAccessibleName(m_title->text());
    for (LevelBox *level : m_levels)
        level->refresh();
    refreshButtons();
    emit heightChanged();
}

void ProjectBox::refreshButtons()
{
    const bool isCurrent = m_desk.current() == m_lesson;
    const bool isCard = m_shows == Shows::current;
    m_start->setText(isCurrent ? tr("Start again") : tr("Start"));
    m_start->setToolTip(tr("Opens the start scene of this project. Undo brings back what is there now."));
    m_goOn->setVisible(isCurrent && !isCard && !m_desk.isAtPlace(m_lesson));
    m_putAway->setVisible(isCard);
    m_buttons->refresh();
}

}
