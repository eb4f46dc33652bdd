#include "app/ui/branches/branches_panel.h"

#include "app/model/difference_table.h"
#include "app/model/difference_words.h"
#include "app/model/sentences.h"
#include "app/ui/branches/difference_plot.h"
#include "app/ui/panels/panel_title.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/time/runs_menu.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace app {

namespace {

constexpr int refreshMilliseconds = 100; ///< while playing: numbers that change faster cannot be read

}

BranchesPanel::BranchesPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_course(session),
      m_title(new PanelTitle(tr("Two runs"), PanelTitle::CaptionPlace::besideTitle, theme, this)),
      m_plot(new DifferencePlot(session, m_course, theme, this)),
      m_export(new PlotExport([this] { return m_plot->picture(); }, theme, this)),
      m_runs(new RunsMenu(session, theme, this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    m_export->setNumbersAsText([this] { return differenceTable(m_course); });
    m_export->addContextMenu(*m_plot);
    m_title->addAction(tabs());
    m_title->addAction(m_export->makeButton(this));
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 4);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_plot, 1);
    column->addWidget(foot());
    m_later.setSingleShot(true);
    connect(&m_later, &QTimer::timeout, this, &BranchesPanel::refreshNow);
    connect(m_plot, &DifferencePlot::pointedAt, this, &BranchesPanel::pointedAt);
    connect(m_plot, &DifferencePlot::pointedAt, m_plot, &DifferencePlot::setHovered);
    connect(&m_course, &DifferenceCourse::changed, this, &BranchesPanel::refresh);
    connect(&session, &Session::moved, this, &BranchesPanel::refresh);
    connect(&session, &Session::runChanged, this, &BranchesPanel::refresh);
    connect(&session, &Session::playingChanged, this, &BranchesPanel::refresh);
    connect(&session, &Session::selectionChanged, this, &BranchesPanel::nameBodies);
    connect(&session, &Session::stepOpened, this, &BranchesPanel::nameBodies);
    connect(&theme, &Theme::changed, this, &BranchesPanel::dress);
    nameBodies();
    dress();
}

void BranchesPanel::dress()
{
    m_runsButton->setIcon(m_theme.icon("runs"));
    refreshNow();
}

QToolButton *BranchesPanel::tab(const QString &name, const QString &tip)
{
    auto *button = new QToolButton(this);
    button->setObjectName("tab");
    button->setText(name);
    button->setToolTip(tip);
    button->setCheckable(true);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QWidget *BranchesPanel::tabs()
{
    auto *row = new QWidget(this);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    m_farthest = tab(tr("Farthest off"), tr("At each frame the body that is farthest from where it is in the "
                                            "other run"));
    m_selected = tab({}, tr("Only the body that is chosen in the picture"));
    m_farthest->setChecked(true);
    auto *group = new QButtonGroup(row);
    group->addButton(m_farthest);
    group->addButton(m_selected);
    layout->addWidget(m_farthest);
    layout->addWidget(m_selected);
    connect(m_farthest, &QToolButton::clicked, this, [this] { setOf(DifferenceCourse::Of::farthest); });
    connect(m_selected, &QToolButton::clicked, this, [this] { setOf(DifferenceCourse::Of::selected); });
    m_runsButton = tab(tr("Runs"), tr("Choose the run to compare with, keep, name and delete runs"));
    m_runsButton->setCheckable(false);
    m_runsButton->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    layout->addSpacing(8);
    layout->addWidget(m_runsButton);
    connect(m_runsButton, &QToolButton::clicked, this, [this] { m_runs->popupAbove(*m_runsButton); });
    return row;
}

QWidget *BranchesPanel::foot()
{
    auto *row = new QWidget(this);
    m_sentence = new QLabel(row);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_go = tab(tr("Go there"), tr("Go to the frame with the largest difference"));
    m_go->setCheckable(false);
    connect(m_go, &QToolButton::clicked, this, &BranchesPanel::goToLargest);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(16, 4, 12, 4);
    layout->setSpacing(8);
    layout->addWidget(m_sentence, 1);
    layout->addWidget(m_go);
    return row;
}

QString BranchesPanel::sentence() const
{
    return m_sentence->text();
}

void BranchesPanel::setOf(DifferenceCourse::Of of)
{
    (of == DifferenceCourse::Of::farthest ? m_farthest : m_selected)->setChecked(true);
    m_course.setOf(of);
    refreshNow();
}

void BranchesPanel::nameBodies()
{
    m_selected->setText(bodyTitle(m_session.selected()));
}

void BranchesPanel::goToLargest()
{
    if (!m_course.largest())
        return;
    m_session.pause();
    m_session.goTo({m_course.largest()->frame, 0});
}

void BranchesPanel::refresh()
{
    if (!isSeen())
        return;
    const bool isLooking = m_course.isComparing() && m_course.next() <= m_course.end();
    if (!(m_session.isPlaying() || isLooking) || !m_sinceRefresh.isValid() ||
        m_sinceRefresh.hasExpired(refreshMilliseconds))
        refreshNow();
    else if (!m_later.isActive())
        m_later.start(refreshMilliseconds - static_cast<int>(m_sinceRefresh.elapsed()));
}

void BranchesPanel::refreshNow()
{
    if (!isSeen())
        return;
    m_later.stop();
    m_sinceRefresh.start();
    const Branch *branch = m_session.beside();
    m_title->setCaption(branch ? tr("this one and “%1”").arg(branch->name) : QString());
    m_sentence->setText(differenceSentence(m_course));
    m_plot->setAccessibleDescription(m_sentence->text());
    const Difference *largest = m_course.largest();
    m_go->setVisible(largest && largest->distance > 0.0);
    m_plot->refresh();
}

void BranchesPanel::setCovered(bool covered)
{
    m_isCovered = covered;
    watch();
}

void BranchesPanel::watch()
{
    m_course.setWatched(isSeen());
    if (isSeen())
        refreshNow();
    else
        m_later.stop();
}

void BranchesPanel::setHovered(std::optional<std::int64_t> frame)
{
    m_plot->setHovered(frame);
}

void BranchesPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    watch();
}

void BranchesPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    watch();
}

}
