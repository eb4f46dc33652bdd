#include "app/ui/measure/accuracy_panel.h"

#include "app/model/accuracy_words.h"
#include "app/ui/measure/order_plot.h"
#include "app/ui/measure/run_plot.h"
#include "app/ui/measure/work_precision_plot.h"
#include "app/ui/panels/panel_title.h"
#include "app/ui/panels/progress_line.h"
#include "app/ui/plots/plot_export.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int margin = 16;
constexpr int leastPlot = 150;   ///< px; below that a plot tells nothing
constexpr int leastRemarks = 36; ///< px: two lines; what does not fit is scrolled to

QLabel *textLabel(const char *name, Qt::TextFormat format, QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextFormat(format);
    label->setWordWrap(true);
    label->setContentsMargins(margin, 0, margin, 0);
    return label;
}

}

AccuracyPanel::AccuracyPanel(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_study(study), m_theme(theme)
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    m_title = new PanelTitle(tr("Accuracy"), PanelTitle::CaptionPlace::besideTitle, theme, this);
    m_views = new QStackedWidget(this);
    m_workPrecision = new WorkPrecisionPlot(study, theme, m_views);
    m_views->addWidget(m_workPrecision);
    m_overTheRun = new RunPlot(study, theme, m_views);
    m_views->addWidget(m_overTheRun);
    connect(m_overTheRun, &RunPlot::pointedAt, this, &AccuracyPanel::pointedAt);
    m_views->addWidget(new OrderPlot(study, theme, m_views));
    const auto seen = [this] { return static_cast<SpotPlot *>(m_views->currentWidget()); };
    m_export = new PlotExport([seen] { return seen()->picture(); }, theme, this);
    m_export->setNumbersAsText([seen] { return seen()->numbers(); });
    for (int i = 0; i < m_views->count(); ++i)
        m_export->addContextMenu(*m_views->widget(i));
    m_showsAll = QSettings().value(showsAllKey, false).toBool();
    m_tabRow = tabs();
    m_title->addAction(m_tabRow);
    m_all = choiceButton("allMethods", tr("Show all methods"),
                         tr("Every method that was measured, two more plots of them, and remarks"), true);
    m_title->addAction(m_all);
    m_title->addAction(m_export->makeButton(this));
    m_unstable = textLabel("failure", Qt::PlainText, this);
    m_views->setMinimumHeight(leastPlot);
    makeRemarks();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 12);
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addWidget(m_unstable);
    column->addWidget(m_views, 1);
    column->addWidget(stateRow());
    column->addWidget(card());
    column->addWidget(m_remarksArea);
    connect(&study, &AccuracyStudy::changed, this, &AccuracyPanel::refresh);
    connect(m_workPrecision, &WorkPrecisionPlot::targetChanged, this, &AccuracyPanel::refresh);
    connect(&theme, &Theme::changed, this, &AccuracyPanel::dress);
    dress();
    refresh();
}

void AccuracyPanel::makeRemarks()
{
    m_remarks = textLabel("caption", Qt::PlainText, this);
    m_remarks->setAlignment(Qt::AlignTop);
    m_remarksArea = new QScrollArea(this);
    m_remarksArea->setWidget(m_remarks);
    m_remarks->setAutoFillBackground(false);
    m_remarksArea->viewport()->setAutoFillBackground(false);
    m_remarksArea->setWidgetResizable(true);
    m_remarksArea->setFrameShape(QFrame::NoFrame);
    m_remarksArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

QWidget *AccuracyPanel::tabs()
{
    auto *row = new QWidget(this);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto *group = new QButtonGroup(row);
    struct Tab
    {
        QString text;
        QString tip;
    };
    const Tab all[] = {{tr("Error against time"), tr("How far off each method is, and what it costs")},
                       {tr("Over the run"), tr("How the error grows, at about the cost of your method")},
                       {tr("Order"), tr("How fast the error shrinks when the step does")}};
    for (const Tab &tab : all) {
        auto *button = new QToolButton(row);
        button->setObjectName("tab");
        button->setText(tab.text);
        button->setToolTip(tab.tip);
        button->setCheckable(true);
        button->setFocusPolicy(Qt::TabFocus);
        button->setChecked(m_tabs.empty());
        group->addButton(button, static_cast<int>(m_tabs.size()));
        layout->addWidget(button);
        m_tabs.push_back(button);
    }
    connect(group, &QButtonGroup::idClicked, m_views, &QStackedWidget::setCurrentIndex);
    return row;
}

QWidget *AccuracyPanel::stateRow()
{
    auto *row = new QWidget(this);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(margin, 0, margin, 0);
    m_state = new QLabel(row);
    m_state->setObjectName("caption");
    m_state->setWordWrap(true);
    m_fewer = choiceButton("fewerMethods", tr("Show fewer methods"),
                           tr("Only the method of this step and the two that tell most beside it"), false);
    m_progress = new ProgressLine(tr("How far the measurement is"), row);
    m_progress->setMaximumWidth(160);
    m_measure = new QPushButton(row);
    m_measure->setObjectName("measure");
    m_measure->setAutoDefault(false);
    layout->addWidget(m_state, 1);
    layout->addWidget(m_progress);
    layout->addWidget(m_fewer);
    layout->addWidget(m_measure);
    connect(m_measure, &QPushButton::clicked, this, &AccuracyPanel::measureOrCancel);
    m_stateRow = row;
    return row;
}

QWidget *AccuracyPanel::card()
{
    auto *outside = new QWidget(this);
    auto *around = new QHBoxLayout(outside);
    around->setContentsMargins(margin, 0, margin, 0);
    auto *card = new QFrame(outside);
    card->setObjectName("sentence");
    around->addWidget(card);
    auto *layout = new QHBoxLayout(card);
    layout->setContentsMargins(14, 10, 12, 10);
    layout->setSpacing(12);
    m_verdict = new QLabel(card);
    m_verdict->setTextFormat(Qt::RichText);
    m_verdict->setWordWrap(true);
    m_use = new QPushButton(tr("Use it"), card);
    m_use->setObjectName("use");
    m_use->setAutoDefault(false);
    layout->addWidget(m_verdict, 1);
    layout->addWidget(m_use, 0, Qt::AlignVCenter);
    connect(m_use, &QPushButton::clicked, this, &AccuracyPanel::useCheapest);
    return outside;
}

void AccuracyPanel::dress()
{
    m_verdict->setFont(m_theme.ui(14));
}

void AccuracyPanel::setView(View view)
{
    m_tabs[view]->setChecked(true);
    m_views->setCurrentIndex(view);
}

AccuracyPanel::View AccuracyPanel::view() const
{
    return static_cast<View>(m_views->currentIndex());
}

QString AccuracyPanel::verdict() const
{
    return QTextDocumentFragment::fromHtml(m_verdict->text()).toPlainText();
}

QString AccuracyPanel::remarks() const
{
    return m_remarks->text();
}

void AccuracyPanel::fitRemarks()
{
    const int whole = std::max(0, m_remarks->heightForWidth(m_remarksArea->viewport()->width()));
    m_remarksArea->setMinimumHeight(std::min(whole, leastRemarks));
    m_remarksArea->setMaximumHeight(whole);
}

void AccuracyPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitRemarks();
}

void AccuracyPanel::refresh()
{
    const sim::Accuracy *accuracy = m_study.accuracy();
    chooseMethods();
    refreshState();
    m_title->layout()->activate(); // the buttons in it are others, perhaps: the caption has what room is left
    m_title->setCaption(accuracy ? captionOf(*accuracy) : QString());
    const QString unstable = accuracy ? unstableWords(*accuracy) : QString();
    m_unstable->setText(unstable.isEmpty() ? QString() : QStringLiteral("✕ ") + unstable);
    m_unstable->setVisible(showsAll() && !unstable.isEmpty());
    const QString remarks = accuracy ? remarksOn(*accuracy).join(QStringLiteral("\n")) : QString();
    m_remarks->setText(remarks);
    m_remarksArea->setVisible(showsAll() && !remarks.isEmpty());
    fitRemarks();
    refreshCard();
}

void AccuracyPanel::refreshState()
{
    using Stage = AccuracyStudy::Stage;
    const bool measuring = m_study.stage() == Stage::measuring;
    m_all->setVisible(!m_showsAll);
    m_fewer->setVisible(m_showsAll);
    m_tabRow->setVisible(m_showsAll);
    m_stateRow->setVisible(m_showsAll ||
                           m_study.stage() != Stage::done); // a plot that is done speaks for itself
    m_progress->setVisible(measuring);
    m_progress->setShare(m_study.done());
    m_measure->setText(measuring ? tr("Cancel") : m_study.accuracy() ? tr("Measure again") : tr("Measure"));
    m_measure->setToolTip(measuring ? tr("Stop; what was measured until now stays")
                                    : tr("Compute the scene with every method, and time it"));
    switch (m_study.stage()) {
    case Stage::measuring:
        m_state->setText(tr("Measuring…"));
        break;
    case Stage::done:
        m_state->setText(tr("Times are medians of repeated, interleaved runs; whiskers show their spread."));
        break;
    case Stage::cancelled:
        m_state->setText(tr("Cancelled. What was measured until then is shown."));
        break;
    case Stage::refused:
        m_state->setText(m_study.refusal());
        break;
    case Stage::none:
        m_state->setText(m_study.isDue()
                             ? tr("The scene has changed. It is measured as soon as it stays the same.")
                             : tr("Not measured yet."));
        break;
    }
}

const sim::AccuracyRow *AccuracyPanel::cheapest() const
{
    return m_study.accuracy() ? m_study.accuracy()->cheapest(m_workPrecision->target()) : nullptr;
}

void AccuracyPanel::refreshCard()
{
    const sim::Accuracy *accuracy = m_study.accuracy();
    const QString text = accuracy ? verdictOn(*accuracy, m_workPrecision->target(), m_study.inUse())
                                  : tr("How far off is each way of computing this scene, and what does it "
                                       "cost? Every method runs it "
                                       "at many steps, against a reference that is far more exact.");
    if (text != m_verdict->text())
        m_verdict->setText(text);
    const sim::AccuracyRow *best = cheapest();
    m_use->setVisible(best && best != m_study.inUse());
    if (best)
        m_use->setToolTip(tr("Use %1").arg(wayWords(best->setup)));
}

void AccuracyPanel::measureOrCancel()
{
    if (m_study.stage() == AccuracyStudy::Stage::measuring)
        m_study.cancel();
    else
        m_study.start();
}

void AccuracyPanel::useCheapest()
{
    if (const sim::AccuracyRow *best = cheapest())
        m_study.adopt(best->setup);
}

void AccuracyPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_study.setWatched(true);
}

void AccuracyPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_study.setWatched(false);
}

}
